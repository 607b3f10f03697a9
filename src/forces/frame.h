/* SPDX-License-Identifier: MIT */
/** @file frame.h
 *  The frame of a tank that moves, and gravity that changes: the accelerations that the liquid feels in the tank, in
 *  addition to the scene's constant gravity g0. It has no potential.
 *
 *  A tank displaced by d and turned by theta about its centre c sees, at r = x - c and with velocity v relative to it,
 *
 *      a = R(-theta) (g(t) - d'') - g0      gravity and the acceleration of the tank
 *        - theta'' z x r                    Euler
 *        + theta'^2 r                       centrifugal
 *        - 2 theta' z x v                   Coriolis
 *
 *  with z x (x, y) = (-y, x), z the axis out of the plane (Landau & Lifshitz, Mechanics, eq. 39.7). */
#ifndef SPH2D_FORCES_FRAME_H
#define SPH2D_FORCES_FRAME_H

#include "forces/place.h"
#include "sph2d/scene.h"

typedef struct sph2d__frame {
    bool moves;          /**< whether there is anything to add */
    sph2d_vec2 center;   /**< about which it turns [m] */
    sph2d_vec2 uniform;  /**< the acceleration at the centre [m/s^2] */
    double omega, alpha; /**< rate of turn [rad/s], and its rate [rad/s^2] */
} sph2d__frame;

/** At rest, until its course is known (scene/frame.h). */
static inline void sph2d__frame_set(sph2d__frame *f, const sph2d_scene *scene, double sound_speed)
{
    (void)scene, (void)sound_speed;
    *f = (sph2d__frame){.moves = false};
}

static inline bool sph2d__frame_acts(const sph2d__frame *f)
{
    return f->moves;
}

static inline void sph2d__frame_add(const sph2d__frame *f, sph2d__place at, double *ax, double *ay)
{
    double rx = at.x - f->center.x, ry = at.y - f->center.y, w2 = f->omega * f->omega;
    *ax += f->uniform.x + f->alpha * ry + w2 * rx + 2 * f->omega * at.vy;
    *ay += f->uniform.y - f->alpha * rx + w2 * ry - 2 * f->omega * at.vx;
}

static inline double sph2d__frame_potential(const sph2d__frame *f, double x, double y)
{
    (void)f, (void)x, (void)y;
    return 0;
}

static inline bool sph2d__frame_drives(const sph2d__frame *f)
{
    return f->moves;
}

static inline void sph2d__frame_drive(const sph2d__frame *f, sph2d__place at, double *ax, double *ay)
{
    sph2d__frame_add(f, at, ax, ay);
}

#endif
