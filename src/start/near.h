/* SPDX-License-Identifier: MIT */
/** @file near.h
 *  Whether a position is near to one of many points, and which. */
#ifndef SPH2D_START_NEAR_H
#define SPH2D_START_NEAR_H

#include "base/memory.h"
#include "sph2d/scene.h"

/** Points in hashed buckets as wide as the distance that counts, which need no bounds of the area that they cover. */
typedef struct sph2d__near {
    double distance;    /**< [m] */
    size_t count;       /**< points */
    size_t slots;       /**< of the hash, a power of two */
    uint32_t *end;      /**< of each slot: behind its last point; it begins where the slot before ends */
    sph2d_vec2 *points; /**< copies, sorted by slots */
    uint32_t *index;    /**< of each as it was given */
} sph2d__near;

/** Sorts `count` points into buckets. False when memory is short. */
bool sph2d__near_build(sph2d__near *near, const double *x, const double *y, size_t count, double distance,
                       sph2d__memory *memory);
/** Whether a point is less than the distance from a position. */
bool sph2d__near_any(const sph2d__near *near, sph2d_vec2 position);
/** Visits the points less than the distance from a position, each once and always in the same order: their index, and
 *  where they are from the position. */
void sph2d__near_each(const sph2d__near *near, sph2d_vec2 position,
                      void (*visit)(void *with, uint32_t index, double x, double y), void *with);
void sph2d__near_free(sph2d__near *near, sph2d__memory *memory);

#endif
