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

/** Finds the cell of each particle from `first` to `last` - 1, clamped against rounding, and counts the particles of
 *  each cell.
 * */
static void assign_cells(sph2d__cells *cells, const sph2d__store *store, size_t first, size_t last, uint32_t *count)
{
    const double *x = store->x, *y = store->y;
    double ox = cells->origin_x, oy = cells->origin_y, ix = cells->inverse_x, iy = cells->inverse_y;
    double rim_x = (double)RIM * cells->columns, last_x = cells->nx - 1.0 - rim_x, last_y = cells->ny - 1.0 - RIM;
    uint32_t nx = cells->nx;
    for (size_t i = first; i < last; ++i) {
        double fx = (x[i] - ox) * ix, fy = (y[i] - oy) * iy;
        fx = fx > rim_x ? fx : rim_x;
        fy = fy > RIM ? fy : RIM;
        fx = fx < last_x ? fx : last_x;
        fy = fy < last_y ? fy : last_y;
        uint32_t cell = (uint32_t)fy * nx + (uint32_t)fx;
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

bool sph2d__cells_build(sph2d__cells *cells, sph2d__store *store, double support, sph2d__memory *memory)
{
    size_t count = store->count;
    lay_grid(cells, count > 0 ? find_bounds(store) : (bounds){0, 0, 0, 0}, support, count);
    size_t cell_count = (size_t)cells->nx * cells->ny;
    int sorters = sorters_for(count);
    if (!reserve(&cells->start, &cells->cell_capacity, cell_count + 1, memory) ||
        !reserve(&cells->places, &cells->place_capacity, cell_count * (size_t)sorters, memory) ||
        !reserve_particles(cells, store->capacity, memory)) {
        cells->nx = cells->ny = 0; /* the grid is not filled */
        return false;
    }
    sort_particles(cells, store, cell_count, sorters);
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

/* ---- queries ----------------------------------------------------------------------------------------------------- */

/** Consecutive rows or columns, and the offset of their image: one period or 0. */
typedef struct span {
    uint32_t first, count;
    double offset;
} span;

/** The rows or columns from `first` - `reach` to `last` + `reach`: one span, or two across an end of the period.
 *  Returns their number. */
static int find_spans(uint32_t first, uint32_t last, uint32_t reach, uint32_t all, double period, span out[2])
{
    uint32_t low = RIM * reach, high = all - low; /* the columns of the period */
    uint32_t count = last - first + 2 * reach + 1;
    first -= reach;
    out[0] = (span){first, count, 0};
    if (!(period > 0))
        return 1;
    if (first < low) { /* the columns below the first are images of the last */
        uint32_t beyond = low - first;
        out[0] = (span){high - beyond, beyond, period};
        out[1] = (span){low, count - beyond, 0};
        return 2;
    }
    if (first + count > high) {
        uint32_t beyond = first + count - high;
        out[0] = (span){first, count - beyond, 0};
        out[1] = (span){low, beyond, -period};
        return 2;
    }
    return 1;
}

/** Adds the particles of a span of columns in one row as a range, if there are any. */
static void add_range(sph2d__ranges *to, const sph2d__cells *cells, uint32_t row, const span *columns, double offset)
{
    size_t first = (size_t)row * cells->nx + columns->first;
    uint32_t begin = cells->start[first], end = cells->start[first + columns->count];
    if (begin == end)
        return;
    int r = to->count++;
    to->begin[r] = begin;
    to->end[r] = end;
    to->x[r] = columns->offset;
    to->y[r] = offset;
}

/** Adds a span of columns in one row; `cut`: split at the ends of tiles, with offsets relative to each tile's
 *  corner. */
static void add_row(sph2d__ranges *to, const sph2d__cells *cells, uint32_t row, span columns, double offset, bool cut)
{
    if (!cut) {
        add_range(to, cells, row, &columns, offset);
        return;
    }
    uint32_t end = columns.first + columns.count;
    for (uint32_t first = columns.first, next; first < end; first = next) {
        next = (first / SPH2D__TILE + 1) * SPH2D__TILE;
        next = next < end ? next : end;
        span part = {first, next - first, columns.offset - sph2d__tile_x(cells, first)};
        add_range(to, cells, row, &part, offset - sph2d__tile_y(cells, row));
    }
}

void sph2d__cells_around(const sph2d__cells *cells, const sph2d__patch *p, bool cut, sph2d__ranges *to)
{
    span columns[2], rows[2];
    int column_count = find_spans(p->left, p->right, cells->columns, cells->nx, cells->period.length_x, columns);
    int row_count = find_spans(p->bottom, p->top, 1, cells->ny, cells->period.length_y, rows);
    to->count = 0;
    for (int b = 0; b < row_count; ++b)
        for (uint32_t row = rows[b].first; row < rows[b].first + rows[b].count; ++row)
            for (int a = 0; a < column_count; ++a)
                add_row(to, cells, row, columns[a], rows[b].offset, cut);
}

void sph2d__cells_periodic_ranges(const sph2d__cells *cells, uint32_t cell, sph2d__ranges *to)
{
    uint32_t row = cell / cells->nx, column = cell - row * cells->nx;
    sph2d__patch patch = {column, column, row, row};
    sph2d__cells_around(cells, &patch, false, to);
}
