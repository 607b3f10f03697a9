/* SPDX-License-Identifier: MIT */
/** @file slabs.c
 *  Sharing slabs among threads. */
#include "methods/slabs.h"

#include "base/threads.h"

/** Slab k of a store. */
static sph2d__slab slab_of(sph2d__store *rows, bool walls, size_t k)
{
    size_t first = k * SPH2D__SLAB, last = first + SPH2D__SLAB;
    return (sph2d__slab){rows, walls, first, last < rows->count ? last : rows->count};
}

static sph2d__slab_sum over(sph2d__system *s, size_t fluid, size_t walls, sph2d__slab_work *work, const void *with)
{
    int threads = sph2d__threads_for(s->threads, (fluid + walls) * SPH2D__SLAB);
#pragma omp parallel for schedule(dynamic) num_threads(threads) if (threads > 1)
    for (size_t k = 0; k < fluid + walls; ++k) {
        sph2d__slab slab = k < fluid ? slab_of(&s->fluid, false, k) : slab_of(&s->walls, true, k - fluid);
        sph2d__slab_sum sum = {0}; /* of its own while it is added to: neighbours would share its cache line */
        work(s, &slab, with, &sum);
        *(k < fluid ? &s->neighbours.sums[k] : &s->wall_neighbours.sums[k - fluid]) = sum;
    }
    sph2d__slab_sum total = sph2d__neighbours_total(&s->neighbours, fluid);
    sph2d__slab_sum beside = sph2d__neighbours_total(&s->wall_neighbours, walls);
    total.first += beside.first;
    total.second += beside.second;
    total.third += beside.third;
    total.most = beside.most > total.most ? beside.most : total.most;
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

/* Each thread takes the same part in every loop, so that its particles stay in its cache. */
void sph2d__over_particles(sph2d__system *s, size_t count, sph2d__span_work *work)
{
    int threads = sph2d__threads_for(s->threads, count);
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
    for (size_t first = 0; first < count; first += SPH2D__SLAB)
        work(s, first, first + SPH2D__SLAB < count ? first + SPH2D__SLAB : count);
}
