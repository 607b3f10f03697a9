/* SPDX-License-Identifier: MIT */
/** @file session.h
 *  The common part of `run` and `resume`: a session, and the summary of what it did. */
#ifndef SPH2D_CLI_SESSION_H
#define SPH2D_CLI_SESSION_H

#include "device.h"
#include "folder.h"
#include "loop.h"
#include "options.h"
#include "threads.h"

typedef struct cli_session {
    const cli_options *options;
    double begun; /**< start on the wall clock, from which --max-wall counts [s] */
    thread_choice threads;
    device_choice device;
    sph2d_scene_file *file;
    sph2d_sim *sim;
    cli_folder folder;
    frame_writer *writer;
    sph2d_report report;
} cli_session;

/** Starts the clock, chooses the threads and installs the signal handlers; then finds the device. Returns an exit code. */
int session_begin(cli_session *s, const cli_options *options);

/** Options for sph2d_sim_create and sph2d_sim_restore. */
sph2d_sim_options session_sim_options(const cli_session *s);

/** Prints the report of reading a scene and returns the exit code for `status`. Without errors the warnings are
 *  dropped: creating the simulation repeats them. */
int session_report_scene(cli_session *s, sph2d_status status);

/** Prints the report and returns the exit code for `status`. */
int session_report(cli_session *s, sph2d_status status);

/** Creates the frame writer if the scene has frames and --no-frames is not given. Needs the simulation. Returns an exit
 *  code. */
int session_create_frame_writer(cli_session *s);

/** Runs the loop with the simulation and the folder, prints the summary and returns the exit code. `saved` is the file
 *  that the simulation was restored from. */
int session_run(cli_session *s, saved_in saved);

/** Frees everything. Of a session that failed (`code`), the empty folders that it made are removed. */
void session_end(cli_session *s, int code);

/* ---- its summary (summary.c) ------------------------------------------------------------------------------------- */

/** Prints the summary to stdout: a table, with --json one object, with --quiet nothing. `reason` is how the session
 *  ended: finished, complete, guard, failed, SIGINT, SIGTERM, SIGHUP, max-wall. The series of gauges are read in the
 *  folder. */
void summary_print(cli_session *s, const loop_result *result, const char *reason);

/** Change of energy since the start, less the net input by particles [J/m]. */
double summary_energy_change(const sph2d_summary *summary);

#endif
