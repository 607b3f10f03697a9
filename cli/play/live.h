/* SPDX-License-Identifier: MIT */
/** @file live.h
 *  A simulation that follows the clock, and whose scene can be changed while it runs. */
#ifndef SPH2D_CLI_PLAY_LIVE_H
#define SPH2D_CLI_PLAY_LIVE_H

#include <stdbool.h>

#include <sph2d/io.h>

#include "drawn.h"
#include "nozzle.h"
#include "past.h"

typedef struct live {
    sph2d_scene_file *file;
    sph2d_scene scene; /**< the file's with the changes since */
    void *lists;       /**< its obstacles and bodies: those of the file, then what was drawn */
    sph2d_sim_options options;
    sph2d_sim *sim;
    sph2d_status stopped; /**< why it takes no more steps ... */
    char why[400];        /**< ... in a sentence */
    double due;           /**< simulated time that should be reached now [s] */
    double deadline;      /**< on the wall clock, for the steps of a picture [s] */
    double ratio;         /**< simulated time over that of the clock, in the mean over about a second */
    double pace;          /**< simulated time for a second of stepping [s], in the mean over some; 0: not known */
    uint64_t left;        /**< particles through open sides ... */
    size_t counted;       /**< ... when there were so many */
    nozzle nozzle;        /**< opened anew before each live_advance() */
    past past;
} live;

/** Starts a scene: takes the file, also after a failure. Errors: as sph2d_sim_create. */
sph2d_status live_open(live *l, sph2d_scene_file *file, const sph2d_sim_options *options, sph2d_report *report);
void live_close(live *l);

/** Starts the scene again, without what was drawn, with its own gravity, at another spacing (0: the
 *  same). */
sph2d_status live_restart(live *l, double spacing, sph2d_report *report);

/** The spacing at which steps take this part of the time of the clock, by those there were; 0: there were none. */
double live_fitting_spacing(const live *l, double part);

/** Steps until `seconds` more are simulated, or `budget` seconds of the clock have passed; what is not reached then is
 *  left out, but for a tenth of a second. Errors: as sph2d_sim_step, once; it stands still then. */
sph2d_status live_advance(live *l, double seconds, double budget, sph2d_report *report);

/** The sentence of a failure: its first error, or what its status means; empty without one. */
const char *live_reason(sph2d_status status, const sph2d_report *report);

/** One step, whatever the clock says. */
sph2d_status live_step(live *l, sph2d_report *report);

/** Goes on with another fluid or method, as in `scene` of the struct, which the caller has changed. The simulation stays
 *  as it was after a failure. Errors: as sph2d_sim_restore. */
sph2d_status live_change(live *l, const sph2d_scene *scene, sph2d_report *report);

/** Gives each particle a colour of its own, that of the liquid, if none has one yet. The same errors. */
sph2d_status live_give_colors(live *l, sph2d_report *report);

/** How thick a wall is that is drawn [m]; 0 where it is a line. */
double live_wall_thickness(const live *l);

/** The pieces of a line through 2 corners or more that make solids here. */
drawn_line live_divide(const live *l, const sph2d_vec2 *corners, size_t count);

/** Goes on with one more wall, a line through 2 corners or more, DRAWN_MOST_CORNERS at most. The liquid that is in its
 *  way now is removed: so many particles. Errors: as sph2d_sim_restore. */
sph2d_status live_add_wall(live *l, const sph2d_vec2 *corners, size_t count, size_t *removed, sph2d_report *report);

/** Goes on without the drawn wall that is at a place; *found says whether there is one. The same errors. */
sph2d_status live_remove_wall(live *l, sph2d_vec2 at, bool *found, sph2d_report *report);

/** Goes on with other walls and bodies, in lists of their own (lists_copy), which it takes unless it fails; `clear` removes
 *  liquid in the way of `what` is new, and counts it, NULL: nothing. Where `anew` is set bodies start as the scene has
 *  them. Errors: as sph2d_sim_restore. */
typedef sph2d_status live_clear(const live *l, sph2d_sim *sim, const void *what, size_t *removed);
sph2d_status live_rebuild(live *l, const sph2d_scene *scene, void *lists, bool anew, live_clear *clear,
                          const void *what, size_t *removed, sph2d_report *report);

/** How far liquid is from what was drawn, at least [m]; and from where that can be taken. */
double live_clearance(const live *l);
double live_grasp(const live *l);

/** Keeps what is before an act of the user, for live_undo(). `name` is that of the act, and outlives it. */
void live_remember(live *l, const char *name);

/** Goes back to before the latest act that live_remember() was told of; *name is its name, NULL if there is none. The
 *  same errors; the act stays then. */
sph2d_status live_undo(live *l, const char **name, sph2d_report *report);

/** Particles that left through open sides. */
uint64_t live_left(const live *l);

/** The scene as it is now, for a file: with its sound speed where gravity, from which this follows, was taken away. */
sph2d_scene live_scene(const live *l);

#endif
