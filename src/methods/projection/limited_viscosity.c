/* SPDX-License-Identifier: MIT */
/** @file limited_viscosity.c
 *  The loop of limited_viscosity.h for the instruction set in use. */
#include "methods/projection/limited_viscosity.h"

#include <math.h>

#include "methods/common/slabs.h"

double sph2d__limited_viscosity_of(const sph2d__system *s)
{
    return s->method.artificial_viscosity * sqrt(fmax(s->head, 0)) * s->support / 16;
}

static void accelerate_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const double *nu = with;
    (void)sum;
    sph2d__limited_viscosity_pass_find(s->isa)->accelerate(s, *nu, slab->first, slab->last);
}

/** Changes the velocities; sums the energy that this takes, over mass. */
static void kick_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const double *dt = with;
    sph2d__store *f = slab->rows;
    double taken = 0;
    (void)s;
    for (size_t i = slab->first; i < slab->last; ++i) {
        double x = *dt * f->next_x[i], y = *dt * f->next_y[i];
        taken -= x * (f->vx[i] + x / 2) + y * (f->vy[i] + y / 2);
        f->vx[i] += x;
        f->vy[i] += y;
    }
    sum->first = taken;
}

double sph2d__limited_viscosity_apply(sph2d__system *s, double dt)
{
    double nu = sph2d__limited_viscosity_of(s);
    sph2d__store *f = &s->fluid;
    if (!(nu > 0) || f->count == 0)
        return 0;
    /* The particle that shorter lists end with has gradients of zero; its values only have to be finite. */
    f->vx[f->count] = f->vy[f->count] = f->stretch[f->count] = f->shear[f->count] = f->density_rate[f->count] = 0;
    sph2d__over_fluid(s, accelerate_slab, &nu, NULL, 0);
    return s->mass * sph2d__over_fluid(s, kick_slab, &dt, NULL, 0).first;
}
