/* SPDX-License-Identifier: MIT */
/** @file displaced.h
 *  One particle on its way through an advection, in C and in OpenCL C: what walls at rest and periodic sides do to it. */
#ifndef SPH2D_SIM_DISPLACED_H
#define SPH2D_SIM_DISPLACED_H

#include "boundary/barrier.h"
#include "sim/balance.h"

/** A particle, and for how long its acceleration acted in the kick before this displacement [s]. */
typedef struct sph2d__kicked {
    size_t particle;
    double duration;
} sph2d__kicked;

/** The way of a particle in an advection. */
typedef struct sph2d__way {
    double dx, dy;   /**< displacement [m] */
    sph2d_vec2 v;    /**< velocity, which walls may change [m/s] */
    double kick;     /**< for how long the accelerations have just acted, and elastic energy not yet [s] */
    double diffused; /**< elastic energy lost otherwise than by its velocity [J/m] */
} sph2d__way;

/** Position and velocity of a particle after its displacement. */
typedef struct sph2d__end {
    sph2d_vec2 at, v;
} sph2d__end;

/** What happened to particles during an advection. */
typedef struct sph2d__events {
    uint64_t hits, reflections, not_finite;
    /** Energy lost to walls, gained from moving ones, and lost by changes of density, in quanta (simulation.h). */
    int64_t stopped, driven, diffused;
    uint64_t noted; /**< on a device: contacts with walls that are listed for loads */
} sph2d__events;

/** By how much the liquid's own forces changed its velocity in the kick. Elastic energy pays for it, by the velocity that
 *  the wall leaves: a particle that pressure pulls against a wall, which stops it in each step, loses nothing. Without
 *  this 16 particles that fell on the upper end of a line lost 58 % of the energy scale more, and two that a rim held
 *  63 J/m per second, 70 times their potential energy. */
static inline sph2d_vec2 sph2d__push_of(const sph2d__system *s, sph2d__kicked k)
{
    const sph2d__store *f = &s->fluid;
    const size_t i = k.particle;
    double bx = 0, by = 0;
    if (!(k.duration > 0))
        return (sph2d_vec2){0, 0};
    sph2d__forces_add(&s->forces, (sph2d__place){f->x[i], f->y[i], f->vx[i], f->vy[i]}, &bx, &by);
    return (sph2d_vec2){k.duration * (f->ax[i] - bx), k.duration * (f->ay[i] - by)};
}

/** Energy of a particle whose position and velocity a wall changes [J/m]: kinetic and potential, less what the kick has
 *  added before elastic energy paid for it. */
static inline double sph2d__energy_kicked(const sph2d__system *s, sph2d__kicked k, sph2d__end end)
{
    const sph2d_vec2 push = sph2d__push_of(s, k);
    return s->mass * sph2d__energy_at(s, end.at.x, end.at.y, end.v.x, end.v.y) -
           s->mass * (push.x * end.v.x + push.y * end.v.y);
}

/** An energy in quanta; 0 if it is more than a particle of a valid run has. */
static inline int64_t sph2d__quanta_of(double quantum, double energy)
{
    const double quanta = energy / quantum;
    return fabs(quanta) < 1e15 ? (int64_t)quanta : 0;
}

/** The difference of a particle's energy between two ends, in quanta. */
static inline int64_t sph2d__quanta_between(const sph2d__system *s, double quantum, sph2d__kicked k, sph2d__end more,
                                            sph2d__end less)
{
    return sph2d__quanta_of(quantum, sph2d__energy_kicked(s, k, more) - sph2d__energy_kicked(s, k, less));
}

/** Wraps the end of a displacement at periodic sides, and moves its start along. True if it has to be swept once more: beside
 *  the opposite side there may be walls. */
static inline bool sph2d__wrap_end(const sph2d__period *period, sph2d_vec2 *from, sph2d_vec2 *to)
{
    const sph2d_vec2 in = {sph2d__period_wrap(to->x, period->low_x, period->length_x),
                           sph2d__period_wrap(to->y, period->low_y, period->length_y)};
    const bool wrapped = in.x != to->x || in.y != to->y;
    if (wrapped)
        *from = (sph2d_vec2){from->x + in.x - to->x, from->y + in.y - to->y};
    *to = in;
    return wrapped;
}

#endif
