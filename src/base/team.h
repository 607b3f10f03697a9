/* SPDX-License-Identifier: MIT */
/** @file team.h
 *  Threads that share loops.
 *
 *  The thread that calls works itself; the others help. A loop is cut into parts of `grain` indices. Each member has a
 *  run of parts of its own, the same in every loop over as many, so that its particles stay in its cache; who is done
 *  takes what others have not begun. So nobody waits for a helper that did not come because another job has its
 *  processor: only for one that has a part in hand.
 *
 *  Helpers start with the first loop that is worth them. They wait for the next loop by spinning for some microseconds
 *  and then asleep, and who waits for them does the same. A team watches its own pace (pace.h) and leaves helpers out
 *  while they bring nothing. Who does what is left to chance: work must give the same bits whatever the parts are. */
#ifndef SPH2D_BASE_TEAM_H
#define SPH2D_BASE_TEAM_H

#include "base/memory.h"

typedef struct sph2d__team sph2d__team;

/** Particles that make a part of a loop which does little to each: some microseconds of work. Loops over pairs take
 *  slabs (particles/neighbours.h). */
enum { SPH2D__GRAIN = 2048 };

/** Processors that this process may use, 1 at least. */
int sph2d__team_processors(void);

/** A team of at most `limit` threads, 1 to 1024, the caller's among them, in memory that sph2d__team_destroy frees.
 *  NULL when memory is short. It belongs to no thread: any may share a loop, one at a time. */
sph2d__team *sph2d__team_create(sph2d__memory *memory, int limit);
/** Ends the helpers and frees the team; NULL is fine. In a process that was forked off, where there are no helpers, it
 *  frees alone. */
void sph2d__team_destroy(sph2d__team *team, sph2d__memory *memory);

/** Lets a team zero large blocks of memory, so that a page comes to lie near the processor that writes to it first:
 *  threads take about the shares of a block that they take of the particles later. NULL: nobody helps. */
void sph2d__team_clears(sph2d__team *team, sph2d__memory *memory);

/** The most threads; 1 for NULL. */
int sph2d__team_limit(const sph2d__team *team);

/** How many threads a loop over `count` indices in parts of `grain` gets now: 1 for NULL and in a loop that is being
 *  shared. */
int sph2d__team_members(const sph2d__team *team, size_t count, size_t grain);

/** What is done to the indices `first` to `last` - 1 of a loop. */
typedef void sph2d__share_work(void *with, size_t first, size_t last);

/** Does it to the indices 0 to `count` - 1, each once, and returns when all is done. Parts begin at multiples of
 *  `grain`, or several are one. */
void sph2d__share(sph2d__team *team, size_t count, size_t grain, sph2d__share_work *work, void *with);

/** Keep other members out while one adds to what they have in common; NULL is fine. */
void sph2d__team_lock(sph2d__team *team);
void sph2d__team_unlock(sph2d__team *team);

/** Surround a stretch of work whose pace is worth watching: a step. */
void sph2d__team_begin(sph2d__team *team);
void sph2d__team_end(sph2d__team *team);

#endif
