/* SPDX-License-Identifier: MIT */
/** @file place_fluid.c
 *  The particles of a scene's blocks: square lattices or rings, kept free of obstacles, refused where they overlap; and
 * single particles. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/pi.h"
#include "base/random.h"
#include "scene/resolve.h"
#include "sim/simulation.h"

/* Places closer to an obstacle than this many spacings stay free: beside layers of boundary particles, which begin half
 * a spacing behind the surface, the lattice goes on. */
static const double FREE_DISTANCE = 0.7, FREE_DISTANCE_OF_LAYERS = 0.49;

/* Cells name particles by 32 bits. */
static const double MOST_PARTICLES = 4e9;

/** The lattice of a block: first place, number of places. */
typedef struct lattice {
    sph2d_vec2 first;
    double spacing;
    double nx, ny; /**< whole numbers, as doubles because a wrong scene may ask for too many */
} lattice;

static lattice lattice_of(const sph2d_sim *sim, const sph2d_block *block)
{
    lattice l = {.spacing = block->spacing > 0 ? block->spacing : sim->scene.spacing};
    sph2d_box b = sph2d__shape_bounds(&block->shape);
    double half = block->shape.kind == SPH2D_SHAPE_BOX ? 0.5 : 0.0; /* boxes fit whole columns, others are cut out */
    l.nx = fmax(floor((b.max.x - b.min.x) / l.spacing + half), 1);
    l.ny = fmax(floor((b.max.y - b.min.y) / l.spacing + half), 1);
    l.first.x = (b.min.x + b.max.x) / 2 - (l.nx - 1) / 2 * l.spacing;
    l.first.y = (b.min.y + b.max.y) / 2 - (l.ny - 1) / 2 * l.spacing;
    return l;
}

/** Whether a place is inside an obstacle or too close to it. */
static bool taken_by(const sph2d_outline *outline, double spacing, double distance, sph2d_vec2 p)
{
    if (outline->kind == SPH2D_OUTLINE_CIRCLE) /* by its radius: it has far more pieces than the others */
        return hypot(p.x - outline->circle.center.x, p.y - outline->circle.center.y) <
               outline->circle.radius + distance;
    if (sph2d__outline_encloses(outline, p))
        return true;
    size_t pieces = sph2d__outline_pieces(outline, spacing);
    for (size_t k = 0; k < pieces; ++k) {
        sph2d__segment s = sph2d__outline_piece(outline, spacing, k);
        if (sph2d__segment_distance(&s, p) < distance)
            return true;
    }
    return false;
}

/** Whether an obstacle takes a place, or one of its images beyond periodic sides, and `part` of the distance that it
 * keeps free. */
static bool taken_by_obstacle(const sph2d_sim *sim, sph2d_vec2 p, double part)
{
    const sph2d_scene *scene = &sim->scene;
    const sph2d__period *period = &sim->system.fluid_cells.period;
    int across = period->length_x > 0, along = period->length_y > 0;
    for (size_t i = 0; i < scene->obstacle_count; ++i) {
        const sph2d_obstacle *obstacle = &scene->obstacles[i];
        bool layers = sph2d__obstacle_form(scene, obstacle) == SPH2D_WALL_GENERALISED;
        double distance = part * (layers ? FREE_DISTANCE_OF_LAYERS : FREE_DISTANCE) * scene->spacing;
        for (int image_x = -across; image_x <= across; ++image_x)
            for (int image_y = -along; image_y <= along; ++image_y) {
                sph2d_vec2 image = {p.x + image_x * period->length_x, p.y + image_y * period->length_y};
                if (taken_by(&obstacle->outline, scene->spacing, distance, image))
                    return true;
            }
    }
    return false;
}

bool sph2d__sim_too_many(const sph2d_sim *sim, double count, const char *path, sph2d_report *report)
{
    long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGESIZE); /* -1 where the system does not tell */
    double memory = pages > 0 && page > 0 ? (double)pages * (double)page : INFINITY;
    double each = (double)sph2d__store_bytes(sim->system.fluid.has) + 3 * sizeof(uint32_t); /* store and cells */
    double bytes = count * each;
    if (count < MOST_PARTICLES && bytes <= memory)
        return false;
    sph2d_diagnostic *d = sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_TOO_MANY, path,
                                           "%.4g particles would need %.4g GB of memory", count, bytes / 1e9);
    if (strcmp(path, "particles") != 0)
        sph2d_diagnostic_hint(d, "a larger spacing needs fewer");
    return true;
}

/** Adds a particle of a block unless an obstacle takes its place; the store has room for it. */
static void place(sph2d_sim *sim, const sph2d_block *block, sph2d_vec2 p)
{
    if (taken_by_obstacle(sim, p, 1)) {
        ++sim->plan.places_left_free;
        return;
    }
    sph2d__store *fluid = &sim->system.fluid;
    size_t i = sph2d__store_add(fluid, sim->record.next_id++, p.x, p.y);
    fluid->vx[i] = block->velocity.x;
    fluid->vy[i] = block->velocity.y;
    fluid->density[i] = sim->scene.fluid.density;
}

static void place_lattice(sph2d_sim *sim, const sph2d_block *block, const lattice *l)
{
    for (size_t row = 0; row < (size_t)l->ny; ++row)
        for (size_t column = 0; column < (size_t)l->nx; ++column) {
            sph2d_vec2 p = {l->first.x + (double)column * l->spacing, l->first.y + (double)row * l->spacing};
            if (block->shape.kind == SPH2D_SHAPE_BOX || sph2d__shape_contains(&block->shape, p))
                place(sim, block, p);
        }
}

/** Particles of the k-th ring from the middle. */
static double ring_count(size_t k)
{
    return round(2 * SPH2D__PI * ((double)k + 0.5));
}

/** The k-th ring has the radius (k + 1/2) spacing; the three particles of the first keep a spacing from each other,
 *  without which they collapse. Rings are turned against each other by the golden angle, which repeats no pattern. */
static void place_rings(sph2d_sim *sim, const sph2d_block *block, double spacing, size_t rings)
{
    const double golden = SPH2D__PI * (3 - sqrt(5));
    for (size_t k = 0; k < rings; ++k) {
        double radius = (k > 0 ? (double)k + 0.5 : 1 / sqrt(3)) * spacing, count = ring_count(k);
        for (size_t i = 0; i < (size_t)count; ++i) {
            double angle = golden * (double)k + 2 * SPH2D__PI * (double)i / count;
            place(sim, block,
                  (sph2d_vec2){block->shape.disc.center.x + radius * cos(angle),
                               block->shape.disc.center.y + radius * sin(angle)});
        }
    }
}

static sph2d_status place_block(sph2d_sim *sim, size_t index, sph2d_report *report)
{
    const sph2d_block *block = &sim->scene.blocks[index];
    sph2d__store *fluid = &sim->system.fluid;
    lattice l = lattice_of(sim, block);
    double count = l.nx * l.ny, rings = 0;
    if (block->arrangement == SPH2D_ARRANGEMENT_RINGS) {
        rings = fmax(round(block->shape.disc.radius / l.spacing), 1);
        count = 2 * SPH2D__PI * rings * rings; /* more than ring_count adds up to */
    }
    char path[64];
    snprintf(path, sizeof path, "blocks[%zu]", index);
    if (sph2d__sim_too_many(sim, (double)fluid->count + count, path, report))
        return SPH2D_SCENE;
    if (!sph2d__store_reserve(fluid, &sim->memory, fluid->count + (size_t)ceil(count)))
        return SPH2D_NOMEM;
    if (rings > 0)
        place_rings(sim, block, l.spacing, (size_t)rings);
    else
        place_lattice(sim, block, &l);
    return SPH2D_OK;
}

static bool in_block(const sph2d_scene *scene, sph2d_vec2 p)
{
    for (size_t i = 0; i < scene->block_count; ++i)
        if (sph2d__shape_contains(&scene->blocks[i].shape, p))
            return true;
    return false;
}

/** The scene's single particles: as they are, wrapped into periodic sides, or refused. */
static sph2d_status place_particles(sph2d_sim *sim, sph2d_report *report)
{
    const sph2d_particles *particles = &sim->scene.particles;
    const sph2d__period *period = &sim->system.fluid_cells.period;
    sph2d__store *f = &sim->system.fluid;
    if (sph2d__sim_too_many(sim, (double)f->count + (double)particles->count, "particles", report))
        return SPH2D_SCENE;
    if (!sph2d__store_reserve(f, &sim->memory, f->count + particles->count))
        return SPH2D_NOMEM;
    for (size_t k = 0; particles->items && k < particles->count; ++k) {
        const sph2d_particle *p = &particles->items[k];
        sph2d_vec2 at = {sph2d__period_wrap(p->x, period->low_x, period->length_x),
                         sph2d__period_wrap(p->y, period->low_y, period->length_y)};
        if (in_block(&sim->scene, at))
            return sph2d__sim_refuse_particle(k, "inside a block", at, report);
        if (taken_by_obstacle(sim, at, 0))
            return sph2d__sim_refuse_particle(k, "inside an obstacle", at, report);
        size_t i = sph2d__store_add(f, sim->record.next_id++, at.x, at.y);
        f->vx[i] = p->vx;
        f->vy[i] = p->vy;
        f->density[i] = p->density;
    }
    return SPH2D_OK;
}

/** Displaces the particles of a block, from `first` on, at random; what leaves a periodic side comes in opposite. */
static void perturb_block(sph2d_sim *sim, size_t index, size_t first)
{
    const sph2d_perturb *perturb = &sim->scene.blocks[index].perturb;
    const sph2d__period *period = &sim->system.fluid_cells.period;
    sph2d__store *f = &sim->system.fluid;
    double reach = perturb->amplitude * sim->scene.spacing;
    for (size_t i = first; reach > 0 && i < f->count; ++i) {
        double x = f->x[i] + reach * sph2d__noise(perturb->seed, index, i - first, 0, 0);
        double y = f->y[i] + reach * sph2d__noise(perturb->seed, index, i - first, 0, 1);
        f->x[i] = sph2d__period_wrap(x, period->low_x, period->length_x);
        f->y[i] = sph2d__period_wrap(y, period->low_y, period->length_y);
    }
}

sph2d_status sph2d__sim_place_fluid(sph2d_sim *sim, sph2d_report *report)
{
    const sph2d_scene *scene = &sim->scene;
    sph2d__store *fluid = &sim->system.fluid;
    for (size_t i = 0; i < scene->block_count; ++i) {
        size_t first = fluid->count;
        sph2d_status status = place_block(sim, i, report);
        if (status == SPH2D_OK)
            status = sph2d__sim_check_overlap(sim, i, first, report);
        if (status != SPH2D_OK)
            return status;
        perturb_block(sim, i, first);
        status = sph2d__sim_start_block(sim, i, first, report);
        if (status != SPH2D_OK)
            return status;
    }
    uint64_t first_single = sim->record.next_id;
    sph2d_status status = place_particles(sim, report);
    if (status != SPH2D_OK)
        return status;
    if (fluid->count == 0 && scene->source_count == 0) {
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_NO_PARTICLES, scene->block_count > 0 ? "blocks" : "particles",
                         "there is no particle");
        return SPH2D_SCENE;
    }
    if (!sph2d__store_reserve(fluid, &sim->memory, 1) ||
        !sph2d__cells_build(&sim->system.fluid_cells, fluid, sim->system.reach, &sim->memory, sim->system.threads))
        return SPH2D_NOMEM;
    status = sph2d__sim_check_distances(sim, first_single, report);
    return status == SPH2D_OK ? sph2d__sim_check_layers(sim, report) : status;
}
