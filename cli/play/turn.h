/* SPDX-License-Identifier: MIT */
/** @file turn.h
 *  One turn of the loop around a window or a page: input, steps, a picture. */
#ifndef SPH2D_CLI_PLAY_TURN_H
#define SPH2D_CLI_PLAY_TURN_H

#include "game.h"

/** What lasts from turn to turn. Starts with {0}. */
typedef struct turning {
    sph2d_renderer *renderer;
    unsigned width, height;   /**< of the renderer */
    sph2d_style style;        /**< ... its style ... */
    sph2d_look look;          /**< ... and its look */
    double stepping, drawing; /**< time of a turn's steps and of its picture, in the mean over some [s] */
    double draws;             /**< when the last picture was begun [s] */
    double pictures;          /**< a second, in the last second ... */
    double counted;           /**< ... whose end this was, and the pictures before it */
    size_t shown, shown_then;
    double simulated, played; /**< sum of simulated time, and of the clock's while not paused [s] */
} turning;

/** Takes what the user did, lets `since` seconds of the clock pass for the liquid, and draws it into framebuffer 0 of the
 *  context that is current, whose functions `loader` finds. Errors: those of sph2d_renderer_create; what goes wrong in the
 *  game is told on the picture. */
sph2d_status turn_take(turning *t, game *g, const play_input *input, sph2d_gl_loader loader, double since,
                       sph2d_report *report);

/** Counts the picture, once it is shown. */
void turn_shown(turning *t);

/** Frees the renderer; the context is current. */
void turn_end(turning *t);

#endif
