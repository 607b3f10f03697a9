/* SPDX-License-Identifier: MIT */
/** @file hand.h
 *  What the mouse does: pull and push liquid, pour, wipe away, draw walls and bodies, move and hold these. */
#ifndef SPH2D_CLI_PLAY_HAND_H
#define SPH2D_CLI_PLAY_HAND_H

#include "grip.h"

/** From HAND_WALL on what is drawn is made when the button comes up. */
typedef enum hand_tool {
    HAND_PULL,
    HAND_PUSH,
    HAND_POUR,
    HAND_WIPE,
    HAND_WALL,
    HAND_CIRCLE,
    HAND_BOX,
    HAND_OUTLINE,
    HAND_HOLD
} hand_tool;

typedef struct hand {
    hand_tool tool;
    double radius;                          /**< [m] */
    sph2d_vec2 at;                          /**< where it is [m] */
    bool down, pushes;                      /**< what its buttons do */
    bool still;                             /**< time stands still */
    grip grip;                              /**< the body that it holds */
    double density;                         /**< of bodies that it draws, over the liquid's */
    sph2d_vec2 corners[DRAWN_MOST_CORNERS]; /**< of what is being drawn: where it was begun, and on */
    size_t corner_count;
    char note[160]; /**< what the last move has to tell; empty for nothing */
} hand;

/** A hand whose reach fits the scene. */
hand hand_for(const sph2d_scene *scene);

/** "pull", "pour" and so on. */
const char *hand_name(hand_tool tool);

/** Moves the hand to a place, with its buttons: left uses the tool, right pushes, or takes away what was drawn where
 *  the tool draws, as a click does. Acts on the liquid; what was before an act is kept when it begins. Errors: as the functions of live.h. */
sph2d_status hand_move(hand *h, live *l, sph2d_vec2 at, bool left, bool right, sph2d_report *report);

/** Takes another tool; what is half drawn is left. */
void hand_take(hand *h, hand_tool tool);

/** Makes the reach larger or smaller, by steps of a tenth. */
void hand_scale(hand *h, double steps);

#endif
