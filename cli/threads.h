/* SPDX-License-Identifier: MIT */
/** @file threads.h
 *  Choice of the number of threads. */
#ifndef SPH2D_CLI_THREADS_H
#define SPH2D_CLI_THREADS_H

#include "options.h"
#include "text.h"

/** A number of threads. */
typedef struct thread_choice {
    int wanted;         /**< by --threads; 0: the library chooses `count` or, where there are few particles, fewer */
    int count;          /**< the largest number */
    const char *source; /**< where it is from */
} thread_choice;

/** -j, else what OpenMP says: OMP_NUM_THREADS, else the processors that this process may use. Also sets the threads of
 *  the software renderer, unless the environment does (LP_NUM_THREADS). */
thread_choice threads_choose(const cli_options *options);

/** Starts the program again with OMP_WAIT_POLICY=passive, unless the environment says how threads wait: those of GNU's OpenMP
 *  spin, and take the processors from threads that draw; it asks only when a program is loaded. Returns where that is
 *  not possible. To be called before anything else. */
void threads_wait_passively(char **argv);

/** The number of threads that draw `frames` frames in parallel; the software renderer then uses one thread for each. */
int threads_for_frames(const cli_options *options, size_t frames);

/** Where the threads of Mesa's renderer cannot be started, it draws in the calling thread: it would wait for them for
 *  ever. To be called before drawing is prepared. */
void threads_check_mesa(void);

/** Why so many are in use. */
const char *threads_source(int in_use, const thread_choice *choice);

/** "2 threads (--threads)", for the number that is in use. Returns `out`. */
char *threads_describe(char out[TEXT_SIZE], int in_use, const thread_choice *choice);

#endif
