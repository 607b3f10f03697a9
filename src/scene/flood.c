/* SPDX-License-Identifier: MIT */
/** @file flood.c */
#include "scene/flood.h"

#include <math.h>

#include "scene/resolve.h"
#include "scene/shape.h"

/* Maximum number of cells. */
static const double MAX_CELLS = 4e6;

/* The "centre" of a cell, slightly off its centre, so that walls with round coordinates do not pass through it and its
 * side does not depend on rounding. */
static const double CENTRE_X = 0.5 + 0.0014142, CENTRE_Y = 0.5 + 0.0017321;

double sph2d__flood_height(const sph2d__flood *flood, sph2d_vec2 p)
{
    return p.x * flood->up_x + p.y * flood->up_y - flood->lowest;
}

/** Heights of the lowest and highest corner of a box. */
sph2d_vec2 sph2d__flood_heights(const sph2d__flood *flood, sph2d_box b)
{
    sph2d_vec2 corners[4] = {b.min, {b.max.x, b.min.y}, b.max, {b.min.x, b.max.y}}, h = {INFINITY, -INFINITY};
    for (int k = 0; k < 4; ++k) {
        h.x = fmin(h.x, sph2d__flood_height(flood, corners[k]));
        h.y = fmax(h.y, sph2d__flood_height(flood, corners[k]));
    }
    return h;
}

static sph2d_box cell_box(const sph2d__flood *flood, size_t i, size_t j)
{
    sph2d_vec2 low = {flood->origin.x + (double)i * flood->size_x, flood->origin.y + (double)j * flood->size_y};
    return (sph2d_box){low, {low.x + flood->size_x, low.y + flood->size_y}};
}

/* ---- walls ------------------------------------------------------------------------------------------------------- */

/** Marks the pairs of neighbours whose connection a wall segment crosses: at most one in each row, or column, of
 *  centres. A segment that ends on a row belongs to one side of it, so that segments that meet leave no gap. */
static void mark_crossings(sph2d__flood *flood, sph2d__segment s, bool columns)
{
    double a = columns ? s.a.x : s.a.y, b = columns ? s.b.x : s.b.y, c = columns ? s.a.y : s.a.x;
    double d = columns ? s.b.y : s.b.x;
    double from = columns ? flood->origin.x : flood->origin.y, size = columns ? flood->size_x : flood->size_y;
    double across = columns ? flood->origin.y : flood->origin.x, step = columns ? flood->size_y : flood->size_x;
    double in_row = columns ? CENTRE_X : CENTRE_Y, in_gap = columns ? CENTRE_Y : CENTRE_X;
    size_t rows = columns ? flood->nx : flood->ny, gaps = columns ? flood->ny : flood->nx;
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
        flood->closed[columns ? k * flood->nx + r : r * flood->nx + k] |= columns ? 2 : 1;
    }
}

static void mark_walls(sph2d__flood *flood)
{
    for (size_t i = SPH2D__WALL_OBSTACLE; i < flood->world->wall_count; ++i) {
        const sph2d__wall *wall = &flood->world->walls[i];
        const sph2d_shape *outline = &wall->shape;
        size_t pieces = !sph2d__wall_moves(wall) ? sph2d__shape_pieces(outline, flood->scene->spacing) : 0;
        for (size_t k = 0; k < pieces; ++k) {
            sph2d__segment s = sph2d__shape_piece(outline, flood->scene->spacing, k);
            mark_crossings(flood, s, false);
            mark_crossings(flood, s, true);
        }
    }
}

/* ---- liquid ------------------------------------------------------------------------------------------------------ */

static void visit(sph2d__flood *flood, size_t i, size_t j)
{
    size_t cell = j * flood->nx + i;
    if (!flood->visited[cell])
        flood->queue[flood->queued++] = (uint32_t)cell;
    flood->visited[cell] = 1;
}

static size_t cell_at(const sph2d__flood *flood, sph2d_vec2 p)
{
    double i = floor((p.x - flood->origin.x) / flood->size_x), j = floor((p.y - flood->origin.y) / flood->size_y);
    return (size_t)fmin(fmax(j, 0), (double)flood->ny - 1) * flood->nx +
           (size_t)fmin(fmax(i, 0), (double)flood->nx - 1);
}

void sph2d__flood_position(sph2d__flood *flood, sph2d_vec2 p)
{
    size_t cell = cell_at(flood, p);
    visit(flood, cell % flood->nx, cell / flood->nx);
}

bool sph2d__flood_reached(const sph2d__flood *flood, sph2d_vec2 p)
{
    return flood->visited[cell_at(flood, p)];
}

void sph2d__flood_shape(sph2d__flood *flood, const sph2d_shape *shape)
{
    sph2d_box b = sph2d__shape_bounds(shape);
    double i0 = fmax(floor((b.min.x - flood->origin.x) / flood->size_x), 0);
    double j0 = fmax(floor((b.min.y - flood->origin.y) / flood->size_y), 0);
    double i1 = fmin(ceil((b.max.x - flood->origin.x) / flood->size_x), (double)flood->nx);
    double j1 = fmin(ceil((b.max.y - flood->origin.y) / flood->size_y), (double)flood->ny);
    for (double j = j0; j < j1; ++j)
        for (double i = i0; i < i1; ++i) {
            sph2d_vec2 centre = {flood->origin.x + (i + CENTRE_X) * flood->size_x,
                                 flood->origin.y + (j + CENTRE_Y) * flood->size_y};
            if (sph2d__shape_contains(shape, centre))
                visit(flood, (size_t)i, (size_t)j);
        }
    if (flood->queued == 0)
        sph2d__flood_position(flood, (sph2d_vec2){(b.min.x + b.max.x) / 2, (b.min.y + b.max.y) / 2});
}

double sph2d__flood_spread(sph2d__flood *flood, double level)
{
    double lowest = INFINITY;
    bool round_x = sph2d__period_x(flood->scene) > 0, round_y = sph2d__period_y(flood->scene) > 0;
    for (size_t n = 0; n < flood->queued; ++n) {
        size_t cell = flood->queue[n], i = cell % flood->nx, j = cell / flood->nx;
        double bottom = sph2d__flood_heights(flood, cell_box(flood, i, j)).x;
        lowest = fmin(lowest, bottom);
        if (bottom > level)
            continue;
        size_t left = i > 0 ? i - 1 : flood->nx - 1, right = i + 1 < flood->nx ? i + 1 : 0;
        size_t below = j > 0 ? j - 1 : flood->ny - 1, above = j + 1 < flood->ny ? j + 1 : 0;
        if ((i > 0 || round_x) && !(flood->closed[j * flood->nx + left] & 1))
            visit(flood, left, j);
        if ((right > 0 || round_x) && !(flood->closed[cell] & 1))
            visit(flood, right, j);
        if ((j > 0 || round_y) && !(flood->closed[below * flood->nx + i] & 2))
            visit(flood, i, below);
        if ((above > 0 || round_y) && !(flood->closed[cell] & 2))
            visit(flood, i, above);
    }
    return lowest < 1e-6 * flood->scene->spacing ? 0 : lowest;
}

void sph2d__flood_clear(sph2d__flood *flood)
{
    for (size_t n = 0; n < flood->queued; ++n)
        flood->visited[flood->queue[n]] = 0;
    flood->queued = 0;
}

/* ---- the grid ---------------------------------------------------------------------------------------------------- */

double sph2d__flood_cells(const sph2d_scene *scene)
{
    sph2d_box d = scene->domain;
    return fmax(ceil((d.max.x - d.min.x) / scene->spacing - 1e-9), 1) *
           fmax(ceil((d.max.y - d.min.y) / scene->spacing - 1e-9), 1);
}

bool sph2d__flood_make(sph2d__flood *flood, const sph2d__world *world, sph2d_vec2 up)
{
    const sph2d_scene *scene = &world->scene;
    sph2d_box d = scene->domain;
    *flood = (sph2d__flood){.world = world, .scene = scene, .up_x = up.x, .up_y = up.y, .origin = d.min};
    flood->lowest = sph2d__flood_heights(flood, d).x;
    flood->memory = sph2d__memory_from((sph2d_allocator){NULL, NULL});
    if (!(sph2d__flood_cells(scene) <= MAX_CELLS))
        return false;
    flood->nx = (size_t)fmax(ceil((d.max.x - d.min.x) / scene->spacing - 1e-9), 1);
    flood->ny = (size_t)fmax(ceil((d.max.y - d.min.y) / scene->spacing - 1e-9), 1);
    flood->size_x = (d.max.x - d.min.x) / (double)flood->nx;
    flood->size_y = (d.max.y - d.min.y) / (double)flood->ny;
    flood->closed = sph2d__alloc(&flood->memory, flood->nx * flood->ny, 1);
    flood->visited = sph2d__alloc(&flood->memory, flood->nx * flood->ny, 1);
    flood->queue = sph2d__alloc(&flood->memory, flood->nx * flood->ny, sizeof *flood->queue);
    bool made = flood->closed && flood->visited && flood->queue;
    if (made)
        mark_walls(flood);
    else
        sph2d__flood_free(flood);
    return made;
}

void sph2d__flood_free(sph2d__flood *flood)
{
    void *blocks[3] = {flood->closed, flood->visited, flood->queue};
    const size_t sizes[3] = {1, 1, sizeof *flood->queue};
    for (int k = 0; k < 3; ++k)
        sph2d__release(&flood->memory, &blocks[k], blocks[k] ? flood->nx * flood->ny : 0, sizes[k]);
    flood->closed = flood->visited = NULL;
    flood->queue = NULL;
}
