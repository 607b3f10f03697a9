/* SPDX-License-Identifier: MIT */
/** @file projected.c
 *  One step of a method whose pressure keeps the density of the places that come next: symplectic Euler.
 *
 *      v(n+1) = v(n) + dt (a(x(n), v(n)) + pressure)
 *      x(n+1) = x(n) + dt v(n+1)
 *
 *  with first order in time, as of the papers: what the pressure keeps is a place, so that it acts over the whole step.
 *  The acceleration that particles have between steps is that without pressure. */
#include "sim/integrators.h"

static void kick(sph2d_sim *sim, double dt, sph2d__flock *w)
{
    const sph2d__store *f = &sim->system.fluid;
    for (size_t k = 0, i = w->first; k < w->count; ++k, ++i) {
        w->vx[k] = f->vx[i] + dt * f->ax[i];
        w->vy[k] = f->vy[i] + dt * f->ay[i];
        w->dx[k] = dt * w->vx[k];
        w->dy[k] = dt * w->vy[k];
    }
}

sph2d_status sph2d__projected_renew(sph2d_sim *sim)
{
    sph2d_status status = sph2d__sort_fluid(sim);
    return status == SPH2D_OK && !sim->method->evaluate(&sim->system) ? SPH2D_NOMEM : status;
}

sph2d_status sph2d__projected(sph2d_sim *sim, double dt)
{
    sph2d__sim_window(sim, sim->record.time, sim->record.time + dt);
    sph2d__profile_enter(&sim->system.profile, SPH2D_PHASE_SOLVE);
    sim->method->project(&sim->system);
    sph2d__sim_book_projection(sim, dt);
    sph2d__profile_enter(&sim->system.profile, SPH2D_PHASE_MOVE);
    sim->record.iterations += sim->system.iterations;
    sim->record.unconverged += sim->system.unconverged;
    sim->record.unconverged_row = sim->system.unconverged ? sim->record.unconverged_row + 1 : 0;
    sph2d_status status = sph2d__carry(sim, dt, kick, NULL);
    if (status == SPH2D_OK)
        status = sph2d__sort_fluid(sim);
    if (status == SPH2D_OK)
        status = sph2d__sim_aim(sim, sim->record.time + dt);
    if (status == SPH2D_OK && !sim->method->evaluate(&sim->system))
        status = SPH2D_NOMEM;
    return status;
}
