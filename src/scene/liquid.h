/* SPDX-License-Identifier: MIT */
/** @file liquid.h
 *  The liquid of a scene: what it starts with, where it is, which side of an open line it wets, and the solid that a line
 *  becomes if both are wet. */
#ifndef SPH2D_SCENE_LIQUID_H
#define SPH2D_SCENE_LIQUID_H

#include "scene/world.h"

/** Whether a scene has the liquid of a snapshot: it names one, and no particles that take their values from it. */
bool sph2d__starts_from_snapshot(const sph2d_scene *scene);

/** Whether it has liquid of a file: single particles, or those of a snapshot. */
bool sph2d__liquid_is_from_file(const sph2d_scene *scene);

/** The largest speed of a start, without the velocity that it is added to [m/s]: as given, or of its values. */
double sph2d__start_speed(const sph2d_start *start);

/** Thickness of the layers of a generalised wall of a resolved scene: whole spacings, at least the support radius [m]. */
double sph2d__layer_thickness(const sph2d_scene *scene);

/** Whether a position lies in a block. */
bool sph2d__in_block(const sph2d_scene *scene, sph2d_vec2 p);

/** Whether liquid and solids fill the domain from the start: one block does, or no side is open and there is no room for
 *  a particle elsewhere, but for some along the edges of blocks. Bodies do not count: they move out of the way. */
bool sph2d__liquid_fills(const sph2d__world *world);

/** Whether a wall is an open line with layers, so that it has a wet side. */
bool sph2d__wall_has_side(const sph2d__wall *wall);

/** Whether a wall is a closed outline with the liquid inside. */
bool sph2d__wall_is_hollow(const sph2d__wall *wall);

/** Whether a position lies in the solid of a wall: in a closed outline, or in the layers around a hollow one. */
bool sph2d__wall_fills(const sph2d_scene *scene, const sph2d__wall *wall, sph2d_vec2 p);

/** The wet side of such a wall: given by the scene, or found from blocks and sources. BOTH if the scene says so,
 *  or if there is liquid within the layers' thickness on both sides. */
sph2d_liquid_side sph2d__liquid_side(const sph2d_scene *scene, const sph2d__wall *wall);

/** The 2 count corners of a solid of a thickness, centred on a line of `count` points: along its left, then back along
 *  its right. False if the line turns too sharply; the corners are then invalid. */
bool sph2d__solid_of_line(sph2d_points line, double thickness, sph2d_vec2 *corners);

/** Sets the wet sides of a world's walls and of its scene's obstacles, and replaces lines that are wet on both sides by
 *  solids; what is new is in the arena. Errors: SPH2D_NOMEM. */
sph2d_status sph2d__resolve_sides(sph2d__world *world, sph2d__arena *arena, sph2d__memory *memory);

#endif
