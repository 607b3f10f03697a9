/* SPDX-License-Identifier: MIT */
/** @file device_data.h
 *  What the host and the kernels of all methods hand each other. Pointers in it are offsets of blocks (device/device.h) on their way. */
#ifndef SPH2D_SIM_DEVICE_DATA_H
#define SPH2D_SIM_DEVICE_DATA_H

#include <math.h>

#include "sim/displaced.h"

/** Threads that share the cells when their particles are counted; a multiple of SPH2D__SLAB. */
enum { SPH2D__SCANNERS = 16384 };

/** Smallest and largest coordinates. */
typedef struct sph2d__bounds_of {
    double min_x, min_y, max_x, max_y;
} sph2d__bounds_of;

static inline sph2d__bounds_of sph2d__no_bounds(void)
{
    return (sph2d__bounds_of){INFINITY, INFINITY, -INFINITY, -INFINITY};
}

static inline sph2d__bounds_of sph2d__join_bounds(sph2d__bounds_of a, sph2d__bounds_of b)
{
    return (sph2d__bounds_of){a.min_x < b.min_x ? a.min_x : b.min_x, a.min_y < b.min_y ? a.min_y : b.min_y,
                              a.max_x > b.max_x ? a.max_x : b.max_x, a.max_y > b.max_y ? a.max_y : b.max_y};
}

/** Arrays that are put in order, from where they are to elsewhere. */
typedef struct sph2d__moved {
    uint64_t from, to;
} sph2d__moved;
typedef struct sph2d__reordered {
    uint64_t count;
    sph2d__moved arrays[SPH2D__STORE_COUNT + 2];
} sph2d__reordered;

/** What a wall did to a particle. */
typedef struct sph2d__contact {
    sph2d_vec2 at, change; /**< [m], [m/s] */
    double work;           /**< by a wall that moves [J/m] */
    int wall;
} sph2d__contact;

/** An advection without bodies and walls that reflect. */
typedef struct sph2d__advection {
    double dt, quantum;
    sph2d__barrier walls;
    uint64_t drifts;      /**< obstacles that move (sph2d__drift) ... */
    uint32_t drift_count; /**< ... so many */
    int holds;            /**< sph2d__method.walls_hold */
    uint64_t contacts,
        contact_count; /**< the list of contacts, and how many there are, which may be more than its room */
    uint32_t contact_room;
    int noted; /**< whether contacts are listed */
} sph2d__advection;

static inline void sph2d__add_events(sph2d__events *to, sph2d__events met)
{
    to->hits += met.hits;
    to->reflections += met.reflections;
    to->not_finite += met.not_finite;
    to->stopped += met.stopped;
    to->driven += met.driven;
    to->diffused += met.diffused;
    to->noted += met.noted;
}

#endif
