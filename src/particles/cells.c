/* SPDX-License-Identifier: MIT */
/** @file cells.c
 *  Building the cells. */
#include "particles/cells.h"

#include <math.h>
#include <string.h>

enum { RIM = SPH2D__RIM };

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

/** What is asked, and what was found. */
typedef struct extent {
    const sph2d__store *store;
    sph2d__team *team;
    bounds found;
} extent;

static void find_some_bounds(void *with, size_t first, size_t last)
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

/** Smallest and largest coordinates. They do not depend on how threads share the work. */
static bounds find_bounds(const sph2d__store *store, sph2d__team *team)
{
    extent e = {store, team, {INFINITY, INFINITY, -INFINITY, -INFINITY}};
    sph2d__share(team, store->count, SPH2D__GRAIN, find_some_bounds, &e);
    return e.found;
}

/** The cells of one direction, rim included. */
typedef struct axis {
    double origin, size, count;
} axis;

/** Cells of at least `size`, `parts` together, over an extent, or exactly over a period, which must hold three times as
 *  many. */
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

/* Threads that sort: each counts cells of its own. */
enum { SORTERS = 4 };

/** Room for something of each cell; it grows by half at least. */
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

/** The cell of each particle from `first` on, by its place in the grid; rounding is kept inside the rim. Counts them.
 */
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

/** Where each of these cells starts, and in it the particles of each sorter; `k` particles are before them. */
static void place_cells(sph2d__cells *cells, size_t first, size_t last, size_t cell_count, int sorters, uint32_t k)
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

/** Sorting by counting, each sorter its part of the particles and its part of the cells. */
typedef struct sorting {
    sph2d__cells *cells;
    const sph2d__store *store;
    size_t cell_count;
    int sorters;
    uint32_t sums[SORTERS]; /**< particles in each part of the cells */
} sorting;

static void count_some(void *with, size_t first, size_t last)
{
    const sorting *s = with;
    for (int t = (int)first; t < (int)last; ++t) {
        uint32_t *count = s->cells->places + (size_t)t * s->cell_count;
        memset(count, 0, s->cell_count * sizeof *count);
        assign_cells(s->cells, s->store, part(s->store->count, t, s->sorters), part(s->store->count, t + 1, s->sorters),
                     count);
    }
}

static void sum_some(void *with, size_t first, size_t last)
{
    sorting *s = with;
    for (int t = (int)first; t < (int)last; ++t)
        s->sums[t] = count_cells(s->cells, part(s->cell_count, t, s->sorters), part(s->cell_count, t + 1, s->sorters),
                                 s->cell_count, s->sorters);
}

static void place_some(void *with, size_t first, size_t last)
{
    const sorting *s = with;
    for (int t = (int)first; t < (int)last; ++t) {
        uint32_t before = 0;
        for (int u = 0; u < t; ++u)
            before += s->sums[u];
        place_cells(s->cells, part(s->cell_count, t, s->sorters), part(s->cell_count, t + 1, s->sorters), s->cell_count,
                    s->sorters, before);
    }
}

static void order_some(void *with, size_t first, size_t last)
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

/** Within a cell particles keep the order that they had, however many sorters there are. */
static void sort_particles(sph2d__cells *cells, const sph2d__store *store, size_t cell_count, int sorters,
                           sph2d__team *team)
{
    static sph2d__share_work *const turns[] = {count_some, sum_some, place_some, order_some};
    sorting s = {cells, store, cell_count, sorters, {0}};
    for (size_t k = 0; k < sizeof turns / sizeof *turns; ++k)
        sph2d__share(team, (size_t)sorters, 1, turns[k], &s);
    cells->start[cell_count] = (uint32_t)store->count;
}

/** The same however many threads there are at a time, and with them the room. */
static int sorters_for(const sph2d__team *team, size_t count)
{
    int most = sph2d__team_limit(team) < SORTERS ? sph2d__team_limit(team) : SORTERS;
    size_t worth = count / SPH2D__GRAIN;
    return worth < 1 ? 1 : worth < (size_t)most ? (int)worth : most;
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
        !reserve_particles(cells, store->capacity, memory))
        return false;
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

/* ---- asking ------------------------------------------------------------------------------------------------------ */

/** Some of the neighbouring rows or columns: they follow each other, moved by one period or not. */
typedef struct stretch {
    uint32_t first, count;
    double offset;
} stretch;

/** The rows or columns from `reach` before `first` to `reach` behind `last`, in one stretch or, at an end of the
 *  period, two. Returns the number. */
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

void sph2d__cells_periodic_ranges(const sph2d__cells *cells, uint32_t cell, sph2d__ranges *to)
{
    uint32_t row = cell / cells->nx, column = cell - row * cells->nx;
    sph2d__patch patch = {column, column, row, row};
    sph2d__cells_around(cells, &patch, false, to);
}
