/* SPDX-License-Identifier: MIT */
/** @file blocks.c
 *  Blocks that a device and the host have, and what is sent of them and fetched. */
#include <string.h>

#include "device/parts.h"

/** The entry of a block, or an empty one for it. */
static block *entry_of(sph2d__device *d, const void *host)
{
    size_t k = (size_t)((uintptr_t)host / LINE * 0x9e3779b1u) % d->block_room;
    while (d->blocks[k].host && d->blocks[k].host != host)
        k = (k + 1) % d->block_room;
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

/** Whether a block is in the list or was in the one before. Of any other the host may have given the memory back, and have something
 *  else in its place. */
static bool is_listed(const sph2d__device *d, const block *b)
{
    return b->host && b->list + 1 >= d->list;
}

/** Makes room for one entry more, and leaves out those that are in no list. */
static bool make_room(sph2d__device *d)
{
    size_t listed = 0, old_room = d->block_room;
    if (2 * (d->known + 1) <= old_room)
        return true;
    for (size_t k = 0; k < old_room; ++k)
        listed += is_listed(d, &d->blocks[k]);
    const size_t room = 4 * listed > old_room ? 2 * old_room : old_room;
    block *old = d->blocks, *blocks = sph2d__alloc(d->memory, room, sizeof *blocks);
    if (!blocks) {
        sph2d__device_fail(d, CL_OUT_OF_HOST_MEMORY, "a longer list of blocks");
        return false;
    }
    d->blocks = blocks;
    d->block_room = room;
    d->known = listed;
    for (size_t k = 0; k < old_room; ++k)
        if (is_listed(d, &old[k]))
            *entry_of(d, old[k].host) = old[k];
    void *released = old;
    sph2d__release(d->memory, &released, old_room, sizeof *old);
    return true;
}

uint64_t sph2d__device_place(sph2d__device *d, const void *host, size_t bytes, sph2d__owner owner)
{
    if (!host || bytes == 0 || !make_room(d))
        return 0;
    block *b = entry_of(d, host);
    if (!is_listed(d, b) || b->bytes != bytes) {
        const union {
            const void *in;
            void *out;
        } same = {host}; /* the block is the caller's to write, who says so by fetching it */
        d->known += !b->host;
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
    for (size_t k = 0; k < d->block_room; ++k)
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
    d->used = LINE;
    for (size_t k = 0; k < d->block_room; ++k) {
        block *b = &d->blocks[k];
        const uint64_t from = b->offset;
        if (!b->host)
            continue;
        if (b->list != d->list) {
            *b = (block){.host = b->host};
            continue;
        }
        b->offset = d->used;
        d->used += sph2d__device_rounded(b->bytes);
        b->spare = b->spare ? d->used : 0;
        d->used += b->spare ? sph2d__device_rounded(b->bytes) : 0;
        if (old && !b->device_old && d->error == CL_SUCCESS)
            sph2d__device_fail(
                d, d->cl->clEnqueueCopyBuffer(d->queue, old, d->arena, from, b->offset, b->bytes, 0, NULL, NULL),
                "a copy");
    }
    if (old) {
        sph2d__device_wait(d, "a copy");
        d->cl->clReleaseMemObject(old);
    }
}

bool sph2d__device_moved(sph2d__device *d)
{
    const bool moves = d->grows && d->error == CL_SUCCESS;
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
    for (size_t k = 0; k < d->block_room; ++k)
        if (d->blocks[k].list == d->list && d->blocks[k].device_old)
            send_block(d, &d->blocks[k]);
}

static void ask(sph2d__device *d, const block *b, size_t bytes)
{
    sph2d__device_fail(d, d->cl->clEnqueueReadBuffer(d->queue, d->arena, 0, b->offset, bytes, b->host, 0, NULL, NULL),
                       "fetching");
    d->use.fetched += bytes;
    d->asked = true;
}

void sph2d__device_ask(sph2d__device *d, void *host)
{
    block *b = host ? entry_of(d, host) : NULL;
    if (!b || !b->host || b->list != d->list || !b->host_old || d->error != CL_SUCCESS)
        return;
    ask(d, b, b->bytes);
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

void sph2d__device_fetch_first(sph2d__device *d, void *host, size_t bytes)
{
    const block *b = entry_of(d, host);
    if (b->list == d->list && bytes > 0 && d->error == CL_SUCCESS)
        ask(d, b, bytes < b->bytes ? bytes : b->bytes);
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
    for (size_t k = 0; k < d->block_room; ++k)
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
