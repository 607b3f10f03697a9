/* SPDX-License-Identifier: MIT */
/** @file to_grid.c
 *  Sums over particles on the grid of method `hybrid`. Particles are in the order of their cells, so that those near some
 *  rows of the grid are one range: each row gets its sums in that order, the same for any number of threads. */
#include <math.h>
#include <string.h>

#include "base/parallel.h"
#include "methods/hybrid/grid.h"

/* Rows of a task: at both ends it looks at some particles of its neighbours. */
enum { BAND = 8 };

/** The first particle of the row of cells at y, in squares above the domain's lower side. */
static size_t first_above(const sph2d__cells *c, const sph2d__grid *g, double y)
{
    const double row = (g->low_y + y / g->inverse_y - c->origin_y) * c->inverse_y;
    if (c->nx == 0 || c->ny == 0)
        return 0;
    const size_t k = row > 0 ? row < c->ny ? (size_t)row : c->ny : 0;
    return c->start[k * c->nx];
}

/** Adds a value that grows by `slope` from one place to the next. */
static inline void add_pair(sph2d__pair2 *to, float x, float weight, float value, float slope)
{
    const int i = (int)x;
    const float part = x - (float)i, b = weight * part, a = weight - b;
    to[i].value += a * (value - part * slope);
    to[i].weight += a;
    to[i + 1].value += b * (value + (1 - part) * slope);
    to[i + 1].weight += b;
}

static inline void add_quad(sph2d__quad *to, float x, float weight, sph2d__quad value)
{
    const int i = (int)x;
    const float b = weight * (x - (float)i), a = weight - b;
    to[i] += a * value;
    to[i + 1] += b * value;
}

/** Rows of the grid that one task sums, from `first` to `last` - 1. */
typedef struct band {
    const sph2d__grid *grid;
    int first, last;
} band;

static bool has(const band *b, int row)
{
    return row >= b->first && row < b->last;
}

/** Velocity of a particle, and its slopes a square further on: APIC (Jiang, Schroeder, Selle, Teran & Stomakhin, The affine
 *  particle-in-cell method, ACM TOG 34 (2015) 51). */
typedef struct motion {
    float u, v, u_x, u_y, v_x, v_y;
} motion;

/** Adds a particle at (x, y), in squares, to those of the two rows around it that are the band's. */
static inline void add_particle(const band *b, float x, float y, const motion *p, sph2d__quad middle)
{
    const sph2d__grid *g = b->grid;
    const int j = (int)(y + 0.5F), k = (int)y + 1; /* middles of row j are at j - 1/2, lower faces at j - 1 */
    const float up = y + 0.5F - (float)j, above = y + 1 - (float)k;
    for (int n = 0; n < 2; ++n) {
        if (has(b, j + n)) {
            const float weight = n == 0 ? 1 - up : up;
            add_pair(g->sums.x + (size_t)(j + n) * g->stride, x + 1, weight, p->u + ((float)n - up) * p->u_y, p->u_x);
            add_quad(g->sums.middle + (size_t)(j + n) * g->stride, x + 0.5F, weight, middle);
        }
        if (has(b, k + n))
            add_pair(g->sums.y + (size_t)(k + n) * g->stride, x + 0.5F, n == 0 ? 1 - above : above,
                     p->v + ((float)n - above) * p->v_y, p->v_x);
    }
}

static void sum_band(const sph2d_sim *sim, const band *b, double dt)
{
    const sph2d__system *s = &sim->system;
    const sph2d__store *f = &s->fluid;
    const sph2d__grid *g = b->grid;
    const size_t from = (size_t)b->first * g->stride, count = (size_t)(b->last - b->first) * g->stride;
    memset(g->sums.x + from, 0, count * sizeof *g->sums.x);
    memset(g->sums.y + from, 0, count * sizeof *g->sums.y);
    memset(g->sums.middle + from, 0, count * sizeof *g->sums.middle);
    const float pressing = (float)(dt / s->rest_density), unit = (float)(1 / s->rest_density);
    const double cell = 1 / (g->inverse_y * s->fluid_cells.height);
    const size_t end = first_above(&s->fluid_cells, g, b->last - 0.5 + cell);
    for (size_t i = first_above(&s->fluid_cells, g, b->first - 2.0); i < end; ++i) {
        const float x = (float)((f->x[i] - g->low_x) * g->inverse_x), y = (float)((f->y[i] - g->low_y) * g->inverse_y);
        if (x >= 0 && x <= (float)g->nx && y >= 0 && y <= (float)g->ny) {
            const float stretch = (float)f->stretch[i], shear = (float)f->shear[i], rotation = (float)f->rotation[i];
            const motion p = {(float)f->vx[i],
                              (float)f->vy[i],
                              g->hx * stretch,
                              g->hy * (shear - rotation),
                              g->hx * (shear + rotation),
                              -g->hy * stretch};
            add_particle(b, x, y, &p,
                         (sph2d__quad){1, unit * (float)f->density[i] - 1, pressing * (float)f->pressure[i], 0});
        }
    }
}

/** Adds what lies beyond one end of a period to the other end. */
static void fold(const sph2d__grid *g, size_t into, size_t from)
{
    const sph2d__sums *s = &g->sums;
    s->x[into].value += s->x[from].value;
    s->x[into].weight += s->x[from].weight;
    s->y[into].value += s->y[from].value;
    s->y[into].weight += s->y[from].weight;
    s->middle[into] += s->middle[from];
}

static void copy(const sph2d__grid *g, size_t to, size_t from)
{
    g->sums.x[to] = g->sums.x[from];
    g->sums.y[to] = g->sums.y[from];
    g->sums.middle[to] = g->sums.middle[from];
}

/** Folds a periodic direction of `n` squares, in which neighbours are `step` apart, along lines `first` to
 *  `lines` - 1, `line` apart. */
static void fold_all(const sph2d__grid *g, int n, size_t step, int first, int lines, size_t line)
{
    for (int k = first; k < lines; ++k) {
        const size_t at = (size_t)k * line, last = at + (size_t)n * step;
        fold(g, last, at);                       /* 0 is n */
        fold(g, at + step, last + step);         /* n + 1 is 1 */
        fold(g, at + 2 * step, last + 2 * step); /* n + 2 is 2 */
        copy(g, at, last);
        copy(g, last + step, at + step);
    }
}

/** Finds the rows of the grid with particles, by the rows of their cells. */
static void find_rows(const sph2d_sim *sim, sph2d__grid *g)
{
    const sph2d__cells *c = &sim->system.fluid_cells;
    uint32_t low = 0, high = c->ny;
    while (low < high && c->start[(size_t)low * c->nx] == c->start[(size_t)(low + 1) * c->nx])
        ++low;
    while (high > low && c->start[(size_t)(high - 1) * c->nx] == c->start[(size_t)high * c->nx])
        --high;
    const double from = (c->origin_y + low * c->height - g->low_y) * g->inverse_y,
                 to = (c->origin_y + high * c->height - g->low_y) * g->inverse_y;
    g->first = g->wraps_y || from < 2 ? 0 : from > g->ny ? g->ny : (int)from - 1;
    g->last = g->wraps_y || to > g->ny - 1 ? g->ny + 1 : to < 0 ? 1 : (int)to + 2;
}

void sph2d__grid_sum(sph2d_sim *sim, sph2d__grid *g, double dt)
{
    find_rows(sim, g);
    const int rows = g->last + 3; /* of the faces above, of those that a period folds */
#pragma omp taskloop num_tasks(sph2d__tasks(sim->system.fluid.count, SPH2D__LOOK_GRAIN))
    for (int j = g->first; j < rows; j += BAND)
        sum_band(sim, &(band){g, j, j + BAND < rows ? j + BAND : rows}, dt);
    if (g->wraps_x)
        fold_all(g, g->nx, 1, g->first, rows, g->stride);
    if (g->wraps_y)
        fold_all(g, g->ny, g->stride, 0, g->nx + 4, 1);
}
