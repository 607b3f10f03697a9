/* SPDX-License-Identifier: MIT */
/** @file integrators.h
 *  The schemes that move the particles by one step, and what they share. */
#ifndef SPH2D_SIM_INTEGRATORS_H
#define SPH2D_SIM_INTEGRATORS_H

#include <math.h>

#include "sim/simulation.h"

/** Kick-drift-kick with density as a sum (leapfrog.c). Errors of all: SPH2D_GUARD when a place is not finite,
 *  SPH2D_NOMEM. */
sph2d_status sph2d__leapfrog(sph2d_sim *sim, double dt);
/** Kick-drift-kick with density moved at the half step (midpoint.c). */
sph2d_status sph2d__midpoint(sph2d_sim *sim, double dt);
/** Finds the neighbours again that the next step projects with, after particles came or went. */
sph2d_status sph2d__projected_renew(sph2d_sim *sim);
/** Pressure for the places that come next, kick, drift (projected.c). */
sph2d_status sph2d__projected(sph2d_sim *sim, double dt);
/** Three stages of third order (runge_kutta.c). */
sph2d_status sph2d__runge_kutta(sph2d_sim *sim, double dt);

/** What happened to particles on their ways. */
typedef struct sph2d__events {
    uint64_t hits, reflections, bad;
} sph2d__events;

/** What sph2d__carry does with a particle that a wall or a side might stop (carry.c). */
void sph2d__carry_held(sph2d_sim *sim, size_t i, double dx, double dy, sph2d_vec2 *v, sph2d__events *events);

/** Moves particle i to its place plus (dx, dy), held by walls and brought round periodic sides, and sets its velocity
 * to *v, turned where a wall held it. */
static inline void sph2d__carry(sph2d_sim *sim, size_t i, double dx, double dy, sph2d_vec2 *v, sph2d__events *events)
{
    sph2d__store *f = &sim->system.fluid;
    sph2d_vec2 from = {f->x[i], f->y[i]}, to = {from.x + dx, from.y + dy};
    bool free = !sim->system.walls_reflect && sim->moving_count == 0 && sph2d__barrier_far(&sim->barrier, from, to) &&
                sph2d__period_holds(&sim->system.fluid_cells.period, to.x, to.y);
    if (!free) {
        sph2d__carry_held(sim, i, dx, dy, v, events);
        return;
    }
    events->bad += !isfinite(to.x + to.y + v->x + v->y);
    f->x[i] = to.x;
    f->y[i] = to.y;
    f->vx[i] = v->x;
    f->vy[i] = v->y;
}

/** Adds the events to the run's counters. SPH2D_GUARD when a place is not finite. */
sph2d_status sph2d__count_events(sph2d_sim *sim, const sph2d__events *events);

/** Sorts the fluid into its cells. SPH2D_OK or SPH2D_NOMEM. */
sph2d_status sph2d__sort_fluid(sph2d_sim *sim);

/** Sets the shift velocity's gain for a step: `gain` times the scene's, but no more than moves particles stably. */
void sph2d__limit_shift(sph2d__system *s, double gain, double dt);

/** Keeps a(n) beside in old_ax and old_ay, so that the second kick can take the prediction back. */
void sph2d__keep_accelerations(sph2d__store *fluid);

/** From the predicted v(n+1/2) + dt/2 a(n) to v(n+1/2) + dt/2 a(n+1). */
void sph2d__second_kick(sph2d__system *s, double dt);

#endif
