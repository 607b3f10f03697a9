/* SPDX-License-Identifier: MIT */
/** @file message.h
 *  What the command says to people: errors, warnings and notices, to stderr. With --json each is a JSON object. */
#ifndef SPH2D_CLI_MESSAGE_H
#define SPH2D_CLI_MESSAGE_H

#include <stdbool.h>

#include "options.h"
#include <sph2d/status.h>

#define MESSAGE_FORMAT(where, first) __attribute__((format(printf, where, first)))

/** Takes --json, --quiet, --verbose and --no-color from the options. */
void message_setup(const cli_options *options);

/** A bad command line, with the advice to try --help. `command` is NULL before one is known. */
void message_usage(const char *command, const char *format, ...) MESSAGE_FORMAT(2, 3);

/** An error of the command's own, with a code of the library's table and a hint (NULL for none). */
void message_error(sph2d_code code, const char *hint, const char *format, ...) MESSAGE_FORMAT(3, 4);
void message_warning(sph2d_code code, const char *format, ...) MESSAGE_FORMAT(2, 3);
/** Unless --quiet. */
void message_note(const char *format, ...) MESSAGE_FORMAT(1, 2);
/** Only with --verbose. */
void message_detail(const char *format, ...) MESSAGE_FORMAT(1, 2);

/** Every diagnostic of a report; with `file` not NULL those about a key path get their place in it. When a call failed
 *  (`status` not SPH2D_OK) without any error in its report, the status itself is reported. */
void message_report(sph2d_status status, sph2d_report *report, const sph2d_scene_file *file);

/** Shows `text` on the terminal's last line, to be replaced by the next; NULL takes it away. Messages go above it. */
void message_status(const char *text);

/** Whether stderr is a terminal that can redraw a line. */
bool message_terminal(void);

#endif
