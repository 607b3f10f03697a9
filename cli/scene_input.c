/* SPDX-License-Identifier: MIT */
/** @file scene_input.c
 *  Reads the scene that a command is given. */
#include "scene_input.h"

#include <string.h>
#include <unistd.h>

#include "message.h"

bool scene_input_is_stream(const char *operand)
{
    return strcmp(operand, "-") == 0;
}

sph2d_status scene_input_read(const cli_options *options, sph2d_scene_file **file, sph2d_report *report)
{
    const char *scene = options->operands[0];
    if (!scene_input_is_stream(scene))
        return sph2d_scene_file_read(scene, options->overrides, options->override_count, file, report);
    if (isatty(STDIN_FILENO))
        message_note("reading the scene from the terminal; Ctrl-D on an empty line ends it");
    return sph2d_scene_file_read_open(STDIN_FILENO, "<stdin>", options->overrides, options->override_count, file,
                                      report);
}
