/* SPDX-License-Identifier: MIT */
/** @file pose.h
 *  The pose of a rigid body, and its rates. All uses of a moving obstacle's position go through these functions. */
#ifndef SPH2D_SCENE_POSE_H
#define SPH2D_SCENE_POSE_H

#include "sph2d/scene.h"

/** A pose and its rates. A body at rest in its initial position has all of them 0, and cosine 1. */
typedef struct sph2d__pose {
    sph2d_vec2 center;       /**< the point about which it turns, in the initial position [m] */
    sph2d_vec2 displacement; /**< of that point [m] */
    double angle;            /**< anticlockwise [rad], and its functions */
    double cosine, sine;
    sph2d_vec2 velocity;     /**< of the centre [m/s] */
    double omega;            /**< angular velocity [rad/s] */
    sph2d_vec2 acceleration; /**< of the centre [m/s^2]; 0 at the corners of a path */
    double alpha;            /**< angular acceleration [rad/s^2] */
} sph2d__pose;

/** A direction of the body, as it is now. */
static inline sph2d_vec2 sph2d__pose_turn(const sph2d__pose *pose, sph2d_vec2 v)
{
    return (sph2d_vec2){pose->cosine * v.x - pose->sine * v.y, pose->sine * v.x + pose->cosine * v.y};
}

/** A direction, as it is in the body's initial position. */
static inline sph2d_vec2 sph2d__pose_turn_back(const sph2d__pose *pose, sph2d_vec2 v)
{
    return (sph2d_vec2){pose->cosine * v.x + pose->sine * v.y, pose->cosine * v.y - pose->sine * v.x};
}

/** The position of a point of the body with initial position `point`. */
static inline sph2d_vec2 sph2d__pose_apply(const sph2d__pose *pose, sph2d_vec2 point)
{
    if (pose->angle == 0) /* without rounding by the centre */
        return (sph2d_vec2){point.x + pose->displacement.x, point.y + pose->displacement.y};
    sph2d_vec2 arm = sph2d__pose_turn(pose, (sph2d_vec2){point.x - pose->center.x, point.y - pose->center.y});
    return (sph2d_vec2){pose->center.x + pose->displacement.x + arm.x, pose->center.y + pose->displacement.y + arm.y};
}

/** From the centre, as it is now, to a position. */
static inline sph2d_vec2 sph2d__pose_arm(const sph2d__pose *pose, sph2d_vec2 at)
{
    return (sph2d_vec2){at.x - pose->center.x - pose->displacement.x, at.y - pose->center.y - pose->displacement.y};
}

/** The initial position of a point of the body that is at `point` now. */
static inline sph2d_vec2 sph2d__pose_invert(const sph2d__pose *pose, sph2d_vec2 point)
{
    if (pose->angle == 0)
        return (sph2d_vec2){point.x - pose->displacement.x, point.y - pose->displacement.y};
    sph2d_vec2 arm = sph2d__pose_turn_back(pose, sph2d__pose_arm(pose, point));
    return (sph2d_vec2){pose->center.x + arm.x, pose->center.y + arm.y};
}

/** The velocity of the body's point that is at a position now: V + omega x r. */
static inline sph2d_vec2 sph2d__pose_velocity(const sph2d__pose *pose, sph2d_vec2 at)
{
    sph2d_vec2 r = sph2d__pose_arm(pose, at);
    return (sph2d_vec2){pose->velocity.x - pose->omega * r.y, pose->velocity.y + pose->omega * r.x};
}

/** The acceleration of that point: A + alpha x r - omega^2 r. */
static inline sph2d_vec2 sph2d__pose_acceleration(const sph2d__pose *pose, sph2d_vec2 at)
{
    sph2d_vec2 r = sph2d__pose_arm(pose, at);
    double w2 = pose->omega * pose->omega;
    return (sph2d_vec2){pose->acceleration.x - pose->alpha * r.y - w2 * r.x,
                        pose->acceleration.y + pose->alpha * r.x - w2 * r.y};
}

#endif
