/* SPDX-License-Identifier: MIT */
/** @file output_schedule.c
 *  Which outputs are due. */
#include "probes/probes.h"

static sph2d_rate rate_of(const sph2d_sim *sim, size_t output)
{
    if (output == SPH2D_OUTPUT_SNAPSHOT)
        return sim->world.scene.run.snapshots.rate;
    if (output == SPH2D_OUTPUT_FRAME)
        return sim->world.scene.run.frames.rate;
    if (output - SPH2D_OUTPUT_PROBE < sim->world.scene.probe_count)
        return sim->world.scene.probes[output - SPH2D_OUTPUT_PROBE].rate;
    return (sph2d_rate){0, 0};
}

/* The clock is a sum of steps: the tolerance for its rounding at a due time. */
static const double REACHED = 1 + 1e-12;

bool sph2d_sim_output_due(const sph2d_sim *sim, size_t output)
{
    if (!sim)
        return false;
    sph2d_rate rate = rate_of(sim, output);
    if (sph2d_rate_interval(rate) <= 0)
        return false;
    return sim->record.time * REACHED >= sph2d_rate_due(rate, sim->output_counts[output]);
}

uint64_t sph2d_sim_output_count(const sph2d_sim *sim, size_t output)
{
    if (!sim)
        return 0;
    return output < SPH2D_OUTPUT_PROBE + sim->world.scene.probe_count ? sim->output_counts[output] : 0;
}

void sph2d_sim_output_done(sph2d_sim *sim, size_t output)
{
    if (!sim)
        return;
    if (output >= SPH2D_OUTPUT_PROBE + sim->world.scene.probe_count)
        return;
    ++sim->output_counts[output];
    if (output < SPH2D_OUTPUT_PROBE)
        return;
    sph2d__loads_sampled(sim, output - SPH2D_OUTPUT_PROBE);
    sph2d__tracers_sampled(sim, output - SPH2D_OUTPUT_PROBE);
}
