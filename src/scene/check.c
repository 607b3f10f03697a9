/* SPDX-License-Identifier: MIT */
/** @file check.c
 *  Checks a scene and resolves it: the range of every number, then items, then what depends on all of them. */
#include <math.h>
#include <stdio.h>

#include "base/null.h"
#include "scene/checker.h"
#include "scene/derive.h"
#include "scene/liquid.h"
#include "scene/openings.h"
#include "scene/shape.h"

/* Smallest spacing over the largest coordinate: leaves three digits for the distance between neighbours. */
static const double MIN_SPACING = 1e-13;
enum { PATH_SIZE = SPH2D__PATH_SIZE };
typedef sph2d__checker checker;

/** Whether doubles resolve the spacing at the domain's coordinates. */
static bool check_precision(checker *c)
{
    sph2d_box d = c->scene->domain;
    double reach = fmax(fmax(fabs(d.min.x), fabs(d.max.x)), fmax(fabs(d.min.y), fabs(d.max.y)));
    if (reach < 1e150 && c->scene->spacing >= MIN_SPACING * reach)
        return true;
    sph2d_diagnostic *d1 =
        sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, "spacing", "is too small for coordinates so far from 0");
    sph2d_diagnostic_hint(d1, "move the domain: spacing must be at least %g of its largest coordinate", MIN_SPACING);
    return false;
}

/** Whether the domain has room for a particle. */
static bool check_spacing(checker *c)
{
    sph2d_box d = c->scene->domain;
    double side = fmin(d.max.x - d.min.x, d.max.y - d.min.y);
    if (c->scene->spacing <= side)
        return true;
    sph2d_diagnostic *d1 =
        sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, "spacing", "is larger than the shorter side of the domain");
    sph2d_diagnostic_hint(
        d1, "no particle fits: at most %g m, and a tenth of the liquid's depth or less to show motion", side);
    return false;
}

/** Whether two rectangles have a point in common. */
static bool meet(sph2d_box a, sph2d_box b)
{
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}

/** Checks that a shape is given, valid, and inside the domain: all of it, or (unless `inside`) a part. */
static void check_shape(checker *c, const sph2d_shape *shape, const char *list, size_t index, bool inside)
{
    char path[PATH_SIZE];
    switch (shape->kind) {
    case SPH2D_SHAPE_BOX:
        if (!sph2d__check_box(c, shape->box, sph2d__check_path(path, list, index, ".box")))
            return;
        break;
    case SPH2D_SHAPE_CIRCLE:
        sph2d__check_path(path, list, index, ".circle");
        break;
    case SPH2D_SHAPE_POLYGON:
        sph2d__check_path(path, list, index, ".polygon");
        if (!sph2d__check_polygon(c, shape->points, path))
            return;
        break;
    case SPH2D_SHAPE_SVG:
        sph2d__check_unread(c, sph2d__check_path(path, list, index, ".svg"));
        return;
    case SPH2D_SHAPE_LINE:
    case SPH2D_SHAPE_POLYLINE:
    case SPH2D_SHAPE_ARC:
    case SPH2D_SHAPE_NONE: {
        sph2d_diagnostic *d =
            sph2d__check_fault(c, SPH2D_CODE_MISSING_KEY, sph2d__check_path(path, list, index, ""), "has no shape");
        sph2d_diagnostic_hint(d, "give one of box, circle, polygon, svg");
        return;
    }
    }
    sph2d_box b = sph2d__shape_bounds(shape);
    if (!inside && meet(b, c->scene->domain))
        return;
    if (!sph2d__check_in_domain(c->scene, b.min))
        sph2d__check_outside(c, path, b.min);
    else if (!sph2d__check_in_domain(c->scene, b.max))
        sph2d__check_outside(c, path, b.max);
}

static void check_times(checker *c, const char *list, size_t index, double start, double stop)
{
    char path[PATH_SIZE];
    if (stop != 0 && !(stop > start))
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, sph2d__check_path(path, list, index, ".stop"),
                           "must be later than start");
}

static void check_block(checker *c, size_t i)
{
    const sph2d_block *block = &c->scene->blocks[i];
    check_shape(c, &block->shape, "blocks", i, true);
    char path[PATH_SIZE];
    double dx = c->scene->spacing;
    if (block->spacing != 0 && !(block->spacing >= 0.03 * dx && block->spacing <= 2 * dx))
        sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, sph2d__check_path(path, "blocks", i, ".spacing"),
                           "must be between 0.03 and 2 times the scene's spacing: 1100 to 1/4 times its density");
    if (block->arrangement == SPH2D_ARRANGEMENT_RINGS && block->shape.kind != SPH2D_SHAPE_CIRCLE)
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, sph2d__check_path(path, "blocks", i, ".arrangement"),
                           "only a disc can be made of rings; leave it out");
}

static bool near_side(const sph2d_scene *scene, sph2d_vec2 p)
{
    double margin = 0.3 * scene->spacing;
    sph2d_box d = scene->domain;
    return p.x < d.min.x + margin || p.x > d.max.x - margin || p.y < d.min.y + margin || p.y > d.max.y - margin;
}

static void check_source(checker *c, size_t i)
{
    const sph2d_source *source = &c->scene->sources[i];
    char path[PATH_SIZE];
    if (!sph2d__check_in_domain(c->scene, source->at))
        sph2d__check_outside(c, sph2d__check_path(path, "sources", i, ".at"), source->at);
    else if (near_side(c->scene, source->at)) {
        sph2d_diagnostic *w =
            sph2d_report_add(c->report, SPH2D_WARNING, SPH2D_CODE_OUTSIDE, sph2d__check_path(path, "sources", i, ".at"),
                             "a nozzle on a side of the domain cannot emit particles");
        sph2d_diagnostic_hint(w, "move it half a spacing inwards");
    }
    sph2d_box box = c->scene->domain;
    if (source->width > hypot(box.max.x - box.min.x, box.max.y - box.min.y))
        sph2d__check_fault(c, SPH2D_CODE_OUTSIDE, sph2d__check_path(path, "sources", i, ".width"),
                           "is larger than the domain");
    if (source->direction.x == 0 && source->direction.y == 0)
        sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, sph2d__check_path(path, "sources", i, ".direction"),
                           "must not be (0, 0)");
    double width = fmax(source->width, c->scene->spacing);
    if (source->speed > 0 && source->rate > width * source->speed * (1 + 1e-9)) {
        sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_CONFLICT, sph2d__check_path(path, "sources", i, ".rate"),
                                                 "is more than a jet of this width and speed can carry");
        sph2d_diagnostic_hint(d, "at most width * speed = %g m^2/s", width * source->speed);
    }
    check_times(c, "sources", i, source->start, source->stop);
}

static void check_interaction(checker *c, size_t i)
{
    char path[PATH_SIZE];
    sph2d__check_path(path, "interactions", i, ".path");
    if (c->scene->interactions[i].path.count == 0)
        sph2d__check_fault(c, SPH2D_CODE_MISSING_KEY, path, "needs one [t, x, y] point at least");
    const sph2d_path *times = &c->scene->interactions[i].path;
    sph2d__check_times(c, times->count > 0 ? &times->items[0].t : NULL, times->count, 3, path);
    double radius = c->scene->interactions[i].radius;
    sph2d_box reach = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (size_t k = 0; k < times->count; ++k) {
        const sph2d_path_point *p = &times->items[k];
        reach.min = (sph2d_vec2){fmin(reach.min.x, p->x - radius), fmin(reach.min.y, p->y - radius)};
        reach.max = (sph2d_vec2){fmax(reach.max.x, p->x + radius), fmax(reach.max.y, p->y + radius)};
    }
    if (times->count > 0 && !meet(reach, c->scene->domain))
        sph2d__check_outside(c, path, (sph2d_vec2){times->items[0].x, times->items[0].y});
}

/** Checks that an absorbing end is at a side that ends, and in the domain. */
static void check_absorber(checker *c, size_t i)
{
    const sph2d_scene *scene = c->scene;
    const sph2d_absorber *a = &scene->absorbers[i];
    bool across = sph2d__side_is_vertical((int)a->side);
    sph2d_box d = scene->domain;
    double size = across ? d.max.x - d.min.x : d.max.y - d.min.y;
    char path[PATH_SIZE];
    if ((size_t)a->side >= SPH2D__WALL_OBSTACLE) /* no word of it: told by the checks of ranges */
        return;
    if (sph2d__side_of(scene, (int)a->side) == SPH2D_SIDE_PERIODIC)
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, sph2d__check_path(path, "absorbers", i, ".side"),
                           "is periodic: waves go on beyond it");
    if (a->length > size)
        sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, sph2d__check_path(path, "absorbers", i, ".length"),
                           "reaches beyond the domain");
    if (!(a->rate > 0) && !(c->world->gravity.size > 0))
        sph2d__check_fault(c, SPH2D_CODE_MISSING_KEY, sph2d__check_path(path, "absorbers", i, ".rate"),
                           "must be given, as there is no gravity from which it could follow");
    for (size_t k = 0; k < i; ++k)
        if (scene->absorbers[k].side == a->side)
            sph2d__check_fault(c, SPH2D_CODE_CONFLICT, sph2d__check_path(path, "absorbers", i, ".side"),
                               "has an absorber already: one is enough");
}

/* Maximum number of items of a list, so that a scene is checked in seconds: many are compared with each other. */
enum { MAX_ITEMS = 1000 };

static void check_lists(checker *c)
{
    const sph2d_scene *s = c->scene;
    const struct {
        const char *path;
        size_t count;
    } lists[] = {{"blocks", s->block_count},      {"sources", s->source_count},
                 {"drains", s->drain_count},      {"obstacles", s->obstacle_count},
                 {"bodies", s->body_count},       {"probes", s->probe_count},
                 {"openings", s->opening_count},  {"interactions", s->interaction_count},
                 {"absorbers", s->absorber_count}};
    for (size_t k = 0; k < sizeof lists / sizeof *lists; ++k) {
        char message[80];
        snprintf(message, sizeof message, "has %zu items, more than %d", lists[k].count, MAX_ITEMS);
        if (lists[k].count > MAX_ITEMS)
            sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, lists[k].path, message);
    }
}

static void check_contents(checker *c)
{
    const sph2d_scene *scene = c->scene;
    if (scene->block_count == 0 && scene->source_count == 0 && scene->opening_count == 0 && !scene->particles.file &&
        scene->particles.count == 0 && !sph2d__starts_from_snapshot(scene)) {
        sph2d_diagnostic *d =
            sph2d__check_fault(c, SPH2D_CODE_NO_PARTICLES, "blocks", "the scene has neither liquid nor a source");
        sph2d_diagnostic_hint(d, "add a block, `blocks: [{box: {min: [0, 0], max: [0.4, 0.8]}}]`, or a source");
        return;
    }
    double c0 = c->errors == 0 ? c->world->derived.sound_speed : 1;
    if (!isfinite(c0))
        sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, "method",
                           "the sound speed that follows from the scene is not finite");
    if (!(c0 > 0)) {
        sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_MISSING_KEY, "method.stiffness",
                                                 "without gravity and speeds the sound speed is not determined");
        sph2d_diagnostic_hint(d, "give the stiffness k = c0^2, in m^2/s^2, or the sound_speed c0, in m/s");
    }
}

/** Checks that a nozzle lies in no solid at rest, and warns of one in a body or in liquid: no particle has room there. */
static void check_nozzle(checker *c, size_t i)
{
    const sph2d_scene *scene = c->scene;
    sph2d_vec2 at = scene->sources[i].at;
    char path[PATH_SIZE], other[64], message[160];
    sph2d__check_path(path, "sources", i, ".at");
    for (size_t k = SPH2D__WALL_OBSTACLE; k < c->world->wall_count; ++k) {
        const sph2d__wall *o = &c->world->walls[k];
        if ((!o->body && sph2d__wall_moves(o)) || !sph2d__wall_fills(scene, o, at))
            continue;
        snprintf(message, sizeof message, "lies inside %s: a nozzle there cannot feed the liquid",
                 sph2d__wall_path(other, sizeof other, o, ""));
        sph2d_diagnostic *d = o->body
                                  ? sph2d_report_add(c->report, SPH2D_WARNING, SPH2D_CODE_OVERLAP, path, "%s", message)
                                  : sph2d__check_fault(c, SPH2D_CODE_OVERLAP, path, message);
        sph2d__check_hint_wall(c, d, k, "move it half a spacing outside");
        return;
    }
    for (size_t k = 0; k < scene->block_count; ++k)
        if (scene->sources[i].start <= 0 && sph2d__shape_contains(&scene->blocks[k].shape, at)) {
            sph2d_diagnostic *d =
                sph2d_report_add(c->report, SPH2D_WARNING, SPH2D_CODE_OVERLAP, path,
                                 "lies in the liquid of blocks[%zu]: a nozzle feeds only where there is room", k);
            sph2d_diagnostic_hint(d, "move it out of the liquid; what flows in below its surface is an opening's");
            return;
        }
}

/** Checks what is drawn, item by item; ranges are checked. */
static void check_items(checker *c)
{
    const sph2d_scene *scene = c->scene;
    for (size_t i = 0; i < scene->block_count; ++i)
        check_block(c, i);
    sph2d__check_starts(c);
    sph2d__check_particles(c);
    for (size_t i = 0; i < scene->source_count; ++i)
        check_source(c, i);
    for (size_t i = 0; i < scene->drain_count; ++i) {
        check_shape(c, &scene->drains[i].shape, "drains", i, false);
        check_times(c, "drains", i, scene->drains[i].start, scene->drains[i].stop);
    }
    for (size_t i = 0; i < scene->absorber_count; ++i)
        check_absorber(c, i);
    sph2d__check_obstacles(c);
}

/** Checks what lies or moves where other things are; without errors before, the world is resolved. */
static void check_consistency(checker *c)
{
    const sph2d_scene *scene = c->scene;
    if (c->errors == 0)
        sph2d__check_bodies(c);
    if (c->errors == 0)
        sph2d__check_motions(c);
    if (c->errors == 0) {
        sph2d__check_thin(c);
        sph2d__check_narrow(c);
    }
    sph2d__check_liquid(c);
    if (c->errors == 0)
        sph2d__check_openings(c);
    for (size_t i = 0; i < scene->interaction_count; ++i)
        check_interaction(c, i);
    for (size_t i = 0; i < scene->probe_count; ++i)
        sph2d__check_probe(c, i);
    sph2d__check_rate(c, scene->run.snapshots.rate, "run.snapshots");
    sph2d__check_rate(c, scene->run.frames.rate, "run.frames");
    sph2d__check_frames(c);
    sph2d__check_method(c);
    check_contents(c);
    if (c->errors == 0) {
        for (size_t i = 0; i < scene->source_count; ++i)
            check_nozzle(c, i);
        sph2d__check_reach(c);
        sph2d__check_weak(c);
    }
}

/** Checks what all else depends on: lists that can be read, numbers in range, a domain that holds a particle. */
static bool check_base(checker *c)
{
    if (c->scene->struct_size != sizeof *c->scene) {
        sph2d__check_fault(c, SPH2D_CODE_GENERAL, NULL,
                           "the scene was not made by sph2d_scene_default() of this version");
        return false;
    }
    check_lists(c);
    if (c->errors > 0)
        return false;
    sph2d__check_ranges(c);
    return sph2d__check_box(c, c->scene->domain, "domain") && c->scene->spacing > 0 && !c->broken &&
           check_precision(c) && check_spacing(c);
}

/** Once outlines are valid: the wet sides of lines, and what follows from the whole. */
static sph2d_status resolve(sph2d__world *world, sph2d__arena *arena, sph2d__memory *memory)
{
    sph2d_status status = sph2d__resolve_sides(world, arena, memory);
    return status == SPH2D_OK ? sph2d__derive(world, arena, memory) : status;
}

sph2d_status sph2d__world_make(sph2d__world *world, const sph2d_scene *scene, bool started, sph2d__arena *arena,
                               sph2d__memory *memory, sph2d_report *report)
{
    checker c = {.given = scene, .world = world, .scene = scene, .report = report, .started = started};
    if (!check_base(&c))
        return SPH2D_SCENE;
    sph2d_status status = sph2d__world_copy(world, scene, arena, memory);
    if (status != SPH2D_OK)
        return status;
    c.scene = &world->scene;
    check_items(&c);
    if (c.errors == 0)
        status = resolve(world, arena, memory);
    if (status != SPH2D_OK)
        return status;
    check_consistency(&c);
    if (c.errors > 0)
        return SPH2D_SCENE;
    sph2d__add_reservoirs(world);
    return SPH2D_OK;
}

sph2d_status sph2d_scene_check(const sph2d_scene *scene, sph2d_report *report)
{
    if (!scene)
        return sph2d__null(report, __func__, "scene");
    sph2d__memory memory = sph2d__memory_from((sph2d_allocator){NULL, NULL});
    sph2d__arena arena = {0};
    sph2d__world world;
    sph2d_status status = sph2d__world_make(&world, scene, false, &arena, &memory, report);
    sph2d__arena_free(&arena, &memory);
    return status;
}
