/* SPDX-License-Identifier: MIT */
/** @file to_grid.c
 *  Sums over particles on the grid of method `hybrid`. Particles are in the order of their cells, so that those near some
 *  rows of the grid are one range: each row gets its sums in that order, the same for any number of threads. */
#include <string.h>

#include "base/parallel.h"
#include "methods/hybrid/grid.h"

/* Squares around those that particles touch: equations read those beside liquid, and what these say about theirs. */
enum { MARGIN = 2 };

/* The fewest rows of a task: at both ends it looks at some particles of its neighbours. */
enum { LEAST_BAND = 8 };

/* ---- which squares ----------------------------------------------------------------------------------------------- */

static void clear_span(const sph2d__grid *g, int j)
{
    const sph2d__level *l = g->level;
    const size_t from = sph2d__at(g, g->begin[j], j), count = (size_t)(g->end[j] - g->begin[j]);
    float *const fields[] = {g->mass,  g->excess, g->u,     g->v,    g->q,     g->s,   g->air_x,
                             g->air_y, g->wet_x,  g->wet_y, l->left, l->below, l->air, l->inverse};
    for (size_t n = 0; n < sizeof fields / sizeof *fields; ++n)
        memset(fields[n] + from, 0, count * sizeof **fields);
    sph2d__quad *const quads[] = {g->face_x, g->face_y, g->sums.middle};
    for (size_t n = 0; n < sizeof quads / sizeof *quads; ++n)
        memset(quads[n] + from, 0, count * sizeof **quads);
    memset(g->sums.x + from, 0, count * sizeof *g->sums.x);
    memset(g->sums.y + from, 0, count * sizeof *g->sums.y);
}

/** Makes rows wide enough for particles between two heights and two columns, in squares above the lower left corner of the
 *  domain, and for what the equations read beside what these particles touch. */
static void widen(sph2d__grid *g, double low, double high, double left, double right)
{
    const int begin = sph2d__grid_clamp(left - MARGIN, g->nx + 3),
              end = sph2d__grid_clamp(right + MARGIN + 3, g->nx + 3) + 1;
    for (int j = sph2d__grid_clamp(low - MARGIN, g->ny + 3), last = sph2d__grid_clamp(high + MARGIN + 2, g->ny + 3);
         j <= last; ++j) {
        const bool is_new = !(g->end[j] > g->begin[j]);
        g->begin[j] = is_new || begin < g->begin[j] ? begin : g->begin[j];
        g->end[j] = is_new || end > g->end[j] ? end : g->end[j];
    }
}

/* In a periodic domain, whose ends are neighbours, they are all. */
void sph2d__grid_find_spans(const sph2d_sim *sim, sph2d__grid *g)
{
    const sph2d__cells *c = &sim->system.fluid_cells;
    const bool wraps = g->wraps_x || g->wraps_y;
    for (int j = 0; j < g->ny + 4; ++j) {
        if (!g->on_device)
            clear_span(g, j);
        g->begin[j] = 0;
        g->end[j] = wraps ? g->nx + 4 : 0;
    }
    for (uint32_t row = 0; row < c->ny && !wraps; ++row) {
        const uint32_t *start = c->start + (size_t)row * c->nx;
        uint32_t from = 0, to = c->nx;
        while (from < to && start[from + 1] == start[0])
            ++from;
        while (to > from && start[to - 1] == start[c->nx])
            --to;
        const double low = (c->origin_y + row * c->height - g->low_y) * g->inverse_y, left = c->origin_x - g->low_x;
        if (from < to)
            widen(g, low, low + c->height * g->inverse_y, (left + from * c->width) * g->inverse_x,
                  (left + to * c->width) * g->inverse_x);
    }
    g->first = 0;
    g->last = g->ny + 3;
    while (g->first < g->last && g->begin[g->first] == g->end[g->first])
        ++g->first;
    while (g->last > g->first && g->begin[g->last] == g->end[g->last])
        --g->last;
}

/** Sums up all rows, by bands that threads share. */
static void sum_bands(sph2d_sim *sim, const sph2d__grid *g, double dt)
{
    const int rows = g->last + 1;
    const int share = (rows - g->first) / (2 * sph2d__threads()) + 1, band = share > LEAST_BAND ? share : LEAST_BAND;
    const sph2d__transfer_passes *pass = sph2d__transfer_passes_find(sim->system.isa);
#pragma omp taskloop grainsize(1) if (rows - g->first > band)
    for (int j = g->first; j < rows; j += band)
        pass->sum(sim, j, j + band < rows ? j + band : rows, dt);
}

void sph2d__grid_sum(sph2d_sim *sim, sph2d__grid *g, double dt)
{
    if (g->on_device) {
        sph2d__grid_sum_on_device(g, dt);
        return;
    }
    sum_bands(sim, g, dt);
    for (int j = g->first; j <= g->last && g->wraps_x; ++j)
        sph2d__fold_line(&g->sums, sph2d__at(g, 0, j), g->nx, 1);
    for (int i = 0; i < g->nx + 4 && g->wraps_y; ++i)
        sph2d__fold_line(&g->sums, (size_t)i, g->ny, g->stride);
}
