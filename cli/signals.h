/* SPDX-License-Identifier: MIT */
/** @file signals.h
 *  The first SIGINT or SIGTERM stops a run after its step; the second has its default action. */
#ifndef SPH2D_CLI_SIGNALS_H
#define SPH2D_CLI_SIGNALS_H

/** Installs the signal handlers. A signal that the parent ignores (nohup, a background job) stays ignored. */
void signals_install(void);

/** The signal caught, SIGINT or SIGTERM; 0 for none. */
int signals_caught(void);

#endif
