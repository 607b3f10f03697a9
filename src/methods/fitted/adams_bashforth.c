/* SPDX-License-Identifier: MIT */
/** @file adams_bashforth.c
 *  Third-order Adams-Bashforth scheme for the rates f of velocity and density: the parabola through those of this step
 *  and of the two before is integrated over the step, with variable steps (Hairer, Norsett & Wanner 1993, III.5),
 *
 *      v(n+1)   = v(n)   + dt (b0 f(n) + b1 f(n-1) + b2 f(n-2))     b = 23/12, -16/12, 5/12 where steps are equal
 *      rho(n+1) = rho(n) + ... likewise
 *      x(n+1)   = x(n)   + dt (v(n) + v(n+1))/2
 *
 *  The first step has one rate, the second two. In addition particles are shifted by dt w(n), and velocity and density
 *  are advected by that shift, with a forward Euler step: it is stable for five times the shift that the parabola is.
 *
 *  A step evaluates the neighbours once. Oscillations are stable up to w dt = 0.72 (Durran 1991), with three-stage
 *  Runge-Kutta up to 1.73; decay at a rate r up to r dt = 6/11. */
#include "methods/common/state_equation.h"
#include "methods/fitted/fitted.h"
#include "sim/stages.h"

/* s of fitted.h for `shifting: 1`. */
static const double SHIFT_GAIN = 2.5;
/* Shifting is a diffusion of particles with D = gain U H: largest D dt / H^2; 0.1 is still stable. */
static const double SHIFT_LIMIT = 0.05;

/** Sets the weights b of the rates for a step `dt` after one of `last` and one of `older` before that; 0: none. */
static void set_weights(double weights[3], double dt, double last, double older)
{
    double both = last + older;
    weights[1] = weights[2] = 0;
    if (last > 0 && older > 0) {
        weights[1] = -dt * (2 * dt + 3 * both) / (6 * last * older);
        weights[2] = dt * (2 * dt + 3 * last) / (6 * both * older);
    } else if (last > 0) {
        weights[1] = -dt / (2 * last);
    }
    weights[0] = 1 - weights[1] - weights[2];
}

static void swap(double **a, double **b)
{
    double *array = *a;
    *a = *b;
    *b = array;
}

/** Makes the rates those of the step before, which become those of two steps before. */
static void rotate_rates(sph2d__store *f)
{
    double **now[] = {&f->ax, &f->ay, &f->density_rate};
    double **old[] = {&f->old_ax, &f->old_ay, &f->old_density_rate};
    double **older[] = {&f->older_ax, &f->older_ay, &f->older_density_rate};
    for (size_t n = 0; n < sizeof now / sizeof now[0]; ++n) {
        swap(older[n], old[n]);
        swap(old[n], now[n]);
    }
}

/** Displacements, velocities and densities of a batch. */
static void advance(sph2d_sim *sim, double dt, sph2d__batch *w)
{
    sph2d__store *f = &sim->system.fluid;
    const double now = dt * sim->weights[0], old = dt * sim->weights[1], older = dt * sim->weights[2];
    for (size_t k = 0, i = w->first; k < w->count; ++k, ++i) {
        double gain_x = now * f->ax[i] + old * f->old_ax[i] + older * f->older_ax[i];
        double gain_y = now * f->ay[i] + old * f->old_ay[i] + older * f->older_ay[i];
        w->dx[k] = dt * (f->vx[i] + gain_x / 2 + f->shift_x[i]);
        w->dy[k] = dt * (f->vy[i] + gain_y / 2 + f->shift_y[i]);
        w->vx[k] = f->vx[i] + gain_x + dt * f->shift_ax[i];
        w->vy[k] = f->vy[i] + gain_y + dt * f->shift_ay[i];
        f->density[i] += now * f->density_rate[i] + old * f->old_density_rate[i] + older * f->older_density_rate[i] +
                         dt * f->shift_density_rate[i];
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

/** Restores the mean density, which is constant in a closed domain; the fits are not conservative and let it drift (a
 *  cavity at Re 1000 by 0.07 % in a time L/U), uniformly. Openings keep it. */
static void restore_mean_density(sph2d_sim *sim)
{
    sph2d__store *f = &sim->system.fluid;
    double drift = sim->openings.count > 0 ? 0 : mean_density(f) - sim->record.mean_density;
    for (size_t i = 0; i < f->count; ++i)
        f->density[i] -= drift;
}

sph2d_status sph2d__adams_bashforth(sph2d_sim *sim, double dt)
{
    sph2d__system *s = &sim->system;
    sph2d__record *r = &sim->record;
    sph2d__limit_shift(s, SHIFT_GAIN, SHIFT_LIMIT, dt);
    if (!(r->mean_density > 0) && sim->openings.count == 0)
        r->mean_density = mean_density(&s->fluid);
    sph2d_status status = sim->openings.count > 0 ? sph2d__sort_fluid(sim) : SPH2D_OK; /* some came, some left */
    if (status != SPH2D_OK)
        return status;
    rotate_rates(&s->fluid);
    if (!sph2d__sim_book_fitted(sim, dt))
        return SPH2D_NOMEM;
    set_weights(sim->weights, dt, r->last_step, r->older_step);
    r->older_step = r->last_step;
    sph2d__openings_hold_rates(sim, dt);
    sph2d__sim_set_drift_interval(sim, r->time, r->time + dt);
    status = sph2d__advect(sim, dt, advance, NULL);
    if (status == SPH2D_OK)
        status = sph2d__sort_fluid(sim);
    if (status == SPH2D_OK)
        status = sph2d__sim_update_forcing(sim, r->time + dt);
    if (status != SPH2D_OK)
        return status;
    restore_mean_density(sim);
    sph2d__openings_impose(sim);
    sph2d__state_equation_apply(s);
    sph2d__loads_find(sim, 1);
    return SPH2D_OK;
}
