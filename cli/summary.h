/* SPDX-License-Identifier: MIT */
/** @file summary.h
 *  The summary of a run: speed and errors. */
#ifndef SPH2D_CLI_SUMMARY_H
#define SPH2D_CLI_SUMMARY_H

#include "folder.h"
#include "loop.h"
#include "options.h"
#include "threads.h"

/** Prints the summary to stdout: a table, with --json one object, with --quiet nothing. `reason` is how the session
 *  ended: finished, complete, guard, failed, SIGINT, SIGTERM, SIGHUP, max-wall. The series of gauges are read in the
 *  folder. */
void summary_print(const sph2d_sim *sim, const loop_result *result, const char *reason, const thread_choice *threads,
                   const cli_options *options, cli_folder *folder);

/** Change of energy since the start, less the net input by particles [J/m]. */
double summary_energy_change(const sph2d_summary *summary);

#endif
