/* SPDX-License-Identifier: MIT */
/** @file probes.c
 *  Time series: energy of the whole, velocity at a point. */
#include <math.h>

#include "kernels/muller.h"
#include "sim/simulation.h"

const char *sph2d_probe_columns(sph2d_probe_kind kind)
{
    switch (kind) {
    case SPH2D_PROBE_ENERGY:
        return "kinetic [J/m],potential [J/m],momentum_x [kg/s],momentum_y [kg/s],particles,speed_max [m/s]";
    case SPH2D_PROBE_SPEED:
        return "vx [m/s],vy [m/s],speed [m/s],neighbours";
    }
    return "";
}

static size_t probe_energy(const sph2d_sim *sim, double *values)
{
    sph2d_summary sum;
    sph2d__sim_sum_energy(sim, &sum);
    values[0] = sum.kinetic;
    values[1] = sum.potential;
    values[2] = sum.momentum[0];
    values[3] = sum.momentum[1];
    values[4] = (double)sim->system.fluid.count;
    values[5] = sum.speed_max;
    return 6;
}

/** Shepard average of the velocity over the particles within the support. */
static size_t probe_speed(const sph2d_sim *sim, sph2d_vec2 at, double *values)
{
    const sph2d__system *s = &sim->system;
    const sph2d__store *f = &s->fluid;
    double weight = 0, vx = 0, vy = 0, neighbours = 0;
    uint32_t cell = f->count > 0 ? sph2d__cells_find(&s->fluid_cells, at.x, at.y) : UINT32_MAX;
    if (cell != UINT32_MAX) {
        sph2d__ranges ranges = sph2d__cells_ranges(&s->fluid_cells, cell);
        SPH2D__FOR_NEIGHBOURS (&ranges, r, j) {
            double dx = at.x + ranges.x[r] - f->x[j], dy = at.y + ranges.y[r] - f->y[j];
            double w = sph2d__poly6_shape(s->support * s->support, dx * dx + dy * dy);
            weight += w;
            vx += w * f->vx[j];
            vy += w * f->vy[j];
            neighbours += w > 0;
        }
    }
    values[0] = weight > 0 ? vx / weight : NAN;
    values[1] = weight > 0 ? vy / weight : NAN;
    values[2] = weight > 0 ? hypot(values[0], values[1]) : NAN;
    values[3] = neighbours;
    return 4;
}

size_t sph2d_sim_probe(const sph2d_sim *sim, size_t index, double values[SPH2D_PROBE_MAX_COLUMNS])
{
    if (index >= sim->scene.probe_count)
        return 0;
    const sph2d_probe *probe = &sim->scene.probes[index];
    return probe->kind == SPH2D_PROBE_SPEED ? probe_speed(sim, probe->at, values) : probe_energy(sim, values);
}

/* ---- what is due ------------------------------------------------------------------------------------------------- */

static sph2d_rate rate_of(const sph2d_sim *sim, size_t output)
{
    if (output == SPH2D_OUTPUT_SNAPSHOT)
        return sim->scene.run.snapshots.rate;
    if (output == SPH2D_OUTPUT_FRAME)
        return sim->scene.run.frames.rate;
    if (output - SPH2D_OUTPUT_PROBE < sim->scene.probe_count)
        return sim->scene.probes[output - SPH2D_OUTPUT_PROBE].rate;
    return (sph2d_rate){0, 0};
}

/* The clock is a sum of steps: a due time that it misses by rounding alone is reached. */
static const double REACHED = 1 + 1e-12;

bool sph2d_sim_output_due(const sph2d_sim *sim, size_t output)
{
    sph2d_rate rate = rate_of(sim, output);
    if (sph2d_rate_interval(rate) <= 0)
        return false;
    return sim->record.time * REACHED >= sph2d_rate_due(rate, sim->output_counts[output]);
}

uint64_t sph2d_sim_output_count(const sph2d_sim *sim, size_t output)
{
    return output < SPH2D_OUTPUT_PROBE + sim->scene.probe_count ? sim->output_counts[output] : 0;
}

void sph2d_sim_output_done(sph2d_sim *sim, size_t output)
{
    if (output < SPH2D_OUTPUT_PROBE + sim->scene.probe_count)
        ++sim->output_counts[output];
}
