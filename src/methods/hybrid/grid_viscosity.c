/* SPDX-License-Identifier: MIT */
/** @file grid_viscosity.c
 *  Viscosity on the grid of method `hybrid`, solved for at the end of a step: u - nu dt lap u = u*, along each axis for
 *  itself, as in Stam (Stable fluids, SIGGRAPH 1999). There is no stress at a surface, nor along walls that slip. */
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

/** What is beside a face across its axis: the closed part of the way there, and the corner that stands for the wall. */
typedef struct beside {
    float closed;
    size_t corner;
} beside;

static beside beside_of(const axis *a, size_t k, int n)
{
    const sph2d__grid *g = a->g;
    const size_t up = g->stride, back = a->x ? 1 : up; /* to the square on the other side of the face */
    const size_t corner = n % 2 == 0 ? k : a->x ? k + up : k + 1;
    const float *open = a->x ? g->open_y : g->open_x;
    return (beside){1 - (open[corner - back] + open[corner]) / 2, corner};
}

/** (1 + sum c) u - sum c u_other at a face; *diagonal: what is before u. `walls`: 1 with the velocities of walls, 0 without.
 *  Along its axis a closed face has its wall's velocity, and stands among u; across, a wall without slip is half a square
 *  away. */
static float apply(const axis *a, const float *u, size_t k, float walls, float *diagonal)
{
    const sph2d__grid *g = a->g;
    const size_t others[4] = {k - 1, k + 1, k - g->stride, k + g->stride};
    const float *speed = a->x ? g->corner_u : g->corner_v;
    float sum = 0, rest = 0;
    for (int n = 0; n < 4; ++n) {
        const float factor = n < 2 ? a->across : a->along;
        const size_t other = others[n];
        if ((n < 2) == a->x) {
            const float c = a->side[other] > 0 || !(a->open[other] > 0) ? factor : 0;
            sum += c;
            rest += c * u[other];
            continue;
        }
        const beside b = beside_of(a, k, n);
        const float free = a->side[other] > 0 ? factor * (1 - b.closed) : 0;
        const float held = 2 * factor * b.closed * g->stick[b.corner];
        sum += free + held;
        rest += free * u[other] + held * walls * speed[b.corner];
    }
    *diagonal = 1 + sum;
    return (1 + sum) * u[k] - rest;
}

/** First and last face of row j that may be unknown. */
static size_t first_of(const axis *a, int j)
{
    return sph2d__at(a->g, a->g->begin[j] > 1 ? a->g->begin[j] : 1, j);
}

static size_t last_of(const axis *a, int j)
{
    return sph2d__at(a->g, a->g->end[j] <= a->last_i ? a->g->end[j] - 1 : a->last_i, j);
}

/** Runs the statement behind it for each unknown face k. */
#define FOR_UNKNOWN(a, k)                                                                                              \
    for (int j_ = (a)->first_j; j_ <= (a)->last_j; ++j_)                                                               \
        for (size_t k = first_of(a, j_), end_ = last_of(a, j_) + 1; k < end_; ++k)                                     \
            if ((a)->side[k] > 0)

static double product(const axis *a, const float *p, const float *q)
{
    double sum = 0;
    FOR_UNKNOWN (a, k)
        sum += (double)(p[k] * q[k]);
    return sum;
}

/** Conjugate gradients with the diagonal, from u on. */
static void solve(const axis *a, float *u)
{
    const sph2d__grid *g = a->g;
    const sph2d__level *l = g->level;
    const sph2d__work *w = &g->pressure; /* free before it */
    float *rest = w->residual, *way = w->direction, *image = w->product, *scaled = w->z,
          *diagonal = w->cycle[0].product;
    for (int j = g->first; j <= g->last; ++j)
        SPH2D__FOR_SPAN (g, j, k)
            way[k] = scaled[k] = rest[k] = 0;
    FOR_UNKNOWN (a, k)
        rest[k] = u[k] - apply(a, u, k, 1, &diagonal[k]);
    const double bound = LEFT * LEFT * product(a, u, u);
    double before = 0;
    for (int n = 0; n < MOST_ITERATIONS && product(a, rest, rest) > bound; ++n) {
        FOR_UNKNOWN (a, k)
            scaled[k] = rest[k] / diagonal[k];
        const double now = product(a, rest, scaled);
        const float keep = n > 0 ? (float)(now / before) : 0;
        FOR_UNKNOWN (a, k)
            way[k] = scaled[k] + keep * way[k];
        sph2d__level_wrap(g, l, way);
        FOR_UNKNOWN (a, k)
            image[k] = apply(a, way, k, 0, &diagonal[k]);
        const float part = (float)(now / product(a, way, image));
        FOR_UNKNOWN (a, k) {
            u[k] += part * way[k];
            rest[k] -= part * image[k];
        }
        sph2d__level_wrap(g, l, u);
        before = now;
    }
}

bool sph2d__grid_is_viscous(const sph2d__grid *g, double number)
{
    return 4 * (number / (g->hx * g->hx) + number / (g->hy * g->hy)) > LEFT;
}

void sph2d__grid_viscosity(sph2d__grid *g, double number)
{
    const int first = g->first > 1 ? g->first : 1, last = g->last < g->ny ? g->last : g->ny;
    const float across = (float)number / (g->hx * g->hx), along = (float)number / (g->hy * g->hy);
    const axis x = {g, g->open_x, g->wet_x, across, along, true, g->wraps_x ? g->nx : g->nx + 1, first, last};
    const axis y = {g, g->open_y, g->wet_y, across, along, false, g->nx, first, g->wraps_y ? g->ny : last + 1};
    solve(&x, g->u);
    solve(&y, g->v);
}
