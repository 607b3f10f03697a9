/* SPDX-License-Identifier: MIT */
/** @file advance.c
 *  One step of method `wcsph` with variational operators: acoustic steps over pairs that stand still in the middle of it,
 *
 *      theta <- theta + dt/2 D(v),  x <- x + dt/2 v
 *      v     <- v + dt f(theta)/m
 *      theta <- theta + dt/2 D(v),  x <- x + dt/2 v,  theta <- theta + dt diffusion
 *
 *  With a fixed pair of transposed operators it keeps K + U - m (c0 dt D)^2/8 (Hairer, Lubich & Wanner 2006, sec. IX.8), so
 *  that K + U falls by what D^2 rises when neighbours are found anew. That is booked as dissipated. */
#include <math.h>
#include <string.h>

#include "base/parallel.h"
#include "methods/variational/variational.h"
#include "sim/stages.h"

/** Puts the particles where they will be in the middle of the step; next_x and next_y keep where they were. */
static void go_to_middle(sph2d__system *s, size_t first, size_t last)
{
    sph2d__store *f = &s->fluid;
    const sph2d__period *p = &s->fluid_cells.period;
    for (size_t i = first; i < last; ++i) {
        f->next_x[i] = f->x[i];
        f->next_y[i] = f->y[i];
        f->x[i] = sph2d__period_wrap(f->x[i] + s->step / 2 * f->vx[i], p->low_x, p->length_x);
        f->y[i] = sph2d__period_wrap(f->y[i] + s->step / 2 * f->vy[i], p->low_y, p->length_y);
    }
}

static void go_back(sph2d__system *s, size_t first, size_t last)
{
    sph2d__store *f = &s->fluid;
    memcpy(f->x + first, f->next_x + first, (last - first) * sizeof *f->x);
    memcpy(f->y + first, f->next_y + first, (last - first) * sizeof *f->y);
}

/** The whole way of the step. */
static void go(sph2d_sim *sim, double dt, sph2d__batch *w)
{
    const sph2d__store *f = &sim->system.fluid;
    (void)dt;
    for (size_t k = 0, i = w->first; k < w->count; ++k, ++i) {
        w->dx[k] = sim->system.frozen->px[i] - f->x[i];
        w->dy[k] = sim->system.frozen->py[i] - f->y[i];
        w->vx[k] = f->vx[i];
        w->vy[k] = f->vy[i];
    }
}

/* ---- relaxation of density --------------------------------------------------------------------------------------- */

/* In how many H/c0 density goes to its sum over the neighbours. */
static const double RELAXATION_TIME = 100;

/** What a particle's theta changes by, in a part of its way to the sum. */
static double relaxed(const sph2d__system *s, size_t i, double part)
{
    return part * s->frozen->summed[i] / sph2d__density_ratio(s->fluid.excess[i]);
}

/** Sums up theta^2/2 that relaxation adds. */
static void sum_relaxed(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const double *part = with;
    for (size_t i = slab->first; i < slab->last; ++i) {
        const double change = relaxed(s, i, *part);
        sum->first += change * (s->fluid.excess[i] + change / 2);
    }
}

static void relax_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const double *part = with;
    sum_relaxed(s, slab, with, sum);
    for (size_t i = slab->first; i < slab->last; ++i)
        s->fluid.excess[i] += relaxed(s, i, *part);
}

/** Moves densities towards their sums, as far as what was dissipated pays for it. */
static void relax(sph2d_sim *sim, double dt)
{
    sph2d__system *s = &sim->system;
    sph2d__record *r = &sim->record;
    double part = fmin(dt * s->sound_speed / (RELAXATION_TIME * s->support), 1);
    const double stiffness = s->mass * s->sound_speed * s->sound_speed;
    const double asked = stiffness * sph2d__over_fluid(s, sum_relaxed, &part).first;
    const double left = fmax(r->energy_pressed + r->energy_diffused, 0);
    if (asked > left)
        part *= left / asked;
    r->energy_diffused -= stiffness * sph2d__over_fluid(s, relax_slab, &part).first;
}

/* ---- the step ---------------------------------------------------------------------------------------------------- */

/* The most that Z is. */
static const double DAMPING = 0.1;

/** Z m c0 H of particle i. The rows of D have no larger sum than 2 g = 2 ((|B| + |C|) sum |G| + |S|), nor, where particles
 *  are alike, the columns of its transpose: an acoustic step dt is stable with Z c0 H (2 g)^2 dt = 2, and here it is 1. */
static double damping_of(const sph2d__system *s, size_t i)
{
    const sph2d__frozen *z = s->frozen;
    const double trace = z->bxx[i] + z->byy[i], det = z->bxx[i] * z->byy[i] - z->bxy[i] * z->bxy[i];
    const double largest = (trace + sqrt(fmax(trace * trace - 4 * det, 0))) / 2;
    const double turned2 =
        z->cxx[i] * z->cxx[i] + z->cxy[i] * z->cxy[i] + z->cyx[i] * z->cyx[i] + z->cyy[i] * z->cyy[i];
    const double g = (largest + sqrt(turned2)) * z->weight[i] + sqrt(z->sx[i] * z->sx[i] + z->sy[i] * z->sy[i]);
    const double diffusivity = DAMPING * s->sound_speed * s->support, bound = 4 * g * g * z->dt;
    return s->mass * (diffusivity * bound > 1 ? 1 / bound : diffusivity);
}

static void start_slab(sph2d__system *s, size_t first, size_t last)
{
    sph2d__frozen *z = s->frozen;
    sph2d__store *f = &s->fluid;
    for (size_t i = first; i < last; ++i) {
        float v[2] = {(float)f->vx[i], (float)f->vy[i]};
        memcpy(z->velocity + i, v, sizeof v);
        z->zx[i] = z->cxx[i] * f->vx[i] + z->cyx[i] * f->vy[i] + z->wall_zx[i];
        z->zy[i] = z->cxy[i] * f->vx[i] + z->cyy[i] * f->vy[i] + z->wall_zy[i];
        z->next_zx[i] = z->next_zy[i] = z->diffused[i] = 0; /* where no wall is they stay so */
        z->damping[i] = damping_of(s, i);
        z->px[i] = f->next_x[i];
        z->py[i] = f->next_y[i];
    }
}

/** For how long rates act before diffusion, and after it. */
typedef struct times {
    double before, after;
} times;

static void rate_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const times *t = with;
    sph2d__variational_find(s->isa)->rate(s, slab->first, slab->last, t->before, t->after, sum);
}

static void force_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    (void)with;
    sph2d__variational_find(s->isa)->force(s, slab->first, slab->last, sum);
}

static void swap(double **a, double **b)
{
    double *c = *a;
    *a = *b;
    *b = c;
}

/** Densities and pressures that are read from outside. */
static void report(sph2d__system *s, size_t first, size_t last)
{
    const sph2d__store *f = &s->fluid;
    const double c2 = s->sound_speed * s->sound_speed;
    for (size_t i = first; i < last; ++i) {
        f->density[i] = s->rest_density * sph2d__density_ratio(f->excess[i]);
        f->pressure[i] = f->density[i] * c2 * f->excess[i];
    }
}

/** The acoustic steps. */
static void sound(sph2d_sim *sim, double dt)
{
    sph2d__system *s = &sim->system;
    sph2d__frozen *z = s->frozen;
    const size_t steps = sph2d__acoustic_steps(s, dt);
    z->dt = dt / (double)steps;
    z->share = 1 / (double)steps;
    sph2d__over_particles(s, s->fluid.count, start_slab);
    const double half = z->dt / 2;
    sph2d__slab_sum rates = sph2d__over_fluid(s, rate_slab, &(times){0, half});
    const double before = rates.third;
    sim->record.energy_pressed += rates.first;
    for (size_t k = 1; k <= steps; ++k) {
        const sph2d__slab_sum work = sph2d__over_fluid(s, force_slab, NULL);
        sim->record.energy_pressed -= work.first;
        sim->record.energy_viscous -= work.second;
        swap(&z->velocity, &z->next_velocity);
        swap(&z->zx, &z->next_zx);
        swap(&z->zy, &z->next_zy);
        rates = sph2d__over_fluid(s, rate_slab, &(times){half, k < steps ? half : 0});
        sim->record.energy_diffused -= rates.second;
        sim->record.energy_pressed += rates.first;
    }
    sph2d__over_particles(s, s->fluid.count, report);
    sim->record.energy_pressed +=
        s->mass * s->sound_speed * s->sound_speed * z->dt * z->dt / 8 * (before - rates.third);
}

sph2d_status sph2d__variational_step(sph2d_sim *sim, double dt)
{
    sph2d__system *s = &sim->system;
    const double start = sim->record.time, middle = start + dt / 2, end = start + dt;
    sph2d__over_particles(s, s->fluid.count, go_to_middle);
    sph2d_status status = sph2d__sort_fluid(sim);
    if (status == SPH2D_OK)
        status = sph2d__sim_update_forcing(sim, middle);
    if (status != SPH2D_OK)
        return status;
    sph2d__profile_enter(&s->profile, SPH2D_PHASE_SEARCH);
    if (!sph2d__frozen_gather(s))
        return SPH2D_NOMEM;
    sph2d__profile_enter(&s->profile, SPH2D_PHASE_FORCES);
    relax(sim, dt);
    sound(sim, dt);
    if (s->walls_move)
        sph2d__sim_book_wall_work(sim, dt);
    sph2d__loads_find(sim, 1);
    sph2d__profile_enter(&s->profile, SPH2D_PHASE_MOVE);
    sph2d__over_particles(s, s->fluid.count, go_back);
    sph2d__sim_set_drift_interval(sim, start, end);
    status = sph2d__advect(sim, dt, go, NULL);
    if (status == SPH2D_OK)
        status = sph2d__sort_fluid(sim);
    return status == SPH2D_OK ? sph2d__sim_update_forcing(sim, end) : status;
}
