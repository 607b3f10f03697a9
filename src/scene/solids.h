/* SPDX-License-Identifier: MIT */
/** @file solids.h
 *  The walls near a position, but for sides. */
#ifndef SPH2D_SCENE_SOLIDS_H
#define SPH2D_SCENE_SOLIDS_H

#include "scene/world.h"

/** Walls sorted into the boxes of a grid over the world's box; the boxes at its edge also stand for what lies beyond. */
typedef struct sph2d__solids {
    sph2d_box box;
    size_t nx, ny; /**< boxes; 0 without walls */
    size_t *first; /**< of each box: its first in `wall`; one more than boxes */
    size_t *wall;  /**< numbers, in each box in order */
} sph2d__solids;

/** A list of walls, owned by the grid. */
typedef struct sph2d__solid_list {
    const size_t *wall; /**< numbers in the world, in order */
    size_t count;
} sph2d__solid_list;

/** Sorts the walls of a world but for sides, with what is within six spacings of them, into an arena. False when memory is
 *  short. */
bool sph2d__solids_build(sph2d__solids *solids, const sph2d__world *world, sph2d__arena *arena, sph2d__memory *memory);

/** The walls that can enclose a position or be within six spacings of it, without periodic images. */
sph2d__solid_list sph2d__solids_near(const sph2d__solids *solids, sph2d_vec2 position);

#endif
