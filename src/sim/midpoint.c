/* SPDX-License-Identifier: MIT */
/** @file midpoint.c
 *  One step of a method whose density has a rate: leapfrog as kick-drift-kick, with density moved at the half step.
 *
 *      v(n+1/2)   = v(n) + dt/2 a(n)
 *      x(n+1/2)   = x(n) + dt/2 (v(n+1/2) + w)
 *      rho(n+1)   = rho(n) + dt rate(x(n+1/2), v(n+1/2))
 *      v(n+1/2)  += dt (w . grad) v
 *      x(n+1)     = x(n+1/2) + dt/2 (v(n+1/2) + w)
 *      a(n+1)     = a(x(n+1), rho(n+1), v(n) + dt a(n))
 *      v(n+1)     = v(n+1/2) + dt/2 a(n+1)
 *
 *  with the shift velocity w of the step (methods/shift.h), which the rate of density knows too. Without dissipation
 * and shifting the rate depends on places and velocities alone: then each line undoes itself when time runs back, so
 * that energy neither grows nor falls in the long run. */
#include "base/threads.h"
#include "methods/shift.h"
#include "sim/integrators.h"

/* Shift velocity over the largest speed, the support and the gradient of crowding, for shifting: 1 (Sun et al. 2017,
 * eq. 7: dr = -CFL Ma (2h)^2 grad C with CFL Ma = dt U/h). */
static const double SHIFT_GAIN = 2;

/** Half a drift of particle i with velocity v and its shift. */
static inline void drift_one(sph2d_sim *sim, size_t i, double dt, sph2d_vec2 v, bool shifted, sph2d__events *events)
{
    sph2d_vec2 w = shifted ? sph2d__shift_velocity(&sim->system, i) : (sph2d_vec2){0, 0};
    sph2d__carry(sim, i, dt / 2 * (v.x + w.x), dt / 2 * (v.y + w.y), &v, events);
}

/** The first kick, then half the drift. */
static sph2d_status kick_drift(sph2d_sim *sim, double dt)
{
    sph2d__store *f = &sim->system.fluid;
    uint64_t hits = 0, reflections = 0, bad = 0;
    bool shifted = sim->system.method.shifting > 0;
    int threads = sph2d__threads_for(sim->system.threads, f->count);
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1) reduction(+ : hits, reflections, bad)
    for (size_t i = 0; i < f->count; ++i) {
        sph2d__events events = {0};
        sph2d_vec2 v = {f->vx[i] + dt / 2 * f->ax[i], f->vy[i] + dt / 2 * f->ay[i]};
        drift_one(sim, i, dt, v, shifted, &events);
        hits += events.hits;
        reflections += events.reflections;
        bad += events.bad;
    }
    return sph2d__count_events(sim, &(sph2d__events){hits, reflections, bad});
}

/** Moves density by its rate and velocity by what a shift finds on its way; then the other half of the drift, after
 *  which the velocity is predicted. */
static sph2d_status drift_predict(sph2d_sim *sim, double dt)
{
    sph2d__store *f = &sim->system.fluid;
    uint64_t hits = 0, reflections = 0, bad = 0;
    bool shifted = sim->system.method.shifting > 0;
    int threads = sph2d__threads_for(sim->system.threads, f->count);
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1) reduction(+ : hits, reflections, bad)
    for (size_t i = 0; i < f->count; ++i) {
        sph2d__events events = {0};
        sph2d_vec2 v = {f->vx[i], f->vy[i]};
        f->density[i] += dt * f->density_rate[i];
        if (shifted) {
            v.x += dt * f->old_ax[i];
            v.y += dt * f->old_ay[i];
        }
        drift_one(sim, i, dt, v, shifted, &events);
        f->vx[i] += dt / 2 * f->ax[i];
        f->vy[i] += dt / 2 * f->ay[i];
        hits += events.hits;
        reflections += events.reflections;
        bad += events.bad;
    }
    return sph2d__count_events(sim, &(sph2d__events){hits, reflections, bad});
}

sph2d_status sph2d__midpoint(sph2d_sim *sim, double dt)
{
    sph2d__limit_shift(&sim->system, SHIFT_GAIN, dt);
    double start = sim->record.time, middle = start + dt / 2, end = start + dt;
    sph2d__sim_window(sim, start, middle);
    sph2d_status status = kick_drift(sim, dt);
    if (status == SPH2D_OK)
        status = sph2d__sort_fluid(sim);
    if (status == SPH2D_OK && sim->moving_count > 0)
        status = sph2d__sim_aim(sim, middle);
    if (status != SPH2D_OK)
        return status;
    sim->method->density_rate(&sim->system);
    sph2d__sim_window(sim, middle, end);
    status = drift_predict(sim, dt);
    if (status == SPH2D_OK)
        status = sph2d__sort_fluid(sim);
    if (status != SPH2D_OK)
        return status;
    sph2d__keep_accelerations(&sim->system.fluid);
    status = sph2d__sim_aim(sim, end);
    if (status != SPH2D_OK)
        return status;
    if (!sim->method->evaluate(&sim->system))
        return SPH2D_NOMEM;
    sph2d__second_kick(&sim->system, dt);
    return SPH2D_OK;
}
