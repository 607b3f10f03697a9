/* SPDX-License-Identifier: MIT */
/* Bodies where they are: how deep they overlap what they must not, and what is in them. From the public state and the
 * outlines of the scene alone. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "judge.h"

static const double pi = 3.14159265358979323846;
enum { PIECES = 64 }; // points along an outline

// ---- outlines ------------------------------------------------------------------------------------------------------

static size_t corner_count(const sph2d_shape *o)
{
    switch (o->kind) {
    case SPH2D_SHAPE_BOX:
        return 4;
    case SPH2D_SHAPE_POLYGON:
    case SPH2D_SHAPE_LINE:
    case SPH2D_SHAPE_POLYLINE:
        return o->points.count;
    case SPH2D_SHAPE_CIRCLE:
    case SPH2D_SHAPE_ARC:
    case SPH2D_SHAPE_SVG:
    case SPH2D_SHAPE_NONE:
        break;
    }
    return 0;
}

static sph2d_vec2 corner(const sph2d_shape *o, size_t i)
{
    if (o->kind == SPH2D_SHAPE_BOX)
        return (sph2d_vec2){i == 1 || i == 2 ? o->box.max.x : o->box.min.x, i >= 2 ? o->box.max.y : o->box.min.y};
    return o->points.items[i];
}

static bool is_open(const sph2d_shape *o)
{
    return o->kind == SPH2D_SHAPE_LINE || o->kind == SPH2D_SHAPE_POLYLINE || o->kind == SPH2D_SHAPE_ARC;
}

/** How deep a point is in a closed outline; negative outside and for lines. */
static double depth_in(const sph2d_shape *o, sph2d_vec2 p)
{
    if (is_open(o))
        return -INFINITY;
    if (o->kind == SPH2D_SHAPE_CIRCLE)
        return o->circle.radius - hypot(p.x - o->circle.center.x, p.y - o->circle.center.y);
    const size_t count = corner_count(o);
    double nearest = INFINITY;
    bool inside = false;
    for (size_t i = 0; i < count; ++i) {
        const sph2d_vec2 a = corner(o, i), b = corner(o, (i + 1) % count);
        const double x = b.x - a.x, y = b.y - a.y, square = x * x + y * y;
        const double part = square > 0 ? fmax(0, fmin(1, ((p.x - a.x) * x + (p.y - a.y) * y) / square)) : 0;
        nearest = fmin(nearest, hypot(p.x - a.x - part * x, p.y - a.y - part * y));
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / y * x)
            inside = !inside;
    }
    return inside ? nearest : -nearest;
}

static sph2d_vec2 at_angle(sph2d_vec2 center, double radius, double angle)
{
    return (sph2d_vec2){center.x + radius * cos(angle), center.y + radius * sin(angle)};
}

/** A point along an outline; of those with corners, these are among them. */
static sph2d_vec2 along(const sph2d_shape *o, size_t index)
{
    const double turn = (double)index / PIECES;
    if (o->kind == SPH2D_SHAPE_CIRCLE)
        return at_angle(o->circle.center, o->circle.radius, 2 * pi * turn);
    if (o->kind == SPH2D_SHAPE_ARC)
        return at_angle(o->arc.center, o->arc.radius, o->arc.from + turn * (o->arc.to - o->arc.from));
    const size_t count = corner_count(o), edges = is_open(o) ? count - 1 : count, each = PIECES / edges + 1;
    const size_t edge = index / each % edges;
    const sph2d_vec2 a = corner(o, edge), b = corner(o, (edge + 1) % count);
    const double part = (double)(index % each) / (double)(is_open(o) ? each - 1 : each);
    return (sph2d_vec2){a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)};
}

static size_t along_count(const sph2d_shape *o)
{
    if (o->kind == SPH2D_SHAPE_CIRCLE)
        return PIECES;
    if (o->kind == SPH2D_SHAPE_ARC)
        return PIECES + 1;
    const size_t edges = is_open(o) ? corner_count(o) - 1 : corner_count(o);
    return edges > 0 ? edges * (PIECES / edges + 1) : 0;
}

// ---- mass ----------------------------------------------------------------------------------------------------------

typedef struct moments {
    double area, second;
    sph2d_vec2 center;
} moments;

/** Sums over triangles with the first corner. */
static moments moments_of(const sph2d_shape *o)
{
    if (o->kind == SPH2D_SHAPE_CIRCLE) {
        const double r2 = o->circle.radius * o->circle.radius;
        return (moments){pi * r2, pi * r2 * r2 / 2, o->circle.center};
    }
    const sph2d_vec2 first = corner(o, 0);
    double area = 0, x = 0, y = 0, second = 0;
    for (size_t i = 1; i + 1 < corner_count(o); ++i) {
        const sph2d_vec2 p = corner(o, i), q = corner(o, i + 1);
        const sph2d_vec2 a = {p.x - first.x, p.y - first.y}, b = {q.x - first.x, q.y - first.y};
        const double cross = a.x * b.y - a.y * b.x;
        area += cross / 2;
        x += cross * (a.x + b.x) / 6;
        y += cross * (a.y + b.y) / 6;
        second += cross * (a.x * a.x + a.y * a.y + a.x * b.x + a.y * b.y + b.x * b.x + b.y * b.y) / 12;
    }
    x /= area;
    y /= area;
    return (moments){fabs(area), fabs(second - area * (x * x + y * y)), {first.x + x, first.y + y}};
}

double body_mass(const sph2d_body *body)
{
    return body->mass > 0 ? body->mass : body->density * moments_of(&body->shape).area;
}

static sph2d_vec2 center_of(const sph2d_body *body)
{
    return isnan(body->center.x) ? moments_of(&body->shape).center : body->center;
}

double bodies_scale(const sph2d_scene *s, double (*fall)(const sph2d_scene *, double x, double y))
{
    double sum = 0;
    for (size_t k = 0; k < s->body_count; ++k) {
        const sph2d_body *b = &s->bodies[k];
        const moments m = moments_of(&b->shape);
        const double mass = body_mass(b), inertia = b->inertia > 0 ? b->inertia : mass * m.second / m.area;
        const sph2d_vec2 center = center_of(b);
        sum += mass * (0.5 * (b->velocity.x * b->velocity.x + b->velocity.y * b->velocity.y) +
                       fall(s, center.x, center.y)) +
               0.5 * inertia * b->rate * b->rate;
        for (size_t i = 0; i < b->spring_count; ++i) {
            const sph2d_spring *p = &b->springs[i];
            const sph2d_vec2 at = isnan(p->at.x) ? center : p->at;
            const double by = isnan(p->length) ? 0 : hypot(p->to.x - at.x, p->to.y - at.y) - p->length;
            sum += by < 0 && p->slack == SPH2D_SWITCH_ON ? 0 : 0.5 * p->stiffness * by * by;
        }
    }
    return sum;
}

// ---- where they are ------------------------------------------------------------------------------------------------

/** An outline that has moved: what was at `from` is at `to`. */
typedef struct placed {
    const sph2d_shape *outline;
    sph2d_vec2 from, to;
    double cosine, sine;
    double reach; // of the outline from there; +inf: not known
} placed;

static sph2d_vec2 now(const placed *p, sph2d_vec2 at)
{
    const double x = at.x - p->from.x, y = at.y - p->from.y;
    return (sph2d_vec2){p->to.x + p->cosine * x - p->sine * y, p->to.y + p->sine * x + p->cosine * y};
}

static sph2d_vec2 drawn(const placed *p, sph2d_vec2 at)
{
    const double x = at.x - p->to.x, y = at.y - p->to.y;
    return (sph2d_vec2){p->from.x + p->cosine * x + p->sine * y, p->from.y - p->sine * x + p->cosine * y};
}

static placed body_now(const sph2d_scene *s, const sph2d_sim *sim, size_t k)
{
    const sph2d_body_state state = sph2d_sim_body(sim, k);
    const sph2d_shape *o = &s->bodies[k].shape;
    placed p = {o, center_of(&s->bodies[k]), state.center, cos(state.angle), sin(state.angle), 0};
    for (size_t i = 0; i < along_count(o); ++i)
        p.reach = fmax(p.reach, hypot(along(o, i).x - p.from.x, along(o, i).y - p.from.y));
    return p;
}

static double period(const sph2d_scene *s, bool y)
{
    const sph2d_box *d = &s->domain;
    if ((y ? s->boundary.bottom : s->boundary.left) != SPH2D_SIDE_PERIODIC)
        return 0;
    return y ? d->max.y - d->min.y : d->max.x - d->min.x;
}

static double nearest_image(double d, double length)
{
    return length > 0 ? d - length * round(d / length) : d;
}

/** How deep the points of one outline are in the other, the most. */
static double deepest(const placed *a, const placed *b)
{
    double most = -INFINITY;
    for (size_t i = 0; i < along_count(a->outline); ++i)
        most = fmax(most, depth_in(b->outline, drawn(b, now(a, along(a->outline, i)))));
    return most;
}

/** Of a body with another one, or an obstacle, by the nearest image of it. */
static double overlap(const sph2d_scene *s, placed a, const placed *b)
{
    a.to.x = b->to.x + nearest_image(a.to.x - b->to.x, period(s, false));
    a.to.y = b->to.y + nearest_image(a.to.y - b->to.y, period(s, true));
    if (hypot(a.to.x - b->to.x, a.to.y - b->to.y) > a.reach + b->reach)
        return -INFINITY;
    return fmax(deepest(&a, b), deepest(b, &a));
}

static double beyond_sides(const sph2d_scene *s, const placed *body)
{
    const sph2d_boundary *side = &s->boundary;
    const sph2d_box *d = &s->domain;
    double most = -INFINITY;
    for (size_t i = 0; i < along_count(body->outline); ++i) {
        const sph2d_vec2 p = now(body, along(body->outline, i));
        // Beside an open side walls go on for one domain more: where bodies are that have left, none is judged.
        if ((side->left == SPH2D_SIDE_OPEN && p.x < d->min.x) || (side->right == SPH2D_SIDE_OPEN && p.x > d->max.x) ||
            (side->bottom == SPH2D_SIDE_OPEN && p.y < d->min.y) || (side->top == SPH2D_SIDE_OPEN && p.y > d->max.y))
            continue;
        const double depths[4] = {side->left == SPH2D_SIDE_WALL ? d->min.x - p.x : -INFINITY,
                                  side->right == SPH2D_SIDE_WALL ? p.x - d->max.x : -INFINITY,
                                  side->bottom == SPH2D_SIDE_WALL ? d->min.y - p.y : -INFINITY,
                                  side->top == SPH2D_SIDE_WALL ? p.y - d->max.y : -INFINITY};
        for (int n = 0; n < 4; ++n)
            most = fmax(most, depths[n]);
    }
    return most;
}

static void keep(double *most, double depth, char text[200], size_t body, const char *what, size_t index)
{
    if (!(depth > *most))
        return;
    *most = depth;
    snprintf(text, 200, "bodies[%zu] and %s", body, what);
    if (index != SIZE_MAX)
        snprintf(text, 200, "bodies[%zu] and %s[%zu]", body, what, index);
}

static double overlap_with_obstacle(const sph2d_scene *s, placed body, size_t index)
{
    // All points of an obstacle at rest are where they are drawn.
    const placed other = {&s->obstacles[index].shape, {0, 0}, {0, 0}, 1, 0, INFINITY};
    body.to.x -= period(s, false) * floor((body.to.x - s->domain.min.x) / fmax(period(s, false), 1e-300));
    body.to.y -= period(s, true) * floor((body.to.y - s->domain.min.y) / fmax(period(s, true), 1e-300));
    return fmax(deepest(&body, &other), deepest(&other, &body));
}

double bodies_overlap(const sph2d_scene *s, const sph2d_sim *sim, char text[200])
{
    double most = 0;
    placed *bodies = calloc(s->body_count + 1, sizeof *bodies);
    if (!bodies) {
        snprintf(text, 200, "out of memory: any bodies");
        return INFINITY;
    }
    for (size_t k = 0; k < s->body_count; ++k) {
        bodies[k] = body_now(s, sim, k);
        keep(&most, beyond_sides(s, &bodies[k]), text, k, "a side", SIZE_MAX);
        for (size_t i = 0; i < k; ++i)
            keep(&most, overlap(s, bodies[k], &bodies[i]), text, k, "bodies", i);
        for (size_t i = 0; i < s->obstacle_count; ++i)
            keep(&most, overlap_with_obstacle(s, bodies[k], i), text, k, "obstacles", i);
    }
    free(bodies);
    return most;
}

size_t particles_in_bodies(const sph2d_scene *s, const sph2d_sim *sim, double depth)
{
    const sph2d_view f = sph2d_sim_fluid(sim);
    size_t count = 0;
    for (size_t k = 0; k < s->body_count; ++k) {
        const placed body = body_now(s, sim, k);
        for (size_t i = 0; i < f.count; ++i) {
            const sph2d_vec2 p = {body.to.x + nearest_image(f.x[i] - body.to.x, period(s, false)),
                                  body.to.y + nearest_image(f.y[i] - body.to.y, period(s, true))};
            count += depth_in(body.outline, drawn(&body, p)) > depth;
        }
    }
    return count;
}

bool bodies_are_finite(const sph2d_scene *s, const sph2d_sim *sim)
{
    for (size_t k = 0; k < s->body_count; ++k) {
        const sph2d_body_state b = sph2d_sim_body(sim, k);
        if (!isfinite(b.center.x + b.center.y + b.angle + b.velocity.x + b.velocity.y + b.rate + b.force.x + b.force.y +
                      b.torque))
            return false;
    }
    return true;
}
