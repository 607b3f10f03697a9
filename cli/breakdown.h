/* SPDX-License-Identifier: MIT */
/** @file breakdown.h
 *  The last word of the command when it breaks down: in a sentence, with an exit code.
 *
 *  HDF5, libfyaml and Mesa do not survive every failed allocation: they follow a NULL, free a block twice, or call
 *  exit(). The process cannot go on, but files under their final names are complete, as they are written under other
 *  names. So it says what happened and ends with 70 instead of a signal, or of whatever the library passed to
 *  exit(). */
#ifndef SPH2D_CLI_BREAKDOWN_H
#define SPH2D_CLI_BREAKDOWN_H

#include <stdbool.h>

/** Watches the process from now on. To be called first: handlers of exit() run in reverse order. */
void breakdown_watch(void);

/** Whether the sentence is a line of JSON. */
void breakdown_use_json(bool json);

/** All is said and written: exit() is expected, and a breakdown in it changes neither. Returns `code`. */
int breakdown_leave(int code);

#endif
