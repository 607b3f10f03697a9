/* SPDX-License-Identifier: MIT */
/** @file on_device.h
 *  A system whose particles a device has: its loops are kernels, and the host reads what it has fetched.
 *
 *  Where the loops of a method run on the processor or, with `system.device`, by kernels of its program (methods/NAME/NAME.cl): these are
 *  the same functions, compiled as OpenCL C, so that they make the same bits. A kernel gets a copy of the system with offsets of blocks in
 *  place of addresses. One whose name begins with wall_ writes arrays of boundary particles, with grid_ those of the grid, any other
 *  those of the fluid. */
#ifndef SPH2D_METHODS_COMMON_ON_DEVICE_H
#define SPH2D_METHODS_COMMON_ON_DEVICE_H

#include "device/device.h"
#include "methods/common/slab.h"

/** What a method hands its kernels behind the system: a struct whose addresses `place` turns into offsets, in a copy. */
enum { SPH2D__MOST_EXTRA = 8192 };
struct sph2d__extra {
    size_t bytes;
    const void *(*data)(const sph2d__system *system);
    void (*place)(const sph2d__system *system, void *copy);
};

/** Turns an address in a copy of a struct into the offset of a block. */
void sph2d__place_block(const sph2d__system *system, void *slot, size_t bytes, sph2d__owner owner);
void sph2d__place_store(const sph2d__system *system, sph2d__store *to, sph2d__owner owner);
void sph2d__place_cells(const sph2d__system *system, sph2d__cells *copy, sph2d__owner owner);

/** Runs a kernel on particles 0 to count - 1. */
void sph2d__device_span(const sph2d__system *system, const char *kernel, size_t count);
/** The same with arguments. */
void sph2d__device_span_with(const sph2d__system *system, const char *kernel, size_t count, const void *with,
                             size_t bytes);

/** The results of a kernel that only reads, one of `size` bytes for each slab of the fluid: sph2d__device_results(). NULL when memory is
 *  short, or after a failure. */
const void *sph2d__device_read_by(const sph2d__system *system, const char *kernel, const void *with, size_t bytes,
                                  size_t size);
/** The same of one that writes arrays of the fluid. */
const void *sph2d__device_written_by(const sph2d__system *system, const char *kernel, const void *with, size_t bytes,
                                     size_t size);

/** The total of the sums of a kernel, as sph2d__sum_fluid(). */
sph2d__slab_sum sph2d__device_sum(const sph2d__system *system, const char *kernel, const void *with, size_t bytes);

/** The same of one that writes arrays of the fluid, as sph2d__over_fluid(). */
sph2d__slab_sum sph2d__device_work(const sph2d__system *system, const char *kernel, const void *with, size_t bytes);

/** The same, later, as sph2d__over_fluid_later(). */
void sph2d__device_work_later(const sph2d__system *system, const char *kernel, const void *with, size_t bytes,
                              sph2d__slab_sum *to);

/** Where the device has an array of the system. */
uint64_t sph2d__device_offset(const sph2d__system *system, const void *array);

/** Whether the device has failed: what it had is lost. */
bool sph2d__device_is_lost(const sph2d__system *system);

/** Sends the system again, with all blocks where there is room for them. */
void sph2d__device_rebind(const sph2d__system *system);

/** Those of a store that are no doubles, as part of a set. */
#define SPH2D__IDS ((sph2d__set)1 << 62)
#define SPH2D__COLORS ((sph2d__set)1 << 63)
_Static_assert(SPH2D__STORE_COUNT <= 62, "ids and colours have bits of their own");

/** All arrays, ids, colours and cells, too. */
#define SPH2D__EVERYTHING (~(sph2d__set)0)

/** Fetches arrays of the fluid, or of boundary particles. */
void sph2d__device_fetch_arrays(const sph2d__system *system, sph2d__set arrays);
void sph2d__device_fetch_walls(const sph2d__system *system);

/** Before the host reads arrays of the fluid. */
static inline void sph2d__host_reads(const sph2d__system *s, sph2d__set arrays)
{
    if (sph2d__is_on_device(s))
        sph2d__device_fetch_arrays(s, arrays);
}

/** The same of boundary particles. */
static inline void sph2d__host_reads_walls(const sph2d__system *s)
{
    if (sph2d__is_on_device(s))
        sph2d__device_fetch_walls(s);
}

/** Before it reads a block. */
static inline void sph2d__host_reads_block(const sph2d__system *s, void *block)
{
    if (sph2d__is_on_device(s))
        sph2d__device_fetch(s->device, block);
}

/** After the host has changed arrays of the fluid, which it has read before. */
void sph2d__host_changed(const sph2d__system *system, sph2d__set arrays);
/** After it has changed a block, all of it. */
void sph2d__host_changed_block(const sph2d__system *system, void *block);
/** Makes room for at least `capacity` particles of the fluid, wherever they are. False when memory is short. */
bool sph2d__fluid_reserve(sph2d__system *system, size_t capacity);
/** After it has changed the points that attract. */
void sph2d__host_changed_points(const sph2d__system *system);
/** After it has changed arrays of boundary particles; all: put them in another order. */
void sph2d__host_changed_walls(const sph2d__system *system, sph2d__set arrays);

#endif
