/* SPDX-License-Identifier: MIT */
/** @file overlap.c */
#include "scene/overlap.h"

#include <math.h>

#include "scene/liquid.h"
#include "scene/shape.h"

/** An outline as its pieces, where its wall is at a time. */
static sph2d__segment piece_at(const sph2d_shape *outline, const sph2d__pose *pose, double spacing, size_t k)
{
    sph2d__segment s = sph2d__shape_piece(outline, spacing, k);
    return (sph2d__segment){sph2d__pose_apply(pose, s.a), sph2d__pose_apply(pose, s.b)};
}

/** Whether two segments cross, each by more than a depth on both sides of the other. */
static bool cross_deeply(const sph2d__segment *s, const sph2d__segment *t, double depth)
{
    if (fmax(s->a.x, s->b.x) < fmin(t->a.x, t->b.x) || fmax(t->a.x, t->b.x) < fmin(s->a.x, s->b.x) ||
        fmax(s->a.y, s->b.y) < fmin(t->a.y, t->b.y) || fmax(t->a.y, t->b.y) < fmin(s->a.y, s->b.y))
        return false;
    double length_s = hypot(s->b.x - s->a.x, s->b.y - s->a.y), length_t = hypot(t->b.x - t->a.x, t->b.y - t->a.y);
    double ta = sph2d__segment_side(s, t->a) / length_s, tb = sph2d__segment_side(s, t->b) / length_s;
    double sa = sph2d__segment_side(t, s->a) / length_t, sb = sph2d__segment_side(t, s->b) / length_t;
    return fmin(ta, tb) < -depth && fmax(ta, tb) > depth && fmin(sa, sb) < -depth && fmax(sa, sb) > depth;
}

/** Whether a point lies in a solid, deeper than a depth. */
static bool lies_deep(const sph2d__wall *wall, double spacing, sph2d_vec2 p, double depth)
{
    const sph2d_shape *outline = &wall->shape;
    if (sph2d__wall_is_hollow(wall) || !sph2d__shape_contains(outline, p))
        return false;
    size_t pieces = sph2d__shape_pieces(outline, spacing);
    for (size_t k = 0; k < pieces; ++k) {
        sph2d__segment s = sph2d__shape_piece(outline, spacing, k);
        if (sph2d__segment_distance(&s, p) <= depth)
            return false;
    }
    return true;
}

bool sph2d__walls_overlap(const sph2d__wall *wall, const sph2d__pose *pose, const sph2d__wall *other, double spacing,
                          double depth)
{
    size_t own = sph2d__shape_pieces(&wall->shape, spacing);
    size_t pieces = sph2d__shape_pieces(&other->shape, spacing);
    for (size_t k = 0; k < own; ++k) {
        sph2d__segment s = piece_at(&wall->shape, pose, spacing, k);
        if (lies_deep(other, spacing, s.a, depth))
            return true;
        for (size_t n = 0; n < pieces; ++n) {
            sph2d__segment t = sph2d__shape_piece(&other->shape, spacing, n);
            if (cross_deeply(&s, &t, depth) || lies_deep(wall, spacing, sph2d__pose_invert(pose, t.a), depth))
                return true;
        }
    }
    return false;
}

/* ---- sides of the domain ----------------------------------------------------------------------------------------- */

/** How far a segment is within a side [m]. */
static double segment_within(const sph2d_scene *scene, int side, const sph2d__segment *s)
{
    return fmin(sph2d__side_distance(&scene->domain, side, s->a), sph2d__side_distance(&scene->domain, side, s->b));
}

double sph2d__beyond_sides(const sph2d_scene *scene, const sph2d_shape *outline, const sph2d__pose *pose,
                           double spacing, const char **side)
{
    size_t pieces = sph2d__shape_pieces(outline, spacing);
    double deepest = 0;
    for (size_t k = 0; k < pieces; ++k) {
        sph2d__segment s = piece_at(outline, pose, spacing, k);
        for (int n = 0; n < SPH2D__WALL_OBSTACLE; ++n) {
            double beyond = -segment_within(scene, n, &s);
            if (sph2d__side_of(scene, n) != SPH2D_SIDE_OPEN && beyond > deepest) {
                deepest = beyond;
                *side = sph2d__side_word(n);
            }
        }
    }
    return deepest;
}

/* ---- gaps -------------------------------------------------------------------------------------------------------- */

/** An outline as segments that are thick by a radius, where its wall is at a time: a solid circle is one point. */
static size_t thick_pieces(const sph2d_shape *outline, bool solid, double spacing)
{
    return solid && outline->kind == SPH2D_SHAPE_CIRCLE ? 1 : sph2d__shape_pieces(outline, spacing);
}

static sph2d__segment thick_piece(const sph2d_shape *outline, bool solid, const sph2d__pose *pose, double spacing,
                                  size_t k, double *radius)
{
    *radius = 0;
    if (!solid || outline->kind != SPH2D_SHAPE_CIRCLE)
        return piece_at(outline, pose, spacing, k);
    sph2d_vec2 center = sph2d__pose_apply(pose, outline->circle.center);
    *radius = outline->circle.radius;
    return (sph2d__segment){center, center};
}

double sph2d__side_gap(const sph2d_scene *scene, const sph2d_shape *outline, const sph2d__pose *pose, double spacing,
                       int side)
{
    if (sph2d__side_of(scene, side) != SPH2D_SIDE_WALL)
        return INFINITY;
    size_t pieces = thick_pieces(outline, true, spacing);
    double least = INFINITY, radius;
    for (size_t k = 0; k < pieces; ++k) {
        sph2d__segment s = thick_piece(outline, true, pose, spacing, k, &radius);
        least = fmin(least, segment_within(scene, side, &s) - radius);
    }
    return least;
}

double sph2d__walls_gap(const sph2d__wall *wall, const sph2d__pose *pose, const sph2d__wall *other, double spacing)
{
    const sph2d_shape *own = &wall->shape, *its = &other->shape;
    bool solid = !sph2d__wall_is_hollow(wall), firm = !sph2d__wall_is_hollow(other);
    sph2d__pose rest = {.cosine = 1};
    size_t count = thick_pieces(own, solid, spacing), others = thick_pieces(its, firm, spacing);
    double least = INFINITY, r, q;
    for (size_t k = 0; k < count; ++k) {
        sph2d__segment s = thick_piece(own, solid, pose, spacing, k, &r);
        for (size_t n = 0; n < others; ++n) {
            sph2d__segment t = thick_piece(its, firm, &rest, spacing, n, &q);
            double a = fmin(sph2d__segment_distance(&t, s.a), sph2d__segment_distance(&t, s.b));
            double b = fmin(sph2d__segment_distance(&s, t.a), sph2d__segment_distance(&s, t.b));
            least = fmin(least, fmin(a, b) - r - q);
        }
    }
    return least;
}
