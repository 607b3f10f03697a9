/* SPDX-License-Identifier: MIT */
/** @file slabs.h
 *  Work on particles in slabs, and on the rows of a pressure solver: fluid particles, and boundary particles that exert
 *  pressure. Threads share the slabs; the sums of the slabs are added in a fixed order.
 *
 *  Pair loops are separate functions called by pointer, so that the kernel is a constant in each. */
#ifndef SPH2D_METHODS_COMMON_SLABS_H
#define SPH2D_METHODS_COMMON_SLABS_H

#include "methods/common/slab.h"

/** Work on a slab; `sum` is zero at first. */
typedef void sph2d__slab_work(sph2d__system *system, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum);

/** Defines such work by that on one particle: an expression with s, i, with and sum. */
#define SPH2D__SLAB_WORK(name, expression)                                                                             \
    static void name(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)                \
    {                                                                                                                  \
        (void)with;                                                                                                    \
        (void)sum;                                                                                                     \
        for (size_t i = slab->first; i < slab->last; ++i)                                                              \
            expression;                                                                                                \
    }

/** Calls `work` on every slab of the fluid; returns the total of the sums. Where a device has the particles, runs its kernel of that
 *  name (on_device.h) with `size` bytes of `with`; NULL in methods that devices do not know. */
sph2d__slab_sum sph2d__over_fluid(sph2d__system *system, sph2d__slab_work *work, const void *with, const char *kernel,
                                  size_t size);

/** The same, whose total is at *to later: when sph2d__sums_settle() returns. On the processor it is there at once. */
void sph2d__over_fluid_later(sph2d__system *system, sph2d__slab_work *work, const void *with, const char *kernel,
                             size_t size, sph2d__slab_sum *to);
void sph2d__sums_settle(sph2d__system *system);

/** The same for work that sums nothing, for which nobody waits. */
void sph2d__each_of_fluid(sph2d__system *system, sph2d__slab_work *work, const void *with, const char *kernel,
                          size_t size);

/** The same for work that only sums: the system stays as it is. */
sph2d__slab_sum sph2d__sum_fluid(const sph2d__system *system, sph2d__slab_work *work, const void *with);

/** The same, and on every slab of the boundary particles if some exert pressure. */
sph2d__slab_sum sph2d__over_rows(sph2d__system *system, sph2d__slab_work *work, const void *with);

/** Work on particles `first` to `last` - 1 of a store. */
typedef void sph2d__span_work(sph2d__system *system, size_t first, size_t last);

/** Calls `work` on particles 0 to count - 1, in slabs that threads share; where a device has the particles, runs its kernel of that
 *  name (on_device.h), which is NULL in methods that devices do not know. */
void sph2d__over_particles(sph2d__system *system, size_t count, sph2d__span_work *work, const char *kernel);

/** Begins the same, and returns while threads may still be at it: the caller waits for them by `omp taskwait`. */
void sph2d__begin_over_particles(sph2d__system *system, size_t count, sph2d__span_work *work, const char *kernel);

#endif
