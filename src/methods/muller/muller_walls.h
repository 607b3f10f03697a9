/* SPDX-License-Identifier: MIT */
/** @file muller_walls.h
 *  The forces of method `muller` between a particle and walls, one by one, for the sums of loads. */
#ifndef SPH2D_METHODS_MULLER_MULLER_WALLS_H
#define SPH2D_METHODS_MULLER_MULLER_WALLS_H

#include "kernels/muller.h"
#include "methods/common/wall_force.h"
#include "methods/muller/muller_side.h"
#include "simd/lanes.h"

SPH2D__INLINE void side_push(const sph2d__system *s, size_t i, double push[4])
{
    const sph2d__store *f = &s->fluid;
    const sph2d__springs *w = &s->forces.springs;
    const double distances[4] = {f->x[i] - w->left, w->right - f->x[i], f->y[i] - w->bottom, w->top - f->y[i]};
    sph2d__side_part parts[2];
    sph2d__sides_at(s, f->x[i], f->y[i], parts);
    for (int side = 0; side < 4; ++side) {
        sph2d__side_part part = {0, 0};
        if (distances[side] < s->support)
            sph2d__side_add(s, distances[side], &part);
        push[side] = f->pressure[i] / (f->density[i] * f->density[i]) *
                     (s->side_fill + s->corner_fill * parts[1 - side / 2].value) * part.slope;
    }
}

SPH2D__INLINE sph2d__wall_force wall_force(const sph2d__system *s, size_t i, size_t b, double dx, double dy)
{
    const sph2d__store *f = &s->fluid, *w = &s->walls;
    double h2 = s->support * s->support, d = h2 - dx * dx - dy * dy, density = f->density[i],
           volume = s->mass / density;
    double press = volume * 6 * sph2d__poly6_constant(s->support) * f->pressure[i] / density * d * d * w->mass[b];
    double drag =
        s->viscosity * sph2d__viscosity_constant(s->support) * volume * (s->support - sqrt(h2 - d)) * w->volume[b];
    return (sph2d__wall_force){.pressure = {press * dx, press * dy},
                               .friction = {drag * (w->vx[b] - f->vx[i]), drag * (w->vy[b] - f->vy[i])}};
}

#endif
