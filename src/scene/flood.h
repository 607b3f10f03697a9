/* SPDX-License-Identifier: MIT */
/** @file flood.h
 *  Where liquid of a scene can get to: a flood fill over the cells of a grid of the spacing, between neighbours whose
 *  centres no wall at rest separates. Obstacles that move, and bodies, are in nobody's way. */
#ifndef SPH2D_SCENE_FLOOD_H
#define SPH2D_SCENE_FLOOD_H

#include <stdint.h>

#include "scene/world.h"

typedef struct sph2d__flood {
    const sph2d__world *world;
    const sph2d_scene *scene;  /**< that of the world */
    double up_x, up_y, lowest; /**< unit vector upwards, or 0; height of the domain's lowest corner along it [m] */
    sph2d_vec2 origin;
    double size_x, size_y; /**< of a cell [m] */
    size_t nx, ny;
    unsigned char *closed; /**< bits of each cell for a wall to its neighbour in +x (1) or +y (2) */
    unsigned char *visited;
    uint32_t *queue;
    size_t queued;
    sph2d__memory memory;
} sph2d__flood;

/** Number of cells; more than four million are too many. */
double sph2d__flood_cells(const sph2d_scene *scene);

/** Makes the grid and marks the walls; `up`: unit vector upwards, or 0. False if there are too many cells, or memory is
 *  short; then there is nothing to free, and heights are known all the same. */
bool sph2d__flood_make(sph2d__flood *flood, const sph2d__world *world, sph2d_vec2 up);
void sph2d__flood_free(sph2d__flood *flood);

/** Puts liquid at a position, or into a shape: one cell at least. */
void sph2d__flood_position(sph2d__flood *flood, sph2d_vec2 p);
void sph2d__flood_shape(sph2d__flood *flood, const sph2d_shape *shape);

/** Lets it spread without rising above a level [m]; returns the lowest height that it reaches [m]. */
double sph2d__flood_spread(sph2d__flood *flood, double level);
/** Takes all liquid away. */
void sph2d__flood_clear(sph2d__flood *flood);

/** Whether liquid is at a position; outside the domain: in the cell nearest to it. */
bool sph2d__flood_reached(const sph2d__flood *flood, sph2d_vec2 p);

/** The height of a position, and heights of the lowest and highest corner of a box b, above the domain's lowest corner
 *  [m]. */
double sph2d__flood_height(const sph2d__flood *flood, sph2d_vec2 p);
sph2d_vec2 sph2d__flood_heights(const sph2d__flood *flood, sph2d_box b);

#endif
