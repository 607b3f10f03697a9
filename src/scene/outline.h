/* SPDX-License-Identifier: MIT */
/** @file outline.h
 *  Geometry of outlines: lines, of which the closed ones bound an area. */
#ifndef SPH2D_SCENE_OUTLINE_H
#define SPH2D_SCENE_OUTLINE_H

#include <stdbool.h>

#include "sph2d/scene.h"

/** A line segment. */
typedef struct sph2d__segment {
    sph2d_vec2 a, b;
} sph2d__segment;

/** Number of segments of an outline; those of a circle or arc are no longer than `spacing`. */
size_t sph2d__outline_pieces(const sph2d_outline *outline, double spacing);
/** Segment `index` of an outline. */
sph2d__segment sph2d__outline_piece(const sph2d_outline *outline, double spacing, size_t index);
/** Whether an outline is a line, polyline or arc. */
bool sph2d__outline_is_open(const sph2d_outline *outline);
/** Number of points of an open outline, one more than its segments; sets them unless NULL. */
size_t sph2d__outline_points(const sph2d_outline *outline, double spacing, sph2d_vec2 *points);
/** Smallest rectangle around an arc. */
sph2d_box sph2d__arc_bounds(const sph2d_arc *arc);
/** How far the segments of an arc are from it, at most [m]. */
double sph2d__arc_bulge(const sph2d_arc *arc, double spacing);
/** Distance of a point from an arc [m]; *side is positive on its left, where its centre is. */
double sph2d__arc_distance(const sph2d_arc *arc, sph2d_vec2 point, double *side);
/** Whether a point lies inside a closed outline (circle, box, polygon); never for lines and arcs. */
bool sph2d__outline_encloses(const sph2d_outline *outline, sph2d_vec2 point);
/** Centroid of a closed outline's area, or of a line [m]. */
sph2d_vec2 sph2d__outline_centroid(const sph2d_outline *outline);
/** The largest distance of an outline from a point [m]. */
double sph2d__outline_distance(const sph2d_outline *outline, sph2d_vec2 point);
/** The distance of a point from an outline [m]; arcs as pieces no longer than `spacing`. */
double sph2d__outline_nearest(const sph2d_outline *outline, double spacing, sph2d_vec2 point);
/** Area within a closed outline [m^2]; 0 for lines. */
double sph2d__outline_area(const sph2d_outline *outline);
/** Smallest rectangle around an outline. */
sph2d_box sph2d__outline_bounds(const sph2d_outline *outline, double spacing);
/** Positive for a point on the left of a to b, negative on the right. */
double sph2d__segment_side(const sph2d__segment *segment, sph2d_vec2 point);
/** Distance of a point from a segment [m]. */
double sph2d__segment_distance(const sph2d__segment *segment, sph2d_vec2 point);

#endif
