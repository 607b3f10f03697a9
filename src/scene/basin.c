/* SPDX-License-Identifier: MIT */
/** @file basin.c
 *  The height from which the liquid of a scene can fall: a flood fill over the cells of a grid, between neighbours
 *  whose centres no wall separates, up to the height that the liquid's energy allows. */
#include "scene/basin.h"

#include <math.h>
#include <stdint.h>

#include "base/memory.h"
#include "scene/bodies.h"
#include "scene/motion.h"
#include "scene/openings.h"
#include "scene/outline.h"
#include "scene/resolve.h"
#include "scene/shape.h"

/* Maximum number of cells, and of cells times liquids, for the flood fill. */
static const double MAX_CELLS = 4e6, MAX_VISITS = 4e7;

/* The "centre" of a cell, slightly off its centre, so that walls with round coordinates do not pass through it and its
 * side does not depend on rounding. */
static const double CENTRE_X = 0.5 + 0.0014142, CENTRE_Y = 0.5 + 0.0017321;

/** A grid over the domain. `closed`: bits of each cell for a wall to its neighbour in +x (1) or +y (2). */
typedef struct grid {
    const sph2d_scene *scene;
    double ux, uy, lowest; /**< unit vector upwards; height of the domain's lowest corner along it */
    sph2d_vec2 origin;
    double size_x, size_y;
    size_t nx, ny;
    unsigned char *closed;
    unsigned char *visited;
    uint32_t *queue;
    size_t queued;
} grid;

static double height_of(const grid *g, sph2d_vec2 p)
{
    return p.x * g->ux + p.y * g->uy - g->lowest;
}

/** Heights of the lowest and highest corner of a box. */
static sph2d_vec2 heights_of(const grid *g, sph2d_box b)
{
    sph2d_vec2 corners[4] = {b.min, {b.max.x, b.min.y}, b.max, {b.min.x, b.max.y}}, h = {INFINITY, -INFINITY};
    for (int k = 0; k < 4; ++k) {
        h.x = fmin(h.x, height_of(g, corners[k]));
        h.y = fmax(h.y, height_of(g, corners[k]));
    }
    return h;
}

static sph2d_box cell_box(const grid *g, size_t i, size_t j)
{
    sph2d_vec2 low = {g->origin.x + (double)i * g->size_x, g->origin.y + (double)j * g->size_y};
    return (sph2d_box){low, {low.x + g->size_x, low.y + g->size_y}};
}

/* ---- walls ------------------------------------------------------------------------------------------------------- */

/** Marks the pairs of neighbours whose connection a wall segment crosses: at most one in each row, or column, of
 *  centres. A segment that ends on a row belongs to one side of it, so that segments that meet leave no gap. */
static void mark_crossings(grid *g, sph2d__segment s, bool columns)
{
    double a = columns ? s.a.x : s.a.y, b = columns ? s.b.x : s.b.y, c = columns ? s.a.y : s.a.x;
    double d = columns ? s.b.y : s.b.x;
    double from = columns ? g->origin.x : g->origin.y, size = columns ? g->size_x : g->size_y;
    double across = columns ? g->origin.y : g->origin.x, step = columns ? g->size_y : g->size_x;
    double in_row = columns ? CENTRE_X : CENTRE_Y, in_gap = columns ? CENTRE_Y : CENTRE_X;
    size_t rows = columns ? g->nx : g->ny, gaps = columns ? g->ny : g->nx;
    double first = fmax(floor((fmin(a, b) - from) / size - in_row), 0);
    double last = fmin(ceil((fmax(a, b) - from) / size - in_row), (double)rows - 1);
    for (double row = first; row <= last; ++row) {
        double centre = from + (row + in_row) * size;
        if ((a > centre) == (b > centre))
            continue;
        double gap = floor((c + (d - c) * (centre - a) / (b - a) - across) / step - in_gap);
        if (gap < -1 || gap >= (double)gaps)
            continue;
        /* before the first: across the period */
        size_t k = (size_t)(gap < 0 ? (double)gaps - 1 : gap), r = (size_t)row;
        g->closed[columns ? k * g->nx + r : r * g->nx + k] |= columns ? 2 : 1;
    }
}

static void mark_walls(grid *g)
{
    for (size_t i = 0; i < g->scene->obstacle_count; ++i) {
        const sph2d_outline *outline = &g->scene->obstacles[i].outline;
        size_t pieces =
            !sph2d__obstacle_moves(&g->scene->obstacles[i]) ? sph2d__outline_pieces(outline, g->scene->spacing) : 0;
        for (size_t k = 0; k < pieces; ++k) {
            sph2d__segment s = sph2d__outline_piece(outline, g->scene->spacing, k);
            mark_crossings(g, s, false);
            mark_crossings(g, s, true);
        }
    }
}

/* ---- liquid ------------------------------------------------------------------------------------------------------ */

static void visit(grid *g, size_t i, size_t j)
{
    size_t cell = j * g->nx + i;
    if (!g->visited[cell])
        g->queue[g->queued++] = (uint32_t)cell;
    g->visited[cell] = 1;
}

static void visit_position(grid *g, sph2d_vec2 p)
{
    double i = floor((p.x - g->origin.x) / g->size_x), j = floor((p.y - g->origin.y) / g->size_y);
    visit(g, (size_t)fmin(fmax(i, 0), (double)g->nx - 1), (size_t)fmin(fmax(j, 0), (double)g->ny - 1));
}

/** Visits the cells whose centres are in a block. */
static void visit_block(grid *g, const sph2d_shape *shape)
{
    sph2d_box b = sph2d__shape_bounds(shape);
    double i0 = fmax(floor((b.min.x - g->origin.x) / g->size_x), 0);
    double j0 = fmax(floor((b.min.y - g->origin.y) / g->size_y), 0);
    double i1 = fmin(ceil((b.max.x - g->origin.x) / g->size_x), (double)g->nx);
    double j1 = fmin(ceil((b.max.y - g->origin.y) / g->size_y), (double)g->ny);
    for (double j = j0; j < j1; ++j)
        for (double i = i0; i < i1; ++i) {
            sph2d_vec2 centre = {g->origin.x + (i + CENTRE_X) * g->size_x, g->origin.y + (j + CENTRE_Y) * g->size_y};
            if (sph2d__shape_contains(shape, centre))
                visit(g, (size_t)i, (size_t)j);
        }
    if (g->queued == 0)
        visit_position(g, (sph2d_vec2){(b.min.x + b.max.x) / 2, (b.min.y + b.max.y) / 2});
}

/** Lowest height that liquid reaches from the cells in the queue without rising above a level. */
static double spread(grid *g, double level)
{
    double lowest = INFINITY;
    bool round_x = sph2d__period_x(g->scene) > 0, round_y = sph2d__period_y(g->scene) > 0;
    for (size_t n = 0; n < g->queued; ++n) {
        size_t cell = g->queue[n], i = cell % g->nx, j = cell / g->nx;
        double bottom = heights_of(g, cell_box(g, i, j)).x;
        lowest = fmin(lowest, bottom);
        if (bottom > level)
            continue;
        size_t left = i > 0 ? i - 1 : g->nx - 1, right = i + 1 < g->nx ? i + 1 : 0;
        size_t below = j > 0 ? j - 1 : g->ny - 1, above = j + 1 < g->ny ? j + 1 : 0;
        if ((i > 0 || round_x) && !(g->closed[j * g->nx + left] & 1))
            visit(g, left, j);
        if ((right > 0 || round_x) && !(g->closed[cell] & 1))
            visit(g, right, j);
        if ((j > 0 || round_y) && !(g->closed[below * g->nx + i] & 2))
            visit(g, i, below);
        if ((above > 0 || round_y) && !(g->closed[cell] & 2))
            visit(g, i, above);
    }
    for (size_t n = 0; n < g->queued; ++n)
        g->visited[g->queue[n]] = 0;
    g->queued = 0;
    return lowest < 1e-6 * g->scene->spacing ? 0 : lowest;
}

/** Heights of the lowest and highest point of a block; cells do not resolve the tips of corners. */
static sph2d_vec2 extremes_of(const grid *g, const sph2d_shape *shape)
{
    sph2d_vec2 h = {INFINITY, -INFINITY};
    if (shape->kind == SPH2D_SHAPE_DISC) {
        double centre = height_of(g, shape->disc.center);
        return (sph2d_vec2){centre - shape->disc.radius, centre + shape->disc.radius};
    }
    if (shape->kind == SPH2D_SHAPE_BOX)
        return heights_of(g, shape->box);
    for (size_t k = 0; k < shape->polygon.count; ++k) {
        h.x = fmin(h.x, height_of(g, shape->polygon.items[k]));
        h.y = fmax(h.y, height_of(g, shape->polygon.items[k]));
    }
    return h;
}

/** How far liquid that comes in at a position can fall. */
static double fall_from(grid *g, sph2d_vec2 p, double extra_head, bool walled)
{
    double height = height_of(g, p);
    if (!walled)
        return height;
    visit_position(g, p);
    return height - spread(g, height + extra_head);
}

/** The same from the higher end of an opening, or its surface, a quarter of a spacing before it. */
static double fall_from_opening(grid *g, const sph2d_opening *opening, double extra_head, bool walled)
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
static double highest_fall(grid *g, double extra_head, bool walled)
{
    const sph2d_scene *scene = g->scene;
    double fall = 0, top = -INFINITY;
    for (size_t i = 0; i < scene->block_count; ++i) {
        const sph2d_shape *shape = &scene->blocks[i].shape;
        sph2d_vec2 heights = extremes_of(g, shape);
        double low = 0;
        if (walled) {
            visit_block(g, shape);
            low = fmin(spread(g, heights.y + extra_head), fmax(heights.x, 0));
        }
        fall = fmax(fall, heights.y - low);
    }
    for (size_t i = 0; i < scene->source_count; ++i)
        fall = fmax(fall, fall_from(g, scene->sources[i].at, extra_head, walled));
    for (size_t i = 0; i < scene->opening_count; ++i)
        fall = fmax(fall, fall_from_opening(g, &scene->openings[i], extra_head, walled));
    for (size_t i = 0; scene->particles.items && i < scene->particles.count; ++i) {
        sph2d_vec2 p = {scene->particles.items[i].x, scene->particles.items[i].y};
        top = fmax(top, height_of(g, p));
        if (walled)
            visit_position(g, p);
    }
    return top > 0 ? fmax(fall, top - (walled ? spread(g, top + extra_head) : 0)) : fall;
}

double sph2d__basin_height(const sph2d_scene *scene, double extra_head)
{
    double strength = hypot(scene->gravity.x, scene->gravity.y);
    sph2d_box d = scene->domain;
    grid g = {.scene = scene, .ux = -scene->gravity.x / strength, .uy = -scene->gravity.y / strength, .origin = d.min};
    g.lowest = heights_of(&g, d).x;
    size_t fixed = 0;
    for (size_t i = 0; i < scene->obstacle_count; ++i)
        fixed += !sph2d__obstacle_moves(&scene->obstacles[i]);
    double nx = fmax(ceil((d.max.x - d.min.x) / scene->spacing - 1e-9), 1);
    double ny = fmax(ceil((d.max.y - d.min.y) / scene->spacing - 1e-9), 1);
    double liquids = (double)scene->block_count + (double)scene->source_count + 2 * (double)scene->opening_count + 1;
    bool walled = fixed > 0 && nx * ny <= MAX_CELLS && nx * ny * liquids <= MAX_VISITS;
    size_t cells = walled ? (size_t)(nx * ny) : 0;
    g.nx = walled ? (size_t)nx : 0;
    g.ny = walled ? (size_t)ny : 0;
    g.size_x = (d.max.x - d.min.x) / nx;
    g.size_y = (d.max.y - d.min.y) / ny;
    sph2d__memory memory = sph2d__memory_from((sph2d_allocator){NULL, NULL});
    void *blocks[3] = {sph2d__alloc(&memory, cells, 1), sph2d__alloc(&memory, cells, 1),
                       sph2d__alloc(&memory, cells, sizeof(uint32_t))};
    g.closed = blocks[0];
    g.visited = blocks[1];
    g.queue = blocks[2];
    walled = walled && g.closed && g.visited && g.queue;
    if (walled)
        mark_walls(&g);
    double fall = highest_fall(&g, extra_head, walled);
    sph2d__release(&memory, &blocks[0], cells, 1);
    sph2d__release(&memory, &blocks[1], cells, 1);
    sph2d__release(&memory, &blocks[2], cells, sizeof(uint32_t));
    return fall;
}
