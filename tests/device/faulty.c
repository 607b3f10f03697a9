/* SPDX-License-Identifier: MIT */
/** @file faulty.c
 *  A libOpenCL.so.1 in front of the real one ($FAULTY_REAL), whose call number $FAULTY_AT fails, and all later ones but those that release,
 *  as when a device is lost; 0: none. At exit it writes how many calls there were to the file $FAULTY_COUNT. */
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>

#include "device/opencl_api.h"

enum { LOST = -5 };

static unsigned long calls, fails_at;
static sph2d__opencl real;

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
    fails_at = at ? strtoul(at, NULL, 10) : 0;
    atexit(tell);
}

static int fails(void)
{
    ++calls;
    return fails_at > 0 && calls >= fails_at;
}

#define EXPORT __attribute__((visibility("default")))
/* One that returns its error; and one that returns what it makes. */
#define STATUS(name, parameters, values)                                                                               \
    EXPORT cl_int name parameters                                                                                      \
    {                                                                                                                  \
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
MADE(cl_command_queue, clCreateCommandQueue, (cl_context in, cl_device_id of, cl_bits with, cl_int *error),
     (in, of, with, error))
RELEASED(clReleaseCommandQueue, cl_command_queue)
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
STATUS(clEnqueueNDRangeKernel,
       (cl_command_queue in, cl_kernel it, cl_uint dimensions, const size_t *offset, const size_t *global,
        const size_t *local, cl_uint waits, const cl_event *for_, cl_event *done),
       (in, it, dimensions, offset, global, local, waits, for_, done))
STATUS(clEnqueueReadBuffer,
       (cl_command_queue in, cl_mem from, cl_uint blocking, size_t offset, size_t size, void *to, cl_uint waits,
        const cl_event *for_, cl_event *done),
       (in, from, blocking, offset, size, to, waits, for_, done))
STATUS(clEnqueueWriteBuffer,
       (cl_command_queue in, cl_mem to, cl_uint blocking, size_t offset, size_t size, const void *from, cl_uint waits,
        const cl_event *for_, cl_event *done),
       (in, to, blocking, offset, size, from, waits, for_, done))
STATUS(clEnqueueCopyBuffer,
       (cl_command_queue in, cl_mem from, cl_mem to, size_t from_offset, size_t to_offset, size_t size, cl_uint waits,
        const cl_event *for_, cl_event *done),
       (in, from, to, from_offset, to_offset, size, waits, for_, done))
STATUS(clEnqueueFillBuffer,
       (cl_command_queue in, cl_mem to, const void *pattern, size_t pattern_size, size_t offset, size_t size,
        cl_uint waits, const cl_event *for_, cl_event *done),
       (in, to, pattern, pattern_size, offset, size, waits, for_, done))
STATUS(clFinish, (cl_command_queue in), (in))
