/* SPDX-License-Identifier: MIT */
/** @file step.c
 *  One step: leapfrog as kick-drift-kick.
 *
 *      v(n+1/2) = v(n) + dt/2 a(n)
 *      x(n+1)   = x(n) + dt v(n+1/2)
 *      a(n+1)   = a(x(n+1), v(n) + dt a(n))
 *      v(n+1)   = v(n+1/2) + dt/2 a(n+1)
 *
 *  The velocity predicted for a(n+1) makes it second order for forces that depend on velocity. For forces of position
 *  alone and a fixed step it is the staggered leapfrog u(t+dt/2) = u(t-dt/2) + dt a(t) started with u(-dt/2) =
 *  u(0) - dt/2 a(0). */
#include <math.h>

#include "base/threads.h"
#include "sim/simulation.h"

/** Reflects a velocity off the nearest boundary particle that is within one spacing and ahead, if that one reflects:
 *  the part along the line between the two is turned round and damped. */
static bool reflect(const sph2d__system *s, sph2d_vec2 p, sph2d_vec2 *v)
{
    uint32_t cell = sph2d__cells_find(&s->wall_cells, p.x, p.y);
    if (cell == UINT32_MAX)
        return false;
    sph2d__ranges ranges = sph2d__cells_ranges(&s->wall_cells, cell);
    double nearest2 = s->spacing * s->spacing;
    size_t nearest = SIZE_MAX;
    for (int r = 0; r < 3; ++r)
        for (size_t b = ranges.begin[r]; b < ranges.end[r]; ++b) {
            double dx = p.x - s->walls.x[b], dy = p.y - s->walls.y[b];
            double r2 = dx * dx + dy * dy;
            if (s->wall_bounce[b] >= 0 && r2 < nearest2 && r2 > 0) {
                nearest2 = r2;
                nearest = b;
            }
        }
    if (nearest == SIZE_MAX)
        return false;
    double nx = p.x - s->walls.x[nearest], ny = p.y - s->walls.y[nearest];
    double along = (v->x * nx + v->y * ny) / nearest2;
    if (along >= 0)
        return false;
    double turn = (1 + s->wall_bounce[nearest]) * along;
    v->x -= turn * nx;
    v->y -= turn * ny;
    return true;
}

/** Kick and drift. Afterwards the velocity is the predicted one. False when a position is not finite. */
static bool kick_drift(sph2d_sim *sim, double dt)
{
    sph2d__system *s = &sim->system;
    sph2d__store *f = &s->fluid;
    uint64_t hits = 0, reflections = 0;
    size_t bad = 0;
    int threads = sph2d__threads_for(s->threads, f->count);
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1) reduction(+ : hits, reflections, bad)
    for (size_t i = 0; i < f->count; ++i) {
        double kick_x = dt / 2 * f->ax[i], kick_y = dt / 2 * f->ay[i];
        sph2d_vec2 v = {f->vx[i] + kick_x, f->vy[i] + kick_y};
        sph2d_vec2 from = {f->x[i], f->y[i]};
        if (s->walls_reflect)
            reflections += reflect(s, from, &v);
        sph2d_vec2 to = {from.x + dt * v.x, from.y + dt * v.y};
        hits += (uint64_t)sph2d__barrier_sweep(&sim->barrier, from, &to, &v);
        bad += !isfinite(to.x + to.y);
        f->x[i] = to.x;
        f->y[i] = to.y;
        f->vx[i] = v.x + kick_x;
        f->vy[i] = v.y + kick_y;
    }
    sim->record.backstop_hits += hits;
    sim->record.reflections += reflections;
    return bad == 0;
}

/** Keeps a(n) beside, so that the second kick can take the prediction back. */
static void keep_accelerations(sph2d__store *f)
{
    double *x = f->old_ax, *y = f->old_ay;
    f->old_ax = f->ax;
    f->old_ay = f->ay;
    f->ax = x;
    f->ay = y;
}

/** From the predicted v(n+1/2) + dt/2 a(n) to v(n+1/2) + dt/2 a(n+1). */
static void kick(sph2d__system *s, double dt)
{
    sph2d__store *f = &s->fluid;
    int threads = sph2d__threads_for(s->threads, f->count);
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
    for (size_t i = 0; i < f->count; ++i) {
        f->vx[i] += dt / 2 * (f->ax[i] - f->old_ax[i]);
        f->vy[i] += dt / 2 * (f->ay[i] - f->old_ay[i]);
    }
}

static sph2d_status halt(sph2d_sim *sim, sph2d_status status, sph2d_report *report)
{
    sim->stopped = status;
    if (status == SPH2D_NOMEM)
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL, "out of memory in step %llu",
                         (unsigned long long)sim->record.steps);
    return status;
}

static void count_limit(sph2d__record *r, uint64_t limit)
{
    uint64_t *counters[SPH2D__LIMIT_COUNT] = {&r->limited_acoustic, &r->limited_force, &r->limited_viscous,
                                              &r->limited_fixed};
    ++*counters[limit];
}

static void advance_clock(sph2d_sim *sim, double dt)
{
    sph2d__record *r = &sim->record;
    count_limit(r, r->next_limit);
    r->time += dt;
    r->last_step = dt;
    r->step_min = r->steps == 0 || dt < r->step_min ? dt : r->step_min;
    r->step_max = dt > r->step_max ? dt : r->step_max;
    ++r->steps;
    r->particle_steps += sim->system.fluid.count;
}

sph2d_status sph2d_sim_step(sph2d_sim *sim, sph2d_report *report)
{
    if (sim->stopped != SPH2D_OK) {
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL, "no step can follow: %s",
                         sph2d_status_text(sim->stopped));
        return sim->stopped;
    }
    sph2d_status status = sph2d__sim_feed(sim);
    if (status == SPH2D_OK)
        status = sph2d__sim_drain(sim);
    if (status != SPH2D_OK)
        return halt(sim, status, report);
    double dt = sim->record.next_step;
    if (!kick_drift(sim, dt)) {
        sph2d__sim_measure(sim, report); /* names the particle */
        return halt(sim, SPH2D_GUARD, report);
    }
    sph2d__system *s = &sim->system;
    if (!sph2d__cells_build(&s->fluid_cells, &s->fluid, s->support, s->memory, s->threads))
        return halt(sim, SPH2D_NOMEM, report);
    keep_accelerations(&s->fluid);
    sph2d__sim_aim(sim, sim->record.time + dt);
    sim->method->evaluate(s);
    kick(s, dt);
    advance_clock(sim, dt);
    if (!sph2d__sim_measure(sim, report))
        return halt(sim, SPH2D_GUARD, report);
    sph2d__sim_sample(sim);
    return SPH2D_OK;
}
