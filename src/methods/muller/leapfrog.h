/* SPDX-License-Identifier: MIT */
/** @file leapfrog.h
 *  What kick-drift-kick does to one particle, in C and in OpenCL C: leapfrog.c. */
#ifndef SPH2D_METHODS_MULLER_LEAPFROG_H
#define SPH2D_METHODS_MULLER_LEAPFROG_H

#include "sim/displaced.h"

/** The first kick, and the way with it. */
static inline sph2d__way sph2d__kick_drift(const sph2d__system *s, double dt, size_t i)
{
    const sph2d__store *f = &s->fluid;
    const sph2d_vec2 v = {f->vx[i] + dt / 2 * f->ax[i], f->vy[i] + dt / 2 * f->ay[i]};
    return (sph2d__way){dt * v.x, dt * v.y, v, 0, 0};
}

/** Predicts the velocity with which a(n+1) is evaluated: v(n+1/2) + dt/2 a(n). */
static inline void sph2d__predict(const sph2d__system *s, double dt, size_t i)
{
    const sph2d__store *f = &s->fluid;
    f->vx[i] += dt / 2 * f->ax[i];
    f->vy[i] += dt / 2 * f->ay[i];
}

/** From the predicted v(n+1/2) + dt/2 a(n) to v(n+1/2) + dt/2 a(n+1). */
static inline void sph2d__second_kick(sph2d__system *s, size_t first, size_t last)
{
    const sph2d__store *f = &s->fluid;
    for (size_t i = first; i < last; ++i) {
        f->vx[i] += s->step / 2 * (f->ax[i] - f->old_ax[i]);
        f->vy[i] += s->step / 2 * (f->ay[i] - f->old_ay[i]);
    }
}

#endif
