/* SPDX-License-Identifier: MIT */
/** @file overlap.h
 *  Whether obstacles overlap each other, or the sides of the domain. */
#ifndef SPH2D_SCENE_OVERLAP_H
#define SPH2D_SCENE_OVERLAP_H

#include "scene/pose.h"

/** Whether an obstacle in a pose overlaps another one in its place, deeper than a depth [m]; circles as pieces no longer
 *  than `spacing`. */
bool sph2d__obstacles_overlap(const sph2d_obstacle *obstacle, const sph2d__pose *pose, const sph2d_obstacle *other,
                              double spacing, double depth);

/** How far an outline in a pose is beyond a side that is no opening [m], and the word of that side. */
double sph2d__beyond_sides(const sph2d_scene *scene, const sph2d_shape *outline, const sph2d__pose *pose,
                           double spacing, const char **side);

/** The distance of an outline in a pose from a side of the domain (scene/wall_names.h) [m], negative beyond it; INFINITY
 *  if it is no wall. */
double sph2d__side_gap(const sph2d_scene *scene, const sph2d_shape *outline, const sph2d__pose *pose, double spacing,
                       int side);

/** The distance of an obstacle in a pose from another one in its place [m], as long as they do not overlap. Hollow
 *  circles and arcs as pieces no longer than `spacing`. */
double sph2d__obstacles_gap(const sph2d_obstacle *obstacle, const sph2d__pose *pose, const sph2d_obstacle *other,
                            double spacing);

#endif
