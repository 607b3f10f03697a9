/* SPDX-License-Identifier: MIT */
/** @file attach.c
 *  The solver for contacts as a simulation calls it. */
#include "contacts/contacts.h"
#include "sph2d/contacts.h"

static sph2d_status solve(void *user, const sph2d_sim *sim, double dt, sph2d_contact_body *bodies, size_t count,
                          double *wall_work)
{
    (void)user;
    const sph2d_scene *scene = sph2d_sim_scene(sim);
    size_t obstacle_count = scene->obstacle_count;
    sph2d__memory memory = sph2d__memory_from((sph2d_allocator){0});
    sph2d_body_state *obstacles = sph2d__alloc(&memory, obstacle_count, sizeof *obstacles);
    if (obstacle_count > 0 && !obstacles)
        return SPH2D_NOMEM;
    for (size_t i = 0; i < obstacle_count; ++i)
        obstacles[i] = sph2d_sim_obstacle(sim, i);
    sph2d_status status = sph2d__contacts_solve(scene, obstacles, dt, bodies, count, wall_work);
    sph2d__release(&memory, (void **)&obstacles, obstacle_count, sizeof *obstacles);
    return status;
}

sph2d_status sph2d_contacts_attach(sph2d_sim *sim)
{
    return sim ? sph2d_sim_set_contacts(sim, solve, NULL) : SPH2D_INVALID;
}
