/* SPDX-License-Identifier: MIT */
/** @file threads.h
 *  How many threads a loop is worth. */
#ifndef SPH2D_BASE_THREADS_H
#define SPH2D_BASE_THREADS_H

#include <stddef.h>

/** Particles below which a second thread costs more than it brings. */
enum { SPH2D__GRAIN = 1024 };

/** Threads for a loop over `count` particles, 1 to `limit`: waking a thread costs microseconds, so that short loops run
 *  on one. */
static inline int sph2d__threads_for(int limit, size_t count)
{
    size_t worth = count / SPH2D__GRAIN;
    return worth < 1 ? 1 : worth < (size_t)limit ? (int)worth : limit;
}

#endif
