/* SPDX-License-Identifier: MIT */
/** @file check_reach.c
 *  Warns of openings and drains that no liquid can get to: walls at rest separate them from all of it. */
#include <math.h>

#include "scene/checker.h"
#include "scene/flood.h"
#include "scene/liquid.h"
#include "scene/openings.h"
#include "scene/shape.h"

/* Most cells times what is put into them or asked for; most places looked at in a drain; and most of all places that are
 * compared with every obstacle. Beyond, nothing is told. */
static const double MAX_VISITS = 4e7, MAX_PLACES = 1e4;
enum { MAX_LOOKS = 20000 };

/** A place inside before an opening, at t of its width. */
static sph2d_vec2 place_before(const sph2d_scene *scene, const sph2d__mouth *m, double t)
{
    double inside = scene->spacing / 4;
    return (sph2d_vec2){m->start.x + t * m->width * m->along.x + inside * m->inward.x,
                        m->start.y + t * m->width * m->along.y + inside * m->inward.y};
}

/** Whether an opening lets liquid in, whatever is before it. */
static bool lets_in(const sph2d_scene *scene, const sph2d_opening *o)
{
    const sph2d_history *h = sph2d__opening_history(o, sph2d__opening_kind_of(o));
    if (!sph2d__opening_has_velocity(o))
        return sph2d__opening_has_surface(o);
    bool in = sph2d__opening_velocity(scene, o, INFINITY) > 0 || o->history.profile.count > 0;
    for (size_t k = 0; k < h->count; ++k)
        in = in || h->items[k].y > 0;
    return in;
}

/** Puts liquid wherever the scene has some at any time, and lets it spread. */
static void flood_all(sph2d__flood *flood)
{
    const sph2d_scene *scene = flood->scene;
    for (size_t i = 0; i < scene->block_count; ++i)
        sph2d__flood_shape(flood, &scene->blocks[i].shape);
    for (size_t i = 0; i < scene->source_count; ++i)
        sph2d__flood_position(flood, scene->sources[i].at);
    for (size_t i = 0; i < scene->particles.count; ++i)
        sph2d__flood_position(flood, (sph2d_vec2){scene->particles.items[i].x, scene->particles.items[i].y});
    for (size_t i = 0; i < scene->opening_count; ++i) {
        sph2d__mouth m = sph2d__opening_mouth(scene, &scene->openings[i]);
        for (double t = 0.5 * scene->spacing / m.width; lets_in(scene, &scene->openings[i]) && t < 1;
             t += scene->spacing / m.width)
            sph2d__flood_position(flood, place_before(scene, &m, t));
    }
    sph2d__flood_spread(flood, INFINITY);
}

static bool opening_is_reached(const sph2d__flood *flood, const sph2d_opening *o)
{
    sph2d__mouth m = sph2d__opening_mouth(flood->scene, o);
    bool reached = false;
    for (double t = 0.5 * flood->scene->spacing / m.width; !reached && t < 1; t += flood->scene->spacing / m.width)
        reached = sph2d__flood_reached(flood, place_before(flood->scene, &m, t));
    return reached;
}

/** Whether liquid gets to a place, which is in no obstacle at rest; true, too, once `looks` is 0. */
static bool is_wet(const sph2d__flood *flood, sph2d_vec2 p, int *looks)
{
    const sph2d_scene *scene = flood->scene;
    if (!sph2d__flood_reached(flood, p))
        return false;
    if (*looks == 0)
        return true;
    --*looks;
    for (size_t i = SPH2D__WALL_OBSTACLE; i < flood->world->wall_count; ++i) {
        const sph2d__wall *wall = &flood->world->walls[i];
        if (!sph2d__wall_moves(wall) && sph2d__wall_fills(scene, wall, p))
            return false;
    }
    return true;
}

/** Looks at places a spacing apart, or more in a large drain, and at the middle. */
static bool drain_is_reached(const sph2d__flood *flood, const sph2d_shape *shape, int *looks)
{
    sph2d_box b = sph2d__shape_bounds(shape), d = flood->scene->domain;
    b.min = (sph2d_vec2){fmax(b.min.x, d.min.x), fmax(b.min.y, d.min.y)};
    b.max = (sph2d_vec2){fmin(b.max.x, d.max.x), fmin(b.max.y, d.max.y)};
    double step = fmax(flood->scene->spacing, sqrt((b.max.x - b.min.x) * (b.max.y - b.min.y) / MAX_PLACES));
    bool reached = is_wet(flood, (sph2d_vec2){(b.min.x + b.max.x) / 2, (b.min.y + b.max.y) / 2}, looks);
    for (double y = b.min.y + step / 2; !reached && y < b.max.y; y += step)
        for (double x = b.min.x + step / 2; !reached && x < b.max.x; x += step) {
            sph2d_vec2 p = {x, y};
            reached = sph2d__shape_contains(shape, p) && is_wet(flood, p, looks);
        }
    return reached;
}

static void tell(sph2d__checker *c, const char *list, size_t index)
{
    char path[SPH2D__PATH_SIZE];
    sph2d_diagnostic *d =
        sph2d_report_add(c->report, SPH2D_WARNING, SPH2D_CODE_OUTSIDE, sph2d__check_path(path, list, index, ""),
                         "no liquid can get there: walls separate it from all blocks, sources and "
                         "openings that let liquid in");
    sph2d_diagnostic_hint(d, "leave a gap of two spacings or more, or put it elsewhere");
}

void sph2d__check_reach(sph2d__checker *c)
{
    const sph2d_scene *scene = c->scene;
    sph2d__flood flood;
    int looks = MAX_LOOKS;
    bool known = !sph2d__liquid_is_from_file(scene);
    double visits = sph2d__flood_cells(scene) * (1 + (double)scene->block_count);
    if (!known || scene->opening_count + scene->drain_count == 0 || c->world->wall_count == SPH2D__WALL_OBSTACLE ||
        visits > MAX_VISITS || !sph2d__flood_make(&flood, c->world, (sph2d_vec2){0, 0}))
        return;
    flood_all(&flood);
    for (size_t i = 0; i < scene->opening_count; ++i)
        if (!opening_is_reached(&flood, &scene->openings[i]))
            tell(c, "openings", i);
    for (size_t i = 0; i < scene->drain_count; ++i)
        if (!drain_is_reached(&flood, &scene->drains[i].shape, &looks))
            tell(c, "drains", i);
    sph2d__flood_free(&flood);
}
