/* SPDX-License-Identifier: MIT */
/** @file check_bodies.c
 *  Checks of bodies that the liquid moves: mass, freedoms, and that they start clear of walls and of each other. */
#include <math.h>
#include <stdio.h>

#include "base/pi.h"
#include "scene/bodies.h"
#include "scene/checker.h"
#include "scene/overlap.h"
#include "scene/shape.h"

typedef sph2d__checker checker;

/* Spacings across below which a body is a few particles; density ratios within which bodies are tested. */
static const double FEW_SPACINGS = 4, LIGHTEST = 0.05, HEAVIEST = 20;
/* How deep a body may overlap at the start [spacings]. */
static const double DEPTH = 0.05;
/* Circles have no more pieces than this here, however small the spacing. */
static const double MOST_PIECES = 2000;

static sph2d_diagnostic *fault(checker *c, size_t k, sph2d_code code, const char *key, const char *message)
{
    char path[SPH2D__PATH_SIZE];
    return sph2d__check_fault(c, code, sph2d__check_path(path, "bodies", k, key), message);
}

static sph2d_diagnostic *warning(checker *c, size_t k, const char *key, const char *message)
{
    char path[SPH2D__PATH_SIZE];
    return sph2d_report_add(c->report, SPH2D_WARNING, SPH2D_CODE_CONFLICT, sph2d__check_path(path, "bodies", k, key),
                            "%s", message);
}

static void check_mass(checker *c, size_t k)
{
    const sph2d_body *body = &c->scene->bodies[k];
    if (body->density == 0 && body->mass == 0)
        sph2d_diagnostic_hint(fault(c, k, SPH2D_CODE_MISSING_KEY, "", "has neither density nor mass"),
                              "give `density`, in kg/m^3; half of the liquid's floats half submerged: %g",
                              c->scene->fluid.density / 2);
    if (body->density > 0 && body->mass > 0)
        fault(c, k, SPH2D_CODE_CONFLICT, ".mass",
              "follows from the density, which is given, too: leave out one of them");
}

/** Velocities at the start that the scene holds at zero. */
static void check_hold(checker *c, size_t k)
{
    const sph2d_body *body = &c->scene->bodies[k];
    bool x = body->hold.x == SPH2D_SWITCH_ON, y = body->hold.y == SPH2D_SWITCH_ON;
    if ((x && body->velocity.x != 0) || (y && body->velocity.y != 0))
        fault(c, k, SPH2D_CODE_CONFLICT, ".velocity", "is along a direction in which `hold` keeps the body at rest");
    if (body->hold.angle != SPH2D_SWITCH_ON)
        return;
    if (body->rate != 0)
        fault(c, k, SPH2D_CODE_CONFLICT, ".rate", "turns a body that `hold` keeps from turning");
    if (body->motor.torque > 0)
        fault(c, k, SPH2D_CODE_CONFLICT, ".motor", "turns a body that `hold` keeps from turning");
}

/** Warns of sizes and densities beyond those that are tested. */
static void check_size(checker *c, size_t k)
{
    const sph2d_body *body = &c->scene->bodies[k];
    sph2d__mass_data m = sph2d__body_mass(body);
    double across = sqrt(m.area) / c->scene->spacing, ratio = m.mass / (m.area * c->scene->fluid.density);
    char text[160];
    if (across < FEW_SPACINGS) {
        snprintf(text, sizeof text, "is %.2g spacings across: what the liquid does to it is not resolved", across);
        sph2d_diagnostic_hint(warning(c, k, "", text), "a spacing of %.2g m or less makes it 10 across",
                              sqrt(m.area) / 10);
    }
    if (!(ratio >= LIGHTEST * (1 - 1e-9) && ratio <= HEAVIEST * (1 + 1e-9))) {
        snprintf(text, sizeof text, "is %.3g times as dense as the liquid, beyond what is tested", ratio);
        sph2d_diagnostic_hint(warning(c, k, body->mass > 0 ? ".mass" : ".density", text),
                              "bodies are tested from %g to %g times the liquid's density", LIGHTEST, HEAVIEST);
    }
}

/* The least part of the moment of inertia that the mass has if it is spread evenly; the farthest end of a spring
 * from its body, over the distance of the outline from its centroid. */
static const double LEAST_INERTIA = 1e-3, FARTHEST = 2;

/** Mass that lies elsewhere than the outline, or all in one point, is a slip of a digit. */
static void check_center(checker *c, size_t k)
{
    const sph2d_body *body = &c->scene->bodies[k];
    sph2d_vec2 center = sph2d__body_mass(body).center;
    sph2d_box b = sph2d__shape_bounds(&body->shape);
    char path[SPH2D__PATH_SIZE], text[160];
    if (!sph2d__check_in_domain(c->scene, center)) {
        sph2d__check_outside(c, sph2d__check_path(path, "bodies", k, ".center"), center);
    } else if (center.x < b.min.x || center.x > b.max.x || center.y < b.min.y || center.y > b.max.y) {
        snprintf(text, sizeof text, "(%g, %g) lies outside the body", center.x, center.y);
        sph2d_diagnostic_hint(warning(c, k, ".center", text), "the body reaches from (%g, %g) to (%g, %g)", b.min.x,
                              b.min.y, b.max.x, b.max.y);
    }
}

static void check_inertia(checker *c, size_t k)
{
    const sph2d_body *body = &c->scene->bodies[k];
    sph2d_body even = *body;
    even.inertia = 0;
    double spread = sph2d__body_mass(&even).inertia;
    char text[160];
    if (!(body->inertia > 0) || body->hold.angle == SPH2D_SWITCH_ON || body->inertia >= LEAST_INERTIA * spread)
        return;
    snprintf(text, sizeof text, "is %.2g times the moment of inertia of the same mass spread evenly",
             body->inertia / spread);
    sph2d_diagnostic_hint(fault(c, k, SPH2D_CODE_OUT_OF_RANGE, ".inertia", text),
                          "%.3g kg m spread evenly; a body that must not turn has `hold: {angle: on}`", spread);
}

/** Springs act at points that move with the body: one far away turns it by a lever that nothing shows. */
static void check_ends(checker *c, size_t k)
{
    const sph2d_body *body = &c->scene->bodies[k];
    sph2d_vec2 center = sph2d__body_mass(body).center;
    double size = sph2d__shape_distance(&body->shape, sph2d_shape_centroid(&body->shape));
    for (size_t i = 0; i < body->spring_count; ++i) {
        sph2d_vec2 at = sph2d__spring_start(&body->springs[i], center);
        double away = sph2d__shape_nearest(&body->shape, c->scene->spacing, at);
        char key[64], text[160];
        if (sph2d__shape_contains(&body->shape, at) || !(away > FARTHEST * size))
            continue;
        snprintf(key, sizeof key, ".springs[%zu].at", i);
        snprintf(text, sizeof text, "(%g, %g) is %.3g m away from the body that it is fixed to", at.x, at.y, away);
        sph2d_diagnostic_hint(warning(c, k, key, text), "`at` is a point of the body, `to` the fixed point");
    }
}

/* The steps of a run with a spring, over sqrt(M/k): sim/bodies_forces.c. */
static const double SPRING_STEP = 0.3;

/** Warns of springs so stiff that the run's steps are theirs. */
static void check_springs(checker *c, size_t k)
{
    const sph2d_body *body = &c->scene->bodies[k];
    const sph2d__derived *d = &c->world->derived;
    double mass = sph2d__body_mass(body).mass, liquid = c->scene->method.cfl * d->support_radius / d->sound_speed;
    for (size_t i = 0; i < body->spring_count; ++i) {
        double step = SPRING_STEP * sqrt(mass / body->springs[i].stiffness);
        char key[64], text[160];
        if (!(step < liquid / 2))
            continue;
        snprintf(key, sizeof key, ".springs[%zu].stiffness", i);
        snprintf(text, sizeof text, "needs steps of %.2g s, %.2g of the liquid's", step, step / liquid);
        sph2d_diagnostic_hint(warning(c, k, key, text), "up to %.2g N/m^2 it costs nothing",
                              mass * pow(SPRING_STEP / liquid, 2));
        return;
    }
}

/** The length of the pieces of a circle. */
static double piece_of(const sph2d_scene *scene, const sph2d_shape *outline)
{
    double radius = outline->kind == SPH2D_SHAPE_CIRCLE ? outline->circle.radius : 0;
    return fmax(scene->spacing, 2 * SPH2D__PI * radius / MOST_PIECES);
}

/** A wall as the scene draws it: of a line that has become a solid only the line is in a body's way at the start, so that one
 *  that is drawn later, where a body has been, leaves a scene that can be read. */
static sph2d__wall as_drawn(const checker *c, size_t number)
{
    sph2d__wall wall = c->world->walls[number];
    if (wall.kind == SPH2D__WALL_IS_OBSTACLE)
        wall.shape = c->given->obstacles[wall.index].shape;
    return wall;
}

/** Whether a body, which is wall `own`, overlaps wall `other`. */
static bool overlaps(const checker *c, size_t own, size_t other)
{
    const sph2d_scene *scene = c->scene;
    sph2d__pose start = {.cosine = 1};
    const sph2d__wall *body = &c->world->walls[own], wall = as_drawn(c, other);
    const sph2d_box a = sph2d__shape_bounds(&body->shape), b = sph2d__shape_bounds(&wall.shape);
    if (a.min.x > b.max.x || b.min.x > a.max.x || a.min.y > b.max.y || b.min.y > a.max.y)
        return false;
    double piece = fmax(piece_of(scene, &body->shape), piece_of(scene, &wall.shape));
    return sph2d__walls_overlap(body, &start, &wall, piece, DEPTH * scene->spacing);
}

/** A body starts within the domain's walls and clear of obstacles and of the bodies before it. */
static void check_place(checker *c, size_t k)
{
    const sph2d_scene *scene = c->scene;
    size_t own = c->world->first_body + k;
    sph2d__pose start = {.cosine = 1};
    const char *side = "";
    char text[160], other[64];
    const sph2d_shape *outline = &scene->bodies[k].shape;
    double beyond = sph2d__beyond_sides(scene, outline, &start, piece_of(scene, outline), &side);
    if (beyond > DEPTH * scene->spacing) {
        snprintf(text, sizeof text, "starts %.3g m beyond the %s side of the domain", beyond, side);
        fault(c, k, SPH2D_CODE_OUTSIDE, "", text);
        return;
    }
    for (size_t i = SPH2D__WALL_OBSTACLE; i < own; ++i) {
        if (!overlaps(c, own, i))
            continue;
        snprintf(text, sizeof text, "starts in %s", sph2d__wall_path(other, sizeof other, &c->world->walls[i], ""));
        sph2d_diagnostic_hint(fault(c, k, SPH2D_CODE_OVERLAP, "", text), "move one of the two");
        return;
    }
}

void sph2d__check_body_keys(checker *c)
{
    for (size_t k = 0; k < c->scene->body_count; ++k) {
        check_mass(c, k);
        check_hold(c, k);
    }
}

void sph2d__check_bodies(checker *c)
{
    for (size_t k = 0; k < c->scene->body_count; ++k) {
        check_size(c, k);
        check_center(c, k);
        check_inertia(c, k);
        check_ends(c, k);
        check_springs(c, k);
        if (!c->started)
            check_place(c, k);
    }
}
