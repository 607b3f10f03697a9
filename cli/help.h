/* SPDX-License-Identifier: MIT */
/** @file help.h
 *  What --help and --version print, to stdout. */
#ifndef SPH2D_CLI_HELP_H
#define SPH2D_CLI_HELP_H

#include "command.h"

/** All commands. */
void help_print(void);
/** One command: what it does, its options, examples. */
void help_print_command(const cli_command *about);
/** Version, licence and what the build has. */
void help_print_version(bool json);

#endif
