/* SPDX-License-Identifier: MIT */
/** @file device.h
 *  A device that runs kernels on one simulation's arrays.
 *
 *  All blocks of memory that host and device share lie in one buffer of the device, each at an offset. Whoever wrote last
 *  has the truth of a block: before a kernel runs, blocks that the host has changed are sent, and the host asks for blocks before it
 *  reads them. A launch returns at once; kernels run one after another, as they were launched.
 *
 *  An error of the driver, or the loss of the device, ends all further work: every function then returns at once, and
 *  sph2d__device_failed() says what happened. */
#ifndef SPH2D_DEVICE_DEVICE_H
#define SPH2D_DEVICE_DEVICE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/memory.h"
#include "sph2d/device.h"

typedef struct sph2d__device sph2d__device;

/** Whose blocks, for what a kernel or the host has changed. A set of bits. */
typedef enum sph2d__owner {
    SPH2D__OF_FLUID = 1,      /**< the fluid's arrays and cells */
    SPH2D__OF_WALLS = 2,      /**< those of boundary particles */
    SPH2D__OF_SCENE = 4,      /**< what is made once */
    SPH2D__OF_POINTS = 8,     /**< the points that attract */
    SPH2D__OF_WALL_SUMS = 16, /**< what kernels write of boundary particles */
    SPH2D__OF_GRID = 32       /**< a method's grid */
} sph2d__owner;

/** Particles that a group of threads works on together, whose sums are one: methods/common/slab.h. */
enum { SPH2D__DEVICE_GROUP = 256 };
/** The most numbers that kernels can be run with [bytes]. */
enum { SPH2D__DEVICE_NUMBERS = 32768 };

/** Opens device `number`, from 1 on, with the kernels of a program (the name of a file *.cl without its end), in which KIND is `kind`. `same_bits`: only if
 *  it makes the same bits. NULL with the reason in the report; SPH2D_NOMEM in *status when memory is short. */
sph2d__device *sph2d__device_open(int number, const char *program, int kind, bool same_bits, sph2d__memory *memory,
                                  sph2d_status *status, sph2d_report *report);
void sph2d__device_close(sph2d__device *device, sph2d__memory *memory);

/** Why the device does no more work, and what it did when that happened; false: it works. */
bool sph2d__device_failed(const sph2d__device *device, const char **why, const char **kernel);
/** Whether that was for want of memory. */
bool sph2d__device_lacks_memory(const sph2d__device *device);

/** Begins a new list of blocks: when the buffer grows, those that are not placed again are forgotten. */
void sph2d__device_list(sph2d__device *device);
/** The offset of a block, which is new or in the list before, with room for it. */
uint64_t sph2d__device_place(sph2d__device *device, const void *host, size_t bytes, sph2d__owner owner);
/** Ends the list; true when the blocks have moved, so that their offsets have to be asked for once more. */
bool sph2d__device_moved(sph2d__device *device);

/** Whether blocks were placed for which there is no room yet. */
bool sph2d__device_is_short(const sph2d__device *device);
/** What the host has is sent again before the next kernel. */
void sph2d__device_forget_numbers(sph2d__device *device);
/** Whether the host had the same numbers at the last call with this place; notes them. */
bool sph2d__device_knows(sph2d__device *device, size_t at, const void *numbers, size_t bytes);
/** The offset of a block that is placed; 0: there is none. */
uint64_t sph2d__device_offset_of(sph2d__device *device, const void *host);

/** What a kernel is run with: numbers that all of its threads read, the same until they are set anew. */
void sph2d__device_numbers(sph2d__device *device, const void *numbers, size_t bytes);

/** Runs a kernel with one thread for each of `count` items, in groups of SPH2D__DEVICE_GROUP, and `bytes` of arguments; `writes`: whose blocks it
 *  changes, a set of sph2d__owner. */
void sph2d__device_run(sph2d__device *device, const char *kernel, size_t count, const void *arguments, size_t bytes,
                       unsigned writes);
/** The same, for kernels with a result of `size` bytes for each group; waits, and returns the results, which are the device's until its
 *  next one, or zeros after a failure. NULL when memory is short, which is one, too. */
const void *sph2d__device_results(sph2d__device *device, const char *kernel, size_t count, const void *arguments,
                                  size_t bytes, unsigned writes, size_t size);

/** Takes the results of a kernel for some groups, once they are there; of none where memory is short. */
typedef void sph2d__take(void *to, const void *results, size_t groups);
/** The same, but the results are handed to `take` later: by sph2d__device_settle(), or before. */
void sph2d__device_results_later(sph2d__device *device, const char *kernel, size_t count, const void *arguments,
                                 size_t bytes, unsigned writes, size_t size, sph2d__take *take, void *to);
/** Waits for all results that are to come later. */
void sph2d__device_settle(sph2d__device *device);

/** Before the host reads a block: waits until it is there. Of blocks that are in no list nothing is known, and nothing is done. */
void sph2d__device_fetch(sph2d__device *device, void *host);
/** The same of several: each is asked for, and then all are waited for. */
void sph2d__device_ask(sph2d__device *device, void *host);
void sph2d__device_arrive(sph2d__device *device);
/** The first bytes of a block, of which the host needs no others until a kernel has written it anew. */
void sph2d__device_fetch_first(sph2d__device *device, void *host, size_t bytes);
/** After the host has changed blocks of some owners, which it has fetched before. */
void sph2d__device_changed(sph2d__device *device, unsigned owners);

/** Before the host gives the memory of a block back, whose place another may take. */
void sph2d__device_forget(sph2d__device *device, void *host);

/** A kernel has changed a block by arguments; or the host one, alone. */
void sph2d__device_changed_on(sph2d__device *device, void *host);
void sph2d__device_changed_one(sph2d__device *device, void *host);

/** Where a kernel may write a block anew while others read what it was, and the end of that: the two change places. */
uint64_t sph2d__device_spare(sph2d__device *device, const void *host);
void sph2d__device_swap(sph2d__device *device, const void *host);

/** Ends all further work, for a reason that is static. */
void sph2d__device_give_up(sph2d__device *device, const char *why);

/** Waits until all kernels have run. */
void sph2d__device_finish(sph2d__device *device);

/** Memory of the device in use [bytes]. */
size_t sph2d__device_bytes(const sph2d__device *device);
/** What it has done so far. */
sph2d_device_use sph2d__device_used(const sph2d__device *device);
/** Its name. */
const char *sph2d__device_name(const sph2d__device *device);

#endif
