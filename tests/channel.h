/* SPDX-License-Identifier: MIT */
/** @file channel.h
 *  A channel that liquid flows through, one at a time, and what tests of openings ask of it. */
#ifndef SPH2D_TESTS_CHANNEL_H
#define SPH2D_TESTS_CHANNEL_H

#include "common.h"

/** Spacing of the channel that channel_lay lays out [m]. */
#define CHANNEL_DX 0.025

/** A scene and what it points to, and its simulation once it started. */
typedef struct test_channel {
    sph2d_scene scene;
    sph2d_block blocks[3];
    sph2d_opening openings[2];
    sph2d_probe probes[2];
    sph2d_vec2 points[3]; /**< of a history */
    sph2d_sim *sim;
} test_channel;

extern test_channel channel;

/** Lays out a channel of water, without gravity, that flows at 1 m/s from the opening "in" on the left, with this
 *  velocity, to "out" on the right, with a pressure of 0; below and above are walls or it is periodic. A probe reads
 *  each opening. */
void channel_lay(double width, double height, bool walls);
/** Points the scene to two openings, "in" and "out", of which nothing is given yet, and to their probes. */
void channel_add_openings(void);
void channel_start(void);
void channel_run_until(double time);
/** Ends the simulation; for the end of every test. */
void channel_finish(void);

/** What a probe of an opening reads. */
typedef struct channel_reading {
    double velocity, flow_rate, let_in, pressure, wet;
} channel_reading;

channel_reading channel_read(size_t index);

/** All particles are those of the start, and those that came less those that left. */
void channel_check_count(uint64_t at_start);

/** How far developed flow between plates, of which the mean velocity is 1 m/s, is from its exact solution,
 *  u = 6 y/H (1 - y/H) and dp/dx = -12 mu/H^2 (Landau and Lifshitz 1987, eq. 17.3). */
typedef struct channel_error {
    double velocity; /**< largest difference inside [m/s] */
    double slope;    /**< of the pressure, as a part of the exact one */
} channel_error;

channel_error channel_parabola_error(void);

/** Both have the same particles with the same bits, and the same energy has come in. */
void channel_compare(sph2d_sim *a, sph2d_sim *b);

#endif
