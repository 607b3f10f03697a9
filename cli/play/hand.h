/* SPDX-License-Identifier: MIT */
/** @file hand.h
 *  What the mouse does to the liquid: pull and push, pour, wipe away, draw walls, move bodies, one of which it holds. */
#ifndef SPH2D_CLI_PLAY_HAND_H
#define SPH2D_CLI_PLAY_HAND_H

#include "live.h"

/** A body that the mouse holds. */
typedef struct grip {
    bool holds;
    size_t body;     /**< of the scene */
    sph2d_vec2 from; /**< the place that is held, from the body's centre when it was taken [m] ... */
    double angle;    /**< ... and the body's angle then [rad] */
} grip;

typedef enum hand_tool { HAND_PULL, HAND_POUR, HAND_WIPE, HAND_WALL } hand_tool;

typedef struct hand {
    hand_tool tool;
    double radius;                          /**< [m] */
    sph2d_vec2 at;                          /**< where it is [m] */
    bool down, pushes;                      /**< what its buttons do */
    bool still;                             /**< time stands still */
    grip grip;                              /**< the body that it holds */
    sph2d_vec2 corners[DRAWN_MOST_CORNERS]; /**< of the wall that is being drawn */
    size_t corner_count;
    char note[80]; /**< what the last move has to tell; empty for nothing */
} hand;

/** A hand whose reach fits the scene. */
hand hand_for(const sph2d_scene *scene);

/** "pull", "pour", "wipe", "wall". */
const char *hand_name(hand_tool tool);

/** Moves the hand to a place, with its buttons: left uses the tool, right pushes, or takes a drawn wall away where that
 *  is the tool. Acts on the liquid; what was before an act is kept when it begins. Errors: as the functions of live.h. */
sph2d_status hand_move(hand *h, live *l, sph2d_vec2 at, bool left, bool right, sph2d_report *report);

/** Makes the reach larger or smaller, by steps of a tenth. */
void hand_scale(hand *h, double steps);

#endif
