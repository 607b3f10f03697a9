/* SPDX-License-Identifier: MIT */
/** @file signals.h
 *  SIGINT, SIGTERM and SIGHUP. While a command prepares there is nothing to save, and the first one ends it at once;
 *  later it is noted, and the command stops after its step. The second has its default action. */
#ifndef SPH2D_CLI_SIGNALS_H
#define SPH2D_CLI_SIGNALS_H

/** Installs the signal handlers: a signal ends the process with 128 + its number, without the empty folders that it
 *  made (made_folders.h). A signal that the parent ignores (nohup, a background job) stays ignored. */
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

#endif
