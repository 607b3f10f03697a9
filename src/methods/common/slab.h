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

/** Adds sums to a total. */
static inline void sph2d__slab_add(sph2d__slab_sum *total, const sph2d__slab_sum *sum)
{
    total->first += sum->first;
    total->second += sum->second;
    total->third += sum->third;
    total->fourth += sum->fourth;
    total->x += sum->x;
    total->y += sum->y;
    total->most = sum->most > total->most ? sum->most : total->most;
}

#endif
