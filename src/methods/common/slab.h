/* SPDX-License-Identifier: MIT */
/** @file slab.h
 *  A slab, and what is summed up over it. */
#ifndef SPH2D_METHODS_COMMON_SLAB_H
#define SPH2D_METHODS_COMMON_SLAB_H

#include "methods/common/system.h"

/** Partial sums of a loop over the particles of a slab. */
typedef struct sph2d__slab_sum {
    double first, second, third, fourth; /**< sums */
    double x, y;                         /**< of a vector */
    double most;                         /**< a maximum, at least 0 */
} sph2d__slab_sum;

/** Particles `first` to `last` - 1 of a store. */
typedef struct sph2d__slab {
    sph2d__store *rows;
    bool walls; /**< of boundary particles */
    size_t first, last;
} sph2d__slab;

#endif
