/* SPDX-License-Identifier: MIT */
/** @file pose.h
 *  The pose of a rigid body with prescribed motion. All uses of a moving obstacle's position go through these
 *  functions, so that only they depend on what a motion consists of: at present a displacement. */
#ifndef SPH2D_BOUNDARY_POSE_H
#define SPH2D_BOUNDARY_POSE_H

#include "sph2d/scene.h"

/** A pose and its rates. All zero: the initial position, at rest. */
typedef struct sph2d__pose {
    sph2d_vec2 displacement; /**< from the initial position [m] */
    sph2d_vec2 velocity;     /**< [m/s] */
    sph2d_vec2 acceleration; /**< [m/s^2]; 0 at the corners of a path */
} sph2d__pose;

/** Whether a motion ever moves. */
bool sph2d__motion_moves(const sph2d_motion *motion);

/** The pose at a time [s]: amplitude (sin(2 pi f t + phase) - sin(phase)), and on that the path. */
sph2d__pose sph2d__pose_at(const sph2d_motion *motion, double time);

/** The position of a point of the body with initial position `point`. */
static inline sph2d_vec2 sph2d__pose_apply(const sph2d__pose *pose, sph2d_vec2 point)
{
    return (sph2d_vec2){point.x + pose->displacement.x, point.y + pose->displacement.y};
}

/** The initial position of a point of the body that is at `point` now. */
static inline sph2d_vec2 sph2d__pose_invert(const sph2d__pose *pose, sph2d_vec2 point)
{
    return (sph2d_vec2){point.x - pose->displacement.x, point.y - pose->displacement.y};
}

#endif
