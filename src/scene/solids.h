/* SPDX-License-Identifier: MIT */
/** @file solids.h
 *  The obstacles near a position. */
#ifndef SPH2D_SCENE_SOLIDS_H
#define SPH2D_SCENE_SOLIDS_H

#include "base/memory.h"
#include "sph2d/scene.h"

/** Obstacles sorted into the boxes of a grid over the domain; the boxes at its edge also stand for what lies beyond. */
typedef struct sph2d__solids {
    sph2d_box domain;
    size_t nx, ny;    /**< boxes; 0 without obstacles */
    size_t *first;    /**< of each box: its first in `obstacles`; one more than boxes */
    size_t *obstacle; /**< indices, in each box in order */
} sph2d__solids;

/** A list of obstacles, owned by the grid. */
typedef struct sph2d__solid_list {
    const size_t *obstacle; /**< indices in the scene, in order */
    size_t count;
} sph2d__solid_list;

/** Sorts the obstacles of a scene, with what is within six spacings of them, into an arena. False when memory is
 *  short. */
bool sph2d__solids_build(sph2d__solids *solids, const sph2d_scene *scene, sph2d__arena *arena, sph2d__memory *memory);

/** The obstacles that can enclose a position or be within six spacings of it, without periodic images. */
sph2d__solid_list sph2d__solids_near(const sph2d__solids *solids, sph2d_vec2 position);

#endif
