/* SPDX-License-Identifier: MIT */
/** @file shared.c
 *  An allocator whose blocks count who uses them: the simulation and those who hold them. */
#include "sph2d/shared.h"

#include <stdatomic.h>
#include <stdint.h>
#include <string.h>

#include "base/system.h"

enum { ALIGNMENT = 64 };

/** In the 64 bytes before a block. */
typedef struct header {
    atomic_size_t users;
} header;

_Static_assert(sizeof(header) <= ALIGNMENT, "a header keeps the block behind it aligned");

static header *header_of(const void *block)
{
    return (header *)((uintptr_t)block - ALIGNMENT);
}

static void *resize(void *user, void *block, size_t old_size, size_t new_size)
{
    (void)user;
    char *fresh = NULL;
    if (new_size > 0) {
        header *h = new_size > SIZE_MAX - ALIGNMENT ? NULL : sph2d__aligned_alloc(ALIGNMENT, ALIGNMENT + new_size);
        if (!h)
            return NULL;
        atomic_init(&h->users, 1);
        fresh = (char *)h + ALIGNMENT;
        if (block)
            memcpy(fresh, block, old_size < new_size ? old_size : new_size);
    }
    sph2d_shared_release(block);
    return fresh;
}

sph2d_allocator sph2d_shared_allocator(void)
{
    return (sph2d_allocator){.resize = resize};
}

void sph2d_shared_hold(const void *block)
{
    if (block)
        atomic_fetch_add_explicit(&header_of(block)->users, 1, memory_order_relaxed);
}

void sph2d_shared_release(const void *block)
{
    /* What others did with the block comes before it is freed. */
    if (block && atomic_fetch_sub_explicit(&header_of(block)->users, 1, memory_order_acq_rel) == 1)
        sph2d__aligned_free(header_of(block));
}
