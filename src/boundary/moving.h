/* SPDX-License-Identifier: MIT */
/** @file moving.h
 *  A moving obstacle: its boundary particles, their motion, and a barrier that moves with them. */
#ifndef SPH2D_BOUNDARY_MOVING_H
#define SPH2D_BOUNDARY_MOVING_H

#include "boundary/barrier.h"
#include "boundary/pose.h"
#include "particles/period.h"
#include "particles/store.h"

typedef struct sph2d__moving {
    const sph2d_motion *motion;
    int wall;                  /**< its number (scene/wall_names.h) */
    uint64_t first_id, end_id; /**< its boundary particles: first_id to end_id - 1 */
    sph2d__barrier barrier;    /**< in the obstacle's initial position */
    sph2d__pose from, to;      /**< at the start and end of the present or last drift */
    sph2d_vec2 velocity;       /**< mean over that drift [m/s] */
} sph2d__moving;

/** Sets the time interval of the next drift [s]; it may go back in time. */
void sph2d__moving_set_drift(sph2d__moving *moving, double from, double to);

/** Sets position, velocity and acceleration of its boundary particles at a time [s]. */
void sph2d__moving_place(const sph2d__moving *moving, double time, sph2d__store *walls, const sph2d__period *period);

/** Keeps a particle's displacement during the drift on its side of the obstacle, in the obstacle's frame (barrier.h).
 *  Returns the number of hits. */
int sph2d__moving_sweep(const sph2d__moving *moving, sph2d_vec2 from, sph2d_vec2 *to, sph2d_vec2 *v);

/** Whether the straight line between two positions crosses the obstacle at the end of the drift. */
bool sph2d__moving_crosses(const sph2d__moving *moving, sph2d_vec2 from, sph2d_vec2 to);

#endif
