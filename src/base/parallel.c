/* SPDX-License-Identifier: MIT */
/** @file parallel.c
 *  Limits of OpenMP, and its threads across a fork. */
#include "base/parallel.h"

#include <stdbool.h>

#ifdef _OPENMP

#include "base/system.h"

/** Whether the calling thread may have others do its tasks. In LLVM's runtime, at least from 14 to 19, threads keep the
 *  memory of tasks that they have done, and use it after the thread that made these has ended: there only the thread of
 *  main() may, which lasts. */
static bool may_share(void)
{
#ifdef __clang__
    return sph2d__on_main_thread();
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

void sph2d__prepare_threads(void)
{
    static bool prepared = false;
#pragma omp critical(sph2d__fork)
    if (!prepared) {
        sph2d__before_fork(end_threads);
        prepared = true;
    }
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
