/* SPDX-License-Identifier: MIT */
/** @file parts.h
 *  What device.c, blocks.c and launches.c know of a device. */
#ifndef SPH2D_DEVICE_PARTS_H
#define SPH2D_DEVICE_PARTS_H

#include "device/device.h"
#include "device/opencl_api.h"

enum {
    FIRST_ROOM = 1024,
    MOST_KERNELS = 96,
    LINE = 64,
    SLOT = SPH2D__DEVICE_NUMBERS,
    SLOTS = SPH2D_DEVICE_FIXED_MEMORY / SLOT,
    MOST_WAITING = 64
};

/** A block that host and device have. */
typedef struct block {
    void *host;
    size_t bytes;
    uint64_t offset, spare; /* spare: 0 until it is asked for */
    unsigned owner;
    bool host_old, device_old; /* the other one has changed it */
    uint64_t list;             /* the last one that it was in */
} block;

typedef struct launcher {
    const char *name;
    cl_kernel kernel;
} launcher;

/** Results that are to be taken later. */
typedef struct later {
    sph2d__take *take;
    void *to;
    size_t at, groups;
} later;

struct sph2d__device {
    const sph2d__opencl *cl;
    cl_device_id id;
    cl_context context;
    cl_command_queue queue;
    cl_program program;
    cl_mem arena, numbers, results;
    size_t arena_bytes, used, results_bytes;
    block *blocks;            /* by a hash of the address, half of the room empty */
    size_t block_room, known; /* entries */
    bool grows;               /* the list needs a larger arena */
    bool asked;               /* blocks are on their way to the host */
    uint64_t list;
    bool stale;                  /* the numbers that kernels have name places of before */
    unsigned slot, numbers_slot; /* the last one filled, and that of what all kernels read now */
    unsigned unread;             /* slots filled since the last wait: the driver may have to read them yet */
    unsigned char (*slots)
        [SLOT]; /* the host's copies, which the driver reads later; the last: what kernels read, as the host has it */
    unsigned char *host_results;
    size_t host_results_bytes;
    later waiting[MOST_WAITING];
    size_t waiting_count, waiting_bytes;
    sph2d_device_use use;
    launcher launchers[MOST_KERNELS];
    size_t launcher_count;
    sph2d__memory *memory;
    cl_int error;
    const char *doing, *reason; /* when the error came; and why, where it is not the driver's */
    sph2d_device description;
};

/** Notes the first error, and what was done when it came. */
void sph2d__device_fail(sph2d__device *device, cl_int error, const char *doing);
/** Waits for all that has been asked of the device. */
void sph2d__device_wait(sph2d__device *device, const char *doing);

/** The next slot but that of what all kernels read, once the driver has read it. */
unsigned char *sph2d__device_slot(sph2d__device *device);
/** Sends what the host has changed of the list's blocks. */
void sph2d__device_send(sph2d__device *device);

/** Bytes of a block in a buffer. */
static inline size_t sph2d__device_rounded(size_t bytes)
{
    return (bytes + LINE - 1) / LINE * LINE;
}

#endif
