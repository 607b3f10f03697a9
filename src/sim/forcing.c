/* SPDX-License-Identifier: MIT */
/** @file forcing.c
 *  Time-dependent forcing: interactions, the pointer, moving obstacles. */
#include "methods/common/on_device.h"
#include "scene/frame.h"
#include "sim/simulation.h"

bool sph2d__path_at(const sph2d_path *path, double time, sph2d_vec2 *at)
{
    const sph2d_path_point *p = path->items;
    if (path->count == 1) {
        *at = (sph2d_vec2){p[0].x, p[0].y};
        return true;
    }
    for (size_t k = 1; k < path->count; ++k) {
        if (time < p[k - 1].t || time > p[k].t)
            continue;
        double f = (time - p[k - 1].t) / (p[k].t - p[k - 1].t);
        *at = (sph2d_vec2){p[k - 1].x + f * (p[k].x - p[k - 1].x), p[k - 1].y + f * (p[k].y - p[k - 1].y)};
        return true;
    }
    return false;
}

void sph2d__sim_set_drift_interval(sph2d_sim *sim, double from, double to)
{
    for (size_t k = 0; k < sim->moving_count; ++k)
        sph2d__moving_set_drift(&sim->moving[k], from, to);
}

/** Moves the boundary particles of moving obstacles, and sorts all of them, starting from the order of their ids, so
 *  that the result depends only on their positions, not on previous sorts. */
static bool move_walls(sph2d_sim *sim, double time)
{
    sph2d__system *s = &sim->system;
    for (size_t i = 0; i < s->walls.count; ++i)
        s->wall_cells.order[s->walls.id[i]] = (uint32_t)i;
    sph2d__store_reorder(&s->walls, s->wall_cells.order);
    for (size_t k = 0; k < sim->moving_count; ++k)
        sph2d__moving_place(&sim->moving[k], time, &s->walls, &s->wall_cells.period);
    bool sorted = sph2d__cells_build(&s->wall_cells, &s->walls, s->wall_reach, s->memory);
    sph2d__host_changed_walls(s, SPH2D__EVERYTHING);
    sph2d__bodies_index(sim, time);
    return sorted;
}

/** Sets the forces on the liquid at a time. */
static void set_forces(sph2d_sim *sim, const sph2d__steering *by, double time)
{
    sph2d__forces *forces = &sim->system.forces;
    size_t count = 0;
    for (size_t i = 0; i < sim->world.scene.interaction_count; ++i) {
        const sph2d_interaction *force = &sim->world.scene.interactions[i];
        sph2d_vec2 at;
        if (sph2d__path_at(&force->path, time, &at))
            sim->points[count++] = (sph2d__point_force){at.x, at.y, force->radius, force->acceleration};
    }
    if (by->pointer_acceleration != 0)
        sim->points[count++] =
            (sph2d__point_force){by->pointer_x, by->pointer_y, by->pointer_radius, by->pointer_acceleration};
    forces->points = (sph2d__points){sim->points, count};
    if (count > 0)
        sph2d__host_changed_points(&sim->system);
    forces->gravity.x = by->gravity_x;
    forces->gravity.y = by->gravity_y;
    forces->frame = sph2d__frame_at(&sim->world.scene, &sim->tank, time);
}

static sph2d__steering steering_of(const sph2d__record *r)
{
    return (sph2d__steering){r->gravity_x, r->gravity_y,      r->pointer_x,
                             r->pointer_y, r->pointer_radius, r->pointer_acceleration};
}

void sph2d__sim_steer(sph2d_sim *sim)
{
    const sph2d__steering by = steering_of(&sim->record);
    set_forces(sim, &by, sim->record.time);
    sim->momentum_kept = 0;
}

void sph2d__sim_act(sph2d_sim *sim)
{
    sim->acting = steering_of(&sim->record);
}

bool sph2d__sim_is_steered(const sph2d_sim *sim)
{
    const sph2d__steering by = steering_of(&sim->record), *acting = &sim->acting;
    return by.gravity_x != acting->gravity_x || by.gravity_y != acting->gravity_y ||
           by.pointer_x != acting->pointer_x || by.pointer_y != acting->pointer_y ||
           by.pointer_radius != acting->pointer_radius || by.pointer_acceleration != acting->pointer_acceleration;
}

sph2d_status sph2d__sim_repeat_forcing(sph2d_sim *sim, double time)
{
    set_forces(sim, &sim->acting, time);
    if (sim->moving_count == 0)
        return SPH2D_OK;
    if (!move_walls(sim, time))
        return SPH2D_NOMEM;
    sph2d__bodies_expect(sim, time);
    if (sim->method->walls_placed)
        sim->method->walls_placed(&sim->system);
    return SPH2D_OK;
}

sph2d_status sph2d__sim_update_forcing(sph2d_sim *sim, double time)
{
    sph2d__sim_act(sim);
    return sph2d__sim_repeat_forcing(sim, time);
}
