/* SPDX-License-Identifier: MIT */
/** @file cells.c
 *  Building the cells. */
#include "particles/cells.h"

#include <math.h>
#include <string.h>

#include "base/threads.h"

enum { RIM = SPH2D__RIM };
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

/** The cells of one direction, rim included. */
typedef struct axis {
    double origin, size, count;
} axis;

/** Cells of at least `size`, `parts` together, over an extent, or exactly over a period, which must hold three times as
 * many. */
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

/** Lays the grid over the particles. Cells grow where sparse particles would need far more cells than there are
 *  particles, so that memory stays in proportion to the particles. */
static void lay_grid(sph2d__cells *cells, bounds b, double support, size_t count)
{
    const sph2d__period *p = &cells->period;
    double limit = fmin(8.0 * (double)count + 4096.0, MOST_CELLS);
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
    double ox = cells->origin_x, oy = cells->origin_y, ix = cells->inverse_x, iy = cells->inverse_y;
    double rim_x = (double)RIM * cells->columns, last_x = cells->nx - 1.0 - rim_x, last_y = cells->ny - 1.0 - RIM;
    uint32_t nx = cells->nx;
    uint32_t *cell = cells->cell;
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
    for (size_t i = 0; i < store->count; ++i) {
        double fx = (x[i] - ox) * ix, fy = (y[i] - oy) * iy;
        fx = fx > rim_x ? fx : rim_x;
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
    *cells = (sph2d__cells){.period = cells->period, .columns = cells->columns};
}

/* ---- asking ------------------------------------------------------------------------------------------------------ */

/** Some of the neighbouring rows or columns: they follow each other, moved by one period or not. */
typedef struct stretch {
    uint32_t first, count;
    double offset;
} stretch;

/** The rows or columns from `reach` before `first` to `reach` behind `last`, in one stretch or, at an end of the
 * period, two. Returns the number. */
static int stretches(uint32_t first, uint32_t last, uint32_t reach, uint32_t all, double period, stretch out[2])
{
    uint32_t low = RIM * reach, high = all - low; /* the columns of the period */
    uint32_t count = last - first + 2 * reach + 1;
    first -= reach;
    out[0] = (stretch){first, count, 0};
    if (!(period > 0))
        return 1;
    if (first < low) { /* the image below the first column is the last one */
        uint32_t beyond = low - first;
        out[0] = (stretch){high - beyond, beyond, period};
        out[1] = (stretch){low, count - beyond, 0};
        return 2;
    }
    if (first + count > high) {
        uint32_t beyond = first + count - high;
        out[0] = (stretch){first, count - beyond, 0};
        out[1] = (stretch){low, beyond, -period};
        return 2;
    }
    return 1;
}

/** Adds the particles of some cells of one row as a range, unless there are none. */
static void add_range(sph2d__ranges *to, const sph2d__cells *cells, uint32_t row, const stretch *columns, double offset)
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

/** Adds the cells of one row, or, to be cut at the ends of tiles, each part of them relative to its tile's corner. */
static void add_row(sph2d__ranges *to, const sph2d__cells *cells, uint32_t row, stretch columns, double offset,
                    bool cut)
{
    if (!cut) {
        add_range(to, cells, row, &columns, offset);
        return;
    }
    uint32_t end = columns.first + columns.count;
    for (uint32_t first = columns.first, next; first < end; first = next) {
        next = (first / SPH2D__TILE + 1) * SPH2D__TILE;
        next = next < end ? next : end;
        stretch part = {first, next - first, columns.offset - sph2d__tile_x(cells, first)};
        add_range(to, cells, row, &part, offset - sph2d__tile_y(cells, row));
    }
}

void sph2d__cells_around(const sph2d__cells *cells, const sph2d__patch *p, bool cut, sph2d__ranges *to)
{
    stretch columns[2], rows[2];
    int column_count = stretches(p->left, p->right, cells->columns, cells->nx, cells->period.length_x, columns);
    int row_count = stretches(p->bottom, p->top, 1, cells->ny, cells->period.length_y, rows);
    to->count = 0;
    for (int b = 0; b < row_count; ++b)
        for (uint32_t row = rows[b].first; row < rows[b].first + rows[b].count; ++row)
            for (int a = 0; a < column_count; ++a)
                add_row(to, cells, row, columns[a], rows[b].offset, cut);
}

/** The patch of one cell. */
static sph2d__patch patch_of(const sph2d__cells *cells, uint32_t cell)
{
    uint32_t row = cell / cells->nx, column = cell - row * cells->nx;
    return (sph2d__patch){column, column, row, row};
}

void sph2d__cells_periodic_ranges(const sph2d__cells *cells, uint32_t cell, sph2d__ranges *to)
{
    sph2d__patch patch = patch_of(cells, cell);
    sph2d__cells_around(cells, &patch, false, to);
}

void sph2d__cells_cut_ranges(const sph2d__cells *cells, uint32_t cell, sph2d__ranges *to)
{
    sph2d__patch patch = patch_of(cells, cell);
    sph2d__cells_around(cells, &patch, true, to);
}
