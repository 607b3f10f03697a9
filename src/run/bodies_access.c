/* SPDX-License-Identifier: MIT */
/** @file bodies_access.c
 *  Bodies and obstacles as callers see and steer them. */
#include <math.h>

#include "scene/shape.h"
#include "sim/simulation.h"

static sph2d_body_state unknown(void)
{
    return (sph2d_body_state){{NAN, NAN}, NAN, {NAN, NAN}, NAN, {NAN, NAN}, NAN};
}

sph2d_body_state sph2d_sim_body(const sph2d_sim *sim, size_t index)
{
    if (!sim || index >= sim->bodies.count)
        return unknown();
    const sph2d__rigid *r = &sim->bodies.items[index];
    const sph2d__rigid_state *s = r->state;
    return (sph2d_body_state){.center = {r->center.x + s->place.x, r->center.y + s->place.y},
                              .angle = s->place.turn,
                              .velocity = {s->velocity.x, s->velocity.y},
                              .rate = s->velocity.turn,
                              .force = {s->liquid.x, s->liquid.y},
                              .torque = s->liquid.turn};
}

sph2d_body_state sph2d_sim_obstacle(const sph2d_sim *sim, size_t index)
{
    if (!sim || index >= sim->world.scene.obstacle_count)
        return unknown();
    const sph2d__wall *wall = &sim->world.walls[SPH2D__WALL_OBSTACLE + index];
    for (size_t k = 0; k < sim->moving_count; ++k)
        if (sim->moving[k].wall == wall) {
            sph2d__pose p = sph2d__moving_at(&sim->moving[k], sim->record.time);
            sph2d_vec2 center = {p.center.x + p.displacement.x, p.center.y + p.displacement.y};
            return (sph2d_body_state){.center = center, .angle = p.angle, .velocity = p.velocity, .rate = p.omega};
        }
    return (sph2d_body_state){.center = sph2d_shape_centroid(&wall->shape)};
}

sph2d_status sph2d_sim_set_body_velocity(sph2d_sim *sim, size_t index, sph2d_vec2 velocity, double rate)
{
    if (!sim || index >= sim->bodies.count || !isfinite(velocity.x) || !isfinite(velocity.y) || !isfinite(rate))
        return SPH2D_INVALID;
    sph2d__rigid *r = &sim->bodies.items[index];
    double before = sph2d__rigid_kinetic(r, r->state->velocity);
    r->state->velocity = (sph2d__twist){r->free.x * velocity.x, r->free.y * velocity.y, r->free.turn * rate};
    sim->record.energy_fed += sph2d__rigid_kinetic(r, r->state->velocity) - before;
    sph2d__bodies_know(sim, false); /* the velocities of its boundary particles, too */
    return SPH2D_OK;
}

sph2d_status sph2d_sim_set_contacts(sph2d_sim *sim, sph2d_contact_solver *solver, void *user)
{
    if (!sim)
        return SPH2D_INVALID;
    sim->bodies.solver = solver;
    sim->bodies.user = user;
    return SPH2D_OK;
}
