/* SPDX-License-Identifier: MIT */
/** @file blocks.c
 *  Blocks that a device and the host have, and what is sent of them and fetched. */
#include <string.h>

#include "device/parts.h"

/** The entry of a block, or an empty one for it. */
static block *entry_of(sph2d__device *d, const void *host)
{
    size_t k = (size_t)((uintptr_t)host / LINE * 0x9e3779b1u) % MOST_BLOCKS;
    while (d->blocks[k].host && d->blocks[k].host != host)
        k = (k + 1) % MOST_BLOCKS;
    return &d->blocks[k];
}

uint64_t sph2d__device_offset_of(sph2d__device *d, const void *host)
{
    return host ? entry_of(d, host)->offset : 0;
}

void sph2d__device_list(sph2d__device *d)
{
    ++d->list;
}

uint64_t sph2d__device_place(sph2d__device *d, const void *host, size_t bytes, sph2d__owner owner)
{
    if (!host || bytes == 0)
        return 0;
    block *b = entry_of(d, host);
    if (!b->host || b->bytes != bytes) {
        const union {
            const void *in;
            void *out;
        } same = {host}; /* the block is the caller's to write, who says so by fetching it */
        *b = (block){.host = same.out, .bytes = bytes, .owner = owner, .device_old = true, .offset = d->used};
        d->used += sph2d__device_rounded(bytes);
        d->grows = d->grows || d->used > d->arena_bytes;
    }
    b->owner = owner;
    b->list = d->list;
    return b->offset;
}

/** Makes an arena for the blocks of the list, with what the device has of them. */
static void grow(sph2d__device *d)
{
    cl_mem old = d->arena;
    cl_int error = CL_SUCCESS;
    size_t bytes = LINE; /* offset 0 is no block */
    for (size_t k = 0; k < MOST_BLOCKS; ++k)
        if (d->blocks[k].host && d->blocks[k].list == d->list)
            bytes += sph2d__device_rounded(d->blocks[k].bytes) * (d->blocks[k].spare ? 2 : 1);
    d->arena_bytes = bytes + bytes / 4;
    if ((double)d->arena_bytes > d->description.largest)
        d->arena_bytes = bytes;
    d->arena = d->cl->clCreateBuffer(d->context, CL_MEM_READ_WRITE, d->arena_bytes, NULL, &error);
    sph2d__device_fail(d, error, "a larger buffer");
    const unsigned zero = 0;
    if (d->error == CL_SUCCESS)
        sph2d__device_fail(
            d, d->cl->clEnqueueFillBuffer(d->queue, d->arena, &zero, sizeof zero, 0, d->arena_bytes, 0, NULL, NULL),
            "zeros");
    block kept[MOST_BLOCKS];
    memcpy(kept, d->blocks, sizeof kept);
    memset(d->blocks, 0, sizeof d->blocks);
    d->used = LINE;
    for (size_t k = 0; k < MOST_BLOCKS; ++k) {
        if (kept[k].host == NULL || kept[k].list != d->list)
            continue;
        block *b = entry_of(d, kept[k].host);
        *b = kept[k];
        b->offset = d->used;
        d->used += sph2d__device_rounded(b->bytes);
        b->spare = kept[k].spare ? d->used : 0;
        d->used += kept[k].spare ? sph2d__device_rounded(b->bytes) : 0;
        if (old && !b->device_old && d->error == CL_SUCCESS)
            sph2d__device_fail(
                d,
                d->cl->clEnqueueCopyBuffer(d->queue, old, d->arena, kept[k].offset, b->offset, b->bytes, 0, NULL, NULL),
                "a copy");
    }
    if (old && d->error == CL_SUCCESS)
        sph2d__device_fail(d, d->cl->clFinish(d->queue), "a copy");
    if (old)
        d->cl->clReleaseMemObject(old);
}

bool sph2d__device_moved(sph2d__device *d)
{
    size_t known = 0;
    for (size_t k = 0; k < MOST_BLOCKS; ++k)
        known += d->blocks[k].host != NULL;
    const bool moves = (d->grows || known > MOST_BLOCKS / 2) && d->error == CL_SUCCESS;
    if (moves)
        grow(d);
    d->grows = false;
    return moves;
}

void sph2d__device_wait(sph2d__device *d, const char *doing)
{
    if (d->error == CL_SUCCESS)
        sph2d__device_fail(d, d->cl->clFinish(d->queue), doing);
    ++d->use.waits;
    d->unread = 0;
}

unsigned char *sph2d__device_slot(sph2d__device *d)
{
    if (d->unread == SLOTS - 2)
        sph2d__device_wait(d, "waiting");
    ++d->unread;
    d->slot = (d->slot + 1) % SLOTS;
    if (d->slot == d->numbers_slot)
        d->slot = (d->slot + 1) % SLOTS;
    return d->slots[d->slot];
}

/** Sends a block: by way of a slot if it fits, as the host may write it again before the driver has read it. */
static void send_block(sph2d__device *d, block *b)
{
    const void *from = b->host;
    const bool fits = b->bytes <= SLOT;
    if (fits)
        from = memcpy(sph2d__device_slot(d), b->host, b->bytes);
    if (d->error == CL_SUCCESS)
        sph2d__device_fail(
            d, d->cl->clEnqueueWriteBuffer(d->queue, d->arena, !fits, b->offset, b->bytes, from, 0, NULL, NULL),
            "sending");
    d->use.waits += !fits;
    d->use.sent += b->bytes;
    b->device_old = false;
}

void sph2d__device_send(sph2d__device *d)
{
    for (size_t k = 0; k < MOST_BLOCKS; ++k)
        if (d->blocks[k].list == d->list && d->blocks[k].device_old)
            send_block(d, &d->blocks[k]);
}

void sph2d__device_ask(sph2d__device *d, void *host)
{
    block *b = host ? entry_of(d, host) : NULL;
    if (!b || !b->host || b->list != d->list || !b->host_old || d->error != CL_SUCCESS)
        return;
    sph2d__device_fail(d, d->cl->clEnqueueReadBuffer(d->queue, d->arena, 0, b->offset, b->bytes, host, 0, NULL, NULL),
                       "fetching");
    d->use.fetched += b->bytes;
    d->asked = true;
    b->host_old = false;
}

void sph2d__device_arrive(sph2d__device *d)
{
    if (!d->asked)
        return;
    sph2d__device_wait(d, "fetching");
    d->asked = false;
}

void sph2d__device_fetch(sph2d__device *d, void *host)
{
    sph2d__device_ask(d, host);
    sph2d__device_arrive(d);
}

void sph2d__device_forget(sph2d__device *d, void *host)
{
    block *b = entry_of(d, host);
    if (host && b->host)
        *b = (block){.host = host}; /* which no list has, and which is new once it is placed */
}

void sph2d__device_changed(sph2d__device *d, unsigned owners)
{
    for (size_t k = 0; k < MOST_BLOCKS; ++k)
        if (d->blocks[k].owner & owners)
            d->blocks[k].device_old = true;
}

void sph2d__device_changed_on(sph2d__device *d, void *host)
{
    block *b = entry_of(d, host);
    if (b->host)
        b->host_old = true;
}

void sph2d__device_changed_one(sph2d__device *d, void *host)
{
    block *b = host ? entry_of(d, host) : NULL;
    if (!b || !b->host)
        return;
    b->device_old = true;
    b->host_old = false;
}

uint64_t sph2d__device_spare(sph2d__device *d, const void *host)
{
    block *b = entry_of(d, host);
    if (b->host && !b->spare) {
        b->spare = d->used;
        d->used += sph2d__device_rounded(b->bytes);
        d->grows = d->grows || d->used > d->arena_bytes;
    }
    return b->spare;
}

void sph2d__device_swap(sph2d__device *d, const void *host)
{
    block *b = entry_of(d, host);
    const uint64_t offset = b->offset;
    b->offset = b->spare;
    b->spare = offset;
    d->stale = true;
}
