/* SPDX-License-Identifier: MIT */
/** @file grid_viscosity.c
 *  Viscosity on the grid of method `hybrid`, solved for at the end of a step: u - nu dt lap u = u*, along each axis for
 *  itself, as in Stam (Stable fluids, SIGGRAPH 1999). There is no stress at a surface, nor along walls, which slip. */
#include <math.h>

#include "methods/hybrid/grid.h"

/* What is left of the right side, and most iterations. */
static const double LEFT = 1e-3;
enum { MOST_ITERATIONS = 60 };

/** Velocities along one axis: on faces that liquid touches they are unknown, on closed ones given, others are air. */
typedef struct axis {
    const sph2d__grid *g;
    const float *open, *side; /**< open parts of the faces; unknown where `side` is above 0 */
    float across, along;      /**< nu dt/h^2, of the axis and of the other one, by the grid's x and y */
    bool x;
    int last_i, first_j, last_j;
} axis;

/** nu dt/h^2 between an unknown face and its neighbour, 0 where there is none; *given: the neighbour is a wall. */
static float between(const axis *a, size_t other, bool along_axis, float factor, bool *given)
{
    *given = along_axis && !(a->open[other] > 0);
    return a->side[other] > 0 || *given ? factor : 0;
}

/** (1 + sum c) u - sum c u_other at a face; *diagonal: what is before u. */
static float apply(const axis *a, const float *u, size_t k, float *diagonal)
{
    const size_t others[4] = {k - 1, k + 1, k - a->g->stride, k + a->g->stride};
    float sum = 0, rest = 0;
    for (int n = 0; n < 4; ++n) {
        bool given;
        const float c = between(a, others[n], (n < 2) == a->x, n < 2 ? a->across : a->along, &given);
        sum += c;
        rest += c * u[others[n]];
    }
    *diagonal = 1 + sum;
    return (1 + sum) * u[k] - rest;
}

/** Runs the statement behind it for each unknown face k. */
#define FOR_UNKNOWN(a, k)                                                                                              \
    for (int j_ = (a)->first_j; j_ <= (a)->last_j; ++j_)                                                               \
        for (size_t k = sph2d__at((a)->g, 1, j_), end_ = sph2d__at((a)->g, (a)->last_i, j_); k <= end_; ++k)           \
            if ((a)->side[k] > 0)

static double product(const axis *a, const float *p, const float *q)
{
    double sum = 0;
    FOR_UNKNOWN(a, k)
    sum += (double)(p[k] * q[k]);
    return sum;
}

/** Conjugate gradients with the diagonal, from u on. */
static void solve(const axis *a, float *u)
{
    const sph2d__grid *g = a->g;
    const sph2d__level *l = g->level; /* arrays that are free before the pressure */
    float *rest = g->rest, *way = g->way, *image = g->image, *scaled = g->z, *diagonal = l->product;
    for (size_t k = 0; k < g->size; ++k)
        way[k] = scaled[k] = rest[k] = 0;
    FOR_UNKNOWN(a, k)
    rest[k] = u[k] - apply(a, u, k, &diagonal[k]);
    const double bound = LEFT * LEFT * product(a, u, u);
    double before = 0;
    for (int n = 0; n < MOST_ITERATIONS && product(a, rest, rest) > bound; ++n) {
        FOR_UNKNOWN(a, k)
        scaled[k] = rest[k] / diagonal[k];
        const double now = product(a, rest, scaled);
        const float keep = n > 0 ? (float)(now / before) : 0;
        FOR_UNKNOWN(a, k)
        way[k] = scaled[k] + keep * way[k];
        sph2d__level_wrap(g, l, way);
        FOR_UNKNOWN(a, k)
        image[k] = apply(a, way, k, &diagonal[k]);
        const float part = (float)(now / product(a, way, image));
        FOR_UNKNOWN(a, k)
        {
            u[k] += part * way[k];
            rest[k] -= part * image[k];
        }
        sph2d__level_wrap(g, l, u);
        before = now;
    }
}

void sph2d__grid_viscosity(sph2d__grid *g, double number)
{
    if (!(4 * (number / (g->hx * g->hx) + number / (g->hy * g->hy)) > LEFT))
        return; /* no more would be left of the right side than the solver leaves */
    const int first = g->first > 1 ? g->first : 1, last = g->last < g->ny ? g->last : g->ny;
    const float across = (float)number / (g->hx * g->hx), along = (float)number / (g->hy * g->hy);
    const axis x = {g, g->open_x, g->wet_x, across, along, true, g->wraps_x ? g->nx : g->nx + 1, first, last};
    const axis y = {g, g->open_y, g->wet_y, across, along, false, g->nx, first, g->wraps_y ? g->ny : last + 1};
    solve(&x, g->u);
    solve(&y, g->v);
}
