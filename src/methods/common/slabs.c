/* SPDX-License-Identifier: MIT */
/** @file slabs.c
 *  Work on slabs, shared among threads. */
#include "methods/common/slabs.h"

#include "base/parallel.h"

/** Slab k of a store. */
static sph2d__slab slab_of(sph2d__store *rows, bool walls, size_t k)
{
    size_t first = k * SPH2D__SLAB, last = first + SPH2D__SLAB;
    return (sph2d__slab){rows, walls, first, last < rows->count ? last : rows->count};
}

/* The fewest slabs that are shared among threads. */
enum { MIN_SLABS = 4 };

/** Work on slabs: `fluid` of the fluid, then `walls` of the boundary particles. */
static sph2d__slab_sum over(sph2d__system *s, size_t fluid, size_t walls, sph2d__slab_work *work, const void *with)
{
    size_t slabs = fluid + walls;
#pragma omp taskloop num_tasks(sph2d__tasks(slabs, 1)) if (slabs >= MIN_SLABS) firstprivate(work)
    for (size_t k = 0; k < slabs; ++k) {
        sph2d__slab slab = k < fluid ? slab_of(&s->fluid, false, k) : slab_of(&s->walls, true, k - fluid);
        sph2d__slab_sum sum = {0}; /* local while it is added to: adjacent sums share a cache line */
        work(s, &slab, with, &sum);
        *(k < fluid ? &s->neighbours.sums[k] : &s->wall_neighbours.sums[k - fluid]) = sum;
    }
    sph2d__slab_sum total = sph2d__neighbours_total(&s->neighbours, fluid);
    sph2d__slab_sum of_walls = sph2d__neighbours_total(&s->wall_neighbours, walls);
    total.first += of_walls.first;
    total.second += of_walls.second;
    total.third += of_walls.third;
    total.fourth += of_walls.fourth;
    total.x += of_walls.x;
    total.y += of_walls.y;
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

static void over_slab(sph2d__system *s, size_t k, size_t count, sph2d__span_work *work)
{
    const size_t first = k * SPH2D__SLAB, last = first + SPH2D__SLAB;
    work(s, first, last < count ? last : count);
}

void sph2d__over_particles(sph2d__system *s, size_t count, sph2d__span_work *work)
{
    size_t slabs = sph2d__slabs(count);
#pragma omp taskloop num_tasks(sph2d__tasks(slabs, 1)) if (slabs >= MIN_SLABS) firstprivate(work)
    for (size_t k = 0; k < slabs; ++k)
        over_slab(s, k, count, work);
}

void sph2d__begin_over_particles(sph2d__system *s, size_t count, sph2d__span_work *work)
{
    size_t slabs = sph2d__slabs(count);
#pragma omp taskloop nogroup num_tasks(sph2d__tasks(slabs, 1)) if (slabs >= MIN_SLABS) firstprivate(work)
    for (size_t k = 0; k < slabs; ++k)
        over_slab(s, k, count, work);
}
