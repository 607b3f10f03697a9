/* SPDX-License-Identifier: MIT */
/** @file clock.h
 *  The two clocks for measuring speed. */
#ifndef SPH2D_CLI_CLOCK_H
#define SPH2D_CLI_CLOCK_H

#include <time.h>

static inline double clock_seconds(clockid_t id)
{
    struct timespec now;
    if (clock_gettime(id, &now) != 0)
        return 0;
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/** Wall-clock time [s]. */
static inline double clock_wall(void)
{
    return clock_seconds(CLOCK_MONOTONIC);
}

/** CPU time of this process, all threads together [s]. */
static inline double clock_cpu(void)
{
    return clock_seconds(CLOCK_PROCESS_CPUTIME_ID);
}

#endif
