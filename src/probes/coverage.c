/* SPDX-License-Identifier: MIT */
/** @file coverage.c
 *  The grid of coverage.h: kernel sums of particles and walls at its nodes, and the covered area. */
#include "probes/coverage.h"

#include <math.h>

#include "kernels/kernel.h"
#include "scene/liquid.h"

/* Cells a spacing, and the kernel's support radius in spacings and cells. */
enum { CELLS = SPH2D__COVERAGE_CELLS, SUPPORT = SPH2D__COVERAGE_SUPPORT, REACH = SUPPORT * CELLS };
/* Sample points across a cell, for the fraction inside walls. */
enum { POINTS = 4, FULL = POINTS * POINTS };
_Static_assert((int)FULL == (int)SPH2D__COVERAGE_FULL, "sixteenths");
/* Columns across a cell in which its covered part is found. */
enum { COLUMNS = 8 };
static const double MAX_CELLS = 268435456;
/* Where walls leave less of the kernel free than this the fill is set to 0. */
static const double MIN_FREE = 0.1;

/* ---- the grid ---------------------------------------------------------------------------------------------------- */

/** The cells of one direction. */
typedef struct axis {
    double origin, size;
    size_t count, nodes;
} axis;

/** The cells of one direction: over the domain, and beyond it as far as the kernel reaches or liquid is. */
static axis axis_of(double low, double high, double period, double dx, const double *x, size_t count)
{
    double cells = fmax(ceil((high - low) * CELLS / dx - 1e-9), 1), size = (high - low) / cells;
    if (period > 0)
        return (axis){low, size, (size_t)cells, (size_t)cells};
    double lowest = low, highest = high, far = high - low;
    for (size_t i = 0; i < count; ++i) {
        lowest = fmin(lowest, x[i]);
        highest = fmax(highest, x[i]);
    }
    double before = REACH + ceil((low - fmax(lowest, low - far)) / size);
    double behind = REACH + ceil((fmin(highest, high + far) - high) / size);
    size_t all = (size_t)(cells + before + behind);
    return (axis){low - before * size, size, all, all + 1};
}

bool sph2d__coverage_beyond_wall(const sph2d__world *world, sph2d_vec2 p)
{
    const sph2d_boundary b = world->scene.boundary;
    const sph2d_box d = world->box;
    return (b.left == SPH2D_SIDE_WALL && p.x < d.min.x) || (b.right == SPH2D_SIDE_WALL && p.x > d.max.x) ||
           (b.bottom == SPH2D_SIDE_WALL && p.y < d.min.y) || (b.top == SPH2D_SIDE_WALL && p.y > d.max.y);
}

/** Position of a sample point of a cell. */
static sph2d_vec2 sample_point(const sph2d__coverage *c, size_t i, size_t j, int k)
{
    double x = (double)i + (k % POINTS + 0.5) / POINTS, y = (double)j + (k / POINTS + 0.5) / POINTS;
    return (sph2d_vec2){c->origin.x + x * c->size_x, c->origin.y + y * c->size_y};
}

/** A range of cells in one direction. */
typedef struct span {
    size_t begin, end;
} span;

/** The cells that overlap [low, high]. */
static span span_of(double low, double high, double origin, double size, size_t count)
{
    double begin = fmax(floor((low - origin) / size), 0), end = fmin(ceil((high - origin) / size), (double)count);
    return begin < end ? (span){(size_t)begin, (size_t)end} : (span){0, 0};
}

/** Bounds of what an obstacle fills, in its present position. */
static sph2d_box bounds_of(const sph2d_sim *sim, const sph2d__wall *o, const sph2d__pose *pose)
{
    sph2d_box b = sph2d__shape_bounds(&o->shape);
    double margin = sph2d__wall_is_hollow(o) ? sph2d__layer_thickness(&sim->world.scene) : 0;
    sph2d_box all = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (int k = 0; k < 4; ++k) {
        sph2d_vec2 corner = {k & 1 ? b.max.x + margin : b.min.x - margin, k & 2 ? b.max.y + margin : b.min.y - margin};
        sph2d_vec2 p = sph2d__pose_apply(pose, corner);
        all = (sph2d_box){{fmin(all.min.x, p.x), fmin(all.min.y, p.y)}, {fmax(all.max.x, p.x), fmax(all.max.y, p.y)}};
    }
    return all;
}

/** Marks the sample points inside an obstacle. */
static void mark_obstacle(const sph2d__coverage *c, const sph2d__wall *o, uint16_t *marks)
{
    sph2d__pose pose = sph2d__sim_pose_of(c->sim, o);
    sph2d_box b = bounds_of(c->sim, o, &pose);
    span x = span_of(b.min.x, b.max.x, c->origin.x, c->size_x, c->nx);
    span y = span_of(b.min.y, b.max.y, c->origin.y, c->size_y, c->ny);
    for (size_t j = y.begin; j < y.end; ++j)
        for (size_t i = x.begin; i < x.end; ++i)
            for (int k = 0; k < FULL; ++k) {
                sph2d_vec2 p = sph2d__pose_invert(&pose, sample_point(c, i, j, k));
                if (sph2d__wall_fills(&c->sim->world.scene, o, p))
                    marks[j * c->nx + i] |= (uint16_t)(1u << k);
            }
}

/** Counts the sample points of each cell that lie in walls. `marks`: a bit for each, initially 0. */
static void find_solids(sph2d__coverage *c, uint16_t *marks)
{
    const sph2d__world *world = &c->sim->world;
    for (size_t k = SPH2D__WALL_OBSTACLE; k < world->wall_count; ++k)
        mark_obstacle(c, &world->walls[k], marks);
    for (size_t j = 0; j < c->ny; ++j)
        for (size_t i = 0; i < c->nx; ++i) {
            int n = 0;
            for (int k = 0; k < FULL; ++k)
                n += marks[j * c->nx + i] >> k & 1 || sph2d__coverage_beyond_wall(world, sample_point(c, i, j, k));
            c->solid[j * c->nx + i] = (unsigned char)n;
        }
}

/** Counts sample points in reservoirs of openings as solid, too: what they hold is not in the domain. After the fill, which
 *  they take part in. */
static void leave_out_reservoirs(sph2d__coverage *c, const uint16_t *marks)
{
    for (size_t j = 0; j < c->ny && c->sim->openings.count > 0; ++j)
        for (size_t i = 0; i < c->nx; ++i)
            for (int k = 0; k < FULL && c->solid[j * c->nx + i] < FULL; ++k) {
                sph2d_vec2 p = sample_point(c, i, j, k);
                bool solid = marks[j * c->nx + i] >> k & 1 || sph2d__coverage_beyond_wall(&c->sim->world, p);
                if (!solid && sph2d__opening_at(c->sim, p.x, p.y))
                    ++c->solid[j * c->nx + i];
            }
}

size_t sph2d__coverage_node(long k, size_t nodes, size_t cells)
{
    if (nodes == cells) /* periodic */
        return (size_t)((k % (long)cells + (long)cells) % (long)cells);
    return k >= 0 && k < (long)nodes ? (size_t)k : SIZE_MAX;
}

/** Adds `amount` W(r) to the sums `out` of the nodes around a position, which is in cells from the origin. */
static void add_kernel(const sph2d__coverage *c, double x, double y, double amount, float *out)
{
    const double h = SUPPORT * c->sim->system.spacing;
    long i0 = (long)floor(x) - REACH - 1, j0 = (long)floor(y) - REACH - 1;
    for (long j = j0; j <= j0 + 2 * REACH + 3; ++j) {
        size_t row = sph2d__coverage_node(j, c->nodes_y, c->ny);
        double dy = ((double)j - y) * c->size_y / h;
        if (row == SIZE_MAX || !(dy * dy < 1))
            continue;
        for (long i = i0; i <= i0 + 2 * REACH + 3; ++i) {
            size_t column = sph2d__coverage_node(i, c->nodes_x, c->nx);
            double dx = ((double)i - x) * c->size_x / h, q2 = dx * dx + dy * dy;
            if (column != SIZE_MAX && q2 < 1)
                out[row * c->nodes_x + column] +=
                    (float)(amount * sph2d__kernel_value_at(SPH2D_KERNEL_WENDLAND_C2, sqrt(q2)));
        }
    }
}

/** Sums liquid and walls at the nodes, and divides by the part of the kernel that walls leave free. */
static void fill_nodes(sph2d__coverage *c, float *walls)
{
    const sph2d__store *f = &c->sim->system.fluid;
    const double dx = c->sim->system.spacing;
    const double constant = sph2d__kernel_constant(SPH2D_KERNEL_WENDLAND_C2) / (SUPPORT * SUPPORT);
    for (size_t i = 0; i < f->count; ++i)
        add_kernel(c, (f->x[i] - c->origin.x) / c->size_x, (f->y[i] - c->origin.y) / c->size_y, constant, c->fill);
    double share = constant * c->size_x * c->size_y / (dx * dx) / FULL;
    for (size_t j = 0; j < c->ny; ++j)
        for (size_t i = 0; i < c->nx; ++i)
            if (c->solid[j * c->nx + i] > 0)
                add_kernel(c, (double)i + 0.5, (double)j + 0.5, share * c->solid[j * c->nx + i], walls);
    for (size_t k = 0; k < c->nodes_x * c->nodes_y; ++k) {
        double free_part = 1 - (double)walls[k];
        c->fill[k] = (float)(free_part > MIN_FREE ? (double)c->fill[k] / free_part : 0);
    }
}

bool sph2d__coverage_make(sph2d__coverage *c, const sph2d_sim *sim)
{
    const sph2d__store *f = &sim->system.fluid;
    const sph2d__period *p = &sim->system.fluid_cells.period;
    const sph2d_box d = sim->world.box;
    axis x = axis_of(d.min.x, d.max.x, p->length_x, sim->system.spacing, f->x, f->count);
    axis y = axis_of(d.min.y, d.max.y, p->length_y, sim->system.spacing, f->y, f->count);
    *c = (sph2d__coverage){.sim = sim,
                           .origin = {x.origin, y.origin},
                           .size_x = x.size,
                           .size_y = y.size,
                           .nx = x.count,
                           .ny = y.count,
                           .nodes_x = x.nodes,
                           .nodes_y = y.nodes};
    if (!((double)x.nodes * (double)y.nodes < MAX_CELLS))
        return false;
    size_t nodes = x.nodes * y.nodes;
    c->fill = sph2d__alloc(sim->system.memory, nodes, sizeof(float));
    c->solid = sph2d__alloc(sim->system.memory, x.count * y.count, 1);
    void *walls = sph2d__alloc(sim->system.memory, nodes, sizeof(float));
    void *marks = sph2d__alloc(sim->system.memory, x.count * y.count, sizeof(uint16_t));
    bool ok = c->fill && c->solid && walls && marks;
    if (ok) {
        find_solids(c, marks);
        fill_nodes(c, walls);
        leave_out_reservoirs(c, marks);
    }
    sph2d__release(sim->system.memory, &marks, marks ? x.count * y.count : 0, sizeof(uint16_t));
    sph2d__release(sim->system.memory, &walls, walls ? nodes : 0, sizeof(float));
    if (!ok)
        sph2d__coverage_free(c);
    return ok;
}

void sph2d__coverage_free(sph2d__coverage *c)
{
    void *blocks[2] = {c->fill, c->solid};
    sph2d__release(c->sim->system.memory, &blocks[0], c->fill ? c->nodes_x * c->nodes_y : 0, sizeof(float));
    sph2d__release(c->sim->system.memory, &blocks[1], c->solid ? c->nx * c->ny : 0, 1);
    c->fill = NULL;
    c->solid = NULL;
}

/* ---- area -------------------------------------------------------------------------------------------------------- */

/** The fill at a cell's corners: lower left, lower right, upper left, upper right. */
static void corners_of(const sph2d__coverage *c, size_t i, size_t j, double out[4])
{
    size_t right = (i + 1) % c->nodes_x, above = (j + 1) % c->nodes_y;
    out[0] = (double)c->fill[j * c->nodes_x + i];
    out[1] = (double)c->fill[j * c->nodes_x + right];
    out[2] = (double)c->fill[above * c->nodes_x + i];
    out[3] = (double)c->fill[above * c->nodes_x + right];
}

/** Part of a line on which a value that varies linearly from a to b is above a half. */
static double part_above(double a, double b)
{
    a -= 0.5;
    b -= 0.5;
    if (a >= 0 && b >= 0)
        return 1;
    if (a < 0 && b < 0)
        return 0;
    return fmax(a, b) / fabs(a - b);
}

/** Part of a cell that is covered, by linear interpolation between its corners. */
static double covered_part(const double f[4])
{
    double sum = 0;
    for (int k = 0; k < COLUMNS; ++k) {
        double t = (k + 0.5) / COLUMNS;
        sum += part_above(f[0] + t * (f[1] - f[0]), f[2] + t * (f[3] - f[2]));
    }
    return sum / COLUMNS;
}

bool sph2d__coverage_cell(double position, double origin, double size, size_t count, size_t *cell, double *in)
{
    double f = (position - origin) / size;
    if (!(f >= 0 && f < (double)count))
        return false;
    *cell = (size_t)f;
    *in = f - (double)*cell;
    return true;
}

/** Fill at a particle; 0 beyond the grid. */
static double fill_at(const sph2d__coverage *c, double x, double y)
{
    size_t i, j;
    double s, t, f[4];
    if (!sph2d__coverage_cell(x, c->origin.x, c->size_x, c->nx, &i, &s) ||
        !sph2d__coverage_cell(y, c->origin.y, c->size_y, c->ny, &j, &t))
        return 0;
    corners_of(c, i, j, f);
    return (1 - t) * (f[0] + s * (f[1] - f[0])) + t * (f[2] + s * (f[3] - f[2]));
}

double sph2d__placed_area(const sph2d_sim *sim)
{
    const sph2d__store *f = &sim->system.fluid;
    size_t inside = f->count;
    for (size_t i = 0; i < f->count && sim->openings.count > 0; ++i)
        inside -= sph2d__opening_at(sim, f->x[i], f->y[i]) != NULL;
    return sim->system.mass / sim->system.rest_density * (double)inside;
}

double sph2d__coverage_area(const sph2d__coverage *c)
{
    const sph2d__store *fluid = &c->sim->system.fluid;
    double cells = 0, alone = 0;
    for (size_t j = 0; j < c->ny; ++j)
        for (size_t i = 0; i < c->nx; ++i) {
            int solid = c->solid[j * c->nx + i];
            if (solid == FULL)
                continue;
            double f[4];
            corners_of(c, i, j, f);
            cells += covered_part(f) * (FULL - solid) / FULL;
        }
    for (size_t i = 0; i < fluid->count; ++i)
        alone += fill_at(c, fluid->x[i], fluid->y[i]) < 0.5 && !sph2d__opening_at(c->sim, fluid->x[i], fluid->y[i]);
    double dx = c->sim->system.spacing;
    return cells * c->size_x * c->size_y + alone * dx * dx;
}
