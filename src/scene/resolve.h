/* SPDX-License-Identifier: MIT */
/** @file resolve.h
 *  Defaults of the method, the search radius, and periods. */
#ifndef SPH2D_SCENE_RESOLVE_H
#define SPH2D_SCENE_RESOLVE_H

#include "sph2d/scene.h"

/* Inner and outer radius of the band of surface tension (methods/terms/tension.h), in spacings from the particles.
 * Flowing liquid has no voids of the inner radius; with an outer radius of 1.5 a drop oscillates 1 % too slowly, with 2
 * by 0.1 %. */
static const double SPH2D__INNER_RADIUS = 1, SPH2D__OUTER_RADIUS = 2;

/** The options with every 0 that means "the method's default" replaced. */
sph2d_method_options sph2d__method_resolve(sph2d_method_options m);

/** Search radius of a resolved scene: H, with surface tension at least two outer radii of its band [m]. */
double sph2d__scene_reach(const sph2d_scene *scene);

/** Length of the period [m]; 0 where the sides are not periodic. */
double sph2d__period_x(const sph2d_scene *scene);
double sph2d__period_y(const sph2d_scene *scene);

#endif
