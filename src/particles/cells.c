/* SPDX-License-Identifier: MIT */
/** @file cells.c
 *  Building the cells. */
#include "particles/cells.h"

#include <math.h>
#include <string.h>

enum { RIM = SPH2D__RIM };

/* The ranges hold all neighbours if the cells are as wide as the support; the excess covers rounding of the index.
 */
static const double MARGIN = 1 + 1e-6;

/* Cells have 32-bit indices. */
static const double MAX_CELLS = 4e9;
/* Cells grow by at max_sorters this factor at a time, so that an extent near DBL_MAX does not make them infinite. */
static const double MAX_GROWTH = 1e100;

typedef struct bounds {
    double min_x, min_y, max_x, max_y;
} bounds;

/** The bounds of a store: input and result. */
typedef struct extent {
    const sph2d__store *store;
    sph2d__team *team;
    bounds found;
} extent;

static void add_bounds(void *with, size_t first, size_t last)
{
    extent *e = with;
    const double *x = e->store->x, *y = e->store->y;
    bounds b = {INFINITY, INFINITY, -INFINITY, -INFINITY}, *all = &e->found;
    for (size_t i = first; i < last; ++i) {
        b.min_x = x[i] < b.min_x ? x[i] : b.min_x;
        b.min_y = y[i] < b.min_y ? y[i] : b.min_y;
        b.max_x = x[i] > b.max_x ? x[i] : b.max_x;
        b.max_y = y[i] > b.max_y ? y[i] : b.max_y;
    }
    sph2d__team_lock(e->team);
    all->min_x = b.min_x < all->min_x ? b.min_x : all->min_x;
    all->min_y = b.min_y < all->min_y ? b.min_y : all->min_y;
    all->max_x = b.max_x > all->max_x ? b.max_x : all->max_x;
    all->max_y = b.max_y > all->max_y ? b.max_y : all->max_y;
    sph2d__team_unlock(e->team);
}

/** Smallest and largest coordinates: the same for any number of threads. */
static bounds find_bounds(const sph2d__store *store, sph2d__team *team)
{
    extent e = {store, team, {INFINITY, INFINITY, -INFINITY, -INFINITY}};
    sph2d__share(team, store->count, SPH2D__GRAIN, add_bounds, &e);
    return e.found;
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

/** A counting sort: each sorter has a part of the particles and a part of the cells. */
typedef struct sorting {
    sph2d__cells *cells;
    const sph2d__store *store;
    size_t cell_count;
    int sorters;
    uint32_t sums[SORTERS]; /**< particles in each part of the cells */
} sorting;

static void count_parts(void *with, size_t first, size_t last)
{
    const sorting *s = with;
    for (int t = (int)first; t < (int)last; ++t) {
        uint32_t *count = s->cells->places + (size_t)t * s->cell_count;
        memset(count, 0, s->cell_count * sizeof *count);
        assign_cells(s->cells, s->store, part(s->store->count, t, s->sorters), part(s->store->count, t + 1, s->sorters),
                     count);
    }
}

static void sum_parts(void *with, size_t first, size_t last)
{
    sorting *s = with;
    for (int t = (int)first; t < (int)last; ++t)
        s->sums[t] = count_cells(s->cells, part(s->cell_count, t, s->sorters), part(s->cell_count, t + 1, s->sorters),
                                 s->cell_count, s->sorters);
}

static void start_parts(void *with, size_t first, size_t last)
{
    const sorting *s = with;
    for (int t = (int)first; t < (int)last; ++t) {
        uint32_t before = 0;
        for (int u = 0; u < t; ++u)
            before += s->sums[u];
        start_cells(s->cells, part(s->cell_count, t, s->sorters), part(s->cell_count, t + 1, s->sorters), s->cell_count,
                    s->sorters, before);
    }
}

static void order_parts(void *with, size_t first, size_t last)
{
    const sorting *s = with;
    const sph2d__cells *cells = s->cells;
    for (int t = (int)first; t < (int)last; ++t) {
        uint32_t *place = cells->places + (size_t)t * s->cell_count;
        size_t end = part(s->store->count, t + 1, s->sorters);
        for (size_t i = part(s->store->count, t, s->sorters); i < end; ++i)
            cells->order[place[cells->cell[i]]++] = (uint32_t)i;
    }
}

/** The sort is stable, so the order does not depend on the number of sorters. */
static void sort_particles(sph2d__cells *cells, const sph2d__store *store, size_t cell_count, int sorters,
                           sph2d__team *team)
{
    static sph2d__share_work *const passes[] = {count_parts, sum_parts, start_parts, order_parts};
    sorting s = {cells, store, cell_count, sorters, {0}};
    for (size_t k = 0; k < sizeof passes / sizeof *passes; ++k)
        sph2d__share(team, (size_t)sorters, 1, passes[k], &s);
    cells->start[cell_count] = (uint32_t)store->count;
}

/** Depends on the team's limit, not on the threads in use: the memory then stays the same. */
static int sorters_for(const sph2d__team *team, size_t count)
{
    int max_sorters = sph2d__team_limit(team) < SORTERS ? sph2d__team_limit(team) : SORTERS;
    size_t worth = count / SPH2D__GRAIN;
    return worth < 1 ? 1 : worth < (size_t)max_sorters ? (int)worth : max_sorters;
}

bool sph2d__cells_build(sph2d__cells *cells, sph2d__store *store, double support, sph2d__memory *memory,
                        sph2d__team *team)
{
    size_t count = store->count;
    bounds b = count > 0 ? find_bounds(store, team) : (bounds){0, 0, 0, 0};
    lay_grid(cells, b, support, count);
    size_t cell_count = (size_t)cells->nx * cells->ny;
    int sorters = sorters_for(team, count);
    if (!reserve(&cells->start, &cells->cell_capacity, cell_count + 1, memory) ||
        !reserve(&cells->places, &cells->place_capacity, cell_count * (size_t)sorters, memory) ||
        !reserve_particles(cells, store->capacity, memory)) {
        cells->nx = cells->ny = 0; /* the grid is not filled */
        return false;
    }
    sort_particles(cells, store, cell_count, sorters, team);
    sph2d__store_reorder(store, cells->order, team);
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
