/* SPDX-License-Identifier: MIT */
/** @file gravity.h
 *  Gravity g, the same everywhere, with the potential -g . (x - corner) but along periods: there it drives. */
#ifndef SPH2D_FORCES_GRAVITY_H
#define SPH2D_FORCES_GRAVITY_H

#include "forces/place.h"
#include "sph2d/scene.h"

typedef struct sph2d__gravity {
    double x, y;               /**< [m/s^2] */
    sph2d_vec2 corner;         /**< where its potential is 0 [m] */
    bool endless_x, endless_y; /**< along a period */
} sph2d__gravity;

/** Sets it for the start of a scene. */
static inline void sph2d__gravity_set(sph2d__gravity *g, const sph2d_scene *scene, double sound_speed)
{
    (void)sound_speed;
    *g = (sph2d__gravity){scene->gravity.x, scene->gravity.y, scene->domain.min,
                          scene->boundary.left == SPH2D_SIDE_PERIODIC, scene->boundary.bottom == SPH2D_SIDE_PERIODIC};
}

static inline bool sph2d__gravity_acts(const sph2d__gravity *g)
{
    return g->x != 0 || g->y != 0;
}

static inline void sph2d__gravity_add(const sph2d__gravity *g, sph2d__place at, double *ax, double *ay)
{
    (void)at;
    *ax += g->x;
    *ay += g->y;
}

static inline double sph2d__gravity_potential(const sph2d__gravity *g, double x, double y)
{
    return -((g->endless_x ? 0 : g->x) * (x - g->corner.x) + (g->endless_y ? 0 : g->y) * (y - g->corner.y));
}

static inline bool sph2d__gravity_drives(const sph2d__gravity *g)
{
    return (g->endless_x && g->x != 0) || (g->endless_y && g->y != 0);
}

static inline void sph2d__gravity_drive(const sph2d__gravity *g, sph2d__place at, double *ax, double *ay)
{
    (void)at;
    *ax += g->endless_x ? g->x : 0;
    *ay += g->endless_y ? g->y : 0;
}

#endif
