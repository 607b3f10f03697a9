/* SPDX-License-Identifier: MIT */
/** @file summary.c
 *  The summary of a run: compression, energy, momentum, counts. */
#include <math.h>

#include "methods/common/on_device.h"
#include "run/run.h"

/* Compression is sampled every so many steps, but not for a time after an impact [s]. */
enum { SAMPLE_STEPS = 10, BINS = 2048 };
static const double IMPACT_WINDOW = 0.05;

static bool in_impact(const sph2d_sim *sim)
{
    for (size_t i = 0; i < sim->world.scene.run.impacts.count; ++i) {
        double since = sim->record.time - sim->world.scene.run.impacts.items[i];
        if (since >= 0 && since < IMPACT_WINDOW)
            return true;
    }
    return false;
}

static double compression_of(const sph2d__system *s, size_t i)
{
    double c = s->fluid.density[i] / s->rest_density - 1;
    return c > 0 ? c : 0;
}

/** 99th percentile over particles, to 1/2048 of the largest value, from a histogram. */
static double percentile_99(const sph2d__system *s, double largest)
{
    if (!(largest > 0))
        return 0;
    size_t bins[BINS] = {0};
    for (size_t i = 0; i < s->fluid.count; ++i) {
        size_t bin = (size_t)(compression_of(s, i) / largest * BINS);
        ++bins[bin < BINS ? bin : BINS - 1];
    }
    size_t above = s->fluid.count / 100, seen = 0, bin = BINS;
    while (bin > 0 && seen + bins[bin - 1] <= above)
        seen += bins[--bin];
    return largest * (double)bin / BINS;
}

void sph2d__sim_sample(sph2d_sim *sim)
{
    const sph2d__system *s = &sim->system;
    sph2d__record *r = &sim->record;
    if (r->steps % SAMPLE_STEPS != 0)
        return;
    double span = r->time - r->sample_time;
    r->sample_time = r->time;
    if (in_impact(sim) || s->fluid.count == 0)
        return;
    sph2d__host_reads(s, SPH2D__BIT(density));
    double largest = 0, sum = 0;
    for (size_t i = 0; i < s->fluid.count; ++i) {
        double c = compression_of(s, i);
        sum += c;
        largest = c > largest ? c : largest;
    }
    r->compression_p99 += span * percentile_99(s, largest);
    r->compression_mean += span * sum / (double)s->fluid.count;
    r->sampled_time += span;
}

/* Particles nearer than this to another, in spacings, act as one: wherever the nearest of a lattice were, these fell
 * together. */
static const double PAIRED = 0.3;

/** Sets the mean number of neighbours within the support radius, and the number of paired particles. */
static void count_neighbours(const sph2d__system *s, sph2d_summary *out)
{
    const sph2d__store *f = &s->fluid;
    double support2 = s->support * s->support, near2 = pow(PAIRED * s->spacing, 2);
    size_t pairs = 0;
    for (size_t i = 0; i < f->count; ++i) {
        uint32_t cell = sph2d__cells_find(&s->fluid_cells, f->x[i], f->y[i]);
        if (cell == UINT32_MAX)
            continue;
        sph2d__ranges ranges;
        sph2d__cells_ranges(&s->fluid_cells, cell, &ranges);
        double nearest2 = INFINITY;
        SPH2D__FOR_NEIGHBOURS (&ranges, r, j) {
            double dx = f->x[i] + ranges.x[r] - f->x[j], dy = f->y[i] + ranges.y[r] - f->y[j], r2 = dx * dx + dy * dy;
            pairs += j != i && r2 < support2;
            nearest2 = j != i ? fmin(nearest2, r2) : nearest2;
        }
        out->paired += nearest2 < near2;
    }
    out->neighbours = f->count > 0 ? (double)pairs / (double)f->count : 0;
}

sph2d_summary sph2d_sim_summary(const sph2d_sim *sim)
{
    if (!sim)
        return (sph2d_summary){0};
    sph2d__host_reads(&sim->system, SPH2D__EVERYTHING);
    const sph2d__record *r = &sim->record;
    double time = r->sampled_time > 0 ? r->sampled_time : 1;
    sph2d_summary out = {
        .time = r->time,
        .steps = r->steps,
        .particle_steps = r->particle_steps,
        .particles = sim->system.fluid.count,
        .compression_p99 = r->compression_p99 / time,
        .compression_mean = r->compression_mean / time,
        .compression_max = r->compression_max,
        .density_apart = r->density_apart,
        .energy_start = r->energy_start,
        .energy_fed = r->energy_fed,
        .energy_rise = sph2d__sim_rise_is_known(sim) ? r->energy_rise : NAN,
        .energy_error = sph2d__sim_error_is_known(sim) ? r->energy_error : NAN,
        .energy_error_rise = sph2d__sim_error_is_known(sim) ? r->error_rise : NAN,
        .energy_walls = r->energy_walls,
        .energy_forces = r->energy_forces,
        .energy_viscous = r->energy_viscous,
        .energy_diffused = r->energy_diffused,
        .energy_stopped = r->energy_stopped,
        .energy_contacts = r->energy_contacts,
        .energy_pressed = r->energy_pressed,
        .energy_scale = sph2d__sim_energy_scale(sim),
        .fed = r->fed,
        .blocked = r->blocked,
        .drained = r->drained,
        .let_in = r->let_in,
        .let_out = r->let_out,
        .left_open = {r->left_left, r->left_right, r->left_bottom, r->left_top},
        .backstop_hits = r->backstop_hits,
        .reflections = r->reflections,
        .iterations = r->iterations,
        .unconverged = r->unconverged,
        .limited_by = {r->limited_acoustic, r->limited_force, r->limited_viscous, r->limited_fixed},
        .time_step_min = r->step_min,
        .time_step_max = r->step_max,
        .kinetic_max = r->kinetic_max,
        .momentum_error = {r->momentum_error_x, r->momentum_error_y},
        .momentum_error_max = r->momentum_worst,
        .momentum_moved = r->momentum_moved,
        .neighbours = NAN,
    };
    if (!sph2d__sim_momentum_is_known(sim))
        out.momentum_error[0] = out.momentum_error[1] = out.momentum_error_max = NAN;
    if (!sph2d__sim_is_broken(sim))
        count_neighbours(&sim->system, &out);
    sph2d__sim_sum_energy(sim, &out);
    return out;
}

sph2d_profile sph2d_sim_profile(const sph2d_sim *sim)
{
    if (!sim)
        return (sph2d_profile){0};
    return sim->system.profile.sums;
}
