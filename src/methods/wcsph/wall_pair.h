/* SPDX-License-Identifier: MIT */
/** @file wall_pair.h
 *  Boundary particles of method `wcsph`: extrapolation of the liquid in front of the wall. No loops: wcsph.h has the
 *  equations. */
#ifndef SPH2D_METHODS_WCSPH_WALL_PAIR_H
#define SPH2D_METHODS_WCSPH_WALL_PAIR_H

#include <math.h>

#include "kernels/kernel.h"
#include "methods/common/state_equation.h"
#include "methods/wcsph/pair.h"
#include "methods/wcsph/wcsph.h"

/** Sums over the liquid around a boundary particle, weighted by the kernel. */
typedef struct wall_sums {
    sph2d__lanes weight, filling, pressure, weight_x, weight_y, behind, vx, vy, flux;
    sph2d__lanes along; /* the part along the wall of the flux, or of p V^2 grad W */
} wall_sums;

/* Mean fillings: liquid slips along a smooth wall fully up to the first, as in films, and not at all from the second
 * on; it is 0.5 at a flat surface and 1 at H below it. */
static const double THIN = 0.6, COVERED = 0.85;
/* Speed over c0 from which on sliding counts. Liquid that slides is not in hydrostatic balance with the wall and would
 * not come to rest. Sloshing with 0.003 c0 in a tank 50 spacings wide is 1.2 % too fast without slip, 1.1 % with 0.004,
 * 0.9 % with 0.002, 0.5 % with 0.001 and 0.02 % with 0; a tank at rest keeps 0.001 sqrt(gH) with 0.002 and 0.005 with
 * 0.001, and water between walls 160 degrees apart 0.04 and 0.05. */
static const double MIN_SLIP_SPEED = 0.002;

/** s_b: by how much the wall of a boundary particle slips with the liquid, from 0 to 1, smooth. */
SPH2D__INLINE double slip_factor(const sph2d__system *s, size_t b, const wall_sums *sums, int l, double share)
{
    const sph2d__store *w = &s->walls;
    if (!(share > 0) || sph2d__slip_of(s, b) == SPH2D_SLIP_NONE)
        return 0;
    double t = (COVERED - share * (double)sums->filling[l]) / (COVERED - THIN), low = MIN_SLIP_SPEED * s->sound_speed;
    double slip = w->normal_x[b] * (share * (double)sums->vy[l] - w->vy[b]) -
                  w->normal_y[b] * (share * (double)sums->vx[l] - w->vx[b]);
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    return w->front[b] * t * t * (3 - 2 * t) * slip * slip / (slip * slip + low * low);
}

/** Sets pressure, density, volume and slip; pressure is 0 if no liquid is near. `share` is one over the sum of weights,
 *  or 0. Under tension the wall has rest density. */
SPH2D__INLINE void finish_pressure(sph2d__system *s, size_t b, const wall_sums *sums, int l, double share)
{
    sph2d__store *w = &s->walls;
    double part = s->rigid_count > 0 ? sph2d__wcsph_felt_part(s, b) : 1, gx = -part * w->ax[b], gy = -part * w->ay[b];
    sph2d__body_add(&s->body, w->x[b], w->y[b], w->vx[b], w->vy[b], &gx, &gy);
    double pressure =
        share * ((double)sums->pressure[l] + gx * (double)sums->weight_x[l] + gy * (double)sums->weight_y[l]);
    w->pressure[b] = pressure;
    w->density[b] = sph2d__density_of(s, fmax(pressure, 0));
    w->volume[b] = w->mass[b] / w->density[b];
    double length = sqrt(slip_factor(s, b, sums, l, share));
    w->along_x[b] = -length * w->normal_y[b];
    w->along_y[b] = length * w->normal_x[b];
    w->slide[b] = share * w->mass[b] / s->mass * length * (double)sums->along[l];
}

/* Largest ratio of the distances of a boundary particle and of the liquid that it sees from the surface, and of those
 * the other way round: the last layer sees little liquid, all of it near. */
static const double MAX_IMAGE = 4;
/* Least distance of the liquid from the surface, over the spacing. */
static const double MIN_IMAGE_DISTANCE = 0.1;

/** Distance of boundary particle b from the surface over that of the liquid in front, in the mean by weight. With a
 *  plain mirror, of ratio 1, liquid between a shaft and a drum (examples/annulus) is 0.5 to 1 % off, with this 0.2 %. */
SPH2D__INLINE double image_ratio(const sph2d__system *s, size_t b, const wall_sums *sums, int l, double share)
{
    if (!(s->walls.depth[b] < INFINITY)) /* in corners */
        return 1;
    double depth = s->walls.depth[b];
    double liquid = fmax(-share * (double)sums->behind[l] - depth, MIN_IMAGE_DISTANCE * s->spacing);
    return fmin(fmax(depth / liquid, 1 / MAX_IMAGE), MAX_IMAGE);
}

/** Sets the image velocity for no slip at the surface: that of the liquid in front, mirrored, and in proportion to the
 *  distances from the surface, so that it is exact for a linear profile. */
SPH2D__INLINE void finish_image(const sph2d__system *s, sph2d__store *w, size_t b, const wall_sums *sums, int l,
                                double share)
{
    bool wet = share > 0; /* of dry walls their own velocity */
    /* A wall that turns: what is mirrored is the velocity of the liquid relative to the wall's at the same place. */
    double turn = s->wall_spin ? s->wall_spin[w->id[b]] * share / s->rest_density : 0;
    double ratio = wet && !s->walls_stick ? image_ratio(s, b, sums, l, share) : 0; /* else images differ by pair */
    double slip_x = w->vx[b] - share * (double)sums->vx[l] + turn * (double)sums->weight_y[l];
    double slip_y = w->vy[b] - share * (double)sums->vy[l] - turn * (double)sums->weight_x[l];
    w->image_vx[b] = w->vx[b] + (wet ? ratio * slip_x : 0);
    w->image_vy[b] = w->vy[b] + (wet ? ratio * slip_y : 0);
}

/** Sets wall_rate, and the velocity of the wall in the rate of density: its own plus the slip along it. */
SPH2D__INLINE void finish_rate(const sph2d__system *s, sph2d__store *w, size_t b, const wall_sums *sums, int l,
                               double share)
{
    double ratio = s->rest_density / w->density[b], factor = slip_factor(s, b, sums, l, share);
    double tx = -w->normal_y[b], ty = w->normal_x[b];
    double slip = tx * (share * (double)sums->vx[l] - w->vx[b]) + ty * (share * (double)sums->vy[l] - w->vy[b]);
    w->wall_rate[b] = share * ratio * ratio * ((double)sums->flux[l] - factor * (double)sums->along[l]);
    w->image_vx[b] = (s->walls_move ? w->vx[b] : 0) + (share > 0 ? factor * slip * tx : 0);
    w->image_vy[b] = (s->walls_move ? w->vy[b] : 0) + (share > 0 ? factor * slip * ty : 0);
}

/** What a pass computes. */
typedef enum wall_output { RATES, PRESSURES, PRESSURES_AND_IMAGES } wall_output;

SPH2D__INLINE void finish_wall(sph2d__system *s, size_t b, const wall_sums *sums, int l, wall_output what)
{
    sph2d__store *w = &s->walls;
    double weight = sums->weight[l];
    double share = weight > 1e-12 && w->bounce[b] < 0 ? 1 / weight : 0;
    if (what == RATES)
        finish_rate(s, w, b, sums, l, share);
    else
        finish_pressure(s, b, sums, l, share);
    if (what == PRESSURES_AND_IMAGES)
        finish_image(s, w, b, sums, l, share);
}

/** The boundary particles of a group: their velocities, and the direction along the wall. */
typedef struct group_state {
    sph2d__lanes vx, vy, along_x, along_y;
} group_state;

SPH2D__INLINE group_state group_state_of(const sph2d__system *s, size_t first)
{
    const sph2d__store *w = &s->walls;
    const sph2d__real moves = s->walls_move; /* a side that slides along itself does not move */
    return (group_state){.vx = moves * sph2d__group_lanes(w->vx + first, 0),
                         .vy = moves * sph2d__group_lanes(w->vy + first, 0),
                         .along_x = -sph2d__group_lanes(w->normal_y + first, 0),
                         .along_y = sph2d__group_lanes(w->normal_x + first, 0)};
}

/** Adds a candidate to the sums. */
SPH2D__INLINE void add_candidate(wall_sums *sums, const sph2d__system *s, const sph2d__packed *f, size_t j,
                                 sph2d_kernel kernel, wall_output what, const pair *p, const group_state *own)
{
    sph2d__lanes weight = sph2d__kernel_value(kernel, p->q);
    const double filling = s->fluid.filling[j];
    sums->weight += weight;
    sums->filling += weight * (sph2d__real)filling;
    sums->vx += weight * f->vx[j];
    sums->vy += weight * f->vy[j];
    if (what == RATES) {
        sph2d__lanes gx = p->g * p->dx, gy = p->g * p->dy;
        sph2d__lanes dvx = own->vx - f->vx[j], dvy = own->vy - f->vy[j];
        sums->flux += dvx * gx + dvy * gy;
        sums->along += (own->along_x * dvx + own->along_y * dvy) * (own->along_x * gx + own->along_y * gy);
        return;
    }
    sph2d__lanes rho_weight = weight * ((sph2d__real)s->mass / f->volume[j] * (sph2d__real)sph2d__connection(filling));
    sums->pressure += weight * f->pressure[j];
    sums->weight_x += rho_weight * p->dx;
    sums->weight_y += rho_weight * p->dy;
    sums->behind += weight * (own->along_y * p->dx - own->along_x * p->dy);
    sums->along +=
        p->g * (f->pressure[j] * f->volume[j] * f->volume[j]) * (own->along_x * p->dx + own->along_y * p->dy);
}

#endif
