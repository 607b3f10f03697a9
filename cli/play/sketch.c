/* SPDX-License-Identifier: MIT */
/** @file sketch.c
 *  Bodies that the mouse draws, holds in their places, and takes away. */
#include "sketch.h"

#include <math.h>
#include <stdio.h>

/* ---- shapes ------------------------------------------------------------------------------------------------------ */

/* The smallest body [spacings across], which the checker does not warn of. */
static const double SMALLEST = 4;

/* A place between the walls, as far from them as bodies are kept apart. */
static sph2d_vec2 between_walls(const live *l, sph2d_vec2 p)
{
    const sph2d_box d = l->scene.domain;
    const double gap = l->scene.spacing / 5;
    return (sph2d_vec2){fmin(fmax(p.x, d.min.x + gap), d.max.x - gap), fmin(fmax(p.y, d.min.y + gap), d.max.y - gap)};
}

/* How far a place is from the nearest of these limits [m]. */
static double room_around(const live *l, sph2d_vec2 p)
{
    const sph2d_box d = l->scene.domain;
    const double gap = l->scene.spacing / 5;
    return fmin(fmin(p.x - d.min.x, d.max.x - p.x), fmin(p.y - d.min.y, d.max.y - p.y)) - gap;
}

bool sketch_shape(const hand *h, const live *l, sph2d_shape *shape)
{
    if (h->corner_count == 0)
        return false;
    const sph2d_vec2 from = h->corners[0], at = between_walls(l, h->at);
    *shape = (sph2d_shape){.kind = SPH2D_SHAPE_POLYGON, .points = {h->corners, h->corner_count}};
    if (h->tool == HAND_CIRCLE)
        *shape = (sph2d_shape){.kind = SPH2D_SHAPE_CIRCLE,
                               .circle = {from, fmin(hypot(at.x - from.x, at.y - from.y), room_around(l, from))}};
    else if (h->tool == HAND_BOX)
        *shape =
            (sph2d_shape){.kind = SPH2D_SHAPE_BOX,
                          .box = {{fmin(from.x, at.x), fmin(from.y, at.y)}, {fmax(from.x, at.x), fmax(from.y, at.y)}}};
    else if (h->tool != HAND_OUTLINE)
        return false;
    return true;
}

static double area_of(const sph2d_shape *shape)
{
    double area = 0;
    if (shape->kind == SPH2D_SHAPE_CIRCLE)
        return 3.14159265 * shape->circle.radius * shape->circle.radius;
    if (shape->kind == SPH2D_SHAPE_BOX)
        return (shape->box.max.x - shape->box.min.x) * (shape->box.max.y - shape->box.min.y);
    const sph2d_vec2 *p = shape->points.items;
    for (size_t k = 0, j = shape->points.count - 1; k < shape->points.count; j = k++)
        area += (p[j].x * p[k].y - p[k].x * p[j].y) / 2;
    return fabs(area);
}

/* Marks the corners between two others that a line within a tolerance needs [Douglas & Peucker 1973]. */
static void mark_needed(const sph2d_vec2 *corners, size_t first, size_t last, double tolerance, bool *needed)
{
    const sph2d_vec2 line[2] = {corners[first], corners[last]};
    double most = tolerance;
    size_t farthest = first;
    for (size_t k = first + 1; k < last; ++k)
        if (drawn_distance(line, corners[k]) > most) {
            most = drawn_distance(line, corners[k]);
            farthest = k;
        }
    if (farthest == first)
        return;
    needed[farthest] = true;
    mark_needed(corners, first, farthest, tolerance, needed);
    mark_needed(corners, farthest, last, tolerance, needed);
}

/* Leaves corners out that say less than a tolerance [m]. */
static void simplify(hand *h, double tolerance)
{
    bool needed[DRAWN_MOST_CORNERS] = {true};
    needed[h->corner_count - 1] = true;
    mark_needed(h->corners, 0, h->corner_count - 1, tolerance, needed);
    size_t count = 0;
    for (size_t k = 0; k < h->corner_count; ++k)
        if (needed[k])
            h->corners[count++] = h->corners[k];
    h->corner_count = count;
}

/* Adds a corner where the hand is a spacing from the last; what is simpler makes room for more. */
static void follow(hand *h, const live *l)
{
    const sph2d_vec2 at = between_walls(l, h->at);
    const double dx = l->scene.spacing;
    const sph2d_vec2 *last = h->corner_count > 0 ? &h->corners[h->corner_count - 1] : NULL;
    if (last && (h->tool != HAND_OUTLINE || hypot(at.x - last->x, at.y - last->y) < dx))
        return;
    for (double tolerance = dx / 2; h->corner_count == DRAWN_MOST_CORNERS; tolerance *= 2)
        simplify(h, tolerance);
    h->corners[h->corner_count++] = at;
}

/* ---- bodies ------------------------------------------------------------------------------------------------------ */

/* What came of a change of bodies: in the note where the scene is against it, and then there is nothing to undo. */
static sph2d_status settle(hand *h, live *l, sph2d_status status, const char *refusal, size_t removed,
                           sph2d_report *report)
{
    if (status == SPH2D_OK && removed > 0)
        snprintf(h->note, sizeof h->note, "the body took the place of %zu particles; U brings them back", removed);
    if (status == SPH2D_OK)
        return SPH2D_OK;
    past_drop(&l->past);
    snprintf(h->note, sizeof h->note, "%s: %s", refusal, live_reason(status, report));
    if (status != SPH2D_SCENE)
        return status;
    sph2d_report_clear(report);
    return SPH2D_OK;
}

static sph2d_status let_go(hand *h, live *l, size_t body, size_t spring, sph2d_report *report)
{
    live_remember(l, "let go");
    const sph2d_status status = live_release(l, body, spring, report);
    if (status == SPH2D_OK)
        snprintf(h->note, sizeof h->note, "let go");
    return settle(h, l, status, "not let go", 0, report);
}

sph2d_status sketch_erase(hand *h, live *l, sph2d_report *report)
{
    const grip here = grip_take(l, h->at);
    const size_t springs = here.holds ? l->scene.bodies[here.body].spring_count : 0;
    if (h->tool == HAND_HOLD && springs > 0)
        return let_go(h, l, here.body, springs - 1, report);
    if (h->tool == HAND_HOLD || !here.holds || !live_is_drawn(l, here.body)) {
        snprintf(h->note, sizeof h->note, h->tool == HAND_HOLD ? "nothing is held here" : "no body was drawn here");
        return SPH2D_OK;
    }
    live_remember(l, "body taken away");
    const sph2d_status status = live_remove_body(l, here.body, report);
    if (status == SPH2D_OK)
        snprintf(h->note, sizeof h->note, "body taken away");
    return settle(h, l, status, "not taken away", 0, report);
}

sph2d_status sketch_body(hand *h, live *l, bool down, sph2d_report *report)
{
    if (down) {
        follow(h, l);
        return SPH2D_OK;
    }
    if (h->corner_count == 0)
        return SPH2D_OK;
    if (h->tool == HAND_OUTLINE)
        simplify(h, l->scene.spacing / 2);
    sph2d_shape shape;
    const sph2d_vec2 begun = h->corners[0];
    const bool made = sketch_shape(h, l, &shape);
    h->corner_count = 0; /* the corners stay */
    if (hypot(h->at.x - begun.x, h->at.y - begun.y) < live_grasp(l) && grip_take(l, h->at).holds)
        return sketch_erase(h, l, report);
    if (!made || sqrt(area_of(&shape)) < SMALLEST * l->scene.spacing) {
        snprintf(h->note, sizeof h->note, "draw a body of %.2g m across or more", SMALLEST * l->scene.spacing);
        return SPH2D_OK;
    }
    size_t removed = 0;
    live_remember(l, "body");
    const double density = h->density * l->scene.fluid.density;
    const sph2d_status status = live_add_body(l, &shape, density, &removed, report);
    return settle(h, l, status, "no body", removed, report);
}

sph2d_status sketch_put(hand *h, live *l, sph2d_report *report)
{
    size_t removed = 0;
    const body_move shift = grip_shift(&h->grip, l, h->at);
    return settle(h, l, live_put_body(l, h->grip.body, &shift, &removed, report), "not moved", removed, report);
}

/* ---- what holds them --------------------------------------------------------------------------------------------- */

sph2d_status sketch_hold(hand *h, live *l, bool down, sph2d_report *report)
{
    if (down && h->corner_count == 0) {
        h->grip = grip_take(l, h->at);
        h->corners[h->corner_count++] = h->at;
    }
    if (down || h->corner_count == 0)
        return SPH2D_OK;
    const sph2d_vec2 from = h->corners[0];
    const bool clicked = hypot(h->at.x - from.x, h->at.y - from.y) < live_grasp(l);
    h->corner_count = 0;
    size_t body, spring;
    if (clicked && live_find_spring(l, h->at, live_grasp(l), &body, &spring))
        return let_go(h, l, body, spring, report);
    if (!h->grip.holds) {
        snprintf(h->note, sizeof h->note, "click on a body to hold it, or drag from it to where a spring ends");
        return SPH2D_OK;
    }
    const sph2d_vec2 end = grip_place(&h->grip, l);
    live_remember(l, clicked ? "hinge" : "spring");
    const sph2d_status status = live_hold(l, h->grip.body, end, clicked ? end : h->at, report);
    if (status == SPH2D_OK)
        snprintf(h->note, sizeof h->note, "%s; a click on it lets go", clicked ? "a hinge" : "a spring");
    return settle(h, l, status, "not held", 0, report);
}
