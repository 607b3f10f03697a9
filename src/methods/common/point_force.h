/* SPDX-License-Identifier: MIT */
/** @file point_force.h
 *  Attraction to a point, or repulsion from it: acceleration * (1 - r/radius) towards it, zero from radius on and at
 *  the point itself. */
#ifndef SPH2D_METHODS_COMMON_POINT_FORCE_H
#define SPH2D_METHODS_COMMON_POINT_FORCE_H

#include <math.h>

typedef struct sph2d__point_force {
    double x, y;         /**< [m] */
    double radius;       /**< [m] */
    double acceleration; /**< the limit at the point [m/s^2]; positive attracts */
} sph2d__point_force;

static inline void sph2d__point_force_add(const sph2d__point_force *f, double x, double y, double *ax, double *ay)
{
    double dx = f->x - x, dy = f->y - y;
    double r = sqrt(dx * dx + dy * dy);
    if (!(r > 0 && r < f->radius))
        return;
    double scale = f->acceleration * (1 - r / f->radius) / r;
    *ax += scale * dx;
    *ay += scale * dy;
}

#endif
