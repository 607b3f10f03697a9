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

/** -j, else what OpenMP says: OMP_NUM_THREADS, else the processors that this process may use. */
thread_choice threads_choose(const cli_options *options);

/** Has OpenMP count the calling thread, which is to draw while another one steps. GNU's threads spin while they wait, and take
 *  processors from others, unless it counts more of them than there are processors; then they sleep (GOMP_SPINCOUNT in the
 *  manual of libgomp). */
void threads_count_caller(void);

/** The number of threads that draw `frames` frames in parallel. */
int threads_for_frames(const cli_options *options, size_t frames);

/** Has Mesa's software renderer draw in the calling thread, unless the environment gives it threads (LP_NUM_THREADS) that
 *  can be started: it would wait for them for ever. To be called before drawing is prepared. */
void threads_draw_here(void);

/** Why so many are in use. */
const char *threads_source(int in_use, const thread_choice *choice);

/** "2 threads (--threads)", for the number that is in use. Returns `out`. */
char *threads_describe(char out[TEXT_SIZE], int in_use, const thread_choice *choice);

#endif
