/* SPDX-License-Identifier: MIT */
/** @file wall_names.h
 *  Numbers of a scene's walls: the sides of the domain, then its obstacles; and the names by which probes refer to
 *  them. */
#ifndef SPH2D_SCENE_WALL_NAMES_H
#define SPH2D_SCENE_WALL_NAMES_H

#include "sph2d/scene.h"

/** The sides; obstacle k is SPH2D__WALL_OBSTACLE + k. */
enum {
    SPH2D__WALL_LEFT,
    SPH2D__WALL_RIGHT,
    SPH2D__WALL_BOTTOM,
    SPH2D__WALL_TOP,
    SPH2D__WALL_OBSTACLE,
    SPH2D__WALL_ALL = -1 /**< in place of one: all of them */
};

/** The word of a side, 0 to 3: "left". */
const char *sph2d__side_word(int side);

/** What a side is. */
sph2d_side sph2d__side_of(const sph2d_scene *scene, int side);

/** How far a point is within a side, negative beyond it [m]. */
double sph2d__side_distance(const sph2d_scene *scene, int side, sph2d_vec2 point);

/** The wall of a name: a side's word, or an obstacle's name; SPH2D__WALL_ALL if there is none. */
int sph2d__wall_named(const sph2d_scene *scene, const char *name);

#endif
