/* SPDX-License-Identifier: MIT */
/** @file force.c
 *  Probes of walls: forces of the liquid, and their work (sim/loads.h). */
#include "probes/probes.h"
#include "sim/loads.h"

static const sph2d__load_state *load_of(const sph2d_sim *sim, const sph2d_probe *probe)
{
    return &sim->loads.states[sim->loads.of_probe[probe - sim->world.scene.probes]];
}

size_t sph2d__probe_force(const sph2d_sim *sim, const sph2d_probe *probe, double *values)
{
    const sph2d__load_state *l = load_of(sim, probe);
    const sph2d__pull contact = {l->springs.x + l->contact.x, l->springs.y + l->contact.y,
                                 l->springs.torque + l->contact.torque};
    values[0] = l->pressure.x + l->friction.x + contact.x;
    values[1] = l->pressure.y + l->friction.y + contact.y;
    values[2] = l->pressure.torque + l->friction.torque + contact.torque;
    values[3] = l->pressure.x;
    values[4] = l->pressure.y;
    values[5] = l->friction.x;
    values[6] = l->friction.y;
    values[7] = contact.x;
    values[8] = contact.y;
    values[9] = l->impulse.x;
    values[10] = l->impulse.y;
    values[11] = l->impulse.torque;
    return 12;
}

size_t sph2d__probe_work(const sph2d_sim *sim, const sph2d_probe *probe, double *values)
{
    values[0] = load_of(sim, probe)->power;
    values[1] = load_of(sim, probe)->work;
    return 2;
}
