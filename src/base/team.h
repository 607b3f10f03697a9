/* SPDX-License-Identifier: MIT */
/** @file team.h
 *  A thread pool for parallel loops.
 *
 *  The calling thread works, too. A loop is cut into chunks of `grain` indices. Each thread (member) has a run of
 *  consecutive chunks, the same in every loop of that length, so that its particles stay in its cache; a thread that is
 *  done takes chunks that others have not begun (work stealing). The caller therefore waits only for workers that are
 *  busy with a chunk, not for one that has not started because another job has its processor.
 *
 *  Workers are started by the first loop that is long enough. They wait for the next loop by spinning for some
 *  microseconds and then asleep, and so does the caller for them. A team measures its throughput (pace.h) and uses
 *  fewer threads where that is faster. Which thread works on which chunk is not defined: the result must not depend on
 *  it. */
#ifndef SPH2D_BASE_TEAM_H
#define SPH2D_BASE_TEAM_H

#include "base/memory.h"

typedef struct sph2d__team sph2d__team;

/** Chunk size of loops that do little to each particle: some microseconds of work. Loops over pairs use slabs
 *  (particles/neighbours.h). */
enum { SPH2D__GRAIN = 2048 };

/** Processors that this process may use, at least 1. */
int sph2d__team_processors(void);

/** A team of at most `limit` threads, 1 to 1024, with the caller's; sph2d__team_destroy frees it. NULL when memory is
 *  short. Any thread may run a loop, one at a time. */
sph2d__team *sph2d__team_create(sph2d__memory *memory, int limit);
/** Ends the workers and frees the team, which may be NULL. In a forked child, which has no workers, it only frees. */
void sph2d__team_destroy(sph2d__team *team, sph2d__memory *memory);

/** Lets a team zero large blocks of memory, so that each page lies near the processor that will use it (first touch):
 *  threads get about the same shares of a block as of the particles later. NULL: the calling thread alone. */
void sph2d__team_clears(sph2d__team *team, sph2d__memory *memory);

/** The maximum number of threads; 1 for NULL. */
int sph2d__team_limit(const sph2d__team *team);

/** How many threads a loop over `count` indices in chunks of `grain` gets now: 1 for NULL and inside another loop. */
int sph2d__team_members(const sph2d__team *team, size_t count, size_t grain);

/** The body of a loop for the indices `first` to `last` - 1. */
typedef void sph2d__share_work(void *with, size_t first, size_t last);

/** Runs a loop over the indices 0 to `count` - 1 and returns when it is done. Chunks begin at multiples of `grain`; one
 *  call may get several of them at once. */
void sph2d__share(sph2d__team *team, size_t count, size_t grain, sph2d__share_work *work, void *with);

/** A lock for results that the members share; the team may be NULL. */
void sph2d__team_lock(sph2d__team *team);
void sph2d__team_unlock(sph2d__team *team);

/** Enclose work whose throughput is measured: a step. */
void sph2d__team_begin(sph2d__team *team);
void sph2d__team_end(sph2d__team *team);

#endif
