/* SPDX-License-Identifier: MIT */
/** @file threads.c
 *  Choice of the number of threads. */
#include "threads.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#ifdef _OPENMP
#include <omp.h>
#endif

enum { THREADS_MAX = 1024 };

/* As every program with OpenMP: OMP_NUM_THREADS, else the processors that this process may use. */
thread_choice threads_choose(const cli_options *options)
{
#ifdef _OPENMP
    const int wanted = options->threads, most = omp_get_thread_limit();
    const int count = wanted > 0 ? wanted : omp_get_max_threads();
    if (count > most)
        return (thread_choice){wanted, most, "OMP_THREAD_LIMIT"};
    if (wanted > 0)
        return (thread_choice){wanted, wanted, "--threads"};
    return (thread_choice){0, count,
                           getenv("OMP_NUM_THREADS") ? "OMP_NUM_THREADS" : "processors allowed to this process"};
#else
    (void)options;
    return (thread_choice){1, 1, "built without OpenMP"};
#endif
}

void threads_count_caller(void)
{
#pragma omp parallel num_threads(2) /* has one more */
    {
#pragma omp barrier /* an empty region would be left out */
    }
}

int threads_for_frames(const cli_options *options, size_t frames)
{
    int count = 1;
#ifdef _OPENMP
    count = threads_choose(options).count;
    count = frames < (size_t)count ? (int)frames : count;
#endif
    return count > 1 ? count : 1;
}

static void *wait_for_gate(void *gate)
{
    pthread_mutex_lock(gate);
    pthread_mutex_unlock(gate);
    return NULL;
}

/* Whether so many threads can exist at the same time, beside those that do. */
static bool can_start(int count)
{
    pthread_t started[THREADS_MAX];
    pthread_mutex_t gate = PTHREAD_MUTEX_INITIALIZER;
    int n = 0;
    pthread_mutex_lock(&gate);
    while (n < count && n < THREADS_MAX && pthread_create(&started[n], NULL, wait_for_gate, &gate) == 0)
        ++n;
    pthread_mutex_unlock(&gate);
    for (int k = 0; k < n; ++k)
        pthread_join(started[k], NULL);
    return n >= count || n == THREADS_MAX;
}

void threads_draw_here(void)
{
    enum { OTHERS = 4 }; /* its caches and queues have threads, too */
    const char *text = getenv("LP_NUM_THREADS");
    long wanted = text ? strtol(text, NULL, 10) : 0;
    int count = wanted < THREADS_MAX ? (int)(wanted < 0 ? 0 : wanted) : THREADS_MAX;
    if (!text || (count > 0 && !can_start(count + OTHERS)))
        setenv("LP_NUM_THREADS", "0", 1); /* if it fails, Mesa chooses */
}

const char *threads_source(int in_use, const thread_choice *choice)
{
    return choice->wanted == 0 && in_use < choice->count ? "few particles" : choice->source;
}

char *threads_describe(char out[TEXT_SIZE], int in_use, const thread_choice *choice)
{
    snprintf(out, TEXT_SIZE, "%d thread%s (%s)", in_use, in_use == 1 ? "" : "s", threads_source(in_use, choice));
    return out;
}
