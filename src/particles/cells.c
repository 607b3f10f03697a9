/* SPDX-License-Identifier: MIT */
/** @file cells.c
 *  Building the cells. */
#include "particles/cells.h"

#include <math.h>
#include <string.h>

#include "base/parallel.h"

enum { RIM = SPH2D__RIM };

/* The ranges hold all neighbours if the cells are as wide as the support; the excess covers rounding of the index.
 */
static const double MARGIN = 1 + 1e-6;

/* Cells have 32-bit indices. */
static const double MAX_CELLS = 4e9;
/* Cells grow by at most this factor at a time, so that an extent near DBL_MAX does not make them infinite. */
static const double MAX_GROWTH = 1e100;

typedef struct bounds {
    double min_x, min_y, max_x, max_y;
} bounds;

static bounds join(bounds a, bounds b)
{
    return (bounds){a.min_x < b.min_x ? a.min_x : b.min_x, a.min_y < b.min_y ? a.min_y : b.min_y,
                    a.max_x > b.max_x ? a.max_x : b.max_x, a.max_y > b.max_y ? a.max_y : b.max_y};
}

static const bounds no_bounds = {INFINITY, INFINITY, -INFINITY, -INFINITY};

/** Smallest and largest coordinates: the same for any number of threads. */
static bounds find_bounds(const sph2d__store *store)
{
    const double *x = store->x, *y = store->y;
    size_t count = store->count;
    bounds all = no_bounds;
#pragma omp taskloop num_tasks(sph2d__tasks(count, SPH2D__GRAIN)) if (count > SPH2D__GRAIN) shared(all)
    for (size_t first = 0; first < count; first += SPH2D__GRAIN) {
        bounds part = no_bounds;
        for (size_t i = first; i < count && i < first + SPH2D__GRAIN; ++i)
            part = join(part, (bounds){x[i], y[i], x[i], y[i]});
#pragma omp critical(sph2d_bounds)
        all = join(all, part);
    }
    return all;
}

/** The cells of one direction, rim included. */
typedef struct axis {
    double origin, size, count;
} axis;

/** Cells over an extent, `parts` of them at least `size` wide together; or exactly over a period, in which case there
 *  are at least 3 `parts`. */
static axis lay_axis(double low, double high, double size, double parts, double period_low, double period)
{
    double rim = RIM * parts;
    if (period > 0) {
        double count = parts * fmax(floor(period / size), 3);
        size = period / count;
        return (axis){period_low - rim * size, size, count + 2 * rim};
    }
    size /= parts;
    double count = floor(high / size - low / size) + 1; /* the difference alone might overflow */
    return (axis){low - rim * size, size, count + 2 * rim};
}

/** Lays the grid over the particles. Sparse particles get larger cells, so that memory stays in proportion to the
 *  number of particles. */
static void lay_grid(sph2d__cells *cells, bounds b, double support, size_t count)
{
    const sph2d__period *p = &cells->period;
    double limit = fmin(8.0 * (double)count + 4096.0, MAX_CELLS);
    double size = support * MARGIN;
    axis x, y;
    for (;;) {
        x = lay_axis(b.min_x, b.max_x, size, cells->columns, p->low_x, p->length_x);
        y = lay_axis(b.min_y, b.max_y, size, 1, p->low_y, p->length_y);
        if (x.count * y.count <= limit)
            break;
        double excess = sqrt(x.count) * sqrt(y.count / limit);
        size *= !(excess < MAX_GROWTH) ? MAX_GROWTH : excess > 1.01 ? excess : 1.01;
    }
    cells->nx = (uint32_t)x.count;
    cells->ny = (uint32_t)y.count;
    cells->width = x.size;
    cells->height = y.size;
    cells->inverse_x = 1 / x.size;
    cells->inverse_y = 1 / y.size;
    cells->origin_x = x.origin;
    cells->origin_y = y.origin;
}

/* The maximum number of sorters: parallel parts of the counting sort, each with its own counts. */
enum { SORTERS = 4 };

/** Grows an array of the cells, by at least a half. */
static bool reserve(uint32_t **array, size_t *capacity, size_t needed, sph2d__memory *memory)
{
    size_t was = *capacity;
    if (needed <= was)
        return true;
    size_t now = needed > was + was / 2 ? needed : was + was / 2;
    const sph2d__growth growth = {array, sizeof **array};
    if (!sph2d__grow_all(memory, &growth, 1, was, now))
        return false;
    *capacity = now;
    return true;
}

static bool reserve_particles(sph2d__cells *cells, size_t needed, sph2d__memory *memory)
{
    size_t was = cells->particle_capacity;
    if (needed <= was)
        return true;
    const sph2d__growth arrays[] = {{&cells->cell, sizeof(uint32_t)}, {&cells->order, sizeof(uint32_t)}};
    if (!sph2d__grow_all(memory, arrays, 2, was, needed))
        return false;
    cells->particle_capacity = needed;
    return true;
}

/** Part k of `parts` equal ones of 0 to count. */
static size_t part(size_t count, int k, int parts)
{
    return count / (size_t)parts * (size_t)k + count % (size_t)parts * (size_t)k / (size_t)parts;
}

/** Finds the cell of each particle from `first` to `last` - 1, and counts the particles of each cell. */
static void assign_cells(sph2d__cells *cells, const sph2d__store *store, size_t first, size_t last, uint32_t *count)
{
    const double *x = store->x, *y = store->y;
    const sph2d__cells of = *cells;
    for (size_t i = first; i < last; ++i) {
        const uint32_t cell = sph2d__cell_of(&of, x[i], y[i]);
        cells->cell[i] = cell;
        ++count[cell];
    }
}

/** Particles in cells first to last - 1, of all sorters. */
static uint32_t count_cells(const sph2d__cells *cells, size_t first, size_t last, size_t cell_count, int sorters)
{
    uint32_t sum = 0;
    for (int t = 0; t < sorters; ++t)
        for (size_t c = first; c < last; ++c)
            sum += cells->places[(size_t)t * cell_count + c];
    return sum;
}

/** Sets the start of each of these cells, and in it the start of each sorter's particles; `k` particles come before. */
static void start_cells(sph2d__cells *cells, size_t first, size_t last, size_t cell_count, int sorters, uint32_t k)
{
    for (size_t c = first; c < last; ++c) {
        cells->start[c] = k;
        for (int t = 0; t < sorters; ++t) {
            uint32_t *place = &cells->places[(size_t)t * cell_count + c], count = *place;
            *place = k;
            k += count;
        }
    }
}

/** Puts the particles of a sorter in the order of their cells. */
static void order_part(sph2d__cells *cells, uint32_t *place, size_t first, size_t last)
{
    for (size_t i = first; i < last; ++i)
        cells->order[place[cells->cell[i]]++] = (uint32_t)i;
}

/** A counting sort by several sorters: each has a part of the particles, and a part of the cells. It is stable, so the
 *  order does not depend on their number. */
static void sort_particles(sph2d__cells *cells, const sph2d__store *store, size_t cell_count, int sorters)
{
    uint32_t in_cells[SORTERS]; /* particles in each part of the cells */
    size_t count = store->count;
#pragma omp taskloop grainsize(1) if (sorters > 1)
    for (int t = 0; t < sorters; ++t) {
        uint32_t *counts = cells->places + (size_t)t * cell_count;
        memset(counts, 0, cell_count * sizeof *counts);
        assign_cells(cells, store, part(count, t, sorters), part(count, t + 1, sorters), counts);
    }
#pragma omp taskloop grainsize(1) if (sorters > 1) shared(in_cells)
    for (int t = 0; t < sorters; ++t)
        in_cells[t] =
            count_cells(cells, part(cell_count, t, sorters), part(cell_count, t + 1, sorters), cell_count, sorters);
#pragma omp taskloop grainsize(1) if (sorters > 1) shared(in_cells)
    for (int t = 0; t < sorters; ++t) {
        uint32_t before = 0;
        for (int u = 0; u < t; ++u)
            before += in_cells[u];
        start_cells(cells, part(cell_count, t, sorters), part(cell_count, t + 1, sorters), cell_count, sorters, before);
    }
    cells->start[cell_count] = (uint32_t)count;
#pragma omp taskloop grainsize(1) if (sorters > 1)
    for (int t = 0; t < sorters; ++t)
        order_part(cells, cells->places + (size_t)t * cell_count, part(count, t, sorters), part(count, t + 1, sorters));
}

static int sorters_for(size_t count)
{
    int most = sph2d__threads() < SORTERS ? sph2d__threads() : SORTERS;
    size_t worth = count / SPH2D__GRAIN;
    return worth < 1 ? 1 : worth < (size_t)most ? (int)worth : most;
}

static bool lay_and_reserve(sph2d__cells *cells, const sph2d__store *store, bounds around, double support, int sorters,
                            size_t more, sph2d__memory *memory)
{
    lay_grid(cells, store->count > 0 ? around : (bounds){0, 0, 0, 0}, support, store->count);
    const size_t cell_count = (size_t)cells->nx * cells->ny;
    if (reserve(&cells->start, &cells->cell_capacity, cell_count + 1, memory) &&
        reserve(&cells->places, &cells->place_capacity, cell_count * (size_t)sorters + more, memory) &&
        reserve_particles(cells, store->capacity, memory))
        return true;
    cells->nx = cells->ny = 0; /* the grid is not filled */
    return false;
}

bool sph2d__cells_lay(sph2d__cells *cells, const sph2d__store *store, const double around[4], double support,
                      size_t more, sph2d__memory *memory)
{
    return lay_and_reserve(cells, store, (bounds){around[0], around[1], around[2], around[3]}, support, 1, more,
                           memory);
}

bool sph2d__cells_build(sph2d__cells *cells, sph2d__store *store, double support, sph2d__memory *memory)
{
    const int sorters = sorters_for(store->count);
    if (!lay_and_reserve(cells, store, find_bounds(store), support, sorters, 0, memory))
        return false;
    sort_particles(cells, store, (size_t)cells->nx * cells->ny, sorters);
    sph2d__store_reorder(store, cells->order);
    return true;
}

void sph2d__cells_free(sph2d__cells *cells, sph2d__memory *memory)
{
    void *start = cells->start, *places = cells->places;
    void *by_particle[2] = {cells->cell, cells->order};
    sph2d__release(memory, &start, cells->cell_capacity, sizeof(uint32_t));
    sph2d__release(memory, &places, cells->place_capacity, sizeof(uint32_t));
    for (int i = 0; i < 2; ++i)
        sph2d__release(memory, &by_particle[i], cells->particle_capacity, sizeof(uint32_t));
    *cells = (sph2d__cells){.period = cells->period, .columns = cells->columns};
}
