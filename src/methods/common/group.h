/* SPDX-License-Identifier: MIT */
/** @file group.h
 *  The traversal of pair loops: some particles of one row at a time, one in each lane, and the particles around all of
 *  them one by one.
 *
 *  What is read of a candidate serves every lane, and no sum must be added up over lanes in the end; the price is that
 *  candidates of the group's other particles count as nothing for most lanes. On a lattice of H/dx = 2.6 a particle
 *  goes through 13 candidates at 4 lanes, 8 at 8 and 5.5 at 16, where 21 are neighbours. A quarter of them is not
 *  near the box around the group: loops that do much with a pair sift them first (tests/bench/README.md).
 *
 *  Each lane sums in the order of memory, so that doubles have the same bits whatever the number of lanes. Lanes behind
 *  the last particle hold whatever follows in memory (arrays are padded); what they sum up is not kept. */
#ifndef SPH2D_METHODS_COMMON_GROUP_H
#define SPH2D_METHODS_COMMON_GROUP_H

#include <math.h>

#include "particles/cells.h"
#include "simd/lanes.h"

/** How a store's particles are grouped. */
typedef struct sph2d__grouping {
    const sph2d__store *store;
    const sph2d__cells *cells, *other; /**< the store's, and others' in which particles near a group are; or NULL */
    uint32_t columns;                  /**< that the last particle of a group may be away from the first */
    double width, height;              /**< a group of several particles is no larger: other cells ask for that [m] */
} sph2d__grouping;

/** A group: particles first to first + count - 1, the cells in which they are and, where there are others, the box. */
typedef struct sph2d__group {
    size_t first;
    int count;
    sph2d__patch patch;
    double low_x, low_y, high_x, high_y;
} sph2d__group;

/* A group is no wider than this many support radii: in spray its particles are far apart. */
enum { SPH2D__GROUP_WIDTH = 4 };

/** Columns of the period that a group may take beside its first so that what is around it does not meet itself; one is
 *  kept for rounding at the period's end. */
static inline uint32_t sph2d__spare_columns(const sph2d__cells *cells)
{
    uint32_t spare = cells->nx - 2 * SPH2D__RIM * cells->columns - (2 * cells->columns + 1);
    return spare > 0 ? spare - 1 : 0;
}

/** The grouping of a store's particles, in `own` cells, that meet others in their own and in `other` cells. */
static inline sph2d__grouping sph2d__grouping_of(const sph2d__store *store, const sph2d__cells *own,
                                                 const sph2d__cells *other)
{
    sph2d__grouping by = {store, own, other, SPH2D__GROUP_WIDTH * own->columns, INFINITY, INFINITY};
    if (own->period.length_x > 0 && sph2d__spare_columns(own) < by.columns)
        by.columns = sph2d__spare_columns(own);
    if (other && (other->width != own->width || other->height != own->height)) {
        by.height = other->height; /* two rows, then, and one on either side */
        if (own->period.length_x > 0)
            by.width = (sph2d__spare_columns(other) - 1.0) * other->width;
    }
    /* In a period of three rows those around two would meet themselves. */
    if (other && own->period.length_y > 0 && other->ny - 2 * SPH2D__RIM < 4)
        by.height = 0;
    return by;
}

/** Lays the box around a group. */
static inline void sph2d__group_box(const sph2d__store *store, sph2d__group *g)
{
    const double *x = store->x + g->first, *y = store->y + g->first;
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

/** The group that begins with particle i, before particle `last`. Called, as there is a copy of the loops for each set
 *  of terms: compilers would put it into some of them. */
static __attribute__((noinline, unused)) sph2d__group sph2d__group_at(const sph2d__grouping *by, size_t i, size_t last)
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

/** The particles of the cells of a patch and around it. */
static __attribute__((noinline, unused)) void sph2d__patch_ranges(const sph2d__cells *cells, const sph2d__patch *p,
                                                                  sph2d__ranges *to)
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
        const uint32_t *start = cells->start + (size_t)row * cells->nx;
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

/** The particles of the other cells that may be near a group. False when there are none. */
static inline bool sph2d__group_near(const sph2d__grouping *by, const sph2d__group *g, sph2d__ranges *to)
{
    sph2d__patch patch;
    if (!by->other || !sph2d__cells_patch(by->other, g->low_x, g->low_y, g->high_x, g->high_y, &patch))
        return false;
    sph2d__patch_ranges(by->other, &patch, to);
    return to->count > 0;
}

/** Coordinates of a group in the lanes, moved by the way that belongs to a range. */
SPH2D__INLINE sph2d__lanes sph2d__group_lanes(const double *from, double way)
{
#ifdef SPH2D__MIXED
    sph2d__real moved[SPH2D__LANES];
    for (int l = 0; l < SPH2D__LANES; ++l)
        moved[l] = (sph2d__real)(from[l] + way);
    return sph2d__lanes_load(moved);
#else
    return sph2d__lanes_load(from) + way;
#endif
}

/* Candidates that are sifted at a time. */
enum { SPH2D__SIFTED = 256 };

/** Hands out the candidates of a group that are near the box around it, which must have been laid: 71 of 100
 *  at 4 lanes, 77 at 8. Where vectors are of 16 bytes it hands out all, as sifting takes as long as it saves. */
typedef struct sph2d__sieve {
    sph2d__real reach2;        /**< more than the squared support radius, by more than rounding */
    int range;                 /**< where to go on, in this range */
    size_t next, count;        /**< with this particle; candidates found */
    double offset_x, offset_y; /**< the way that belongs to them [m] */
#ifdef __AVX__
    uint32_t index[SPH2D__SIFTED + SPH2D__PADDING]; /**< blocks are written whole */
#else
    size_t first; /**< the first one found */
#endif
} sph2d__sieve;

/** Begins with the candidates in some ranges. */
static inline void sph2d__sieve_start(sph2d__sieve *sieve, const sph2d__ranges *ranges, double support)
{
    sieve->reach2 = (sph2d__real)(support * support * 1.0001);
    sieve->range = 0;
    sieve->next = ranges->count > 0 ? ranges->begin[0] : 0;
}

/** Finds more candidates, of those at `x` and `y`. False when there are none left. */
#ifdef __AVX__
SPH2D__INLINE bool sph2d__sift(sph2d__sieve *sieve, const sph2d__group *g, const sph2d__ranges *ranges,
                               const sph2d__real *x, const sph2d__real *y)
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
        const size_t room = SPH2D__SIFTED - count, end = ranges->end[r], stop = end - j > room ? j + room : end;
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

/** Runs the statement behind it for each candidate `j` that was found. */
#define SPH2D__FOR_FOUND(sieve, j)                                                                                     \
    for (size_t k_##j = 0, j; k_##j < (sieve).count && (j = (sieve).index[k_##j], true); ++k_##j)
#else
SPH2D__INLINE bool sph2d__sift(sph2d__sieve *sieve, const sph2d__group *g, const sph2d__ranges *ranges,
                               const sph2d__real *x, const sph2d__real *y)
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

/** Runs the statement behind it for each lane that has a particle. */
#define SPH2D__FOR_LANES(g, l) for (int l = 0; l < SPH2D__LANES && l < (g).count; ++l)

/** Runs the statement behind it for each group `g` of particles `from` to `last` - 1. */
#define SPH2D__FOR_GROUPS(by, g, from, last)                                                                           \
    for (size_t at_##g = (from); at_##g < (last);)                                                                     \
        for (sph2d__group g = sph2d__group_at(by, at_##g, last); at_##g == g.first; at_##g += (size_t)g.count)

#endif
