/* SPDX-License-Identifier: MIT */
/** @file opencl_api.h
 *  What is used of OpenCL 1.2: its types, numbers and functions (Khronos, The OpenCL Specification 1.2, 2012), so that no
 *  headers of it are needed. Its library is looked for when a program asks for devices (opencl.c). */
#ifndef SPH2D_DEVICE_OPENCL_API_H
#define SPH2D_DEVICE_OPENCL_API_H

#include <stddef.h>
#include <stdint.h>

typedef struct _cl_platform_id *cl_platform_id;
typedef struct _cl_device_id *cl_device_id;
typedef struct _cl_context *cl_context;
typedef struct _cl_command_queue *cl_command_queue;
typedef struct _cl_mem *cl_mem;
typedef struct _cl_program *cl_program;
typedef struct _cl_kernel *cl_kernel;
typedef struct _cl_event *cl_event;
typedef int32_t cl_int;
typedef uint32_t cl_uint;
typedef uint64_t cl_bits;

enum {
    CL_SUCCESS = 0,
    CL_DEVICE_NOT_AVAILABLE = -2,
    CL_MEM_OBJECT_ALLOCATION_FAILURE = -4,
    CL_OUT_OF_RESOURCES = -5,
    CL_OUT_OF_HOST_MEMORY = -6,
    CL_BUILD_PROGRAM_FAILURE = -11,
    CL_INVALID_COMMAND_QUEUE = -36,
    CL_INVALID_BUFFER_SIZE = -61,
    CL_PLATFORM_NAME = 0x0902,
    CL_DEVICE_TYPE = 0x1000,
    CL_DEVICE_MAX_COMPUTE_UNITS = 0x1002,
    CL_DEVICE_MAX_WORK_GROUP_SIZE = 0x1004,
    CL_DEVICE_ADDRESS_BITS = 0x100d,
    CL_DEVICE_MAX_MEM_ALLOC_SIZE = 0x1010,
    CL_DEVICE_SINGLE_FP_CONFIG = 0x101b,
    CL_DEVICE_GLOBAL_MEM_SIZE = 0x101f,
    CL_DEVICE_LOCAL_MEM_SIZE = 0x1023,
    CL_DEVICE_ENDIAN_LITTLE = 0x1026,
    CL_DEVICE_AVAILABLE = 0x1027,
    CL_DEVICE_COMPILER_AVAILABLE = 0x1028,
    CL_DEVICE_NAME = 0x102b,
    CL_DRIVER_VERSION = 0x102d,
    CL_DEVICE_DOUBLE_FP_CONFIG = 0x1032,
    CL_PROGRAM_BUILD_LOG = 0x1183
};

#define CL_DEVICE_TYPE_GPU ((cl_bits)1 << 2)
#define CL_DEVICE_TYPE_ALL ((cl_bits)0xffffffff)
#define CL_FP_DENORM ((cl_bits)1 << 0)
#define CL_FP_INF_NAN ((cl_bits)1 << 1)
#define CL_FP_ROUND_TO_NEAREST ((cl_bits)1 << 2)
#define CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT ((cl_bits)1 << 7)
#define CL_MEM_READ_WRITE ((cl_bits)1 << 0)

/** On Windows functions of OpenCL have a calling convention of their own on 32 bits, which are refused. */
#define SPH2D__OPENCL_FUNCTIONS(X)                                                                                     \
    X(cl_int, clGetPlatformIDs, (cl_uint room, cl_platform_id * platforms, cl_uint * count))                           \
    X(cl_int, clGetPlatformInfo, (cl_platform_id, cl_uint what, size_t size, void *value, size_t *needed))             \
    X(cl_int, clGetDeviceIDs, (cl_platform_id, cl_bits type, cl_uint room, cl_device_id *, cl_uint * count))           \
    X(cl_int, clGetDeviceInfo, (cl_device_id, cl_uint what, size_t size, void *value, size_t *needed))                 \
    X(cl_context, clCreateContext,                                                                                     \
      (const intptr_t *properties, cl_uint count, const cl_device_id *, void *notify, void *user, cl_int *error))      \
    X(cl_int, clReleaseContext, (cl_context))                                                                          \
    X(cl_command_queue, clCreateCommandQueue, (cl_context, cl_device_id, cl_bits properties, cl_int * error))          \
    X(cl_int, clReleaseCommandQueue, (cl_command_queue))                                                               \
    X(cl_mem, clCreateBuffer, (cl_context, cl_bits flags, size_t size, void *host, cl_int *error))                     \
    X(cl_int, clReleaseMemObject, (cl_mem))                                                                            \
    X(cl_program, clCreateProgramWithSource,                                                                           \
      (cl_context, cl_uint count, const char **texts, const size_t *lengths, cl_int *error))                           \
    X(cl_int, clBuildProgram,                                                                                          \
      (cl_program, cl_uint count, const cl_device_id *, const char *options, void *notify, void *user))                \
    X(cl_int, clGetProgramBuildInfo, (cl_program, cl_device_id, cl_uint what, size_t size, void *value, size_t *))     \
    X(cl_int, clReleaseProgram, (cl_program))                                                                          \
    X(cl_kernel, clCreateKernel, (cl_program, const char *name, cl_int *error))                                        \
    X(cl_int, clReleaseKernel, (cl_kernel))                                                                            \
    X(cl_int, clSetKernelArg, (cl_kernel, cl_uint index, size_t size, const void *value))                              \
    X(cl_int, clEnqueueNDRangeKernel,                                                                                  \
      (cl_command_queue, cl_kernel, cl_uint dimensions, const size_t *offset, const size_t *global,                    \
       const size_t *local, cl_uint waits, const cl_event *, cl_event *))                                              \
    X(cl_int, clEnqueueReadBuffer,                                                                                     \
      (cl_command_queue, cl_mem, cl_uint blocking, size_t offset, size_t size, void *to, cl_uint waits,                \
       const cl_event *, cl_event *))                                                                                  \
    X(cl_int, clEnqueueWriteBuffer,                                                                                    \
      (cl_command_queue, cl_mem, cl_uint blocking, size_t offset, size_t size, const void *from, cl_uint waits,        \
       const cl_event *, cl_event *))                                                                                  \
    X(cl_int, clEnqueueCopyBuffer,                                                                                     \
      (cl_command_queue, cl_mem from, cl_mem to, size_t from_offset, size_t to_offset, size_t size, cl_uint waits,     \
       const cl_event *, cl_event *))                                                                                  \
    X(cl_int, clEnqueueFillBuffer,                                                                                     \
      (cl_command_queue, cl_mem, const void *pattern, size_t pattern_size, size_t offset, size_t size, cl_uint waits,  \
       const cl_event *, cl_event *))                                                                                  \
    X(cl_int, clFinish, (cl_command_queue))

/** The library's functions. */
typedef struct sph2d__opencl {
#define SPH2D__OPENCL_MEMBER(type, name, arguments) type(*name) arguments;
    SPH2D__OPENCL_FUNCTIONS(SPH2D__OPENCL_MEMBER)
#undef SPH2D__OPENCL_MEMBER
} sph2d__opencl;

/** The functions; NULL where there is no such library, or an older one. It stays loaded. */
const sph2d__opencl *sph2d__opencl_find(void);

/** Device number `k`, from 0 on, in the order of the platforms; NULL: there are not so many. */
cl_device_id sph2d__opencl_device(const sph2d__opencl *cl, size_t k, cl_platform_id *platform);

/** The meaning of an error. */
const char *sph2d__opencl_error(cl_int error);

#endif
