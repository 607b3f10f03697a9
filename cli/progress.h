/* SPDX-License-Identifier: MIT */
/** @file progress.h
 *  How far a long job is: a bar with the time that is left on a terminal, a plain line now and then elsewhere. */
#ifndef SPH2D_CLI_PROGRESS_H
#define SPH2D_CLI_PROGRESS_H

#include <stdbool.h>

#include "options.h"

typedef struct cli_progress {
    enum { PROGRESS_OFF, PROGRESS_LINES, PROGRESS_BAR } form;
    double from, to;      /**< where the job starts and ends, in whatever it counts */
    double begun;         /**< [s] on the wall clock */
    double printed;       /**< [s] when it was last printed */
    double printed_tenth; /**< and what tenth of the job it was */
} cli_progress;

/** Starts; `from` to `to` is what this session has to do. */
cli_progress progress_begin(const cli_options *options, double from, double to);

/** Tells how far it is, when it is time to; `detail` is printf's, about the moment: "t 0.2 of 1 s". */
void progress_update(cli_progress *p, double now, const char *format, ...) __attribute__((format(printf, 3, 4)));

/** Takes the bar away. */
void progress_end(cli_progress *p);

#endif
