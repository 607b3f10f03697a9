/* SPDX-License-Identifier: MIT */
/** @file summary.h
 *  What a run was: its speed and its errors, side by side. */
#ifndef SPH2D_CLI_SUMMARY_H
#define SPH2D_CLI_SUMMARY_H

#include "loop.h"
#include "options.h"
#include "threads.h"

/** Prints the summary to stdout: a table, with --json one object, with --quiet nothing. `reason` is a word for how the
 *  session ended: finished, complete, guard, failed, SIGINT, SIGTERM, max-wall. */
void summary_print(const sph2d_sim *sim, const loop_result *result, const char *reason, const thread_choice *threads,
                   const cli_options *options);

/** What became of the energy that nobody fed in or took out [J/m]. */
double summary_energy_change(const sph2d_summary *summary);

#endif
