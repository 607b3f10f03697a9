/* SPDX-License-Identifier: MIT */
/** @file barrier.h
 *  Continuous collision: displacements are swept against the walls' line segments, so that no particle passes a wall
 *  one particle thick at any speed. */
#ifndef SPH2D_BOUNDARY_BARRIER_H
#define SPH2D_BOUNDARY_BARRIER_H

#include <math.h>

#include "base/address.h"
#include "base/memory.h"
#include "scene/pose.h"
#include "scene/shape.h"

/* A particle in a corner slides along one wall and meets the next; after so many hits it stays where it was. */
enum { SPH2D__MAX_STOPS = 4 };

/** A wall segment with its precomputed direction and length. */
typedef struct sph2d__piece {
    sph2d__segment ends;
    sph2d_vec2 direction; /**< from a to b, of length 1 */
    double length;        /**< [m] */
    int wall;             /**< the wall that it is a piece of (scene/world.h) */
} sph2d__piece;

/** What the hits of a displacement did to the velocity. */
typedef struct sph2d__stops {
    int count;
    struct {
        int wall;
        sph2d_vec2 change; /**< [m/s] */
    } items[SPH2D__MAX_STOPS];
} sph2d__stops;

typedef struct sph2d__barrier {
    SPH2D__ARRAY sph2d__piece *segments;
    size_t count, capacity;
    int wall;         /**< that segments are added to now */
    double clearance; /**< distance from a wall at which a particle is stopped [m] */
    /* A grid of buckets over the segments; each lists the segments near it. */
    double origin_x, origin_y, inverse_size;
    int nx, ny;
    SPH2D__ARRAY uint32_t *start;     /**< nx * ny + 1 values */
    SPH2D__ARRAY uint32_t *items;     /**< segment indices */
    SPH2D__ARRAY unsigned char *near; /**< whether a bucket or one of the 8 around it has a segment */
    size_t start_capacity, item_capacity;
} sph2d__barrier;

/** Adds a wall segment. False when memory is short. */
bool sph2d__barrier_add(sph2d__barrier *barrier, sph2d__segment segment, sph2d__memory *memory);

/** Builds the buckets, `bucket` wide [m] or wider; call it once after the last add. False when memory is short. */
bool sph2d__barrier_build(sph2d__barrier *barrier, double bucket, double clearance, sph2d__memory *memory);

/** Row or column of a coordinate's bucket, clamped to the grid; NaN gives the first. */
static inline int sph2d__bucket_of(double position, double origin, double inverse_size, int n)
{
    double f = (position - origin) * inverse_size;
    f = f > 0 ? f : 0;
    return (int)(f < n - 1 ? f : n - 1);
}

/** Whether a displacement is certainly out of reach of all walls: the usual case, and the only cheap one. */
static inline bool sph2d__barrier_far(const sph2d__barrier *b, sph2d_vec2 from, sph2d_vec2 to)
{
    if (b->count == 0)
        return true;
    double distance = fabs(to.x - from.x) + fabs(to.y - from.y);
    int ix = sph2d__bucket_of(from.x, b->origin_x, b->inverse_size, b->nx);
    int iy = sph2d__bucket_of(from.y, b->origin_y, b->inverse_size, b->ny);
    return !b->near[(size_t)iy * (size_t)b->nx + (size_t)ix] && (distance + b->clearance) * b->inverse_size < 1;
}

/** The same for all displacements that end between `low` and `high` and are no longer than `distance` [m]. */
bool sph2d__barrier_far_from(const sph2d__barrier *barrier, sph2d_vec2 low, sph2d_vec2 high, double distance);

/** sph2d__barrier_sweep for a displacement that may reach a wall. */
int sph2d__barrier_resolve(const sph2d__barrier *barrier, sph2d_vec2 from, sph2d_vec2 *to, sph2d_vec2 *v,
                           sph2d__stops *stops);

/** Keeps a displacement from `from` to *to with velocity *v on its side of every wall. On a hit the particle stops at
 *  the clearance, loses its normal velocity and slides along the wall; it never gains kinetic energy. Returns the
 *  number of hits, and writes them to `stops` unless that is NULL. */
static inline int sph2d__barrier_sweep(const sph2d__barrier *barrier, sph2d_vec2 from, sph2d_vec2 *to, sph2d_vec2 *v,
                                       sph2d__stops *stops)
{
    return sph2d__barrier_far(barrier, from, *to) ? 0 : sph2d__barrier_resolve(barrier, from, to, v, stops);
}

/** The way of a barrier that moves: it is straight from pose to pose, of which there are chords + 1. */
enum { SPH2D__MOST_CHORDS = 64 };
typedef struct sph2d__drift {
    SPH2D__ARRAY const sph2d__pose *poses;
    int chords;
    int wall; /**< its number (scene/world.h) */
    sph2d__barrier barrier;
} sph2d__drift;

/** Keeps a displacement on its side of a barrier that moves, in its frame. Returns the number of hits. */
int sph2d__drift_sweep(const sph2d__drift *drift, sph2d_vec2 from, sph2d_vec2 *to, sph2d_vec2 *v);

/** Whether the straight line between two positions crosses a wall. */
bool sph2d__barrier_crosses(const sph2d__barrier *barrier, sph2d_vec2 from, sph2d_vec2 to);

void sph2d__barrier_free(sph2d__barrier *barrier, sph2d__memory *memory);

#endif
