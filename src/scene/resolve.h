/* SPDX-License-Identifier: MIT */
/** @file resolve.h
 *  What a scene leaves to its method. */
#ifndef SPH2D_SCENE_RESOLVE_H
#define SPH2D_SCENE_RESOLVE_H

#include "sph2d/scene.h"

/** The options with every 0 that stands for "the method's" filled in. */
sph2d_method_options sph2d__method_resolve(sph2d_method_options m);

/** The form of viscosity that a scene without one gets: at a free surface that of Monaghan & Gingold. Methods without
 *  forms keep the default. */
sph2d_viscosity_form sph2d__viscosity_form(const sph2d_scene *scene);

/** The model of eddies that a scene without one gets: Smagorinsky's at a free surface, unless shifting is off, or
 *  the scene damps by an artificial viscosity of its own. Methods without eddies keep the default. */
sph2d_turbulence sph2d__turbulence(const sph2d_scene *scene);

/** The form of the domain's sides that are walls. */
sph2d_wall_form sph2d__side_form(const sph2d_scene *scene);
/** The form of an obstacle. */
sph2d_wall_form sph2d__obstacle_form(const sph2d_scene *scene, const sph2d_obstacle *obstacle);

/** Length of the period [m]; 0 where the sides are not periodic. */
double sph2d__period_x(const sph2d_scene *scene);
double sph2d__period_y(const sph2d_scene *scene);

#endif
