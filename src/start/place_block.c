/* SPDX-License-Identifier: MIT */
/** @file place_block.c
 *  The particles of a block: a square lattice or rings if these fit its area, otherwise a stretched or shifted lattice
 *  or a packing. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/pi.h"
#include "scene/shape.h"
#include "start/packing.h"
#include "start/start.h"

/* Relative error of the area up to which a lattice is kept; the maximum stretch of a lattice; and the minimum area of a
 * packing, in particles. */
static const double AREA_TOLERANCE = 0.002, MAX_STRETCH = 0.02, MIN_PACKED = 4;

/* Shifts of a lattice that are tried in each direction, and the maximum of lattice sites times corners for trying. */
enum { SHIFTS = 16 };
static const double MAX_SHIFT_COST = 2e5;

/** The lattice of a block: first site, spacings, number of sites. */
typedef struct lattice {
    sph2d_vec2 first;
    double x, y;   /**< spacings [m] */
    double nx, ny; /**< integers; double because an invalid scene may have too many */
} lattice;

static double block_spacing(const sph2d_sim *sim, const sph2d_block *block)
{
    return block->spacing > 0 ? block->spacing : sim->world.scene.spacing;
}

static lattice lattice_of(const sph2d_sim *sim, const sph2d_block *block)
{
    double spacing = block_spacing(sim, block);
    lattice l = {.x = spacing, .y = spacing};
    sph2d_box b = sph2d__shape_bounds(&block->shape);
    double half = block->shape.kind == SPH2D_SHAPE_BOX
                      ? 0.5
                      : 0.0; /* boxes round to whole columns, other shapes are cut out of the lattice */
    l.nx = fmax(floor((b.max.x - b.min.x) / spacing + half), 1);
    l.ny = fmax(floor((b.max.y - b.min.y) / spacing + half), 1);
    l.first.x = (b.min.x + b.max.x) / 2 - (l.nx - 1) / 2 * spacing;
    l.first.y = (b.min.y + b.max.y) / 2 - (l.ny - 1) / 2 * spacing;
    return l;
}

/** Whether a number of particles has the right area, that of `target` particles. */
static bool matches_area(double count, double target)
{
    return fabs(count - target) <= fmax(0.5, AREA_TOLERANCE * target);
}

/** Stretches or compresses a lattice to fit a box; false if that would exceed MAX_STRETCH. */
static bool stretch(const sph2d_sim *sim, const sph2d_block *block, lattice *l)
{
    if (block->shape.kind != SPH2D_SHAPE_BOX)
        return false;
    sph2d_box b = block->shape.box;
    double spacing = block_spacing(sim, block), width = b.max.x - b.min.x, height = b.max.y - b.min.y;
    for (double nx = floor(width / spacing); nx <= ceil(width / spacing); ++nx)
        for (double ny = floor(height / spacing); ny <= ceil(height / spacing); ++ny) {
            *l = (lattice){.x = width / nx, .y = height / ny, .nx = nx, .ny = ny};
            l->first = (sph2d_vec2){b.min.x + l->x / 2, b.min.y + l->y / 2};
            if (nx > 0 && ny > 0 && fabs(l->x / spacing - 1) <= MAX_STRETCH &&
                fabs(l->y / spacing - 1) <= MAX_STRETCH && matches_area(nx * ny, width / spacing * (height / spacing)))
                return true;
        }
    return false;
}

/** A block that is being placed. */
typedef struct placing {
    const sph2d_block *block;
    double spacing;
    size_t first;       /**< its first particle */
    size_t index;       /**< of the block */
    size_t occupied[4]; /**< sites by sph2d__occupancy */
    double area;        /**< area to fill: its shape without solids [m^2] */
} placing;

/** Adds a particle. A block with its own spacing starts with the density that follows from it. */
static void add(sph2d_sim *sim, const sph2d_block *block, sph2d_vec2 p)
{
    sph2d__store *fluid = &sim->system.fluid;
    size_t i = sph2d__sim_add_liquid(sim, p, block->color);
    fluid->vx[i] = block->velocity.x;
    fluid->vy[i] = block->velocity.y;
    double compression = pow(sim->world.scene.spacing / block_spacing(sim, block), 2);
    fluid->density[i] = compression * sim->world.scene.fluid.density;
}

/** Adds a particle of a block unless an obstacle occupies its position; the store has the capacity. */
static void place(sph2d_sim *sim, placing *b, sph2d_vec2 p)
{
    sph2d__occupancy occupancy = sph2d__sim_occupancy(sim, p, 1);
    ++b->occupied[occupancy];
    if (occupancy == SPH2D__FREE)
        add(sim, b->block, p);
}

static void place_lattice(sph2d_sim *sim, placing *b, const lattice *l)
{
    for (size_t row = 0; row < (size_t)l->ny; ++row)
        for (size_t column = 0; column < (size_t)l->nx; ++column) {
            sph2d_vec2 p = {l->first.x + (double)column * l->x, l->first.y + (double)row * l->y};
            if (b->block->shape.kind == SPH2D_SHAPE_BOX || sph2d__shape_contains(&b->block->shape, p))
                place(sim, b, p);
        }
}

/** Number of particles of the k-th ring. */
static double ring_count(size_t k)
{
    return round(2 * SPH2D__PI * ((double)k + 0.5));
}

/** The k-th ring has the radius (k + 1/2) spacing; the three particles of the first are one spacing apart, as they
 *  collapse if closer. Each ring is rotated by the golden angle against the last, which avoids a pattern. */
static void place_rings(sph2d_sim *sim, placing *b, size_t rings)
{
    const double golden = SPH2D__PI * (3 - sqrt(5)), spacing = b->spacing;
    for (size_t k = 0; k < rings; ++k) {
        double radius = (k > 0 ? (double)k + 0.5 : 1 / sqrt(3)) * spacing, count = ring_count(k);
        for (size_t i = 0; i < (size_t)count; ++i) {
            double angle = golden * (double)k + 2 * SPH2D__PI * (double)i / count;
            place(sim, b,
                  (sph2d_vec2){b->block->shape.circle.center.x + radius * cos(angle),
                               b->block->shape.circle.center.y + radius * sin(angle)});
        }
    }
}

/** Removes the particles of a block again. */
static void remove_block(sph2d_sim *sim, placing *b)
{
    sim->record.next_id -= sim->system.fluid.count - b->first;
    sim->system.fluid.count = b->first;
    memset(b->occupied, 0, sizeof b->occupied);
}

/** Whether obstacles occupied no site. */
static bool all_sites_free(const placing *b)
{
    for (int k = SPH2D__ENCLOSED; k <= SPH2D__NEAR_LINE; ++k)
        if (b->occupied[k] > 0)
            return false;
    return true;
}

/** Whether a block is about a spacing or more away from the sides of the domain and from obstacles. */
static bool is_isolated(const sph2d_sim *sim, const placing *b)
{
    const sph2d__store *f = &sim->system.fluid;
    for (size_t i = b->first; i < f->count; ++i)
        if (sph2d__sim_occupancy(sim, (sph2d_vec2){f->x[i], f->y[i]}, 3) != SPH2D__FREE)
            return false;
    sph2d_box d = sim->world.box, s = sph2d__shape_bounds(&b->block->shape);
    return s.min.x > d.min.x + b->spacing && s.max.x < d.max.x - b->spacing && s.min.y > d.min.y + b->spacing &&
           s.max.y < d.max.y - b->spacing;
}

static double count_inside(const placing *b, const lattice *l)
{
    double count = 0;
    for (double row = 0; row < l->ny; ++row)
        for (double column = 0; column < l->nx; ++column)
            count += sph2d__shape_contains(&b->block->shape,
                                           (sph2d_vec2){l->first.x + column * l->x, l->first.y + row * l->y});
    return count;
}

/** Moves the particles of a block so that their centroid is its shape's. */
static void centre(sph2d_sim *sim, const placing *b)
{
    const sph2d_vec2 c = sph2d_shape_centroid(&b->block->shape);
    sph2d__store *f = &sim->system.fluid;
    double x = 0, y = 0, count = (double)(f->count - b->first);
    for (size_t i = b->first; i < f->count; ++i) {
        x += (f->x[i] - c.x) / count;
        y += (f->y[i] - c.y) / count;
    }
    for (size_t i = b->first; i < f->count; ++i) {
        f->x[i] -= x;
        f->y[i] -= y;
    }
}

/** Fills an isolated disc or polygon by a lattice, shifted by sixteenths of a spacing until the number of sites inside
 *  has the right area; false if there is none, or if walls are near. A lattice starts without pressure differences,
 *  while the summed densities of packed particles differ a little. */
static bool place_shifted(sph2d_sim *sim, placing *b, const lattice *plain)
{
    const sph2d_shape *shape = &b->block->shape;
    double corners = shape->kind == SPH2D_SHAPE_POLYGON ? (double)shape->points.count : 1;
    double target = b->area / (b->spacing * b->spacing), smallest = INFINITY;
    lattice best = *plain;
    if (shape->kind == SPH2D_SHAPE_BOX || b->block->arrangement == SPH2D_ARRANGEMENT_RINGS || !all_sites_free(b) ||
        plain->nx * plain->ny * corners > MAX_SHIFT_COST || !is_isolated(sim, b))
        return false;
    for (int k = 1; k < SHIFTS * SHIFTS && smallest > 0.5; ++k) {
        lattice l = *plain;
        l.first.x += ((double)(k % SHIFTS) / SHIFTS - 1) * b->spacing;
        l.first.y += floor((double)k / SHIFTS) * b->spacing / SHIFTS - b->spacing;
        ++l.nx;
        ++l.ny;
        double error = fabs(count_inside(b, &l) - target);
        if (error < smallest) {
            smallest = error;
            best = l;
        }
    }
    if (!matches_area(target + smallest, target))
        return false;
    remove_block(sim, b);
    place_lattice(sim, b, &best);
    if (shape->kind == SPH2D_SHAPE_CIRCLE)
        centre(sim, b);
    return true;
}

static bool has_solid(const sph2d__world *world)
{
    for (size_t k = SPH2D__WALL_OBSTACLE; k < world->wall_count; ++k)
        if (!sph2d__shape_is_open(&world->walls[k].shape))
            return true;
    return false;
}

/** Whether the placed particles fit: no site was lost beside layers, and their number has the right area. */
static bool fits(const sph2d_sim *sim, const placing *b)
{
    double target = b->area / (b->spacing * b->spacing), placed = (double)(sim->system.fluid.count - b->first);
    return b->occupied[SPH2D__NEAR_LAYERS] == 0 && matches_area(placed, target);
}

/** Whether the columns and rows of a box fill it to its edges, within a twentieth of a spacing on either side. */
static bool fits_edges(const placing *b, const lattice *l)
{
    sph2d_box box = sph2d__shape_bounds(&b->block->shape);
    double x = l->nx * l->x - (box.max.x - box.min.x), y = l->ny * l->y - (box.max.y - box.min.y);
    return b->block->shape.kind != SPH2D_SHAPE_BOX || fmax(fabs(x), fabs(y)) <= 0.1 * b->spacing;
}

/** Fills a box again by a stretched lattice; false if none fits, or an obstacle occupies sites. */
static bool place_stretched(sph2d_sim *sim, placing *b)
{
    lattice l;
    if (!all_sites_free(b) || !stretch(sim, b->block, &l))
        return false;
    remove_block(sim, b);
    place_lattice(sim, b, &l);
    return true;
}

/** Fills a block again by a packing. False when memory is short. */
static bool place_packed(sph2d_sim *sim, placing *b, sph2d__region *region)
{
    sph2d__packing packing;
    remove_block(sim, b);
    if (!sph2d__pack(sim, region, &packing) ||
        !sph2d__store_reserve(&sim->system.fluid, &sim->memory, b->first + packing.count))
        return false;
    for (size_t i = 0; i < packing.count; ++i)
        add(sim, b->block, packing.positions[i]);
    sph2d__packing_free(&packing, &sim->memory);
    return true;
}

/* Relative error of a region's area, from sampling the edges of solids. */
static const double GRID_ERROR = 1e-3;

/** Adds a block to the plan. */
static void add_to_plan(sph2d_sim *sim, const placing *b)
{
    sph2d_plan *plan = &sim->plan;
    double shape_area = sph2d__shape_area(&b->block->shape), part = 1 - b->area / shape_area;
    plan->area_asked += b->area;
    plan->area_placed += (double)(sim->system.fluid.count - b->first) * b->spacing * b->spacing;
    for (int k = SPH2D__ENCLOSED; k <= SPH2D__NEAR_LINE; ++k)
        plan->places_left_free += b->occupied[k];
    if (!(part > GRID_ERROR))
        return;
    plan->area_left_out += shape_area - b->area;
    if (part > plan->most_left_out) {
        plan->most_left_out = part;
        plan->most_left_out_block = b->index;
    }
}

/** Computes the area of a block and fills it: by its lattice or rings if they fit, by a stretched or shifted lattice,
 *  or by a packing. Beside obstacles without layers the lattice is kept. */
static sph2d_status fill_area(sph2d_sim *sim, placing *b, const lattice *l)
{
    sph2d__region region = {0};
    bool solids = has_solid(&sim->world);
    b->area = sph2d__shape_area(&b->block->shape);
    double margin = ceil(sim->system.support / sim->world.scene.spacing) + 1;
    sph2d_vec2 corner = {l->first.x - b->spacing / 2, l->first.y - b->spacing / 2};
    bool ok = !solids || sph2d__region_make(&region, sim, &b->block->shape, corner, b->spacing, (int)margin);
    if (ok && solids)
        b->area = sph2d__region_area(&region);
    bool rings = b->block->arrangement == SPH2D_ARRANGEMENT_RINGS && b->occupied[SPH2D__NEAR_LAYERS] == 0;
    bool done =
        rings || (fits(sim, b) && fits_edges(b, l)); /* rings are kept as requested, a whole number of spacings wide */
    done = done || !ok || b->area < MIN_PACKED * b->spacing * b->spacing || place_stretched(sim, b);
    done = done || fits(sim, b) || place_shifted(sim, b, l);
    if (!done && b->occupied[SPH2D__NEAR_LINE] == 0) {
        ok = solids || sph2d__region_make(&region, sim, &b->block->shape, corner, b->spacing, (int)margin);
        ok = ok && place_packed(sim, b, &region);
    }
    if (region.quarters)
        sph2d__region_free(&region, &sim->memory);
    add_to_plan(sim, b);
    return ok ? SPH2D_OK : SPH2D_NOMEM;
}

sph2d_status sph2d__sim_place_block(sph2d_sim *sim, size_t index, sph2d_report *report)
{
    const sph2d_block *block = &sim->world.scene.blocks[index];
    sph2d__store *fluid = &sim->system.fluid;
    placing b = {.block = block, .spacing = block_spacing(sim, block), .first = fluid->count, .index = index};
    lattice l = lattice_of(sim, block);
    double count = l.nx * l.ny, rings = 0;
    if (block->arrangement == SPH2D_ARRANGEMENT_RINGS) {
        rings = fmax(round(block->shape.circle.radius / b.spacing), 1);
        count = 2 * SPH2D__PI * rings * rings; /* an upper bound of the sum of ring_count */
    }
    char path[64];
    snprintf(path, sizeof path, "blocks[%zu]", index);
    if (sph2d__sim_too_many(sim, (double)fluid->count + count, path, report))
        return SPH2D_SCENE;
    double max_count = fmax(count, (l.nx + 2) * (l.ny + 2)); /* of a stretched lattice */
    if (!sph2d__store_reserve(fluid, &sim->memory, fluid->count + (size_t)ceil(max_count)))
        return SPH2D_NOMEM;
    if (rings > 0)
        place_rings(sim, &b, (size_t)rings);
    else
        place_lattice(sim, &b, &l);
    return fill_area(sim, &b, &l);
}
