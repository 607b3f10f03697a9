/* SPDX-License-Identifier: MIT */
/** @file coverage.h
 *  The area that liquid covers, from particle positions alone, not from the method's density: the fill fraction on a
 *  grid of half a spacing,
 *
 *      f(x) = dx^2 sum_j W(x - x_j) / part of the kernel that walls leave free,   W Wendland's C2 with H = 3 dx
 *
 *  1 inside liquid of rest density, 1/2 at a straight surface, also beside a wall. Inside the liquid f is density over
 *  rest density; where it is above 1/2 the position is covered by liquid. Walls are the sides of the domain and closed
 *  obstacles in their present position; lines have no interior, and are treated like a free surface. */
#ifndef SPH2D_PROBES_COVERAGE_H
#define SPH2D_PROBES_COVERAGE_H

#include "sim/simulation.h"

/** Cells per spacing, the kernel's support radius [spacings], and the sample points of a cell. */
enum { SPH2D__COVERAGE_CELLS = 2, SPH2D__COVERAGE_SUPPORT = 3, SPH2D__COVERAGE_FULL = 16 };

typedef struct sph2d__coverage {
    const sph2d_sim *sim;
    sph2d_vec2 origin;
    double size_x, size_y; /**< of a cell [m] */
    size_t nx, ny;         /**< cells; nodes are one more each way, or as many along a period */
    size_t nodes_x, nodes_y;
    float *fill;          /**< f at the nodes, row by row */
    unsigned char *solid; /**< of each cell: sample points inside walls, or in reservoirs of openings, of 16 */
} sph2d__coverage;

/** Computes the grid. False when memory is short or the domain has more than 2^28 cells; then there is nothing to
 *  free. */
bool sph2d__coverage_make(sph2d__coverage *coverage, const sph2d_sim *sim);
void sph2d__coverage_free(sph2d__coverage *coverage);

/** Index of a node in one direction, wrapped into the period; SIZE_MAX beyond the grid. */
size_t sph2d__coverage_node(long k, size_t nodes, size_t cells);
/** The cell of a coordinate, and the fraction of the cell before it; false beyond the grid. */
bool sph2d__coverage_cell(double position, double origin, double size, size_t count, size_t *cell, double *in);
/** Whether a position lies beyond a side of the domain that is a wall. */
bool sph2d__coverage_beyond_wall(const sph2d__world *world, sph2d_vec2 p);

/** The covered area: that of the grid, and dx^2 for each isolated particle; without reservoirs [m^2]. */
double sph2d__coverage_area(const sph2d__coverage *coverage);

/** The area of the particles at rest density, without those in reservoirs of openings [m^2]. */
double sph2d__placed_area(const sph2d_sim *sim);

/** Height of the level surface of an area of liquid that fills the space connected to the liquid without crossing
 *  walls, from below [m]; NaN if that space is too small, or unless gravity points straight down. */
double sph2d__coverage_level(const sph2d__coverage *coverage, double area);

/** Samples the difference of reported and counted density every few steps. Errors: SPH2D_NOMEM. */
sph2d_status sph2d__sim_watch_density(sph2d_sim *sim);

#endif
