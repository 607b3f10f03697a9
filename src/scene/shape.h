/* SPDX-License-Identifier: MIT */
/** @file shape.h
 *  Geometry of shapes: closed ones, which bound an area, and lines. */
#ifndef SPH2D_SCENE_SHAPE_H
#define SPH2D_SCENE_SHAPE_H

#include <stdbool.h>

#include "sph2d/scene.h"

/** A line segment. */
typedef struct sph2d__segment {
    sph2d_vec2 a, b;
} sph2d__segment;

/** The end of a path to a shape: ".polygon"; "" for none. */
const char *sph2d__shape_key(sph2d_shape_kind kind);
/** Whether a shape is a line, polyline or arc. */
bool sph2d__shape_is_open(const sph2d_shape *shape);
/** Smallest rectangle around a shape; an empty one at the origin for no shape. */
sph2d_box sph2d__shape_bounds(const sph2d_shape *shape);
/** Area within a closed shape [m^2]; 0 for lines. */
double sph2d__shape_area(const sph2d_shape *shape);
/** Whether a point lies inside a closed shape; points on the lower and left edges of a rectangle do, on the others not. */
bool sph2d__shape_contains(const sph2d_shape *shape, sph2d_vec2 point);
/** The largest distance of a shape's line from a point [m]. */
double sph2d__shape_distance(const sph2d_shape *shape, sph2d_vec2 point);
/** The distance of a point from a shape's line [m]; arcs as pieces no longer than `spacing`. */
double sph2d__shape_nearest(const sph2d_shape *shape, double spacing, sph2d_vec2 point);

/** Number of segments of a shape's line; those of a circle or arc are no longer than `spacing`. */
size_t sph2d__shape_pieces(const sph2d_shape *shape, double spacing);
/** Segment `index` of it. */
sph2d__segment sph2d__shape_piece(const sph2d_shape *shape, double spacing, size_t index);

/** Smallest rectangle around an arc. */
sph2d_box sph2d__arc_bounds(const sph2d_arc *arc);
/** How far the segments of an arc are from it, at most [m]. */
double sph2d__arc_bulge(const sph2d_arc *arc, double spacing);
/** Distance of a point from an arc [m]; *side is positive on its left, where its centre is. */
double sph2d__arc_distance(const sph2d_arc *arc, sph2d_vec2 point, double *side);

/** Whether two non-adjacent sides of a closed polygon meet. */
bool sph2d__polygon_crosses_itself(sph2d_points points);
/** Whether the corners of a polygon are in clockwise order. */
bool sph2d__polygon_is_clockwise(sph2d_points points);
/** Area of a polygon [m^2]: positive for anticlockwise corners. */
double sph2d__polygon_area(sph2d_points points);
/** Twice the signed area of a triangle: positive if c is on the left of a to b. */
double sph2d__points_turn(sph2d_vec2 a, sph2d_vec2 b, sph2d_vec2 c);
/** Smallest rectangle around points, of which there is one at least. */
sph2d_box sph2d__points_bounds(sph2d_points points);

/** Positive for a point on the left of a to b, negative on the right. */
double sph2d__segment_side(const sph2d__segment *segment, sph2d_vec2 point);
/** Distance of a point from a segment [m]. */
double sph2d__segment_distance(const sph2d__segment *segment, sph2d_vec2 point);

#endif
