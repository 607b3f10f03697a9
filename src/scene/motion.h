/* SPDX-License-Identifier: MIT */
/** @file motion.h
 *  Prescribed motions: paths, oscillations and turning, as functions of time (sph2d_motion). */
#ifndef SPH2D_SCENE_MOTION_H
#define SPH2D_SCENE_MOTION_H

#include "scene/pose.h"
#include "sph2d/scene.h"

/** A motion, and what it takes to evaluate it. */
typedef struct sph2d__course {
    const sph2d_motion *motion;
    sph2d_vec2 center;       /**< about which it turns, in the initial position [m] */
    sph2d_pose_point *bends; /**< at each point of a cubic path: second derivatives; NULL: straight lines */
} sph2d__course;

/** Whether a motion ever moves. */
bool sph2d__motion_moves(const sph2d_motion *motion);

/** Whether it ever turns. */
bool sph2d__motion_turns(const sph2d_motion *motion);

/** The lowest and the highest frequency of its oscillations [1/s]; both 0 without any. */
typedef struct sph2d__frequencies {
    double lowest, highest;
} sph2d__frequencies;
sph2d__frequencies sph2d__motion_frequencies(const sph2d_motion *motion);

/** The number of second derivatives that its course needs; 0 with straight lines. */
size_t sph2d__motion_bends(const sph2d_motion *motion);

/** Its course, for an obstacle with an outline; `bends` has room for those, or is NULL for straight lines. */
sph2d__course sph2d__course_of(const sph2d_motion *motion, const sph2d_shape *outline, sph2d_pose_point *bends);

/** The pose at a time [s]. */
sph2d__pose sph2d__course_at(const sph2d__course *course, double time);

/** The displacement and angle of its path alone, of which there is a point. */
sph2d_pose_point sph2d__course_path_at(const sph2d__course *course, double time);

/** A bound of the speed of all points within a distance of the centre, which one kind of motion alone reaches [m/s]. */
double sph2d__course_speed(const sph2d__course *course, double distance);

#endif
