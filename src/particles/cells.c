/* SPDX-License-Identifier: MIT */
/** @file cells.c
 *  Building the cells. */
#include "particles/cells.h"

#include <math.h>
#include <string.h>

#include "base/threads.h"

enum { RIM = 2 };
#define NONE UINT32_MAX

/* A list of neighbours is complete when the cells are as wide as the support; the excess covers rounding of the index.
 */
static const double MARGIN = 1 + 1e-6;

/* A cell's number has 32 bits. */
static const double MOST_CELLS = 4e9;
/* Cells grow by no more than this at a time, so that an extent near the end of the numbers does not make them infinite.
 */
static const double MAX_GROWTH = 1e100;

typedef struct bounds {
    double min_x, min_y, max_x, max_y;
} bounds;

/** Smallest and largest coordinates. They do not depend on how threads share the work. */
static bounds find_bounds(const sph2d__store *store, int threads)
{
    double min_x = INFINITY, min_y = INFINITY, max_x = -INFINITY, max_y = -INFINITY;
    const double *x = store->x, *y = store->y;
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1) reduction(min                          \
                                                                                          : min_x, min_y)              \
    reduction(max                                                                                                      \
              : max_x, max_y)
    for (size_t i = 0; i < store->count; ++i) {
        min_x = x[i] < min_x ? x[i] : min_x;
        min_y = y[i] < min_y ? y[i] : min_y;
        max_x = x[i] > max_x ? x[i] : max_x;
        max_y = y[i] > max_y ? y[i] : max_y;
    }
    return (bounds){min_x, min_y, max_x, max_y};
}

/** Lays the grid over the particles. Cells grow where sparse particles would need far more cells than there are
 *  particles, so that memory stays in proportion to the particles. */
static void lay_grid(sph2d__cells *cells, bounds b, double support, size_t count)
{
    double limit = fmin(8.0 * (double)count + 4096.0, MOST_CELLS);
    double size = support * MARGIN;
    double nx, ny;
    for (;;) {
        nx = floor(b.max_x / size - b.min_x / size) + 1 + 2 * RIM; /* the difference alone might overflow */
        ny = floor(b.max_y / size - b.min_y / size) + 1 + 2 * RIM;
        if (nx * ny <= limit)
            break;
        double excess = sqrt(nx) * sqrt(ny / limit);
        size *= !(excess < MAX_GROWTH) ? MAX_GROWTH : excess > 1.01 ? excess : 1.01;
    }
    cells->nx = (uint32_t)nx;
    cells->ny = (uint32_t)ny;
    cells->inverse_size = 1 / size;
    cells->origin_x = b.min_x - RIM * size;
    cells->origin_y = b.min_y - RIM * size;
}

static bool reserve_cells(sph2d__cells *cells, size_t needed, sph2d__memory *memory)
{
    size_t was = cells->cell_capacity;
    if (needed <= was)
        return true;
    size_t now = needed > was + was / 2 ? needed : was + was / 2;
    const sph2d__growth arrays[] = {{&cells->start, sizeof(uint32_t)}, {&cells->head, sizeof(uint32_t)}};
    if (!sph2d__grow_all(memory, arrays, 2, was, now))
        return false;
    cells->cell_capacity = now;
    return true;
}

static bool reserve_particles(sph2d__cells *cells, size_t needed, sph2d__memory *memory)
{
    size_t was = cells->particle_capacity;
    if (needed <= was)
        return true;
    const sph2d__growth arrays[] = {
        {&cells->next, sizeof(uint32_t)}, {&cells->cell, sizeof(uint32_t)}, {&cells->order, sizeof(uint32_t)}};
    if (!sph2d__grow_all(memory, arrays, 3, was, needed))
        return false;
    cells->particle_capacity = needed;
    return true;
}

/** The cell of each particle, by its place in the grid; rounding is kept inside the rim. */
static void assign_cells(sph2d__cells *cells, const sph2d__store *store, int threads)
{
    const double *x = store->x, *y = store->y;
    double ox = cells->origin_x, oy = cells->origin_y, inverse = cells->inverse_size;
    double last_x = cells->nx - 1.0 - RIM, last_y = cells->ny - 1.0 - RIM;
    uint32_t nx = cells->nx;
    uint32_t *cell = cells->cell;
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
    for (size_t i = 0; i < store->count; ++i) {
        double fx = (x[i] - ox) * inverse, fy = (y[i] - oy) * inverse;
        fx = fx > RIM ? fx : RIM;
        fy = fy > RIM ? fy : RIM;
        fx = fx < last_x ? fx : last_x;
        fy = fy < last_y ? fy : last_y;
        cell[i] = (uint32_t)fy * nx + (uint32_t)fx;
    }
}

/** Links every particle into its cell's list, from the last to the first, so that a list keeps the present order. */
static void link_particles(sph2d__cells *cells, size_t count, size_t cell_count)
{
    memset(cells->head, 0xff, cell_count * sizeof *cells->head);
    for (size_t i = count; i-- > 0;) {
        uint32_t *head = &cells->head[cells->cell[i]];
        cells->next[i] = *head;
        *head = (uint32_t)i;
    }
}

/** Walks the lists, cell after cell: the order of the particles, and where each cell starts in it. */
static void walk_lists(sph2d__cells *cells, size_t cell_count)
{
    uint32_t k = 0;
    for (size_t c = 0; c < cell_count; ++c) {
        cells->start[c] = k;
        for (uint32_t i = cells->head[c]; i != NONE; i = cells->next[i])
            cells->order[k++] = i;
    }
    cells->start[cell_count] = k;
}

bool sph2d__cells_build(sph2d__cells *cells, sph2d__store *store, double support, sph2d__memory *memory, int threads)
{
    size_t count = store->count;
    threads = sph2d__threads_for(threads, count);
    bounds b = count > 0 ? find_bounds(store, threads) : (bounds){0, 0, 0, 0};
    lay_grid(cells, b, support, count);
    size_t cell_count = (size_t)cells->nx * cells->ny;
    if (!reserve_cells(cells, cell_count + 1, memory) || !reserve_particles(cells, store->capacity, memory))
        return false;
    assign_cells(cells, store, threads);
    link_particles(cells, count, cell_count);
    walk_lists(cells, cell_count);
    sph2d__store_reorder(store, cells->order, threads);
    return true;
}

void sph2d__cells_free(sph2d__cells *cells, sph2d__memory *memory)
{
    void *by_cell[2] = {cells->start, cells->head};
    void *by_particle[3] = {cells->next, cells->cell, cells->order};
    for (int i = 0; i < 2; ++i)
        sph2d__release(memory, &by_cell[i], cells->cell_capacity, sizeof(uint32_t));
    for (int i = 0; i < 3; ++i)
        sph2d__release(memory, &by_particle[i], cells->particle_capacity, sizeof(uint32_t));
    *cells = (sph2d__cells){0};
}
