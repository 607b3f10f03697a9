/* SPDX-License-Identifier: MIT */
/** @file session.h
 *  What `run` and `resume` have in common: everything that a run needs while it goes on, and how it ends. */
#ifndef SPH2D_CLI_SESSION_H
#define SPH2D_CLI_SESSION_H

#include "folder.h"
#include "loop.h"
#include "options.h"
#include "threads.h"

typedef struct cli_session {
    const cli_options *options;
    double begun; /**< [s] on the wall clock; --max-wall counts from here */
    thread_choice threads;
    sph2d_scene_file *file;
    sph2d_sim *sim;
    cli_folder folder;
    cli_painter *painter;
    sph2d_report report;
} cli_session;

/** Starts the clock, chooses threads and catches signals. */
void session_begin(cli_session *s, const cli_options *options);

/** Options for sph2d_sim_create and sph2d_sim_restore. */
sph2d_sim_options session_sim_options(const cli_session *s);

/** After a scene was read: tells what was wrong with it and returns the exit code for `status`. When nothing was,
 *  warnings wait: making the simulation finds them again. */
int session_report_scene(cli_session *s, sph2d_status status);

/** Tells what the report says and returns the exit code for `status`. */
int session_report(cli_session *s, sph2d_status status);

/** Makes the painter if the scene asks for frames and --no-frames is not given. Needs the simulation. Returns an exit
 *  code. */
int session_make_painter(cli_session *s);

/** With the simulation and the folder ready: runs the loop, prints the summary and returns the exit code. `saved` tells
 *  what the simulation was restored from. */
int session_run(cli_session *s, saved_in saved);

/** Frees everything. */
void session_end(cli_session *s);

#endif
