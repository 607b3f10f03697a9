/* SPDX-License-Identifier: MIT */
/** @file coverage_level.c
 *  The height of the liquid at rest: its area fills, from below, the cells that are connected to it. */
#include <math.h>

#include "probes/coverage.h"

enum { FULL = SPH2D__COVERAGE_FULL };
enum { WALL_RIGHT = 1, WALL_ABOVE = 2, LIQUID = 4 };
enum { DRY, PARTIAL, WET };

/** A flood fill of the cells. */
typedef struct flood {
    const sph2d__coverage *grid;
    unsigned char *closed; /**< of each cell: bits for a wall to the next cell, and for liquid */
    unsigned char *wet;    /**< of each cell: DRY; WET, where the fill goes on; or PARTIAL, if a wall's surface passes
                                through the cell and its centre is behind that */
    uint32_t *queue;
    size_t queued;
} flood;

/** Marks walls between the centres of neighbouring cells, and cells with liquid. */
static void mark_cells(flood *w)
{
    const sph2d__coverage *c = w->grid;
    const sph2d__store *f = &c->sim->system.fluid;
    for (size_t j = 0; j < c->ny && c->sim->world.wall_count > SPH2D__WALL_OBSTACLE; ++j)
        for (size_t i = 0; i < c->nx; ++i) {
            sph2d_vec2 at = {c->origin.x + ((double)i + 0.5) * c->size_x, c->origin.y + ((double)j + 0.5) * c->size_y};
            bool x = sph2d__sim_crosses_wall(c->sim, at, (sph2d_vec2){at.x + c->size_x, at.y});
            bool y = sph2d__sim_crosses_wall(c->sim, at, (sph2d_vec2){at.x, at.y + c->size_y});
            w->closed[j * c->nx + i] = (unsigned char)((x ? WALL_RIGHT : 0) | (y ? WALL_ABOVE : 0));
        }
    for (size_t k = 0; k < f->count; ++k) {
        size_t i, j;
        double in;
        if (sph2d__coverage_cell(f->x[k], c->origin.x, c->size_x, c->nx, &i, &in) &&
            sph2d__coverage_cell(f->y[k], c->origin.y, c->size_y, c->ny, &j, &in))
            w->closed[j * c->nx + i] |= LIQUID;
    }
}

static void wet_cell(flood *w, size_t cell, bool closed)
{
    unsigned char solid = w->grid->solid[cell];
    if (w->wet[cell] == WET || solid == FULL || (closed && solid == 0))
        return;
    w->wet[cell] = closed ? PARTIAL : WET;
    if (!closed)
        w->queue[w->queued++] = (uint32_t)cell;
}

/** Wets the neighbours of a cell up to row `top`. */
static void spread(flood *w, size_t cell, size_t top)
{
    const sph2d__coverage *c = w->grid;
    size_t i = cell % c->nx, j = cell / c->nx, row = cell - i;
    bool round_x = c->nodes_x == c->nx;
    size_t left = row + (i + c->nx - 1) % c->nx;
    if (i + 1 < c->nx || round_x)
        wet_cell(w, row + (i + 1) % c->nx, w->closed[cell] & WALL_RIGHT);
    if (i > 0 || round_x)
        wet_cell(w, left, w->closed[left] & WALL_RIGHT);
    if (j < top)
        wet_cell(w, cell + c->nx, w->closed[cell] & WALL_ABOVE);
    if (j > 0)
        wet_cell(w, cell - c->nx, w->closed[cell - c->nx] & WALL_ABOVE);
}

/** The space connected to the liquid below the top of a row: its area and that in the row itself, in cells. */
typedef struct space {
    double area, row;
} space;

static space space_below(flood *w, size_t top)
{
    const sph2d__coverage *c = w->grid;
    const size_t cells = c->nx * (top + 1);
    space r = {0, 0};
    w->queued = 0;
    for (size_t k = 0; k < cells; ++k)
        w->wet[k] = DRY;
    for (size_t k = 0; k < cells; ++k)
        if (w->closed[k] & LIQUID)
            wet_cell(w, k, false);
    for (size_t k = 0; k < w->queued; ++k)
        spread(w, w->queue[k], top);
    for (size_t k = 0; k < cells; ++k)
        if (w->wet[k] != DRY) {
            double part = (double)(FULL - c->solid[k]) / FULL;
            r.area += part;
            r.row += k / c->nx == top ? part : 0;
        }
    return r;
}

/** Finds the row of the liquid's surface by bisection. */
static double level_of(flood *w, double area)
{
    const sph2d__coverage *c = w->grid;
    size_t low = 0, high = c->ny - 1;
    mark_cells(w);
    if (space_below(w, high).area < area)
        return NAN;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (space_below(w, middle).area < area)
            low = middle + 1;
        else
            high = middle;
    }
    space r = space_below(w, low);
    double spare = r.row > 0 ? fmin((r.area - area) / r.row, 1) : 0;
    return c->origin.y + ((double)low + 1 - spare) * c->size_y;
}

double sph2d__coverage_level(const sph2d__coverage *c, double area)
{
    const sph2d__forces *b = &c->sim->system.forces;
    sph2d__memory *memory = c->sim->system.memory;
    size_t cells = c->nx * c->ny;
    if (b->gravity.x != 0 || !(b->gravity.y < 0) || c->nodes_y == c->ny || c->nx == 0)
        return NAN;
    void *closed = sph2d__alloc(memory, cells, 1), *wet = sph2d__alloc(memory, cells, 1);
    void *queue = sph2d__alloc(memory, cells, sizeof(uint32_t));
    double level = NAN;
    if (closed && wet && queue)
        level =
            level_of(&(flood){.grid = c, .closed = closed, .wet = wet, .queue = queue}, area / (c->size_x * c->size_y));
    sph2d__release(memory, &closed, closed ? cells : 0, 1);
    sph2d__release(memory, &wet, wet ? cells : 0, 1);
    sph2d__release(memory, &queue, queue ? cells : 0, sizeof(uint32_t));
    return level;
}
