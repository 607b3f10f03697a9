/* SPDX-License-Identifier: MIT */
/** @file sampled.h
 *  Values of particles on a square lattice: at each node a linear function is fitted to those around it, by weighted least
 *  squares, so that linear fields are exact up to walls and surfaces. */
#ifndef SPH2D_RENDER_SAMPLED_H
#define SPH2D_RENDER_SAMPLED_H

#include <stdbool.h>
#include <stddef.h>

#include "sph2d/scene.h"

/** Nodes are at whole multiples of `step`. */
typedef struct sph2d__sampled {
    int columns, rows;
    double step;       /**< [m] */
    sph2d_vec2 origin; /**< the first node [m] */
    double *sums;      /**< of each node, row by row */
    size_t capacity;   /**< [nodes] */
} sph2d__sampled;

/** Two values a particle, or one: `second` is NULL. */
typedef struct sph2d__samples {
    size_t count;
    const double *x, *y; /**< [m] */
    const double *first, *second;
    double spacing; /**< of the particles [m] */
} sph2d__samples;

/** Lays a lattice over a box and adds the particles up; the step becomes larger where there were too many nodes. Values
 *  that are not finite are left out. False when memory is short. Starts with {0}. */
bool sph2d__sampled_take(sph2d__sampled *sampled, sph2d_box box, double step, const sph2d__samples *samples);

/** The place of a node. */
sph2d_vec2 sph2d__sampled_place(const sph2d__sampled *sampled, int column, int row);

/** The values at a node. False where less than `part` of the places around it, 0 to 1, has particles. */
bool sph2d__sampled_at(const sph2d__sampled *sampled, int column, int row, double part, double values[2]);

void sph2d__sampled_free(sph2d__sampled *sampled);

#endif
