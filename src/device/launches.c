/* SPDX-License-Identifier: MIT */
/** @file launches.c
 *  Kernels, what they are run with, and their results. */
#include <string.h>

#include "device/parts.h"

static cl_kernel kernel_named(sph2d__device *d, const char *name)
{
    for (size_t k = 0; k < d->launcher_count; ++k)
        if (d->launchers[k].name == name || strcmp(d->launchers[k].name, name) == 0)
            return d->launchers[k].kernel;
    cl_int error = d->launcher_count < MOST_KERNELS ? CL_SUCCESS : CL_BUILD_PROGRAM_FAILURE;
    cl_kernel kernel = error == CL_SUCCESS ? d->cl->clCreateKernel(d->program, name, &error) : NULL;
    sph2d__device_fail(d, error, name);
    if (error == CL_SUCCESS)
        d->launchers[d->launcher_count++] = (launcher){name, kernel};
    return kernel;
}

/** Copies numbers to the next slot of the device, before all kernels that come. Returns the slot. */
static unsigned send_numbers(sph2d__device *d, const void *numbers, size_t bytes)
{
    if (bytes == 0)
        return d->slot;
    const void *from = memcpy(sph2d__device_slot(d), numbers, bytes);
    if (d->error == CL_SUCCESS)
        sph2d__device_fail(
            d, d->cl->clEnqueueWriteBuffer(d->queue, d->numbers, 0, (size_t)d->slot * SLOT, bytes, from, 0, NULL, NULL),
            "sending numbers");
    d->use.sent += bytes;
    return d->slot;
}

bool sph2d__device_is_short(const sph2d__device *d)
{
    return d->grows;
}

void sph2d__device_forget_numbers(sph2d__device *d)
{
    d->stale = true;
}

bool sph2d__device_knows(sph2d__device *d, size_t at, const void *numbers, size_t bytes)
{
    unsigned char *noted = d->slots[SLOTS] + at;
    const bool known = memcmp(noted, numbers, bytes) == 0 && !d->stale;
    memcpy(noted, numbers, bytes);
    return known;
}

void sph2d__device_numbers(sph2d__device *d, const void *numbers, size_t bytes)
{
    d->numbers_slot = send_numbers(d, numbers, bytes);
    d->stale = false;
}

/** Launches a kernel, whose results go to the buffer for them. */
static void launch(sph2d__device *d, const char *name, size_t count, const void *arguments, size_t bytes,
                   unsigned writes)
{
    cl_kernel kernel = kernel_named(d, name);
    sph2d__device_send(d);
    const uint64_t numbers = (uint64_t)d->numbers_slot * SLOT, own = (uint64_t)send_numbers(d, arguments, bytes) * SLOT,
                   items = count, at = d->waiting_bytes;
    const size_t local = SPH2D__DEVICE_GROUP, global = (count + local - 1) / local * local;
    if (d->error != CL_SUCCESS || count == 0)
        return;
    const struct {
        size_t size;
        const void *value;
    } values[] = {{sizeof d->arena, &d->arena},
                  {sizeof d->numbers, &d->numbers},
                  {sizeof numbers, &numbers},
                  {sizeof own, &own},
                  {sizeof items, &items},
                  {sizeof d->results, &d->results},
                  {sizeof at, &at}};
    for (cl_uint k = 0; k < sizeof values / sizeof *values; ++k)
        sph2d__device_fail(d, d->cl->clSetKernelArg(kernel, k, values[k].size, values[k].value), name);
    if (d->error == CL_SUCCESS)
        sph2d__device_fail(d, d->cl->clEnqueueNDRangeKernel(d->queue, kernel, 1, NULL, &global, &local, 0, NULL, NULL),
                           name);
    ++d->use.launches;
    for (size_t k = 0; k < d->block_room; ++k)
        if (d->blocks[k].list == d->list && d->blocks[k].owner & writes)
            d->blocks[k].host_old = true;
}

/** Takes what has been read of results that were to come later. */
static void take_waiting(sph2d__device *d)
{
    for (size_t k = 0; k < d->waiting_count; ++k)
        d->waiting[k].take(d->waiting[k].to, d->host_results + d->waiting[k].at, d->waiting[k].groups);
    d->waiting_count = d->waiting_bytes = 0;
}

/** Waits for the first `bytes` of results, which may be none; zeros after a failure. */
static void read_results(sph2d__device *d, size_t bytes, const char *doing)
{
    if (bytes == 0)
        return;
    if (d->error == CL_SUCCESS)
        sph2d__device_fail(
            d, d->cl->clEnqueueReadBuffer(d->queue, d->results, 1, 0, bytes, d->host_results, 0, NULL, NULL), doing);
    ++d->use.waits;
    d->unread = 0;
    d->use.fetched += bytes;
    if (d->error != CL_SUCCESS)
        memset(d->host_results, 0, bytes);
}

/** Makes room for results behind those that wait; where there is none, they are taken first, and the next ones have twice the room. */
static bool reserve_results(sph2d__device *d, size_t bytes)
{
    bytes = d->waiting_bytes + sph2d__device_rounded(bytes > 0 ? bytes : 1);
    if (bytes <= d->results_bytes)
        return true;
    sph2d__device_settle(d);
    void *host = d->host_results;
    bytes *= 2;
    if (bytes > d->host_results_bytes) {
        if (!sph2d__resize(d->memory, &host, d->host_results_bytes, bytes, 1))
            return false;
        d->host_results = host;
        d->host_results_bytes = bytes;
    }
    if (bytes > d->results_bytes && d->error == CL_SUCCESS) {
        cl_int error = CL_SUCCESS;
        if (d->results)
            d->cl->clReleaseMemObject(d->results);
        d->results = d->cl->clCreateBuffer(d->context, CL_MEM_READ_WRITE, bytes, NULL, &error);
        d->results_bytes = bytes;
        sph2d__device_fail(d, error, "a buffer for results");
    }
    return true;
}

void sph2d__device_run(sph2d__device *d, const char *kernel, size_t count, const void *arguments, size_t bytes,
                       unsigned writes)
{
    if (reserve_results(d, 0))
        launch(d, kernel, count, arguments, bytes, writes);
    else
        sph2d__device_fail(d, CL_OUT_OF_HOST_MEMORY, kernel);
}

static size_t groups_of(size_t count)
{
    return (count + SPH2D__DEVICE_GROUP - 1) / SPH2D__DEVICE_GROUP;
}

const void *sph2d__device_results(sph2d__device *d, const char *kernel, size_t count, const void *arguments,
                                  size_t bytes, unsigned writes, size_t size)
{
    const size_t all = groups_of(count) * size;
    if (!reserve_results(d, all)) {
        sph2d__device_fail(d, CL_OUT_OF_HOST_MEMORY, kernel);
        return NULL;
    }
    unsigned char *to = d->host_results + d->waiting_bytes;
    launch(d, kernel, count, arguments, bytes, writes);
    read_results(d, d->waiting_bytes + all, kernel);
    take_waiting(d);
    return to;
}

void sph2d__device_results_later(sph2d__device *d, const char *kernel, size_t count, const void *arguments,
                                 size_t bytes, unsigned writes, size_t size, sph2d__take *take, void *to)
{
    const size_t all = groups_of(count) * size;
    if (d->waiting_count == MOST_WAITING)
        sph2d__device_settle(d);
    if (!reserve_results(d, all)) {
        sph2d__device_fail(d, CL_OUT_OF_HOST_MEMORY, kernel);
        take(to, NULL, 0);
        return;
    }
    launch(d, kernel, count, arguments, bytes, writes);
    d->waiting[d->waiting_count++] = (later){take, to, d->waiting_bytes, groups_of(count)};
    d->waiting_bytes += sph2d__device_rounded(all);
}

void sph2d__device_finish(sph2d__device *d)
{
    sph2d__device_wait(d, "waiting");
}

void sph2d__device_settle(sph2d__device *d)
{
    if (d->waiting_count == 0)
        return;
    read_results(d, d->waiting_bytes, "sums");
    take_waiting(d);
}
