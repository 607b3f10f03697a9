/* SPDX-License-Identifier: MIT */
/** @file balance.h
 *  What the balances of energy and momentum sum up: the part of one particle, which adds once to each sum, so that a loop over
 *  particles and a device that has one for each of its threads make the same bits. */
#ifndef SPH2D_SIM_BALANCE_H
#define SPH2D_SIM_BALANCE_H

#include "methods/common/slab.h"

/** Kinetic and potential energy per mass at a place with a velocity [J/kg]. */
static inline double sph2d__energy_at(const sph2d__system *s, double x, double y, double vx, double vy)
{
    return (vx * vx + vy * vy) / 2 + sph2d__forces_potential(&s->forces, x, y);
}

/** Adds particle i: kinetic, kinetic and potential, elastic energy per mass [J/kg], of which the last is given; the velocity, and the
 *  largest square of one. */
static inline void sph2d__add_energy(const sph2d__system *s, size_t i, double elastic, sph2d__slab_sum *sum)
{
    const sph2d__store *f = &s->fluid;
    const double v2 = f->vx[i] * f->vx[i] + f->vy[i] * f->vy[i];
    sum->first += v2 / 2;
    sum->second += sph2d__energy_at(s, f->x[i], f->y[i], f->vx[i], f->vy[i]);
    sum->third += elastic;
    sum->x += f->vx[i];
    sum->y += f->vy[i];
    sum->most = v2 > sum->most ? v2 : sum->most;
}

/** Adds particle i: velocity, speed [m/s], and the external acceleration [m/s^2] in `first` and `second`. */
static inline void sph2d__add_momentum(const sph2d__system *s, const sph2d__forces *external, size_t i,
                                       sph2d__slab_sum *sum)
{
    const sph2d__store *f = &s->fluid;
    double ax = 0, ay = 0;
    sph2d__forces_add(external, (sph2d__place){f->x[i], f->y[i], f->vx[i], f->vy[i]}, &ax, &ay);
    sum->x += f->vx[i];
    sum->y += f->vy[i];
    sum->third += sqrt(f->vx[i] * f->vx[i] + f->vy[i] * f->vy[i]);
    sum->first += ax;
    sum->second += ay;
}

/** Adds the power of forces without a potential whose work is of a kind on particle i, per mass [W/kg]. */
static inline void sph2d__add_power(const sph2d__system *s, sph2d__work_kind kind, size_t i, sph2d__slab_sum *sum)
{
    const sph2d__store *f = &s->fluid;
    double ax = 0, ay = 0;
    sph2d__forces_drive(&s->forces, kind, (sph2d__place){f->x[i], f->y[i], f->vx[i], f->vy[i]}, &ax, &ay);
    sum->first += f->vx[i] * ax + f->vy[i] * ay;
}

/** Adds particle i: the power of its acceleration, per mass, and in `second` that of the part of external forces that is odd in
 *  velocity [W/kg]. */
static inline void sph2d__add_work(const sph2d__system *s, size_t i, sph2d__slab_sum *sum)
{
    const sph2d__store *f = &s->fluid;
    const double x = f->x[i], y = f->y[i], vx = f->vx[i], vy = f->vy[i];
    double forward[2] = {0, 0}, reversed[2] = {0, 0};
    sph2d__forces_add(&s->forces, (sph2d__place){x, y, vx, vy}, &forward[0], &forward[1]);
    sph2d__forces_add(&s->forces, (sph2d__place){x, y, -vx, -vy}, &reversed[0], &reversed[1]);
    sum->first += vx * f->ax[i] + vy * f->ay[i];
    sum->second += vx * (forward[0] - reversed[0]) / 2 + vy * (forward[1] - reversed[1]) / 2;
}

/** Whose forces of sides are summed up: the side, or SPH2D__WALL_ALL, and the point of torques. */
typedef struct sph2d__side_load {
    int side;
    sph2d_vec2 about;
} sph2d__side_load;

/** Adds what particle i does to sides, per mass: by springs in `first`, `second` and, a torque, `third`; by what is imagined
 *  behind them, which pushes by `fill` away from each [m/s^2], in x, y and `fourth`. */
static inline void sph2d__add_sides(const sph2d__system *s, const sph2d__side_load *load, size_t i,
                                    const double fill[4], sph2d__slab_sum *sum)
{
    const sph2d__store *f = &s->fluid;
    const sph2d__springs *w = &s->forces.springs;
    const double distance[4] = {f->x[i] - w->left, w->right - f->x[i], f->y[i] - w->bottom, w->top - f->y[i]};
    const double out[4] = {f->vx[i], -f->vx[i], f->vy[i], -f->vy[i]};
    sph2d_vec2 springs = {0, 0}, behind = {0, 0};
    for (int side = 0; side < 4; ++side) {
        if (load->side >= 0 && load->side != side) /* not all */
            continue;
        const double sign = side & 1 ? 1 : -1, push = sign * sph2d__spring_force(w, distance[side], out[side]);
        if (side < 2) {
            springs.x += push;
            behind.x += sign * fill[side];
        } else {
            springs.y += push;
            behind.y += sign * fill[side];
        }
    }
    const sph2d_vec2 arm = {f->x[i] - load->about.x, f->y[i] - load->about.y};
    sum->first += springs.x;
    sum->second += springs.y;
    sum->third += arm.x * springs.y - arm.y * springs.x;
    sum->x += behind.x;
    sum->y += behind.y;
    sum->fourth += arm.x * behind.y - arm.y * behind.x;
}

#endif
