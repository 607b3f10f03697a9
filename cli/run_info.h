/* SPDX-License-Identifier: MIT */
/** @file run_info.h
 *  What `sph2d info` tells of the folder of a run. */
#ifndef SPH2D_CLI_RUN_INFO_H
#define SPH2D_CLI_RUN_INFO_H

#include "options.h"

/** Prints scene, state and files of the run in a folder, as a table or as JSON, and changes nothing in it. Returns an
 *  exit code; a folder without a complete snapshot is an error. */
int run_info_print(const cli_options *options, const char *path);

#endif
