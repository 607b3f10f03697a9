/* SPDX-License-Identifier: MIT */
/** @file lumps.h
 *  The field of wide balls from fewer balls. On a grid much finer than the balls, the particles near a node are
 *  replaced by one ball with their total weight: each particle is distributed over the four nodes around it (cloud in
 *  cell). */
#ifndef SPH2D_RENDER_LUMPS_H
#define SPH2D_RENDER_LUMPS_H

#include "render/dots.h"
#include "render/field_grid.h"

/** Nodes are the centres of squares, from the top left corner of a view. */
typedef struct sph2d__lumps {
    int columns, rows;
    double texel;    /**< side of a square [px] */
    float *weights;  /**< in particles, one a node, row by row */
    size_t capacity; /**< [nodes] */
} sph2d__lumps;

/** Creates a grid with a capacity of columns x rows nodes. Errors: SPH2D_NOMEM. */
sph2d_status sph2d__lumps_create(sph2d__lumps *lumps, int columns, int rows, sph2d_report *report);

/** Empties the grid and sets its size, within its capacity. */
void sph2d__lumps_reset(sph2d__lumps *lumps, int columns, int rows, double texel);

/** Distributes a particle over the four nodes around it by bilinear weights; false if it is not between four nodes. */
bool sph2d__lumps_add(sph2d__lumps *lumps, const float pixel[2]);

/** Adds the balls of a list, of a radius [px], to the sums at the nodes: particles between the nodes as lumps, with what
 *  is in them already, the others one by one. */
void sph2d__lumps_sum(sph2d__lumps *lumps, sph2d__field_grid *grid, const sph2d__view *view,
                      const sph2d__dot_list *list, double radius);

/** Frees it; it may be zeroed. */
void sph2d__lumps_destroy(sph2d__lumps *lumps);

#endif
