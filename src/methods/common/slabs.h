/* SPDX-License-Identifier: MIT */
/** @file slabs.h
 *  Work on particles, slab by slab, and on the rows of a pressure solver: those of the fluid and those of the boundary
 *  particles that have some. Threads share the slabs; what each sums up is added in one order.
 *
 *  Pair loops are functions of their own, which a pointer names: a kernel that is an argument is a constant in their
 *  loops. */
#ifndef SPH2D_METHODS_COMMON_SLABS_H
#define SPH2D_METHODS_COMMON_SLABS_H

#include "methods/common/system.h"

/** Particles `first` to `last` - 1 of a store. */
typedef struct sph2d__slab {
    sph2d__store *rows;
    bool walls; /**< they are boundary particles */
    size_t first, last;
} sph2d__slab;

/** What is done to a slab; `sum` starts at zeros. */
typedef void sph2d__slab_work(sph2d__system *system, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum);

/** Does the same to every slab of the fluid; returns what they sum up. */
sph2d__slab_sum sph2d__over_fluid(sph2d__system *system, sph2d__slab_work *work, const void *with);

/** And to every slab of the boundary particles, where some act by pressure. */
sph2d__slab_sum sph2d__over_rows(sph2d__system *system, sph2d__slab_work *work, const void *with);

/** What is done to particles `first` to `last` - 1 of some store. */
typedef void sph2d__span_work(sph2d__system *system, size_t first, size_t last);

/** Does it to particles 0 to count - 1, in slabs that threads share. */
void sph2d__over_particles(sph2d__system *system, size_t count, sph2d__span_work *work);

#endif
