/* SPDX-License-Identifier: MIT */
/** @file fitted_surface.h
 *  What fits near walls know of their surfaces. */
#ifndef SPH2D_METHODS_FITTED_FITTED_SURFACE_H
#define SPH2D_METHODS_FITTED_FITTED_SURFACE_H

#include "methods/common/state_equation.h"
#include "methods/fitted/fitted.h"

/* Largest depth [dx] of boundary particles of the first layer, which represent the surface. */
static const double FIRST_LAYER = 0.75;
/* Weight of the density gradient known at a wall relative to neighbours. Without it the gradient at a wall is an
 * extrapolation, and a cavity at Re 1000 diverged. */
static const double GRADIENT_WEIGHT = 0.1;

/** The density gradient along the normal at boundary particle b, in units of H, for a density and a body force there. */
static inline double sph2d__fitted_slope(const sph2d__system *s, size_t b, double density, sph2d_vec2 at)
{
    const sph2d__store *w = &s->walls;
    double gx = -w->ax[b], gy = -w->ay[b];
    sph2d__forces_add(&s->forces, (sph2d__place){at.x, at.y, w->vx[b], w->vy[b]}, &gx, &gy);
    double c2 = s->sound_speed * s->sound_speed;
    return density / c2 * s->support * (gx * w->normal_x[b] + gy * w->normal_y[b]);
}

#endif
