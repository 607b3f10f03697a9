/* SPDX-License-Identifier: MIT */
/** @file overlap.c */
#include "scene/overlap.h"

#include <math.h>

#include "scene/liquid_side.h"
#include "scene/shape.h"

/** An outline as its pieces, where its obstacle is at a time. */
static sph2d__segment piece_at(const sph2d_outline *outline, const sph2d__pose *pose, double spacing, size_t k)
{
    sph2d__segment s = sph2d__outline_piece(outline, spacing, k);
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
static bool lies_deep(const sph2d_obstacle *obstacle, double spacing, sph2d_vec2 p, double depth)
{
    const sph2d_outline *outline = &obstacle->outline;
    if (sph2d__obstacle_is_hollow(obstacle) || !sph2d__outline_encloses(outline, p))
        return false;
    size_t pieces = sph2d__outline_pieces(outline, spacing);
    for (size_t k = 0; k < pieces; ++k) {
        sph2d__segment s = sph2d__outline_piece(outline, spacing, k);
        if (sph2d__segment_distance(&s, p) <= depth)
            return false;
    }
    return true;
}

bool sph2d__obstacles_overlap(const sph2d_obstacle *obstacle, const sph2d__pose *pose, const sph2d_obstacle *other,
                              double spacing, double depth)
{
    size_t own = sph2d__outline_pieces(&obstacle->outline, spacing);
    size_t pieces = sph2d__outline_pieces(&other->outline, spacing);
    for (size_t k = 0; k < own; ++k) {
        sph2d__segment s = piece_at(&obstacle->outline, pose, spacing, k);
        if (lies_deep(other, spacing, s.a, depth))
            return true;
        for (size_t n = 0; n < pieces; ++n) {
            sph2d__segment t = sph2d__outline_piece(&other->outline, spacing, n);
            if (cross_deeply(&s, &t, depth) || lies_deep(obstacle, spacing, sph2d__pose_invert(pose, t.a), depth))
                return true;
        }
    }
    return false;
}

double sph2d__beyond_sides(const sph2d_scene *scene, const sph2d_outline *outline, const sph2d__pose *pose,
                           double spacing, const char **side)
{
    const sph2d_box d = scene->domain;
    const sph2d_boundary b = scene->boundary;
    size_t pieces = sph2d__outline_pieces(outline, spacing);
    double deepest = 0;
    for (size_t k = 0; k < pieces; ++k) {
        sph2d__segment s = piece_at(outline, pose, spacing, k);
        const struct {
            const char *name;
            sph2d_side kind;
            double depth;
        } sides[4] = {{"left", b.left, d.min.x - fmin(s.a.x, s.b.x)},
                      {"right", b.right, fmax(s.a.x, s.b.x) - d.max.x},
                      {"bottom", b.bottom, d.min.y - fmin(s.a.y, s.b.y)},
                      {"top", b.top, fmax(s.a.y, s.b.y) - d.max.y}};
        for (int n = 0; n < 4; ++n)
            if (sides[n].kind != SPH2D_SIDE_OPEN && sides[n].depth > deepest) {
                deepest = sides[n].depth;
                *side = sides[n].name;
            }
    }
    return deepest;
}
