/* SPDX-License-Identifier: MIT */
/** @file none.c
 *  `sph2d play` in a build without windows: a sentence that says what to install. */
#include "../command.h"
#include "../exit.h"
#include "../message.h"

int command_play(const cli_options *options)
{
    (void)options;
    message_error(SPH2D_CODE_GL_MISSING,
                  "install GLFW (Debian: apt install libglfw3-dev) and build sph2d again, with RENDER=1; "
                  "'sph2d run' draws frames without it",
                  "this build of sph2d has no windows");
    return exit_of_status(SPH2D_RENDER);
}
