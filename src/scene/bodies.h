/* SPDX-License-Identifier: MIT */
/** @file bodies.h
 *  Bodies of a scene as rigid bodies, with mass, inertia and springs. */
#ifndef SPH2D_SCENE_BODIES_H
#define SPH2D_SCENE_BODIES_H

#include "sph2d/scene.h"

/** Mass [kg/m], moment of inertia about the centre of mass [kg m], centre of mass [m], and area [m^2]. */
typedef struct sph2d__mass_data {
    double mass, inertia;
    sph2d_vec2 center;
    double area;
} sph2d__mass_data;

/** Of a body with a valid outline. */
sph2d__mass_data sph2d__body_mass(const sph2d_body *body);

/** Where a spring holds a body whose centre of mass is given, as the scene draws it; and its length without force. */
sph2d_vec2 sph2d__spring_start(const sph2d_spring *spring, sph2d_vec2 center);
double sph2d__spring_length(const sph2d_spring *spring, sph2d_vec2 start);

/** Energy of a spring as the scene draws it, where it can move the body [J/m]. */
double sph2d__spring_energy(const sph2d_body *body, const sph2d_spring *spring);

/** The largest speed of a body's points at the start; and a bound, in vacuum, of that of the ends of its springs later,
 *  if these turn all that they store at the start into motion [m/s]. */
double sph2d__body_speed(const sph2d_body *body);
double sph2d__spring_speed(const sph2d_body *body);

#endif
