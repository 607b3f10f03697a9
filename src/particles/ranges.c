/* SPDX-License-Identifier: MIT */
/** @file ranges.c
 *  Queries of the cells, in C and in OpenCL C. */
#include "particles/cells.h"

/** Consecutive rows or columns, and the offset of their image: one period or 0. */
typedef struct span {
    uint32_t first, count;
    double offset;
} span;

/** The rows or columns from `first` - `reach` to `last` + `reach`: one span, or two across an end of the period.
 *  Returns their number. */
static int find_spans(uint32_t first, uint32_t last, uint32_t reach, uint32_t all, double period, span out[2])
{
    uint32_t low = SPH2D__RIM * reach, high = all - low; /* the columns of the period */
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

SPH2D__LINKED void sph2d__cells_around(const sph2d__cells *cells, const sph2d__patch *p, bool cut, sph2d__ranges *to)
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

SPH2D__LINKED void sph2d__cells_periodic_ranges(const sph2d__cells *cells, uint32_t cell, sph2d__ranges *to)
{
    uint32_t row = cell / cells->nx, column = cell - row * cells->nx;
    sph2d__patch patch = {column, column, row, row};
    sph2d__cells_around(cells, &patch, false, to);
}
