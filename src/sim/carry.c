/* SPDX-License-Identifier: MIT */
/** @file carry.c
 *  What every scheme does with a particle on its way: walls, periodic sides, sorting, the second kick. */
#include <math.h>

#include "base/threads.h"
#include "sim/integrators.h"

/** Reflects a velocity off the nearest boundary particle that is within one spacing and ahead, if that one reflects:
 *  the part along the line between the two is turned round and damped. */
static bool reflect(const sph2d__system *s, sph2d_vec2 p, sph2d_vec2 *v)
{
    uint32_t cell = sph2d__cells_find(&s->wall_cells, p.x, p.y);
    if (cell == UINT32_MAX)
        return false;
    sph2d__ranges ranges;
    sph2d__cells_ranges(&s->wall_cells, cell, &ranges);
    double nearest2 = s->spacing * s->spacing;
    size_t nearest = SIZE_MAX;
    double nx = 0, ny = 0;
    SPH2D__FOR_NEIGHBOURS (&ranges, r, b) {
        double dx = p.x + ranges.x[r] - s->walls.x[b], dy = p.y + ranges.y[r] - s->walls.y[b];
        double r2 = dx * dx + dy * dy;
        if (s->walls.bounce[b] >= 0 && r2 < nearest2 && r2 > 0) {
            nearest2 = r2;
            nearest = b;
            nx = dx;
            ny = dy;
        }
    }
    if (nearest == SIZE_MAX)
        return false;
    double along = (v->x * nx + v->y * ny) / nearest2;
    if (along >= 0)
        return false;
    double turn = (1 + s->walls.bounce[nearest]) * along;
    v->x -= turn * nx;
    v->y -= turn * ny;
    return true;
}

/** Holds a motion on its side of every obstacle that moves: swept where the obstacle is at rest. */
static uint64_t sweep_moving(const sph2d_sim *sim, sph2d_vec2 from, sph2d_vec2 *to, sph2d_vec2 *v)
{
    uint64_t hits = 0;
    for (size_t k = 0; k < sim->moving_count; ++k) {
        const sph2d__moving *m = &sim->moving[k];
        sph2d_vec2 a = {from.x - m->from.x, from.y - m->from.y}, b = {to->x - m->to.x, to->y - m->to.y};
        sph2d_vec2 relative = {v->x - m->velocity.x, v->y - m->velocity.y};
        uint64_t met = (uint64_t)sph2d__barrier_sweep(&m->barrier, a, &b, &relative);
        if (met == 0)
            continue;
        hits += met;
        *to = (sph2d_vec2){b.x + m->to.x, b.y + m->to.y};
        *v = (sph2d_vec2){relative.x + m->velocity.x, relative.y + m->velocity.y};
    }
    return hits;
}

void sph2d__carry_held(sph2d_sim *sim, size_t i, double dx, double dy, sph2d_vec2 *v, sph2d__events *events)
{
    sph2d__store *f = &sim->system.fluid;
    const sph2d__period *period = &sim->system.fluid_cells.period;
    sph2d_vec2 from = {f->x[i], f->y[i]};
    if (sim->system.walls_reflect) {
        sph2d_vec2 before = *v;
        if (reflect(&sim->system, from, v)) {
            ++events->reflections;
            double dt = sim->system.step;
            dx += dt * (v->x - before.x);
            dy += dt * (v->y - before.y);
        }
    }
    sph2d_vec2 to = {from.x + dx, from.y + dy};
    events->hits += (uint64_t)sph2d__barrier_sweep(&sim->barrier, from, &to, v);
    if (sim->moving_count > 0)
        events->hits += sweep_moving(sim, from, &to, v);
    sph2d_vec2 in = {sph2d__period_wrap(to.x, period->low_x, period->length_x),
                     sph2d__period_wrap(to.y, period->low_y, period->length_y)};
    if (in.x != to.x || in.y != to.y) { /* the last part of the way lies at the other side */
        from = (sph2d_vec2){from.x + in.x - to.x, from.y + in.y - to.y};
        events->hits += (uint64_t)sph2d__barrier_sweep(&sim->barrier, from, &in, v);
    }
    events->bad += !isfinite(in.x + in.y + v->x + v->y);
    f->x[i] = in.x;
    f->y[i] = in.y;
    f->vx[i] = v->x;
    f->vy[i] = v->y;
}

sph2d_status sph2d__count_events(sph2d_sim *sim, const sph2d__events *events)
{
    sim->record.backstop_hits += events->hits;
    sim->record.reflections += events->reflections;
    return events->bad == 0 ? SPH2D_OK : SPH2D_GUARD;
}

sph2d_status sph2d__sort_fluid(sph2d_sim *sim)
{
    sph2d__system *s = &sim->system;
    sph2d_phase before = sph2d__profile_enter(&s->profile, SPH2D_PHASE_SORT);
    bool sorted = sph2d__cells_build(&s->fluid_cells, &s->fluid, s->reach, s->memory, s->threads);
    sph2d__profile_enter(&s->profile, before);
    return sorted ? SPH2D_OK : SPH2D_NOMEM;
}

/* Shifting is a diffusion of particles with D = gain U H: explicit steps stand D dt / H^2 of this. */
static const double SHIFT_LIMIT = 0.1;

void sph2d__limit_shift(sph2d__system *s, double gain, double dt)
{
    double most = s->speed > 0 ? SHIFT_LIMIT * s->support / (s->speed * dt) : INFINITY;
    s->shift_gain = fmin(s->method.shifting * gain, most);
}

void sph2d__keep_accelerations(sph2d__store *f)
{
    double *x = f->old_ax, *y = f->old_ay;
    f->old_ax = f->ax;
    f->old_ay = f->ay;
    f->ax = x;
    f->ay = y;
}

void sph2d__second_kick(sph2d__system *s, double dt)
{
    sph2d__store *f = &s->fluid;
    int threads = sph2d__threads_for(s->threads, f->count);
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
    for (size_t i = 0; i < f->count; ++i) {
        f->vx[i] += dt / 2 * (f->ax[i] - f->old_ax[i]);
        f->vy[i] += dt / 2 * (f->ay[i] - f->old_ay[i]);
    }
}
