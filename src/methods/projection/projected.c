/* SPDX-License-Identifier: MIT */
/** @file projected.c
 *  One step of a method whose pressure keeps the density of the places that come next: drift, kick, drift.
 *
 *      y        = x(n) + dt/2 v(n)
 *      v(n+1)   = v(n) + dt (a(y, v(n)) + a_p)
 *      x(n+1)   = y + dt/2 v(n+1)
 *
 *  Artificial viscosity (limited_viscosity.h) changes v(n) first, so that what it takes is known to round-off.
 *  Neighbours, density and all forces belong to the middle y, and a_p keeps the density where the step leads from
 *  there, at y + dt v(n+1), which is the next middle. From middle to middle that is the symplectic Euler scheme of the
 *  papers; places and velocities between steps belong to the same moment, so that forces that have a potential keep
 *  energy to
 *  second order in dt (Hairer, Lubich & Wanner 2006, sec. I.1: position Verlet) and free fall is exact. Density and
 *  pressure between steps are those of the middle of the last one, and so is the acceleration, which is that without
 *  pressure.
 *
 *  With d = dt a_p and the mean velocity of the step, pressure does the work
 *
 *      W/m = sum d . (v(n) + v(n+1))/2
 *
 *  on the liquid, and the other forces all else that changes its energy. Of it moving walls bring P dt. The rest cannot
 *  be above 0: pressure that keeps a density stores no energy, so that it can give none back, and where liquid meets
 *  liquid or a wall it takes what keeps them from parting (energy.c books that). What it does to put right a density
 *  that is wrong already, by the error of steps before, by walls, by a start in too little room, moves places; where
 *  velocities with it would make more energy than there was, they keep less of it:
 *
 *      v(n+1) <- v(n+1) - theta d,   0 <= theta <= 1, the same for all, so that momentum is kept,
 *
 *  while the next middle stays where it is, x(n+1) = y + dt/2 v(n+1) + dt theta d. That way takes theta dt a . d from
 *  the potential of the other forces; in all
 *
 *      dE/m = W - theta A + theta^2 B/2,   A = A' + C,   B = sum d . d = 2 (A' - C - W),
 *                                          A' = sum d . v(n+1),   C = dt/2 sum d . a
 *
 *  with v(n+1) before the change on the right. It is at most P dt/m for the smallest theta that makes it so, or least.
 *  Where d does little but carry weight, as in a tank at rest, A is below 0: what velocities do not keep is not worth
 *  the way. Yet from middle to middle, in the energy of v(n+1) and y, there is no such way, and theta takes A' from it:
 *  it calms the trembling of a liquid at rest. There it goes by A', as far as the step's energy rises by no more than a
 *  quarter of what is to be put right.
 *
 *  Position corrections without velocities are known as split impulses; here they are split only where energy asks for
 *  it. */
#include <math.h>

#include "methods/common/slabs.h"
#include "methods/projection/limited_viscosity.h"
#include "methods/projection/projection.h"
#include "sim/stages.h"

static void drift(sph2d_sim *sim, double dt, sph2d__batch *w)
{
    const sph2d__store *f = &sim->system.fluid;
    for (size_t k = 0, i = w->first; k < w->count; ++k, ++i) {
        w->vx[k] = f->vx[i];
        w->vy[k] = f->vy[i];
        w->dx[k] = dt / 2 * w->vx[k];
        w->dy[k] = dt / 2 * w->vy[k];
    }
}

/** Kick and drift; the acceleration is that without pressure again, which free_ax and free_ay are. */
static void kick(sph2d_sim *sim, double dt, sph2d__batch *w)
{
    sph2d__store *f = &sim->system.fluid;
    for (size_t k = 0, i = w->first; k < w->count; ++k, ++i) {
        double kept_x = sim->split * (f->ax[i] - f->free_ax[i]), kept_y = sim->split * (f->ay[i] - f->free_ay[i]);
        w->vx[k] = f->vx[i] + dt * (f->ax[i] - kept_x);
        w->vy[k] = f->vy[i] + dt * (f->ay[i] - kept_y);
        w->dx[k] = dt / 2 * w->vx[k] + dt * dt * kept_x;
        w->dy[k] = dt / 2 * w->vy[k] + dt * dt * kept_y;
        f->ax[i] = f->free_ax[i];
        f->ay[i] = f->free_ay[i];
    }
}

/** W, A' and C of a slab. */
static void sum_work(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const sph2d__store *f = slab->rows;
    double dt = s->step, work = 0, slope = 0, weight = 0;
    (void)with;
    for (size_t i = slab->first; i < slab->last; ++i) {
        double ax = f->ax[i], ay = f->ay[i], bx = f->free_ax[i], by = f->free_ay[i];
        double px = dt * (ax - bx), py = dt * (ay - by), vx = f->vx[i], vy = f->vy[i];
        work += px * (vx + dt / 2 * ax) + py * (vy + dt / 2 * ay);
        slope += px * (vx + dt * ax) + py * (vy + dt * ay);
        weight += dt / 2 * (px * bx + py * by);
    }
    *sum = (sph2d__slab_sum){.first = work, .second = slope, .third = weight};
}

/* So much of what is above may a step's energy rise for the next one's. */
static const double LENT = 0.25;

/** theta for W - P dt/m = `above`, A, A' and B, of which the first is above 0. */
static double theta_of(double above, double whole, double middle, double curve)
{
    double slope = whole > 0 ? whole : middle;
    if (!(slope > 0 && curve > 0))
        return 0;
    double theta = (slope - sqrt(fmax(slope * slope - 2 * curve * above, 0))) / curve;
    return fmin(theta, whole > 0 ? 1 : LENT * above / (curve / 2 - whole));
}

/** Finds theta, and books the work of pressure that moving walls do not bring. */
static void split(sph2d_sim *sim, double dt)
{
    double mass = sim->system.mass, walls = sph2d__sim_book_wall_work(sim, dt) / mass;
    sph2d__slab_sum w = sph2d__over_fluid(&sim->system, sum_work, NULL, NULL, 0);
    sph2d__bodies_add_work(sim, dt, &w);
    double above = w.first - walls, whole = w.second + w.third, curve = 2 * (w.second - w.third - w.first);
    sim->split = above > 0 ? fmin(theta_of(above, whole, w.second, curve), 1) : 0;
    sim->record.work_pressed += mass * (above + sim->split * (sim->split * curve / 2 - whole));
}

/** Half a drift, and all that depends on places alone at its end. */
static sph2d_status go(sph2d_sim *sim, double dt, sph2d__batch_work *set, double to)
{
    sph2d_status status = sph2d__advect(sim, dt, set, NULL);
    if (status == SPH2D_OK)
        status = sph2d__sort_fluid(sim);
    return status == SPH2D_OK ? sph2d__sim_update_forcing(sim, to) : status;
}

sph2d_status sph2d__projected(sph2d_sim *sim, double dt)
{
    double start = sim->record.time, middle = start + dt / 2, end = start + dt;
    sph2d__bodies_drift(sim, dt);
    sph2d__sim_set_drift_interval(sim, start, middle);
    sph2d_status status = go(sim, dt, drift, middle);
    if (status != SPH2D_OK)
        return status;
    if (!sim->method->evaluate(&sim->system) || !sph2d__sim_book_viscosity(sim, dt))
        return SPH2D_NOMEM;
    sph2d__profile_enter(&sim->system.profile, SPH2D_PHASE_SOLVE);
    sim->record.energy_viscous += sph2d__limited_viscosity_apply(&sim->system, dt);
    sph2d__projection_keep(&sim->system);
    sim->method->project(&sim->system);
    sph2d__projection_average(&sim->system);
    sph2d__bodies_press(sim);
    split(sim, dt);
    sph2d__loads_find(sim, 1 - sim->split);
    status = sph2d__bodies_project(sim, dt, sim->split);
    if (status != SPH2D_OK)
        return status;
    sph2d__profile_enter(&sim->system.profile, SPH2D_PHASE_MOVE);
    sim->record.iterations += sim->system.iterations;
    sim->record.unconverged += sim->system.unconverged;
    sim->record.unconverged_row = sim->system.unconverged ? sim->record.unconverged_row + 1 : 0;
    sph2d__sim_set_drift_interval(sim, middle, end);
    return go(sim, dt, kick, end);
}
