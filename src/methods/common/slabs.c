/* SPDX-License-Identifier: MIT */
/** @file slabs.c
 *  Work on slabs, shared among threads. */
#include "methods/common/slabs.h"

#include "base/parallel.h"
#include "methods/common/on_device.h"

/** Slab k of a store. */
static sph2d__slab slab_of(sph2d__store *rows, bool walls, size_t k)
{
    size_t first = k * SPH2D__SLAB, last = first + SPH2D__SLAB;
    return (sph2d__slab){rows, walls, first, last < rows->count ? last : rows->count};
}

/* The fewest slabs that are shared among threads, and the most whose sums wait at a time to be added in their order. */
enum { MIN_SLABS = 4, ROUND = 1024 };

/** Work on slabs `from` to `to` - 1 of a store. */
static void over_round(sph2d__system *s, bool walls, size_t from, size_t to, sph2d__slab_work *work, const void *with,
                       sph2d__slab_sum *total)
{
    sph2d__slab_sum sums[ROUND], *all = sums;
#pragma omp taskloop num_tasks(sph2d__tasks(to - from, 1)) if (to - from >= MIN_SLABS) firstprivate(work, all)
    for (size_t k = from; k < to; ++k) {
        const sph2d__slab slab = slab_of(walls ? &s->walls : &s->fluid, walls, k);
        sph2d__slab_sum sum = {0}; /* local while it is added to: adjacent sums share a cache line */
        work(s, &slab, with, &sum);
        all[k - from] = sum;
    }
    for (size_t k = from; k < to; ++k)
        sph2d__slab_add(total, &sums[k - from]);
}

/** Work on all slabs of a store. */
static sph2d__slab_sum over(sph2d__system *s, bool walls, sph2d__slab_work *work, const void *with)
{
    const size_t slabs = sph2d__slabs(walls ? s->walls.count : s->fluid.count);
    sph2d__slab_sum total = {0};
    for (size_t from = 0; from < slabs; from += ROUND)
        over_round(s, walls, from, slabs - from < ROUND ? slabs : from + ROUND, work, with, &total);
    return total;
}

sph2d__slab_sum sph2d__over_fluid(sph2d__system *s, sph2d__slab_work *work, const void *with, const char *kernel,
                                  size_t size)
{
    if (sph2d__is_on_device(s))
        return sph2d__device_work(s, kernel, with, size);
    return over(s, false, work, with);
}

void sph2d__over_fluid_later(sph2d__system *s, sph2d__slab_work *work, const void *with, const char *kernel,
                             size_t size, sph2d__slab_sum *to)
{
    if (sph2d__is_on_device(s))
        sph2d__device_work_later(s, kernel, with, size, to);
    else
        *to = over(s, false, work, with);
}

void sph2d__sums_settle(sph2d__system *s)
{
    if (sph2d__is_on_device(s))
        sph2d__device_settle(s->device);
}

void sph2d__each_of_fluid(sph2d__system *s, sph2d__slab_work *work, const void *with, const char *kernel, size_t size)
{
    if (sph2d__is_on_device(s))
        sph2d__device_span_with(s, kernel, s->fluid.count, with, size);
    else
        over(s, false, work, with);
}

sph2d__slab_sum sph2d__sum_fluid(const sph2d__system *s, sph2d__slab_work *work, const void *with)
{
    sph2d__system same = *s;
    return over(&same, false, work, with);
}

sph2d__slab_sum sph2d__over_rows(sph2d__system *s, sph2d__slab_work *work, const void *with)
{
    sph2d__slab_sum total = over(s, false, work, with);
    if (s->walls_press) {
        const sph2d__slab_sum of_walls = over(s, true, work, with);
        sph2d__slab_add(&total, &of_walls);
    }
    return total;
}

static void over_slab(sph2d__system *s, size_t k, size_t count, sph2d__span_work *work)
{
    const size_t first = k * SPH2D__SLAB, last = first + SPH2D__SLAB;
    work(s, first, last < count ? last : count);
}

void sph2d__over_particles(sph2d__system *s, size_t count, sph2d__span_work *work, const char *kernel)
{
    if (sph2d__is_on_device(s)) {
        sph2d__device_span(s, kernel, count);
        return;
    }
    size_t slabs = sph2d__slabs(count);
#pragma omp taskloop num_tasks(sph2d__tasks(slabs, 1)) if (slabs >= MIN_SLABS) firstprivate(work)
    for (size_t k = 0; k < slabs; ++k)
        over_slab(s, k, count, work);
}

void sph2d__begin_over_particles(sph2d__system *s, size_t count, sph2d__span_work *work, const char *kernel)
{
    if (sph2d__is_on_device(s)) {
        sph2d__device_span(s, kernel, count);
        return;
    }
    size_t slabs = sph2d__slabs(count);
#pragma omp taskloop nogroup num_tasks(sph2d__tasks(slabs, 1)) if (slabs >= MIN_SLABS) firstprivate(work)
    for (size_t k = 0; k < slabs; ++k)
        over_slab(s, k, count, work);
}
