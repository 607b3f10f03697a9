/* SPDX-License-Identifier: MIT */
/** @file memory.h
 *  Allocation by the host's allocator, aligned to 64 bytes, with a count of the bytes in use. */
#ifndef SPH2D_BASE_MEMORY_H
#define SPH2D_BASE_MEMORY_H

#include <stdbool.h>
#include <stddef.h>

#include "sph2d/sim.h"

typedef struct sph2d__memory {
    sph2d_allocator allocator;
    size_t bytes;    /**< allocated now */
    size_t failures; /**< allocations that failed so far */
} sph2d__memory;

/** The C library's allocator where `allocator` is {NULL, NULL}. */
sph2d__memory sph2d__memory_from(sph2d_allocator allocator);

/** `count` zeroed items of `size` bytes; NULL when memory is short or the product overflows. NULL for a count of 0,
 *  too. */
void *sph2d__alloc(sph2d__memory *memory, size_t count, size_t size);

/** Resizes *block from `old_count` to `new_count` items, zeroing the new ones. *block is unchanged on failure. */
bool sph2d__resize(sph2d__memory *memory, void **block, size_t old_count, size_t new_count, size_t size);

/** Makes room for one item more than `count` in the list whose pointer is at `slot`, doubling `*room` when it is full; false
 *  when memory is short. */
bool sph2d__room_for_one(sph2d__memory *memory, void *slot, size_t count, size_t *room, size_t size);

/** One of several blocks that grow together. */
typedef struct sph2d__growth {
    void *slot;  /**< the address of the pointer to the block */
    size_t size; /**< of an item */
} sph2d__growth;

/** Grows all blocks from `old_count` to `new_count` items, zeroing the new ones; none when memory is short. */
bool sph2d__grow_all(sph2d__memory *memory, const sph2d__growth *blocks, size_t count, size_t old_count,
                     size_t new_count);

/** Frees *block of `count` items and sets it to NULL. */
void sph2d__release(sph2d__memory *memory, void **block, size_t count, size_t size);

/** Many small blocks that are freed together. Initialise with {0}. */
typedef struct sph2d__arena {
    struct sph2d__arena_chunk *first;
} sph2d__arena;

/** Zeroed memory that lives until sph2d__arena_free; NULL when memory is short. */
void *sph2d__arena_alloc(sph2d__arena *arena, sph2d__memory *memory, size_t count, size_t size);
void sph2d__arena_free(sph2d__arena *arena, sph2d__memory *memory);

#endif
