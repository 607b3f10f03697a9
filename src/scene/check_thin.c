/* SPDX-License-Identifier: MIT */
/** @file check_thin.c
 *  Detects obstacles so thin that the liquids on their two sides interact through them.
 *
 *  With most methods a boundary particle extrapolates the pressure of all liquid around it, and fluid particles within the
 *  support radius interact even across a wall. With equal pressures on both sides, as around a plate in a pool, this is
 *  correct. The variational operators of wcsph see no liquid through walls (methods/wcsph/wcsph_sight.h), as far as there are
 *  boundary particles of both faces. For a tank 40 spacings deep beside one of 20, the errors at half the depth of the
 *  shallow one, 10 spacings above the floor, are by thickness of the wall in spacings, H = 3 dx:
 *
 *      thickness                    0.3    0.5    1      1.5    2      2.5    3      4
 *      wcsph, deep                  -7 %   -3 %   -1 %    0      0      0      0      0
 *      wcsph, shallow              +18 %   +5 %   -3 %   +2 %    0      0      0      0
 *      seen through, deep                 -25 %  -28 %  -24 %   +4 %   +3 %   +1 %   0
 *      seen through, shallow               -5 %  +37 %  -10 %  -48 %  -14 %   -7 %   0
 *
 *  Pressures on a wall 2 dx thick between surfaces 2 dx apart are within 1 %, on one of 1 dx within 6 %, seen through. */
#include <math.h>
#include <stdio.h>

#include "scene/checker.h"
#include "scene/liquid.h"
#include "scene/shape.h"

/* Maximum number of samples along a wall segment; and steps per spacing across it. */
static const double MAX_SAMPLES = 2000, STEPS_PER_SPACING = 10;
/* Maximum number of segments of an outline that are sampled: each sample tests all of them. */
static const size_t MAX_PIECES = 1000;

/* Thickness from which on the faces of a wall hide the liquid behind it [spacings]. */
static const double HIDES = 1;

static bool hides(const sph2d_scene *scene)
{
    return scene->method.name == SPH2D_METHOD_CONSTRAINT ||
           (scene->method.name == SPH2D_METHOD_WCSPH && scene->method.operators == SPH2D_OPERATORS_VARIATIONAL);
}

/** Minimum distance between liquids on the two sides of an obstacle [m]. */
static double required_thickness(const sph2d_scene *scene, const sph2d__wall *wall)
{
    return wall->form == SPH2D_WALL_GENERALISED ? sph2d__layer_thickness(scene)
                                                : scene->method.support_ratio * scene->spacing;
}

static sph2d_vec2 displaced(sph2d_vec2 p, sph2d_vec2 n, double d)
{
    return (sph2d_vec2){p.x + d * n.x, p.y + d * n.y};
}

/** Height of the surface of the liquid within a distance of a position on one side [m]; NaN without liquid. A block
 *  that overlaps the obstacle is taken to continue inside it. */
static double surface_height(const sph2d__world *world, const sph2d_shape *outline, sph2d_vec2 p, sph2d_vec2 side,
                             double limit)
{
    const sph2d_scene *scene = &world->scene;
    const sph2d_vec2 up = world->gravity.up;
    double dx = scene->spacing, d = dx / STEPS_PER_SPACING;
    while (d < limit && !sph2d__in_block(scene, displaced(p, side, d)))
        d += dx / 2;
    if (!(d < limit))
        return NAN;
    sph2d_vec2 at = displaced(p, side, d), above = displaced(at, up, dx / STEPS_PER_SPACING);
    while (sph2d__in_block(scene, above) || sph2d__shape_contains(outline, above)) {
        at = above;
        above = displaced(at, up, dx / STEPS_PER_SPACING);
    }
    return at.x * up.x + at.y * up.y;
}

/** Thickness of an obstacle at a position on its surface [m]; INFINITY if it is `enough` or more. */
static double thickness_at(const sph2d_shape *outline, sph2d_vec2 p, sph2d_vec2 inwards, double step, double enough)
{
    if (sph2d__shape_is_open(outline))
        return 0;
    for (double d = step / 2; d < enough; d += step)
        if (!sph2d__shape_contains(outline, displaced(p, inwards, d)))
            return d - step / 2;
    return INFINITY;
}

/** A position where liquids interact through an obstacle. */
typedef struct thin {
    sph2d_vec2 at;
    double thickness, apart; /**< thickness of the wall, difference in height of the two surfaces [m] */
} thin;

/** Finds the first such position along a segment of the outline. */
static bool find_thin(const sph2d__world *world, const sph2d_shape *outline, sph2d__segment s, double required,
                      thin *found)
{
    const sph2d_scene *scene = &world->scene;
    double dx = scene->spacing, length = hypot(s.b.x - s.a.x, s.b.y - s.a.y);
    double count = fmin(fmax(floor(length / dx), 1), MAX_SAMPLES);
    sph2d_vec2 in = {-(s.b.y - s.a.y) / length, (s.b.x - s.a.x) / length};
    sph2d_vec2 middle = {(s.a.x + s.b.x) / 2, (s.a.y + s.b.y) / 2};
    if (!sph2d__shape_is_open(outline) && !sph2d__shape_contains(outline, displaced(middle, in, 1e-3 * dx)))
        in = (sph2d_vec2){-in.x, -in.y};
    for (double i = 0.5; i < count; ++i) {
        double t = i / count;
        sph2d_vec2 p = {s.a.x + t * (s.b.x - s.a.x), s.a.y + t * (s.b.y - s.a.y)};
        double thickness = thickness_at(outline, p, in, dx / STEPS_PER_SPACING, required * (1 - 1e-9));
        double distance = required * (1 - 1e-9) - thickness;
        if (!(distance > 0) || (hides(scene) && thickness >= HIDES * dx))
            continue;
        double front = surface_height(world, outline, p, (sph2d_vec2){-in.x, -in.y}, distance);
        double back = surface_height(world, outline, displaced(p, in, thickness), in, distance);
        *found = (thin){p, thickness, fabs(front - back)};
        if (found->apart > fmax(thickness, dx)) /* false if one is NaN */
            return true;
    }
    return false;
}

/** Finds the first such position of a wall. Lines with layers have liquid on one side, or have become solids. */
static bool find_in_wall(const sph2d__world *world, const sph2d__wall *wall, thin *found)
{
    const sph2d_scene *scene = &world->scene;
    const sph2d_shape *outline = &wall->shape;
    const bool made = wall->liquid == SPH2D_LIQUID_BOTH && wall->form == SPH2D_WALL_GENERALISED; /* of a line */
    if (wall->body || made || sph2d__wall_has_side(wall) || sph2d__wall_is_hollow(wall))
        return false;
    double required = required_thickness(scene, wall);
    size_t pieces = sph2d__shape_pieces(outline, scene->spacing);
    for (size_t k = 0; k < pieces; k += 1 + pieces / MAX_PIECES)
        if (find_thin(world, outline, sph2d__shape_piece(outline, scene->spacing, k), required, found))
            return true;
    return false;
}

void sph2d__check_thin(sph2d__checker *c)
{
    const sph2d_scene *scene = c->scene;
    size_t count = 0, first = 0;
    thin place = {0}, found;
    for (size_t i = SPH2D__WALL_OBSTACLE; i < c->world->wall_count && c->world->gravity.size > 0; ++i)
        if (find_in_wall(c->world, &c->world->walls[i], &found) && ++count == 1) {
            first = i;
            place = found;
        }
    if (count == 0)
        return;
    const sph2d__wall *wall = &c->world->walls[first];
    char path[SPH2D__PATH_SIZE], more[60] = "";
    if (count > 1)
        snprintf(more, sizeof more, "; the same holds for %zu more", count - 1);
    sph2d_diagnostic *w = sph2d_report_add(
        c->report, SPH2D_WARNING, SPH2D_CODE_CONFLICT, sph2d__check_wall_path(c, path, first, wall->shape_key),
        "liquids whose surfaces are %.2g m apart in height press on each other through it, near (%.3g, %.3g), where it "
        "is %.2g m thick%s",
        place.apart, place.at.x, place.at.y, place.thickness, more);
    double required = hides(scene) ? HIDES * scene->spacing : required_thickness(scene, wall);
    if (place.thickness > 0)
        sph2d_diagnostic_hint(w, "make it %.3g m thick or thicker, or the spacing %.2g m", required,
                              scene->spacing * place.thickness / required);
    else
        sph2d_diagnostic_hint(w, "draw it as a box or a polygon, %.3g m thick or thicker", required);
}
