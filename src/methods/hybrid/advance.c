/* SPDX-License-Identifier: MIT */
/** @file advance.c
 *  One step of method `hybrid`, and what particles take from the grid: hybrid.h has the equations. */
#include <math.h>

#include "base/parallel.h"
#include "methods/hybrid/grid.h"
#include "methods/hybrid/hybrid.h"
#include "methods/terms/tension.h"
#include "sim/stages.h"

static void kick(sph2d__store *f, double dt)
{
#pragma omp taskloop num_tasks(sph2d__tasks(f->count, SPH2D__GRAIN)) if (f->count > SPH2D__GRAIN)
    for (size_t i = 0; i < f->count; ++i) {
        f->vx[i] += dt * f->ax[i];
        f->vy[i] += dt * f->ay[i];
    }
}

/** Energy of the liquid, and the power of the forces without a potential. */
typedef struct energies {
    double energy, power;
} energies;

static energies energies_of(const sph2d_sim *sim)
{
    return (energies){sph2d__sim_energy_of_all(sim), sph2d__sim_power_of_forces(sim) - sph2d__bodies_power(sim)};
}

/** Evaluates densities and accelerations, then the energy of the surface; returns how much more that is [J/m]. */
static sph2d_status evaluate(sph2d_sim *sim, double *more)
{
    sph2d__grid *g = sim->system.grid;
    const double before = g->surface_energy;
    const bool ok = sim->method->evaluate(&sim->system);
    g->surface_energy = sim->system.surface_tension > 0 ? sph2d__tension_energy(&sim->system) : 0;
    *more = g->surface_energy - before;
    return ok ? SPH2D_OK : SPH2D_NOMEM;
}

/** Sorts and evaluates again when particles came or went since the last step, or gravity or the pointer were set: at its end,
 *  both are of those there were. */
static sph2d_status take_in(sph2d_sim *sim)
{
    sph2d__grid *g = sim->system.grid;
    if (g->next_id == sim->record.next_id && g->count == sim->system.fluid.count && !sph2d__sim_is_steered(sim))
        return SPH2D_OK;
    const sph2d_status status = sph2d__sort_fluid(sim);
    if (status != SPH2D_OK)
        return status;
    g->next_id = sim->record.next_id;
    g->count = sim->system.fluid.count;
    sph2d__sim_act(sim);
    double brought;
    return evaluate(sim, &brought);
}

sph2d_status sph2d__hybrid_step(sph2d_sim *sim, double dt)
{
    sph2d__system *s = &sim->system;
    sph2d__record *r = &sim->record;
    sph2d_status status = sph2d__grid_prepare(sim);
    if (status == SPH2D_OK)
        status = take_in(sim);
    if (status != SPH2D_OK)
        return status;
    sph2d__profile_enter(&s->profile, SPH2D_PHASE_BOOKKEEPING);
#pragma omp task
    sph2d__grid_find_spans(sim, s->grid);
    const energies before = energies_of(sim);
    const double booked = r->energy_stopped - r->energy_walls;
    sph2d__profile_enter(&s->profile, SPH2D_PHASE_MOVE);
    kick(&s->fluid, dt);
    sph2d__bodies_fall(sim, dt);
    sph2d__sim_set_drift_interval(sim, r->time, r->time + dt);
    sph2d__profile_enter(&s->profile, SPH2D_PHASE_SOLVE);
#pragma omp taskwait
    if (!sph2d__grid_cut(sim, s->grid))
        status = SPH2D_NOMEM; /* returned once the threads are done */
    sph2d__grid_open_nozzles(sim, s->grid);
    sph2d__grid_sum(sim, s->grid, dt);
    sph2d__hybrid_begin_order(s);
    sph2d__grid_passes_find(s->isa)->solve(s->grid, dt * s->viscosity / s->rest_density);
#pragma omp taskwait
    if (status != SPH2D_OK)
        return status;
    if (sim->moving_count > sim->bodies.count)
        r->energy_walls += sph2d__grid_wall_work(s->grid, s->rest_density);
    const double fed = sph2d__grid_nozzle_work(s->grid, s->rest_density);
    r->energy_fed += fed;
    double on_bodies = 0;
    if (s->grid->body_count > 0) {
        sph2d__grid_impulses(s->grid, s->rest_density, s->grid->impulses);
        status = sph2d__bodies_push(sim, dt, s->grid->impulses, &on_bodies);
        if (status != SPH2D_OK)
            return status;
        sph2d__sim_set_drift_interval(sim, r->time, r->time + dt);
    }
    sph2d__profile_enter(&s->profile, SPH2D_PHASE_MOVE);
    status = sph2d__advect(sim, dt, sph2d__transfer_passes_find(s->isa)->move, NULL);
    if (status != SPH2D_OK)
        return status;
    status = sph2d__sort_fluid(sim);
    if (status != SPH2D_OK)
        return status;
    sph2d__profile_enter(&s->profile, SPH2D_PHASE_BOOKKEEPING);
    const energies after = energies_of(sim);
    r->work_pressed += on_bodies + after.energy - before.energy - dt * (before.power + after.power) / 2 +
                       (r->energy_stopped - r->energy_walls - booked) - fed;
    status = sph2d__sim_update_forcing(sim, r->time + dt);
    if (status != SPH2D_OK)
        return status;
    double more;
    status = evaluate(sim, &more);
    r->work_pressed += more;
    return status;
}
