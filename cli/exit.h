/* SPDX-License-Identifier: MIT */
/** @file exit.h
 *  The table of exit codes, used for the enum, `sph2d help exit` and the tests. Those from 64 up are from sysexits.h,
 *  so that a script can distinguish an invalid scene from a full disk. */
#ifndef SPH2D_CLI_EXIT_H
#define SPH2D_CLI_EXIT_H

#include <sph2d/status.h>

/** Name, value, name in sysexits.h, meaning. */
#define CLI_EXIT_MAP(X)                                                                                                \
    X(SUCCESS, 0, "", "success")                                                                                       \
    X(GUARD, 1, "", "a guard stopped the simulation, or a study missed a bound")                                       \
    X(USAGE, 64, "EX_USAGE", "bad command line")                                                                       \
    X(DATA, 65, "EX_DATAERR", "the content of a scene or snapshot was rejected")                                       \
    X(NOINPUT, 66, "EX_NOINPUT", "an input is missing or unreadable")                                                  \
    X(UNAVAILABLE, 69, "EX_UNAVAILABLE", "rendering or gnuplot is not available")                                      \
    X(SOFTWARE, 70, "EX_SOFTWARE", "internal error, or out of memory")                                                 \
    X(CANTCREAT, 73, "EX_CANTCREAT", "an output cannot be created")                                                    \
    X(IO, 74, "EX_IOERR", "reading or writing failed")                                                                 \
    X(STOPPED, 75, "EX_TEMPFAIL", "stopped by --max-wall with a checkpoint; 'sph2d resume' continues")                 \
    X(HUNG_UP, 129, "", "stopped by SIGHUP with a checkpoint; 'sph2d resume' continues")                               \
    X(INTERRUPTED, 130, "", "stopped by SIGINT with a checkpoint; 'sph2d resume' continues")                           \
    X(TERMINATED, 143, "", "stopped by SIGTERM with a checkpoint; 'sph2d resume' continues")

enum {
#define CLI__EXIT_ENUM(name, value, sysexit, text) CLI_EXIT_##name = (value),
    CLI_EXIT_MAP(CLI__EXIT_ENUM)
#undef CLI__EXIT_ENUM
};

/** The exit code for a status of the library. */
int exit_of_status(sph2d_status status);

#endif
