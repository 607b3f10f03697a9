/* SPDX-License-Identifier: MIT */
/** @file edit.c
 *  Liquid that a program adds and removes between steps. Energy counts as that of sources and drains. */
#include <math.h>

#include "methods/common/on_device.h"
#include "run/run.h"
#include "scene/liquid.h"
#include "scene/shape.h"

/** Whether a position lies in a solid, where this is now. */
static bool in_solid(const sph2d_sim *sim, sph2d_vec2 at)
{
    for (size_t k = SPH2D__WALL_OBSTACLE; k < sim->world.wall_count; ++k) {
        const sph2d__wall *wall = &sim->world.walls[k];
        sph2d__pose pose = sph2d__sim_pose_of(sim, wall);
        if (sph2d__wall_fills(&sim->world.scene, wall, sph2d__pose_invert(&pose, at)))
            return true;
    }
    return false;
}

static void add_one(sph2d_sim *sim, const sph2d_particle *p)
{
    sph2d__store *fluid = &sim->system.fluid;
    double rest = sim->world.scene.fluid.density;
    size_t i = sph2d__sim_add_liquid(sim, (sph2d_vec2){p->x, p->y}, NULL);
    if (fluid->colored && p->color > 0)
        fluid->color[i] = (uint64_t)p->color;
    fluid->density[i] = p->density > 0 ? p->density : rest;
    fluid->vx[i] = p->vx;
    fluid->vy[i] = p->vy;
    sph2d__forces_add(&sim->system.forces, (sph2d__place){p->x, p->y, p->vx, p->vy}, &fluid->ax[i], &fluid->ay[i]);
    sim->record.energy_fed += sph2d__sim_energy_of(sim, p->x, p->y, p->vx, p->vy);
    ++sim->record.fed;
}

static bool is_particle(const sph2d_particle *p)
{
    return isfinite(p->x) && isfinite(p->y) && isfinite(p->vx) && isfinite(p->vy) && p->density >= 0 &&
           isfinite(p->density) && sph2d__is_color(p->color);
}

/** Makes the simulation as it is between steps: sorted. */
static sph2d_status settle(sph2d_sim *sim)
{
    sph2d__sim_act(sim);
    return sph2d__sim_sort_all_arrays(sim);
}

sph2d_status sph2d_sim_add_particles(sph2d_sim *sim, const sph2d_particle *particles, size_t count, size_t *added)
{
    if (added)
        *added = 0;
    if (!sim || (count > 0 && !particles))
        return SPH2D_INVALID;
    if (sim->stopped != SPH2D_OK)
        return sim->stopped;
    for (size_t k = 0; k < count; ++k)
        if (!is_particle(&particles[k]))
            return SPH2D_INVALID;
    sph2d__store *fluid = &sim->system.fluid;
    size_t before = fluid->count;
    sph2d__host_reads(&sim->system, SPH2D__EVERYTHING);
    if (count > SPH2D__MAX_PARTICLES - before || !sph2d__fluid_reserve(&sim->system, before + count))
        return SPH2D_NOMEM;
    for (size_t k = 0; k < count; ++k) {
        sph2d_vec2 at = {particles[k].x, particles[k].y};
        if (sph2d__sim_has_room(sim, before, at, at.x, at.y) && !in_solid(sim, at))
            add_one(sim, &particles[k]);
    }
    if (added)
        *added = fluid->count - before;
    if (fluid->count == before)
        return SPH2D_OK;
    sph2d__host_changed(&sim->system, SPH2D__EVERYTHING);
    sim->none_left = false;
    sph2d_status status = sph2d__sim_book_new_surface(sim, before);
    return status == SPH2D_OK ? settle(sim) : status;
}

static bool is_point(sph2d_vec2 p)
{
    return isfinite(p.x) && isfinite(p.y);
}

static bool is_shape(const sph2d_shape *shape)
{
    enum { MOST_CORNERS = 10000 };
    const sph2d_box *b = &shape->box;
    const sph2d_points *corners = &shape->points;
    switch (shape->kind) {
    case SPH2D_SHAPE_BOX:
        return is_point(b->min) && is_point(b->max) && b->min.x < b->max.x && b->min.y < b->max.y;
    case SPH2D_SHAPE_CIRCLE:
        return is_point(shape->circle.center) && shape->circle.radius > 0 && isfinite(shape->circle.radius);
    case SPH2D_SHAPE_POLYGON:
        if (!corners->items || corners->count < 3 || corners->count > MOST_CORNERS)
            return false;
        for (size_t k = 0; k < corners->count; ++k)
            if (!is_point(corners->items[k]))
                return false;
        return true;
    case SPH2D_SHAPE_LINE:
    case SPH2D_SHAPE_POLYLINE:
    case SPH2D_SHAPE_ARC:
    case SPH2D_SHAPE_SVG:
    case SPH2D_SHAPE_NONE:
        break;
    }
    return false;
}

sph2d_status sph2d_sim_remove_particles(sph2d_sim *sim, const sph2d_shape *shape, size_t *removed)
{
    if (removed)
        *removed = 0;
    if (!sim || !shape || !is_shape(shape))
        return SPH2D_INVALID;
    if (sim->stopped != SPH2D_OK)
        return sim->stopped;
    if (!sph2d__sim_reserve_flags(sim))
        return SPH2D_NOMEM;
    const sph2d__store *f = &sim->system.fluid;
    size_t count = 0;
    sph2d__host_reads(&sim->system, SPH2D__BIT(x) | SPH2D__BIT(y));
    for (size_t i = 0; i < f->count; ++i) {
        sim->to_remove[i] = sph2d__shape_contains(shape, (sph2d_vec2){f->x[i], f->y[i]});
        count += sim->to_remove[i];
    }
    if (removed)
        *removed = count;
    if (count == 0)
        return SPH2D_OK;
    sim->record.momentum_changes = SPH2D__MOMENTUM_CUT;
    sph2d_status status = sph2d__sim_remove_flagged(sim);
    return status == SPH2D_OK ? settle(sim) : status;
}
