/* SPDX-License-Identifier: MIT */
/** @file stages.c
 *  Stages that time schemes share besides advection: sorting, the limit of shifting. */
#include "sim/stages.h"

#include <math.h>

#include "sim/device_steps.h"

sph2d_status sph2d__sort_fluid(sph2d_sim *sim)
{
    sph2d__system *s = &sim->system;
    sph2d_phase before = sph2d__profile_enter(&s->profile, SPH2D_PHASE_SORT);
    bool sorted = sph2d__is_on_device(s) ? sph2d__device_sort(s)
                                         : sph2d__cells_build(&s->fluid_cells, &s->fluid, s->reach, s->memory);
    sph2d__profile_enter(&s->profile, before);
    return sorted ? SPH2D_OK : SPH2D_NOMEM;
}

void sph2d__limit_shift(sph2d__system *s, double gain, double limit, double dt)
{
    double max_gain = s->speed > 0 ? limit * s->support / (s->speed * dt) : INFINITY;
    s->shift_gain = fmin(s->method.shifting * gain, max_gain);
}

void sph2d__keep_accelerations(sph2d__store *f)
{
    double *x = f->old_ax, *y = f->old_ay;
    f->old_ax = f->ax;
    f->old_ay = f->ay;
    f->ax = x;
    f->ay = y;
}
