/* SPDX-License-Identifier: MIT */
/** @file device.h
 *  The device of --device. */
#ifndef SPH2D_CLI_DEVICE_H
#define SPH2D_CLI_DEVICE_H

#include <sph2d/device.h>

#include "options.h"

/** Long enough for what device_describe() writes. */
#define TEXT_DEVICE_SIZE 128

/** What takes the steps. */
typedef struct device_choice {
    int number;         /**< in the list of `sph2d devices`; 0: the processor */
    bool same_bits;     /**< by --same-bits */
    sph2d_device about; /**< the device, unless it is the processor */
} device_choice;

/** Finds the device that the options name. Returns an exit code; otherwise prints an error. */
int device_choose(device_choice *choice, const cli_options *options);

/** The same by another process, for a command that forks later: drivers have threads, which a fork would lose. */
int device_choose_apart(device_choice *choice, const cli_options *options);

/** Sets the options of simulations. */
void device_set(sph2d_sim_options *sim, const device_choice *choice);

/** Says what takes the steps, unless it is the processor. */
void device_tell(const device_choice *choice);

/** "device 1 (NVIDIA H200)", or "" for the processor. Returns `out`. */
char *device_describe(char out[TEXT_DEVICE_SIZE], const device_choice *choice);

/** Its name, "cpu" for the processor. */
const char *device_name(const device_choice *choice);

/** All devices, which the caller frees. NULL where there are none, or with *short_of_memory. */
sph2d_device *device_list(size_t *count, bool *short_of_memory);

/** What to install where no device is found. */
extern const char device_hint[];

#endif
