/* SPDX-License-Identifier: MIT */
/** @file live.h
 *  A simulation that follows the clock, and whose scene can be changed while it runs. */
#ifndef SPH2D_CLI_PLAY_LIVE_H
#define SPH2D_CLI_PLAY_LIVE_H

#include <stdbool.h>

#include <sph2d/io.h>

typedef struct live {
    sph2d_scene_file *file;
    sph2d_scene scene;         /**< the file's with the changes since */
    sph2d_obstacle *obstacles; /**< its list */
    sph2d_sim_options options;
    sph2d_sim *sim;
    sph2d_status stopped; /**< why it takes no more steps */
    double due;           /**< simulated time that should be reached now [s] */
    double deadline;      /**< on the wall clock, for the steps of a picture [s] */
    double ratio;         /**< simulated time over that of the clock, in the mean over about a second */
    double pace;          /**< simulated time for a second of stepping [s], in the mean over some; 0: not known */
    sph2d_vec2 *corners;  /**< of the walls that were drawn */
    size_t corner_count;
} live;

/** Starts a scene: takes the file, also after a failure. Errors: as sph2d_sim_create. */
sph2d_status live_open(live *l, sph2d_scene_file *file, const sph2d_sim_options *options, sph2d_report *report);
void live_close(live *l);

/** Starts the scene again, without the walls that were drawn, at another spacing (0: the same). */
sph2d_status live_restart(live *l, double spacing, sph2d_report *report);

/** Steps until `seconds` more are simulated, or `budget` seconds of the clock have passed; what is not reached then is
 *  left out, but for a tenth of a second. Errors: as sph2d_sim_step, once; it stands still then. */
sph2d_status live_advance(live *l, double seconds, double budget, sph2d_report *report);

/** One step, whatever the clock says. */
sph2d_status live_step(live *l, sph2d_report *report);

/** Goes on with another fluid or method, as in `scene` of the struct, which the caller has changed. The simulation stays
 *  as it was after a failure. Errors: as sph2d_sim_restore. */
sph2d_status live_change(live *l, const sph2d_scene *scene, sph2d_report *report);

/** Goes on with one more wall, a line through 2 corners or more; liquid in its way is removed. Errors: as
 *  sph2d_sim_create. */
sph2d_status live_add_wall(live *l, const sph2d_vec2 *corners, size_t count, sph2d_report *report);

#endif
