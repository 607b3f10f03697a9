/* SPDX-License-Identifier: MIT */
/** @file flood.c */
#include "scene/flood.h"

#include <math.h>

#include "scene/bodies.h"
#include "scene/resolve.h"
#include "scene/shape.h"

/* Maximum number of cells. */
static const double MAX_CELLS = 4e6;

/* The "centre" of a cell, slightly off its centre, so that walls with round coordinates do not pass through it and its
 * side does not depend on rounding. */
static const double CENTRE_X = 0.5 + 0.0014142, CENTRE_Y = 0.5 + 0.0017321;

double sph2d__flood_height(const sph2d__flood *g, sph2d_vec2 p)
{
    return p.x * g->up_x + p.y * g->up_y - g->lowest;
}

/** Heights of the lowest and highest corner of a box. */
sph2d_vec2 sph2d__flood_heights(const sph2d__flood *g, sph2d_box b)
{
    sph2d_vec2 corners[4] = {b.min, {b.max.x, b.min.y}, b.max, {b.min.x, b.max.y}}, h = {INFINITY, -INFINITY};
    for (int k = 0; k < 4; ++k) {
        h.x = fmin(h.x, sph2d__flood_height(g, corners[k]));
        h.y = fmax(h.y, sph2d__flood_height(g, corners[k]));
    }
    return h;
}

static sph2d_box cell_box(const sph2d__flood *g, size_t i, size_t j)
{
    sph2d_vec2 low = {g->origin.x + (double)i * g->size_x, g->origin.y + (double)j * g->size_y};
    return (sph2d_box){low, {low.x + g->size_x, low.y + g->size_y}};
}

/* ---- walls ------------------------------------------------------------------------------------------------------- */

/** Marks the pairs of neighbours whose connection a wall segment crosses: at most one in each row, or column, of
 *  centres. A segment that ends on a row belongs to one side of it, so that segments that meet leave no gap. */
static void mark_crossings(sph2d__flood *g, sph2d__segment s, bool columns)
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

static void mark_walls(sph2d__flood *g)
{
    for (size_t i = 0; i < g->scene->obstacle_count; ++i) {
        const sph2d_shape *outline = &g->scene->obstacles[i].shape;
        size_t pieces =
            !sph2d__obstacle_moves(&g->scene->obstacles[i]) ? sph2d__shape_pieces(outline, g->scene->spacing) : 0;
        for (size_t k = 0; k < pieces; ++k) {
            sph2d__segment s = sph2d__shape_piece(outline, g->scene->spacing, k);
            mark_crossings(g, s, false);
            mark_crossings(g, s, true);
        }
    }
}

/* ---- liquid ------------------------------------------------------------------------------------------------------ */

static void visit(sph2d__flood *g, size_t i, size_t j)
{
    size_t cell = j * g->nx + i;
    if (!g->visited[cell])
        g->queue[g->queued++] = (uint32_t)cell;
    g->visited[cell] = 1;
}

static size_t cell_at(const sph2d__flood *g, sph2d_vec2 p)
{
    double i = floor((p.x - g->origin.x) / g->size_x), j = floor((p.y - g->origin.y) / g->size_y);
    return (size_t)fmin(fmax(j, 0), (double)g->ny - 1) * g->nx + (size_t)fmin(fmax(i, 0), (double)g->nx - 1);
}

void sph2d__flood_position(sph2d__flood *g, sph2d_vec2 p)
{
    size_t cell = cell_at(g, p);
    visit(g, cell % g->nx, cell / g->nx);
}

bool sph2d__flood_reached(const sph2d__flood *g, sph2d_vec2 p)
{
    return g->visited[cell_at(g, p)];
}

void sph2d__flood_shape(sph2d__flood *g, const sph2d_shape *shape)
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
        sph2d__flood_position(g, (sph2d_vec2){(b.min.x + b.max.x) / 2, (b.min.y + b.max.y) / 2});
}

double sph2d__flood_spread(sph2d__flood *g, double level)
{
    double lowest = INFINITY;
    bool round_x = sph2d__period_x(g->scene) > 0, round_y = sph2d__period_y(g->scene) > 0;
    for (size_t n = 0; n < g->queued; ++n) {
        size_t cell = g->queue[n], i = cell % g->nx, j = cell / g->nx;
        double bottom = sph2d__flood_heights(g, cell_box(g, i, j)).x;
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
    return lowest < 1e-6 * g->scene->spacing ? 0 : lowest;
}

void sph2d__flood_clear(sph2d__flood *g)
{
    for (size_t n = 0; n < g->queued; ++n)
        g->visited[g->queue[n]] = 0;
    g->queued = 0;
}

/* ---- the grid ---------------------------------------------------------------------------------------------------- */

double sph2d__flood_cells(const sph2d_scene *scene)
{
    sph2d_box d = scene->domain;
    return fmax(ceil((d.max.x - d.min.x) / scene->spacing - 1e-9), 1) *
           fmax(ceil((d.max.y - d.min.y) / scene->spacing - 1e-9), 1);
}

bool sph2d__flood_make(sph2d__flood *g, const sph2d_scene *scene, sph2d_vec2 up)
{
    sph2d_box d = scene->domain;
    *g = (sph2d__flood){.scene = scene, .up_x = up.x, .up_y = up.y, .origin = d.min};
    g->lowest = sph2d__flood_heights(g, d).x;
    g->memory = sph2d__memory_from((sph2d_allocator){NULL, NULL});
    if (!(sph2d__flood_cells(scene) <= MAX_CELLS))
        return false;
    g->nx = (size_t)fmax(ceil((d.max.x - d.min.x) / scene->spacing - 1e-9), 1);
    g->ny = (size_t)fmax(ceil((d.max.y - d.min.y) / scene->spacing - 1e-9), 1);
    g->size_x = (d.max.x - d.min.x) / (double)g->nx;
    g->size_y = (d.max.y - d.min.y) / (double)g->ny;
    g->closed = sph2d__alloc(&g->memory, g->nx * g->ny, 1);
    g->visited = sph2d__alloc(&g->memory, g->nx * g->ny, 1);
    g->queue = sph2d__alloc(&g->memory, g->nx * g->ny, sizeof *g->queue);
    bool made = g->closed && g->visited && g->queue;
    if (made)
        mark_walls(g);
    else
        sph2d__flood_free(g);
    return made;
}

void sph2d__flood_free(sph2d__flood *g)
{
    void *blocks[3] = {g->closed, g->visited, g->queue};
    const size_t sizes[3] = {1, 1, sizeof *g->queue};
    for (int k = 0; k < 3; ++k)
        sph2d__release(&g->memory, &blocks[k], blocks[k] ? g->nx * g->ny : 0, sizes[k]);
    g->closed = g->visited = NULL;
    g->queue = NULL;
}
