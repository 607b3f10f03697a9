/* SPDX-License-Identifier: MIT */
/** @file stages.c
 *  Stages that time schemes share besides advection: sorting, the limit of shifting, prediction, the second kick. */
#include "sim/stages.h"

#include <math.h>

#include "base/parallel.h"

sph2d_status sph2d__sort_fluid(sph2d_sim *sim)
{
    sph2d__system *s = &sim->system;
    sph2d_phase before = sph2d__profile_enter(&s->profile, SPH2D_PHASE_SORT);
    bool sorted = sph2d__cells_build(&s->fluid_cells, &s->fluid, s->reach, s->memory);
    sph2d__profile_enter(&s->profile, before);
    return sorted ? SPH2D_OK : SPH2D_NOMEM;
}

void sph2d__limit_shift(sph2d__system *s, double gain, double limit, double dt)
{
    double max_gain = s->speed > 0 ? limit * s->support / (s->speed * dt) : INFINITY;
    s->shift_gain = fmin(s->method.shifting * gain, max_gain);
}

void sph2d__predict(sph2d_sim *sim, double dt, sph2d__batch *w)
{
    const sph2d__store *f = &sim->system.fluid;
    for (size_t i = w->first; i < w->first + w->count; ++i) {
        f->vx[i] += dt / 2 * f->ax[i];
        f->vy[i] += dt / 2 * f->ay[i];
    }
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
    const sph2d__store *f = &s->fluid;
#pragma omp taskloop num_tasks(sph2d__tasks(f->count, SPH2D__GRAIN)) if (f->count > SPH2D__GRAIN)
    for (size_t i = 0; i < f->count; ++i) {
        f->vx[i] += dt / 2 * (f->ax[i] - f->old_ax[i]);
        f->vy[i] += dt / 2 * (f->ay[i] - f->old_ay[i]);
    }
}
