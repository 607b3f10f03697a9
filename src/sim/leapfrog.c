/* SPDX-License-Identifier: MIT */
/** @file leapfrog.c
 *  One step of a method whose density is a sum: leapfrog as kick-drift-kick.
 *
 *      v(n+1/2) = v(n) + dt/2 a(n)
 *      x(n+1)   = x(n) + dt v(n+1/2)
 *      a(n+1)   = a(x(n+1), v(n) + dt a(n))
 *      v(n+1)   = v(n+1/2) + dt/2 a(n+1)
 *
 *  The velocity predicted for a(n+1) makes it second order for forces that depend on velocity. For forces of position
 *  alone and a fixed step it is the staggered leapfrog u(t+dt/2) = u(t-dt/2) + dt a(t) started with u(-dt/2) =
 *  u(0) - dt/2 a(0). */
#include "base/threads.h"
#include "sim/integrators.h"

/** Kick and drift. Afterwards the velocity is the predicted one. */
static sph2d_status kick_drift(sph2d_sim *sim, double dt)
{
    sph2d__store *f = &sim->system.fluid;
    uint64_t hits = 0, reflections = 0, bad = 0;
    int threads = sph2d__threads_for(sim->system.threads, f->count);
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1) reduction(+ : hits, reflections, bad)
    for (size_t i = 0; i < f->count; ++i) {
        double kick_x = dt / 2 * f->ax[i], kick_y = dt / 2 * f->ay[i];
        sph2d_vec2 v = {f->vx[i] + kick_x, f->vy[i] + kick_y};
        sph2d__events events = {0};
        sph2d__carry(sim, i, dt * v.x, dt * v.y, &v, &events);
        f->vx[i] += kick_x;
        f->vy[i] += kick_y;
        hits += events.hits;
        reflections += events.reflections;
        bad += events.bad;
    }
    return sph2d__count_events(sim, &(sph2d__events){hits, reflections, bad});
}

sph2d_status sph2d__leapfrog(sph2d_sim *sim, double dt)
{
    sph2d__sim_window(sim, sim->record.time, sim->record.time + dt);
    sph2d_status status = kick_drift(sim, dt);
    if (status == SPH2D_OK)
        status = sph2d__sort_fluid(sim);
    if (status != SPH2D_OK)
        return status;
    sph2d__keep_accelerations(&sim->system.fluid);
    status = sph2d__sim_aim(sim, sim->record.time + dt);
    if (status != SPH2D_OK)
        return status;
    if (!sim->method->evaluate(&sim->system))
        return SPH2D_NOMEM;
    sph2d__second_kick(&sim->system, dt);
    return SPH2D_OK;
}
