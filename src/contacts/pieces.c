/* SPDX-License-Identifier: MIT */
/** @file pieces.c
 *  Outlines as shapes of Chipmunk, where they are now and grown by the margin: circles, convex polygons, segments.
 *
 *  Concave obstacles are segments like all walls that are lines, and not cut into pieces: what slides along them would
 *  stumble over the corners of pieces, which segments that know their neighbours do not have. */
#include <chipmunk/chipmunk.h>
#include <math.h>

#include "contacts/contacts.h"
#include "contacts/convex.h"

/* Corners that turn by less are none. */
#define STRAIGHT 1e-12

static cpVect vector(sph2d_vec2 v)
{
    return cpv(v.x, v.y);
}

static bool is_open(const sph2d__placed *placed)
{
    const sph2d_shape_kind kind = placed->shape->kind;
    return kind == SPH2D_SHAPE_LINE || kind == SPH2D_SHAPE_POLYLINE || kind == SPH2D_SHAPE_ARC;
}

/** Whether a corner is, but for rounding, on the line between its neighbours. */
static bool is_straight(sph2d_vec2 a, sph2d_vec2 b, sph2d_vec2 c)
{
    double square =
        (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y) + (c.x - b.x) * (c.x - b.x) + (c.y - b.y) * (c.y - b.y);
    return fabs(sph2d__turn(a, b, c)) <= STRAIGHT * square;
}

/** The corners of a closed outline where it is now, anticlockwise and without those on a line; NULL when memory is
 *  short. */
static sph2d_vec2 *corners_of(sph2d__contacts *c, const sph2d__placed *placed, int *count)
{
    size_t all = placed->corner_count;
    sph2d_vec2 *corners = sph2d__arena_alloc(&c->arena, &c->memory, all, sizeof *corners);
    if (!corners)
        return NULL;
    int n = 0;
    double area = 0;
    for (size_t i = 0; i < all; ++i) {
        sph2d_vec2 p = placed->corners[i];
        while (n > 1 && is_straight(corners[n - 2], corners[n - 1], p))
            --n;
        corners[n++] = p;
    }
    while (n > 3 && is_straight(corners[n - 2], corners[n - 1], corners[0]))
        --n;
    for (int i = 1; i + 1 < n; ++i)
        area += sph2d__turn(corners[0], corners[i], corners[i + 1]);
    for (int i = 0; area < 0 && i < n / 2; ++i) {
        sph2d_vec2 p = corners[i];
        corners[i] = corners[n - 1 - i];
        corners[n - 1 - i] = p;
    }
    *count = n;
    return corners;
}

static bool is_convex(const sph2d_vec2 *corners, int count)
{
    for (int i = 0; i < count; ++i) {
        sph2d_vec2 a = corners[i], b = corners[(i + 1) % count], c = corners[(i + 2) % count];
        if (sph2d__turn(a, b, c) < 0 && !is_straight(a, b, c))
            return false;
    }
    return true;
}

static void keep(sph2d__placed *placed, cpShape *shape)
{
    cpShapeUpdate(shape, cpTransformIdentity);
    placed->pieces[placed->piece_count++] = shape;
}

static sph2d_status cut_concave(sph2d__contacts *c, sph2d__placed *placed, const sph2d_vec2 *corners, int count)
{
    size_t n = (size_t)count;
    sph2d__piece *parts = sph2d__arena_alloc(&c->arena, &c->memory, n, sizeof *parts);
    int *indices = sph2d__arena_alloc(&c->arena, &c->memory, n * n, sizeof *indices);
    cpVect *part = sph2d__arena_alloc(&c->arena, &c->memory, n, sizeof *part);
    placed->pieces = sph2d__arena_alloc(&c->arena, &c->memory, n, sizeof *placed->pieces);
    if (!parts || !indices || !part || !placed->pieces)
        return SPH2D_NOMEM;
    for (size_t i = 0; i + 2 < n; ++i)
        parts[i].corners = indices + n * (i + 1);
    int found = sph2d__convex_pieces(corners, count, indices, parts);
    for (int i = 0; i < found; ++i) {
        for (int k = 0; k < parts[i].count; ++k)
            part[k] = vector(corners[parts[i].corners[k]]);
        keep(placed, cpPolyShapeNewRaw(c->ground, parts[i].count, part, c->margin));
    }
    return SPH2D_OK;
}

/** Keeps a convex polygon as a whole. */
static sph2d_status keep_polygon(sph2d__contacts *c, sph2d__placed *placed, const sph2d_vec2 *corners, int count)
{
    cpVect *all = sph2d__arena_alloc(&c->arena, &c->memory, (size_t)count, sizeof *all);
    placed->pieces = sph2d__arena_alloc(&c->arena, &c->memory, 1, sizeof *placed->pieces);
    if (!all || !placed->pieces)
        return SPH2D_NOMEM;
    for (int i = 0; i < count; ++i)
        all[i] = vector(corners[i]);
    keep(placed, cpPolyShapeNewRaw(c->ground, count, all, c->margin));
    return SPH2D_OK;
}

static sph2d_status keep_circle(sph2d__contacts *c, sph2d__placed *placed)
{
    placed->pieces = sph2d__arena_alloc(&c->arena, &c->memory, 1, sizeof *placed->pieces);
    if (!placed->pieces)
        return SPH2D_NOMEM;
    double radius = placed->shape->circle.radius + c->margin;
    keep(placed, cpCircleShapeNew(c->ground, radius, vector(placed->center)));
    return SPH2D_OK;
}

sph2d_status sph2d__cut(sph2d__contacts *c, sph2d__placed *placed)
{
    if (placed->cut)
        return SPH2D_OK;
    if (!c->ground)
        c->ground = cpBodyNewStatic();
    placed->cut = true;
    if (placed->shape->kind == SPH2D_SHAPE_CIRCLE)
        return keep_circle(c, placed);
    if (placed->hollow || is_open(placed))
        return SPH2D_OK;
    int count = 0;
    sph2d_vec2 *corners = corners_of(c, placed, &count);
    if (!corners)
        return SPH2D_NOMEM;
    if (is_convex(corners, count))
        return keep_polygon(c, placed, corners, count);
    bool solid = placed->number != c->body_count && count <= SPH2D__MOST_CUT_CORNERS;
    return solid ? cut_concave(c, placed, corners, count) : SPH2D_OK;
}

size_t sph2d__edge_count(const sph2d__placed *placed)
{
    size_t corners = placed->corner_count;
    return is_open(placed) && corners > 0 ? corners - 1 : corners;
}

cpShape *sph2d__edge(const sph2d__contacts *c, const sph2d__placed *placed, size_t index, const sph2d_box *box)
{
    size_t count = placed->corner_count;
    cpVect a = vector(placed->corners[index]), b = vector(placed->corners[(index + 1) % count]);
    double m = c->margin;
    if (cpfmin(a.x, b.x) - m > box->max.x || cpfmax(a.x, b.x) + m < box->min.x || cpfmin(a.y, b.y) - m > box->max.y ||
        cpfmax(a.y, b.y) + m < box->min.y)
        return NULL;
    bool first = is_open(placed) && index == 0, last = is_open(placed) && index + 2 == count;
    cpShape *shape = cpSegmentShapeNew(c->ground, a, b, m);
    cpSegmentShapeSetNeighbors(shape, first ? a : vector(placed->corners[(index + count - 1) % count]),
                               last ? b : vector(placed->corners[(index + 2) % count]));
    cpShapeUpdate(shape, cpTransformIdentity);
    return shape;
}

void sph2d__free_pieces(sph2d__contacts *c)
{
    for (size_t i = 0; i < c->placed_count; ++i)
        for (size_t k = 0; k < c->placed[i].piece_count; ++k)
            cpShapeFree(c->placed[i].pieces[k]);
    if (c->ground)
        cpBodyFree(c->ground);
}
