/* SPDX-License-Identifier: MIT */
/** @file threads.c
 *  Choice of the number of threads. */
#define _GNU_SOURCE /* sched_getaffinity */
#include "threads.h"

#include <pthread.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

enum { THREADS_MAX = 1024 };

/* OMP_NUM_THREADS may be a list, one number per nesting level, of which the first is used. 0 if there is none. */
static int environment_threads(void)
{
    const char *text = getenv("OMP_NUM_THREADS");
    if (!text)
        return 0;
    char *end;
    long count = strtol(text, &end, 10);
    return end != text && (*end == '\0' || *end == ',') && count >= 1 && count <= THREADS_MAX ? (int)count : 0;
}

/* 0 if unknown. */
static int affinity_threads(void)
{
    cpu_set_t set;
    if (sched_getaffinity(0, sizeof set, &set) != 0)
        return 0;
    return CPU_COUNT(&set);
}

static thread_choice choose(const cli_options *options)
{
    int count = options->threads;
    if (count > 0)
        return (thread_choice){count, "--threads"};
    if ((count = environment_threads()) > 0)
        return (thread_choice){count, "OMP_NUM_THREADS"};
    if ((count = affinity_threads()) > 0)
        return (thread_choice){count, "processors allowed to this process"};
    long online = sysconf(_SC_NPROCESSORS_ONLN);
    return (thread_choice){online < 1 ? 1 : online > THREADS_MAX ? THREADS_MAX : (int)online, "processors online"};
}

thread_choice threads_choose(const cli_options *options)
{
    thread_choice choice = choose(options);
    char count[16];
    snprintf(count, sizeof count, "%d", choice.count);
    setenv("LP_NUM_THREADS", count, 0); /* if it fails, Mesa chooses */
    return choice;
}

int threads_for_frames(const cli_options *options, size_t frames)
{
    int count = 1;
#ifdef _OPENMP
    count = choose(options).count;
    count = frames < (size_t)count ? (int)frames : count;
#endif
    if (count > 1)
        setenv("LP_NUM_THREADS", "0", 0); /* Mesa draws in the calling thread */
    else
        threads_choose(options);
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

void threads_check_mesa(void)
{
    enum { OTHERS = 4 }; /* its caches and queues have threads, too */
    const char *text = getenv("LP_NUM_THREADS");
    long wanted = text ? strtol(text, NULL, 10) : affinity_threads();
    int count = wanted < THREADS_MAX ? (int)(wanted < 0 ? 0 : wanted) : THREADS_MAX;
    if (count > 0 && !can_start(count + OTHERS))
        setenv("LP_NUM_THREADS", "0", 1);
}

char *threads_describe(char out[TEXT_SIZE], int count, const thread_choice *choice)
{
    snprintf(out, TEXT_SIZE, "%d thread%s (%s)", count, count == 1 ? "" : "s", choice->source);
    return out;
}
