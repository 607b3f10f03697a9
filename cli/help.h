/* SPDX-License-Identifier: MIT */
/** @file help.h
 *  The texts of --help and --version, printed to stdout. */
#ifndef SPH2D_CLI_HELP_H
#define SPH2D_CLI_HELP_H

#include "command.h"

/** All commands. */
void help_print(void);
/** One command: what it does, its options, examples. */
void help_print_command(const cli_command *about);
/** Version, licence and features of the build. */
void help_print_version(bool json);

#endif
