/* SPDX-License-Identifier: MIT */
/** @file place_fluid.c
 *  The particles of a scene: those of its blocks, kept free of obstacles, and single ones. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/random.h"
#include "scene/resolve.h"
#include "sim/simulation.h"

/* Places closer to an obstacle than this many spacings stay free: beside layers of boundary particles, which begin half
 * a spacing behind the surface, the lattice goes on. */
static const double FREE_DISTANCE = 0.7, FREE_DISTANCE_OF_LAYERS = 0.49;

/* Cells name particles by 32 bits. */
static const double MOST_PARTICLES = 4e9;

/** Whether a piece of an outline is nearer to a place than a distance. */
static bool is_beside(const sph2d_outline *outline, double spacing, double distance, sph2d_vec2 p)
{
    if (outline->kind == SPH2D_OUTLINE_CIRCLE) /* by its radius: it has far more pieces than the others */
        return hypot(p.x - outline->circle.center.x, p.y - outline->circle.center.y) <
               outline->circle.radius + distance;
    size_t pieces = sph2d__outline_pieces(outline, spacing);
    for (size_t k = 0; k < pieces; ++k) {
        sph2d__segment s = sph2d__outline_piece(outline, spacing, k);
        if (sph2d__segment_distance(&s, p) < distance)
            return true;
    }
    return false;
}

static sph2d__taken taken_by(const sph2d_sim *sim, const sph2d_obstacle *obstacle, double part, sph2d_vec2 p)
{
    bool layers = sph2d__obstacle_form(&sim->scene, obstacle) == SPH2D_WALL_GENERALISED;
    double distance = part * (layers ? FREE_DISTANCE_OF_LAYERS : FREE_DISTANCE) * sim->scene.spacing;
    if (sph2d__outline_encloses(&obstacle->outline, p))
        return layers ? SPH2D__ENCLOSED : SPH2D__BESIDE_LINE;
    if (!is_beside(&obstacle->outline, sim->scene.spacing, distance, p))
        return SPH2D__FREE;
    return layers ? SPH2D__BESIDE_LAYERS : SPH2D__BESIDE_LINE;
}

sph2d__taken sph2d__sim_taken(const sph2d_sim *sim, sph2d_vec2 p, double part)
{
    const sph2d_scene *scene = &sim->scene;
    const sph2d__period *period = &sim->system.fluid_cells.period;
    int across = period->length_x > 0, along = period->length_y > 0;
    sph2d__taken taken = SPH2D__FREE;
    for (size_t i = 0; i < scene->obstacle_count; ++i)
        for (int image_x = -across; image_x <= across; ++image_x)
            for (int image_y = -along; image_y <= along; ++image_y) {
                sph2d_vec2 image = {p.x + image_x * period->length_x, p.y + image_y * period->length_y};
                sph2d__taken now = taken_by(sim, &scene->obstacles[i], part, image);
                taken = now > taken ? now : taken;
            }
    return taken;
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
        if (sph2d__sim_taken(sim, at, 0) != SPH2D__FREE)
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
        sph2d_status status = sph2d__sim_place_block(sim, i, report);
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
        !sph2d__cells_build(&sim->system.fluid_cells, fluid, sim->system.reach, &sim->memory, sim->system.team))
        return SPH2D_NOMEM;
    status = sph2d__sim_check_distances(sim, first_single, report);
    return status == SPH2D_OK ? sph2d__sim_check_layers(sim, report) : status;
}
