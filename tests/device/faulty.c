/* SPDX-License-Identifier: MIT */
/** @file faulty.c
 *  A libOpenCL.so.1 in front of the real one ($FAULTY_REAL), whose call number $FAULTY_AT fails, and all later ones but those that release,
 *  as when a device is lost; 0: none. At exit it writes how many calls there were to the file $FAULTY_COUNT.
 *  With $FAULTY_LATE nothing is done before the host waits for it, as a driver may have it that is far behind. */
#include <dlfcn.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>

#include "device/opencl_api.h"

enum { LOST = -5 };

static unsigned long calls, fails_at;
static sph2d__opencl real;
static cl_event (*create_event)(cl_context, cl_int *);
static cl_int (*set_event)(cl_event, cl_int), (*release_event)(cl_event);

static void tell(void)
{
    const char *path = getenv("FAULTY_COUNT");
    FILE *to = path ? fopen(path, "w") : NULL;
    if (to) {
        fprintf(to, "%lu\n", calls);
        fclose(to);
    }
}

static void *symbol(void *library, const char *name)
{
    void *found = library ? dlsym(library, name) : NULL;
    if (!found) {
        fprintf(stderr, "faulty: no %s\n", name);
        exit(2);
    }
    return found;
}

__attribute__((constructor)) static void start(void)
{
    const char *path = getenv("FAULTY_REAL"), *at = getenv("FAULTY_AT");
    void *library = dlopen(path ? path : "libOpenCL.so.1", RTLD_NOW | RTLD_LOCAL);
#define TAKE(type, name, arguments) *(void **)&real.name = symbol(library, #name);
    SPH2D__OPENCL_FUNCTIONS(TAKE)
#undef TAKE
    if (getenv("FAULTY_LATE")) {
        *(void **)&create_event = symbol(library, "clCreateUserEvent");
        *(void **)&set_event = symbol(library, "clSetUserEventStatus");
        *(void **)&release_event = symbol(library, "clReleaseEvent");
    }
    fails_at = at ? strtoul(at, NULL, 10) : 0;
    atexit(tell);
}

static int fails(void)
{
    ++calls;
    return fails_at > 0 && calls >= fails_at;
}

/* ---- queues that stand still until the host waits ---------------------------------------------------------------- */

enum { MOST_QUEUES = 64 };

/* What the commands of a queue wait for. */
static struct held {
    cl_command_queue queue;
    cl_context context;
    cl_event gate;
} all_held[MOST_QUEUES];
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;

/** The entry of a queue, and of none an empty one; NULL: there is none. `by`: what it is from now on. */
static struct held *held_of(cl_command_queue queue, const struct held *by)
{
    struct held *found = NULL;
    pthread_mutex_lock(&lock);
    for (size_t k = 0; k < MOST_QUEUES && !found; ++k)
        found = all_held[k].queue == queue ? &all_held[k] : NULL;
    if (found && by)
        *found = *by;
    pthread_mutex_unlock(&lock);
    return found;
}

/** Lets a queue go on. */
static void let_go(cl_command_queue queue)
{
    struct held *entry = held_of(queue, NULL);
    if (!entry || !entry->gate)
        return;
    set_event(entry->gate, CL_SUCCESS);
    release_event(entry->gate);
    entry->gate = NULL;
}

/** What a command of a queue has to wait for: nothing if the host waits for it. */
static const cl_event *gate_of(cl_command_queue queue, cl_uint host_waits)
{
    struct held *entry = held_of(queue, NULL);
    cl_int error;
    if (host_waits)
        let_go(queue);
    else if (entry && !entry->gate)
        entry->gate = create_event(entry->context, &error);
    return entry && entry->gate ? &entry->gate : NULL;
}

/* ---- the functions ----------------------------------------------------------------------------------------------- */

#define EXPORT __attribute__((visibility("default")))
/* One that returns its error; and one that returns what it makes. */
#define STATUS(name, parameters, values)                                                                               \
    EXPORT cl_int name parameters                                                                                      \
    {                                                                                                                  \
        return fails() ? LOST : real.name values;                                                                      \
    }
#define QUEUED(name, parameters, blocking, values)                                                                     \
    EXPORT cl_int name parameters                                                                                      \
    {                                                                                                                  \
        for_ = gate_of(in, blocking);                                                                                  \
        waits = for_ != NULL;                                                                                          \
        return fails() ? LOST : real.name values;                                                                      \
    }
#define MADE(type, name, parameters, values)                                                                           \
    EXPORT type name parameters                                                                                        \
    {                                                                                                                  \
        if (!fails())                                                                                                  \
            return real.name values;                                                                                   \
        *error = LOST;                                                                                                 \
        return NULL;                                                                                                   \
    }
#define RELEASED(name, type)                                                                                           \
    EXPORT cl_int name(type it)                                                                                        \
    {                                                                                                                  \
        return real.name(it);                                                                                          \
    }

STATUS(clGetPlatformIDs, (cl_uint room, cl_platform_id *to, cl_uint *count), (room, to, count))
STATUS(clGetPlatformInfo, (cl_platform_id of, cl_uint what, size_t size, void *to, size_t *needed),
       (of, what, size, to, needed))
STATUS(clGetDeviceIDs, (cl_platform_id of, cl_bits type, cl_uint room, cl_device_id *to, cl_uint *count),
       (of, type, room, to, count))
STATUS(clGetDeviceInfo, (cl_device_id of, cl_uint what, size_t size, void *to, size_t *needed),
       (of, what, size, to, needed))
MADE(cl_context, clCreateContext,
     (const intptr_t *with, cl_uint count, const cl_device_id *of, void *notify, void *user, cl_int *error),
     (with, count, of, notify, user, error))
RELEASED(clReleaseContext, cl_context)
EXPORT cl_command_queue clCreateCommandQueue(cl_context in, cl_device_id of, cl_bits with, cl_int *error)
{
    *error = LOST;
    cl_command_queue made = fails() ? NULL : real.clCreateCommandQueue(in, of, with, error);
    if (made && create_event)
        held_of(NULL, &(struct held){made, in, NULL});
    return made;
}
EXPORT cl_int clReleaseCommandQueue(cl_command_queue it)
{
    const struct held *entry = held_of(it, NULL);
    if (entry && entry->gate) {
        fprintf(stderr, "faulty: a queue is released that may still read and write the host's memory\n");
        abort();
    }
    held_of(it, &(struct held){NULL, NULL, NULL});
    return real.clReleaseCommandQueue(it);
}
MADE(cl_mem, clCreateBuffer, (cl_context in, cl_bits flags, size_t size, void *host, cl_int *error),
     (in, flags, size, host, error))
RELEASED(clReleaseMemObject, cl_mem)
MADE(cl_program, clCreateProgramWithSource,
     (cl_context in, cl_uint count, const char **texts, const size_t *lengths, cl_int *error),
     (in, count, texts, lengths, error))
STATUS(clBuildProgram,
       (cl_program it, cl_uint count, const cl_device_id *of, const char *options, void *notify, void *user),
       (it, count, of, options, notify, user))
STATUS(clGetProgramBuildInfo, (cl_program it, cl_device_id of, cl_uint what, size_t size, void *to, size_t *needed),
       (it, of, what, size, to, needed))
RELEASED(clReleaseProgram, cl_program)
MADE(cl_kernel, clCreateKernel, (cl_program in, const char *name, cl_int *error), (in, name, error))
RELEASED(clReleaseKernel, cl_kernel)
STATUS(clSetKernelArg, (cl_kernel it, cl_uint index, size_t size, const void *value), (it, index, size, value))
QUEUED(clEnqueueNDRangeKernel,
       (cl_command_queue in, cl_kernel it, cl_uint dimensions, const size_t *offset, const size_t *global,
        const size_t *local, cl_uint waits, const cl_event *for_, cl_event *done),
       0, (in, it, dimensions, offset, global, local, waits, for_, done))
QUEUED(clEnqueueReadBuffer,
       (cl_command_queue in, cl_mem from, cl_uint blocking, size_t offset, size_t size, void *to, cl_uint waits,
        const cl_event *for_, cl_event *done),
       blocking, (in, from, blocking, offset, size, to, waits, for_, done))
QUEUED(clEnqueueWriteBuffer,
       (cl_command_queue in, cl_mem to, cl_uint blocking, size_t offset, size_t size, const void *from, cl_uint waits,
        const cl_event *for_, cl_event *done),
       blocking, (in, to, blocking, offset, size, from, waits, for_, done))
QUEUED(clEnqueueCopyBuffer,
       (cl_command_queue in, cl_mem from, cl_mem to, size_t from_offset, size_t to_offset, size_t size, cl_uint waits,
        const cl_event *for_, cl_event *done),
       0, (in, from, to, from_offset, to_offset, size, waits, for_, done))
QUEUED(clEnqueueFillBuffer,
       (cl_command_queue in, cl_mem to, const void *pattern, size_t pattern_size, size_t offset, size_t size,
        cl_uint waits, const cl_event *for_, cl_event *done),
       0, (in, to, pattern, pattern_size, offset, size, waits, for_, done))
EXPORT cl_int clFinish(cl_command_queue in)
{
    let_go(in);
    const cl_int error = real.clFinish(in); /* also of a device that is lost, which does no more */
    return fails() ? LOST : error;
}
