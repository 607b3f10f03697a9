/* SPDX-License-Identifier: MIT */
/** @file message.h
 *  Errors, warnings and notices, printed to stderr. With --json each is a JSON object. */
#ifndef SPH2D_CLI_MESSAGE_H
#define SPH2D_CLI_MESSAGE_H

#include <stdbool.h>

#include "options.h"
#include <sph2d/status.h>

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

#endif
