/* SPDX-License-Identifier: MIT */
/** @file place_side_layers.c
 *  Generalised walls at sides of the domain: layers of boundary particles outside, on the continued lattice. */
#include <math.h>

#include "kernels/kernel.h"
#include "start/layers.h"
#include "start/start.h"

/** One direction of the domain's lattice: cells 0 to count - 1 inside; low to high - 1 with walls and open space. */
typedef struct extent {
    double origin, size;
    long count, low, high;
    bool wall_low, wall_high;
} extent;

static extent extent_of(double min, double max, double spacing, sph2d_side low, sph2d_side high, int layers)
{
    extent e = {.origin = min, .count = (long)fmax(floor((max - min) / spacing + 0.5), 1)};
    e.size = (max - min) / (double)e.count;
    e.wall_low = low == SPH2D_SIDE_WALL;
    e.wall_high = high == SPH2D_SIDE_WALL;
    e.low = e.wall_low ? -layers : low == SPH2D_SIDE_OPEN ? -e.count : 0;
    e.high = e.count + (e.wall_high ? layers : high == SPH2D_SIDE_OPEN ? e.count : 0);
    return e;
}

/** Whether a cell lies beyond a wall of this direction. */
static bool is_behind(const extent *e, long k)
{
    return (k < 0 && e->wall_low) || (k >= e->count && e->wall_high);
}

/** The next column at or after `i` that may have a boundary particle; rows inside the domain have them only
 *  beyond the two ends. */
static long next_column(const extent *x, bool row_behind, long i)
{
    return !row_behind && i >= 0 && i < x->count ? x->count : i;
}

/** Sets normal and depth of a boundary particle of a side; in corners there is no single surface. */
static void set_surface(sph2d__boundary_particle *p, const extent *x, long i, const extent *y, long j)
{
    bool beside_x = is_behind(x, i), beside_y = is_behind(y, j);
    if (beside_x && !beside_y) {
        p->normal.x = i < 0 ? 1 : -1;
        p->depth = (i < 0 ? -(double)i - 0.5 : (double)(i - x->count) + 0.5) * x->size;
        p->skin = p->depth < x->size ? y->size : 0;
    }
    if (beside_y && !beside_x) {
        p->normal.y = j < 0 ? 1 : -1;
        p->depth = (j < 0 ? -(double)j - 0.5 : (double)(j - y->count) + 0.5) * y->size;
        p->skin = p->depth < y->size ? x->size : 0;
    }
}

/** Kernel sum, of f(q) times the area of a cell over H^2, over the lattice of liquid that fills all space in front of
 *  the walls. */
static double filled_sum(const sph2d_sim *sim, const extent *x, const extent *y, sph2d_vec2 p)
{
    double h = sim->system.support, sum = 0;
    long i1 = (long)floor((p.x + h - x->origin) / x->size), j1 = (long)floor((p.y + h - y->origin) / y->size);
    for (long j = (long)floor((p.y - h - y->origin) / y->size); j <= j1; ++j)
        for (long i = (long)floor((p.x - h - x->origin) / x->size); i <= i1; ++i) {
            double dx = x->origin + ((double)i + 0.5) * x->size - p.x;
            double dy = y->origin + ((double)j + 0.5) * y->size - p.y;
            if (!is_behind(x, i) && !is_behind(y, j))
                sum += sph2d__kernel_value_at(sim->system.method.kernel, hypot(dx, dy) / h);
        }
    return sum * x->size * y->size / (h * h);
}

/** Sets the velocity of the last boundary particle to that of its side; corners are at rest. */
static void set_speed(sph2d_sim *sim, const extent *x, long i, const extent *y, long j)
{
    const sph2d_side_speeds *speeds = &sim->world.scene.wall_speeds;
    sph2d__store *w = &sim->system.walls;
    bool beside_x = is_behind(x, i), beside_y = is_behind(y, j);
    if (beside_x && !beside_y)
        w->vy[w->count - 1] = i < 0 ? speeds->left : speeds->right;
    if (beside_y && !beside_x)
        w->vx[w->count - 1] = j < 0 ? speeds->bottom : speeds->top;
}

/** Adds the boundary particle of cell (i, j) of the lattice that continues the domain's beyond its sides. */
static sph2d_status place_cell(sph2d_sim *sim, const extent *x, long i, const extent *y, long j, sph2d_report *report)
{
    sph2d_vec2 p = {x->origin + ((double)i + 0.5) * x->size, y->origin + ((double)j + 0.5) * y->size};
    sph2d__boundary_particle particle = {p, x->size * y->size, {0, 0}, INFINITY, 0};
    set_surface(&particle, x, i, y, j);
    sph2d_status status = sph2d__layers_add(sim, &particle, report);
    if (status != SPH2D_OK)
        return status;
    set_speed(sim, x, i, y, j);
    if (sim->system.walls.filled)
        sim->system.walls.filled[sim->system.walls.count - 1] = filled_sum(sim, x, y, p);
    return SPH2D_OK;
}

/** Fills the cells behind the sides, but for those too near to obstacles. */
static sph2d_status place_cells(sph2d_sim *sim, const extent *x, const extent *y, sph2d_report *report)
{
    sph2d__near earlier;
    sph2d_status status = sph2d__layers_find_earlier(sim, &earlier) ? SPH2D_OK : SPH2D_NOMEM;
    for (long j = y->low; status == SPH2D_OK && j < y->high; ++j) {
        bool behind = is_behind(y, j);
        for (long i = next_column(x, behind, x->low); status == SPH2D_OK && i < x->high;
             i = next_column(x, behind, i + 1)) {
            sph2d_vec2 p = {x->origin + ((double)i + 0.5) * x->size, y->origin + ((double)j + 0.5) * y->size};
            if ((behind || is_behind(x, i)) && !sph2d__near_any(&earlier, p))
                status = place_cell(sim, x, i, y, j, report);
        }
    }
    sph2d__near_free(&earlier, &sim->memory);
    return status;
}

sph2d_status sph2d__sim_place_side_layers(sph2d_sim *sim, sph2d_report *report)
{
    sph2d_box d = sim->world.box;
    sph2d_boundary b = sim->world.scene.boundary;
    double dx = sim->world.scene.spacing;
    if (b.left != SPH2D_SIDE_WALL && b.right != SPH2D_SIDE_WALL && b.bottom != SPH2D_SIDE_WALL &&
        b.top != SPH2D_SIDE_WALL)
        return SPH2D_OK;
    int layers = sph2d__layer_count(sim);
    double longest = fmax(d.max.x - d.min.x, d.max.y - d.min.y) / dx;
    if (sph2d__sim_too_many(sim, longest * layers, "spacing", report))
        return SPH2D_SCENE;
    extent x = extent_of(d.min.x, d.max.x, dx, b.left, b.right, layers);
    extent y = extent_of(d.min.y, d.max.y, dx, b.bottom, b.top, layers);
    return place_cells(sim, &x, &y, report);
}
