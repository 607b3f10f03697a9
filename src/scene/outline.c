/* SPDX-License-Identifier: MIT */
/** @file outline.c
 *  Geometry of outlines: lines, of which the closed ones bound an area. */
#include "scene/outline.h"
#include "base/pi.h"
#include "scene/shape.h"

#include <math.h>

static sph2d_vec2 point_at(sph2d_vec2 center, double radius, double angle)
{
    return (sph2d_vec2){center.x + radius * cos(angle), center.y + radius * sin(angle)};
}

/** As many pieces as a circle has, in proportion. */
static size_t arc_pieces(const sph2d_arc *arc, double spacing)
{
    double turn = arc->to - arc->from;
    double pieces = fmax(ceil(turn * arc->radius / spacing), ceil(8 * turn / (2 * SPH2D__PI)));
    return pieces > 4e9 ? (size_t)4e9 : pieces > 1 ? (size_t)pieces : 1;
}

size_t sph2d__outline_pieces(const sph2d_outline *outline, double spacing)
{
    switch (outline->kind) {
    case SPH2D_OUTLINE_LINE:
        return outline->line.count > 0 ? outline->line.count - 1 : 0;
    case SPH2D_OUTLINE_POLYLINE:
        return outline->polyline.count > 0 ? outline->polyline.count - 1 : 0;
    case SPH2D_OUTLINE_CIRCLE: {
        double pieces = ceil(2 * SPH2D__PI * outline->circle.radius / spacing);
        return pieces < 8 ? 8 : pieces > 4e9 ? (size_t)4e9 : (size_t)pieces;
    }
    case SPH2D_OUTLINE_ARC:
        return arc_pieces(&outline->arc, spacing);
    case SPH2D_OUTLINE_BOX:
        return 4;
    case SPH2D_OUTLINE_POLYGON:
        return outline->polygon.count;
    case SPH2D_OUTLINE_NONE:
        break;
    }
    return 0;
}

/** A corner of the regular polygon that has the area of a circle: one within it would have 0.6 % less, and so much less
 *  buoyancy, at 10 spacings across. */
static sph2d_vec2 circle_point(sph2d_disc circle, size_t index, size_t pieces)
{
    double part = 2 * SPH2D__PI / (double)pieces;
    return point_at(circle.center, circle.radius * sqrt(part / sin(part)), part * (double)(index % pieces));
}

static sph2d_vec2 arc_point(const sph2d_arc *arc, size_t index, size_t pieces)
{
    double part = (double)index / (double)pieces;
    return point_at(arc->center, arc->radius, (1 - part) * arc->from + part * arc->to);
}

sph2d__segment sph2d__outline_piece(const sph2d_outline *outline, double spacing, size_t index)
{
    switch (outline->kind) {
    case SPH2D_OUTLINE_LINE:
        return (sph2d__segment){outline->line.items[index], outline->line.items[index + 1]};
    case SPH2D_OUTLINE_POLYLINE:
        return (sph2d__segment){outline->polyline.items[index], outline->polyline.items[index + 1]};
    case SPH2D_OUTLINE_CIRCLE: {
        size_t pieces = sph2d__outline_pieces(outline, spacing);
        return (sph2d__segment){circle_point(outline->circle, index, pieces),
                                circle_point(outline->circle, index + 1, pieces)};
    }
    case SPH2D_OUTLINE_ARC: {
        size_t pieces = arc_pieces(&outline->arc, spacing);
        return (sph2d__segment){arc_point(&outline->arc, index, pieces), arc_point(&outline->arc, index + 1, pieces)};
    }
    case SPH2D_OUTLINE_BOX: {
        sph2d_box b = outline->box;
        sph2d_vec2 corners[5] = {b.min, {b.max.x, b.min.y}, b.max, {b.min.x, b.max.y}, b.min};
        return (sph2d__segment){corners[index % 4], corners[index % 4 + 1]};
    }
    case SPH2D_OUTLINE_POLYGON:
        return (sph2d__segment){outline->polygon.items[index],
                                outline->polygon.items[(index + 1) % outline->polygon.count]};
    case SPH2D_OUTLINE_NONE:
        break;
    }
    return (sph2d__segment){{0, 0}, {0, 0}};
}

bool sph2d__outline_encloses(const sph2d_outline *outline, sph2d_vec2 point)
{
    switch (outline->kind) {
    case SPH2D_OUTLINE_CIRCLE:
        return sph2d__disc_contains(outline->circle, point);
    case SPH2D_OUTLINE_BOX:
        return sph2d__box_contains(outline->box, point);
    case SPH2D_OUTLINE_POLYGON:
        return sph2d__polygon_contains(outline->polygon, point);
    case SPH2D_OUTLINE_LINE:
    case SPH2D_OUTLINE_POLYLINE:
    case SPH2D_OUTLINE_ARC:
    case SPH2D_OUTLINE_NONE:
        break;
    }
    return false;
}

bool sph2d__outline_is_open(const sph2d_outline *outline)
{
    return outline->kind == SPH2D_OUTLINE_LINE || outline->kind == SPH2D_OUTLINE_POLYLINE ||
           outline->kind == SPH2D_OUTLINE_ARC;
}

size_t sph2d__outline_points(const sph2d_outline *outline, double spacing, sph2d_vec2 *points)
{
    size_t pieces = sph2d__outline_pieces(outline, spacing);
    for (size_t k = 0; points && k < pieces; ++k) {
        sph2d__segment s = sph2d__outline_piece(outline, spacing, k);
        points[k] = s.a;
        points[k + 1] = s.b;
    }
    return pieces + 1;
}

/** Whether an arc has a point in the direction of an angle. */
static bool arc_has(const sph2d_arc *arc, double angle)
{
    double past = fmod(angle - arc->from, 2 * SPH2D__PI);
    return (past < 0 ? past + 2 * SPH2D__PI : past) <= arc->to - arc->from;
}

sph2d_box sph2d__arc_bounds(const sph2d_arc *arc)
{
    const sph2d_vec2 ends[2] = {point_at(arc->center, arc->radius, arc->from),
                                point_at(arc->center, arc->radius, arc->to)};
    sph2d_box b = sph2d__points_bounds((sph2d_points){ends, 2});
    sph2d_box circle = sph2d__disc_bounds((sph2d_disc){arc->center, arc->radius});
    b.max.x = arc_has(arc, 0) ? circle.max.x : b.max.x;
    b.max.y = arc_has(arc, SPH2D__PI / 2) ? circle.max.y : b.max.y;
    b.min.x = arc_has(arc, SPH2D__PI) ? circle.min.x : b.min.x;
    b.min.y = arc_has(arc, -SPH2D__PI / 2) ? circle.min.y : b.min.y;
    return b;
}

double sph2d__arc_bulge(const sph2d_arc *arc, double spacing)
{
    return arc->radius * (1 - cos((arc->to - arc->from) / (2 * (double)arc_pieces(arc, spacing))));
}

double sph2d__arc_distance(const sph2d_arc *arc, sph2d_vec2 p, double *side)
{
    double x = p.x - arc->center.x, y = p.y - arc->center.y, r = hypot(x, y);
    if (arc_has(arc, atan2(y, x))) {
        *side = arc->radius - r;
        return fabs(*side);
    }
    const double angles[2] = {arc->from, arc->to};
    double nearest = INFINITY;
    *side = 0;
    for (int k = 0; k < 2; ++k) { /* beyond an end, the side of the tangent there */
        sph2d_vec2 end = point_at(arc->center, arc->radius, angles[k]);
        double distance = hypot(p.x - end.x, p.y - end.y);
        if (distance < nearest)
            *side = arc->radius - (x * cos(angles[k]) + y * sin(angles[k]));
        nearest = fmin(nearest, distance);
    }
    return nearest;
}

double sph2d__segment_side(const sph2d__segment *segment, sph2d_vec2 point)
{
    return sph2d__points_turn(segment->a, segment->b, point);
}

double sph2d__segment_distance(const sph2d__segment *segment, sph2d_vec2 point)
{
    double ex = segment->b.x - segment->a.x, ey = segment->b.y - segment->a.y;
    double px = point.x - segment->a.x, py = point.y - segment->a.y;
    double length2 = ex * ex + ey * ey;
    double t = length2 > 0 ? fmin(fmax((px * ex + py * ey) / length2, 0), 1) : 0;
    double x = px - t * ex, y = py - t * ey;
    return sqrt(x * x + y * y); /* hypot takes twice as long, and numbers of scenes neither overflow nor vanish */
}

/** Centroid of a polygon's area, from its first corner so that a far origin costs no digits. */
static sph2d_vec2 polygon_centroid(sph2d_points points)
{
    sph2d_vec2 o = points.items[0], sum = {0, 0};
    double twice = 0;
    for (size_t i = 1; i + 1 < points.count; ++i) {
        sph2d_vec2 a = points.items[i], b = points.items[i + 1];
        double part = sph2d__points_turn(o, a, b);
        twice += part;
        sum.x += part * (a.x - o.x + b.x - o.x);
        sum.y += part * (a.y - o.y + b.y - o.y);
    }
    return twice != 0 ? (sph2d_vec2){o.x + sum.x / (3 * twice), o.y + sum.y / (3 * twice)} : o;
}

/** Centroid of a line of constant weight. */
static sph2d_vec2 line_centroid(sph2d_points points)
{
    sph2d_vec2 sum = {0, 0};
    double length = 0;
    for (size_t i = 1; i < points.count; ++i) {
        sph2d_vec2 a = points.items[i - 1], b = points.items[i];
        double part = hypot(b.x - a.x, b.y - a.y);
        length += part;
        sum.x += part * (a.x + b.x) / 2;
        sum.y += part * (a.y + b.y) / 2;
    }
    return length > 0 ? (sph2d_vec2){sum.x / length, sum.y / length} : points.items[0];
}

sph2d_vec2 sph2d__outline_centroid(const sph2d_outline *outline)
{
    const sph2d_box *b = &outline->box;
    switch (outline->kind) {
    case SPH2D_OUTLINE_CIRCLE:
        return outline->circle.center;
    case SPH2D_OUTLINE_BOX:
        return (sph2d_vec2){(b->min.x + b->max.x) / 2, (b->min.y + b->max.y) / 2};
    case SPH2D_OUTLINE_POLYGON:
        return outline->polygon.count > 0 ? polygon_centroid(outline->polygon) : (sph2d_vec2){0, 0};
    case SPH2D_OUTLINE_LINE:
        return outline->line.count > 0 ? line_centroid(outline->line) : (sph2d_vec2){0, 0};
    case SPH2D_OUTLINE_POLYLINE:
        return outline->polyline.count > 0 ? line_centroid(outline->polyline) : (sph2d_vec2){0, 0};
    case SPH2D_OUTLINE_ARC: {
        const sph2d_arc *arc = &outline->arc;
        double half = (arc->to - arc->from) / 2;
        return point_at(arc->center, half > 0 ? arc->radius * sin(half) / half : 0, arc->from + half);
    }
    case SPH2D_OUTLINE_NONE:
        break;
    }
    return (sph2d_vec2){0, 0};
}

double sph2d__outline_distance(const sph2d_outline *outline, sph2d_vec2 point)
{
    if (outline->kind == SPH2D_OUTLINE_CIRCLE)
        return hypot(outline->circle.center.x - point.x, outline->circle.center.y - point.y) + outline->circle.radius;
    if (outline->kind == SPH2D_OUTLINE_ARC) {
        const sph2d_arc *arc = &outline->arc;
        sph2d_vec2 from = point_at(arc->center, arc->radius, arc->from);
        sph2d_vec2 to = point_at(arc->center, arc->radius, arc->to);
        double x = arc->center.x - point.x, y = arc->center.y - point.y;
        return arc_has(arc, atan2(y, x))
                   ? hypot(x, y) + arc->radius
                   : fmax(hypot(from.x - point.x, from.y - point.y), hypot(to.x - point.x, to.y - point.y));
    }
    double farthest = 0;
    size_t pieces = sph2d__outline_pieces(outline, 1);
    for (size_t k = 0; k < pieces; ++k) {
        sph2d__segment s = sph2d__outline_piece(outline, 1, k);
        farthest =
            fmax(farthest, fmax(hypot(s.a.x - point.x, s.a.y - point.y), hypot(s.b.x - point.x, s.b.y - point.y)));
    }
    return farthest;
}

double sph2d__outline_nearest(const sph2d_outline *outline, double spacing, sph2d_vec2 point)
{
    if (outline->kind == SPH2D_OUTLINE_CIRCLE)
        return fabs(hypot(point.x - outline->circle.center.x, point.y - outline->circle.center.y) -
                    outline->circle.radius);
    double least = INFINITY;
    size_t pieces = sph2d__outline_pieces(outline, spacing);
    for (size_t k = 0; k < pieces; ++k) {
        sph2d__segment s = sph2d__outline_piece(outline, spacing, k);
        least = fmin(least, sph2d__segment_distance(&s, point));
    }
    return least;
}

sph2d_box sph2d__outline_bounds(const sph2d_outline *outline, double spacing)
{
    sph2d_box b = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    size_t pieces = outline->kind == SPH2D_OUTLINE_CIRCLE ? 0 : sph2d__outline_pieces(outline, spacing);
    for (size_t k = 0; k < pieces; ++k) {
        sph2d__segment s = sph2d__outline_piece(outline, spacing, k);
        b.min = (sph2d_vec2){fmin(b.min.x, fmin(s.a.x, s.b.x)), fmin(b.min.y, fmin(s.a.y, s.b.y))};
        b.max = (sph2d_vec2){fmax(b.max.x, fmax(s.a.x, s.b.x)), fmax(b.max.y, fmax(s.a.y, s.b.y))};
    }
    if (outline->kind == SPH2D_OUTLINE_CIRCLE)
        b = sph2d__disc_bounds(outline->circle);
    return b;
}

double sph2d__outline_area(const sph2d_outline *outline)
{
    const sph2d_box *b = &outline->box;
    switch (outline->kind) {
    case SPH2D_OUTLINE_CIRCLE:
        return SPH2D__PI * outline->circle.radius * outline->circle.radius;
    case SPH2D_OUTLINE_BOX:
        return (b->max.x - b->min.x) * (b->max.y - b->min.y);
    case SPH2D_OUTLINE_POLYGON:
        return fabs(sph2d__polygon_area(outline->polygon));
    case SPH2D_OUTLINE_LINE:
    case SPH2D_OUTLINE_POLYLINE:
    case SPH2D_OUTLINE_ARC:
    case SPH2D_OUTLINE_NONE:
        break;
    }
    return 0;
}
