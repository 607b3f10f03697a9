/* SPDX-License-Identifier: MIT */
/** @file pair.h
 *  The terms of a pair, the same in every way through the pairs: continuity with diffusion of density (Molteni &
 *  Colagrossi 2009), pressure, Monaghan's viscosity. */
#ifndef SPH2D_TESTS_BENCH_PAIR_H
#define SPH2D_TESTS_BENCH_PAIR_H

#include "kernels/kernel.h"
#include "variants.h"

/** The same in all lanes, of what is in memory: one instruction. (Of 0 + a, as sph2d__lanes_all has it, a compiler
 *  must add the 0 first, since -0 + 0 is 0.) */
SPH2D__INLINE sph2d__lanes everywhere(double a)
{
    return a - (sph2d__lanes){0};
}

/** What the loops ask of a scene. */
typedef struct terms {
    double inverse_support, diffusion, damping;
} terms;

static inline terms terms_of(const field *f)
{
    return (terms){1 / f->scene.support, f->scene.diffusion, -8 * f->scene.viscosity};
}

/** The particle for which sums are made, or several; `own` is p V^2, `damping` makes viscosity of the same unit. */
typedef struct receiver {
    sph2d__lanes x, y, vx, vy, density, own, damping;
} receiver;

/** A candidate in all lanes, or several. */
typedef struct candidate {
    sph2d__lanes x, y, vx, vy, density, pressure, volume;
} candidate;

typedef struct sums {
    sph2d__lanes flux, x, y;
} sums;

/* In place of 0 where it is divided by. */
#define TINY 1e-300

SPH2D__INLINE void add_pair(sums *to, const terms *n, const receiver *me, const candidate *you)
{
    sph2d__lanes dx = me->x - you->x, dy = me->y - you->y, r2 = dx * dx + dy * dy;
    sph2d__lanes g = sph2d__kernel_slope(SPH2D_KERNEL_WENDLAND_C2, sph2d__lanes_sqrt(r2) * n->inverse_support);
    sph2d__lanes approach = (me->vx - you->vx) * dx + (me->vy - you->vy) * dy;
    sph2d__lanes stress = me->own + you->pressure * you->volume * you->volume;
    stress += approach / sph2d__lanes_max(r2, sph2d__lanes_all(TINY)) * (me->damping * you->volume);
    sph2d__lanes press = g * stress;
    to->flux += g * (approach + (me->density - you->density) * (n->diffusion * you->volume));
    to->x += press * dx;
    to->y += press * dy;
}

/** Particles `first` and so on. */
SPH2D__INLINE receiver receivers_at(const sph2d__store *s, const terms *n, size_t first)
{
    sph2d__lanes volume = sph2d__lanes_load(s->volume + first);
    return (receiver){sph2d__lanes_load(s->x + first),
                      sph2d__lanes_load(s->y + first),
                      sph2d__lanes_load(s->vx + first),
                      sph2d__lanes_load(s->vy + first),
                      sph2d__lanes_load(s->density + first),
                      sph2d__lanes_load(s->pressure + first) * volume * volume,
                      n->damping * volume};
}

/** Particle i in all lanes. */
SPH2D__INLINE receiver receiver_at(const sph2d__store *s, const terms *n, size_t i)
{
    double volume = s->volume[i];
    return (receiver){everywhere(s->x[i]),
                      everywhere(s->y[i]),
                      everywhere(s->vx[i]),
                      everywhere(s->vy[i]),
                      everywhere(s->density[i]),
                      everywhere(s->pressure[i] * volume * volume),
                      everywhere(n->damping * volume)};
}

SPH2D__INLINE candidate candidate_at(const sph2d__store *s, size_t j)
{
    return (candidate){everywhere(s->x[j]),     everywhere(s->y[j]),       everywhere(s->vx[j]),
                       everywhere(s->vy[j]),    everywhere(s->density[j]), everywhere(s->pressure[j]),
                       everywhere(s->volume[j])};
}

SPH2D__INLINE candidate candidates_at(const sph2d__store *s, size_t first)
{
    return (candidate){sph2d__lanes_load(s->x + first),       sph2d__lanes_load(s->y + first),
                       sph2d__lanes_load(s->vx + first),      sph2d__lanes_load(s->vy + first),
                       sph2d__lanes_load(s->density + first), sph2d__lanes_load(s->pressure + first),
                       sph2d__lanes_load(s->volume + first)};
}

/** Writes what the sums of particle i stand for. */
SPH2D__INLINE void write_sums(field *f, size_t i, double flux, double x, double y)
{
    double scale = f->scene.scale;
    f->store.density_rate[i] = scale * f->scene.mass * flux;
    f->store.ax[i] = -scale / f->scene.mass * x;
    f->store.ay[i] = -scale / f->scene.mass * y;
}

/** The same of particles `first` and so on, `count` of them. */
SPH2D__INLINE void write_lanes(field *f, size_t first, int count, const sums *from)
{
    for (int l = 0; l < SPH2D__LANES && l < count; ++l)
        write_sums(f, first + (size_t)l, from->flux[l], from->x[l], from->y[l]);
}

SPH2D__INLINE double total(sph2d__lanes a)
{
    double sum = 0;
    for (int l = 0; l < SPH2D__LANES; ++l)
        sum += a[l];
    return sum;
}

/** The same of particle i, whose sums are spread over the lanes. */
SPH2D__INLINE void write_total(field *f, size_t i, const sums *from)
{
    write_sums(f, i, total(from->flux), total(from->x), total(from->y));
}

#endif
