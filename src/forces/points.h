/* SPDX-License-Identifier: MIT */
/** @file points.h
 *  Attraction to points, or repulsion from them, interactions and the pointer: acceleration * (1 - r/radius) towards a
 *  point, zero from radius on and at the point itself. They come, move and go, so that their work is external. */
#ifndef SPH2D_FORCES_POINTS_H
#define SPH2D_FORCES_POINTS_H

#include <math.h>
#include <stddef.h>

#include "base/address.h"
#include "forces/place.h"
#include "sph2d/scene.h"

typedef struct sph2d__point_force {
    double x, y;         /**< [m] */
    double radius;       /**< [m] */
    double acceleration; /**< the limit at the point [m/s^2]; positive attracts */
} sph2d__point_force;

typedef struct sph2d__points {
    SPH2D__ARRAY const sph2d__point_force *items; /**< those active at present: sim/forcing.c */
    size_t count;
} sph2d__points;

/** None, until a time is set. */
static inline void sph2d__points_set(sph2d__points *p, const sph2d_scene *scene, double sound_speed)
{
    (void)scene, (void)sound_speed;
    *p = (sph2d__points){NULL, 0};
}

static inline bool sph2d__points_acts(const sph2d__points *p)
{
    return p->count > 0;
}

static inline void sph2d__points_add(const sph2d__points *p, sph2d__place at, double *ax, double *ay)
{
    for (size_t k = 0; k < p->count; ++k) {
        SPH2D__ARRAY const sph2d__point_force *f = &p->items[k];
        const double dx = f->x - at.x, dy = f->y - at.y, r = sqrt(dx * dx + dy * dy);
        if (!(r > 0 && r < f->radius))
            continue;
        const double scale = f->acceleration * (1 - r / f->radius) / r;
        *ax += scale * dx;
        *ay += scale * dy;
    }
}

static inline double sph2d__points_potential(const sph2d__points *p, double x, double y)
{
    (void)p, (void)x, (void)y;
    return 0;
}

static inline bool sph2d__points_drives(const sph2d__points *p)
{
    return p->count > 0;
}

static inline void sph2d__points_drive(const sph2d__points *p, sph2d__place at, double *ax, double *ay)
{
    sph2d__points_add(p, at, ax, ay);
}

#endif
