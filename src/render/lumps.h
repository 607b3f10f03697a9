/* SPDX-License-Identifier: MIT */
/** @file lumps.h
 *  The field of wide balls from few of them. On a grid much finer than the balls, particles near a node can be one ball
 *  that weighs as much as they do: each is shared among the four nodes around it. */
#ifndef SPH2D_RENDER_LUMPS_H
#define SPH2D_RENDER_LUMPS_H

#include "render/dots.h"

/** Nodes are the middles of squares from the top left corner of a view. */
typedef struct sph2d__lumps {
    int columns, rows;
    double texel;    /**< side of a square [px] */
    float *weights;  /**< in particles, one a node, row by row */
    size_t capacity; /**< nodes that there is room for */
} sph2d__lumps;

/** With room for so many nodes. Errors: SPH2D_NOMEM. */
sph2d_status sph2d__lumps_create(sph2d__lumps *lumps, int columns, int rows, sph2d_report *report);

/** Empties a grid of another size, within the room that there is. */
void sph2d__lumps_reset(sph2d__lumps *lumps, int columns, int rows, double texel);

/** Shares a particle among the four nodes around it, such that their centre is its place; false where it has not four.
 */
bool sph2d__lumps_take(sph2d__lumps *lumps, const float pixel[2]);

/** Draws a list with the program, target and blending in use: the lumps of an empty grid, and as they are the particles
 *  that it does not take. */
void sph2d__lumps_draw(const sph2d__gl *gl, sph2d__lumps *lumps, sph2d__dots *dots, const sph2d__view *view,
                       const sph2d__dot_list *list);

/** Frees it; zeros are fine. */
void sph2d__lumps_destroy(sph2d__lumps *lumps);

#endif
