/* SPDX-License-Identifier: MIT */
/** @file message.h
 *  Errors, warnings and notices, printed to stderr; with --json each is a JSON object. And the progress of a long job: a bar
 *  with the remaining time on a terminal, otherwise plain lines. */
#ifndef SPH2D_CLI_MESSAGE_H
#define SPH2D_CLI_MESSAGE_H

#include <stdbool.h>

#include <sph2d/status.h>

#include "options.h"

#define MESSAGE_FORMAT(where, first) __attribute__((format(printf, where, first)))

/** Sets the style by --json, --quiet, --verbose and --no-color. */
void message_setup(const cli_options *options);

/** A usage error, with a hint to --help. `command` is NULL before it is known. */
void message_usage(const char *command, const char *format, ...) MESSAGE_FORMAT(2, 3);

/** An error of the command itself, with a code of the library's table and a hint (NULL for none). */
void message_error(sph2d_code code, const char *hint, const char *format, ...) MESSAGE_FORMAT(3, 4);
void message_warning(sph2d_code code, const char *format, ...) MESSAGE_FORMAT(2, 3);
/** Unless --quiet. */
void message_note(const char *format, ...) MESSAGE_FORMAT(1, 2);
/** Only with --verbose. */
void message_detail(const char *format, ...) MESSAGE_FORMAT(1, 2);

/** All diagnostics of a report; if `file` is not NULL, those about a key path get their place in it. If a call failed
 *  (`status` not SPH2D_OK) without any error in its report, the status itself is reported. */
void message_report(sph2d_status status, sph2d_report *report, const sph2d_scene_file *file);

/** Shows `text` on the terminal's last line, to be replaced by the next; NULL removes it. Messages go above it. */
void message_status(const char *text);

/** Whether stderr is a terminal that can redraw a line. */
bool message_terminal(void);

/* ---- progress of a long job -------------------------------------------------------------------------------------- */

typedef struct cli_progress {
    enum { PROGRESS_OFF, PROGRESS_LINES, PROGRESS_BAR } form;
    double from, to;      /**< start and end of the job, in any unit */
    double begun;         /**< start on the wall clock [s] */
    double printed;       /**< time of the last output [s] */
    double printed_tenth; /**< tenth of the job at the last output */
} cli_progress;

/** Starts; this session works from `from` to `to`. */
cli_progress progress_begin(const cli_options *options, double from, double to);

/** A fact of a line of progress, a text or a number. */
typedef struct progress_fact {
    const char *key;
    double number;
    const char *text; /**< NULL: the number */
} progress_fact;

/** Prints the progress `now` when it is due, with a detail in printf's format, such as "t 0.2 of 1 s"; with --json an object
 *  with the facts, which one without a key ends. */
void progress_update(cli_progress *p, double now, const progress_fact *facts, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/** Removes the bar. */
void progress_end(cli_progress *p);

#endif
