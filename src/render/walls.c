/* SPDX-License-Identifier: MIT */
/** @file walls.c
 *  Outlines become polygons: solids are filled, a wall with the liquid on its left is a band on the right of its line,
 *  and a line without thickness is a band around it. */
#include "render/walls.h"

#include <math.h>

#include "base/random.h"
#include "sph2d/field.h"

/* Thinner bands would be hard to see. */
static const double thinnest = 2.0; /* [px] */

/* The longest mitre of a corner, over the thickness of the band. */
static const double longest_mitre = 4.0;

sph2d_status sph2d__walls_create(const sph2d__gl *gl, sph2d__walls *walls, GLsizei width, GLsizei height,
                                 sph2d_report *report)
{
    *walls = (sph2d__walls){0};
    return sph2d__mask_create(gl, &walls->mask, width, height, report);
}

/* ---- bands ------------------------------------------------------------------------------------------------------- */

/* A chain of corners, in pixels. */
typedef struct chain {
    const sph2d__view *view;
    const double *x, *y;
    size_t count; /* of different corners */
    bool closed;
} chain;

static sph2d_vec2 corner(const chain *c, size_t k)
{
    return sph2d__view_at(c->view, c->x[k % c->count], c->y[k % c->count]);
}

/* The unit vector to the right of the line between two points; 0 if they are one. Pixels count downwards. */
static sph2d_vec2 right_of(sph2d_vec2 a, sph2d_vec2 b)
{
    const double x = b.x - a.x, y = b.y - a.y, length = hypot(x, y);
    return length > 0.0 ? (sph2d_vec2){-y / length, x / length} : (sph2d_vec2){0, 0};
}

/* Corner k of the line at a distance to the right, mitred. */
static sph2d_vec2 beside(const chain *c, size_t k, double distance)
{
    const bool first = k == 0 && !c->closed, last = k + 1 == c->count && !c->closed;
    const sph2d_vec2 at = corner(c, k);
    const sph2d_vec2 before = first ? at : corner(c, k + c->count - 1), after = last ? at : corner(c, k + 1);
    const sph2d_vec2 in = right_of(before, at), out = right_of(at, after);
    const double x = in.x + out.x, y = in.y + out.y, square = x * x + y * y; /* 4 cos^2 of half the bend */
    if (!(square > 0.0))
        return at;
    const bool end = first || last;
    const double mitre = end ? 1.0 : fmin(2.0 / square, longest_mitre / sqrt(square));
    return (sph2d_vec2){at.x + distance * mitre * x, at.y + distance * mitre * y};
}

static void add_edge(sph2d__cover *cover, sph2d_vec2 a, sph2d_vec2 b)
{
    sph2d__cover_edge(cover, (double[]){a.x, a.y}, (double[]){b.x, b.y});
}

/* Fills the band between the lines at two distances to the right. */
static void fill_band(sph2d__cover *cover, const chain *c, double near, double far)
{
    const size_t pieces = c->closed ? c->count : c->count - 1;
    for (size_t k = 0; k < pieces; ++k) {
        const size_t next = (k + 1) % c->count;
        add_edge(cover, beside(c, k, near), beside(c, next, near));
        add_edge(cover, beside(c, next, far), beside(c, k, far));
    }
    if (!c->closed) {
        add_edge(cover, beside(c, pieces, near), beside(c, pieces, far));
        add_edge(cover, beside(c, 0, far), beside(c, 0, near));
    }
    sph2d__cover_fill(cover);
}

static void fill_solid(sph2d__cover *cover, const chain *c)
{
    for (size_t k = 0; k < c->count; ++k)
        add_edge(cover, corner(c, k), corner(c, k + 1));
    sph2d__cover_fill(cover);
}

/* Pixels from the image's corner that are still exact. */
static const double farthest = 1e7;

static bool is_drawable(const chain *c)
{
    for (size_t k = 0; k < c->count; ++k) {
        const sph2d_vec2 at = corner(c, k);
        if (!(fabs(at.x) < farthest && fabs(at.y) < farthest)) /* nor NaN */
            return false;
    }
    return true;
}

/* Fills one outline of a picture, its corners `from` to `to` - 1. */
static void fill_outline(sph2d__cover *cover, const sph2d__view *view, const sph2d_picture *p, double thickness,
                         size_t from, size_t to)
{
    chain c = {.view = view, .x = p->outline_x + from, .y = p->outline_y + from, .count = to - from};
    if (!is_drawable(&c))
        return;
    if (p->outline_liquid[from] == SPH2D_OUTLINE_LIQUID_OUTSIDE) {
        fill_solid(cover, &c);
        return;
    }
    c.closed = c.count > 2 && c.x[0] == c.x[c.count - 1] && c.y[0] == c.y[c.count - 1];
    c.count -= c.closed;
    if (c.count < 2)
        return;
    const bool both = p->outline_liquid[from] == SPH2D_OUTLINE_LIQUID_BOTH;
    const double wide = fmax((both ? p->wall_thickness : thickness) * view->scale, thinnest);
    fill_band(cover, &c, both ? -wide / 2 : 0.0, both ? wide / 2 : wide);
}

void sph2d__walls_cover(sph2d__cover *cover, const sph2d__view *view, const sph2d_picture *picture, double thickness)
{
    for (size_t from = 0, to; from < picture->outline_count; from = to) {
        for (to = from + 1; to < picture->outline_count && picture->outline_id[to] == picture->outline_id[from]; ++to)
            continue;
        fill_outline(cover, view, picture, thickness, from, to);
    }
}

/* ---- drawing ----------------------------------------------------------------------------------------------------- */

/* A mark of what is drawn: walls at rest are the same in every frame. */
static uint64_t mark_of(const sph2d__view *view, const sph2d_picture *p)
{
    const size_t count = p->outline_count;
    const double numbers[6] = {view->middle.x, view->middle.y, view->center.x,
                               view->center.y, view->scale,    p->wall_thickness};
    uint64_t mark = sph2d__hash(SPH2D__HASH_START, numbers, sizeof numbers);
    mark = sph2d__hash(mark, p->outline_x, count * sizeof *p->outline_x);
    mark = sph2d__hash(mark, p->outline_y, count * sizeof *p->outline_y);
    mark = sph2d__hash(mark, p->outline_id, count * sizeof *p->outline_id);
    return sph2d__hash(mark, p->outline_liquid, count * sizeof *p->outline_liquid);
}

void sph2d__walls_find(const sph2d__gl *gl, sph2d__walls *walls, const sph2d__view *view, const sph2d_picture *picture)
{
    const uint64_t mark = mark_of(view, picture);
    if (mark == walls->mark)
        return;
    sph2d__cover_clear(&walls->mask.cover, (int)view->width, (int)view->height);
    sph2d__walls_cover(&walls->mask.cover, view, picture, picture->wall_thickness);
    sph2d__mask_upload(gl, &walls->mask);
    walls->mark = mark;
}

void sph2d__walls_draw(const sph2d__gl *gl, const sph2d__walls *walls, GLuint program, const sph2d__target *target,
                       const sph2d_picture *picture)
{
    static const float color[4] = {0.36F, 0.345F, 0.34F, 1.0F};
    if (picture->outline_count > 0)
        sph2d__mask_draw(gl, &walls->mask, program, target, color);
}

void sph2d__walls_destroy(const sph2d__gl *gl, sph2d__walls *walls)
{
    sph2d__mask_destroy(gl, &walls->mask);
    *walls = (sph2d__walls){0};
}
