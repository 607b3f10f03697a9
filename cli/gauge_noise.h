/* SPDX-License-Identifier: MIT */
/** @file gauge_noise.h
 *  How noisy the series of a pressure gauge is. */
#ifndef SPH2D_CLI_GAUGE_NOISE_H
#define SPH2D_CLI_GAUGE_NOISE_H

#include <sph2d/io.h>

/** Of the last quarter of a series. */
typedef struct gauge_noise {
    double mean;      /**< [Pa] */
    double deviation; /**< root mean square of the differences from the running mean over a quarter of it [Pa] */
} gauge_noise;

/** Reads the series NAME.csv of a probe of kind pressure in the folder of a run. False when it cannot be read, is too
 *  short, with less than MIN_SAMPLES samples in its last quarter, or has samples without liquid there. */
bool gauge_noise_read(const char *path, gauge_noise *out);

#endif
