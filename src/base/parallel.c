/* SPDX-License-Identifier: MIT */
/** @file parallel.c
 *  Limits of OpenMP, and its threads across a fork. */
#include "base/parallel.h"

#ifdef _OPENMP

#include <pthread.h>

int sph2d__max_threads(int wanted)
{
    int most = omp_get_thread_limit(), threads = wanted > 0 ? wanted : omp_get_max_threads();
    return threads < most ? threads : most;
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
