/* SPDX-License-Identifier: MIT */
/** @file muller_pair.h
 *  Pair terms of method `muller`, and the terms of spring walls. No loops: muller.h has the equations. */
#ifndef SPH2D_METHODS_MULLER_MULLER_PAIR_H
#define SPH2D_METHODS_MULLER_MULLER_PAIR_H

#include "kernels/muller.h"
#include "methods/common/group.h"
#include "methods/muller/muller_side.h"
#include "methods/terms/viscosity.h"

/** Poly6 without its constant, for particles at `at` and a candidate at (x, y). */
SPH2D__INLINE sph2d__lanes shape_of(double support2, sph2d__lanes at_x, sph2d__lanes at_y, double x, double y)
{
    sph2d__lanes dx = at_x - x, dy = at_y - y;
    sph2d__lanes d = sph2d__lanes_max(support2 - (dx * dx + dy * dy), (sph2d__lanes){0});
    return d * d * d;
}

/** The density that the sides of the domain add at a position. */
SPH2D__INLINE double side_density(const sph2d__system *s, double x, double y)
{
    sph2d__side_part parts[2];
    sph2d__sides_at(s, x, y, parts);
    return s->side_fill * (parts[0].value + parts[1].value) + s->corner_fill * parts[0].value * parts[1].value;
}

/** Adds the acceleration of particle i by these sides. */
SPH2D__INLINE void add_side_force(const sph2d__system *s, size_t i, double *ax, double *ay)
{
    const sph2d__store *f = &s->fluid;
    double rho = f->density[i], push = f->pressure[i] / (rho * rho);
    if (!(push > 0))
        return;
    sph2d__side_part parts[2];
    sph2d__sides_at(s, f->x[i], f->y[i], parts);
    *ax += push * (s->side_fill + s->corner_fill * parts[1].value) * parts[0].slope;
    *ay += push * (s->side_fill + s->corner_fill * parts[0].value) * parts[1].slope;
}

/** Sums of the forces on a group, without their constants. */
typedef struct force_sums {
    sph2d__lanes press_x, press_y;
    sph2d__drag drag;
} force_sums;

/** The particles of a group. */
typedef struct group_state {
    sph2d__lanes x, y, vx, vy, pressure;
} group_state;

SPH2D__INLINE void add_force(force_sums *sums, double support, const group_state *own, const sph2d__store *from,
                             size_t j)
{
    sph2d__lanes dx = own->x - from->x[j], dy = own->y - from->y[j];
    /* Coincident particles have no direction: 1/r stays finite, and dx = dy = 0. */
    sph2d__lanes tiny = sph2d__lanes_all(1e-24 * support * support);
    sph2d__lanes r = sph2d__lanes_sqrt(sph2d__lanes_max(dx * dx + dy * dy, tiny));
    sph2d__lanes w = sph2d__lanes_max(support - r, (sph2d__lanes){0});
    sph2d__lanes wv = w * from->volume[j];
    sph2d__lanes press = wv * w * (own->pressure + from->acting_pressure[j]) / r;
    sums->press_x += press * dx;
    sums->press_y += press * dy;
    sph2d__drag_add(&sums->drag, wv, from->vx[j] - own->vx, from->vy[j] - own->vy);
}

/** The same for a boundary particle, whose pressure force comes from the density sum. */
SPH2D__INLINE void add_wall_force(force_sums *sums, double support, const group_state *own, const sph2d__store *walls,
                                  size_t j)
{
    sph2d__lanes dx = own->x - walls->x[j], dy = own->y - walls->y[j], none = {0};
    sph2d__lanes r2 = dx * dx + dy * dy, d = sph2d__lanes_max(support * support - r2, none);
    sph2d__lanes press = d * d * walls->mass[j], wv = sph2d__lanes_max(support - sph2d__lanes_sqrt(r2), none);
    sums->press_x += press * dx;
    sums->press_y += press * dy;
    sph2d__drag_add(&sums->drag, wv * walls->volume[j], walls->vx[j] - own->vx, walls->vy[j] - own->vy);
}

#endif
