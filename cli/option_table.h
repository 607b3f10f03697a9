/* SPDX-License-Identifier: MIT */
/** @file option_table.h
 *  All options, one a row: which commands take them, what help and completions say of them (option_table.c), and what they
 *  mean, from an option and its argument to a member of cli_options (option_values.c). */
#ifndef SPH2D_CLI_OPTION_TABLE_H
#define SPH2D_CLI_OPTION_TABLE_H

#include <stdbool.h>
#include <stddef.h>

#include "options.h"

/** Options without a short form. */
enum {
    OPTION_JSON = 256,
    OPTION_NO_COLOR,
    OPTION_PROGRESS,
    OPTION_ISA,
    OPTION_MAX_WALL,
    OPTION_NO_FRAMES,
    OPTION_NO_CHECKSUM,
    OPTION_GL,
    OPTION_SHADER_DIR,
    OPTION_SIZE,
    OPTION_STYLE,
    OPTION_LOOK,
    OPTION_BACKGROUND,
    OPTION_VIEW,
    OPTION_FOLLOW,
    OPTION_ARROWS,
    OPTION_STREAMLINES,
    OPTION_ISOLINES,
    OPTION_RADIUS,
    OPTION_COLOR,
    OPTION_RANGE,
    OPTION_FILM,
    OPTION_FPS,
    OPTION_PREVIEW,
    OPTION_TEMPLATE,
    OPTION_ALL,
    OPTION_TARGET,
    OPTION_REPEAT,
    OPTION_PROFILE,
    OPTION_SHARD,
    OPTION_DEVICE,
    OPTION_SAME_BITS
};

/** An option as a row of the table. */
typedef struct option_row {
    int id;               /**< its letter, or a number above 255 */
    const char *name;     /**< the long name */
    const char *argument; /**< what it is called in help; NULL: none */
    unsigned commands;    /**< bits of the commands that take it */
    const char *text;
} option_row;

/** No table has more rows. */
enum { OPTION_ROWS_MAX = 80 };

/** Row number `i` of the table; NULL beyond its end. */
const option_row *options_row(size_t i);

/** The values that an option can have, NULL-terminated, in the order of their enum; NULL if there is no list of them
 *  here. */
const char *const *options_words(int id);

/** Prints the options that a command takes, one a line, to stdout. */
void options_print(unsigned command);

/** Sets the option `id` (option_table.h); `value` is its argument, NULL if it takes none, is borrowed, and may be cut in
 *  two. `name` is the command's, for messages. False after an error, which is reported. */
bool option_values_set(cli_options *options, const char *name, int id, char *value);

#endif
