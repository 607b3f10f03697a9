/* SPDX-License-Identifier: MIT */
/** @file parallel.c
 *  Limits of OpenMP, and its threads across a fork. */
#define _GNU_SOURCE /* gettid */
#include "base/parallel.h"

#include <stdbool.h>

#ifdef _OPENMP

#include <pthread.h>
#include <unistd.h>

/** Whether the calling thread may have others do its tasks. In LLVM's runtime, at least from 14 to 19, threads keep the
 *  memory of tasks that they have done, and use it after the thread that made these has ended: there only the thread of
 *  main() may, which lasts. */
static bool may_share(void)
{
#if defined(__clang__) && defined(__linux__)
    return gettid() == getpid();
#else
    return true;
#endif
}

int sph2d__max_threads(int wanted)
{
    int most = omp_get_thread_limit(), threads = wanted > 0 ? wanted : omp_get_max_threads();
    return !may_share() ? 1 : threads < most ? threads : most;
}

static void end_threads(void)
{
    omp_pause_resource_all(omp_pause_soft); /* fails inside a region: nothing can be done for a fork there */
}

static void register_fork(void)
{
    pthread_atfork(end_threads, NULL, NULL);
}

void sph2d__prepare_threads(void)
{
    static pthread_once_t once = PTHREAD_ONCE_INIT;
    pthread_once(&once, register_fork);
}

#else

int sph2d__max_threads(int wanted)
{
    (void)wanted;
    return 1;
}

void sph2d__prepare_threads(void)
{
}

#endif
