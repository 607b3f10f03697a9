/* SPDX-License-Identifier: MIT */
/** @file slices.h
 *  Fills neighbour lists on a device, where a thread has a particle (in C: src/methods/common/slices.h). The slots of SPH2D__STRIDE particles
 *  take turns, so that their threads read side by side; each particle has room for as many pairs. */
#ifndef SPH2D_METHODS_COMMON_SLICES_H
#define SPH2D_METHODS_COMMON_SLICES_H

#include "particles/cells.h"
#include "particles/neighbours.h"
#include "simd/lanes.h"

/** Where the pairs of a particle go. */
typedef struct sph2d__pairs {
    __global uint32_t *index;
    size_t next, end; /* the next slot, and the end of its room */
    uint32_t most;    /* of the list that is being made */
    bool full;
    int fluid, walls, images;
} sph2d__pairs;

SPH2D__INLINE sph2d__pairs sph2d__pairs_of_particle(const sph2d__neighbours *n, size_t i)
{
    const size_t begin = i / SPH2D__STRIDE * SPH2D__STRIDE * n->each + i % SPH2D__STRIDE;
    return (sph2d__pairs){.index = n->index, .next = begin, .end = begin + n->each * SPH2D__STRIDE};
}

SPH2D__INLINE void sph2d__pairs_none(sph2d__pairs *to)
{
    to->most = 0;
}

SPH2D__INLINE void sph2d__pairs_put(sph2d__pairs *to, size_t lane, uint32_t j)
{
    const size_t k = to->next + (size_t)to->most * SPH2D__STRIDE;
    to->full = to->full || k >= to->end;
    if (to->full)
        return;
    to->index[k] = j;
    ++to->most;
}

/** Lists the neighbours in one store of particle `first` of another, or of the same one (`own`). */
SPH2D__INLINE void sph2d__pairs_search(sph2d__pairs *to, int *cursor, const sph2d__cells *cells,
                                       const sph2d__store *from, const sph2d__store *of, size_t first, double support2,
                                       bool own, __global const double *filled)
{
    const double x = of->x[first], y = of->y[first];
    const uint32_t cell = sph2d__cells_find(cells, x, y);
    sph2d__ranges ranges;
    to->most = 0;
    if (cell == UINT32_MAX)
        return;
    sph2d__cells_ranges(cells, cell, &ranges);
    SPH2D__FOR_NEIGHBOURS (&ranges, r, j) {
        const double dx = x + ranges.x[r] - from->x[j], dy = y + ranges.y[r] - from->y[j];
        if (dx * dx + dy * dy < support2 && !(own && j == first))
            sph2d__pairs_put(to, 0, (uint32_t)j);
    }
}

/** Ends the list. Returns how many there are. */
SPH2D__INLINE uint32_t sph2d__pairs_write(sph2d__neighbours *n, sph2d__pairs *to, size_t far)
{
    const uint32_t count = to->full ? 0 : to->most;
    to->next += (size_t)count * SPH2D__STRIDE;
    return count;
}

#endif
