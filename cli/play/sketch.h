/* SPDX-License-Identifier: MIT */
/** @file sketch.h
 *  Bodies that the mouse draws, holds in their places, and takes away: what is begun when a button goes down is done when
 *  it comes up. What cannot be is told by the hand's note. Errors: as sph2d_sim_restore, for lack of memory. */
#ifndef SPH2D_CLI_PLAY_SKETCH_H
#define SPH2D_CLI_PLAY_SKETCH_H

#include "hand.h"

/** The body as far as it is drawn; of a polygon the corners are the hand's. False: nothing is drawn. */
bool sketch_shape(const hand *h, const live *l, sph2d_shape *shape);

/** Goes on drawing while the button is `down`; else makes the body that was drawn. */
sph2d_status sketch_body(hand *h, live *l, bool down, sph2d_report *report);

/** Goes on to hold a body, by a spring to where the hand is; else, once the button is up, holds it so: a click makes a
 *  hinge, or lets go of what holds the body there. */
sph2d_status sketch_hold(hand *h, live *l, bool down, sph2d_report *report);

/** Takes away the drawn body at the hand, or what holds the one there. */
sph2d_status sketch_erase(hand *h, live *l, sph2d_report *report);

/** Puts the body that is held where the hand is. */
sph2d_status sketch_put(hand *h, live *l, sph2d_report *report);

#endif
