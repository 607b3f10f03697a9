/* SPDX-License-Identifier: MIT */
/** @file signals.h
 *  The first SIGINT or SIGTERM asks a run to stop after its step; the second does what it always does. */
#ifndef SPH2D_CLI_SIGNALS_H
#define SPH2D_CLI_SIGNALS_H

/** From now on signals are caught. One that the parent had switched off (nohup, a shell's background job) stays off. */
void signals_install(void);

/** SIGINT, SIGTERM, or 0 when none came. */
int signals_caught(void);

#endif
