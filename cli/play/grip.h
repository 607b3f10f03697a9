/* SPDX-License-Identifier: MIT */
/** @file grip.h
 *  A body that the mouse holds. */
#ifndef SPH2D_CLI_PLAY_GRIP_H
#define SPH2D_CLI_PLAY_GRIP_H

#include "live.h"

typedef struct grip {
    bool holds;
    size_t body;     /**< of the scene */
    sph2d_vec2 from; /**< the place that is held, from the body's centre when it was taken [m] ... */
    double angle;    /**< ... and the body's angle then [rad] */
} grip;

/** Takes the body at a place, if there is one. */
grip grip_take(const live *l, sph2d_vec2 at);

/** A body, where it is now, through which a line of this thickness [m] would go; SIZE_MAX for none. */
size_t grip_in_way(const live *l, const sph2d_vec2 *corners, size_t count, double thickness);

/** Lets the body follow the hand for the next steps, by its velocity. Errors: as sph2d_sim_set_body_velocity. */
sph2d_status grip_pull(const grip *g, live *l, sph2d_vec2 at);

#endif
