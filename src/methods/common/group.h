/* SPDX-License-Identifier: MIT */
/** @file group.h
 *  The traversal of pair loops: a group of particles of one row at a time, one in each lane, and the candidates around
 *  all of them one by one.
 *
 *  A candidate is loaded once for all lanes, and no sum is reduced over lanes at the end; the price is that a candidate
 *  contributes nothing to lanes that it is too far from. On a lattice with H/dx = 2.6 the loop visits 13 candidates per
 *  particle with 4 lanes, 8 with 8 and 5.5 with 16, where 21 are neighbours. A quarter of them is farther than H from
 *  the box around the group: loops with expensive pair terms filter them first (tests/bench/README.md).
 *
 *  Each lane sums in memory order, so that doubles have the same bits for any number of lanes. Lanes after the last
 *  particle hold whatever follows in memory (arrays are padded); their sums are discarded. */
#ifndef SPH2D_METHODS_COMMON_GROUP_H
#define SPH2D_METHODS_COMMON_GROUP_H

#include <math.h>

#include "particles/cells.h"
#include "simd/lanes.h"

/** How a store's particles are grouped. */
typedef struct sph2d__grouping {
    const sph2d__store *store;
    const sph2d__cells *cells, *other; /**< the store's own, and those of the other store that is searched; or NULL */
    uint32_t columns;                  /**< most columns between the first particle of a group and the last */
    double width, height;              /**< largest box of a group of several particles, set by `other` [m] */
} sph2d__grouping;

/** A group: particles first to first + count - 1, their cells and, if there are other cells, their bounding box. */
typedef struct sph2d__group {
    size_t first;
    int count;
    sph2d__patch patch;
    double low_x, low_y, high_x, high_y;
} sph2d__group;

/* Largest width of a group in support radii: in spray particles are far apart. */
enum { SPH2D__GROUP_WIDTH = 4 };

/** The columns that a group may span after its first without its neighbourhood overlapping itself across the period;
 *  one is kept for rounding at the end of the period. */
static inline uint32_t sph2d__spare_columns(const sph2d__cells *cells)
{
    uint32_t spare = cells->nx - 2 * SPH2D__RIM * cells->columns - (2 * cells->columns + 1);
    return spare > 0 ? spare - 1 : 0;
}

/** The grouping of a store's particles, in `own` cells, whose neighbours are in their own and in `other` cells. */
static inline sph2d__grouping sph2d__grouping_of(const sph2d__store *store, const sph2d__cells *own,
                                                 const sph2d__cells *other)
{
    sph2d__grouping by = {store, own, other, SPH2D__GROUP_WIDTH * own->columns, INFINITY, INFINITY};
    if (own->period.length_x > 0 && sph2d__spare_columns(own) < by.columns)
        by.columns = sph2d__spare_columns(own);
    if (other && (other->width != own->width || other->height != own->height)) {
        by.height = other->height; /* so that a group covers two rows at most, and one more on either side */
        if (own->period.length_x > 0)
            by.width = (sph2d__spare_columns(other) - 1.0) * other->width;
    }
    /* In a period of three rows the neighbourhood of two rows would overlap itself. */
    if (other && own->period.length_y > 0 && other->ny - 2 * SPH2D__RIM < 4)
        by.height = 0;
    return by;
}

/** Sets the bounding box of a group. */
static inline void sph2d__group_box(const sph2d__store *store, sph2d__group *g)
{
    SPH2D__ARRAY const double *x = store->x + g->first, *y = store->y + g->first;
    double low_x = x[0], low_y = y[0], high_x = x[0], high_y = y[0];
    for (int l = 1; l < g->count; ++l) {
        low_x = x[l] < low_x ? x[l] : low_x;
        low_y = y[l] < low_y ? y[l] : low_y;
        high_x = x[l] > high_x ? x[l] : high_x;
        high_y = y[l] > high_y ? y[l] : high_y;
    }
    g->low_x = low_x;
    g->low_y = low_y;
    g->high_x = high_x;
    g->high_y = high_y;
}

/** The group that starts at particle i and ends before particle `last`. Not inlined: there is a copy of the loops for
 *  each set of terms, and compilers would inline it into some of them. */
SPH2D__OUTLINE sph2d__group sph2d__group_at(const sph2d__grouping *by, size_t i, size_t last)
{
    const sph2d__cells *c = by->cells;
    uint32_t cell = c->cell[c->order[i]], row = cell / c->nx, next = cell + by->columns + 1;
    size_t end = c->start[next < (row + 1) * c->nx ? next : (row + 1) * c->nx];
    end = end < last ? end : last;
    end = end < i + SPH2D__LANES ? end : i + SPH2D__LANES;
    sph2d__group g = {.first = i, .count = (int)(end - i)};
    if (by->other)
        for (sph2d__group_box(by->store, &g);
             g.count > 1 && (g.high_y - g.low_y > by->height || g.high_x - g.low_x > by->width);
             sph2d__group_box(by->store, &g))
            g.count /= 2;
    uint32_t right = c->cell[c->order[i + (size_t)g.count - 1]] - row * c->nx;
    g.patch = (sph2d__patch){cell - row * c->nx, right, row, row};
    return g;
}

/** The particles in the cells of a patch and around it. */
SPH2D__OUTLINE void sph2d__patch_ranges(const sph2d__cells *cells, const sph2d__patch *p, sph2d__ranges *to)
{
#ifdef SPH2D__MIXED
    const bool tiled = true;
#else
    const bool tiled = false;
#endif
    uint32_t reach = cells->columns, first = p->left - reach, last = p->right + reach;
    bool periodic = cells->period.length_x > 0 || cells->period.length_y > 0;
    if (periodic || (tiled && first / SPH2D__TILE != last / SPH2D__TILE)) {
        sph2d__cells_around(cells, p, tiled, to);
        return;
    }
    int count = 0;
    for (uint32_t row = p->bottom - 1; row <= p->top + 1; ++row) {
        SPH2D__ARRAY const uint32_t *start = cells->start + (size_t)row * cells->nx;
        if (start[first] == start[last + 1])
            continue;
        to->begin[count] = start[first];
        to->end[count] = start[last + 1];
        to->x[count] = tiled ? -sph2d__tile_x(cells, first) : 0;
        to->y[count] = tiled ? -sph2d__tile_y(cells, row) : 0;
        ++count;
    }
    to->count = count;
}

/** The candidates for a group in the other cells. False when there are none. */
static inline bool sph2d__group_others(const sph2d__grouping *by, const sph2d__group *g, sph2d__ranges *to)
{
    sph2d__patch patch;
    if (!by->other || !sph2d__cells_patch(by->other, g->low_x, g->low_y, g->high_x, g->high_y, &patch))
        return false;
    sph2d__patch_ranges(by->other, &patch, to);
    return to->count > 0;
}

/** Loads values of a group, one in each lane, plus an offset: for coordinates the image offset of a range. */
SPH2D__INLINE sph2d__lanes sph2d__group_lanes(SPH2D__ARRAY const double *from, double offset)
{
#ifdef SPH2D__MIXED
    sph2d__real moved[SPH2D__LANES];
    for (int l = 0; l < SPH2D__LANES; ++l)
        moved[l] = (sph2d__real)(from[l] + offset);
    return sph2d__lanes_load(moved);
#else
    return sph2d__lanes_load(from) + offset;
#endif
}

/* Candidates that are filtered at a time. */
enum { SPH2D__SIFTED = 256 };

/** Yields the candidates of a group within H of its bounding box, which must be set: 71 of 100 with 4 lanes, 77 with 8.
 *  With vectors of 16 bytes it yields all, since filtering costs as much as it saves. */
typedef struct sph2d__sieve {
    sph2d__real reach2;        /**< squared support radius, larger by more than rounding errors */
    int range;                 /**< the range to continue in */
    size_t next, count;        /**< the particle to continue with; the number of candidates found */
    double offset_x, offset_y; /**< image offset of the candidates [m] */
#ifdef __AVX__
    uint32_t index[SPH2D__SIFTED + SPH2D__PADDING]; /**< the candidates; written in whole blocks */
#else
    size_t first; /**< the first candidate */
#endif
} sph2d__sieve;

/** Starts with the candidates in `ranges`. */
static inline void sph2d__sieve_start(sph2d__sieve *sieve, const sph2d__ranges *ranges, double support)
{
    sieve->reach2 = (sph2d__real)(support * support * 1.0001);
    sieve->range = 0;
    sieve->next = ranges->count > 0 ? ranges->begin[0] : 0;
}

/** Finds the next candidates, whose positions are in `x` and `y`. False when there are none left. */
#ifdef __AVX__
SPH2D__INLINE bool sph2d__sift(sph2d__sieve *sieve, const sph2d__group *g, const sph2d__ranges *ranges,
                               SPH2D__ARRAY const sph2d__real *x, SPH2D__ARRAY const sph2d__real *y)
{
    int r = sieve->range;
    if (r >= ranges->count)
        return false;
    const double offset_x = ranges->x[r], offset_y = ranges->y[r];
    const sph2d__real low_x = (sph2d__real)(g->low_x + offset_x), high_x = (sph2d__real)(g->high_x + offset_x);
    const sph2d__real low_y = (sph2d__real)(g->low_y + offset_y), high_y = (sph2d__real)(g->high_y + offset_y);
    const sph2d__lanes zero = {0};
    size_t j = sieve->next, count = 0;
    do {
        const size_t space = SPH2D__SIFTED - count, end = ranges->end[r], stop = end - j > space ? j + space : end;
        for (; j < stop; j += SPH2D__LANES) {
            sph2d__lanes at_x = sph2d__lanes_load(x + j), at_y = sph2d__lanes_load(y + j);
            sph2d__lanes dx = sph2d__lanes_max(sph2d__lanes_max(low_x - at_x, at_x - high_x), zero);
            sph2d__lanes dy = sph2d__lanes_max(sph2d__lanes_max(low_y - at_y, at_y - high_y), zero);
            unsigned near = sph2d__lanes_which(dx * dx + dy * dy, (double)sieve->reach2);
            if (stop - j < SPH2D__LANES)
                near &= (1u << (stop - j)) - 1;
            sph2d__lanes_pack_index(sieve->index + count, (uint32_t)j, near);
            count += (size_t)__builtin_popcount(near);
        }
        j = stop;
        if (j < end)
            break;
        if (++r < ranges->count)
            j = ranges->begin[r];
    } while (r < ranges->count && ranges->x[r] == offset_x && ranges->y[r] == offset_y && count < SPH2D__SIFTED);
    sieve->range = r;
    sieve->next = j;
    sieve->count = count;
    sieve->offset_x = offset_x;
    sieve->offset_y = offset_y;
    return true;
}

/** Runs the statement that follows for each candidate `j` that was found. */
#define SPH2D__FOR_FOUND(sieve, j)                                                                                     \
    for (size_t k_##j = 0, j; k_##j < (sieve).count && (j = (sieve).index[k_##j], true); ++k_##j)
#else
SPH2D__INLINE bool sph2d__sift(sph2d__sieve *sieve, const sph2d__group *g, const sph2d__ranges *ranges,
                               SPH2D__ARRAY const sph2d__real *x, SPH2D__ARRAY const sph2d__real *y)
{
    (void)g;
    (void)x;
    (void)y;
    int r = sieve->range;
    if (r >= ranges->count)
        return false;
    sieve->first = ranges->begin[r];
    sieve->count = ranges->end[r] - ranges->begin[r];
    sieve->offset_x = ranges->x[r];
    sieve->offset_y = ranges->y[r];
    sieve->range = r + 1;
    return true;
}

#define SPH2D__FOR_FOUND(sieve, j) for (size_t j = (sieve).first; j < (sieve).first + (sieve).count; ++j)
#endif

/** Runs the statement that follows for each lane that has a particle. */
#define SPH2D__FOR_LANES(g, l) for (int l = 0; l < SPH2D__LANES && l < (g).count; ++l)

/** Runs the statement that follows for each group `g` of particles `from` to `last` - 1. */
#define SPH2D__FOR_GROUPS(by, g, from, last)                                                                           \
    for (size_t at_##g = (from); at_##g < (last);)                                                                     \
        for (sph2d__group g = sph2d__group_at(by, at_##g, last); at_##g == g.first; at_##g += (size_t)g.count)

#endif
