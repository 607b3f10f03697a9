/* SPDX-License-Identifier: MIT */
/** @file multigrid_pass.c
 *  Conjugate gradients for the equations of the grid, one V-cycle of multigrid each as preconditioner (McAdams, Sifakis &
 *  Teran, A parallel multigrid Poisson solver for fluids simulation on large grids, SCA 2010).
 *
 *  A square of a coarse level is four of the finer one. Sums of four go down, copies come up, and couplings are half of
 *  the sum of the finer ones: their sum is Galerkin's, of which corrections would be half of what they should be. Smoothing
 *  is by damped Jacobi, as often before as after, so that a cycle is symmetric. */
#include <math.h>
#include <string.h>

#include "methods/hybrid/grid.h"

/* Damping of Jacobi, sweeps before and after, and on the coarsest level. */
static const float DAMPING = 0.75F;
enum { SWEEPS = 2, COARSEST_SWEEPS = 30 };
/* Floats are solved for when this part is left of r . A^-1 r. */
static const double SOLVED = 1e-12;

/** Runs the statement behind it for the squares k of row j from the first liquid one to the last. Elsewhere values are
 *  finite and couplings 0. */
#define FOR_LIQUID(l, j, k)                                                                                            \
    for (size_t k = (size_t)(j) * (l)->stride + (size_t)(l)->from[j],                                                  \
                end_ = (size_t)(j) * (l)->stride + (size_t)(l)->to[j] + 1;                                             \
         k < end_; ++k)

/** out = A p. */
static void multiply(const sph2d__grid *g, const sph2d__level *l, float *p, float *restrict out)
{
    sph2d__level_wrap(g, l, p);
    const float *left = l->left, *below = l->below, *air = l->air;
    const size_t up = l->stride;
    for (int j = 1; j <= l->ny; ++j)
        FOR_LIQUID(l, j, k)
    out[k] = left[k] * (p[k] - p[k - 1]) + left[k + 1] * (p[k] - p[k + 1]) + below[k] * (p[k] - p[k - up]) +
             below[k + up] * (p[k] - p[k + up]) + air[k] * p[k];
}

/** p <- p + w D^-1 (r - A p). */
static void sweep(const sph2d__grid *g, const sph2d__level *l, float *restrict p, const float *r,
                  float *restrict product)
{
    multiply(g, l, p, product);
    const float *inverse = l->inverse;
    for (int j = 1; j <= l->ny; ++j)
        FOR_LIQUID(l, j, k)
    p[k] += DAMPING * inverse[k] * (r[k] - product[k]);
}

/** What is left, r - A p, summed onto the coarser level. */
static void restrict_to(const sph2d__level *l, const float *r, const float *product, const sph2d__level *coarse,
                        float *rest)
{
    for (int j = 1; j <= coarse->ny; ++j)
        for (int i = coarse->from[j]; i <= coarse->to[j]; ++i) {
            const size_t to = (size_t)j * coarse->stride + (size_t)i;
            const size_t at = (size_t)(2 * j - 1) * l->stride + (size_t)(2 * i - 1);
            const size_t of[4] = {at, at + 1, at + l->stride, at + l->stride + 1};
            float sum = 0;
            for (int k = 0; k < 4; ++k)
                sum += l->inverse[of[k]] > 0 ? r[of[k]] - product[of[k]] : 0;
            rest[to] = coarse->inverse[to] > 0 ? sum : 0;
        }
}

static void prolong(const sph2d__level *coarse, const float *value, const sph2d__level *l, float *p)
{
    for (int j = 1; j <= l->ny; ++j)
        for (int i = l->from[j]; i <= l->to[j]; ++i) {
            const size_t at = (size_t)j * l->stride + (size_t)i;
            const float more = value[(size_t)((j + 1) / 2) * coarse->stride + (size_t)((i + 1) / 2)];
            p[at] += l->inverse[at] > 0 ? more : 0;
        }
}

/** p = about A^-1 r, from the finest level on down and up. */
static void cycle(const sph2d__grid *g, const sph2d__work *w, float *finest, const float *right)
{
    for (int n = 0; n < g->levels; ++n) {
        const sph2d__level *l = &g->level[n];
        float *p = n == 0 ? finest : w->cycle[n].value, *product = w->cycle[n].product;
        const float *r = n == 0 ? right : w->cycle[n].rest;
        for (int j = 1; j <= l->ny; ++j)
            FOR_LIQUID(l, j, k)
        p[k] = DAMPING * l->inverse[k] * r[k];
        const int more = n + 1 == g->levels ? COARSEST_SWEEPS : SWEEPS - 1;
        for (int k = 0; k < more; ++k)
            sweep(g, l, p, r, product);
        if (n + 1 < g->levels) {
            multiply(g, l, p, product);
            restrict_to(l, r, product, l + 1, w->cycle[n + 1].rest);
        }
    }
    for (int n = g->levels - 2; n >= 0; --n) {
        const sph2d__level *l = &g->level[n];
        float *p = n == 0 ? finest : w->cycle[n].value;
        prolong(l + 1, w->cycle[n + 1].value, l, p);
        for (int k = 0; k < SWEEPS; ++k)
            sweep(g, l, p, n == 0 ? right : w->cycle[n].rest, w->cycle[n].product);
    }
}

static int lower(int a, int b)
{
    return a < b ? a : b;
}

static int higher(int a, int b)
{
    return a > b ? a : b;
}

/** First and last liquid square of the rows of a coarser level. */
static void coarsen_rows(const sph2d__level *l, const sph2d__level *c)
{
    for (int j = 1; j <= c->ny; ++j) {
        const int row = 2 * j - 1, next = row < l->ny ? 2 * j : row;
        c->from[j] = (lower(l->from[row], l->from[next]) + 1) / 2;
        c->to[j] = (higher(l->to[row], l->to[next]) + 1) / 2;
    }
    c->from[0] = c->from[c->ny + 1] = c->nx + 1;
    c->to[0] = c->to[c->ny + 1] = 0;
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

static void coarsen(const sph2d__level *l, const sph2d__level *c)
{
    float *const all[] = {c->left, c->below, c->air, c->inverse};
    coarsen_rows(l, c);
    int first = 1, last = c->ny;
    while (first < last && c->to[first] < c->from[first])
        ++first;
    while (last > first && c->to[last] < c->from[last])
        --last;
    for (size_t n = 0; n < sizeof all / sizeof *all; ++n)
        sph2d__level_clear(c, all[n], first, last);
    for (int j = 1; j <= c->ny + 1; ++j)
        for (int i = lower(c->from[j], c->from[j - 1]); i <= higher(c->to[j], c->to[j - 1]) + 1; ++i)
            couple(l, c, i, j);
    for (int j = 1; j <= c->ny; ++j)
        FOR_LIQUID(c, j, k)
        {
            const float sum = c->left[k] + c->left[k + 1] + c->below[k] + c->below[k + c->stride] + c->air[k];
            c->inverse[k] = sum > 0 ? 1 / (sum > 0 ? sum : 1) : 0;
        }
}

static void prepare(sph2d__grid *g)
{
    for (int k = 0; k + 1 < g->levels; ++k)
        coarsen(&g->level[k], &g->level[k + 1]);
}

/** A scalar product: of each row in eight sums of floats, and rows in their order. */
static double dot(const sph2d__level *l, const float *a, const float *b)
{
    enum { SIDE_BY_SIDE = 8 };
    double sum = 0;
    for (int j = 1; j <= l->ny; ++j) {
        const size_t at = (size_t)j * l->stride, end = at + (size_t)l->to[j] + 1;
        float row[SIDE_BY_SIDE] = {0};
        size_t k = at + (size_t)l->from[j];
        for (; k + SIDE_BY_SIDE <= end; k += SIDE_BY_SIDE)
            for (size_t n = 0; n < SIDE_BY_SIDE; ++n)
                row[n] += a[k + n] * b[k + n];
        for (; k < end; ++k)
            row[0] += a[k] * b[k];
        sum += (double)(((row[0] + row[1]) + (row[2] + row[3])) + ((row[4] + row[5]) + (row[6] + row[7])));
    }
    return sum;
}

static void solve(const sph2d__grid *g, const sph2d__work *w, float *restrict value, bool bodies, int iterations)
{
    const sph2d__level *l = g->level;
    float *restrict residual = w->residual, *restrict direction = w->direction, *restrict product = w->product,
                    *restrict z = w->z;
    multiply(g, l, value, z);
    if (bodies)
        sph2d__grid_add_bodies(g, value, z);
    for (int j = 1; j <= l->ny; ++j)
        FOR_LIQUID(l, j, k)
    residual[k] = l->inverse[k] > 0 ? residual[k] - z[k] : 0;
    double before = 0, enough = 1e-30;
    for (int n = 0; n < iterations; ++n) {
        cycle(g, w, z, residual);
        const double now = dot(l, residual, z);
        if (!(now > enough))
            return;
        enough = n == 0 ? SOLVED * now : enough;
        const float beta = n > 0 ? (float)(now / before) : 0;
        for (int j = 1; j <= l->ny; ++j)
            FOR_LIQUID(l, j, k)
        direction[k] = n > 0 ? z[k] + beta * direction[k] : z[k];
        multiply(g, l, direction, product);
        if (bodies)
            sph2d__grid_add_bodies(g, direction, product);
        const float alpha = (float)(now / dot(l, direction, product));
        for (int j = 1; j <= l->ny; ++j)
            FOR_LIQUID(l, j, k)
            {
                value[k] += alpha * direction[k];
                residual[k] -= alpha * product[k];
            }
        before = now;
    }
}

const sph2d__multigrid SPH2D__OF_ISA(sph2d__multigrid) = {prepare, solve};
