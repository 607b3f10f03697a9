/* SPDX-License-Identifier: MIT */
/** @file packing.h
 *  Packs an area of any shape with as many particles as it holds.
 *
 *  Particles start in the cells of a grid, one per covered area of a cell, and move until the concentration gradient
 *  vanishes: sum_j dx^2 grad W_ij over the liquid, the boundary particles and the empty rest of the plane. A uniform
 *  pressure then exerts no force on any particle (Colagrossi, Bouscasse, Antuono & Marrone 2012). The gradient is that
 *  of an energy, sum W_ij, so that the descent converges. */
#ifndef SPH2D_START_PACKING_H
#define SPH2D_START_PACKING_H

#include "sim/simulation.h"
#include "start/region.h"

/** A packed area. */
typedef struct sph2d__packing {
    sph2d_vec2 *positions;
    size_t count;
    double residual; /**< largest remaining concentration gradient times the spacing */
} sph2d__packing;

/** Packs a region whose cells have the size of the particle spacing; walls are already placed. Away from edges that cut
 *  cells, and from obstacles, particles stay on the grid. `region` is overwritten, but must be freed. False when memory
 *  is short. The caller frees the packing. */
bool sph2d__pack(sph2d_sim *sim, sph2d__region *region, sph2d__packing *packing);
void sph2d__packing_free(sph2d__packing *packing, sph2d__memory *memory);

#endif
