/* SPDX-License-Identifier: MIT */
/** @file coverage.c
 *  The grid of coverage.h: particles and walls are spread over its nodes, and areas read off it. */
#include "sim/coverage.h"

#include <math.h>

#include "kernels/kernel.h"

/* Cells a spacing, and the kernel's support radius in spacings and cells. */
enum { CELLS = 2, SUPPORT = 3, REACH = SUPPORT * CELLS };
/* Points across a cell in which obstacles are looked at; sixteenths. */
enum { LOOKS = 4, WHOLE = LOOKS * LOOKS };
/* Columns across a cell in which its covered part is found. */
enum { COLUMNS = 8 };
static const double MOST_CELLS = 268435456;
/* Where walls leave less of the kernel than this nothing is said. */
static const double LEAST_ROOM = 0.1;
/* Liquid all around: so far [spacings]. */
enum { INSIDE = 5, LEAST_INSIDE = 20 };

/* ---- the grid ---------------------------------------------------------------------------------------------------- */

/** Where cells begin and how many there are in one direction, `ghosts` of them beyond either end of the domain. */
typedef struct axis {
    double origin, size;
    size_t count, nodes;
} axis;

/** Cells along a direction: as many as fit the domain, beyond its ends as far as walls are felt or liquid is. */
static axis axis_of(double low, double high, double period, double dx, const double *x, size_t count)
{
    double cells = fmax(ceil((high - low) * CELLS / dx - 1e-9), 1), size = (high - low) / cells;
    if (period > 0)
        return (axis){low, size, (size_t)cells, (size_t)cells};
    double least = low, most = high, far = high - low;
    for (size_t i = 0; i < count; ++i) {
        least = fmin(least, x[i]);
        most = fmax(most, x[i]);
    }
    double before = REACH + ceil((low - fmax(least, low - far)) / size);
    double behind = REACH + ceil((fmin(most, high + far) - high) / size);
    size_t all = (size_t)(cells + before + behind);
    return (axis){low - before * size, size, all, all + 1};
}

static bool is_beyond_wall(const sph2d_scene *scene, sph2d_vec2 p)
{
    const sph2d_boundary b = scene->boundary;
    const sph2d_box d = scene->domain;
    return (b.left == SPH2D_SIDE_WALL && p.x < d.min.x) || (b.right == SPH2D_SIDE_WALL && p.x > d.max.x) ||
           (b.bottom == SPH2D_SIDE_WALL && p.y < d.min.y) || (b.top == SPH2D_SIDE_WALL && p.y > d.max.y);
}

static bool is_solid(const sph2d_sim *sim, sph2d_vec2 p)
{
    if (is_beyond_wall(&sim->scene, p))
        return true;
    for (size_t k = 0; k < sim->scene.obstacle_count; ++k) {
        const sph2d_obstacle *o = &sim->scene.obstacles[k];
        sph2d_vec2 way = sph2d__sim_way_of(sim, o);
        if (sph2d__outline_encloses(&o->outline, (sph2d_vec2){p.x - way.x, p.y - way.y}))
            return true;
    }
    return false;
}

/** Looks where walls are: at a cell's corners, and closer where those differ. */
static void find_solids(sph2d__coverage *c)
{
    for (size_t j = 0; j < c->ny; ++j)
        for (size_t i = 0; i < c->nx; ++i) {
            int n = 0;
            for (int k = 0; k < WHOLE; ++k) {
                double x = (double)i + (k % LOOKS + 0.5) / LOOKS, y = (double)j + (k / LOOKS + 0.5) / LOOKS;
                n += is_solid(c->sim, (sph2d_vec2){c->origin.x + x * c->size_x, c->origin.y + y * c->size_y});
            }
            c->solid[j * c->nx + i] = (unsigned char)n;
        }
}

/** Node of a column or row, brought into the period; SIZE_MAX beyond the grid. */
static size_t node_at(long k, size_t nodes, size_t cells)
{
    if (nodes == cells) /* periodic */
        return (size_t)((k % (long)cells + (long)cells) % (long)cells);
    return k >= 0 && k < (long)nodes ? (size_t)k : SIZE_MAX;
}

/** Adds `amount` W(r) to the nodes around a place, which is in cells from the origin; `out` are sums of nodes. */
static void spread(const sph2d__coverage *c, double x, double y, double amount, float *out)
{
    const double h = SUPPORT * c->sim->system.spacing;
    long i0 = (long)floor(x) - REACH - 1, j0 = (long)floor(y) - REACH - 1;
    for (long j = j0; j <= j0 + 2 * REACH + 3; ++j) {
        size_t row = node_at(j, c->nodes_y, c->ny);
        double dy = ((double)j - y) * c->size_y / h;
        if (row == SIZE_MAX || !(dy * dy < 1))
            continue;
        for (long i = i0; i <= i0 + 2 * REACH + 3; ++i) {
            size_t column = node_at(i, c->nodes_x, c->nx);
            double dx = ((double)i - x) * c->size_x / h, q2 = dx * dx + dy * dy;
            if (column != SIZE_MAX && q2 < 1)
                out[row * c->nodes_x + column] +=
                    (float)(amount * sph2d__kernel_value_at(SPH2D_KERNEL_WENDLAND_C2, sqrt(q2)));
        }
    }
}

/** Spreads liquid and walls, and divides by what walls leave free. */
static void fill_nodes(sph2d__coverage *c, float *walls)
{
    const sph2d__store *f = &c->sim->system.fluid;
    const double dx = c->sim->system.spacing;
    const double constant = sph2d__kernel_constant(SPH2D_KERNEL_WENDLAND_C2) / (SUPPORT * SUPPORT);
    for (size_t i = 0; i < f->count; ++i)
        spread(c, (f->x[i] - c->origin.x) / c->size_x, (f->y[i] - c->origin.y) / c->size_y, constant, c->fill);
    double share = constant * c->size_x * c->size_y / (dx * dx) / WHOLE;
    for (size_t j = 0; j < c->ny; ++j)
        for (size_t i = 0; i < c->nx; ++i)
            if (c->solid[j * c->nx + i] > 0)
                spread(c, (double)i + 0.5, (double)j + 0.5, share * c->solid[j * c->nx + i], walls);
    for (size_t k = 0; k < c->nodes_x * c->nodes_y; ++k) {
        double room = 1 - (double)walls[k];
        c->fill[k] = (float)(room > LEAST_ROOM ? (double)c->fill[k] / room : 0);
    }
}

bool sph2d__coverage_make(sph2d__coverage *c, const sph2d_sim *sim)
{
    const sph2d__store *f = &sim->system.fluid;
    const sph2d__period *p = &sim->system.fluid_cells.period;
    const sph2d_box d = sim->scene.domain;
    axis x = axis_of(d.min.x, d.max.x, p->length_x, sim->system.spacing, f->x, f->count);
    axis y = axis_of(d.min.y, d.max.y, p->length_y, sim->system.spacing, f->y, f->count);
    *c = (sph2d__coverage){.sim = sim, .origin = {x.origin, y.origin}, .size_x = x.size, .size_y = y.size,
                           .nx = x.count, .ny = y.count, .nodes_x = x.nodes, .nodes_y = y.nodes};
    if (!((double)x.nodes * (double)y.nodes < MOST_CELLS))
        return false;
    size_t nodes = x.nodes * y.nodes;
    c->fill = sph2d__alloc(sim->system.memory, nodes, sizeof(float));
    c->solid = sph2d__alloc(sim->system.memory, x.count * y.count, 1);
    void *walls = sph2d__alloc(sim->system.memory, nodes, sizeof(float));
    bool ok = c->fill && c->solid && walls;
    if (ok) {
        find_solids(c);
        fill_nodes(c, walls);
    }
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

/** Part of a line on which a value that goes from a to b is above a half. */
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

/** The cell of a place in one direction, and how far in it; false beyond the grid. */
static bool cell_of(double place, double origin, double size, size_t count, size_t *cell, double *in)
{
    double f = (place - origin) / size;
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
    if (!cell_of(x, c->origin.x, c->size_x, c->nx, &i, &s) || !cell_of(y, c->origin.y, c->size_y, c->ny, &j, &t))
        return 0;
    corners_of(c, i, j, f);
    return (1 - t) * (f[0] + s * (f[1] - f[0])) + t * (f[2] + s * (f[3] - f[2]));
}

double sph2d__coverage_area(const sph2d__coverage *c)
{
    const sph2d__store *fluid = &c->sim->system.fluid;
    double cells = 0, alone = 0;
    for (size_t j = 0; j < c->ny; ++j)
        for (size_t i = 0; i < c->nx; ++i) {
            int solid = c->solid[j * c->nx + i];
            if (solid == WHOLE)
                continue;
            double f[4];
            corners_of(c, i, j, f);
            cells += covered_part(f) * (WHOLE - solid) / WHOLE;
        }
    for (size_t i = 0; i < fluid->count; ++i)
        alone += fill_at(c, fluid->x[i], fluid->y[i]) < 0.5;
    double dx = c->sim->system.spacing;
    return cells * c->size_x * c->size_y + alone * dx * dx;
}

/* ---- level ------------------------------------------------------------------------------------------------------- */

enum { TO_RIGHT = 1, UPWARDS = 2, LIQUID = 4 };
enum { DRY, TOUCHED, WET };

/** Liquid that spreads from cell to cell. */
typedef struct flood {
    const sph2d__coverage *grid;
    unsigned char *closed; /**< of each cell: a wall stands in the way to the next, liquid is there */
    unsigned char *wet;    /**< dry; wet, and liquid goes on from there; or the rest of a cell that has a wall's surface
                                in it and its middle behind that */
    uint32_t *queue;
    size_t queued;
} flood;

static bool is_crossed(const sph2d_sim *sim, sph2d_vec2 a, sph2d_vec2 b)
{
    bool crossed = sph2d__barrier_crosses(&sim->barrier, a, b);
    for (size_t k = 0; k < sim->moving_count && !crossed; ++k) {
        sph2d_vec2 way = sim->moving[k].to;
        crossed = sph2d__barrier_crosses(&sim->moving[k].barrier, (sph2d_vec2){a.x - way.x, a.y - way.y},
                                         (sph2d_vec2){b.x - way.x, b.y - way.y});
    }
    return crossed;
}

/** Closes ways between the middles of cells that a wall crosses, and marks cells with liquid. */
static void lay_out(flood *w)
{
    const sph2d__coverage *c = w->grid;
    const sph2d__store *f = &c->sim->system.fluid;
    for (size_t j = 0; j < c->ny && c->sim->scene.obstacle_count > 0; ++j)
        for (size_t i = 0; i < c->nx; ++i) {
            sph2d_vec2 at = {c->origin.x + ((double)i + 0.5) * c->size_x, c->origin.y + ((double)j + 0.5) * c->size_y};
            bool x = is_crossed(c->sim, at, (sph2d_vec2){at.x + c->size_x, at.y});
            bool y = is_crossed(c->sim, at, (sph2d_vec2){at.x, at.y + c->size_y});
            w->closed[j * c->nx + i] = (unsigned char)((x ? TO_RIGHT : 0) | (y ? UPWARDS : 0));
        }
    for (size_t k = 0; k < f->count; ++k) {
        size_t i, j;
        double in;
        if (cell_of(f->x[k], c->origin.x, c->size_x, c->nx, &i, &in) &&
            cell_of(f->y[k], c->origin.y, c->size_y, c->ny, &j, &in))
            w->closed[j * c->nx + i] |= LIQUID;
    }
}

static void wet_cell(flood *w, size_t cell, bool closed)
{
    unsigned char solid = w->grid->solid[cell];
    if (w->wet[cell] == WET || solid == WHOLE || (closed && solid == 0))
        return;
    w->wet[cell] = closed ? TOUCHED : WET;
    if (!closed)
        w->queue[w->queued++] = (uint32_t)cell;
}

/** Wets the cells around one that are no higher than row `top`. */
static void go_on(flood *w, size_t cell, size_t top)
{
    const sph2d__coverage *c = w->grid;
    size_t i = cell % c->nx, j = cell / c->nx, row = cell - i;
    bool round_x = c->nodes_x == c->nx;
    size_t left = row + (i + c->nx - 1) % c->nx;
    if (i + 1 < c->nx || round_x)
        wet_cell(w, row + (i + 1) % c->nx, w->closed[cell] & TO_RIGHT);
    if (i > 0 || round_x)
        wet_cell(w, left, w->closed[left] & TO_RIGHT);
    if (j < top)
        wet_cell(w, cell + c->nx, w->closed[cell] & UPWARDS);
    if (j > 0)
        wet_cell(w, cell - c->nx, w->closed[cell - c->nx] & UPWARDS);
}

/** What liquid can get to below the top of a row: its area and that in the row itself, in cells. */
typedef struct room {
    double area, row;
} room;

static room room_below(flood *w, size_t top)
{
    const sph2d__coverage *c = w->grid;
    const size_t cells = c->nx * (top + 1);
    room r = {0, 0};
    w->queued = 0;
    for (size_t k = 0; k < cells; ++k)
        w->wet[k] = DRY;
    for (size_t k = 0; k < cells; ++k)
        if (w->closed[k] & LIQUID)
            wet_cell(w, k, false);
    for (size_t k = 0; k < w->queued; ++k)
        go_on(w, w->queue[k], top);
    for (size_t k = 0; k < cells; ++k)
        if (w->wet[k] != DRY) {
            double part = (double)(WHOLE - c->solid[k]) / WHOLE;
            r.area += part;
            r.row += k / c->nx == top ? part : 0;
        }
    return r;
}

/** Looks for the row in which the liquid's surface is. */
static double level_of(flood *w, double area)
{
    const sph2d__coverage *c = w->grid;
    size_t low = 0, high = c->ny - 1;
    lay_out(w);
    if (room_below(w, high).area < area)
        return NAN;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (room_below(w, middle).area < area)
            low = middle + 1;
        else
            high = middle;
    }
    room r = room_below(w, low);
    double spare = r.row > 0 ? fmin((r.area - area) / r.row, 1) : 0;
    return c->origin.y + ((double)low + 1 - spare) * c->size_y;
}

double sph2d__coverage_level(const sph2d__coverage *c, double area)
{
    const sph2d__body *b = &c->sim->system.body;
    sph2d__memory *memory = c->sim->system.memory;
    size_t cells = c->nx * c->ny;
    if (b->gravity_x != 0 || !(b->gravity_y < 0) || c->nodes_y == c->ny)
        return NAN;
    void *closed = sph2d__alloc(memory, cells, 1), *wet = sph2d__alloc(memory, cells, 1);
    void *queue = sph2d__alloc(memory, cells, sizeof(uint32_t));
    double level = NAN;
    if (closed && wet && queue)
        level = level_of(&(flood){.grid = c, .closed = closed, .wet = wet, .queue = queue},
                         area / (c->size_x * c->size_y));
    sph2d__release(memory, &closed, closed ? cells : 0, 1);
    sph2d__release(memory, &wet, wet ? cells : 0, 1);
    sph2d__release(memory, &queue, queue ? cells : 0, sizeof(uint32_t));
    return level;
}

/* ---- density ----------------------------------------------------------------------------------------------------- */

/** Marks the nodes of a rectangle around a place, in nodes; beyond the grid there are none. */
static void mark_around(const sph2d__coverage *c, double x, double y, double reach_x, double reach_y,
                        unsigned char *marks)
{
    for (long j = (long)ceil(y - reach_y); j <= (long)floor(y + reach_y); ++j)
        for (long i = (long)ceil(x - reach_x); i <= (long)floor(x + reach_x); ++i) {
            size_t row = node_at(j, c->nodes_y, c->ny), column = node_at(i, c->nodes_x, c->nx);
            if (row != SIZE_MAX && column != SIZE_MAX)
                marks[row * c->nodes_x + column] = 1;
        }
}

/** Marks what is near a place where there is no liquid. */
static void mark_bare(const sph2d__coverage *c, unsigned char *marks)
{
    for (size_t j = 0; j < c->nodes_y; ++j)
        for (size_t i = 0; i < c->nodes_x; ++i) {
            size_t left = j * c->nodes_x + (i + c->nodes_x - 1) % c->nodes_x;
            bool bare = (double)c->fill[j * c->nodes_x + i] < 0.5, first = i == 0 && c->nodes_x != c->nx;
            bool before = !first && (double)c->fill[left] < 0.5;
            if (bare) /* in a row of them the first marks all that the others would but for their last columns */
                mark_around(c, (double)i + (before ? INSIDE * CELLS : 0), (double)j, before ? 0 : INSIDE * CELLS,
                            INSIDE * CELLS, marks);
        }
}

/** Marks what is near boundary particles and sides. */
static void mark_walls(const sph2d__coverage *c, unsigned char *marks)
{
    const sph2d__store *w = &c->sim->system.walls;
    double h = SUPPORT * c->sim->system.spacing;
    for (size_t b = 0; b < w->count; ++b)
        mark_around(c, (w->x[b] - c->origin.x) / c->size_x, (w->y[b] - c->origin.y) / c->size_y, h / c->size_x,
                    h / c->size_y, marks);
    for (size_t j = 0; j < c->nodes_y; ++j)
        for (size_t i = 0; i < c->nodes_x; ++i) {
            double x = c->origin.x + (double)i * c->size_x, y = c->origin.y + (double)j * c->size_y;
            for (int k = 0; k < 4; ++k) {
                sph2d_vec2 p = {x + (k == 0 ? -h : k == 1 ? h : 0), y + (k == 2 ? -h : k == 3 ? h : 0)};
                if (is_beyond_wall(&c->sim->scene, p))
                    marks[j * c->nodes_x + i] = 1;
            }
        }
}

static sph2d_densities densities_of(const sph2d__coverage *c, const unsigned char *marks)
{
    const sph2d__store *f = &c->sim->system.fluid;
    double counted = 0, told = 0;
    size_t nodes = 0, particles = 0;
    for (size_t k = 0; k < c->nodes_x * c->nodes_y; ++k)
        if (!marks[k]) {
            counted += (double)c->fill[k];
            ++nodes;
        }
    for (size_t i = 0; i < f->count; ++i) {
        double x = (f->x[i] - c->origin.x) / c->size_x + 0.5, y = (f->y[i] - c->origin.y) / c->size_y + 0.5;
        size_t column = x >= 0 && x < (double)c->nx + 1 ? node_at((long)x, c->nodes_x, c->nx) : SIZE_MAX;
        size_t row = y >= 0 && y < (double)c->ny + 1 ? node_at((long)y, c->nodes_y, c->ny) : SIZE_MAX;
        if (column == SIZE_MAX || row == SIZE_MAX || marks[row * c->nodes_x + column])
            continue;
        told += f->density[i] / c->sim->system.rest_density;
        ++particles;
    }
    if (particles < LEAST_INSIDE)
        return (sph2d_densities){NAN, NAN};
    return (sph2d_densities){told / (double)particles, counted / (double)nodes};
}

sph2d_densities sph2d__coverage_densities(const sph2d__coverage *c)
{
    sph2d__memory *memory = c->sim->system.memory;
    size_t nodes = c->nodes_x * c->nodes_y;
    sph2d_densities found = {NAN, NAN};
    void *marks = sph2d__alloc(memory, nodes, 1);
    if (marks) {
        mark_bare(c, marks);
        mark_walls(c, marks);
        found = densities_of(c, marks);
    }
    sph2d__release(memory, &marks, marks ? nodes : 0, 1);
    return found;
}

sph2d_densities sph2d_sim_densities(const sph2d_sim *sim)
{
    sph2d__coverage c;
    sph2d_densities found = {NAN, NAN};
    if (sph2d__coverage_make(&c, sim)) {
        found = sph2d__coverage_densities(&c);
        sph2d__coverage_free(&c);
    }
    return found;
}

/* Steps between looks, which take as long as some steps do. */
enum { DENSITY_STEPS = 500 };

void sph2d__sim_watch_density(sph2d_sim *sim)
{
    sph2d__record *r = &sim->record;
    if (r->steps % DENSITY_STEPS != 0)
        return;
    sph2d_densities now = sph2d_sim_densities(sim);
    r->density_apart = fmax(r->density_apart, fabs(now.told - now.counted)); /* passes over NaN */
}
