/* SPDX-License-Identifier: MIT */
/** @file place.c
 *  Bodies and obstacles where they are now. */
#include <math.h>

#include "contacts/contacts.h"

/* Arcs are chords of at most this angle, which leave them by 1/800 of the radius [rad]. */
#define CHORD 0.1

static sph2d_vec2 now(const sph2d__placed *placed, sph2d_vec2 drawn)
{
    double x = drawn.x - placed->from.x, y = drawn.y - placed->from.y;
    return (sph2d_vec2){placed->to.x + placed->cosine * x - placed->sine * y,
                        placed->to.y + placed->sine * x + placed->cosine * y};
}

sph2d_vec2 sph2d__wall_velocity(const sph2d__placed *placed, sph2d_vec2 at)
{
    return (sph2d_vec2){placed->velocity.x - placed->rate * (at.y - placed->to.y),
                        placed->velocity.y + placed->rate * (at.x - placed->to.x)};
}

/** The centre in the scene: the one given, or the centroid. */
static sph2d_vec2 center_of(const sph2d_shape *shape, sph2d_vec2 given)
{
    return isnan(given.x) ? sph2d_shape_centroid(shape) : given;
}

bool sph2d__place_corners(sph2d__contacts *c, sph2d__placed *placed)
{
    const sph2d_shape *shape = placed->shape;
    if (shape->kind == SPH2D_SHAPE_CIRCLE) {
        placed->center = now(placed, shape->circle.center);
        return true;
    }
    const double chord = shape->kind == SPH2D_SHAPE_ARC ? CHORD * shape->arc.radius : 1;
    const size_t count = sph2d_shape_corners(shape, chord, NULL);
    sph2d_vec2 *corners = sph2d__arena_alloc(&c->arena, &c->memory, count, sizeof *corners);
    if (!corners && count > 0)
        return false;
    sph2d_shape_corners(shape, chord, corners);
    for (size_t i = 0; i < count; ++i)
        corners[i] = now(placed, corners[i]);
    placed->corners = corners;
    placed->corner_count = count;
    return true;
}

/** Sets the box of what is placed, not yet grown; returns a bound of the distance of its points from its centre. */
static double measure(sph2d__placed *placed)
{
    sph2d_box box = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    if (placed->shape->kind == SPH2D_SHAPE_CIRCLE) {
        sph2d_vec2 center = placed->center;
        double r = placed->shape->circle.radius;
        box = (sph2d_box){{center.x - r, center.y - r}, {center.x + r, center.y + r}};
    }
    for (size_t i = 0; i < placed->corner_count; ++i) {
        sph2d_vec2 p = placed->corners[i];
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
    sph2d__placed placed = {.shape = &body->shape, .to = c->bodies[i].center, .number = i};
    placed.from = center_of(placed.shape, body->center);
    turn(&placed, c->bodies[i].angle);
    return placed;
}

static sph2d__placed placed_obstacle(const sph2d__contacts *c, size_t i)
{
    const sph2d_obstacle *obstacle = &c->scene->obstacles[i];
    const sph2d_body_state *state = &c->obstacles[i];
    sph2d__placed placed = {.shape = &obstacle->shape, .to = state->center, .velocity = state->velocity};
    placed.from = center_of(placed.shape, obstacle->motion.center);
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
        if (!sph2d__place_corners(c, placed))
            return SPH2D_NOMEM;
        double reach = measure(placed);
        const sph2d_contact_body *body = &c->bodies[i];
        fastest = fmax(fastest, hypot(body->velocity.x, body->velocity.y) + fabs(body->rate) * reach);
    }
    for (size_t i = 0; i < obstacle_count; ++i) {
        sph2d__placed *placed = &c->placed[c->placed_count++];
        *placed = placed_obstacle(c, i);
        if (!sph2d__place_corners(c, placed))
            return SPH2D_NOMEM;
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
