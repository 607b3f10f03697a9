/* SPDX-License-Identifier: MIT */
/** @file bodies.c */
#include "scene/bodies.h"

#include <math.h>

#include "base/pi.h"
#include "scene/shape.h"

/** Area and second moment about the centroid of a closed outline. */
typedef struct moments {
    double area, second; /**< [m^2], [m^4] */
} moments;

/** Of a polygon: sums over the triangles with a point, (a x b)/2 and (a x b)(a.a + a.b + b.b)/12. */
static moments polygon_moments(sph2d_points points, sph2d_vec2 o)
{
    moments sum = {0, 0};
    for (size_t i = 0; i < points.count; ++i) {
        sph2d_vec2 p = points.items[i], q = points.items[(i + 1) % points.count];
        sph2d_vec2 a = {p.x - o.x, p.y - o.y}, b = {q.x - o.x, q.y - o.y};
        double cross = a.x * b.y - a.y * b.x;
        sum.area += cross / 2;
        sum.second += cross * (a.x * a.x + a.y * a.y + a.x * b.x + a.y * b.y + b.x * b.x + b.y * b.y) / 12;
    }
    return (moments){fabs(sum.area), fabs(sum.second)};
}

static moments moments_of(const sph2d_shape *outline)
{
    double r2 = outline->circle.radius * outline->circle.radius;
    double a = outline->box.max.x - outline->box.min.x, b = outline->box.max.y - outline->box.min.y;
    switch (outline->kind) {
    case SPH2D_SHAPE_CIRCLE:
        return (moments){SPH2D__PI * r2, SPH2D__PI * r2 * r2 / 2};
    case SPH2D_SHAPE_BOX:
        return (moments){a * b, a * b * (a * a + b * b) / 12};
    case SPH2D_SHAPE_POLYGON:
        return polygon_moments(outline->points, sph2d_shape_centroid(outline));
    case SPH2D_SHAPE_LINE:
    case SPH2D_SHAPE_POLYLINE:
    case SPH2D_SHAPE_ARC:
    case SPH2D_SHAPE_SVG:
    case SPH2D_SHAPE_NONE:
        break;
    }
    return (moments){0, 0};
}

sph2d__mass_data sph2d__body_mass(const sph2d_body *body)
{
    moments m = moments_of(&body->shape);
    sph2d__mass_data data = {.area = m.area, .center = body->center};
    data.mass = body->mass > 0 ? body->mass : body->density * m.area;
    data.inertia = body->inertia > 0 ? body->inertia : data.mass * m.second / m.area;
    if (isnan(body->center.x) || isnan(body->center.y))
        data.center = sph2d_shape_centroid(&body->shape);
    return data;
}

sph2d_vec2 sph2d__spring_start(const sph2d_spring *spring, sph2d_vec2 center)
{
    return isnan(spring->at.x) || isnan(spring->at.y) ? center : spring->at;
}

double sph2d__spring_length(const sph2d_spring *spring, sph2d_vec2 start)
{
    return isnan(spring->length) ? hypot(spring->to.x - start.x, spring->to.y - start.y) : spring->length;
}

double sph2d__spring_energy(const sph2d_body *body, const sph2d_spring *spring)
{
    sph2d_vec2 at = sph2d__spring_start(spring, sph2d__body_mass(body).center);
    double stretch = hypot(spring->to.x - at.x, spring->to.y - at.y) - sph2d__spring_length(spring, at);
    bool loose = spring->slack == SPH2D_SWITCH_ON && stretch < 0;
    const sph2d_hold *hold = &body->hold;
    bool held = hold->x == SPH2D_SWITCH_ON && hold->y == SPH2D_SWITCH_ON && hold->angle == SPH2D_SWITCH_ON;
    return loose || held ? 0 : spring->stiffness * stretch * stretch / 2;
}

double sph2d__body_speed(const sph2d_body *body)
{
    return hypot(body->velocity.x, body->velocity.y) +
           fabs(body->rate) * sph2d__shape_distance(&body->shape, sph2d__body_mass(body).center);
}

/** One over the mass that the end of a spring feels, at least: that of the body, as a lever as long as the end is away
 *  from the centre of mass. */
static double yielding(const sph2d_body *body, const sph2d_spring *spring)
{
    sph2d__mass_data m = sph2d__body_mass(body);
    sph2d_vec2 at = sph2d__spring_start(spring, m.center), arm = {at.x - m.center.x, at.y - m.center.y};
    bool goes = body->hold.x != SPH2D_SWITCH_ON || body->hold.y != SPH2D_SWITCH_ON;
    bool turns = body->hold.angle != SPH2D_SWITCH_ON;
    return (goes ? 1 / m.mass : 0) + (turns ? (arm.x * arm.x + arm.y * arm.y) / m.inertia : 0);
}

double sph2d__spring_speed(const sph2d_body *body)
{
    double square = 0;
    for (size_t i = 0; i < body->spring_count; ++i)
        square += 2 * sph2d__spring_energy(body, &body->springs[i]) * yielding(body, &body->springs[i]);
    return sqrt(square);
}
