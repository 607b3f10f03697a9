/* SPDX-License-Identifier: MIT */
/** @file multigrid.h
 *  What the solver of the grid of method `hybrid` does to one square, in C and in OpenCL C: multigrid_pass.c. */
#ifndef SPH2D_METHODS_HYBRID_MULTIGRID_H
#define SPH2D_METHODS_HYBRID_MULTIGRID_H

#include "methods/hybrid/grid_data.h"

/* Damping of Jacobi. */
SPH2D__FIXED float DAMPING = 0.75F;

/* A row of a scalar product is so many sums of floats. */
enum { SIDE_BY_SIDE = 8 };

/** Couplings of a level. */
typedef struct couplings {
    SPH2D__ARRAY const float *left, *below, *air;
    size_t up;
} couplings;

static inline couplings couplings_of(const sph2d__level *l)
{
    return (couplings){l->left, l->below, l->air, l->stride};
}

/** A p. */
static inline float product_at(const couplings *c, SPH2D__ARRAY const float *p, size_t k)
{
    return c->left[k] * (p[k] - p[k - 1]) + c->left[k + 1] * (p[k] - p[k + 1]) + c->below[k] * (p[k] - p[k - c->up]) +
           c->below[k + c->up] * (p[k] - p[k + c->up]) + c->air[k] * p[k];
}

/** What is left, r - A p, of the four squares of a coarse one. */
static inline float left_in(const sph2d__level *l, SPH2D__ARRAY const float *r, SPH2D__ARRAY const float *product,
                            int i, int j)
{
    const size_t at = (size_t)(2 * j - 1) * l->stride + (size_t)(2 * i - 1);
    const size_t of[4] = {at, at + 1, at + l->stride, at + l->stride + 1};
    float sum = 0;
    for (int k = 0; k < 4; ++k)
        sum += l->inverse[of[k]] > 0 ? r[of[k]] - product[of[k]] : 0;
    return sum;
}

/** The coarse square that has square (i, j). */
static inline size_t coarse_of(const sph2d__level *coarse, int i, int j)
{
    return (size_t)((j + 1) / 2) * coarse->stride + (size_t)((i + 1) / 2);
}

static inline int lower(int a, int b)
{
    return a < b ? a : b;
}

static inline int higher(int a, int b)
{
    return a > b ? a : b;
}

/** First and last liquid square of a row of a coarser level. */
static inline void coarsen_row(const sph2d__level *l, const sph2d__level *c, int j)
{
    const int row = 2 * j - 1, next = row < l->ny ? 2 * j : row;
    const bool none = j < 1 || j > c->ny;
    c->from[j] = none ? c->nx + 1 : (lower(l->from[row], l->from[next]) + 1) / 2;
    c->to[j] = none ? 0 : (higher(l->to[row], l->to[next]) + 1) / 2;
}

/** Whether square (i, j) has a left or lower face that liquid touches. */
static inline bool has_faces(const sph2d__level *l, int i, int j)
{
    return j >= 1 && j <= l->ny + 1 && i >= lower(l->from[j], l->from[j - 1]) &&
           i <= higher(l->to[j], l->to[j - 1]) + 1;
}

static inline bool is_within(const sph2d__level *l, int i, int j)
{
    return j >= 1 && j <= l->ny && i >= l->from[j] && i <= l->to[j];
}

/** Couplings of a square of a coarser level. Rows and columns beyond an odd edge have none. */
static inline void couple(const sph2d__level *l, const sph2d__level *c, int i, int j)
{
    const size_t to = (size_t)j * c->stride + (size_t)i;
    const size_t at = (size_t)(2 * j - 1) * l->stride + (size_t)(2 * i - 1), up = at + l->stride;
    const bool row = j <= c->ny, column = i <= c->nx, higher_too = 2 * j <= l->ny, wider = 2 * i <= l->nx;
    c->left[to] = row ? 0.5F * (l->left[at] + (higher_too ? l->left[up] : 0)) : 0;
    c->below[to] = column ? 0.5F * (l->below[at] + (wider ? l->below[at + 1] : 0)) : 0;
    c->air[to] = row && column ? 0.5F * (l->air[at] + (wider ? l->air[at + 1] : 0) + (higher_too ? l->air[up] : 0) +
                                         (wider && higher_too ? l->air[up + 1] : 0))
                               : 0;
}

/** 1 over the sum of the couplings of a square. */
static inline float inverse_at(const couplings *c, size_t k)
{
    const float sum = c->left[k] + c->left[k + 1] + c->below[k] + c->below[k + c->up] + c->air[k];
    return sum > 0 ? 1 / (sum > 0 ? sum : 1) : 0;
}

static inline float sum_of_row(const float row[SIDE_BY_SIDE])
{
    return ((row[0] + row[1]) + (row[2] + row[3])) + ((row[4] + row[5]) + (row[6] + row[7]));
}

#endif
