/* SPDX-License-Identifier: MIT */
/** @file pose.h
 *  Where something rigid is that moves as a scene says, and how fast. Everything that follows a moving obstacle goes
 *  through the functions below, so that they alone know what a motion is made of: today of a displacement. */
#ifndef SPH2D_BOUNDARY_POSE_H
#define SPH2D_BOUNDARY_POSE_H

#include "sph2d/scene.h"

/** A pose, and its rates. All zero: as the scene places it, at rest. */
typedef struct sph2d__pose {
    sph2d_vec2 displacement; /**< from where the scene places it [m] */
    sph2d_vec2 velocity;     /**< [m/s] */
    sph2d_vec2 acceleration; /**< [m/s^2]; none in the corners of a path */
} sph2d__pose;

/** Whether a motion moves anything at any time. */
bool sph2d__motion_moves(const sph2d_motion *motion);

/** The pose at a time [s]: amplitude (sin(2 pi f t + phase) - sin(phase)), and on that the path. */
sph2d__pose sph2d__pose_at(const sph2d_motion *motion, double time);

/** Where a point is that the scene places at `point`. */
static inline sph2d_vec2 sph2d__pose_apply(const sph2d__pose *pose, sph2d_vec2 point)
{
    return (sph2d_vec2){point.x + pose->displacement.x, point.y + pose->displacement.y};
}

/** Where the scene places what is at `point` now. */
static inline sph2d_vec2 sph2d__pose_invert(const sph2d__pose *pose, sph2d_vec2 point)
{
    return (sph2d_vec2){point.x - pose->displacement.x, point.y - pose->displacement.y};
}

#endif
