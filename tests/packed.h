/* SPDX-License-Identifier: MIT */
/** @file packed.h
 *  Scenes of liquid that must be packed: tanks and wedges whose walls no lattice fits, one at a time. */
#ifndef SPH2D_TESTS_PACKED_H
#define SPH2D_TESTS_PACKED_H

#include "common.h"

/** The spacing [m]. */
static const double DX = 0.01;

/** A scene with what it points to: one block of liquid, and an obstacle that counts where obstacle_count is 1. */
typedef struct test_packed {
    sph2d_scene scene;
    sph2d_block block;
    sph2d_obstacle obstacle;
    sph2d_vec2 corners[72]; /**< of the block */
    sph2d_vec2 line[4];     /**< of the obstacle */
} test_packed;

extern test_packed packed;

/** A domain of 1.4 m, open all around, with a block of 0.6 m by 0.4 m at (0, 0), for method `wcsph`. */
void packed_start(void);

/** Makes the block the polygon of the first so many corners; the obstacle the polyline of the first so many points. */
void packed_set_polygon(size_t count);
void packed_set_line(size_t count);

/** A wedge whose walls are `degrees` apart, 0.5 m deep or 1 m wide. Returns its area. */
double packed_set_wedge(double degrees);
/** A tank 0.6 m by 0.4 m that is turned about (0.3, 0.1), with liquid 0.3 m deep. */
void packed_set_turned_tank(double degrees);

#endif
