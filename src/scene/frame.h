/* SPDX-License-Identifier: MIT */
/** @file frame.h
 *  The frame of a tank that moves, and gravity that changes: the accelerations that the liquid feels in the tank, in
 *  addition to the scene's constant gravity g0.
 *
 *  A tank displaced by d and turned by theta about its centre c sees, at r = x - c and with velocity v relative to it,
 *
 *      a = R(-theta) (g(t) - d'') - g0      gravity and the acceleration of the tank
 *        - theta'' z x r                    Euler
 *        + theta'^2 r                       centrifugal
 *        - 2 theta' z x v                   Coriolis
 *
 *  with z x (x, y) = (-y, x), z the axis out of the plane (Landau & Lifshitz, Mechanics, eq. 39.7). */
#ifndef SPH2D_SCENE_FRAME_H
#define SPH2D_SCENE_FRAME_H

#include "scene/motion.h"

typedef struct sph2d__frame {
    bool moves;          /**< whether there is anything to add */
    sph2d_vec2 center;   /**< about which it turns [m] */
    sph2d_vec2 uniform;  /**< the acceleration at the centre [m/s^2] */
    double omega, alpha; /**< rate of turn [rad/s], and its rate [rad/s^2] */
} sph2d__frame;

/** Adds the accelerations at (x, y) for a velocity (vx, vy), both relative to the tank. */
static inline void sph2d__frame_add(const sph2d__frame *f, double x, double y, double vx, double vy, double *ax,
                                    double *ay)
{
    double rx = x - f->center.x, ry = y - f->center.y, w2 = f->omega * f->omega;
    *ax += f->uniform.x + f->alpha * ry + w2 * rx + 2 * f->omega * vy;
    *ay += f->uniform.y - f->alpha * rx + w2 * ry - 2 * f->omega * vx;
}

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
