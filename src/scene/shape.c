/* SPDX-License-Identifier: MIT */
/** @file shape.c
 *  Geometry of shapes: areas, and lines. */
#include "scene/shape.h"

#include <math.h>

#include "base/pi.h"

/* ---- points ------------------------------------------------------------------------------------------------------ */

double sph2d__points_turn(sph2d_vec2 a, sph2d_vec2 b, sph2d_vec2 c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

sph2d_box sph2d__points_bounds(sph2d_points points)
{
    sph2d_box box = {points.items[0], points.items[0]};
    for (size_t i = 1; i < points.count; ++i) {
        sph2d_vec2 p = points.items[i];
        box.min.x = fmin(box.min.x, p.x);
        box.min.y = fmin(box.min.y, p.y);
        box.max.x = fmax(box.max.x, p.x);
        box.max.y = fmax(box.max.y, p.y);
    }
    return box;
}

/** Shoelace formula. */
double sph2d__polygon_area(sph2d_points points)
{
    double twice = 0;
    for (size_t i = 0; i < points.count; ++i) {
        sph2d_vec2 a = points.items[i];
        sph2d_vec2 b = points.items[(i + 1) % points.count];
        twice += a.x * b.y - b.x * a.y;
    }
    return twice / 2;
}

bool sph2d__polygon_is_clockwise(sph2d_points points)
{
    return sph2d__polygon_area(points) < 0;
}

static bool sides_cross(sph2d_vec2 a, sph2d_vec2 b, sph2d_vec2 c, sph2d_vec2 d)
{
    return (sph2d__points_turn(a, b, c) > 0) != (sph2d__points_turn(a, b, d) > 0) &&
           (sph2d__points_turn(c, d, a) > 0) != (sph2d__points_turn(c, d, b) > 0);
}

bool sph2d__polygon_crosses_itself(sph2d_points points)
{
    const sph2d_vec2 *p = points.items;
    size_t n = points.count;
    for (size_t i = 0; i < n; ++i)
        for (size_t k = i + 2; k < n; ++k) {
            bool neighbours = i == 0 && k + 1 == n;
            if (!neighbours && sides_cross(p[i], p[i + 1], p[k], p[(k + 1) % n]))
                return true;
        }
    return false;
}

/** Counts crossings of a ray to the right. */
static bool polygon_contains(sph2d_points points, sph2d_vec2 p)
{
    bool inside = false;
    for (size_t i = 0; i < points.count; ++i) {
        sph2d_vec2 a = points.items[i];
        sph2d_vec2 b = points.items[(i + 1) % points.count];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y))
            inside = !inside;
    }
    return inside;
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

/* ---- circles and arcs -------------------------------------------------------------------------------------------- */

static sph2d_vec2 point_at(sph2d_vec2 center, double radius, double angle)
{
    return (sph2d_vec2){center.x + radius * cos(angle), center.y + radius * sin(angle)};
}

static sph2d_box circle_bounds(sph2d_circle circle)
{
    sph2d_vec2 c = circle.center;
    return (sph2d_box){{c.x - circle.radius, c.y - circle.radius}, {c.x + circle.radius, c.y + circle.radius}};
}

static bool circle_contains(sph2d_circle circle, sph2d_vec2 p)
{
    double x = fabs(p.x - circle.center.x), y = fabs(p.y - circle.center.y);
    return x < circle.radius && y < circle.radius &&
           hypot(x, y) < circle.radius; /* most positions are far, hypot is slow */
}

/** As many pieces as a circle has, in proportion. */
static size_t arc_pieces(const sph2d_arc *arc, double spacing)
{
    double turn = arc->to - arc->from;
    double pieces = fmax(ceil(turn * arc->radius / spacing), ceil(8 * turn / (2 * SPH2D__PI)));
    return pieces > 4e9 ? (size_t)4e9 : pieces > 1 ? (size_t)pieces : 1;
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
    sph2d_box circle = circle_bounds((sph2d_circle){arc->center, arc->radius});
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

/* ---- shapes ------------------------------------------------------------------------------------------------------ */

const char *sph2d__shape_key(sph2d_shape_kind kind)
{
    switch (kind) {
    case SPH2D_SHAPE_BOX:
        return ".box";
    case SPH2D_SHAPE_CIRCLE:
        return ".circle";
    case SPH2D_SHAPE_POLYGON:
        return ".polygon";
    case SPH2D_SHAPE_LINE:
        return ".line";
    case SPH2D_SHAPE_POLYLINE:
        return ".polyline";
    case SPH2D_SHAPE_ARC:
        return ".arc";
    case SPH2D_SHAPE_SVG:
        return ".svg";
    case SPH2D_SHAPE_NONE:
        break;
    }
    return "";
}

bool sph2d__shape_is_open(const sph2d_shape *shape)
{
    return shape->kind == SPH2D_SHAPE_LINE || shape->kind == SPH2D_SHAPE_POLYLINE || shape->kind == SPH2D_SHAPE_ARC;
}

/** Whether a shape is its points: joined by straight lines. */
static bool has_points(const sph2d_shape *shape)
{
    return (shape->kind == SPH2D_SHAPE_POLYGON || shape->kind == SPH2D_SHAPE_LINE ||
            shape->kind == SPH2D_SHAPE_POLYLINE) &&
           shape->points.count > 0;
}

sph2d_box sph2d__shape_bounds(const sph2d_shape *shape)
{
    if (shape->kind == SPH2D_SHAPE_BOX)
        return shape->box;
    if (shape->kind == SPH2D_SHAPE_CIRCLE)
        return circle_bounds(shape->circle);
    if (shape->kind == SPH2D_SHAPE_ARC)
        return sph2d__arc_bounds(&shape->arc);
    return has_points(shape) ? sph2d__points_bounds(shape->points) : (sph2d_box){{0, 0}, {0, 0}};
}

double sph2d__shape_area(const sph2d_shape *shape)
{
    const sph2d_box *b = &shape->box;
    if (shape->kind == SPH2D_SHAPE_BOX)
        return (b->max.x - b->min.x) * (b->max.y - b->min.y);
    if (shape->kind == SPH2D_SHAPE_CIRCLE)
        return SPH2D__PI * shape->circle.radius * shape->circle.radius;
    return shape->kind == SPH2D_SHAPE_POLYGON ? fabs(sph2d__polygon_area(shape->points)) : 0;
}

static bool box_contains(sph2d_box box, sph2d_vec2 p)
{
    return p.x >= box.min.x && p.x < box.max.x && p.y >= box.min.y && p.y < box.max.y;
}

bool sph2d__shape_contains(const sph2d_shape *shape, sph2d_vec2 point)
{
    if (shape->kind == SPH2D_SHAPE_BOX)
        return box_contains(shape->box, point);
    if (shape->kind == SPH2D_SHAPE_CIRCLE)
        return circle_contains(shape->circle, point);
    return shape->kind == SPH2D_SHAPE_POLYGON && polygon_contains(shape->points, point);
}

size_t sph2d__shape_pieces(const sph2d_shape *shape, double spacing)
{
    if (shape->kind == SPH2D_SHAPE_BOX)
        return 4;
    if (shape->kind == SPH2D_SHAPE_CIRCLE) {
        double pieces = ceil(2 * SPH2D__PI * shape->circle.radius / spacing);
        return !(pieces > 8) ? 8 : pieces > 4e9 ? (size_t)4e9 : (size_t)pieces;
    }
    if (shape->kind == SPH2D_SHAPE_ARC)
        return arc_pieces(&shape->arc, spacing);
    return has_points(shape) ? shape->points.count - (size_t)sph2d__shape_is_open(shape) : 0;
}

/** A corner of the regular polygon that has the area of a circle: one within it would have 0.6 % less, and so much less
 *  buoyancy, at 10 spacings across. */
static sph2d_vec2 circle_point(sph2d_circle circle, size_t index, size_t pieces)
{
    double part = 2 * SPH2D__PI / (double)pieces;
    return point_at(circle.center, circle.radius * sqrt(part / sin(part)), part * (double)(index % pieces));
}

static sph2d_vec2 arc_point(const sph2d_arc *arc, size_t index, size_t pieces)
{
    double part = (double)index / (double)pieces;
    return point_at(arc->center, arc->radius, (1 - part) * arc->from + part * arc->to);
}

sph2d__segment sph2d__shape_piece(const sph2d_shape *shape, double spacing, size_t index)
{
    const sph2d_box *b = &shape->box;
    const sph2d_vec2 corners[5] = {b->min, {b->max.x, b->min.y}, b->max, {b->min.x, b->max.y}, b->min};
    const size_t pieces = sph2d__shape_pieces(shape, spacing);
    if (shape->kind == SPH2D_SHAPE_BOX)
        return (sph2d__segment){corners[index % 4], corners[index % 4 + 1]};
    if (shape->kind == SPH2D_SHAPE_CIRCLE)
        return (sph2d__segment){circle_point(shape->circle, index, pieces),
                                circle_point(shape->circle, index + 1, pieces)};
    if (shape->kind == SPH2D_SHAPE_ARC)
        return (sph2d__segment){arc_point(&shape->arc, index, pieces), arc_point(&shape->arc, index + 1, pieces)};
    if (!has_points(shape))
        return (sph2d__segment){{0, 0}, {0, 0}};
    return (sph2d__segment){shape->points.items[index], shape->points.items[(index + 1) % shape->points.count]};
}

size_t sph2d_shape_corners(const sph2d_shape *shape, double spacing, sph2d_vec2 *corners)
{
    const size_t pieces = shape && spacing > 0 ? sph2d__shape_pieces(shape, spacing) : 0;
    const bool open = pieces > 0 && sph2d__shape_is_open(shape);
    for (size_t k = 0; corners && k < pieces; ++k) {
        const sph2d__segment s = sph2d__shape_piece(shape, spacing, k);
        corners[k] = s.a;
        if (open)
            corners[k + 1] = s.b;
    }
    return pieces + (size_t)open;
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

sph2d_vec2 sph2d_shape_centroid(const sph2d_shape *shape)
{
    if (!shape)
        return (sph2d_vec2){NAN, NAN};
    if (shape->kind == SPH2D_SHAPE_CIRCLE)
        return shape->circle.center;
    if (shape->kind == SPH2D_SHAPE_BOX)
        return (sph2d_vec2){(shape->box.min.x + shape->box.max.x) / 2, (shape->box.min.y + shape->box.max.y) / 2};
    if (shape->kind == SPH2D_SHAPE_ARC) {
        const sph2d_arc *arc = &shape->arc;
        double half = (arc->to - arc->from) / 2;
        return point_at(arc->center, half > 0 ? arc->radius * sin(half) / half : 0, arc->from + half);
    }
    if (!has_points(shape))
        return (sph2d_vec2){0, 0};
    return shape->kind == SPH2D_SHAPE_POLYGON ? polygon_centroid(shape->points) : line_centroid(shape->points);
}

double sph2d__shape_distance(const sph2d_shape *shape, sph2d_vec2 point)
{
    if (shape->kind == SPH2D_SHAPE_CIRCLE)
        return hypot(shape->circle.center.x - point.x, shape->circle.center.y - point.y) + shape->circle.radius;
    if (shape->kind == SPH2D_SHAPE_ARC) {
        const sph2d_arc *arc = &shape->arc;
        sph2d_vec2 from = point_at(arc->center, arc->radius, arc->from);
        sph2d_vec2 to = point_at(arc->center, arc->radius, arc->to);
        double x = arc->center.x - point.x, y = arc->center.y - point.y;
        return arc_has(arc, atan2(y, x))
                   ? hypot(x, y) + arc->radius
                   : fmax(hypot(from.x - point.x, from.y - point.y), hypot(to.x - point.x, to.y - point.y));
    }
    double farthest = 0;
    size_t pieces = sph2d__shape_pieces(shape, 1);
    for (size_t k = 0; k < pieces; ++k) {
        sph2d__segment s = sph2d__shape_piece(shape, 1, k);
        farthest =
            fmax(farthest, fmax(hypot(s.a.x - point.x, s.a.y - point.y), hypot(s.b.x - point.x, s.b.y - point.y)));
    }
    return farthest;
}

double sph2d__shape_nearest(const sph2d_shape *shape, double spacing, sph2d_vec2 point)
{
    if (shape->kind == SPH2D_SHAPE_CIRCLE)
        return fabs(hypot(point.x - shape->circle.center.x, point.y - shape->circle.center.y) - shape->circle.radius);
    double least = INFINITY;
    size_t pieces = sph2d__shape_pieces(shape, spacing);
    for (size_t k = 0; k < pieces; ++k) {
        sph2d__segment s = sph2d__shape_piece(shape, spacing, k);
        least = fmin(least, sph2d__segment_distance(&s, point));
    }
    return least;
}
