/* SPDX-License-Identifier: MIT */
/** @file threads.h
 *  How many threads. */
#ifndef SPH2D_CLI_THREADS_H
#define SPH2D_CLI_THREADS_H

#include "options.h"
#include "text.h"

/** A number of threads, and where it comes from, in words. */
typedef struct thread_choice {
    int count;
    const char *source;
} thread_choice;

/** -j, else OMP_NUM_THREADS, else the processors that this process may use. Also tells the software renderer, unless
 *  the environment does (LP_NUM_THREADS). */
thread_choice threads_choose(const cli_options *options);

/** How many threads draw so many more frames side by side; tells the software renderer to draw each in its own. */
int threads_for_frames(const cli_options *options, size_t frames);

/** "2 threads (--threads)", for the number that is in use. Returns `out`. */
char *threads_describe(char out[TEXT_SIZE], int count, const thread_choice *choice);

#endif
