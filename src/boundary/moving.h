/* SPDX-License-Identifier: MIT */
/** @file moving.h
 *  A moving obstacle, or a body that the liquid moves: its boundary particles, their motion, and a barrier that moves with them.
 *
 *  A displacement is swept against the barrier in the frame of the obstacle, in which it is bent where the obstacle
 *  turns. It is swept as chords of that curve, each over a turn of at most SPH2D__LARGEST_TURN: by the chords a closed
 *  outline is as tight as one at rest, and they leave the curve by at most 1/8 LARGEST_TURN^2 of the distance from the
 *  centre of the turn. */
#ifndef SPH2D_BOUNDARY_MOVING_H
#define SPH2D_BOUNDARY_MOVING_H

#include "boundary/barrier.h"
#include "boundary/rigid.h"
#include "particles/period.h"
#include "particles/store.h"
#include "scene/motion.h"
#include "scene/world.h"

/** The largest turn of one chord [rad], and the largest number of chords. */
#define SPH2D__LARGEST_TURN 0.05

typedef struct sph2d__moving {
    sph2d__course course;      /**< of an obstacle with a motion */
    const sph2d__rigid *rigid; /**< a body, which the liquid moves; NULL: none */
    const sph2d__wall *wall;   /**< in its initial position */
    int number;                /**< of the wall (scene/world.h) */
    uint64_t first_id, end_id; /**< its boundary particles: first_id to end_id - 1 */
    sph2d_vec2 *normals;       /**< of these, in the initial position; NULL if they have none, or it never turns */
    double *spins;             /**< of these, their angular velocity [rad/s]; NULL if it never turns */
    sph2d__barrier barrier;    /**< in the obstacle's initial position */
    sph2d_box bounds;          /**< of the barrier */
    sph2d__pose from, to;      /**< at the start and end of the present or last drift */
    sph2d__drift drift;        /**< its poses in it, and the barrier */
    sph2d__pose *poses;        /**< room for these: SPH2D__MOST_CHORDS + 1 */
    double span;               /**< its length; negative in the stages of a scheme that moves back in time [s] */
    sph2d_box swept;           /**< around all that the barrier sweeps in it, with its clearance */
} sph2d__moving;

/** Keeps the normals of its boundary particles, of which the first is at `first`, once they are placed, and the bounds
 *  of its barrier. `normals` has room for them, or is NULL. */
void sph2d__moving_start(sph2d__moving *moving, const sph2d__store *walls, sph2d_vec2 *normals);

/** The pose at a time [s]; of a body at one of its present way. */
sph2d__pose sph2d__moving_at(const sph2d__moving *moving, double time);

/** Sets the time interval of the next drift [s]; it may go back in time. */
void sph2d__moving_set_drift(sph2d__moving *moving, double from, double to);

/** Sets position, velocity, acceleration and normal of its boundary particles at a time [s]; they are in the order of
 *  their ids. */
void sph2d__moving_place(const sph2d__moving *moving, double time, sph2d__store *walls, const sph2d__period *period);

/** Whether displacements that end between `low` and `high`, and are no longer than `distance` [m], are certainly out of
 *  its reach. */
bool sph2d__moving_far_from(const sph2d__moving *moving, sph2d_vec2 low, sph2d_vec2 high, double distance);

/** The largest displacement of a point of its barrier in the drift [m]. */
double sph2d__moving_shift(const sph2d__moving *moving);

/** Keeps a particle's displacement during the drift on its side of the obstacle, in the obstacle's frame (barrier.h).
 *  Returns the number of hits. */
int sph2d__moving_sweep(const sph2d__moving *moving, sph2d_vec2 from, sph2d_vec2 *to, sph2d_vec2 *v);

/** Whether the straight line between two positions crosses the obstacle at the end of the drift. */
bool sph2d__moving_crosses(const sph2d__moving *moving, sph2d_vec2 from, sph2d_vec2 to);

#endif
