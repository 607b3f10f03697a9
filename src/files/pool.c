/* SPDX-License-Identifier: MIT */
/** @file pool.c
 *  Allocates blocks from chunks; a block larger than a chunk gets its own. */
#include "files/pool.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CHUNK_BYTES = 64 * 1024, ALIGNMENT = 16 };

struct sph2d__pool_chunk {
    struct sph2d__pool_chunk *next;
    _Alignas(16) unsigned char bytes[];
};

void *sph2d__pool_alloc(sph2d__pool *pool, size_t count, size_t size)
{
    if (size > 0 && count > (SIZE_MAX / 2) / size)
        return NULL;
    size_t needed = (count * size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
    if (!pool->first || needed > pool->size - pool->used) {
        size_t capacity = needed > CHUNK_BYTES ? needed : CHUNK_BYTES;
        struct sph2d__pool_chunk *chunk = calloc(1, sizeof *chunk + capacity);
        if (!chunk)
            return NULL;
        chunk->next = pool->first;
        pool->first = chunk;
        pool->used = 0;
        pool->size = capacity;
    }
    void *block = pool->first->bytes + pool->used;
    pool->used += needed;
    return block;
}

char *sph2d__pool_text(sph2d__pool *pool, const char *text, size_t length)
{
    char *copy = length < SIZE_MAX ? sph2d__pool_alloc(pool, length + 1, 1) : NULL;
    if (copy && length > 0)
        memcpy(copy, text, length);
    return copy;
}

const char *sph2d__pool_join(sph2d__pool *pool, const char *from, const char *path)
{
    const char *slash = strrchr(from, '/');
    size_t folder = slash && path[0] != '/' ? (size_t)(slash - from) + 1 : 0;
    size_t size = folder + strlen(path) + 1;
    char *joined = sph2d__pool_alloc(pool, size, 1);
    if (joined)
        snprintf(joined, size, "%.*s%s", (int)folder, from, path);
    return joined;
}

void sph2d__pool_free(sph2d__pool *pool)
{
    while (pool->first) {
        struct sph2d__pool_chunk *chunk = pool->first;
        pool->first = chunk->next;
        free(chunk);
    }
    *pool = (sph2d__pool){0};
}
