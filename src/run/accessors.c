/* SPDX-License-Identifier: MIT */
/** @file accessors.c
 *  Accessors of a simulation's values, and steering during a run. */
#include <math.h>

#include "base/null.h"
#include "device/device.h"
#include "methods/common/on_device.h"
#include "run/run.h"
#include "sim/device_steps.h"
#include "sim/simulation.h"
#include "sph2d/device.h"

sph2d_status sph2d_sim_set_gravity(sph2d_sim *sim, sph2d_vec2 gravity)
{
    if (!sim)
        return SPH2D_INVALID;
    if (!isfinite(gravity.x) || !isfinite(gravity.y))
        return SPH2D_INVALID;
    sph2d_summary before, after;
    sph2d__sim_sum_energy(sim, &before);
    sim->record.gravity_x = gravity.x;
    sim->record.gravity_y = gravity.y;
    sph2d__sim_steer(sim);
    sph2d__sim_sum_energy(sim, &after);
    sim->record.energy_fed += after.potential - before.potential;
    return SPH2D_OK;
}

sph2d_status sph2d_sim_set_pointer(sph2d_sim *sim, sph2d_vec2 at, double radius, double acceleration)
{
    if (!sim)
        return SPH2D_INVALID;
    if (!isfinite(at.x) || !isfinite(at.y) || !isfinite(acceleration) || !isfinite(radius))
        return SPH2D_INVALID;
    if (acceleration != 0 ? !(radius > 0) : !(radius >= 0))
        return SPH2D_INVALID;
    sim->record.pointer_x = at.x;
    sim->record.pointer_y = at.y;
    sim->record.pointer_radius = radius;
    sim->record.pointer_acceleration = acceleration;
    sph2d__sim_steer(sim);
    return SPH2D_OK;
}

double sph2d_sim_time(const sph2d_sim *sim)
{
    if (!sim)
        return 0;
    return sim->record.time;
}

uint64_t sph2d_sim_steps(const sph2d_sim *sim)
{
    if (!sim)
        return 0;
    return sim->record.steps;
}

double sph2d_sim_time_step(const sph2d_sim *sim)
{
    if (!sim)
        return 0;
    return sim->record.next_step;
}

sph2d_isa sph2d_sim_isa(const sph2d_sim *sim)
{
    if (!sim)
        return SPH2D_ISA_AUTO;
    return sim->system.isa;
}

int sph2d_sim_threads(const sph2d_sim *sim)
{
    if (!sim)
        return 0;
    return sph2d__sim_threads(sim);
}

size_t sph2d_sim_memory(const sph2d_sim *sim)
{
    if (!sim)
        return 0;
    return sim->memory.bytes;
}

sph2d_device_use sph2d_sim_device_use(const sph2d_sim *sim)
{
    return sim && sph2d__is_on_device(&sim->system) ? sph2d__device_used(sim->system.device) : (sph2d_device_use){0};
}

size_t sph2d_sim_device_memory(const sph2d_sim *sim)
{
    return sim && sph2d__is_on_device(&sim->system) ? sph2d__device_bytes(sim->system.device) : 0;
}

sph2d_status sph2d_sim_device_status(const sph2d_sim *sim, sph2d_report *report)
{
    return sim ? sph2d__device_check(sim, report) : sph2d__null(report, __func__, "sim");
}

const sph2d_scene *sph2d_sim_scene(const sph2d_sim *sim)
{
    if (!sim)
        return NULL;
    return &sim->world.scene;
}

const sph2d_plan *sph2d_sim_plan(const sph2d_sim *sim)
{
    if (!sim)
        return NULL;
    return &sim->plan;
}

static sph2d_view view_of(const sph2d__store *s)
{
    return (sph2d_view){s->count, s->x, s->y, s->vx, s->vy, s->ax, s->ay, s->density, s->pressure, s->id};
}

size_t sph2d_sim_count(const sph2d_sim *sim)
{
    return sim ? sim->system.fluid.count : 0;
}

sph2d_view sph2d_sim_fluid(const sph2d_sim *sim)
{
    const sph2d__set shown =
        SPH2D__STORE_BASIC | SPH2D__BIT(ax) | SPH2D__BIT(ay) | SPH2D__BIT(density) | SPH2D__BIT(pressure) | SPH2D__IDS;
    if (!sim)
        return (sph2d_view){0};
    sph2d__host_reads(&sim->system, shown);
    return view_of(&sim->system.fluid);
}

sph2d_view sph2d_sim_walls(const sph2d_sim *sim)
{
    if (!sim)
        return (sph2d_view){0};
    sph2d__host_reads_walls(&sim->system);
    sph2d_view view = view_of(&sim->system.walls);
    view.ax = view.ay = NULL;
    return view;
}
