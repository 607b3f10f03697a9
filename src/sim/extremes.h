/* SPDX-License-Identifier: MIT */
/** @file extremes.h
 *  Extremes over all particles, and the first that a guard finds, in C and in OpenCL C. */
#ifndef SPH2D_SIM_EXTREMES_H
#define SPH2D_SIM_EXTREMES_H

#include <math.h>

#include "particles/store.h"
#include "sph2d/scene.h"

typedef struct sph2d__extremes {
    double speed2, acceleration2, density, pressure;
    double log_density; /**< the largest size of one, where particles have it */
    size_t not_finite;  /**< index of the first particle with a value that is not finite; SIZE_MAX for none */
    size_t escaped;     /**< of the first beyond a side that is a wall */
    size_t implausible; /**< of the first with a density out of bounds */
    size_t left;        /**< of the first that has left through a side */
} sph2d__extremes;

/** Bounds to check. */
typedef struct sph2d__limits {
    sph2d_box domain, walled;        /**< the latter unbounded at sides that are not walls */
    int open[4];                     /**< whether the left, right, bottom, top side is open */
    double min_density, max_density; /**< [kg/m^3] */
} sph2d__limits;

/** The open side through which a particle has left: 0 to 3 for left, right, bottom, top, or -1. Within one more width or height
 *  of the domain it is kept, as it may come back. */
static inline int sph2d__side_left(const sph2d_box *box, double x, double y)
{
    const sph2d_box d = *box;
    const double width = d.max.x - d.min.x, height = d.max.y - d.min.y;
    if (x < d.min.x - width)
        return 0;
    if (x > d.max.x + width)
        return 1;
    if (y < d.min.y - height)
        return 2;
    return y > d.max.y + height ? 3 : -1;
}

static inline sph2d__extremes sph2d__no_extremes(void)
{
    return (sph2d__extremes){.not_finite = SIZE_MAX, .escaped = SIZE_MAX, .implausible = SIZE_MAX, .left = SIZE_MAX};
}

/** Takes particle i into account. */
static inline void sph2d__see_particle(const sph2d__store *f, const sph2d__limits *within, size_t i, sph2d__extremes *e)
{
    const double x = f->x[i], y = f->y[i], density = f->density[i];
    const double pressure = f->acting_pressure ? f->acting_pressure[i] : f->pressure[i];
    const double v2 = f->vx[i] * f->vx[i] + f->vy[i] * f->vy[i], a2 = f->ax[i] * f->ax[i] + f->ay[i] * f->ay[i];
    const sph2d_box box = within->walled;
    e->speed2 = v2 > e->speed2 ? v2 : e->speed2;
    e->acceleration2 = a2 > e->acceleration2 ? a2 : e->acceleration2;
    e->density = density > e->density ? density : e->density;
    e->pressure = pressure > e->pressure ? pressure : e->pressure;
    const double theta = f->log_density ? fabs(f->log_density[i]) : 0;
    e->log_density = theta > e->log_density ? theta : e->log_density;
    if (!isfinite(v2 + a2 + x + y) && i < e->not_finite)
        e->not_finite = i;
    const int side = sph2d__side_left(&within->domain, x, y);
    e->left = side >= 0 && i < e->left ? i : e->left;
    if ((x < box.min.x || x > box.max.x || y < box.min.y || y > box.max.y) && i < e->escaped &&
        !(side >= 0 && within->open[side])) /* beyond the end of the walls */
        e->escaped = i;
    if (!(density >= within->min_density && density <= within->max_density) && i < e->implausible)
        e->implausible = i;
}

static inline sph2d__extremes sph2d__join_extremes(sph2d__extremes a, sph2d__extremes b)
{
    return (sph2d__extremes){a.speed2 > b.speed2 ? a.speed2 : b.speed2,
                             a.acceleration2 > b.acceleration2 ? a.acceleration2 : b.acceleration2,
                             a.density > b.density ? a.density : b.density,
                             a.pressure > b.pressure ? a.pressure : b.pressure,
                             a.log_density > b.log_density ? a.log_density : b.log_density,
                             a.not_finite < b.not_finite ? a.not_finite : b.not_finite,
                             a.escaped < b.escaped ? a.escaped : b.escaped,
                             a.implausible < b.implausible ? a.implausible : b.implausible,
                             a.left < b.left ? a.left : b.left};
}

#endif
