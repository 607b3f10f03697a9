/* SPDX-License-Identifier: MIT */
/** @file midpoint.c
 *  Time scheme for a method that integrates the rate of density: leapfrog as kick-drift-kick, with density advanced by
 *  its rate at the half step.
 *
 *      v(n+1/2)   = v(n) + dt/2 a(n)
 *      x(n+1/2)   = x(n) + dt/2 v(n+1/2)
 *      rho(n+1)   = rho(n) + dt rate(x(n+1/2), v(n+1/2))
 *      x(n+1)     = x(n+1/2) + dt/2 v(n+1/2) + dt w(n+1/2)
 *      a(n+1)     = a(x(n+1), rho(n+1), v(n) + dt a(n))
 *      v(n+1)     = v(n+1/2) + dt/2 a(n+1)
 *
 *  with the shift velocity w (methods/terms/shift.h), which the rate of density includes. Without dissipation and
 *  shifting the rate depends on positions and velocities alone: the scheme is then time-reversible, so that energy has
 *  no long-term drift. */
#include "methods/common/state_equation.h"
#include "methods/wcsph/wcsph.h"
#include "sim/stages.h"

/** The first kick, then half the drift. */
static void kick(sph2d_sim *sim, double dt, sph2d__batch *w)
{
    const sph2d__store *f = &sim->system.fluid;
    w->kick = dt / 2;
    for (size_t k = 0, i = w->first; k < w->count; ++k, ++i) {
        w->vx[k] = f->vx[i] + dt / 2 * f->ax[i];
        w->vy[k] = f->vy[i] + dt / 2 * f->ay[i];
        w->dx[k] = dt / 2 * w->vx[k];
        w->dy[k] = dt / 2 * w->vy[k];
    }
}

/** The density of particle i after the step. Isolated particles have rest density; the elastic energy that they give up
 *  counts as diffused. */
static double next_density(const sph2d_sim *sim, size_t i, double dt, sph2d__batch *w)
{
    const sph2d__store *f = &sim->system.fluid;
    if (sph2d__connection(f->filling[i]) > 0)
        return f->density[i] + dt * f->density_rate[i];
    if (f->density[i] != sim->system.rest_density)
        w->diffused += sim->system.mass * sph2d__elastic_of(&sim->system, f->density[i]);
    return sim->system.rest_density;
}

/** Advances density by its rate, then the second half of the drift and the shift. */
static void advance_density(sph2d_sim *sim, double dt, sph2d__batch *w)
{
    sph2d__store *f = &sim->system.fluid;
    const bool shifted = sim->system.method.shifting > 0;
    for (size_t k = 0, i = w->first; k < w->count; ++k, ++i) {
        f->density[i] = next_density(sim, i, dt, w);
        w->vx[k] = f->vx[i];
        w->vy[k] = f->vy[i];
        w->dx[k] = dt / 2 * f->vx[i] + (shifted ? dt * f->shift_x[i] : 0);
        w->dy[k] = dt / 2 * f->vy[i] + (shifted ? dt * f->shift_y[i] : 0);
    }
}

sph2d_status sph2d__midpoint(sph2d_sim *sim, double dt)
{
    double start = sim->record.time, middle = start + dt / 2, end = start + dt;
    sph2d_status status = sph2d__bodies_kick(sim, dt);
    if (status != SPH2D_OK)
        return status;
    sph2d__sim_set_drift_interval(sim, start, middle);
    status = sph2d__advect(sim, dt, kick, NULL);
    if (status == SPH2D_OK)
        status = sph2d__sort_fluid(sim);
    if (status == SPH2D_OK && sim->moving_count > 0)
        status = sph2d__sim_update_forcing(sim, middle);
    if (status != SPH2D_OK)
        return status;
    sim->method->density_rate(&sim->system);
    if (sim->bodies.count > 0)
        sph2d__wcsph_keep_compression_rates(&sim->system);
    sph2d__sim_book_diffusion(sim, dt);
    sph2d__openings_hold_density(sim, dt);
    sph2d__sim_set_drift_interval(sim, middle, end);
    status = sph2d__advect(sim, dt, advance_density, sph2d__predict);
    if (status == SPH2D_OK)
        status = sph2d__sort_fluid(sim);
    if (status != SPH2D_OK)
        return status;
    sph2d__keep_accelerations(&sim->system.fluid);
    status = sph2d__sim_update_forcing(sim, end);
    if (status != SPH2D_OK)
        return status;
    sph2d__openings_impose(sim);
    if (!sim->method->evaluate(&sim->system))
        return SPH2D_NOMEM;
    sph2d__openings_hold_velocity(sim, dt);
    sph2d__loads_find(sim, 1);
    sph2d__bodies_second_kick(sim, dt); /* first: forces depend on the velocities that were predicted */
    sph2d__second_kick(&sim->system, dt);
    return SPH2D_OK;
}
