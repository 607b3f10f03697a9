/* SPDX-License-Identifier: MIT */
/** @file liquid_side.h
 *  Which side of an open line is wet, and the solid that a line becomes when both are. */
#ifndef SPH2D_SCENE_LIQUID_SIDE_H
#define SPH2D_SCENE_LIQUID_SIDE_H

#include "base/memory.h"
#include "scene/shape.h"

/** Thickness of the layers of a generalised wall: whole spacings, the support radius at least [m]. */
double sph2d__layer_thickness(const sph2d_scene *scene);

/** Whether a place lies in a block of liquid. */
bool sph2d__in_block(const sph2d_scene *scene, sph2d_vec2 p);

/** Whether an obstacle has layers on one side of an open line, so that its side matters. */
bool sph2d__obstacle_has_side(const sph2d_scene *scene, const sph2d_obstacle *obstacle);

/** The wet side of an obstacle that has sides: what the scene names, or where blocks and sources lie. BOTH when the
 *  scene says so, or when blocks lie within the layers' thickness on either side. */
sph2d_liquid_side sph2d__liquid_side(const sph2d_scene *scene, const sph2d_obstacle *obstacle);

/** Corners of the solid of a thickness that is centred on a line of `count` points: 2 count of them, on the left of the
 *  way first, then back on the right. False where the line turns too sharply: then they mean nothing. */
bool sph2d__solid_of_line(sph2d_points line, double thickness, sph2d_vec2 *corners);

/** Puts the sides that are found into a scene that the arena owns, and solids in the place of lines that are wet on
 *  both. Errors: SPH2D_NOMEM. */
sph2d_status sph2d__resolve_obstacles(sph2d_scene *scene, sph2d__arena *arena, sph2d__memory *memory);

#endif
