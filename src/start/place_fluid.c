/* SPDX-License-Identifier: MIT */
/** @file place_fluid.c
 *  The fluid particles of a scene: those of its blocks, outside obstacles, and single ones. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/random.h"
#include "scene/liquid.h"
#include "start/start.h"

/** Gives single particles, from `first` on, what the scene starts with; densities that were given stay. */
static sph2d_status start_particles(sph2d_sim *sim, size_t first, sph2d_report *report)
{
    const sph2d_particles *particles = &sim->world.scene.particles;
    double *density = sim->system.fluid.density;
    sph2d_status status = sph2d__sim_start(sim, &sim->world.scene.start, first, "start", false, report);
    for (size_t k = 0; k < particles->count; ++k)
        if (particles->items[k].density > 0)
            density[first + k] = particles->items[k].density;
    return status;
}

/** Places the scene's single particles, wrapped at periodic sides; reports those in a block or obstacle. */
static sph2d_status place_particles(sph2d_sim *sim, sph2d_report *report)
{
    const sph2d_particles *particles = &sim->world.scene.particles;
    const size_t first = sim->system.fluid.count;
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
        if (sph2d__in_block(&sim->world.scene, at))
            return sph2d__sim_refuse_particle(k, "inside a block", at, report);
        if (sph2d__sim_occupancy(sim, at, 0) != SPH2D__FREE)
            return sph2d__sim_refuse_particle(k, "inside an obstacle", at, report);
        size_t i = sph2d__sim_add_liquid(sim, at, NULL);
        if (f->colored && p->color > 0)
            f->color[i] = (uint64_t)p->color;
        f->vx[i] = p->vx;
        f->vy[i] = p->vy;
        f->density[i] = sim->world.scene.fluid.density;
    }
    return particles->items && particles->count > 0 ? start_particles(sim, first, report) : SPH2D_OK;
}

/** Displaces the particles of a block, from `first` on, at random, wrapping them at periodic sides. */
static void perturb_block(sph2d_sim *sim, size_t index, size_t first)
{
    const sph2d_perturb *perturb = &sim->world.scene.blocks[index].perturb;
    const sph2d__period *period = &sim->system.fluid_cells.period;
    sph2d__store *f = &sim->system.fluid;
    double reach = perturb->amplitude * sim->world.scene.spacing;
    for (size_t i = first; reach > 0 && i < f->count; ++i) {
        double x = f->x[i] + reach * sph2d__noise(perturb->seed, index, i - first, 0, 0);
        double y = f->y[i] + reach * sph2d__noise(perturb->seed, index, i - first, 0, 1);
        f->x[i] = sph2d__period_wrap(x, period->low_x, period->length_x);
        f->y[i] = sph2d__period_wrap(y, period->low_y, period->length_y);
    }
}

sph2d_status sph2d__sim_place_fluid(sph2d_sim *sim, sph2d_report *report)
{
    const sph2d_scene *scene = &sim->world.scene;
    sph2d__store *fluid = &sim->system.fluid;
    if (!sph2d__solids_build(&sim->solids, &sim->world, &sim->arena, &sim->memory))
        return SPH2D_NOMEM;
    for (size_t i = 0; i < scene->block_count; ++i) {
        size_t first = fluid->count;
        sph2d_status status = sph2d__sim_place_block(sim, i, report);
        if (status == SPH2D_OK)
            status = sph2d__sim_check_overlap(sim, i, first, report);
        if (status != SPH2D_OK)
            return status;
        perturb_block(sim, i, first);
        char key[64];
        snprintf(key, sizeof key, "blocks[%zu].start", i);
        status = sph2d__sim_start(sim, &scene->blocks[i].start, first, key, true, report);
        if (status != SPH2D_OK)
            return status;
    }
    uint64_t first_single = sim->record.next_id;
    sph2d_status status = place_particles(sim, report);
    if (status == SPH2D_OK && sph2d__starts_from_snapshot(scene))
        status = sph2d__sim_place_snapshot(sim, report);
    if (status != SPH2D_OK)
        return status;
    status = sph2d__openings_fill(sim);
    if (status != SPH2D_OK)
        return status;
    if (fluid->count == 0 && scene->source_count == 0 && scene->opening_count == 0) {
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_NO_PARTICLES, scene->block_count > 0 ? "blocks" : "particles",
                         "the scene has no particles, source or opening");
        return SPH2D_SCENE;
    }
    if (!sph2d__store_reserve(fluid, &sim->memory, 1) ||
        !sph2d__cells_build(&sim->system.fluid_cells, fluid, sim->system.reach, &sim->memory))
        return SPH2D_NOMEM;
    status = sph2d__sim_check_distances(sim, first_single, report);
    return status == SPH2D_OK ? sph2d__sim_check_layers(sim, report) : status;
}
