/* SPDX-License-Identifier: MIT */
/** @file frame.h
 *  The course of a tank that moves, and what it can do to the liquid (forces/frame.h). */
#ifndef SPH2D_SCENE_FRAME_H
#define SPH2D_SCENE_FRAME_H

#include "forces/frame.h"
#include "scene/motion.h"

/** Whether a scene's tank moves, or its gravity changes. */
bool sph2d__scene_is_driven(const sph2d_scene *scene);

/** The number of second derivatives that the tank's course needs: its path is cubic unless the scene says otherwise. */
size_t sph2d__tank_bends(const sph2d_scene *scene);
/** The course of the tank, about the centre of the domain unless the scene says otherwise. `bends` has room for those, or
 *  is NULL. */
sph2d__course sph2d__tank_course(const sph2d_scene *scene, sph2d_pose_point *bends);

/** The frame at a time [s]. */
sph2d__frame sph2d__frame_at(const sph2d_scene *scene, const sph2d__course *tank, double time);

/** What the drive of a scene can do to its liquid, however long its run: a run that goes on later is the same. */
typedef struct sph2d__drive {
    double gravity; /**< the largest gravity, with the acceleration of the tank's centre [m/s^2] */
    double tilt;    /**< the largest sine of the angle between that and g0; 1 beyond a right angle */
    double speed;   /**< the largest speed of the tank [m/s] */
} sph2d__drive;

/** For a scene that is not driven: |g0|, 0, 0. */
sph2d__drive sph2d__scene_drive(const sph2d_scene *scene);

#endif
