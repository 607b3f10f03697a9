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
#include "methods/hybrid/multigrid.h"

/* Sweeps before and after, and on the coarsest level. */
enum { SWEEPS = 2, COARSEST_SWEEPS = 30 };
/* Floats are solved for when this part is left of r . A^-1 r. */
static const double SOLVED = 1e-12;

/** Runs the statement behind it for the squares k of row j from the first liquid one to the last. Elsewhere values are
 *  finite and couplings 0. */
#define FOR_LIQUID(l, j, k)                                                                                            \
    for (size_t k = (size_t)(j) * (l)->stride + (size_t)(l)->from[j],                                                  \
                end_ = (size_t)(j) * (l)->stride + (size_t)(l)->to[j] + 1;                                             \
         k < end_; ++k)

/** Runs a kernel for the squares of a level, where a device solves. */
static bool by_device(const sph2d__grid *g, const char *kernel, const sph2d__level *l, sph2d__grid_work with)
{
    with.level = (int)(l - g->level);
    if (g->on_device)
        sph2d__grid_run(g, kernel, l->size, &with);
    return g->on_device != NULL;
}

/** out = A p. */
static void multiply(const sph2d__grid *g, const sph2d__level *l, float *p, float *restrict out)
{
    const couplings c = couplings_of(l);
    sph2d__grid_wrap(g, l, p);
    if (by_device(g, "grid_multiply", l, (sph2d__grid_work){.field = {p, out}}))
        return;
    for (int j = 1; j <= l->ny; ++j)
        FOR_LIQUID (l, j, k)
            out[k] = product_at(&c, p, k);
}

/** p <- p + w D^-1 (r - A p). */
static void sweep(const sph2d__grid *g, const sph2d__level *l, float *restrict p, float *r, float *restrict product)
{
    multiply(g, l, p, product);
    const float *inverse = l->inverse;
    if (by_device(g, "grid_sweep", l, (sph2d__grid_work){.field = {p, r, product}}))
        return;
    for (int j = 1; j <= l->ny; ++j)
        FOR_LIQUID (l, j, k)
            p[k] += DAMPING * inverse[k] * (r[k] - product[k]);
}

/** Sweeps from zeros, of which the first one is p = w D^-1 r; with all of them in one kernel where a level is small. */
static void smooth(const sph2d__grid *g, const sph2d__level *l, float *restrict p, float *r, float *restrict product,
                   int sweeps)
{
    const bool last = l + 1 == g->level + g->levels;
    const sph2d__grid_work with = {.field = {p, r, product}, .level = (int)(l - g->level), .times = sweeps - 1};
    if (g->on_device && last) {
        sph2d__grid_run(g, "grid_smooth", 1, &with);
        return;
    }
    if (!by_device(g, "grid_start", l, with))
        for (int j = 1; j <= l->ny; ++j)
            FOR_LIQUID (l, j, k)
                p[k] = DAMPING * l->inverse[k] * r[k];
    for (int k = 1; k < sweeps; ++k)
        sweep(g, l, p, r, product);
}

/** What is left, r - A p, summed onto the coarser level. */
static void restrict_to(const sph2d__grid *g, const sph2d__level *l, float *r, float *product,
                        const sph2d__level *coarse, float *rest)
{
    if (by_device(g, "grid_restrict", coarse, (sph2d__grid_work){.field = {rest, r, product}}))
        return;
    for (int j = 1; j <= coarse->ny; ++j)
        for (int i = coarse->from[j]; i <= coarse->to[j]; ++i) {
            const size_t to = (size_t)j * coarse->stride + (size_t)i;
            rest[to] = coarse->inverse[to] > 0 ? left_in(l, r, product, i, j) : 0;
        }
}

static void prolong(const sph2d__grid *g, const sph2d__level *coarse, float *value, const sph2d__level *l, float *p)
{
    if (by_device(g, "grid_prolong", l, (sph2d__grid_work){.field = {p, value}}))
        return;
    for (int j = 1; j <= l->ny; ++j)
        for (int i = l->from[j]; i <= l->to[j]; ++i) {
            const size_t at = (size_t)j * l->stride + (size_t)i;
            p[at] += l->inverse[at] > 0 ? value[coarse_of(coarse, i, j)] : 0;
        }
}

/** p = about A^-1 r, from the finest level on down and up. */
static void cycle(const sph2d__grid *g, const sph2d__work *w, float *finest, float *right)
{
    for (int n = 0; n < g->levels; ++n) {
        const sph2d__level *l = &g->level[n];
        float *p = n == 0 ? finest : w->cycle[n].value, *product = w->cycle[n].product;
        float *r = n == 0 ? right : w->cycle[n].rest;
        smooth(g, l, p, r, product, n + 1 == g->levels ? 1 + COARSEST_SWEEPS : SWEEPS);
        if (n + 1 < g->levels) {
            multiply(g, l, p, product);
            restrict_to(g, l, r, product, l + 1, w->cycle[n + 1].rest);
        }
    }
    for (int n = g->levels - 2; n >= 0; --n) {
        const sph2d__level *l = &g->level[n];
        float *p = n == 0 ? finest : w->cycle[n].value;
        prolong(g, l + 1, w->cycle[n + 1].value, l, p);
        for (int k = 0; k < SWEEPS; ++k)
            sweep(g, l, p, n == 0 ? right : w->cycle[n].rest, w->cycle[n].product);
    }
}

static void coarsen(const sph2d__level *l, const sph2d__level *c)
{
    float *const all[] = {c->left, c->below, c->air, c->inverse};
    const couplings coarse = couplings_of(c);
    for (int j = 0; j <= c->ny + 1; ++j)
        coarsen_row(l, c, j);
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
        FOR_LIQUID (c, j, k)
            c->inverse[k] = inverse_at(&coarse, k);
}

static void prepare(sph2d__grid *g)
{
    static const char *const kernels[] = {"grid_coarsen_rows", "grid_coarsen", "grid_invert"};
    for (int k = 0; k + 1 < g->levels; ++k) {
        for (size_t n = 0; g->on_device && n < sizeof kernels / sizeof *kernels; ++n)
            by_device(g, kernels[n], &g->level[k + 1], (sph2d__grid_work){0});
        if (!g->on_device)
            coarsen(&g->level[k], &g->level[k + 1]);
    }
}

/** A scalar product: of each row in eight sums of floats, and rows in their order. */
static double dot(const sph2d__grid *g, const sph2d__level *l, float *a, float *b)
{
    double sum = 0;
    if (g->on_device)
        return sph2d__grid_sum_rows(g, &(sph2d__grid_work){.field = {a, b}});
    for (int j = 1; j <= l->ny; ++j) {
        const size_t at = (size_t)j * l->stride, end = at + (size_t)l->to[j] + 1;
        float row[SIDE_BY_SIDE] = {0};
        size_t k = at + (size_t)l->from[j];
        for (; k + SIDE_BY_SIDE <= end; k += SIDE_BY_SIDE)
            for (size_t n = 0; n < SIDE_BY_SIDE; ++n)
                row[n] += a[k + n] * b[k + n];
        for (; k < end; ++k)
            row[0] += a[k] * b[k];
        sum += (double)sum_of_row(row);
    }
    return sum;
}

/** What is left before the first iteration. */
static void begin(const sph2d__grid *g, const sph2d__level *l, float *restrict residual, float *restrict z)
{
    if (by_device(g, "grid_rest", l, (sph2d__grid_work){.field = {residual, z}}))
        return;
    for (int j = 1; j <= l->ny; ++j)
        FOR_LIQUID (l, j, k)
            residual[k] = l->inverse[k] > 0 ? residual[k] - z[k] : 0;
}

/** The next direction, by the last one times beta after the first iteration. */
static void direct(const sph2d__grid *g, const sph2d__level *l, float *restrict direction, float *restrict z, int n,
                   float beta)
{
    if (by_device(g, "grid_direct", l, (sph2d__grid_work){.field = {direction, z}, .factor = beta, .times = n}))
        return;
    for (int j = 1; j <= l->ny; ++j)
        FOR_LIQUID (l, j, k)
            direction[k] = n > 0 ? z[k] + beta * direction[k] : z[k];
}

static void advance(const sph2d__grid *g, const sph2d__work *w, float *restrict value, float alpha)
{
    const sph2d__level *l = g->level;
    float *restrict residual = w->residual, *restrict direction = w->direction, *restrict product = w->product;
    if (by_device(g, "grid_advance", l,
                  (sph2d__grid_work){.field = {value, residual, direction, product}, .factor = alpha}))
        return;
    for (int j = 1; j <= l->ny; ++j)
        FOR_LIQUID (l, j, k) {
            value[k] += alpha * direction[k];
            residual[k] -= alpha * product[k];
        }
}

static void solve(const sph2d__grid *g, const sph2d__work *w, float *restrict value, bool bodies, int iterations)
{
    const sph2d__level *l = g->level;
    multiply(g, l, value, w->z);
    if (bodies)
        sph2d__grid_add_bodies(g, value, w->z);
    begin(g, l, w->residual, w->z);
    double before = 0, enough = 1e-30;
    for (int n = 0; n < iterations; ++n) {
        cycle(g, w, w->z, w->residual);
        const double now = dot(g, l, w->residual, w->z);
        if (!(now > enough))
            return;
        enough = n == 0 ? SOLVED * now : enough;
        direct(g, l, w->direction, w->z, n, n > 0 ? (float)(now / before) : 0);
        multiply(g, l, w->direction, w->product);
        if (bodies)
            sph2d__grid_add_bodies(g, w->direction, w->product);
        advance(g, w, value, (float)(now / dot(g, l, w->direction, w->product)));
        before = now;
    }
}

const sph2d__multigrid SPH2D__OF_ISA(sph2d__multigrid) = {prepare, solve};
