/* SPDX-License-Identifier: MIT */
/** @file slabs.c
 *  Work on slabs, shared among threads. */
#include "methods/common/slabs.h"

/** Slab k of a store. */
static sph2d__slab slab_of(sph2d__store *rows, bool walls, size_t k)
{
    size_t first = k * SPH2D__SLAB, last = first + SPH2D__SLAB;
    return (sph2d__slab){rows, walls, first, last < rows->count ? last : rows->count};
}

/* The fewest slabs that are shared among threads. */
enum { MIN_SLABS = 4 };

/** The team for this number of slabs; NULL: one thread. */
static sph2d__team *team_for(const sph2d__system *s, size_t slabs)
{
    return slabs < MIN_SLABS ? NULL : s->team;
}

/** Work on slabs: those of the fluid, then those of the boundary particles. */
typedef struct task {
    sph2d__system *system;
    size_t fluid;
    sph2d__slab_work *work;
    const void *with;
} task;

static void do_slabs(void *task_, size_t first, size_t last)
{
    const task *t = task_;
    sph2d__system *s = t->system;
    for (size_t k = first; k < last; ++k) {
        sph2d__slab slab = k < t->fluid ? slab_of(&s->fluid, false, k) : slab_of(&s->walls, true, k - t->fluid);
        sph2d__slab_sum sum = {0}; /* local while it is added to: adjacent sums share a cache line */
        t->work(s, &slab, t->with, &sum);
        *(k < t->fluid ? &s->neighbours.sums[k] : &s->wall_neighbours.sums[k - t->fluid]) = sum;
    }
}

static sph2d__slab_sum over(sph2d__system *s, size_t fluid, size_t walls, sph2d__slab_work *work, const void *with)
{
    sph2d__share(team_for(s, fluid + walls), fluid + walls, 1, do_slabs, &(task){s, fluid, work, with});
    sph2d__slab_sum total = sph2d__neighbours_total(&s->neighbours, fluid);
    sph2d__slab_sum of_walls = sph2d__neighbours_total(&s->wall_neighbours, walls);
    total.first += of_walls.first;
    total.second += of_walls.second;
    total.third += of_walls.third;
    total.most = of_walls.most > total.most ? of_walls.most : total.most;
    return total;
}

sph2d__slab_sum sph2d__over_fluid(sph2d__system *s, sph2d__slab_work *work, const void *with)
{
    return over(s, sph2d__slabs(s->fluid.count), 0, work, with);
}

sph2d__slab_sum sph2d__over_rows(sph2d__system *s, sph2d__slab_work *work, const void *with)
{
    size_t walls = s->walls_press ? sph2d__slabs(s->walls.count) : 0;
    return over(s, sph2d__slabs(s->fluid.count), walls, work, with);
}

/** Work on the particles of a store. */
typedef struct span {
    sph2d__system *system;
    size_t count;
    sph2d__span_work *work;
} span;

static void do_spans(void *span_, size_t first, size_t last)
{
    const span *t = span_;
    for (size_t k = first; k < last; ++k) {
        size_t end = (k + 1) * SPH2D__SLAB;
        t->work(t->system, k * SPH2D__SLAB, end < t->count ? end : t->count);
    }
}

void sph2d__over_particles(sph2d__system *s, size_t count, sph2d__span_work *work)
{
    size_t slabs = sph2d__slabs(count);
    sph2d__share(team_for(s, slabs), slabs, 1, do_spans, &(span){s, count, work});
}
