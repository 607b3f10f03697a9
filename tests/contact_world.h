/* SPDX-License-Identifier: MIT */
/** @file contact_world.h
 *  Bodies without liquid, moved by a kick, the solver for contacts and a drift. */
#ifndef SPH2D_TESTS_CONTACT_WORLD_H
#define SPH2D_TESTS_CONTACT_WORLD_H

#include "contacts/contacts.h"

enum { WORLD_BODIES = 1000, WORLD_OBSTACLES = 4, WORLD_WALLS = SPH2D__SIDES + WORLD_OBSTACLES };

typedef struct contact_world {
    sph2d_scene scene;
    sph2d_vec2 gravity;
    double dt;
    sph2d_body bodies[WORLD_BODIES];
    sph2d_contact_body states[WORLD_BODIES];
    sph2d_obstacle obstacles[WORLD_OBSTACLES];
    sph2d_body_state walls[WORLD_OBSTACLES]; /**< of these; moved by their velocities */
    double work[WORLD_WALLS];                /**< of each wall so far, as the solver tells [J/m] */
    double gain;    /**< largest rise of kinetic energy less `work` by contacts, of what was there */
    double overlap; /**< largest overlap of two bodies or of one with a side [m] */
} contact_world;

/** An empty world: a domain of 1 m by 1 m with four walls, spacing 1 mm, gravity, steps of 0.5 ms. It is static. */
contact_world *world_new(void);
/** Add a body of 1000 kg/m^3; return its number. Points are borrowed. */
uint32_t world_disc(contact_world *world, double x, double y, double radius);
uint32_t world_box(contact_world *world, double x, double y, double width, double height);
/** A polygon with its centre of mass at (x, y), from where its corners are drawn, and of a given mass and inertia. */
uint32_t world_polygon(contact_world *world, sph2d_points corners, sph2d_vec2 center, double mass, double inertia);
/** Adds an obstacle at rest, which turns about a centre. */
void world_obstacle(contact_world *world, sph2d_shape outline, sph2d_vec2 center);
/** One step; overlaps are measured in it if wanted. */
void world_step(contact_world *world, bool wanted);
/** A number of steps, with overlaps measured in each. */
void world_run(contact_world *world, int steps);
/** Kinetic energy [J/m]. */
double world_kinetic(const contact_world *world);
/** Kinetic energy and that of gravity [J/m]. */
double world_energy(const contact_world *world);
/** Overlap of two discs or convex bodies; negative for a gap, of which it is then a lower bound [m]. */
double world_overlap(const contact_world *w, uint32_t i, uint32_t j);

#endif
