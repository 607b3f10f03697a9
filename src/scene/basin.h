/* SPDX-License-Identifier: MIT */
/** @file basin.h
 *  How far the liquid of a scene can fall. */
#ifndef SPH2D_SCENE_BASIN_H
#define SPH2D_SCENE_BASIN_H

#include "sph2d/scene.h"

/** Largest height of a block, source or single particle above the lowest place that its liquid can get to [m], against
 *  gravity, which must not be 0. Liquid that starts with a head of `spare` [m], besides its height, gets as high as
 *  that and no higher; sides of the domain and obstacles that stand hold it. Where the domain has no such obstacle, or
 *  more than four million squares of the spacing, the lowest place is the domain's lowest corner. */
double sph2d__basin_height(const sph2d_scene *scene, double spare);

#endif
