/* SPDX-License-Identifier: MIT */
/** @file cloud.h
 *  A cloud of compressible liquid for method `wcsph` in the open, one at a time. */
#ifndef SPH2D_TESTS_CLOUD_H
#define SPH2D_TESTS_CLOUD_H

#include "common.h"

/** A scene and its blocks. */
typedef struct test_cloud {
    sph2d_scene scene;
    sph2d_block blocks[2];
} test_cloud;

extern test_cloud cloud;

/** Compressible liquid of speed of sound c0 [m/s]. */
void cloud_plain(double c0);
/** A cloud of 400 particles in the open, displaced by up to 0.2 spacings. */
void cloud_start(void);
/** Pseudorandom velocities of up to `speed` [m/s], by particle number. */
void cloud_stir(sph2d_sim *sim, double speed);

#endif
