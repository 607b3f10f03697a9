/* SPDX-License-Identifier: MIT */
/** @file central.h
 *  A force towards a centre, -B^2 (x - centre), with the potential B^2 (x - centre)^2/2. */
#ifndef SPH2D_FORCES_CENTRAL_H
#define SPH2D_FORCES_CENTRAL_H

#include "forces/place.h"
#include "sph2d/scene.h"

typedef struct sph2d__central {
    double x, y;  /**< the centre [m] */
    double rate2; /**< B^2 [1/s^2] */
} sph2d__central;

static inline void sph2d__central_set(sph2d__central *c, const sph2d_scene *scene, double sound_speed)
{
    (void)sound_speed;
    const sph2d_central_force *f = &scene->central_force;
    *c = (sph2d__central){f->center.x, f->center.y, f->rate * f->rate};
}

static inline bool sph2d__central_acts(const sph2d__central *c)
{
    return c->rate2 != 0;
}

static inline void sph2d__central_add(const sph2d__central *c, sph2d__place at, double *ax, double *ay)
{
    *ax -= c->rate2 * (at.x - c->x);
    *ay -= c->rate2 * (at.y - c->y);
}

static inline double sph2d__central_potential(const sph2d__central *c, double x, double y)
{
    const double dx = x - c->x, dy = y - c->y;
    return c->rate2 * (dx * dx + dy * dy) / 2;
}

static inline bool sph2d__central_drives(const sph2d__central *c)
{
    (void)c;
    return false;
}

static inline void sph2d__central_drive(const sph2d__central *c, sph2d__place at, double *ax, double *ay)
{
    (void)c, (void)at, (void)ax, (void)ay;
}

#endif
