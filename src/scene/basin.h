/* SPDX-License-Identifier: MIT */
/** @file basin.h
 *  The height from which the liquid of a scene can fall. */
#ifndef SPH2D_SCENE_BASIN_H
#define SPH2D_SCENE_BASIN_H

#include "sph2d/scene.h"

/** Largest height of a block, source or single particle above the lowest point that its liquid can reach [m], against
 *  gravity, which must not be 0. Liquid with a head of `extra_head` [m] in addition to its height can rise by that
 *  much; sides of the domain and fixed obstacles confine it. Without such obstacles, or with more than four million
 *  cells of the size of the spacing, the lowest point is the domain's lowest corner. */
double sph2d__basin_height(const sph2d_scene *scene, double extra_head);

#endif
