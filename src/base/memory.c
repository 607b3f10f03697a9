/* SPDX-License-Identifier: MIT */
/** @file memory.c
 *  Allocation that counts its bytes, and arenas. */
#include "base/memory.h"

#include <stdint.h>
#include <string.h>

#include "base/system.h"

enum { ALIGNMENT = 64 };

/** realloc with alignment: C has aligned_alloc but nothing that resizes. */
static void *resize_aligned(void *user, void *block, size_t old_size, size_t new_size)
{
    (void)user;
    void *fresh = NULL;
    if (new_size > 0) {
        fresh = sph2d__aligned_alloc(ALIGNMENT, new_size);
        if (!fresh)
            return NULL;
        if (block)
            memcpy(fresh, block, old_size < new_size ? old_size : new_size);
    }
    sph2d__aligned_free(block);
    return fresh;
}

sph2d__memory sph2d__memory_from(sph2d_allocator allocator)
{
    if (!allocator.resize)
        allocator.resize = resize_aligned;
    return (sph2d__memory){.allocator = allocator};
}

bool sph2d__resize(sph2d__memory *memory, void **block, size_t old_count, size_t new_count, size_t size)
{
    if (new_count > SIZE_MAX / size) {
        ++memory->failures;
        return false;
    }
    size_t old_size = old_count * size;
    size_t new_size = new_count * size;
    if (!*block && new_size == 0)
        return true;
    void *fresh = memory->allocator.resize(memory->allocator.user, *block, old_size, new_size);
    if (!fresh && new_size > 0) {
        ++memory->failures;
        return false;
    }
    if (new_size > old_size)
        memset((char *)fresh + old_size, 0, new_size - old_size);
    *block = fresh;
    memory->bytes += new_size - old_size;
    return true;
}

static void *load_pointer(const void *slot)
{
    void *pointer;
    memcpy(&pointer, slot, sizeof pointer);
    return pointer;
}

bool sph2d__room_for_one(sph2d__memory *memory, void *slot, size_t count, size_t *room, size_t size)
{
    enum { FIRST = 64 };
    if (count < *room)
        return true;
    size_t more = *room > 0 ? 2 * *room : FIRST;
    void *list = load_pointer(slot);
    if (!sph2d__resize(memory, &list, *room, more, size))
        return false;
    memcpy(slot, &list, sizeof list);
    *room = more;
    return true;
}

void *sph2d__alloc(sph2d__memory *memory, size_t count, size_t size)
{
    void *block = NULL;
    return sph2d__resize(memory, &block, 0, count, size) ? block : NULL;
}

void sph2d__release(sph2d__memory *memory, void **block, size_t count, size_t size)
{
    if (*block)
        sph2d__resize(memory, block, count, 0, size);
}

bool sph2d__grow_all(sph2d__memory *memory, const sph2d__growth *blocks, size_t count, size_t old_count,
                     size_t new_count)
{
    enum { MAX_BLOCKS = 96 }; /* more than a store with every array has, or a step of wcsph */
    void *fresh[MAX_BLOCKS] = {0};
    if (count > MAX_BLOCKS)
        return false;
    for (size_t i = 0; i < count; ++i) {
        fresh[i] = sph2d__alloc(memory, new_count, blocks[i].size);
        if (fresh[i])
            continue;
        while (i-- > 0)
            sph2d__release(memory, &fresh[i], new_count, blocks[i].size);
        return false;
    }
    for (size_t i = 0; i < count; ++i) {
        void *old = load_pointer(blocks[i].slot);
        if (old)
            memcpy(fresh[i], old, old_count * blocks[i].size);
        sph2d__release(memory, &old, old_count, blocks[i].size);
        memcpy(blocks[i].slot, &fresh[i], sizeof fresh[i]);
    }
    return true;
}

struct sph2d__arena_chunk {
    struct sph2d__arena_chunk *next;
    size_t size; /**< of the chunk with this header */
};

void *sph2d__arena_alloc(sph2d__arena *arena, sph2d__memory *memory, size_t count, size_t size)
{
    if (size > 0 && count > (SIZE_MAX - ALIGNMENT) / size)
        return NULL;
    size_t bytes = ALIGNMENT + count * size;
    struct sph2d__arena_chunk *chunk = sph2d__alloc(memory, bytes, 1);
    if (!chunk)
        return NULL;
    chunk->next = arena->first;
    chunk->size = bytes;
    arena->first = chunk;
    return (char *)chunk + ALIGNMENT;
}

void sph2d__arena_free(sph2d__arena *arena, sph2d__memory *memory)
{
    while (arena->first) {
        struct sph2d__arena_chunk *chunk = arena->first;
        arena->first = chunk->next;
        void *block = chunk;
        sph2d__release(memory, &block, chunk->size, 1);
    }
}
