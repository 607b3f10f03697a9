/* SPDX-License-Identifier: MIT */
/** @file constraint_pass.h
 *  The loops of method `constraint` over the rows of a slab, between sums over neighbours. */
#ifndef SPH2D_METHODS_PROJECTION_CONSTRAINT_PASS_H
#define SPH2D_METHODS_PROJECTION_CONSTRAINT_PASS_H

#include "methods/common/slabs.h"
#include "simd/isa.h"

/** Compiled once for each instruction set, with the same bits. The inverse diagonal is negative in rows that are not
 *  active. What is left to correct is summed as add_left of constraint_pass.c says. */
typedef struct sph2d__constraint_passes {
    /** product += soft direction. First sum: direction . product; second and third: product . residual and
     *  product . product, each over the diagonal, of active rows. */
    void (*apply)(const sph2d__slab *slab, double soft, sph2d__slab_sum *sum);
    /** Finds the active rows: those that push, and those that are compressed. Their direction is what is left over the
     *  diagonal. Sums what is left. */
    void (*begin)(const sph2d__slab *slab, sph2d__slab_sum *sum);
    /** A step of `length` along the direction, and the next direction, which keeps a part of the last. Sums what is
     *  left. */
    void (*advance)(const sph2d__slab *slab, double length, double keep, sph2d__slab_sum *sum);
    /** Makes the way from multipliers that pull back to none the direction. Second sum: what that does to residuals, as
     *  far as a row's own goes. */
    void (*clamp)(const sph2d__slab *slab, sph2d__slab_sum *sum);
} sph2d__constraint_passes;

SPH2D__COPIES(sph2d__constraint_passes, sph2d__constraint_passes)

#endif
