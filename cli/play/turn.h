/* SPDX-License-Identifier: MIT */
/** @file turn.h
 *  One turn of the loop around a window or a page: input, steps, a picture. */
#ifndef SPH2D_CLI_PLAY_TURN_H
#define SPH2D_CLI_PLAY_TURN_H

#include "game.h"

/* ---- a thread that does one thing again and again, while the caller does another (worker.c) ---------------------- */

typedef struct worker worker;

/** Starts a thread for work(context). NULL: there is none to be had. */
worker *worker_start(void (*work)(void *), void *context);

/** Has the work done once; it ends before worker_wait() returns, and the next begins after that. */
void worker_begin(worker *w);
void worker_wait(worker *w);

/** Ends the thread once its work is done, and frees it; NULL is ignored. */
void worker_stop(worker *w);

/* ---- a turn ------------------------------------------------------------------------------------------------------ */

/** The steps of a turn. */
typedef struct stepping {
    live *live;
    double seconds, budget; /**< that the liquid follows, and that it has for that [s] */
    sph2d_status status;
    sph2d_report report;
    double taken; /**< by them [s] */
} stepping;

/** What lasts from turn to turn. Starts with {0}, turn_beside() may follow. */
typedef struct turning {
    stepping steps;
    worker *worker; /**< takes them beside drawing; NULL: the caller does before */
    sph2d_renderer *renderer;
    unsigned width, height;   /**< of the renderer */
    sph2d_style style;        /**< ... its style ... */
    sph2d_look look;          /**< ... and its look */
    double stepping, drawing; /**< time of a turn's steps and of its picture, in the mean over some [s] */
    double draws;             /**< when the last picture was begun [s] */
    double pictures;          /**< a second, in the last second ... */
    double counted;           /**< ... whose end this was, and the pictures before it */
    size_t shown, shown_then;
    double from;              /**< simulated time before the steps [s] */
    double simulated, played; /**< sum of simulated time, and of the clock's while not paused [s] */
} turning;

/** Takes what the user did, lets `since` seconds of the clock pass for the liquid, and draws it into framebuffer 0 of the
 *  context that is current, whose functions `loader` finds. Errors: those of sph2d_renderer_create; what goes wrong in the
 *  game is told on the picture. */
sph2d_status turn_take(turning *t, game *g, const play_input *input, sph2d_gl_loader loader, double since,
                       sph2d_report *report);

/** Lets a thread step while pictures are drawn: each then shows what there was before its turn's steps. The turning stays
 *  where it is. */
void turn_beside(turning *t);

/** Counts the picture, once it is shown, and waits for the steps. */
void turn_shown(turning *t, game *g);

/** Waits for steps, and frees the renderer; the context is current. */
void turn_end(turning *t, game *g);

#endif
