/* SPDX-License-Identifier: MIT */
/** @file leapfrog.c
 *  Time scheme for density by summation: leapfrog as kick-drift-kick.
 *
 *      v(n+1/2) = v(n) + dt/2 a(n)
 *      x(n+1)   = x(n) + dt v(n+1/2)
 *      a(n+1)   = a(x(n+1), v(n) + dt a(n))
 *      v(n+1)   = v(n+1/2) + dt/2 a(n+1)
 *
 *  The velocity predicted for a(n+1) makes it second order for forces that depend on velocity. For forces that depend
 *  on position alone and a fixed step it is the staggered leapfrog u(t+dt/2) = u(t-dt/2) + dt a(t) started with
 *  u(-dt/2) = u(0) - dt/2 a(0). */
#include "methods/muller/leapfrog.h"
#include "methods/muller/muller.h"
#include "sim/stages.h"

static void kick(sph2d_sim *sim, double dt, sph2d__batch *w)
{
    for (size_t k = 0; k < w->count; ++k) {
        const sph2d__way way = sph2d__kick_drift(&sim->system, dt, w->first + k);
        w->vx[k] = way.v.x;
        w->vy[k] = way.v.y;
        w->dx[k] = way.dx;
        w->dy[k] = way.dy;
    }
}

static void predict(sph2d_sim *sim, double dt, sph2d__batch *w)
{
    for (size_t i = w->first; i < w->first + w->count; ++i)
        sph2d__predict(&sim->system, dt, i);
}

sph2d_status sph2d__leapfrog(sph2d_sim *sim, double dt)
{
    sph2d_status status = sph2d__bodies_kick(sim, dt);
    if (status != SPH2D_OK)
        return status;
    sph2d__sim_set_drift_interval(sim, sim->record.time, sim->record.time + dt);
    status = sph2d__advect(sim, dt, kick, predict);
    if (status == SPH2D_OK)
        status = sph2d__sort_fluid(sim);
    if (status != SPH2D_OK)
        return status;
    sph2d__keep_accelerations(&sim->system.fluid);
    status = sph2d__sim_update_forcing(sim, sim->record.time + dt);
    if (status != SPH2D_OK)
        return status;
    if (!sim->method->evaluate(&sim->system))
        return SPH2D_NOMEM;
    sph2d__loads_find(sim, 1);
    sph2d__bodies_second_kick(sim, dt); /* first: forces depend on the velocities that were predicted */
    sph2d__over_particles(&sim->system, sim->system.fluid.count, sph2d__second_kick, "second_kick_pass");
    return SPH2D_OK;
}
