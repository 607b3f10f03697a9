/* SPDX-License-Identifier: MIT */
/** @file body.c
 *  Probes of a body: where it is, how it moves, and the force of the liquid. */
#include "probes/probes.h"

size_t sph2d__probe_body(const sph2d_sim *sim, const sph2d_probe *probe, double *values)
{
    const int wall = sph2d__wall_named(&sim->world, probe->on);
    const sph2d__rigid *r = &sim->bodies.items[sim->world.walls[wall].index];
    const sph2d__rigid_state *now = r->state;
    const double all[] = {r->center.x + now->place.x,
                          r->center.y + now->place.y,
                          now->place.turn,
                          now->velocity.x,
                          now->velocity.y,
                          now->velocity.turn,
                          now->liquid.x,
                          now->liquid.y,
                          now->liquid.turn,
                          sph2d__body_energy(sim, r)};
    const size_t count = sizeof all / sizeof *all;
    for (size_t k = 0; k < count; ++k)
        values[k] = all[k];
    return count;
}
