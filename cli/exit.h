/* SPDX-License-Identifier: MIT */
/** @file exit.h
 *  How the command ends: exit codes, the signals that stop it, and its last word when it breaks down.
 *
 *  The table of exit codes is used for the enum, `sph2d help exit` and the tests. Those from 64 up are from sysexits.h, so
 *  that a script can distinguish an invalid scene from a full disk.
 *
 *  SIGINT, SIGTERM and SIGHUP: while a command prepares there is nothing to save, and the first one ends it at once; later
 *  it is noted, and the command stops after its step. The second has its default action. The folders that this process
 *  made are known, so that one which fails or is stopped before it wrote anything leaves none of them.
 *
 *  HDF5, libfyaml and Mesa do not survive every failed allocation: they follow a NULL, free a block twice, or call exit().
 *  The process cannot go on, but files under their final names are complete, as they are written under other names. So it
 *  says what happened and ends with 70 instead of a signal, or of whatever the library passed to exit(). */
#ifndef SPH2D_CLI_EXIT_H
#define SPH2D_CLI_EXIT_H

#include <stdbool.h>

#include <sph2d/status.h>

/* ---- exit codes -------------------------------------------------------------------------------------------------- */

/** Name, value, name in sysexits.h, meaning. */
#define CLI_EXIT_MAP(X)                                                                                                \
    X(SUCCESS, 0, "", "success")                                                                                       \
    X(GUARD, 1, "", "a guard stopped the simulation, or a study missed a bound")                                       \
    X(USAGE, 64, "EX_USAGE", "bad command line")                                                                       \
    X(DATA, 65, "EX_DATAERR", "the content of a scene or snapshot was rejected")                                       \
    X(NOINPUT, 66, "EX_NOINPUT", "an input is missing or unreadable")                                                  \
    X(UNAVAILABLE, 69, "EX_UNAVAILABLE", "rendering, gnuplot or a device is not available")                            \
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

/* ---- folders that were made -------------------------------------------------------------------------------------- */

/** Makes a folder and its parents as far as they do not exist. Returns 0 or an errno. */
int made_folders_make(const char *path);

/** Removes those that are empty, inner ones first: only while the folder is locked, as another process that found it may
 *  use it otherwise. May be called by a signal handler. */
void made_folders_remove(void);

/** Forgets them: they stay. */
void made_folders_keep(void);

/* ---- signals that stop a command --------------------------------------------------------------------------------- */

/** Installs the signal handlers: a signal ends the process with 128 + its number, without the empty folders that it
 *  made. A signal that the parent ignores (nohup, a background job) stays ignored. */
void signals_install(void);

/** Preparation is over: from now on a signal is noted for signals_caught. */
void signals_note(void);

/** Preparation begins in a process that was forked: until signals_note a signal ends it at once. One that was noted
 *  already does so here. */
void signals_prepare(void);

/** The signal caught, SIGINT, SIGTERM or SIGHUP; 0 for none. */
int signals_caught(void);

/** Its name. */
const char *signals_name(int number);

/* ---- breakdowns -------------------------------------------------------------------------------------------------- */

/** Watches the process from now on. To be called first: handlers of exit() run in reverse order. */
void breakdown_watch(void);

/** Whether the sentence is a line of JSON. */
void breakdown_use_json(bool json);

/** All is said and written: exit() is expected, and a breakdown in it changes neither. Returns `code`. */
int breakdown_leave(int code);

#endif
