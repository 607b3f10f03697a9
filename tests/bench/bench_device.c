/* SPDX-License-Identifier: MIT */
/** @file bench_device.c
 *  What a device can do at most, by the kernels of src/device/machine.cl. */
#include "bench.h"

#include "device/device.h"

/* Doubles of an array: no cache holds them. */
enum { DOUBLES = 1 << 22, ADDS = 8 * 1000, TRIES = 5 };

/** The least time of a kernel in some runs. */
static double least(sph2d__device *d, const char *kernel, uint64_t each)
{
    double best = 1e300;
    for (int k = 0; k < TRIES; ++k) {
        const double start = bench_wall();
        sph2d__device_run(d, kernel, each, &each, sizeof each, SPH2D__OF_SCENE);
        sph2d__device_finish(d);
        const double time = bench_wall() - start;
        best = time < best ? time : best;
    }
    return best;
}

bench_machine bench_machine_of_device(int device)
{
    sph2d__memory memory = sph2d__memory_from((sph2d_allocator){NULL, NULL});
    sph2d_report report = {0};
    sph2d_status status;
    bench_machine machine = {0, 0};
    sph2d__device *d = sph2d__device_open(device, "machine", 0, false, &memory, &status, &report);
    double *arrays = sph2d__alloc(&memory, 3 * (size_t)DOUBLES, sizeof *arrays);
    if (d && arrays) {
        sph2d__device_list(d);
        sph2d__device_place(d, arrays, 3 * (size_t)DOUBLES * sizeof *arrays, SPH2D__OF_SCENE);
        sph2d__device_moved(d);
        machine.bandwidth = 3.0 * DOUBLES * sizeof *arrays / least(d, "triad", DOUBLES);
        machine.flops = 2.0 * ADDS * DOUBLES / least(d, "multiply_add", DOUBLES);
    } else {
        fprintf(stderr, "bench: device %d: %s\n", device, report.count > 0 ? report.items[0].message : "out of memory");
    }
    void *block = arrays;
    sph2d__release(&memory, &block, arrays ? 3 * (size_t)DOUBLES : 0, sizeof *arrays);
    sph2d__device_close(d, &memory);
    return machine;
}
