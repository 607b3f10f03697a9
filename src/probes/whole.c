/* SPDX-License-Identifier: MIT */
/** @file whole.c
 *  Probes of the liquid as a whole: energy, momentum, extent, principal axes. */
#include <math.h>

#include "probes/probes.h"

size_t sph2d__probe_energy(const sph2d_sim *sim, const sph2d_probe *probe, double *values)
{
    (void)probe;
    sph2d_summary sum;
    sph2d__sim_sum_energy(sim, &sum);
    values[0] = sum.kinetic;
    values[1] = sum.potential;
    values[2] = sum.momentum[0];
    values[3] = sum.momentum[1];
    values[4] = (double)sim->system.fluid.count;
    values[5] = sum.speed_max;
    values[6] = sum.elastic;
    values[7] = sph2d__sim_error_is_known(sim) ? sim->record.energy_error / sph2d__sim_energy_scale(sim) : NAN;
    return 8;
}

/** Centre of mass, summed from the domain's centre, so that coordinates far from 0 lose no digits; NaN without liquid.
 */
static sph2d_vec2 centre_of_mass(const sph2d_sim *sim, sph2d_vec2 from)
{
    const sph2d__store *f = &sim->system.fluid;
    double x = 0, y = 0, n = (double)f->count;
    for (size_t i = 0; i < f->count; ++i) {
        x += f->x[i] - from.x;
        y += f->y[i] - from.y;
    }
    return (sph2d_vec2){from.x + x / n, from.y + y / n};
}

static sph2d_vec2 domain_centre(const sph2d_sim *sim)
{
    sph2d_box d = sim->world.box;
    return (sph2d_vec2){(d.min.x + d.max.x) / 2, (d.min.y + d.max.y) / 2};
}

size_t sph2d__probe_momentum(const sph2d_sim *sim, const sph2d_probe *probe, double *values)
{
    (void)probe;
    const sph2d__store *f = &sim->system.fluid;
    sph2d_vec2 middle = domain_centre(sim), centre = centre_of_mass(sim, middle);
    double x = 0, y = 0, angular = 0;
    for (size_t i = 0; i < f->count; ++i) {
        x += f->vx[i];
        y += f->vy[i];
        angular += (f->x[i] - middle.x) * f->vy[i] - (f->y[i] - middle.y) * f->vx[i];
    }
    values[0] = sim->system.mass * x;
    values[1] = sim->system.mass * y;
    values[2] = sim->system.mass * angular;
    values[3] = centre.x;
    values[4] = centre.y;
    return 5;
}

size_t sph2d__probe_extent(const sph2d_sim *sim, const sph2d_probe *probe, double *values)
{
    (void)probe;
    const sph2d__store *f = &sim->system.fluid;
    for (int k = 0; k < 4; ++k)
        values[k] = NAN;
    for (size_t i = 0; i < f->count; ++i) { /* fmin and fmax ignore NaN */
        values[0] = fmin(values[0], f->x[i]);
        values[1] = fmax(values[1], f->x[i]);
        values[2] = fmin(values[2], f->y[i]);
        values[3] = fmax(values[3], f->y[i]);
    }
    double half = sim->world.scene.spacing / 2; /* a particle is a square of liquid */
    values[0] -= half;
    values[1] += half;
    values[2] -= half;
    values[3] += half;
    return 4;
}

/** A filled ellipse with half axes a and b has second moments a^2/4 and b^2/4 along them. */
size_t sph2d__probe_axes(const sph2d_sim *sim, const sph2d_probe *probe, double *values)
{
    (void)probe;
    const sph2d__store *f = &sim->system.fluid;
    sph2d_vec2 centre = centre_of_mass(sim, domain_centre(sim));
    double xx = 0, xy = 0, yy = 0, n = (double)f->count;
    for (size_t i = 0; i < f->count; ++i) {
        double x = f->x[i] - centre.x, y = f->y[i] - centre.y;
        xx += x * x;
        xy += x * y;
        yy += y * y;
    }
    double mean = (xx + yy) / 2, half = (xx - yy) / 2, reach = sqrt(half * half + xy * xy);
    double smaller = mean < reach ? 0 : mean - reach; /* rounding alone makes it negative */
    values[0] = centre.x;
    values[1] = centre.y;
    values[2] = 2 * sqrt((mean + reach) / n); /* NaN without liquid, as all that follow */
    values[3] = 2 * sqrt(smaller / n);
    values[4] = f->count > 0 ? atan2(xy, half) / 2 : NAN;
    values[5] = 2 * sqrt(xx / n);
    values[6] = 2 * sqrt(yy / n);
    values[7] = values[2] * values[3];
    return 8;
}
