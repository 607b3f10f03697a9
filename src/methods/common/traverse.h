/* SPDX-License-Identifier: MIT */
/** @file traverse.h
 *  The traversal: hands a pair term one particle and its candidates, a block of SPH2D__LANES at a time.
 *
 *  The last block of a range runs over its end: lanes from `left` on hold other particles or padding and must count as
 *  nothing. What lies behind the ranges (cells, today) is not seen by the terms. */
#ifndef SPH2D_METHODS_COMMON_TRAVERSE_H
#define SPH2D_METHODS_COMMON_TRAVERSE_H

#include "particles/cells.h"
#include "simd/lanes.h"

/** Runs the statement behind it for each block of candidates in `ranges`: `range` is the number of the range (whose x
 *  and y must be added to the asking particle's place), `first` the block's first particle, `left` (a double, so that
 *  it compares in the lanes' own type) the number of candidates from there on. */
#define SPH2D__FOR_BLOCKS(ranges, range, first, left)                                                                  \
    for (int range = 0; range < (ranges)->count; ++range)                                                              \
        for (size_t first = (ranges)->begin[range], end_ = (ranges)->end[range]; first < end_; first += SPH2D__LANES)  \
            for (double left = (double)(end_ - first), once_ = 1; once_ > 0; once_ = 0)

/** The ranges around one particle after another: kept while they stay in one cell, as particles in cell order do. */
typedef struct sph2d__cursor {
    uint32_t cell;
    sph2d__ranges ranges;
} sph2d__cursor;

#define SPH2D__CURSOR_START ((sph2d__cursor){.cell = UINT32_MAX - 1})

/** Moves the cursor to the cell at (x, y). False when no particle can be near. */
SPH2D__INLINE bool sph2d__cursor_move(sph2d__cursor *cursor, const sph2d__cells *cells, double x, double y)
{
    uint32_t cell = sph2d__cells_find(cells, x, y);
    if (cell == cursor->cell)
        return cell != UINT32_MAX;
    cursor->cell = cell;
    if (cell == UINT32_MAX)
        return false;
    sph2d__cells_ranges(cells, cell, &cursor->ranges);
    return true;
}

#endif
