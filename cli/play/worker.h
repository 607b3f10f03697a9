/* SPDX-License-Identifier: MIT */
/** @file worker.h
 *  A thread that does one thing again and again, while the caller does another. */
#ifndef SPH2D_CLI_PLAY_WORKER_H
#define SPH2D_CLI_PLAY_WORKER_H

typedef struct worker worker;

/** Starts a thread for work(context). NULL: there is none to be had. */
worker *worker_start(void (*work)(void *), void *context);

/** Has the work done once; it ends before worker_wait() returns, and the next begins after that. */
void worker_begin(worker *w);
void worker_wait(worker *w);

/** Ends the thread once its work is done, and frees it; NULL is ignored. */
void worker_stop(worker *w);

#endif
