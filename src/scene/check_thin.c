/* SPDX-License-Identifier: MIT */
/** @file check_thin.c
 *  Obstacles so thin that the liquids on their two sides feel each other through them.
 *
 *  A boundary particle tells each liquid the pressure of all liquid around it, and liquid particles nearer than the
 *  support radius push each other, whatever stands between them. Where both press the same, as around a plate in a
 *  pool, that is right. A tank 40 spacings deep beside one of 20, wcsph with H = 3 dx, has at half the depth of the
 *  shallow one, 10 spacings over the floor, by thickness of the wall in spacings:
 *
 *      thickness                    0.5    1      1.5    2      2.5    3      3.5    4
 *      pressure, deep              -25 %  -28 %  -24 %   +4 %   +3 %   +1 %   +1 %   0
 *      pressure, shallow            -5 %  +37 %  -10 %  -48 %  -14 %   -7 %   -1 %   0
 *      kinetic energy, 4 has 1      120    290    340     28      6      3      2     1
 *
 *  Pressures on a wall of 2 dx between surfaces 2 dx apart are within 1 %, on one of 1 dx 6 % off. */
#include <math.h>
#include <stdio.h>

#include "scene/checker.h"
#include "scene/liquid_side.h"
#include "scene/resolve.h"

/* Places along a piece of wall that are looked at, at most; and steps in a spacing from face to face. */
static const double MOST_ALONG = 2000, FINE = 10;
/* Of more pieces not all are looked at: each place asks all of them where it is. */
static const size_t MOST_PIECES = 1000;

/** How far liquids must be from each other at an obstacle [m]. */
static double wanted_thickness(const sph2d_scene *scene, const sph2d_obstacle *obstacle)
{
    return sph2d__obstacle_form(scene, obstacle) == SPH2D_WALL_GENERALISED
               ? sph2d__layer_thickness(scene)
               : sph2d__method_resolve(scene->method).support_ratio * scene->spacing;
}

static sph2d_vec2 beyond(sph2d_vec2 p, sph2d_vec2 n, double d)
{
    return (sph2d_vec2){p.x + d * n.x, p.y + d * n.y};
}

/** Height of the surface [m] over the liquid that lies within a distance of a place on that side; NaN without liquid.
 *  What is drawn through the obstacle goes on in it. */
static double surface_over(const sph2d_scene *scene, const sph2d_outline *outline, sph2d_vec2 p, sph2d_vec2 side,
                           double most)
{
    double g = hypot(scene->gravity.x, scene->gravity.y), dx = scene->spacing, d = dx / FINE;
    sph2d_vec2 up = {-scene->gravity.x / g, -scene->gravity.y / g};
    while (d < most && !sph2d__in_block(scene, beyond(p, side, d)))
        d += dx / 2;
    if (!(d < most))
        return NAN;
    sph2d_vec2 at = beyond(p, side, d), above = beyond(at, up, dx / FINE);
    while (sph2d__in_block(scene, above) || sph2d__outline_encloses(outline, above)) {
        at = above;
        above = beyond(at, up, dx / FINE);
    }
    return at.x * up.x + at.y * up.y;
}

/** Thickness of an obstacle behind a place on its surface [m], INFINITY where it is `enough` or more. */
static double thickness_at(const sph2d_outline *outline, sph2d_vec2 p, sph2d_vec2 inwards, double step, double enough)
{
    if (sph2d__outline_is_open(outline))
        return 0;
    for (double d = step / 2; d < enough; d += step)
        if (!sph2d__outline_encloses(outline, beyond(p, inwards, d)))
            return d - step / 2;
    return INFINITY;
}

/** A place where liquids feel each other. */
typedef struct thin {
    sph2d_vec2 at;
    double thickness, apart; /**< of the wall, and of the two surfaces [m] */
} thin;

/** The first such place of a piece of the outline whose solid, if it is one, lies that way. */
static bool find_thin(const sph2d_scene *scene, const sph2d_outline *outline, sph2d__segment s, double wanted,
                      thin *found)
{
    double dx = scene->spacing, length = hypot(s.b.x - s.a.x, s.b.y - s.a.y);
    double count = fmin(fmax(floor(length / dx), 1), MOST_ALONG);
    sph2d_vec2 in = {-(s.b.y - s.a.y) / length, (s.b.x - s.a.x) / length};
    sph2d_vec2 middle = {(s.a.x + s.b.x) / 2, (s.a.y + s.b.y) / 2};
    if (!sph2d__outline_is_open(outline) && !sph2d__outline_encloses(outline, beyond(middle, in, 1e-3 * dx)))
        in = (sph2d_vec2){-in.x, -in.y};
    for (double i = 0.5; i < count; ++i) {
        double t = i / count;
        sph2d_vec2 p = {s.a.x + t * (s.b.x - s.a.x), s.a.y + t * (s.b.y - s.a.y)};
        double thickness = thickness_at(outline, p, in, dx / FINE, wanted * (1 - 1e-9));
        double room = wanted * (1 - 1e-9) - thickness;
        if (!(room > 0))
            continue;
        double here = surface_over(scene, outline, p, (sph2d_vec2){-in.x, -in.y}, room);
        double there = surface_over(scene, outline, beyond(p, in, thickness), in, room);
        *found = (thin){p, thickness, fabs(here - there)};
        if (found->apart > fmax(thickness, dx)) /* not so where one is NaN */
            return true;
    }
    return false;
}

/** The first such place of an obstacle. Lines with layers are walls of liquid on one side, or become solids. */
static bool find_in_obstacle(const sph2d_scene *scene, const sph2d_obstacle *obstacle, thin *found)
{
    const sph2d_outline *outline = &obstacle->outline;
    if (sph2d__obstacle_has_side(scene, obstacle))
        return false;
    double wanted = wanted_thickness(scene, obstacle);
    size_t pieces = sph2d__outline_pieces(outline, scene->spacing);
    for (size_t k = 0; k < pieces; k += 1 + pieces / MOST_PIECES)
        if (find_thin(scene, outline, sph2d__outline_piece(outline, scene->spacing, k), wanted, found))
            return true;
    return false;
}

void sph2d__check_thin(sph2d__checker *c)
{
    static const char *const kinds[] = {[SPH2D_OUTLINE_LINE] = ".line",
                                        [SPH2D_OUTLINE_POLYLINE] = ".polyline",
                                        [SPH2D_OUTLINE_CIRCLE] = ".circle",
                                        [SPH2D_OUTLINE_BOX] = ".box",
                                        [SPH2D_OUTLINE_POLYGON] = ".polygon"};
    const sph2d_scene *scene = c->scene;
    size_t count = 0, first = 0;
    thin place = {0}, found;
    for (size_t i = 0; i < scene->obstacle_count && (scene->gravity.x != 0 || scene->gravity.y != 0); ++i)
        if (find_in_obstacle(scene, &scene->obstacles[i], &found) && ++count == 1) {
            first = i;
            place = found;
        }
    if (count == 0)
        return;
    const sph2d_obstacle *obstacle = &scene->obstacles[first];
    char path[SPH2D__PATH_SIZE], more[60] = "";
    if (count > 1)
        snprintf(more, sizeof more, "; and so through %zu more", count - 1);
    sph2d_diagnostic *w = sph2d_report_add(
        c->report, SPH2D_WARNING, SPH2D_CODE_CONFLICT,
        sph2d__check_path(path, "obstacles", first, kinds[obstacle->outline.kind]),
        "liquids whose surfaces are %.2g m apart in height press on each other through it, near (%.3g, %.3g), where it "
        "is %.2g m thick%s",
        place.apart, place.at.x, place.at.y, place.thickness, more);
    double wanted = wanted_thickness(scene, obstacle);
    if (place.thickness > 0)
        sph2d_diagnostic_hint(w, "make it %.3g m thick or thicker, or the spacing %.2g m", wanted,
                              scene->spacing * place.thickness / wanted);
    else
        sph2d_diagnostic_hint(w, "draw it as a box or a polygon, %.3g m thick or thicker", wanted);
}
