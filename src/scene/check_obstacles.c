/* SPDX-License-Identifier: MIT */
/** @file check_obstacles.c
 *  Checks of obstacles and bodies as the scene draws them: their outlines, and the side of the liquid. */
#include <math.h>
#include <stdio.h>

#include "base/pi.h"
#include "scene/checker.h"
#include "scene/liquid.h"
#include "scene/shape.h"

enum { PATH_SIZE = SPH2D__PATH_SIZE };
typedef sph2d__checker checker;

/** Checks the name of an obstacle. */
static void check_wall_name(checker *c, size_t i)
{
    const char *name = c->world->walls[i].name;
    char path[PATH_SIZE];
    if (!name)
        return;
    sph2d__check_wall_path(c, path, i, ".name");
    int wall = sph2d__wall_named(c->world, name);
    if (!sph2d__check_name(name))
        sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, path, "must be 1 to 64 letters, digits, _ or -");
    else if (wall < SPH2D__WALL_OBSTACLE)
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, path, "is the name of a side of the domain");
    else if (wall != (int)i)
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, path, "another obstacle or body has this name");
}

static void check_points_inside(checker *c, sph2d_points points, const char *path)
{
    size_t i = 0;
    while (i < points.count && sph2d__check_in_domain(c->scene, points.items[i]))
        ++i;
    if (i < points.count) /* one tells: a drawing has hundreds */
        sph2d__check_outside(c, path, points.items[i]);
}

static void check_outline_points(checker *c, sph2d_points points, bool two, const char *path)
{
    if (two ? points.count != 2 : points.count < 2) {
        sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, path,
                           two ? "a line has two points" : "a polyline has two points or more");
        return;
    }
    if (!sph2d__check_count(c, points, path))
        return;
    check_points_inside(c, points, path);
    for (size_t i = 1; i < points.count; ++i) {
        sph2d_vec2 p = points.items[i];
        if (p.x == points.items[i - 1].x && p.y == points.items[i - 1].y)
            sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, path, "two consecutive points are the same");
    }
}

static double domain_diagonal(const sph2d_scene *scene)
{
    return hypot(scene->domain.max.x - scene->domain.min.x, scene->domain.max.y - scene->domain.min.y);
}

static void check_arc(checker *c, const sph2d_arc *arc, size_t i)
{
    char path[PATH_SIZE];
    double turn = arc->to - arc->from;
    if (!(turn > 0 && turn < 2 * SPH2D__PI)) {
        sph2d_diagnostic *d = sph2d__check_fault(
            c, SPH2D_CODE_OUT_OF_RANGE, sph2d__check_wall_path(c, path, i, ".arc.to"),
            turn > 0 ? "is a full turn or more above `from`" : "must be above `from`: arcs go anticlockwise");
        sph2d_diagnostic_hint(d, turn > 0 ? "use a circle; with `liquid: inside` it is hollow"
                                          : "a full turn more, 6.28319, is the same direction");
        return;
    }
    sph2d_box b = sph2d__arc_bounds(arc);
    sph2d__check_wall_path(c, path, i, ".arc");
    if (!sph2d__check_in_domain(c->scene, b.min))
        sph2d__check_outside(c, path, b.min);
    else if (!sph2d__check_in_domain(c->scene, b.max))
        sph2d__check_outside(c, path, b.max);
}

static void check_obstacle(checker *c, size_t i)
{
    const sph2d__wall *wall = &c->world->walls[i];
    const sph2d_shape *outline = &wall->shape;
    char path[PATH_SIZE];
    check_wall_name(c, i);
    if (wall->form == SPH2D_WALL_SPRING && c->scene->method.name == SPH2D_METHOD_MULLER) {
        sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_UNSUPPORTED, sph2d__check_wall_path(c, path, i, ".form"),
                                                 "only sides of the domain can be springs");
        sph2d_diagnostic_hint(d, "use heavy or reflect");
    }
    switch (outline->kind) {
    case SPH2D_SHAPE_LINE:
        check_outline_points(c, outline->points, true, sph2d__check_wall_path(c, path, i, ".line"));
        break;
    case SPH2D_SHAPE_POLYLINE:
        check_outline_points(c, outline->points, false, sph2d__check_wall_path(c, path, i, ".polyline"));
        break;
    case SPH2D_SHAPE_CIRCLE:
        if (!sph2d__check_in_domain(c->scene, outline->circle.center))
            sph2d__check_outside(c, sph2d__check_wall_path(c, path, i, ".circle.center"), outline->circle.center);
        if (outline->circle.radius > domain_diagonal(c->scene))
            sph2d__check_fault(c, SPH2D_CODE_OUTSIDE, sph2d__check_wall_path(c, path, i, ".circle.radius"),
                               "is larger than the domain");
        break;
    case SPH2D_SHAPE_BOX:
        sph2d__check_wall_path(c, path, i, ".box");
        if (sph2d__check_box(c, outline->box, path)) {
            if (!sph2d__check_in_domain(c->scene, outline->box.min))
                sph2d__check_outside(c, path, outline->box.min);
            if (!sph2d__check_in_domain(c->scene, outline->box.max))
                sph2d__check_outside(c, path, outline->box.max);
        }
        break;
    case SPH2D_SHAPE_POLYGON:
        sph2d__check_wall_path(c, path, i, ".polygon");
        if (sph2d__check_polygon(c, outline->points, path))
            check_points_inside(c, outline->points, path);
        break;
    case SPH2D_SHAPE_ARC:
        check_arc(c, &outline->arc, i);
        break;
    case SPH2D_SHAPE_SVG:
        sph2d__check_unread(c, sph2d__check_wall_path(c, path, i, ".svg"));
        break;
    case SPH2D_SHAPE_NONE: {
        sph2d_diagnostic *d =
            sph2d__check_fault(c, SPH2D_CODE_MISSING_KEY, sph2d__check_wall_path(c, path, i, ""), "has no outline");
        sph2d_diagnostic_hint(d, "give one of %s",
                              wall->body ? "circle, box, polygon, svg"
                                         : "line, polyline, circle, box, polygon, arc, svg");
        break;
    }
    }
}

/** Whether a line can be a solid of the layers' thickness. */
static bool can_be_solid(const sph2d_scene *scene, const sph2d_shape *outline)
{
    sph2d__memory memory = sph2d__memory_from((sph2d_allocator){NULL, NULL});
    size_t count = sph2d_shape_corners(outline, scene->spacing, NULL);
    void *points = sph2d__alloc(&memory, 3 * count, sizeof(sph2d_vec2));
    sph2d_vec2 *corners = points, *line = corners ? corners + 2 * count : NULL;
    sph2d_shape_corners(outline, scene->spacing, line);
    bool can = !corners || sph2d__solid_of_line((sph2d_points){line, count}, sph2d__layer_thickness(scene), corners);
    sph2d__release(&memory, &points, 3 * count, sizeof(sph2d_vec2));
    return can;
}

/** Layers inside an arc must fit there, and their back: liquid from behind must not get into them. */
static void check_layers_inside(checker *c, const sph2d_arc *arc, size_t i)
{
    double thickness = sph2d__layer_thickness(c->scene);
    char path[PATH_SIZE];
    if (arc->radius > thickness)
        return;
    sph2d_diagnostic *d = sph2d__check_fault(
        c, SPH2D_CODE_CONFLICT, sph2d__check_wall_path(c, path, i, ".arc.radius"),
        "is not larger than the thickness of the layers, which are inside the arc as the liquid is outside");
    sph2d_diagnostic_hint(d, "make it larger than %.3g m, or draw the solid as a `polygon`", thickness);
}

/** Checks that the wet side of a line is given or can be found, and that a line wet on both sides can be a solid. */
static void check_side(checker *c, size_t i)
{
    const sph2d__wall *wall = &c->world->walls[i];
    char path[PATH_SIZE];
    sph2d_diagnostic *d;
    if (wall->liquid == SPH2D_LIQUID_INSIDE && sph2d__shape_is_open(&wall->shape))
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, sph2d__check_wall_path(c, path, i, ".liquid"),
                           "a line has no inside: use left, right or both");
    if (!sph2d__wall_has_side(wall))
        return;
    sph2d_liquid_side side = sph2d__liquid_side(c->scene, wall);
    if (wall->shape.kind == SPH2D_SHAPE_ARC && side == SPH2D_LIQUID_RIGHT)
        check_layers_inside(c, &wall->shape.arc, i);
    if (side != SPH2D_LIQUID_BOTH)
        return;
    sph2d__check_wall_path(c, path, i, wall->shape_key);
    if (wall->liquid == SPH2D_LIQUID_AUTO) {
        d = sph2d__check_fault(c, SPH2D_CODE_CONFLICT, path,
                               "liquid lies on both sides of it, where the layers of boundary particles must be");
        sph2d_diagnostic_hint(d, "`liquid: both` makes it a solid %.3g m thick; or leave one side free for %.3g m",
                              sph2d__layer_thickness(c->scene), sph2d__layer_thickness(c->scene));
    } else if (!can_be_solid(c->scene, &wall->shape)) {
        d = sph2d__check_fault(c, SPH2D_CODE_CONFLICT, path,
                               "turns too sharply for a solid of the layers' thickness that has liquid on both sides");
        sph2d_diagnostic_hint(d, "draw the solid as a `polygon`, %.3g m thick or thicker",
                              sph2d__layer_thickness(c->scene));
    }
}

/* Maximum number of points of all outlines, so that a scene is placed in seconds. */
static const size_t MAX_ALL_POINTS = 5000;

static void check_all_points(checker *c)
{
    size_t points = 0;
    for (size_t i = SPH2D__WALL_OBSTACLE; i < c->world->wall_count; ++i) {
        const sph2d_shape *o = &c->world->walls[i].shape;
        bool solid_arc = o->kind == SPH2D_SHAPE_ARC && c->world->walls[i].liquid == SPH2D_LIQUID_BOTH;
        points += solid_arc                         ? sph2d_shape_corners(o, c->scene->spacing, NULL)
                  : o->kind == SPH2D_SHAPE_POLYLINE ? o->points.count
                  : o->kind == SPH2D_SHAPE_POLYGON  ? o->points.count
                                                    : 4;
    }
    if (points <= MAX_ALL_POINTS)
        return;
    char message[100];
    snprintf(message, sizeof message, "have %zu points in all, more than %zu", points, MAX_ALL_POINTS);
    sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, "obstacles", message);
    sph2d_diagnostic_hint(d, "points nearer to each other than the spacing of %g m change nothing: leave some out",
                          c->scene->spacing);
}

void sph2d__check_obstacles(checker *c)
{
    check_all_points(c);
    for (size_t i = SPH2D__WALL_OBSTACLE; i < c->world->wall_count; ++i)
        check_obstacle(c, i);
    sph2d__check_motion_keys(c);
    sph2d__check_body_keys(c);
    for (size_t i = SPH2D__WALL_OBSTACLE; c->errors == 0 && i < c->world->wall_count; ++i)
        check_side(c, i);
}
