/* SPDX-License-Identifier: MIT */
/** @file place.c
 *  Bodies and obstacles where they are now. */
#include <math.h>

#include "contacts/contacts.h"

static sph2d_points points_of(const sph2d_outline *outline)
{
    switch (outline->kind) {
    case SPH2D_OUTLINE_LINE:
        return outline->line;
    case SPH2D_OUTLINE_POLYLINE:
        return outline->polyline;
    case SPH2D_OUTLINE_POLYGON:
        return outline->polygon;
    case SPH2D_OUTLINE_CIRCLE:
    case SPH2D_OUTLINE_BOX:
    case SPH2D_OUTLINE_ARC:
    case SPH2D_OUTLINE_NONE:
        break;
    }
    return (sph2d_points){0};
}

/* Arcs are chords of at most this angle, which leave them by 1/800 of the radius [rad]. */
#define CHORD 0.1

size_t sph2d__corner_count(const sph2d_outline *outline)
{
    if (outline->kind == SPH2D_OUTLINE_ARC)
        return 1 + (size_t)ceil((outline->arc.to - outline->arc.from) / CHORD);
    return outline->kind == SPH2D_OUTLINE_BOX ? 4 : points_of(outline).count;
}

/** A corner in the scene; of a box anticlockwise. */
static sph2d_vec2 drawn_corner(const sph2d_outline *outline, size_t index)
{
    const sph2d_box *box = &outline->box;
    const sph2d_arc *arc = &outline->arc;
    if (outline->kind == SPH2D_OUTLINE_ARC) {
        double part = (double)index / (double)(sph2d__corner_count(outline) - 1);
        double angle = (1 - part) * arc->from + part * arc->to;
        return (sph2d_vec2){arc->center.x + arc->radius * cos(angle), arc->center.y + arc->radius * sin(angle)};
    }
    if (outline->kind != SPH2D_OUTLINE_BOX)
        return points_of(outline).items[index];
    return (sph2d_vec2){index == 1 || index == 2 ? box->max.x : box->min.x, index >= 2 ? box->max.y : box->min.y};
}

static sph2d_vec2 now(const sph2d__placed *placed, sph2d_vec2 drawn)
{
    double x = drawn.x - placed->from.x, y = drawn.y - placed->from.y;
    return (sph2d_vec2){placed->to.x + placed->cosine * x - placed->sine * y,
                        placed->to.y + placed->sine * x + placed->cosine * y};
}

sph2d_vec2 sph2d__corner(const sph2d__placed *placed, size_t index)
{
    return now(placed, drawn_corner(placed->outline, index));
}

sph2d_vec2 sph2d__circle_center(const sph2d__placed *placed)
{
    return now(placed, placed->outline->circle.center);
}

sph2d_vec2 sph2d__wall_velocity(const sph2d__placed *placed, sph2d_vec2 at)
{
    return (sph2d_vec2){placed->velocity.x - placed->rate * (at.y - placed->to.y),
                        placed->velocity.y + placed->rate * (at.x - placed->to.x)};
}

static sph2d_vec2 polygon_centroid(sph2d_points points)
{
    sph2d_vec2 o = points.items[0], sum = {0, 0};
    double twice = 0;
    for (size_t i = 1; i + 1 < points.count; ++i) {
        sph2d_vec2 a = {points.items[i].x - o.x, points.items[i].y - o.y};
        sph2d_vec2 b = {points.items[i + 1].x - o.x, points.items[i + 1].y - o.y};
        double part = a.x * b.y - a.y * b.x;
        twice += part;
        sum.x += part * (a.x + b.x);
        sum.y += part * (a.y + b.y);
    }
    return twice != 0 ? (sph2d_vec2){o.x + sum.x / (3 * twice), o.y + sum.y / (3 * twice)} : o;
}

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

/** The centre in the scene: the one given, or the centroid. */
static sph2d_vec2 center_of(const sph2d_outline *outline, sph2d_vec2 given)
{
    if (!isnan(given.x))
        return given;
    if (outline->kind == SPH2D_OUTLINE_CIRCLE)
        return outline->circle.center;
    const sph2d_box *box = &outline->box;
    if (outline->kind == SPH2D_OUTLINE_BOX)
        return (sph2d_vec2){(box->min.x + box->max.x) / 2, (box->min.y + box->max.y) / 2};
    const sph2d_arc *arc = &outline->arc;
    if (outline->kind == SPH2D_OUTLINE_ARC) { /* of a line along it: r sin(a/2)/(a/2) from the centre */
        double middle = (arc->from + arc->to) / 2, half = (arc->to - arc->from) / 2, r = arc->radius * sin(half) / half;
        return (sph2d_vec2){arc->center.x + r * cos(middle), arc->center.y + r * sin(middle)};
    }
    sph2d_points points = points_of(outline);
    if (points.count == 0)
        return (sph2d_vec2){0, 0};
    return outline->kind == SPH2D_OUTLINE_POLYGON ? polygon_centroid(points) : line_centroid(points);
}

/** Sets the box of what is placed, not yet grown; returns a bound of the distance of its points from its centre. */
static double measure(sph2d__placed *placed)
{
    sph2d_box box = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    if (placed->outline->kind == SPH2D_OUTLINE_CIRCLE) {
        sph2d_vec2 center = sph2d__circle_center(placed);
        double r = placed->outline->circle.radius;
        box = (sph2d_box){{center.x - r, center.y - r}, {center.x + r, center.y + r}};
    }
    size_t count = sph2d__corner_count(placed->outline);
    for (size_t i = 0; i < count; ++i) {
        sph2d_vec2 p = sph2d__corner(placed, i);
        box.min = (sph2d_vec2){fmin(box.min.x, p.x), fmin(box.min.y, p.y)};
        box.max = (sph2d_vec2){fmax(box.max.x, p.x), fmax(box.max.y, p.y)};
    }
    placed->box = box;
    return hypot(fmax(placed->to.x - box.min.x, box.max.x - placed->to.x),
                 fmax(placed->to.y - box.min.y, box.max.y - placed->to.y));
}

static void turn(sph2d__placed *placed, double angle)
{
    placed->cosine = angle == 0 ? 1 : cos(angle);
    placed->sine = angle == 0 ? 0 : sin(angle);
}

static sph2d__placed placed_body(const sph2d__contacts *c, uint32_t i)
{
    const sph2d_body *body = &c->scene->bodies[i];
    sph2d__placed placed = {.outline = &body->outline, .to = c->bodies[i].center, .number = i};
    placed.from = center_of(placed.outline, body->center);
    turn(&placed, c->bodies[i].angle);
    return placed;
}

static sph2d__placed placed_obstacle(const sph2d__contacts *c, size_t i)
{
    const sph2d_obstacle *obstacle = &c->scene->obstacles[i];
    const sph2d_body_state *state = &c->obstacles[i];
    sph2d__placed placed = {.outline = &obstacle->outline, .to = state->center, .velocity = state->velocity};
    placed.from = center_of(placed.outline, obstacle->motion.center);
    placed.rate = state->rate;
    placed.number = c->body_count;
    placed.wall = (uint32_t)(SPH2D__SIDES + i);
    placed.hollow = obstacle->liquid == SPH2D_LIQUID_INSIDE;
    turn(&placed, state->angle);
    return placed;
}

sph2d_status sph2d__place_all(sph2d__contacts *c)
{
    size_t obstacle_count = c->scene->obstacle_count;
    c->placed_room = c->body_count + obstacle_count;
    c->placed = sph2d__alloc(&c->memory, c->placed_room, sizeof *c->placed);
    if (!c->placed)
        return SPH2D_NOMEM;
    double fastest = 0;
    for (uint32_t i = 0; i < c->body_count; ++i) {
        sph2d__placed *placed = &c->placed[c->placed_count++];
        *placed = placed_body(c, i);
        double reach = measure(placed);
        const sph2d_contact_body *body = &c->bodies[i];
        fastest = fmax(fastest, hypot(body->velocity.x, body->velocity.y) + fabs(body->rate) * reach);
    }
    for (size_t i = 0; i < obstacle_count; ++i) {
        sph2d__placed *placed = &c->placed[c->placed_count++];
        *placed = placed_obstacle(c, i);
        double reach = measure(placed);
        fastest = fmax(fastest, hypot(placed->velocity.x, placed->velocity.y) + fabs(placed->rate) * reach);
    }
    /* That of the fastest for all: it may hit others, which then are as fast. */
    c->margin = fastest * c->dt + c->clearance;
    for (size_t i = 0; i < c->placed_count; ++i) {
        sph2d_box *box = &c->placed[i].box;
        box->min = (sph2d_vec2){box->min.x - c->margin, box->min.y - c->margin};
        box->max = (sph2d_vec2){box->max.x + c->margin, box->max.y + c->margin};
    }
    return SPH2D_OK;
}
