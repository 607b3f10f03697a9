/* SPDX-License-Identifier: MIT */
/** @file device.c
 *  Buffers, kernels and launches by OpenCL. */
#include "device/device.h"

#include <stdio.h>
#include <string.h>

#include "device/kernels.h"
#include "device/opencl_api.h"
#include "sph2d/device.h"

enum { MOST_BLOCKS = 1024, MOST_KERNELS = 96, LINE = 64, SLOTS = 64, SLOT = 32768, OPTIONS = 96, MOST_WAITING = 64 };

/** A block that host and device have. */
typedef struct block {
    void *host;
    size_t bytes;
    uint64_t offset, spare; /* spare: 0 until it is asked for */
    unsigned owner;
    bool host_old, device_old; /* the other one has changed it */
    unsigned list;             /* the last one that it was in */
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
    block blocks[MOST_BLOCKS]; /* by a hash of the address */
    bool grows;                /* the list needs a larger arena */
    bool asked;                /* blocks are on their way to the host */
    unsigned list;
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

static void fail(sph2d__device *d, cl_int error, const char *doing)
{
    if (error != CL_SUCCESS && d->error == CL_SUCCESS) {
        d->error = error;
        d->doing = doing;
    }
}

/* ---- opening ----------------------------------------------------------------------------------------------------- */

static sph2d_status refuse(sph2d_report *report, const char *hint, const char *format, const char *name)
{
    sph2d_diagnostic_hint(sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_UNSUPPORTED, NULL, format, name), "%s",
                          hint);
    return SPH2D_INVALID;
}

static const char LIST[] = "`sph2d devices` lists those that there are";

static sph2d_status find(sph2d__device *d, int number, bool same_bits, sph2d_report *report)
{
    sph2d_device list[64];
    cl_platform_id platform;
    d->cl = sph2d__opencl_find();
    if (!d->cl)
        return refuse(report, "install a driver with OpenCL for the device, and the loader, libOpenCL.so.1%s",
                      "there is no OpenCL on this machine%s", "");
    const size_t count = sph2d_devices(list, sizeof list / sizeof *list);
    d->id = number >= 1 ? sph2d__opencl_device(d->cl, (size_t)number - 1, &platform) : NULL;
    if (!d->id || (size_t)number > sizeof list / sizeof *list) {
        char text[64];
        snprintf(text, sizeof text, "%d, of %zu", number, count);
        return refuse(report, LIST, "there is no device %s", text);
    }
    d->description = list[number - 1];
    if (d->description.lacks[0]) {
        char text[192];
        snprintf(text, sizeof text, "%s: it lacks %s", d->description.name, d->description.lacks);
        return refuse(report, LIST, "this device cannot run simulations, %s", text);
    }
    if (same_bits && !d->description.same_bits)
        return refuse(report, "without --same-bits it runs, and differs in the last digits",
                      "%s does not round as the processor does, so that its results are not the same bits",
                      d->description.name);
    return SPH2D_OK;
}

static sph2d_status build(sph2d__device *d, const char *program, int kind, sph2d_report *report)
{
    char options[OPTIONS];
    snprintf(options, sizeof options, "-cl-std=CL1.2 -w -DKIND=%d%s", kind,
             d->description.same_bits ? " -cl-fp32-correctly-rounded-divide-sqrt" : "");
    const char *text = sph2d__kernels_of(program);
    cl_int error = CL_SUCCESS;
    d->program = d->cl->clCreateProgramWithSource(d->context, 1, &text, NULL, &error);
    if (error == CL_SUCCESS)
        error = d->cl->clBuildProgram(d->program, 1, &d->id, options, NULL, NULL);
    if (error == CL_SUCCESS)
        return SPH2D_OK;
    char log[400] = "";
    if (error == CL_BUILD_PROGRAM_FAILURE)
        d->cl->clGetProgramBuildInfo(d->program, d->id, CL_PROGRAM_BUILD_LOG, sizeof log - 1, log, NULL);
    log[strcspn(log, "\n")] = '\0';
    sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_DEVICE, NULL, "%s: %s (OpenCL error %d) %s", d->description.name,
                     sph2d__opencl_error(error), (int)error, log);
    return SPH2D_DEVICE;
}

static sph2d_status start(sph2d__device *d, const char *program, int kind, sph2d_report *report)
{
    cl_int error = CL_SUCCESS;
    d->context = d->cl->clCreateContext(NULL, 1, &d->id, NULL, NULL, &error);
    if (error == CL_SUCCESS)
        d->queue = d->cl->clCreateCommandQueue(d->context, d->id, 0, &error);
    if (error == CL_SUCCESS)
        d->numbers = d->cl->clCreateBuffer(d->context, CL_MEM_READ_WRITE, SLOTS * SLOT, NULL, &error);
    if (error != CL_SUCCESS) {
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_DEVICE, NULL, "%s: %s (OpenCL error %d)", d->description.name,
                         sph2d__opencl_error(error), (int)error);
        return SPH2D_DEVICE;
    }
    return build(d, program, kind, report);
}

sph2d__device *sph2d__device_open(int number, const char *program, int kind, bool same_bits, sph2d__memory *memory,
                                  sph2d_status *status, sph2d_report *report)
{
    sph2d__device *d = sph2d__alloc(memory, 1, sizeof *d);
    *status = SPH2D_NOMEM;
    if (!d)
        return NULL;
    d->memory = memory;
    d->slots = sph2d__alloc(memory, SLOTS + 1, SLOT);
    if (d->slots)
        *status = find(d, number, same_bits, report);
    if (*status == SPH2D_OK)
        *status = start(d, program, kind, report);
    if (*status == SPH2D_OK)
        return d;
    sph2d__device_close(d, memory);
    return NULL;
}

void sph2d__device_close(sph2d__device *d, sph2d__memory *memory)
{
    if (!d)
        return;
    for (size_t k = 0; k < d->launcher_count; ++k)
        d->cl->clReleaseKernel(d->launchers[k].kernel);
    const cl_mem buffers[] = {d->arena, d->numbers, d->results};
    for (size_t k = 0; k < sizeof buffers / sizeof *buffers; ++k)
        if (buffers[k])
            d->cl->clReleaseMemObject(buffers[k]);
    if (d->program)
        d->cl->clReleaseProgram(d->program);
    if (d->queue)
        d->cl->clReleaseCommandQueue(d->queue);
    if (d->context)
        d->cl->clReleaseContext(d->context);
    void *blocks[] = {d->slots, d->host_results, d};
    sph2d__release(memory, &blocks[0], d->slots ? SLOTS + 1 : 0, SLOT);
    sph2d__release(memory, &blocks[1], d->host_results_bytes, 1);
    sph2d__release(memory, &blocks[2], 1, sizeof *d);
}

void sph2d__device_give_up(sph2d__device *d, const char *why)
{
    d->reason = d->error == CL_SUCCESS ? why : d->reason;
    fail(d, 1, "its end");
}

bool sph2d__device_failed(const sph2d__device *d, const char **why, const char **kernel)
{
    *why = d->reason ? d->reason : sph2d__opencl_error(d->error);
    *kernel = d->doing;
    return d->error != CL_SUCCESS;
}

size_t sph2d__device_bytes(const sph2d__device *d)
{
    return d->arena_bytes + d->results_bytes + SLOTS * SLOT;
}

sph2d_device_use sph2d__device_used(const sph2d__device *d)
{
    return d->use;
}

const char *sph2d__device_name(const sph2d__device *d)
{
    return d->description.name;
}

/* ---- blocks ------------------------------------------------------------------------------------------------------ */

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

static size_t rounded(size_t bytes)
{
    return (bytes + LINE - 1) / LINE * LINE;
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
        d->used += rounded(bytes);
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
            bytes += rounded(d->blocks[k].bytes) * (d->blocks[k].spare ? 2 : 1);
    d->arena_bytes = bytes + bytes / 4;
    if ((double)d->arena_bytes > d->description.largest)
        d->arena_bytes = bytes;
    d->arena = d->cl->clCreateBuffer(d->context, CL_MEM_READ_WRITE, d->arena_bytes, NULL, &error);
    fail(d, error, "a larger buffer");
    const unsigned zero = 0;
    if (d->error == CL_SUCCESS)
        fail(d, d->cl->clEnqueueFillBuffer(d->queue, d->arena, &zero, sizeof zero, 0, d->arena_bytes, 0, NULL, NULL),
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
        d->used += rounded(b->bytes);
        b->spare = kept[k].spare ? d->used : 0;
        d->used += kept[k].spare ? rounded(b->bytes) : 0;
        if (old && !b->device_old && d->error == CL_SUCCESS)
            fail(
                d,
                d->cl->clEnqueueCopyBuffer(d->queue, old, d->arena, kept[k].offset, b->offset, b->bytes, 0, NULL, NULL),
                "a copy");
    }
    if (old && d->error == CL_SUCCESS)
        fail(d, d->cl->clFinish(d->queue), "a copy");
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

/** Waits for all that has been asked of the device. */
static void wait(sph2d__device *d, const char *doing)
{
    if (d->error == CL_SUCCESS)
        fail(d, d->cl->clFinish(d->queue), doing);
    ++d->use.waits;
    d->unread = 0;
}

/** The next slot but that of what all kernels read, which the driver has read. */
static unsigned char *next_slot(sph2d__device *d)
{
    if (d->unread == SLOTS - 2)
        wait(d, "waiting");
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
        from = memcpy(next_slot(d), b->host, b->bytes);
    if (d->error == CL_SUCCESS)
        fail(d, d->cl->clEnqueueWriteBuffer(d->queue, d->arena, !fits, b->offset, b->bytes, from, 0, NULL, NULL),
             "sending");
    d->use.waits += !fits;
    d->use.sent += b->bytes;
    b->device_old = false;
}

static void send_old(sph2d__device *d)
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
    fail(d, d->cl->clEnqueueReadBuffer(d->queue, d->arena, 0, b->offset, b->bytes, host, 0, NULL, NULL), "fetching");
    d->use.fetched += b->bytes;
    d->asked = true;
    b->host_old = false;
}

void sph2d__device_arrive(sph2d__device *d)
{
    if (!d->asked)
        return;
    wait(d, "fetching");
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
        d->used += rounded(b->bytes);
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

/* ---- kernels ----------------------------------------------------------------------------------------------------- */

static cl_kernel kernel_named(sph2d__device *d, const char *name)
{
    for (size_t k = 0; k < d->launcher_count; ++k)
        if (d->launchers[k].name == name || strcmp(d->launchers[k].name, name) == 0)
            return d->launchers[k].kernel;
    cl_int error = d->launcher_count < MOST_KERNELS ? CL_SUCCESS : CL_BUILD_PROGRAM_FAILURE;
    cl_kernel kernel = error == CL_SUCCESS ? d->cl->clCreateKernel(d->program, name, &error) : NULL;
    fail(d, error, name);
    if (error == CL_SUCCESS)
        d->launchers[d->launcher_count++] = (launcher){name, kernel};
    return kernel;
}

/** Copies numbers to the next slot of the device, before all kernels that come. Returns the slot. */
static unsigned send_numbers(sph2d__device *d, const void *numbers, size_t bytes)
{
    if (bytes == 0)
        return d->slot;
    const void *from = memcpy(next_slot(d), numbers, bytes);
    if (d->error == CL_SUCCESS)
        fail(d,
             d->cl->clEnqueueWriteBuffer(d->queue, d->numbers, 0, (size_t)d->slot * SLOT, bytes, from, 0, NULL, NULL),
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
    send_old(d);
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
        fail(d, d->cl->clSetKernelArg(kernel, k, values[k].size, values[k].value), name);
    if (d->error == CL_SUCCESS)
        fail(d, d->cl->clEnqueueNDRangeKernel(d->queue, kernel, 1, NULL, &global, &local, 0, NULL, NULL), name);
    ++d->use.launches;
    for (size_t k = 0; k < MOST_BLOCKS; ++k)
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

/** Waits for the first `bytes` of results; zeros after a failure. */
static void read_results(sph2d__device *d, size_t bytes, const char *doing)
{
    if (d->error == CL_SUCCESS && bytes > 0)
        fail(d, d->cl->clEnqueueReadBuffer(d->queue, d->results, 1, 0, bytes, d->host_results, 0, NULL, NULL), doing);
    ++d->use.waits;
    d->unread = 0;
    d->use.fetched += bytes;
    if (d->error != CL_SUCCESS)
        memset(d->host_results, 0, bytes);
}

/** Makes room for results behind those that wait; where there is none, they are taken first, and the next ones have twice the room. */
static bool reserve_results(sph2d__device *d, size_t bytes)
{
    bytes = d->waiting_bytes + rounded(bytes > 0 ? bytes : 1);
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
        fail(d, error, "a buffer for results");
    }
    return true;
}

void sph2d__device_run(sph2d__device *d, const char *kernel, size_t count, const void *arguments, size_t bytes,
                       unsigned writes)
{
    if (reserve_results(d, 0))
        launch(d, kernel, count, arguments, bytes, writes);
    else
        fail(d, -6, kernel);
}

static size_t groups_of(size_t count)
{
    return (count + SPH2D__DEVICE_GROUP - 1) / SPH2D__DEVICE_GROUP;
}

const void *sph2d__device_results(sph2d__device *d, const char *kernel, size_t count, const void *arguments,
                                  size_t bytes, unsigned writes, size_t size)
{
    const size_t all = groups_of(count) * size;
    if (!reserve_results(d, all))
        return NULL;
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
        fail(d, -6, kernel);
        return;
    }
    launch(d, kernel, count, arguments, bytes, writes);
    d->waiting[d->waiting_count++] = (later){take, to, d->waiting_bytes, groups_of(count)};
    d->waiting_bytes += rounded(all);
}

void sph2d__device_finish(sph2d__device *d)
{
    wait(d, "waiting");
}

void sph2d__device_settle(sph2d__device *d)
{
    if (d->waiting_count == 0)
        return;
    read_results(d, d->waiting_bytes, "sums");
    take_waiting(d);
}
