/* SPDX-License-Identifier: MIT */
/** @file target.h
 *  What particles add to: rows of the grid. On a device, where a thread has a square: src/device/clc/methods/hybrid/target.h. */
#ifndef SPH2D_METHODS_HYBRID_TARGET_H
#define SPH2D_METHODS_HYBRID_TARGET_H

#include "methods/hybrid/grid_data.h"

/** Rows of the grid, from `first` to `last` - 1. */
typedef struct sph2d__target {
    const sph2d__grid *grid;
    int first, last;
} sph2d__target;

/* Four and eight floats at any place. */
typedef float sph2d__any_quad __attribute__((vector_size(16), aligned(4), may_alias));
typedef float sph2d__any_oct __attribute__((vector_size(32), aligned(4), may_alias));

static inline bool sph2d__target_has(const sph2d__target *to, int row)
{
    return row >= to->first && row < to->last;
}

/** Adds values and weights of the left faces of two squares, `column` and the next. */
static inline void sph2d__add_left(sph2d__target *to, int row, int column, sph2d__quad weighted)
{
    if (sph2d__target_has(to, row))
        *(sph2d__any_quad *)(to->grid->sums.x + sph2d__at(to->grid, column, row)) += weighted;
}

/** The same of lower faces. */
static inline void sph2d__add_lower(sph2d__target *to, int row, int column, sph2d__quad weighted)
{
    if (sph2d__target_has(to, row))
        *(sph2d__any_quad *)(to->grid->sums.y + sph2d__at(to->grid, column, row)) += weighted;
}

/** And what squares themselves sum up, four numbers each. */
static inline void sph2d__add_middles(sph2d__target *to, int row, int column, sph2d__oct weighted)
{
    if (sph2d__target_has(to, row))
        *(sph2d__any_oct *)(to->grid->sums.middle + sph2d__at(to->grid, column, row)) += weighted;
}

#endif
