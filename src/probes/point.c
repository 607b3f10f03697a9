/* SPDX-License-Identifier: MIT */
/** @file point.c
 *  Probes at a point: velocity, pressure. */
#include <math.h>

#include "probes/probes.h"

size_t sph2d__probe_speed(const sph2d_sim *sim, const sph2d_probe *probe, double *values)
{
    sph2d_sample sample;
    sph2d_sim_sample(sim, probe->at, &sample);
    values[0] = sample.velocity[0];
    values[1] = sample.velocity[1];
    values[2] = hypot(sample.velocity[0], sample.velocity[1]);
    values[3] = sample.neighbours;
    return 4;
}

size_t sph2d__probe_pressure(const sph2d_sim *sim, const sph2d_probe *probe, double *values)
{
    sph2d_sample sample;
    sph2d_sim_sample(sim, probe->at, &sample);
    bool gauge = probe->size > 0 || probe->rise_time > 0;
    values[0] = gauge ? sph2d__gauge_reading(sim, (size_t)(probe - sim->world.scene.probes)) : sample.pressure;
    values[1] = sample.density;
    values[2] = sample.neighbours;
    return 3;
}
