/* SPDX-License-Identifier: MIT */
/** @file device.c
 *  Opens devices by OpenCL, and closes them. */
#include "device/device.h"

#include <stdio.h>
#include <string.h>

#include "device/kernels.h"
#include "device/parts.h"

enum { OPTIONS = 96 };

void sph2d__device_fail(sph2d__device *d, cl_int error, const char *doing)
{
    if (error == CL_SUCCESS || d->error != CL_SUCCESS)
        return;
    d->error = error;
    d->doing = doing;
    if (d->queue) /* what came before may still read and write the host's memory */
        d->cl->clFinish(d->queue);
}

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
    sph2d_diagnostic_hint(sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_DEVICE, NULL, "%s: %s (OpenCL error %d) %s",
                                           d->description.name, sph2d__opencl_error(error), (int)error, log),
                          "if another machine takes them, see whether the driver can write where it keeps what it "
                          "compiles: docs/devices.md");
    return SPH2D_DEVICE;
}

static sph2d_status start(sph2d__device *d, const char *program, int kind, sph2d_report *report)
{
    cl_int error = CL_SUCCESS;
    d->context = d->cl->clCreateContext(NULL, 1, &d->id, NULL, NULL, &error);
    if (error == CL_SUCCESS)
        d->queue = d->cl->clCreateCommandQueue(d->context, d->id, 0, &error);
    if (error == CL_SUCCESS)
        d->numbers = d->cl->clCreateBuffer(d->context, CL_MEM_READ_WRITE, SPH2D_DEVICE_FIXED_MEMORY, NULL, &error);
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
    d->blocks = sph2d__alloc(memory, d->block_room = FIRST_ROOM, sizeof *d->blocks);
    if (d->slots && d->blocks)
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
    if (d->queue) /* kernels may still be at work, on numbers of the host */
        d->cl->clFinish(d->queue);
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
    void *own[] = {d->slots, d->host_results, d->blocks, d};
    sph2d__release(memory, &own[0], d->slots ? SLOTS + 1 : 0, SLOT);
    sph2d__release(memory, &own[1], d->host_results_bytes, 1);
    sph2d__release(memory, &own[2], d->blocks ? d->block_room : 0, sizeof *d->blocks);
    sph2d__release(memory, &own[3], 1, sizeof *d);
}

void sph2d__device_give_up(sph2d__device *d, const char *why)
{
    d->reason = d->error == CL_SUCCESS ? why : d->reason;
    sph2d__device_fail(d, 1, "its end");
}

bool sph2d__device_failed(const sph2d__device *d, const char **why, const char **kernel)
{
    *why = d->reason ? d->reason : sph2d__opencl_error(d->error);
    *kernel = d->doing;
    return d->error != CL_SUCCESS;
}

bool sph2d__device_lacks_memory(const sph2d__device *d)
{
    return d->error == CL_MEM_OBJECT_ALLOCATION_FAILURE || d->error == CL_OUT_OF_HOST_MEMORY ||
           d->error == CL_INVALID_BUFFER_SIZE;
}

size_t sph2d__device_bytes(const sph2d__device *d)
{
    return d->used + d->results_bytes + SPH2D_DEVICE_FIXED_MEMORY;
}

sph2d_device_use sph2d__device_used(const sph2d__device *d)
{
    return d->use;
}

const char *sph2d__device_name(const sph2d__device *d)
{
    return d->description.name;
}
