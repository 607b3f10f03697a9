/* SPDX-License-Identifier: MIT */
/** @file moving.h
 *  An obstacle that moves: which boundary particles are its own, where they go, and a backstop that goes with them. */
#ifndef SPH2D_BOUNDARY_MOVING_H
#define SPH2D_BOUNDARY_MOVING_H

#include "boundary/barrier.h"
#include "boundary/pose.h"
#include "particles/period.h"
#include "particles/store.h"

typedef struct sph2d__moving {
    const sph2d_motion *motion;
    uint64_t first_id, end_id; /**< its boundary particles: first_id to end_id - 1 */
    sph2d__barrier barrier;    /**< where the scene places it */
    sph2d__pose from, to;      /**< at the start and end of the drift that is being made, or was last */
    sph2d_vec2 velocity;       /**< mean over that drift [m/s] */
} sph2d__moving;

/** Sets the drift that comes next, from one time to another [s]; it may go back. */
void sph2d__moving_set_drift(sph2d__moving *moving, double from, double to);

/** Puts its boundary particles to where they are at a time [s], with their velocity and acceleration. */
void sph2d__moving_place(const sph2d__moving *moving, double time, sph2d__store *walls, const sph2d__period *period);

/** Holds a particle's motion over the drift on its side of it (barrier.h): swept where it is at rest. Returns the
 *  number of hits. */
int sph2d__moving_sweep(const sph2d__moving *moving, sph2d_vec2 from, sph2d_vec2 *to, sph2d_vec2 *v);

/** Whether the straight way between two places crosses it where it is at the end of the drift. */
bool sph2d__moving_crosses(const sph2d__moving *moving, sph2d_vec2 from, sph2d_vec2 to);

#endif
