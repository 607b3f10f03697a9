/* SPDX-License-Identifier: MIT */
/** @file bodies.h
 *  Bodies of a scene as rigid bodies, with mass and inertia, and as obstacles, which they are to everything that knows
 *  outlines only. */
#ifndef SPH2D_SCENE_BODIES_H
#define SPH2D_SCENE_BODIES_H

#include "base/memory.h"
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

/** Appends the bodies to the obstacles of a copy of a scene. False when memory is short. */
bool sph2d__append_bodies(sph2d_scene *scene, sph2d__arena *arena, sph2d__memory *memory);

/** The number of obstacles before the bodies in such a copy. */
static inline size_t sph2d__obstacles_without_bodies(const sph2d_scene *scene)
{
    size_t n = scene->obstacle_count;
    return n > 0 && scene->obstacles[n - 1].body ? n - scene->body_count : n;
}

/** Whether an obstacle ever moves: by its motion, or as a body. */
bool sph2d__obstacle_moves(const sph2d_obstacle *obstacle);
/** Whether it ever turns. */
bool sph2d__obstacle_turns(const sph2d_obstacle *obstacle);

/** "obstacles[2].line", or "bodies[0].circle" where obstacle `index` of a copy is a body; at most `size` bytes. */
const char *sph2d__obstacle_path(char *path, size_t size, const sph2d_scene *scene, size_t index, const char *rest);

#endif
