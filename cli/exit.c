/* SPDX-License-Identifier: MIT */
/** @file exit.c
 *  Maps the library's status to the process's exit code. */
#include "exit.h"

int exit_of_status(sph2d_status status)
{
    /* Without a default, so that the compiler warns about a missing status. */
    switch (status) {
    case SPH2D_OK:
        return CLI_EXIT_SUCCESS;
    case SPH2D_GUARD:
        return CLI_EXIT_GUARD;
    case SPH2D_SCENE:
    case SPH2D_FORMAT:
        return CLI_EXIT_DATA;
    case SPH2D_NOINPUT:
        return CLI_EXIT_NOINPUT;
    case SPH2D_RENDER:
        return CLI_EXIT_UNAVAILABLE;
    case SPH2D_CANTCREAT:
        return CLI_EXIT_CANTCREAT;
    case SPH2D_IO:
        return CLI_EXIT_IO;
    /* The command line is already checked, so an invalid argument is a bug of the command. */
    case SPH2D_INVALID:
    case SPH2D_NOMEM:
        break;
    }
    return CLI_EXIT_SOFTWARE;
}
