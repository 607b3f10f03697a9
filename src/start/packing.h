/* SPDX-License-Identifier: MIT */
/** @file packing.h
 *  Places for as many particles as an area holds, at edges and walls of any slope.
 *
 *  Places start on the cells of a grid, one for each cell's worth of area that is covered, and move until the gradient
 *  of concentration, sum_j dx^2 grad W_ij over the liquid, the boundary particles and what fills the rest of the room,
 *  is gone: equal pressure then pushes no particle (Colagrossi, Bouscasse, Antuono & Marrone 2012). The gradient is
 *  that of an energy, sum W_ij, so that the descent ends. */
#ifndef SPH2D_START_PACKING_H
#define SPH2D_START_PACKING_H

#include "sim/simulation.h"
#include "start/region.h"

/** A packed area. */
typedef struct sph2d__packing {
    sph2d_vec2 *places;
    size_t count;
    double residual; /**< largest gradient of concentration that is left, times the spacing */
} sph2d__packing;

/** Packs a region whose cells are the spacing of its particles; walls are placed. Away from edges that pass through
 *  cells, and from obstacles that take places, places stay on the grid. `region` is used up, but must be freed. False
 *  when memory is short. The caller frees the packing. */
bool sph2d__pack(sph2d_sim *sim, sph2d__region *region, sph2d__packing *packing);
void sph2d__packing_free(sph2d__packing *packing, sph2d__memory *memory);

#endif
