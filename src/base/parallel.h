/* SPDX-License-Identifier: MIT */
/** @file parallel.h
 *  Threads: OpenMP shares the loops, and nothing else starts a thread.
 *
 *  A step, or another call that has loops to share, is one parallel region, and the calling thread runs its code:
 *
 *      #pragma omp parallel num_threads(threads)
 *      #pragma omp master
 *      status = step(sim);
 *
 *  Its loops are `taskloop`s, whose tasks any thread of the region takes, the caller as well:
 *
 *      #pragma omp taskloop num_tasks(sph2d__tasks(count, SPH2D__GRAIN)) if (count > SPH2D__GRAIN)
 *      for (size_t i = 0; i < count; ++i)
 *          ...
 *
 *  The end of a taskloop waits for tasks that have begun, not for threads: one whose processor another job has delays a
 *  loop only if it was stopped in the middle of a task. Regions or worksharing loops wait for every thread at every loop
 *  (tests/bench/README.md has the times of all three). A variable of the function is copied into the tasks unless it is
 *  named in shared(); a pointer to a function must be named in firstprivate(), without which Clang 14 breaks down.
 *
 *  Which thread does what is not defined, so results must not depend on it: a loop writes only what belongs to its own
 *  index (gather form), and sums are those of fixed parts, added in their order. Extremes and whole numbers may also be
 *  joined in any order, under `#pragma omp critical`.
 *
 *  Without OpenMP the pragmas vanish. */
#ifndef SPH2D_BASE_PARALLEL_H
#define SPH2D_BASE_PARALLEL_H

#include <stddef.h>

#ifdef _OPENMP
#include <omp.h>
#endif

/** The fewest iterations that are worth a task, some microseconds: in loops that do little to each particle, and in
 *  those that look at its neighbours. Loops over all pairs use slabs (particles/neighbours.h). */
enum { SPH2D__GRAIN = 2048, SPH2D__LOOK_GRAIN = 128 };

/** The threads of the region that the caller is in; 1 outside. */
static inline int sph2d__threads(void)
{
#ifdef _OPENMP
    return omp_get_num_threads();
#else
    return 1;
#endif
}

/** The number of tasks for a loop, each of at least `grain` iterations: four for each thread, so that one that comes late
 *  leaves its part to the others, and in long loops up to sixteen, so that none waits long for the last task. */
static inline int sph2d__tasks(size_t count, size_t grain)
{
    size_t threads = (size_t)sph2d__threads(), worth = count / grain, tasks = worth / 8;
    tasks = tasks < 4 * threads ? 4 * threads : tasks > 16 * threads ? 16 * threads : tasks;
    return (int)(worth < 1 ? 1 : worth < tasks ? worth : tasks);
}

/** The number of threads to ask for in a region of the caller: that wanted, or where it is 0 that of OpenMP
 *  (OMP_NUM_THREADS, else the processors that the process may use); at most OMP_THREAD_LIMIT. 1 without OpenMP, and with
 *  LLVM's runtime (clang) on other threads than that of main(). */
int sph2d__max_threads(int wanted);

/** To be called before the first region: makes fork() safe. GNU's OpenMP has no threads in the child, but would wait for
 *  them; so those of the calling thread are ended before a fork, and started again when they are needed. */
void sph2d__prepare_threads(void);

#endif
