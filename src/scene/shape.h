/* SPDX-License-Identifier: MIT */
/** @file shape.h
 *  Geometry of shapes: areas. */
#ifndef SPH2D_SCENE_SHAPE_H
#define SPH2D_SCENE_SHAPE_H

#include <stdbool.h>

#include "sph2d/scene.h"

/** Smallest rectangle around a shape; an empty one at the origin for no shape. */
sph2d_box sph2d__shape_bounds(const sph2d_shape *shape);
/** Area [m^2]. */
double sph2d__shape_area(const sph2d_shape *shape);
/** Whether a point lies inside; points on the lower and left edges of a rectangle do, on the others not. */
bool sph2d__shape_contains(const sph2d_shape *shape, sph2d_vec2 point);

/** Whether two non-adjacent sides of a closed polygon meet. */
bool sph2d__polygon_crosses_itself(sph2d_points points);
/** Whether the corners of a polygon are in clockwise order. */
bool sph2d__polygon_is_clockwise(sph2d_points points);
/** Area of a polygon [m^2]: positive for anticlockwise corners. */
double sph2d__polygon_area(sph2d_points points);
/** Twice the signed area of a triangle: positive if c is on the left of a to b. */
double sph2d__points_turn(sph2d_vec2 a, sph2d_vec2 b, sph2d_vec2 c);

/** Smallest rectangle around points, of which there is one at least, or around a disc. */
sph2d_box sph2d__points_bounds(sph2d_points points);
sph2d_box sph2d__disc_bounds(sph2d_disc disc);

/** Whether a point lies inside, as sph2d__shape_contains() says. */
bool sph2d__disc_contains(sph2d_disc disc, sph2d_vec2 point);
bool sph2d__box_contains(sph2d_box box, sph2d_vec2 point);
bool sph2d__polygon_contains(sph2d_points points, sph2d_vec2 point);

#endif
