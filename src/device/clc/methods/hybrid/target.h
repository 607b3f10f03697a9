/* SPDX-License-Identifier: MIT */
/** @file target.h
 *  What particles add to: a square, its left and its lower face (in C: src/methods/hybrid/target.h). */
#ifndef SPH2D_METHODS_HYBRID_TARGET_H
#define SPH2D_METHODS_HYBRID_TARGET_H

#include "methods/hybrid/grid_data.h"

/** A square, and its sums so far. */
typedef struct sph2d__target {
    int column, row;
    float2 left, lower; /* values and weights */
    float4 middle;
} sph2d__target;

static inline void sph2d__add_pair(const sph2d__target *to, int row, int column, float4 weighted, float2 *sum)
{
    if (row == to->row && column == to->column)
        *sum += weighted.lo;
    if (row == to->row && column + 1 == to->column)
        *sum += weighted.hi;
}

static inline void sph2d__add_left(sph2d__target *to, int row, int column, sph2d__quad weighted)
{
    sph2d__add_pair(to, row, column, weighted, &to->left);
}

static inline void sph2d__add_lower(sph2d__target *to, int row, int column, sph2d__quad weighted)
{
    sph2d__add_pair(to, row, column, weighted, &to->lower);
}

static inline void sph2d__add_middles(sph2d__target *to, int row, int column, sph2d__oct weighted)
{
    if (row == to->row && column == to->column)
        to->middle += weighted.lo;
    if (row == to->row && column + 1 == to->column)
        to->middle += weighted.hi;
}

#endif
