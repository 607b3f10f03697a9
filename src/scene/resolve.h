/* SPDX-License-Identifier: MIT */
/** @file resolve.h
 *  Defaults that depend on the method. */
#ifndef SPH2D_SCENE_RESOLVE_H
#define SPH2D_SCENE_RESOLVE_H

#include "sph2d/scene.h"

/* Inner and outer radius of the band of surface tension (methods/terms/tension.h), in spacings from the particles.
 * Flowing liquid has no voids of the inner radius; with an outer radius of 1.5 a drop oscillates 1 % too slowly, with 2
 * by 0.1 %. */
static const double SPH2D__INNER_RADIUS = 1, SPH2D__OUTER_RADIUS = 2;

/** The options with every 0 that means "the method's default" replaced. */
sph2d_method_options sph2d__method_resolve(sph2d_method_options m);

/** Search radius: H, with surface tension at least two outer radii of its band [m]. */
double sph2d__scene_reach(const sph2d_scene *scene);

/** Whether liquid fills the domain from the start: no side is open, and one block covers it. */
bool sph2d__has_no_surface(const sph2d_scene *scene);

/** The form of the domain's sides that are walls. */
sph2d_wall_form sph2d__side_form(const sph2d_scene *scene);
/** The form of an obstacle. */
sph2d_wall_form sph2d__obstacle_form(const sph2d_scene *scene, const sph2d_obstacle *obstacle);

/** The slip of a side, by its number (wall_names.h), and of an obstacle. */
sph2d_slip sph2d__side_slip(const sph2d_scene *scene, int side);
sph2d_slip sph2d__obstacle_slip(const sph2d_scene *scene, const sph2d_obstacle *obstacle);
/** Which slips the generalised walls of the scene have, a bit for each sph2d_slip; without such walls wall_slip. */
unsigned sph2d__slips(const sph2d_scene *scene);

/** Length of the period [m]; 0 where the sides are not periodic. */
double sph2d__period_x(const sph2d_scene *scene);
double sph2d__period_y(const sph2d_scene *scene);

#endif
