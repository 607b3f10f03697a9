/* SPDX-License-Identifier: MIT */
/** @file solid.c
 *  Solids in a pose, as the grid of method `hybrid` sees them. */
#include "methods/hybrid/solid.h"

#include <math.h>

#include "scene/liquid.h"
#include "scene/shape.h"

/* Part of a spacing within which an outline lies along a side. */
static const double ALONG = 1e-6;

sph2d__solid sph2d__solid_of(const sph2d__world *world, const sph2d__wall *is, const sph2d__pose *pose)
{
    const sph2d_scene *scene = &world->scene;
    const bool layered = sph2d__shape_is_open(&is->shape) || sph2d__wall_is_hollow(is);
    const sph2d_box b = sph2d__shape_bounds(&is->shape), *d = &world->box;
    const sph2d_vec2 ends[4] = {b.min, {b.max.x, b.min.y}, b.max, {b.min.x, b.max.y}};
    const double more = layered ? sph2d__layer_thickness(scene) : 0, in = ALONG * scene->spacing;
    sph2d_vec2 low = {INFINITY, INFINITY}, high = {-INFINITY, -INFINITY};
    for (int k = 0; k < 4; ++k) {
        const sph2d_vec2 p = sph2d__pose_apply(pose, ends[k]);
        low = (sph2d_vec2){fmin(low.x, p.x - more), fmin(low.y, p.y - more)};
        high = (sph2d_vec2){fmax(high.x, p.x + more), fmax(high.y, p.y + more)};
    }
    const bool over_x = low.x < d->min.x + in && high.x > d->max.x - in,
               over_y = low.y < d->min.y + in && high.y > d->max.y - in;
    bool wall[4]; /* or the seam of a period, on both sides of which the solid goes on */
    for (int side = 0; side < 4; ++side) {
        const sph2d_side side_is = sph2d__side_of(scene, side);
        wall[side] = side_is == SPH2D_SIDE_WALL || (side_is == SPH2D_SIDE_PERIODIC && (side < 2 ? over_x : over_y));
    }
    const sph2d_box inside = {{wall[0] ? d->min.x + in : -INFINITY, wall[2] ? d->min.y + in : -INFINITY},
                              {wall[1] ? d->max.x - in : INFINITY, wall[3] ? d->max.y - in : INFINITY}};
    const bool reaches =
        !layered && (low.x < inside.min.x || high.x > inside.max.x || low.y < inside.min.y || high.y > inside.max.y);
    return (sph2d__solid){scene, is, pose, {low, high}, inside, reaches};
}

static double coordinate(sph2d_vec2 p, int axis)
{
    return axis == 0 ? p.x : p.y;
}

/** Leaves of a segment what is within a box; false: nothing. */
static bool clip(sph2d__segment *s, const sph2d_box *box)
{
    double from = 0, to = 1;
    for (int axis = 0; axis < 2; ++axis) {
        const double a = coordinate(s->a, axis), way = coordinate(s->b, axis) - a;
        const double low = coordinate(box->min, axis) - a, high = coordinate(box->max, axis) - a;
        if (way == 0) {
            if (low > 0 || high < 0)
                return false;
            continue;
        }
        from = fmax(from, fmin(low / way, high / way));
        to = fmin(to, fmax(low / way, high / way));
    }
    if (!(from <= to))
        return false;
    const sph2d__segment whole = *s;
    const double x = whole.b.x - whole.a.x, y = whole.b.y - whole.a.y;
    *s = (sph2d__segment){{whole.a.x + from * x, whole.a.y + from * y}, {whole.a.x + to * x, whole.a.y + to * y}};
    return true;
}

/** Distance of a point from a solid's outline; `drawn`: the point, where the scene draws the solid [m]. */
static double outline_distance(const sph2d__solid *s, sph2d_vec2 at, sph2d_vec2 drawn)
{
    const sph2d_shape *outline = &s->wall->shape;
    const double spacing = s->scene->spacing;
    if (!s->reaches)
        return sph2d__shape_nearest(outline, spacing, drawn);
    double nearest = INFINITY;
    for (size_t k = 0, n = sph2d__shape_pieces(outline, spacing); k < n; ++k) {
        sph2d__segment piece = sph2d__shape_piece(outline, spacing, k);
        piece.a = sph2d__pose_apply(s->pose, piece.a);
        piece.b = sph2d__pose_apply(s->pose, piece.b);
        if (clip(&piece, &s->inside))
            nearest = fmin(nearest, sph2d__segment_distance(&piece, at));
    }
    return nearest;
}

double sph2d__solid_distance(const sph2d__solid *s, sph2d_vec2 point)
{
    const sph2d_scene *scene = s->scene;
    const sph2d__wall *o = s->wall;
    const sph2d_shape *outline = &o->shape;
    const sph2d_vec2 at = {fmin(fmax(point.x, s->inside.min.x), s->inside.max.x),
                           fmin(fmax(point.y, s->inside.min.y), s->inside.max.y)};
    const sph2d_vec2 p = sph2d__pose_invert(s->pose, at);
    const double d = outline_distance(s, at, p), thick = sph2d__layer_thickness(scene);
    if (!sph2d__shape_is_open(outline)) {
        if (sph2d__wall_fills(scene, o, p))
            return -d;
        const bool beyond = sph2d__wall_is_hollow(o) && !sph2d__shape_contains(outline, p);
        return beyond ? d - thick : d;
    }
    /* A line is wet on one side, with layers on the other: the side is that of its nearest piece. */
    double nearest = INFINITY, side = 0;
    for (size_t k = 0, n = sph2d__shape_pieces(outline, scene->spacing); k < n; ++k) {
        const sph2d__segment piece = sph2d__shape_piece(outline, scene->spacing, k);
        const double r = sph2d__segment_distance(&piece, p);
        if (r < nearest) {
            nearest = r;
            side = sph2d__segment_side(&piece, p);
        }
    }
    const bool wet = o->liquid == SPH2D_LIQUID_RIGHT ? side < 0 : side > 0;
    return wet ? d : d < thick ? -d : d - thick;
}
