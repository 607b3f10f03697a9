/* SPDX-License-Identifier: MIT */
/** @file opening.c
 *  Probes of what flows through an opening. */
#include "probes/probes.h"

size_t sph2d__probe_opening(const sph2d_sim *sim, const sph2d_probe *probe, double *values)
{
    const sph2d_opening *opening = sph2d__opening_named(&sim->world.scene, probe->on);
    sph2d__opening_read(sim, (size_t)(opening - sim->world.scene.openings), values);
    return SPH2D__OPENING_READINGS;
}
