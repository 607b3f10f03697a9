/* SPDX-License-Identifier: MIT */
/** @file live_bodies.h
 *  Bodies of a live simulation that are drawn, taken away, put elsewhere, held and let go. After each of these all bodies
 *  of the scene start where they are then, with the velocities that they have: what is kept of it can run from its start.
 *  Errors of the functions: as sph2d_sim_restore; all stays as it was then. */
#ifndef SPH2D_CLI_PLAY_LIVE_BODIES_H
#define SPH2D_CLI_PLAY_LIVE_BODIES_H

#include "lists.h"
#include "live.h"

/** Where a body of the scene has gone. */
body_move live_body_move(const live *l, size_t body);

/** Whether a body was drawn. */
bool live_is_drawn(const live *l, size_t body);

/** Adds a body of a density [kg/m^3], and removes the liquid in its way: so many particles. */
sph2d_status live_add_body(live *l, const sph2d_shape *shape, double density, size_t *removed, sph2d_report *report);
sph2d_status live_remove_body(live *l, size_t body, sph2d_report *report);

/** Puts a body elsewhere, by a move from where it is now. */
sph2d_status live_put_body(live *l, size_t body, const body_move *shift, size_t *removed, sph2d_report *report);

/** Holds the point of a body that is at a place now by a spring to a fixed point [m]: a hinge where both are the same. */
sph2d_status live_hold(live *l, size_t body, sph2d_vec2 at, sph2d_vec2 to, sph2d_report *report);

/** The spring at a place, if one is within a reach [m]; and the way to let go of it. */
bool live_find_spring(const live *l, sph2d_vec2 at, double reach, size_t *body, size_t *spring);
sph2d_status live_release(live *l, size_t body, size_t spring, sph2d_report *report);

/** The point of the body that a spring holds, where it is now. */
sph2d_vec2 live_spring_end(const live *l, size_t body, size_t spring);

#endif
