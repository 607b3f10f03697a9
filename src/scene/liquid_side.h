/* SPDX-License-Identifier: MIT */
/** @file liquid_side.h
 *  The wet side of an open line, and the solid that a line becomes if both sides are wet. */
#ifndef SPH2D_SCENE_LIQUID_SIDE_H
#define SPH2D_SCENE_LIQUID_SIDE_H

#include "base/memory.h"

/** Thickness of the layers of a generalised wall: whole spacings, at least the support radius [m]. */
double sph2d__layer_thickness(const sph2d_scene *scene);

/** Whether a position lies in a block. */
bool sph2d__in_block(const sph2d_scene *scene, sph2d_vec2 p);

/** Whether liquid and solids fill the domain from the start: one block does, or no side is open and there is no room for
 *  a particle elsewhere, but for some along the edges of blocks. */
bool sph2d__liquid_fills(const sph2d_scene *scene);

/** Whether an obstacle is an open line with layers, so that it has a wet side. */
bool sph2d__obstacle_has_side(const sph2d_scene *scene, const sph2d_obstacle *obstacle);

/** Whether an obstacle is a closed outline with the liquid inside. */
bool sph2d__obstacle_is_hollow(const sph2d_obstacle *obstacle);

/** Whether a position lies in the solid of an obstacle: in a closed outline, or in the layers around a hollow one. */
bool sph2d__obstacle_fills(const sph2d_scene *scene, const sph2d_obstacle *obstacle, sph2d_vec2 p);

/** The wet side of such an obstacle: given by the scene, or found from blocks and sources. BOTH if the scene says so,
 *  or if there is liquid within the layers' thickness on both sides. */
sph2d_liquid_side sph2d__liquid_side(const sph2d_scene *scene, const sph2d_obstacle *obstacle);

/** The 2 count corners of a solid of a thickness, centred on a line of `count` points: along its left, then back along
 *  its right. False if the line turns too sharply; the corners are then invalid. */
bool sph2d__solid_of_line(sph2d_points line, double thickness, sph2d_vec2 *corners);

/** Sets the wet sides of a scene's obstacles, and replaces lines that are wet on both sides by solids; the new
 *  obstacles are in the arena. Errors: SPH2D_NOMEM. */
sph2d_status sph2d__resolve_obstacles(sph2d_scene *scene, sph2d__arena *arena, sph2d__memory *memory);

#endif
