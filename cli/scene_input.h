/* SPDX-License-Identifier: MIT */
/** @file scene_input.h
 *  Reads the scene that a command is given: a file, or the standard input. */
#ifndef SPH2D_CLI_SCENE_INPUT_H
#define SPH2D_CLI_SCENE_INPUT_H

#include <stdbool.h>

#include <sph2d/io.h>

#include "options.h"

/** Whether an operand is the standard input; a file of that name is "./-". */
bool scene_input_is_stream(const char *operand);

/** Reads the scene of the first operand, with the overrides of --set. Returns as sph2d_scene_file_read(). */
sph2d_status scene_input_read(const cli_options *options, sph2d_scene_file **file, sph2d_report *report);

#endif
