/* SPDX-License-Identifier: MIT */
/** @file overlap.h
 *  Whether walls overlap each other, or the sides of the domain. */
#ifndef SPH2D_SCENE_OVERLAP_H
#define SPH2D_SCENE_OVERLAP_H

#include "scene/pose.h"
#include "scene/world.h"

/** Whether a wall in a pose overlaps another one in its place, deeper than a depth [m]; circles as pieces no longer
 *  than `spacing`. */
bool sph2d__walls_overlap(const sph2d__wall *wall, const sph2d__pose *pose, const sph2d__wall *other, double spacing,
                          double depth);

/** How far an outline in a pose is beyond a side that is no opening [m], and the word of that side. */
double sph2d__beyond_sides(const sph2d_scene *scene, const sph2d_shape *outline, const sph2d__pose *pose,
                           double spacing, const char **side);

/** The distance of an outline in a pose from a side of the domain (scene/world.h) [m], negative beyond it; INFINITY
 *  if it is no wall. */
double sph2d__side_gap(const sph2d_scene *scene, const sph2d_shape *outline, const sph2d__pose *pose, double spacing,
                       int side);

/** The distance of a wall in a pose from another one in its place [m], as long as they do not overlap. Hollow
 *  circles and arcs as pieces no longer than `spacing`. */
double sph2d__walls_gap(const sph2d__wall *wall, const sph2d__pose *pose, const sph2d__wall *other, double spacing);

#endif
