/* SPDX-License-Identifier: MIT */
/** @file traverse.h
 *  The traversal for one particle: its candidates, in blocks of SPH2D__LANES.
 *
 *  The last block of a range may extend past its end: lanes from `left` on hold other particles or padding and must
 *  contribute nothing. Pair terms see ranges, not cells. */
#ifndef SPH2D_METHODS_COMMON_TRAVERSE_H
#define SPH2D_METHODS_COMMON_TRAVERSE_H

#include "particles/cells.h"
#include "simd/lanes.h"

/** Runs the statement that follows for each block of candidates in `ranges`: `range` is the index of the range (whose x
 *  and y must be added to the particle's position), `first` the block's first candidate, `left` the number of
 *  candidates from there on (a double, so that it compares in the type of the lanes). */
#define SPH2D__FOR_BLOCKS(ranges, range, first, left)                                                                  \
    for (int range = 0; range < (ranges)->count; ++range)                                                              \
        for (size_t first = (ranges)->begin[range], end_ = (ranges)->end[range]; first < end_; first += SPH2D__LANES)  \
            for (double left = (double)(end_ - first), once_ = 1; once_ > 0; once_ = 0)

/** The ranges around a particle, kept from one particle to the next as long as they are in the same cell. */
typedef struct sph2d__cursor {
    uint32_t cell;
    sph2d__ranges ranges;
} sph2d__cursor;

#define SPH2D__CURSOR_START ((sph2d__cursor){.cell = UINT32_MAX - 1})

/** Moves the cursor to the cell at (x, y). False when there are no candidates. */
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
