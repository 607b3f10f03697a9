/* SPDX-License-Identifier: MIT */
/** @file device.h
 *  Devices that take the steps of a simulation in place of the processor: graphics cards and whatever else OpenCL 1.2
 *  knows. Its library is looked for when one of these functions is called; nothing else needs it.
 *
 *      size_t count = sph2d_devices(NULL, 0);
 *      options.device = 1;                      the first of them
 *
 *  A device with `same_bits` makes the results of the processor's instruction set `baseline` to the bit. */
#ifndef SPH2D_DEVICE_H
#define SPH2D_DEVICE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "sph2d/export.h"
#include "sph2d/sim.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A device. Texts are cut at their size. */
typedef struct sph2d_device {
    char name[96];     /**< as its driver calls it */
    char platform[64]; /**< whose OpenCL it is */
    char driver[64];   /**< version of the driver */
    bool gpu;          /**< a graphics card; else a processor, or something else */
    bool same_bits;    /**< rounds correctly, divisions and roots of floats as well, and has subnormal floats */
    char lacks[64];    /**< what a run needs and it does not have, "double precision"; empty: nothing */
    unsigned units;    /**< compute units */
    double memory;     /**< in all [bytes] */
    double largest;    /**< of one block, which has to hold all of a run [bytes] */
} sph2d_device;

/** What a device has done for a simulation since it was created. */
typedef struct sph2d_device_use {
    uint64_t launches; /**< of kernels */
    uint64_t waits;    /**< how often the processor waited for it */
    uint64_t sent;     /**< to it [bytes] */
    uint64_t fetched;  /**< from it [bytes] */
} sph2d_device_use;

/** Describes up to `room` devices, in an order that stays the same until hardware or drivers change. Returns how many there
 *  are, which may be more; 0 where there is no OpenCL. `out` may be NULL with a room of 0. */
SPH2D_API size_t sph2d_devices(sph2d_device *out, size_t room);

/** Why a device cannot take the steps of a scene, in words that follow "because": "a device does not know bodies". NULL: it can.
 *  Static storage. */
SPH2D_API const char *sph2d_device_refuses(const sph2d_scene *scene);

/** What the device of a simulation has done; zeros without one. */
SPH2D_API sph2d_device_use sph2d_sim_device_use(const sph2d_sim *sim);

/** Memory that any simulation takes on a device, for the arguments of kernels [bytes]. */
enum { SPH2D_DEVICE_FIXED_MEMORY = 2 << 20 };

/** Memory in use on the device of a simulation, that in it [bytes]; 0 on the processor. The first step takes most of it. A quarter
 *  more is reserved while there is room for it. */
SPH2D_API size_t sph2d_sim_device_memory(const sph2d_sim *sim);

/** Whether the device of a simulation works; SPH2D_OK on the processor, too. What is asked of the particles after a step has to be
 *  fetched: where that fails, numbers are old, and only this and the next step say so. Errors: SPH2D_DEVICE. */
SPH2D_API sph2d_status sph2d_sim_device_status(const sph2d_sim *sim, sph2d_report *report);

#ifdef __cplusplus
}
#endif

#endif
