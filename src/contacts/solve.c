/* SPDX-License-Identifier: MIT */
/** @file solve.c
 *  The contacts of one step, from bodies to bodies. */
#include <math.h>

#include "contacts/contacts.h"

/* Bodies keep this part of the spacing between them: particles of the liquid, which stop at 0.05 spacings from each
 * surface, then have room where two meet, and are not pressed through a wall; what the iterations leave undone is no
 * overlap; and distances are those of bodies apart, of which Chipmunk knows the normals best. */
#define CLEARANCE 0.2

static bool all_finite(const sph2d__contacts *c)
{
    for (uint32_t i = 0; i < c->body_count; ++i) {
        const sph2d_contact_body *b = &c->bodies[i];
        if (!isfinite(b->center.x) || !isfinite(b->center.y) || !isfinite(b->angle) || !isfinite(b->velocity.x) ||
            !isfinite(b->velocity.y) || !isfinite(b->rate))
            return false;
    }
    return true;
}

static sph2d_status run(sph2d__contacts *c)
{
    if (!all_finite(c))
        return SPH2D_INVALID;
    sph2d_status status = sph2d__place_all(c);
    if (status == SPH2D_OK)
        status = sph2d__find_pairs(c);
    if (status == SPH2D_OK)
        status = sph2d__find_contacts(c);
    if (status != SPH2D_OK || c->contact_count == 0)
        return status;
    sph2d__groups groups = {0};
    status = sph2d__find_groups(c, &groups);
    return status == SPH2D_OK ? sph2d__relax(c, &groups) : status;
}

sph2d_status sph2d__contacts_solve(const sph2d_scene *scene, const sph2d_body_state *obstacles, double dt,
                                   sph2d_contact_body *bodies, size_t count, double *wall_work)
{
    if (count == 0 || !(dt > 0))
        return SPH2D_OK;
    sph2d__contacts c = {.scene = scene, .obstacles = obstacles, .dt = dt, .bodies = bodies, .wall_work = wall_work};
    c.body_count = (uint32_t)count;
    c.clearance = CLEARANCE * scene->spacing;
    c.memory = sph2d__memory_from((sph2d_allocator){0});
    sph2d_status status = run(&c);
    sph2d__free_pieces(&c);
    sph2d__release(&c.memory, (void **)&c.contacts, c.contact_room, sizeof *c.contacts);
    sph2d__release(&c.memory, (void **)&c.pairs, c.pair_room, sizeof *c.pairs);
    sph2d__release(&c.memory, (void **)&c.placed, c.placed_room, sizeof *c.placed);
    sph2d__arena_free(&c.arena, &c.memory);
    return status;
}
