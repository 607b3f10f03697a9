/* SPDX-License-Identifier: MIT */
/** @file check_weak.c
 *  Warns of scenes that a method is known to compute badly, each measured by a hard case (docs/validation.md) whose
 *  figures stand below. */
#include <math.h>

#include "scene/checker.h"
#include "scene/shape.h"

static bool is_method(const sph2d_scene *scene, sph2d_method name)
{
    return scene->method.name == name;
}

/* Films of one and of three rows still moved by 0.04 to 0.09 sqrt(g H) after 2 s, by every method but one (D4): where
 * half of the particles or more are at a surface, nothing damps them. */
static const double FEWEST_ROWS = 3.5;

/** Warns if the thickest block is a film. Sources fill as they please. */
static void check_films(sph2d__checker *c)
{
    const sph2d_scene *scene = c->scene;
    size_t thickest = 0;
    double rows = 0;
    for (size_t i = 0; i < scene->block_count; ++i) {
        sph2d_box b = sph2d__shape_bounds(&scene->blocks[i].shape);
        double thickness = fmin(b.max.x - b.min.x, b.max.y - b.min.y) / scene->spacing;
        if (thickness > rows) {
            rows = thickness;
            thickest = i;
        }
    }
    if (!(rows > 0) || !(rows < FEWEST_ROWS) || scene->source_count > 0 || scene->particles.file ||
        scene->particles.count > 0 || !(c->world->gravity.size > 0))
        return;
    char path[SPH2D__PATH_SIZE];
    sph2d_diagnostic *d = sph2d_report_add(c->report, SPH2D_WARNING, SPH2D_CODE_OUT_OF_RANGE,
                                           sph2d__check_path(path, "blocks", thickest, ""),
                                           "the thickest block is %.2g spacings thick: particles of such a film "
                                           "have no inside and do not come to rest",
                                           rows);
    sph2d_diagnostic_hint(d, "a spacing of %.2g m or less gives it ten rows", rows * scene->spacing / 10);
}

/* From 0.3 spacings of disorder on muller heats itself: 1.1 to 2.1 % of density, speeds of c0/6 to c0/3; the other
 * methods settle (C6). */
static const double MOST_DISORDER = 0.3;

static void check_disorder(sph2d__checker *c)
{
    const sph2d_scene *scene = c->scene;
    for (size_t i = 0; i < scene->block_count && is_method(scene, SPH2D_METHOD_MULLER); ++i) {
        if (!(scene->blocks[i].perturb.amplitude >= MOST_DISORDER))
            continue;
        char path[SPH2D__PATH_SIZE];
        sph2d_diagnostic *d = sph2d_report_add(
            c->report, SPH2D_WARNING, SPH2D_CODE_OUT_OF_RANGE, sph2d__check_path(path, "blocks", i, ".perturb"),
            "method muller heats liquid that starts as disordered as this: speeds of a sixth of c0 and more");
        sph2d_diagnostic_hint(d, "give an amplitude of 0.1 or less, or use `method: {name: wcsph}`");
        return;
    }
}

/* A particle that starts in a spring leaves it at up to c0/2: 8 times the speed of the highest fall (spring), 2.5
 * (heavy); generalised walls push gently (D7). */
static const double LEAST_DISTANCE = 0.5;

static void check_distance(sph2d__checker *c)
{
    const sph2d_scene *scene = c->scene;
    const sph2d_wall_form form = scene->walls;
    if (form != SPH2D_WALL_SPRING && form != SPH2D_WALL_HEAVY)
        return;
    for (size_t i = 0; scene->particles.items && i < scene->particles.count; ++i) {
        const sph2d_vec2 at = {scene->particles.items[i].x, scene->particles.items[i].y};
        double distance = sph2d__walled_distance(scene, &scene->domain, at) / scene->spacing;
        if (!(distance < LEAST_DISTANCE * (1 - 1e-9)))
            continue;
        char path[SPH2D__PATH_SIZE];
        sph2d_diagnostic *d = sph2d_report_add(
            c->report, SPH2D_WARNING, SPH2D_CODE_OUTSIDE, sph2d__check_path(path, "particles", i, ""),
            "it starts %.2g spacings from a wall that repels what is nearer than half a spacing, and is thrown away",
            distance);
        sph2d_diagnostic_hint(d, "start it half a spacing away, or use `walls: generalised` of wcsph, pcisph, "
                                 "constraint");
        return;
    }
}

/* Where friction at walls is felt over more spacings than this, liquid that slides is not the one that was named: honey
 * from a tap reached walls 1 m away within 1 s, instead of a heap 0.25 m wide (8 spacings). */
static const double THICK_LAYER = 5;

/** Viscosity of the liquid where it is sheared at a rate, without the limits of the models [Pa s]. */
static double viscosity_at(const sph2d_fluid *f, double rate)
{
    switch (f->model) {
    case SPH2D_RHEOLOGY_POWER_LAW:
    case SPH2D_RHEOLOGY_HERSCHEL_BULKLEY:
        return f->yield_stress / rate + f->consistency * pow(rate, (f->index > 0 ? f->index : 1) - 1);
    case SPH2D_RHEOLOGY_NEWTONIAN:
    case SPH2D_RHEOLOGY_CARREAU:
        break;
    }
    return f->dynamic_viscosity;
}

/** Whether all walls are free-slip by default, and there are some. */
static bool slides(const sph2d_scene *scene)
{
    const sph2d_side_slips *s = &scene->side_slip;
    bool walls = sph2d__has_side(scene, SPH2D_SIDE_WALL) || scene->obstacle_count + scene->body_count > 0;
    bool own = s->left != SPH2D_WALL_SLIP_DEFAULT || s->right != SPH2D_WALL_SLIP_DEFAULT ||
               s->bottom != SPH2D_WALL_SLIP_DEFAULT || s->top != SPH2D_WALL_SLIP_DEFAULT;
    for (size_t i = 0; i < scene->obstacle_count; ++i)
        own |= scene->obstacles[i].slip != SPH2D_WALL_SLIP_DEFAULT;
    for (size_t i = 0; i < scene->body_count; ++i)
        own |= scene->bodies[i].slip != SPH2D_WALL_SLIP_DEFAULT;
    return walls && !own && scene->wall_slip == SPH2D_SLIP_FREE;
}

/** Warns of thick liquid between free-slip walls: the layer that they would slow within the time in which it crosses the
 *  domain is sqrt(nu L/U) thick (Batchelor 1967, An Introduction to Fluid Dynamics, sec. 4.3). */
static void check_slip(sph2d__checker *c)
{
    const sph2d_scene *scene = c->scene;
    if (is_method(scene, SPH2D_METHOD_MULLER) || !slides(scene))
        return;
    double speed = sqrt(2 * c->world->derived.head);
    double length = fmax(scene->domain.max.x - scene->domain.min.x, scene->domain.max.y - scene->domain.min.y);
    double viscosity = speed > 0 ? viscosity_at(&scene->fluid, speed / length) : 0;
    double layer = viscosity > 0 ? sqrt(viscosity / scene->fluid.density * length / speed) / scene->spacing : 0;
    if (!(layer > THICK_LAYER))
        return;
    sph2d_diagnostic *d = sph2d_report_add(c->report, SPH2D_WARNING, SPH2D_CODE_CONFLICT, "wall_slip",
                                           "this liquid slides along its walls as if they were not there, though it is "
                                           "so thick that they would slow a layer of %.2g spacings",
                                           layer);
    sph2d_diagnostic_hint(
        d, "`wall_slip: none` makes it stick, as real walls do; `side_slip: {bottom: free}` says that it "
           "shall slide");
}

void sph2d__check_weak(sph2d__checker *c)
{
    check_slip(c);
    check_films(c);
    check_disorder(c);
    check_distance(c);
}
