/* SPDX-License-Identifier: MIT */
/** @file barrier.h
 *  The backstop: motion is swept against the walls' straight pieces, so that nothing passes a wall one particle thick,
 *  however fast it is. */
#ifndef SPH2D_BOUNDARY_BARRIER_H
#define SPH2D_BOUNDARY_BARRIER_H

#include <math.h>

#include "base/memory.h"
#include "scene/shape.h"

/** A straight piece of wall with what is asked of it in every step. */
typedef struct sph2d__piece {
    sph2d__segment ends;
    sph2d_vec2 direction; /**< from a to b, of length 1 */
    double length;        /**< [m] */
} sph2d__piece;

typedef struct sph2d__barrier {
    sph2d__piece *segments;
    size_t count, capacity;
    double clearance; /**< distance from a wall at which a particle is stopped [m] */
    /* A grid of buckets over the segments, each with the segments that come near it. */
    double origin_x, origin_y, inverse_size;
    int nx, ny;
    uint32_t *start;     /**< nx * ny + 1 values */
    uint32_t *items;     /**< segment indices */
    unsigned char *near; /**< whether a bucket or one of the 8 around it has a segment */
    size_t start_capacity, item_capacity;
} sph2d__barrier;

/** Adds a piece of wall. False when memory is short. */
bool sph2d__barrier_add(sph2d__barrier *barrier, sph2d__segment segment, sph2d__memory *memory);

/** Builds the buckets, `bucket` wide [m] or wider; call it once after the last add. False when memory is short. */
bool sph2d__barrier_build(sph2d__barrier *barrier, double bucket, double clearance, sph2d__memory *memory);

/** A row or column of buckets, clamped to the grid; NaN gives the first. */
static inline int sph2d__bucket_of(double place, double origin, double inverse_size, int n)
{
    double f = (place - origin) * inverse_size;
    f = f > 0 ? f : 0;
    return (int)(f < n - 1 ? f : n - 1);
}

/** Whether a motion stays so far from every wall that it need not be looked at: the usual case, and the only cheap one.
 */
static inline bool sph2d__barrier_far(const sph2d__barrier *b, sph2d_vec2 from, sph2d_vec2 to)
{
    if (b->count == 0)
        return true;
    double way = fabs(to.x - from.x) + fabs(to.y - from.y);
    int ix = sph2d__bucket_of(from.x, b->origin_x, b->inverse_size, b->nx);
    int iy = sph2d__bucket_of(from.y, b->origin_y, b->inverse_size, b->ny);
    return !b->near[(size_t)iy * (size_t)b->nx + (size_t)ix] && (way + b->clearance) * b->inverse_size < 1;
}

/** The same of all motions that end between `low` and `high` and go no farther than `way` [m]. */
bool sph2d__barrier_far_from(const sph2d__barrier *barrier, sph2d_vec2 low, sph2d_vec2 high, double way);

/** What sph2d__barrier_sweep does with a motion that is not far from every wall. */
int sph2d__barrier_hold(const sph2d__barrier *barrier, sph2d_vec2 from, sph2d_vec2 *to, sph2d_vec2 *v);

/** Holds a motion from `from` to *to with velocity *v on its side of every wall. On a hit the particle stops at the
 *  clearance, loses its velocity into the wall and slides along it; it never gains energy. Returns the number of hits.
 */
static inline int sph2d__barrier_sweep(const sph2d__barrier *barrier, sph2d_vec2 from, sph2d_vec2 *to, sph2d_vec2 *v)
{
    return sph2d__barrier_far(barrier, from, *to) ? 0 : sph2d__barrier_hold(barrier, from, to, v);
}

/** Whether the straight way between two places crosses a wall. */
bool sph2d__barrier_crosses(const sph2d__barrier *barrier, sph2d_vec2 from, sph2d_vec2 to);

void sph2d__barrier_free(sph2d__barrier *barrier, sph2d__memory *memory);

#endif
