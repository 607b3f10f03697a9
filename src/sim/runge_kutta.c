/* SPDX-License-Identifier: MIT */
/** @file runge_kutta.c
 *  One step of third order in three stages (Shu & Osher 1988, eq. 2.18), for methods that give the rates of place,
 *  velocity and density:
 *
 *      y1     = y(n) + dt f(y(n))
 *      y2     = 3/4 y(n) + 1/4 (y1 + dt f(y1))
 *      y(n+1) = 1/3 y(n) + 2/3 (y2 + dt f(y2))
 *
 *  Each stage is an average of forward steps: what one forward step keeps bounded, the whole keeps bounded. */
#include <string.h>

#include "methods/state_equation.h"
#include "sim/integrators.h"

/* Shift velocity over the largest speed and the crowding, for shifting: 1. */
static const double SHIFT_GAIN = 4;

static void keep_start(sph2d__store *f)
{
    memcpy(f->start_x, f->x, f->count * sizeof(double));
    memcpy(f->start_y, f->y, f->count * sizeof(double));
    memcpy(f->start_vx, f->vx, f->count * sizeof(double));
    memcpy(f->start_vy, f->vy, f->count * sizeof(double));
    memcpy(f->start_density, f->density, f->count * sizeof(double));
}

/** One forward step, averaged with the start by the weight `old`. */
static void stage(sph2d_sim *sim, double dt, double old, sph2d__flock *w)
{
    const sph2d__store *f = &sim->system.fluid;
    const sph2d__period *period = &sim->system.fluid_cells.period;
    for (size_t k = 0, i = w->first; k < w->count; ++k, ++i) {
        /* Of the way since the start, 1 - old is gone: what is left of it is the way from here. */
        double gone_x = sph2d__period_nearest(f->x[i] - f->start_x[i], period->length_x);
        double gone_y = sph2d__period_nearest(f->y[i] - f->start_y[i], period->length_y);
        w->dx[k] = (1 - old) * dt * (f->vx[i] + f->shift_x[i]) - old * gone_x;
        w->dy[k] = (1 - old) * dt * (f->vy[i] + f->shift_y[i]) - old * gone_y;
        w->vx[k] = old * f->start_vx[i] + (1 - old) * (f->vx[i] + dt * f->ax[i]);
        w->vy[k] = old * f->start_vy[i] + (1 - old) * (f->vy[i] + dt * f->ay[i]);
        f->density[i] = old * f->start_density[i] + (1 - old) * (f->density[i] + dt * f->density_rate[i]);
    }
}

/** Mean density of the particles, summed in their order. */
static double mean_density(const sph2d__store *f)
{
    double sum = 0;
    for (size_t i = 0; i < f->count; ++i)
        sum += f->density[i];
    return f->count > 0 ? sum / (double)f->count : 0;
}

/** Liquid that fills a closed room keeps its mass, so that its mean density is known; fits that are not conservative
 * let it drift (a cavity at Re 1000 by 0.07 % in a time L/U), and the drift is the same everywhere. */
static void keep_mass(sph2d_sim *sim)
{
    sph2d__store *f = &sim->system.fluid;
    double drift = mean_density(f) - sim->record.mean_density;
    for (size_t i = 0; i < f->count; ++i)
        f->density[i] -= drift;
}

sph2d_status sph2d__runge_kutta(sph2d_sim *sim, double dt)
{
    static const double old[3] = {0, 3.0 / 4, 1.0 / 3}, moment[4] = {0, 1, 0.5, 1};
    sph2d__system *s = &sim->system;
    sph2d__limit_shift(s, SHIFT_GAIN, dt);
    if (!(sim->record.mean_density > 0))
        sim->record.mean_density = mean_density(&s->fluid);
    keep_start(&s->fluid);
    for (int k = 0; k < 3; ++k) {
        double time = sim->record.time;
        sph2d_status status = sph2d__sim_aim(sim, time + moment[k] * dt);
        if (status != SPH2D_OK)
            return status;
        if (!sim->method->evaluate(s))
            return SPH2D_NOMEM;
        sph2d__sim_window(sim, time + moment[k] * dt, time + moment[k + 1] * dt);
        status = sph2d__carry(sim, dt, old[k], stage, NULL);
        if (status == SPH2D_OK)
            status = sph2d__sort_fluid(sim);
        if (status != SPH2D_OK)
            return status;
    }
    keep_mass(sim);
    sph2d__state_equation_apply(s, &s->fluid);
    return SPH2D_OK;
}
