/* SPDX-License-Identifier: MIT */
/** @file pool.h
 *  Many small blocks of memory that are freed together: those of a scene file or a snapshot. */
#ifndef SPH2D_FILES_POOL_H
#define SPH2D_FILES_POOL_H

#include <stddef.h>

/** Initialise with {0}. */
typedef struct sph2d__pool {
    struct sph2d__pool_chunk *first;
    size_t used, size; /**< of the first chunk */
} sph2d__pool;

/** `count` zeroed items of `size` bytes, aligned for any type; NULL when memory is short or the product overflows. */
void *sph2d__pool_alloc(sph2d__pool *pool, size_t count, size_t size);

/** A NUL-terminated copy of `length` bytes; NULL when memory is short. */
char *sph2d__pool_text(sph2d__pool *pool, const char *text, size_t length);

/** `path` relative to the folder of the file `from`; NULL when memory is short. */
const char *sph2d__pool_join(sph2d__pool *pool, const char *from, const char *path);

void sph2d__pool_free(sph2d__pool *pool);

#endif
