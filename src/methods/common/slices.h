/* SPDX-License-Identifier: MIT */
/** @file slices.h
 *  Fills neighbour lists (particles/neighbours.h): neighbours are searched for one particle after another, a block of
 *  candidates at a time, and written slot by slot. */
#ifndef SPH2D_METHODS_COMMON_SLICES_H
#define SPH2D_METHODS_COMMON_SLICES_H

#include "methods/common/traverse.h"
#include "particles/neighbours.h"

/** Where the pairs of a slab go. */
typedef struct sph2d__pairs {
    size_t next, end;                    /**< room that is left */
    SPH2D__ARRAY uint32_t *found;        /**< the lists of the slice that is searched */
    size_t longest;                      /**< room of each */
    uint32_t counts[SPH2D__LANES], most; /**< their lengths, and the largest */
    sph2d__cursor fluid, walls, images;
    bool full;
} sph2d__pairs;

static inline sph2d__pairs sph2d__pairs_start(const sph2d__neighbours *n, size_t k)
{
    size_t room = n->each * SPH2D__SLAB, longest = sph2d__neighbours_longest(n);
    return (sph2d__pairs){.next = k * room,
                          .end = (k + 1) * room,
                          .found = n->found + k * longest * SPH2D__WIDEST,
                          .longest = longest,
                          .fluid = SPH2D__CURSOR_START,
                          .walls = SPH2D__CURSOR_START,
                          .images = SPH2D__CURSOR_START};
}

/** Begins empty lists. */
SPH2D__INLINE void sph2d__pairs_none(sph2d__pairs *to)
{
    memset(to->counts, 0, sizeof to->counts);
    to->most = 0;
}

/** Adds a neighbour of a lane's particle. */
SPH2D__INLINE void sph2d__pairs_put(sph2d__pairs *to, size_t lane, uint32_t j)
{
    to->found[lane * to->longest + to->counts[lane]++] = j;
    to->most = to->counts[lane] > to->most ? to->counts[lane] : to->most;
}

/** Lists the particles nearer than the support around (x, y), but particle `but`. */
SPH2D__INLINE void sph2d__pairs_of(sph2d__pairs *to, int lane, const sph2d__store *from, const sph2d__ranges *ranges,
                                   double x, double y, double support2, size_t but)
{
    uint32_t *found = to->found + (size_t)lane * to->longest, *next = found;
    const uint32_t *last = found + to->longest - SPH2D__LANES; /* blocks are written whole */
    SPH2D__FOR_BLOCKS (ranges, r, j, left) {
        sph2d__lanes dx = x + ranges->x[r] - sph2d__lanes_load(from->x + j);
        sph2d__lanes dy = y + ranges->y[r] - sph2d__lanes_load(from->y + j);
        unsigned near = sph2d__lanes_which(dx * dx + dy * dy, support2);
        if (left < SPH2D__LANES)
            near &= (1u << (int)left) - 1;
        if (but - j < SPH2D__LANES)
            near &= ~(1u << (but - j));
        if (next > last) {
            to->full = true;
            break;
        }
        sph2d__lanes_pack_index(next, (uint32_t)j, near);
        next += (size_t)__builtin_popcount(near);
    }
    uint32_t count = (uint32_t)(next - found);
    to->counts[lane] = count;
    to->most = count > to->most ? count : to->most;
}

/** Lists the neighbours in one store of particles `first` on of another, or of the same one (`own`). */
SPH2D__INLINE void sph2d__pairs_search(sph2d__pairs *to, sph2d__cursor *cursor, const sph2d__cells *cells,
                                       const sph2d__store *from, const sph2d__store *of, size_t first, double support2,
                                       bool own, const double *filled)
{
    to->most = 0;
    for (int l = 0; l < SPH2D__LANES; ++l) {
        size_t i = first + (size_t)l;
        to->counts[l] = 0;
        if (i < of->count && (!filled || filled[i] > 0) && sph2d__cursor_move(cursor, cells, of->x[i], of->y[i]))
            sph2d__pairs_of(to, l, from, &cursor->ranges, of->x[i], of->y[i], support2, own ? i : SIZE_MAX);
    }
}

/** Writes the lists as slots; `far` stands where a list is at its end. Returns how many. */
SPH2D__INLINE uint32_t sph2d__pairs_write(sph2d__neighbours *n, sph2d__pairs *to, size_t far)
{
    uint32_t *index = n->index + to->next;
    if (to->end - to->next < (size_t)to->most * SPH2D__LANES)
        to->full = true;
    if (to->full)
        return 0;
    for (int l = 0; l < SPH2D__LANES; ++l)
        for (uint32_t k = to->counts[l]; k < to->most; ++k)
            to->found[(size_t)l * to->longest + k] = (uint32_t)far;
    for (uint32_t k = 0; k < to->most; ++k)
        for (int l = 0; l < SPH2D__LANES; ++l)
            index[k * SPH2D__LANES + (uint32_t)l] = to->found[(size_t)l * to->longest + k];
    to->next += (size_t)to->most * SPH2D__LANES;
    return to->most;
}

#endif
