/* SPDX-License-Identifier: MIT */
/** @file check_narrow.c
 *  Detects channels too narrow for the grid of method `hybrid`.
 *
 *  Water 0.4 m deep runs out of a slot in a floor 0.1 m thick, spacing 1 cm, by this part of the rate that Torricelli's law
 *  gives for its width, at two places among the squares of the grid; by `constraint` it is 0.53 to 0.57 with all widths:
 *
 *      width in spacings    2           3           4           6           10
 *      rate                 0.38 0.48   0.58 0.62   0.69 0.67   0.69 0.65   0.63 0.67 */
#include <math.h>

#include "base/memory.h"
#include "scene/checker.h"
#include "scene/liquid.h"
#include "scene/shape.h"
#include "scene/solids.h"

/* Narrower channels are told, unless no particle gets into them; and steps across one [spacings]. */
static const double NARROW = 2.9, CLOSED = 0.5, STEP = 0.125;
/* Most places along a piece of a wall. */
static const double MOST_PLACES = 500;

/** A place where walls are near each other. */
typedef struct place {
    double width; /**< [m] */
    sph2d_vec2 at;
} place;

/** A search: the narrowest channel that it has found, and the narrowest place of the one that it is at, unless that has an
 *  end, as between a slope and a floor. */
typedef struct search {
    const sph2d__world *world;
    const sph2d_scene *scene;
    sph2d__solids solids;
    place found, here;
    double before; /**< the width at the last place */
    bool ends;
} search;

static bool is_solid(const search *s, sph2d_vec2 p)
{
    const sph2d_scene *scene = s->scene;
    for (int side = 0; side < SPH2D__WALL_OBSTACLE; ++side)
        if (sph2d__side_of(scene, side) == SPH2D_SIDE_WALL && sph2d__side_distance(&scene->domain, side, p) < 0)
            return true;
    const sph2d__solid_list near = sph2d__solids_near(&s->solids, p);
    for (size_t n = 0; n < near.count; ++n) {
        const sph2d__wall *o = &s->world->walls[near.wall[n]];
        if (sph2d__wall_moves(o))
            continue;
        if (sph2d__shape_is_open(&o->shape)
                ? sph2d__shape_nearest(&o->shape, scene->spacing, p) < 0.51 * STEP * scene->spacing
                : sph2d__wall_fills(scene, o, p))
            return true;
    }
    return false;
}

/** The width of the channel from a place of a wall along its normal; 0: no liquid there, INFINITY: it is wide [m]. */
static double width_at(const search *s, sph2d_vec2 p, sph2d_vec2 n)
{
    const double step = STEP * s->scene->spacing;
    for (double d = step; d < NARROW * s->scene->spacing; d += step)
        if (is_solid(s, (sph2d_vec2){p.x + d * n.x, p.y + d * n.y}))
            return d < CLOSED * s->scene->spacing ? 0 : d;
    return INFINITY;
}

/** Leaves the channel that the search is at. */
static void leave(search *s)
{
    if (!s->ends && s->here.width < s->found.width)
        s->found = s->here;
    s->here.width = s->before = INFINITY;
    s->ends = false;
}

/** Looks along a piece of a wall, on the side of a normal. Walls at more than 45 degrees are a corner. */
static void look_along(search *s, const sph2d__segment *piece, sph2d_vec2 n)
{
    const double x = piece->b.x - piece->a.x, y = piece->b.y - piece->a.y;
    const double spacing = s->scene->spacing, length = hypot(x, y);
    const double places = fmin(fmax(ceil(2 * length / spacing), 1), MOST_PLACES), apart = length / places;
    for (double k = 0.5; k < places; ++k) {
        const sph2d_vec2 p = {piece->a.x + k / places * x, piece->a.y + k / places * y};
        const double width = width_at(s, p, n), change = fabs(width - s->before);
        s->before = width;
        if (width == INFINITY)
            leave(s);
        else if (width == 0)
            s->ends = true;
        else if (width < s->here.width && change <= apart + STEP * spacing)
            s->here = (place){width, {p.x + width / 2 * n.x, p.y + width / 2 * n.y}};
    }
}

static void look_around(search *s, const sph2d__wall *o)
{
    const double spacing = s->scene->spacing;
    for (int side = -1; side <= 1; side += 2) {
        for (size_t k = 0, n = sph2d__shape_pieces(&o->shape, spacing); k < n; ++k) {
            const sph2d__segment piece = sph2d__shape_piece(&o->shape, spacing, k);
            const double x = piece.b.x - piece.a.x, y = piece.b.y - piece.a.y, by = side / hypot(x, y);
            look_along(s, &piece, (sph2d_vec2){-by * y, by * x});
        }
        leave(s);
    }
}

void sph2d__check_narrow(sph2d__checker *c)
{
    const sph2d_scene *scene = c->scene;
    sph2d__memory memory = sph2d__memory_from((sph2d_allocator){0});
    sph2d__arena arena = {0};
    search s = {.world = c->world,
                .scene = scene,
                .found = {.width = INFINITY},
                .here = {.width = INFINITY},
                .before = INFINITY};
    if (scene->method.name != SPH2D_METHOD_HYBRID)
        return;
    if (sph2d__solids_build(&s.solids, c->world, &arena, &memory))
        for (size_t i = SPH2D__WALL_OBSTACLE; i < c->world->wall_count; ++i)
            if (!sph2d__wall_moves(&c->world->walls[i]))
                look_around(&s, &c->world->walls[i]);
    sph2d__arena_free(&arena, &memory);
    if (!(s.found.width < INFINITY))
        return;
    sph2d_diagnostic *w = sph2d_report_add(
        c->report, SPH2D_WARNING, SPH2D_CODE_CONFLICT, "spacing",
        "the channel near (%.3g, %.3g) is %.2g m wide, %.2g spacings; of such method hybrid lets out a "
        "third less than of wider ones",
        s.found.at.x, s.found.at.y, s.found.width, s.found.width / scene->spacing);
    sph2d_diagnostic_hint(w, "make the spacing %.2g m, or take another method", s.found.width / 3);
}
