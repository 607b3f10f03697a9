/* SPDX-License-Identifier: MIT */
/** @file progress.h
 *  Progress of a long job: a bar with the remaining time on a terminal, otherwise plain lines. */
#ifndef SPH2D_CLI_PROGRESS_H
#define SPH2D_CLI_PROGRESS_H

#include <stdbool.h>

#include "options.h"

typedef struct cli_progress {
    enum { PROGRESS_OFF, PROGRESS_LINES, PROGRESS_BAR } form;
    double from, to;      /**< start and end of the job, in any unit */
    double begun;         /**< start on the wall clock [s] */
    double printed;       /**< time of the last output [s] */
    double printed_tenth; /**< tenth of the job at the last output */
} cli_progress;

/** Starts; this session works from `from` to `to`. */
cli_progress progress_begin(const cli_options *options, double from, double to);

/** Prints the progress `now` when it is due, with a detail in printf's format, such as "t 0.2 of 1 s". */
void progress_update(cli_progress *p, double now, const char *format, ...) __attribute__((format(printf, 3, 4)));

/** Removes the bar. */
void progress_end(cli_progress *p);

#endif
