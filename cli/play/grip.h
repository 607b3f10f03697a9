/* SPDX-License-Identifier: MIT */
/** @file grip.h
 *  Bodies under the mouse: which one is there, how one that is held follows. */
#ifndef SPH2D_CLI_PLAY_GRIP_H
#define SPH2D_CLI_PLAY_GRIP_H

#include "live_bodies.h"

/** A body that the mouse holds. */
typedef struct grip {
    bool holds;
    size_t body;     /**< of the scene */
    sph2d_vec2 from; /**< the place that is held, from the body's centre when it was taken [m] ... */
    double angle;    /**< ... and the body's angle then [rad] */
} grip;

/** Takes the body at a place, if there is one. */
grip grip_take(const live *l, sph2d_vec2 at);

/** Where the held point of the body is now [m]. */
sph2d_vec2 grip_place(const grip *g, const live *l);

/** Lets the body follow the hand for the next steps, by its velocity. Errors: as sph2d_sim_set_body_velocity. */
sph2d_status grip_pull(const grip *g, live *l, sph2d_vec2 at);

/** How the body goes from where it is now, so that its held point comes to a place as near as what holds it lets it. */
body_move grip_shift(const grip *g, const live *l, sph2d_vec2 at);

/** A body, where it is now, through which a line of this thickness [m] would go; SIZE_MAX for none. */
size_t grip_in_way(const live *l, const sph2d_vec2 *corners, size_t count, double thickness);

#endif
