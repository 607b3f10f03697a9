/* SPDX-License-Identifier: MIT */
/** @file openings.c
 *  Openings at run time: made, told from the rest of the liquid, and read by probes. */
#include "sim/openings.h"

#include <math.h>

#include "sim/openings_parts.h"
#include "sim/simulation.h"

/* ---- making ------------------------------------------------------------------------------------------------------ */

void sph2d__opening_set_line(const sph2d_sim *sim, sph2d__opening *o, double beyond)
{
    sph2d__mouth m = sph2d__opening_mouth(&sim->world.scene, o->given);
    o->middle = (sph2d_vec2){m.start.x + m.width / 2 * m.along.x, m.start.y + m.width / 2 * m.along.y};
    m.start = (sph2d_vec2){m.start.x - beyond * m.inward.x, m.start.y - beyond * m.inward.y};
    o->mouth = m;
}

static bool make_lanes(sph2d_sim *sim, sph2d__opening *o)
{
    double dx = sim->world.scene.spacing;
    o->kind = sph2d__opening_kind_of(o->given);
    o->has_velocity = sph2d__opening_has_velocity(o->given);
    o->has_surface = sph2d__opening_has_surface(o->given);
    o->duct = o->has_velocity ? 0 : SPH2D__DUCT * dx;
    sph2d__opening_set_line(sim, o, o->duct);
    o->lane_count = (size_t)fmax(floor(o->mouth.width / dx + 0.5), 1);
    o->lane_width = o->mouth.width / (double)o->lane_count;
    o->stride = dx * dx / o->lane_width;
    o->depth = (double)sph2d__reservoir_rows(&sim->world.scene) * dx;
    o->lanes = sph2d__arena_alloc(&sim->arena, &sim->memory, o->lane_count, sizeof *o->lanes);
    o->outermost = sph2d__arena_alloc(&sim->arena, &sim->memory, o->lane_count, sizeof *o->outermost);
    return o->lanes && o->outermost;
}

sph2d_status sph2d__openings_create(sph2d_sim *sim)
{
    sph2d__openings *all = &sim->openings;
    size_t count = sim->world.scene.opening_count;
    if (count == 0)
        return SPH2D_OK;
    all->items = sph2d__arena_alloc(&sim->arena, &sim->memory, count, sizeof *all->items);
    if (!all->items)
        return SPH2D_NOMEM;
    all->means = sph2d__arena_alloc(&sim->arena, &sim->memory, count, sizeof *all->means);
    if (!all->means)
        return SPH2D_NOMEM;
    for (size_t k = 0; k < count; ++k) {
        all->items[k].given = &sim->world.scene.openings[k];
        all->items[k].means = &all->means[k];
        if (!make_lanes(sim, &all->items[k]))
            return SPH2D_NOMEM;
    }
    all->count = count;
    return SPH2D_OK;
}

/* ---- places ------------------------------------------------------------------------------------------------------ */

/** Particles that walls push a little beyond the ends still belong to it. */
static bool is_beyond(const sph2d__opening *o, sph2d__spot s)
{
    return s.beyond > 0 && s.along > -o->lane_width && s.along < o->mouth.width + o->lane_width;
}

const sph2d__opening *sph2d__opening_at(const sph2d_sim *sim, double x, double y)
{
    for (size_t k = 0; k < sim->openings.count; ++k)
        if (is_beyond(&sim->openings.items[k], sph2d__spot_of(&sim->openings.items[k], x, y)))
            return &sim->openings.items[k];
    return NULL;
}

/* ---- what probes tell -------------------------------------------------------------------------------------------- */

double sph2d__opening_particles(const sph2d_sim *sim, const sph2d__opening *o)
{
    double count = 0;
    for (size_t i = 0; i < sim->system.fluid.count; ++i)
        count += sph2d__opening_at(sim, sim->system.fluid.x[i], sim->system.fluid.y[i]) == o;
    return count;
}

void sph2d__opening_read(const sph2d_sim *sim, size_t index, double values[SPH2D__OPENING_READINGS])
{
    const sph2d__opening *o = &sim->openings.items[index];
    double area = sim->world.scene.spacing * sim->world.scene.spacing;
    sph2d__openings_measure(sim);
    double wet = o->has_surface ? o->now.depth : (double)o->wet_lanes * o->lane_width;
    double kept = sph2d__opening_particles(sim, o) - o->means->first;
    values[0] = o->wet ? o->now.velocity : NAN;
    values[1] = wet * o->now.velocity;
    values[2] = (o->means->came - o->means->left - kept) * area;
    values[3] = o->wet ? o->now.pressure + o->means->slope * o->duct : NAN;
    values[4] = wet;
}
