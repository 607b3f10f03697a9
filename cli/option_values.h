/* SPDX-License-Identifier: MIT */
/** @file option_values.h
 *  What options mean: from one option and its argument to a member of cli_options. */
#ifndef SPH2D_CLI_OPTION_VALUES_H
#define SPH2D_CLI_OPTION_VALUES_H

#include <stdbool.h>

#include "options.h"

/** Sets the option `id` (option_table.h); `value` is its argument, NULL if it takes none, is borrowed, and may be cut in
 *  two. `name` is the command's, for messages. False after an error, which is reported. */
bool option_values_set(cli_options *options, const char *name, int id, char *value);

#endif
