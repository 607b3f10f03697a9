/* SPDX-License-Identifier: MIT */
/** @file basin.c
 *  The height from which the liquid of a scene can fall, as far as it gets (flood.h) within the height that its energy
 *  allows. */
#include "scene/derive.h"

#include <math.h>

#include "scene/flood.h"
#include "scene/openings.h"
#include "scene/shape.h"

/* Maximum number of cells times liquids. */
static const double MAX_VISITS = 4e7;

/** Lowest height that liquid reaches without rising above a level; takes it away. */
static double lowest_below(sph2d__flood *g, double level)
{
    double lowest = sph2d__flood_spread(g, level);
    sph2d__flood_clear(g);
    return lowest;
}

/** Heights of the lowest and highest point of a block; cells do not resolve the tips of corners. */
static sph2d_vec2 extremes_of(const sph2d__flood *g, const sph2d_shape *shape)
{
    sph2d_vec2 h = {INFINITY, -INFINITY};
    if (shape->kind == SPH2D_SHAPE_CIRCLE) {
        double centre = sph2d__flood_height(g, shape->circle.center);
        return (sph2d_vec2){centre - shape->circle.radius, centre + shape->circle.radius};
    }
    const double spacing = g->scene->spacing;
    for (size_t k = 0, n = sph2d__shape_pieces(shape, spacing); k < n; ++k) {
        const double height = sph2d__flood_height(g, sph2d__shape_piece(shape, spacing, k).a);
        h = (sph2d_vec2){fmin(h.x, height), fmax(h.y, height)};
    }
    return h;
}

/** How far liquid that comes in at a position can fall. */
static double fall_from(sph2d__flood *g, sph2d_vec2 p, double extra_head, bool walled)
{
    double height = sph2d__flood_height(g, p);
    if (!walled)
        return height;
    sph2d__flood_position(g, p);
    return height - lowest_below(g, height + extra_head);
}

/** The same from the higher end of an opening, or its surface, a quarter of a spacing before it. */
static double fall_from_opening(sph2d__flood *g, const sph2d_opening *opening, double extra_head, bool walled)
{
    sph2d__mouth m = sph2d__opening_mouth(g->scene, opening);
    double inside = g->scene->spacing / 4, low = fmin(inside, m.width / 4), fall = 0;
    if (sph2d__opening_has_surface(opening) && m.along.y > 0) { /* from the surface, which may be above the opening */
        sph2d_vec2 p = {m.start.x + inside * m.inward.x, m.start.y + low};
        return fall_from(g, p, extra_head, walled) + sph2d__opening_highest(g->scene, opening) - low;
    }
    for (int end = 0; end < 2; ++end) {
        double t = end == 0 ? low : m.width - low;
        sph2d_vec2 p = {m.start.x + t * m.along.x + inside * m.inward.x,
                        m.start.y + t * m.along.y + inside * m.inward.y};
        fall = fmax(fall, fall_from(g, p, extra_head, walled));
    }
    return fall;
}

/** Largest height of a liquid above the lowest point it reaches, or above the lowest corner if not `walled`. */
static double highest_fall(sph2d__flood *g, double extra_head, bool walled)
{
    const sph2d_scene *scene = g->scene;
    double fall = 0, top = -INFINITY;
    for (size_t i = 0; i < scene->block_count; ++i) {
        const sph2d_shape *shape = &scene->blocks[i].shape;
        sph2d_vec2 heights = extremes_of(g, shape);
        double low = 0;
        if (walled) {
            sph2d__flood_shape(g, shape);
            low = fmin(lowest_below(g, heights.y + extra_head), fmax(heights.x, 0));
        }
        fall = fmax(fall, heights.y - low);
    }
    for (size_t i = 0; i < scene->source_count; ++i)
        fall = fmax(fall, fall_from(g, scene->sources[i].at, extra_head, walled));
    for (size_t i = 0; i < scene->opening_count; ++i)
        fall = fmax(fall, fall_from_opening(g, &scene->openings[i], extra_head, walled));
    for (size_t i = 0; !scene->particles.file && i < scene->particles.count; ++i) {
        sph2d_vec2 p = {scene->particles.items[i].x, scene->particles.items[i].y};
        top = fmax(top, sph2d__flood_height(g, p));
        if (walled)
            sph2d__flood_position(g, p);
    }
    return top > 0 ? fmax(fall, top - (walled ? lowest_below(g, top + extra_head) : 0)) : fall;
}

double sph2d__basin_height(const sph2d__world *world, double extra_head)
{
    const sph2d_scene *scene = &world->scene;
    const sph2d_vec2 up = world->gravity.up;
    size_t fixed = 0;
    for (size_t k = SPH2D__WALL_OBSTACLE; k < world->wall_count; ++k)
        fixed += !sph2d__wall_moves(&world->walls[k]);
    double liquids = (double)scene->block_count + (double)scene->source_count + 2 * (double)scene->opening_count + 1;
    sph2d__flood g = {.world = world, .scene = scene, .up_x = up.x, .up_y = up.y};
    g.lowest = sph2d__flood_heights(&g, scene->domain).x;
    bool walled = fixed > 0 && sph2d__flood_cells(scene) * liquids <= MAX_VISITS && sph2d__flood_make(&g, world, up);
    double fall = highest_fall(&g, extra_head, walled);
    if (walled)
        sph2d__flood_free(&g);
    return fall;
}
