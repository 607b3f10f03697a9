/* SPDX-License-Identifier: MIT */
/** @file opencl.c
 *  Finds OpenCL's library and its devices. */
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "base/system.h"
#include "device/opencl_api.h"
#include "sph2d/device.h"

enum { MOST_PLATFORMS = 16, MOST_DEVICES = 64 };

/* Where the library is, by system. */
static const char *const names[] = {"libOpenCL.so.1", "libOpenCL.so", "OpenCL.dll",
                                    "/System/Library/Frameworks/OpenCL.framework/OpenCL", NULL};

static bool take_functions(sph2d__opencl *cl, void *library)
{
    bool whole = true;
#define TAKE(type, name, arguments)                                                                                    \
    {                                                                                                                  \
        void *found = sph2d__library_symbol(library, #name);                                                           \
        memcpy(&cl->name, &found, sizeof found); /* C has no conversion from objects to functions */                   \
        whole = whole && found;                                                                                        \
    }
    SPH2D__OPENCL_FUNCTIONS(TAKE)
#undef TAKE
    return whole;
}

cl_device_id sph2d__opencl_device(const sph2d__opencl *cl, size_t k, cl_platform_id *platform)
{
    cl_platform_id platforms[MOST_PLATFORMS];
    cl_uint platform_count = 0;
    if (!cl || cl->clGetPlatformIDs(MOST_PLATFORMS, platforms, &platform_count) != CL_SUCCESS)
        return NULL;
    for (cl_uint p = 0; p < platform_count && p < MOST_PLATFORMS; ++p) {
        cl_device_id devices[MOST_DEVICES];
        cl_uint count = 0;
        if (cl->clGetDeviceIDs(platforms[p], CL_DEVICE_TYPE_ALL, MOST_DEVICES, devices, &count) != CL_SUCCESS)
            continue;
        count = count < MOST_DEVICES ? count : MOST_DEVICES;
        if (k < count) {
            *platform = platforms[p];
            return devices[k];
        }
        k -= count;
    }
    return NULL;
}

/** Where the functions are once they are found. The first question makes drivers set themselves up, and not all of them
 *  take it from two threads at once. */
static const sph2d__opencl *find(void)
{
    static sph2d__opencl functions;
    static enum { NOT_TRIED, MISSING, FOUND } state;
    for (size_t k = 0; state == NOT_TRIED && names[k]; ++k) {
        void *library = sph2d__library_open(names[k]);
        if (!library || !take_functions(&functions, library))
            continue;
        cl_platform_id platform;
        sph2d__opencl_device(&functions, SIZE_MAX, &platform);
        state = FOUND;
    }
    state = state == FOUND ? FOUND : MISSING;
    return state == FOUND ? &functions : NULL;
}

const sph2d__opencl *sph2d__opencl_find(void)
{
    const sph2d__opencl *found;
#pragma omp critical(sph2d_opencl)
    found = find();
    return found;
}

static cl_bits bits_of(const sph2d__opencl *cl, cl_device_id device, cl_uint what)
{
    cl_bits value = 0; /* of 4 or 8 bytes: the machine is little-endian, as the device has to be */
    return cl->clGetDeviceInfo(device, what, sizeof value, &value, NULL) == CL_SUCCESS ? value : 0;
}

static const char *lack_of(const sph2d__opencl *cl, cl_device_id device)
{
    const cl_bits doubles = bits_of(cl, device, CL_DEVICE_DOUBLE_FP_CONFIG);
    if (!(bits_of(cl, device, CL_DEVICE_AVAILABLE) & 1))
        return "it is not available";
    if (!(bits_of(cl, device, CL_DEVICE_COMPILER_AVAILABLE) & 1))
        return "a compiler";
    if (!(doubles & CL_FP_ROUND_TO_NEAREST) || !(doubles & CL_FP_INF_NAN))
        return "double precision";
    if (bits_of(cl, device, CL_DEVICE_ADDRESS_BITS) != 64 || !(bits_of(cl, device, CL_DEVICE_ENDIAN_LITTLE) & 1))
        return "addresses of 64 bits, lowest byte first";
    if (bits_of(cl, device, CL_DEVICE_MAX_WORK_GROUP_SIZE) < 256)
        return "groups of 256 threads";
    return "";
}

static void describe(const sph2d__opencl *cl, cl_device_id device, cl_platform_id platform, sph2d_device *out)
{
    *out = (sph2d_device){.gpu = bits_of(cl, device, CL_DEVICE_TYPE) & CL_DEVICE_TYPE_GPU,
                          .units = (unsigned)bits_of(cl, device, CL_DEVICE_MAX_COMPUTE_UNITS),
                          .memory = (double)bits_of(cl, device, CL_DEVICE_GLOBAL_MEM_SIZE),
                          .largest = (double)bits_of(cl, device, CL_DEVICE_MAX_MEM_ALLOC_SIZE)};
    char text[1024] = "";
    if (cl->clGetDeviceInfo(device, CL_DEVICE_NAME, sizeof text - 1, text, NULL) == CL_SUCCESS)
        snprintf(out->name, sizeof out->name, "%s", text);
    memset(text, 0, sizeof text);
    if (cl->clGetDeviceInfo(device, CL_DRIVER_VERSION, sizeof text - 1, text, NULL) == CL_SUCCESS)
        snprintf(out->driver, sizeof out->driver, "%s", text);
    memset(text, 0, sizeof text);
    if (cl->clGetPlatformInfo(platform, CL_PLATFORM_NAME, sizeof text - 1, text, NULL) == CL_SUCCESS)
        snprintf(out->platform, sizeof out->platform, "%s", text);
    const cl_bits floats = bits_of(cl, device, CL_DEVICE_SINGLE_FP_CONFIG);
    out->same_bits = floats & CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT && floats & CL_FP_DENORM &&
                     bits_of(cl, device, CL_DEVICE_DOUBLE_FP_CONFIG) & CL_FP_DENORM;
    snprintf(out->lacks, sizeof out->lacks, "%s", lack_of(cl, device));
}

size_t sph2d_devices(sph2d_device *out, size_t room)
{
    const sph2d__opencl *cl = sph2d__opencl_find();
    cl_platform_id platform;
    cl_device_id device;
    size_t count = 0;
    for (; (device = sph2d__opencl_device(cl, count, &platform)) != NULL; ++count)
        if (out && count < room)
            describe(cl, device, platform, &out[count]);
    return count;
}

const char *sph2d__opencl_error(cl_int error)
{
    switch (error) {
    case CL_DEVICE_NOT_AVAILABLE:
        return "the device is not available";
    case CL_MEM_OBJECT_ALLOCATION_FAILURE:
    case CL_INVALID_BUFFER_SIZE:
        return "the device has not enough memory";
    case CL_OUT_OF_RESOURCES:
        return "the device is out of resources, or lost";
    case CL_OUT_OF_HOST_MEMORY:
        return "its driver has not enough memory";
    case CL_BUILD_PROGRAM_FAILURE:
        return "its compiler does not take the kernels";
    case CL_INVALID_COMMAND_QUEUE:
        return "its queue is not valid any more";
    default:
        return "its driver reports an error";
    }
}
