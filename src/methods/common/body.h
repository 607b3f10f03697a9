/* SPDX-License-Identifier: MIT */
/** @file body.h
 *  Body forces on a particle: gravity, a central force, the frame of a tank, spring walls, point forces. */
#ifndef SPH2D_METHODS_COMMON_BODY_H
#define SPH2D_METHODS_COMMON_BODY_H

#include <stddef.h>

#include "boundary/spring_wall.h"
#include "methods/common/point_force.h"
#include "scene/frame.h"

typedef struct sph2d__body {
    double gravity_x, gravity_y; /**< [m/s^2] */
    double center_x, center_y;   /**< of the central force [m] */
    double central_rate2;        /**< B^2 in the acceleration -B^2 (x - center) [1/s^2] */
    sph2d__frame frame;          /**< of a tank that moves */
    sph2d__spring_walls springs;
    const sph2d__point_force *points; /**< those active at present */
    size_t point_count;
} sph2d__body;

/** Adds the accelerations [m/s^2] on a particle at (x, y) with velocity (vx, vy). */
static inline void sph2d__body_add(const sph2d__body *body, double x, double y, double vx, double vy, double *ax,
                                   double *ay)
{
    *ax += body->gravity_x - body->central_rate2 * (x - body->center_x);
    *ay += body->gravity_y - body->central_rate2 * (y - body->center_y);
    if (body->frame.moves)
        sph2d__frame_add(&body->frame, x, y, vx, vy, ax, ay);
    sph2d__spring_walls_add(&body->springs, x, y, vx, vy, ax, ay);
    for (size_t k = 0; k < body->point_count; ++k)
        sph2d__point_force_add(&body->points[k], x, y, ax, ay);
}

#endif
