/* SPDX-License-Identifier: MIT */
/** @file shape.c
 *  Geometry of shapes: areas. */
#include "scene/shape.h"
#include "base/pi.h"

#include <math.h>

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

sph2d_box sph2d__disc_bounds(sph2d_disc disc)
{
    sph2d_vec2 c = disc.center;
    return (sph2d_box){{c.x - disc.radius, c.y - disc.radius}, {c.x + disc.radius, c.y + disc.radius}};
}

sph2d_box sph2d__shape_bounds(const sph2d_shape *shape)
{
    switch (shape->kind) {
    case SPH2D_SHAPE_BOX:
        return shape->box;
    case SPH2D_SHAPE_DISC:
        return sph2d__disc_bounds(shape->disc);
    case SPH2D_SHAPE_POLYGON:
        if (shape->polygon.count > 0)
            return sph2d__points_bounds(shape->polygon);
        break;
    case SPH2D_SHAPE_NONE:
        break;
    }
    return (sph2d_box){{0, 0}, {0, 0}};
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

double sph2d__shape_area(const sph2d_shape *shape)
{
    switch (shape->kind) {
    case SPH2D_SHAPE_BOX:
        return (shape->box.max.x - shape->box.min.x) * (shape->box.max.y - shape->box.min.y);
    case SPH2D_SHAPE_DISC:
        return SPH2D__PI * shape->disc.radius * shape->disc.radius;
    case SPH2D_SHAPE_POLYGON:
        return fabs(sph2d__polygon_area(shape->polygon));
    case SPH2D_SHAPE_NONE:
        break;
    }
    return 0;
}

bool sph2d__disc_contains(sph2d_disc disc, sph2d_vec2 p)
{
    double x = fabs(p.x - disc.center.x), y = fabs(p.y - disc.center.y);
    return x < disc.radius && y < disc.radius && hypot(x, y) < disc.radius; /* most positions are far, hypot is slow */
}

bool sph2d__box_contains(sph2d_box box, sph2d_vec2 p)
{
    return p.x >= box.min.x && p.x < box.max.x && p.y >= box.min.y && p.y < box.max.y;
}

/** Counts crossings of a ray to the right. */
bool sph2d__polygon_contains(sph2d_points points, sph2d_vec2 p)
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

bool sph2d__shape_contains(const sph2d_shape *shape, sph2d_vec2 point)
{
    switch (shape->kind) {
    case SPH2D_SHAPE_BOX:
        return sph2d__box_contains(shape->box, point);
    case SPH2D_SHAPE_DISC:
        return sph2d__disc_contains(shape->disc, point);
    case SPH2D_SHAPE_POLYGON:
        return sph2d__polygon_contains(shape->polygon, point);
    case SPH2D_SHAPE_NONE:
        break;
    }
    return false;
}

double sph2d__points_turn(sph2d_vec2 a, sph2d_vec2 b, sph2d_vec2 c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
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

bool sph2d__polygon_is_clockwise(sph2d_points points)
{
    return sph2d__polygon_area(points) < 0;
}
