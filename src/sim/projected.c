/* SPDX-License-Identifier: MIT */
/** @file projected.c
 *  One step of a method whose pressure keeps the density of the places that come next: symplectic Euler.
 *
 *      v(n+1) = v(n) + dt (a(x(n), v(n)) + a_p)
 *      x(n+1) = x(n) + dt v(n+1)
 *
 *  with first order in time, as of the papers: what the pressure keeps is a place, so that it acts over the whole step.
 *  The acceleration that particles have between steps is that without pressure.
 *
 *  Pressure that keeps a density stores no energy, so that it can give none back. What it does to put right a density
 *  that is wrong already, by the error of steps before, by walls, by a start in too little room, moves places; where
 *  velocities with it would make more energy than there was, they keep less of it: with d = dt a_p and
 *
 *      v(n+1) <- v(n+1) - theta d,   0 <= theta <= 1, the same for all, so that momentum is kept,
 *
 *  after the places have moved, the change of kinetic energy and of the energy of the forces a that are no pressure,
 *
 *      dE/m = sum (v(n+1)^2 - v(n)^2)/2 - dt a . v(n+1) = W - theta A + theta^2 B/2,
 *      W = sum d . (v(n) + v(n+1))/2 + dt a . (v(n) - v(n+1))/2,   A = sum d . v(n+1),   B = sum d . d
 *
 *  with v(n+1) before the change on the right, is at most 0 for the smallest theta that makes it so, or least. Walls
 *  that move do work of their own: with them theta is 0. Position corrections without velocities are known as split
 *  impulses; here they are split only where energy asks for it. */
#include <math.h>
#include <string.h>

#include "methods/slabs.h"
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

/** The same, but for theta a_p, which old_ax and old_ay are, in velocities. */
static void kick_less(sph2d_sim *sim, double dt, sph2d__flock *w)
{
    const sph2d__store *f = &sim->system.fluid;
    kick(sim, dt, w);
    for (size_t k = 0, i = w->first; k < w->count; ++k, ++i) {
        w->vx[k] -= dt * f->old_ax[i];
        w->vy[k] -= dt * f->old_ay[i];
    }
}

/** Keeps the acceleration without pressure beside. */
static void keep_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    sph2d__store *f = slab->rows;
    size_t bytes = (slab->last - slab->first) * sizeof(double);
    (void)s;
    (void)with;
    (void)sum;
    memcpy(f->old_ax + slab->first, f->ax + slab->first, bytes);
    memcpy(f->old_ay + slab->first, f->ay + slab->first, bytes);
}

/** W, A and B of a slab. */
static void sum_work(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const sph2d__store *f = slab->rows;
    double dt = s->step, work = 0, slope = 0, curve = 0;
    (void)with;
    for (size_t i = slab->first; i < slab->last; ++i) {
        double ax = f->ax[i], ay = f->ay[i], bx = f->old_ax[i], by = f->old_ay[i];
        double px = dt * (ax - bx), py = dt * (ay - by), vx = f->vx[i], vy = f->vy[i];
        work += px * (vx + dt / 2 * ax) + py * (vy + dt / 2 * ay) - dt * dt / 2 * (bx * ax + by * ay);
        slope += px * (vx + dt * ax) + py * (vy + dt * ay);
        curve += px * px + py * py;
    }
    *sum = (sph2d__slab_sum){.first = work, .second = slope, .third = curve};
}

/** From the acceleration without pressure to theta a_p. */
static void lessen_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const double *theta = with;
    sph2d__store *f = slab->rows;
    (void)s;
    (void)sum;
    for (size_t i = slab->first; i < slab->last; ++i) {
        f->old_ax[i] = *theta * (f->ax[i] - f->old_ax[i]);
        f->old_ay[i] = *theta * (f->ay[i] - f->old_ay[i]);
    }
}

/** theta: where W - theta A + theta^2 B/2 falls to 0, or its lowest place. */
static double excess(sph2d_sim *sim)
{
    if (sim->moving_count > 0)
        return 0;
    sph2d__slab_sum w = sph2d__over_fluid(&sim->system, sum_work, NULL);
    if (!(w.first > 0 && w.second > 0))
        return 0;
    double root = sqrt(fmax(w.second * w.second - 2 * w.third * w.first, 0));
    return fmin((w.second - root) / w.third, 1);
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
    sph2d__over_fluid(&sim->system, keep_slab, NULL);
    sim->method->project(&sim->system);
    sph2d__sim_book_projection(sim, dt);
    sph2d__profile_enter(&sim->system.profile, SPH2D_PHASE_MOVE);
    double theta = excess(sim);
    if (theta > 0)
        sph2d__over_fluid(&sim->system, lessen_slab, &theta);
    sim->record.iterations += sim->system.iterations;
    sim->record.unconverged += sim->system.unconverged;
    sim->record.unconverged_row = sim->system.unconverged ? sim->record.unconverged_row + 1 : 0;
    sph2d_status status = sph2d__carry(sim, dt, theta > 0 ? kick_less : kick, NULL);
    if (status == SPH2D_OK)
        status = sph2d__sort_fluid(sim);
    if (status == SPH2D_OK)
        status = sph2d__sim_aim(sim, sim->record.time + dt);
    if (status == SPH2D_OK && !sim->method->evaluate(&sim->system))
        status = SPH2D_NOMEM;
    return status;
}
