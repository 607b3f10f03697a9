/* SPDX-License-Identifier: MIT */
/** @file coverage.h
 *  What liquid covers, found by counting particles whatever the method says of their density: the part of a kernel that
 *  they fill, on a grid of half a spacing,
 *
 *      f(x) = dx^2 sum_j W(x - x_j) / part of the kernel that walls leave free,   W Wendland's C2 with H = 3 dx
 *
 *  1 inside liquid of rest density, 1/2 at a straight surface, beside a wall too. Inside it is density over rest
 *  density; where it is above a half liquid covers the place. Walls are the sides of the domain and closed obstacles
 *  where they are now; lines have no inside, and liquid at one covers what is in front of it as it does at a
 *  surface. */
#ifndef SPH2D_PROBES_COVERAGE_H
#define SPH2D_PROBES_COVERAGE_H

#include "sim/simulation.h"

/** Cells a spacing, the kernel's support radius [spacings], and what a cell counts that is all wall. */
enum { SPH2D__COVERAGE_CELLS = 2, SPH2D__COVERAGE_SUPPORT = 3, SPH2D__COVERAGE_WHOLE = 16 };

typedef struct sph2d__coverage {
    const sph2d_sim *sim;
    sph2d_vec2 origin;
    double size_x, size_y; /**< of a cell [m] */
    size_t nx, ny;         /**< cells; nodes are one more each way, or as many along a period */
    size_t nodes_x, nodes_y;
    float *fill;          /**< f at the nodes, row by row */
    unsigned char *solid; /**< of each cell: sixteenths that are wall */
} sph2d__coverage;

/** Counts. False when memory is short or the domain has more than 2^28 cells; then nothing has to be freed. */
bool sph2d__coverage_make(sph2d__coverage *coverage, const sph2d_sim *sim);
void sph2d__coverage_free(sph2d__coverage *coverage);

/** Node of a column or row, brought into the period; SIZE_MAX beyond the grid. */
size_t sph2d__coverage_node(long k, size_t nodes, size_t cells);
/** The cell of a place in one direction, and how far in it; false beyond the grid. */
bool sph2d__coverage_cell(double place, double origin, double size, size_t count, size_t *cell, double *in);
/** Whether a place lies beyond a side of the domain that is a wall. */
bool sph2d__coverage_beyond_wall(const sph2d_scene *scene, sph2d_vec2 p);

/** Area that liquid covers: of the grid, and of particles by themselves, which stand for dx^2 each [m^2]. */
double sph2d__coverage_area(const sph2d__coverage *coverage);

/** Height up to which so much liquid fills what it can get to from where it is, below that height and without passing
 *  a wall [m]; NaN unless gravity points straight down, and where there is no room for it. */
double sph2d__coverage_level(const sph2d__coverage *coverage, double area);

/** Looks from time to time how far the two are apart. */
void sph2d__sim_watch_density(sph2d_sim *sim);

#endif
