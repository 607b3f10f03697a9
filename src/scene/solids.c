/* SPDX-License-Identifier: MIT */
/** @file solids.c
 *  A grid of obstacles, so that liquid is placed around a thousand of them as fast as around ten. */
#include "scene/solids.h"

#include <math.h>

#include "scene/shape.h"

/* What counts as near an obstacle [spacings]: more than all clearances of the liquid, and the thickness of layers. */
static const double NEAR = 6;

/* Boxes along each side of the domain. */
static const double MOST_BOXES = 64;

/** Smallest rectangle around what is near an outline. */
static sph2d_box bounds_of(const sph2d_shape *outline, double spacing)
{
    sph2d_box b = sph2d__shape_bounds(outline);
    double d = NEAR * spacing;
    return (sph2d_box){{b.min.x - d, b.min.y - d}, {b.max.x + d, b.max.y + d}};
}

static size_t index_of(double x, double low, double high, size_t count)
{
    double k = floor((x - low) / (high - low) * (double)count);
    return k > 0 ? (size_t)fmin(k, (double)count - 1) : 0;
}

static size_t column_of(const sph2d__solids *s, double x)
{
    return index_of(x, s->box.min.x, s->box.max.x, s->nx);
}

static size_t row_of(const sph2d__solids *s, double y)
{
    return index_of(y, s->box.min.y, s->box.max.y, s->ny);
}

/** Counts the obstacles of each box in first[box + 1], or, with a list, enters them from first[box] on. */
static void visit(sph2d__solids *s, const sph2d__world *world, bool enter)
{
    for (size_t i = SPH2D__WALL_OBSTACLE; i < world->wall_count; ++i) {
        sph2d_box b = bounds_of(&world->walls[i].shape, world->scene.spacing);
        size_t right = column_of(s, b.max.x), top = row_of(s, b.max.y);
        for (size_t row = row_of(s, b.min.y); row <= top; ++row)
            for (size_t column = column_of(s, b.min.x); column <= right; ++column) {
                size_t box = row * s->nx + column;
                if (enter)
                    s->wall[s->first[box]++] = i;
                else
                    ++s->first[box + 1];
            }
    }
}

bool sph2d__solids_build(sph2d__solids *solids, const sph2d__world *world, sph2d__arena *arena, sph2d__memory *memory)
{
    *solids = (sph2d__solids){.box = world->box};
    const size_t count = world->wall_count - SPH2D__WALL_OBSTACLE;
    if (count == 0)
        return true;
    solids->nx = solids->ny = (size_t)fmin(ceil(2 * sqrt((double)count)), MOST_BOXES);
    size_t boxes = solids->nx * solids->ny;
    solids->first = sph2d__arena_alloc(arena, memory, boxes + 1, sizeof *solids->first);
    if (!solids->first)
        return false;
    visit(solids, world, false);
    for (size_t box = 0; box < boxes; ++box)
        solids->first[box + 1] += solids->first[box];
    solids->wall = sph2d__arena_alloc(arena, memory, solids->first[boxes] + 1, sizeof *solids->wall);
    if (!solids->wall)
        return false;
    visit(solids, world, true);
    for (size_t box = boxes; box > 0; --box) /* entering moved each to where the next begins */
        solids->first[box] = solids->first[box - 1];
    solids->first[0] = 0;
    return true;
}

sph2d__solid_list sph2d__solids_near(const sph2d__solids *s, sph2d_vec2 p)
{
    if (s->nx == 0)
        return (sph2d__solid_list){0};
    size_t box = row_of(s, p.y) * s->nx + column_of(s, p.x);
    return (sph2d__solid_list){s->wall + s->first[box], s->first[box + 1] - s->first[box]};
}
