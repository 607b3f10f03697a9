/* SPDX-License-Identifier: MIT */
/** @file wcsph_stick.h
 *  Liquid that sticks to walls, and what viscosity does by itself, in C and in OpenCL C (wcsph_friction.c). */
#ifndef SPH2D_METHODS_WCSPH_WCSPH_STICK_H
#define SPH2D_METHODS_WCSPH_WCSPH_STICK_H

#include "methods/terms/stick.h"
#include "methods/wcsph/wcsph_frozen.h"
#include "simd/lanes.h"

SPH2D__INLINE sph2d__frozen_stick stick_of(const sph2d__system *s, size_t i, size_t b, double gx, double gy, double x,
                                           double y)
{
    const sph2d__store *w = &s->walls;
    const double size2 = gx * gx + gy * gy, gain = size2 > 0 ? sph2d__stick(s, b, x, y) : 0;
    const double mu = s->viscosities ? s->viscosities[i] : s->viscosity;
    const double scale = gain > 0 ? mu / s->rest_density * s->central_weight * sqrt(x * x + y * y) / sqrt(size2) : 0;
    const double turn = (gain - 1) * (s->wall_spin ? s->wall_spin[w->id[b]] : 0);
    const double along = scale * (gx * (gain * w->vx[b] - turn * y) + gy * (gain * w->vy[b] + turn * x));
    return (sph2d__frozen_stick){gain * scale * gx * gx, gain * scale * gx * gy, gain * scale * gy * gy, along * gx,
                                 along * gy};
}

/** Sums over the walls around some particles. */
SPH2D__INLINE void stick_some(sph2d__system *s, size_t first, size_t last)
{
    const sph2d__neighbours *n = &s->neighbours;
    sph2d__frozen *z = s->frozen;
    for (size_t i = first; i < last; ++i) {
        SPH2D__ARRAY const sph2d__slice *at = &n->slices[i / n->lanes];
        sph2d__frozen_stick sum = {0};
        size_t k = at->begin + (size_t)at->fluid * n->stride + i % n->lanes;
        for (uint32_t slot = 0; slot < at->walls; ++slot, k += n->stride) {
            if (n->index[k] >= s->walls.count)
                continue;
            const sph2d__frozen_stick b =
                stick_of(s, i, n->index[k], (double)z->gx[k], (double)z->gy[k], (double)z->rx[k], (double)z->ry[k]);
            sum = (sph2d__frozen_stick){sum.xx + b.xx, sum.xy + b.xy, sum.yy + b.yy, sum.x + b.x, sum.y + b.y};
        }
        z->stick_xx[i] = sum.xx;
        z->stick_xy[i] = sum.xy;
        z->stick_yy[i] = sum.yy;
        z->stick_x[i] = sum.x;
        z->stick_y[i] = sum.y;
        z->mean_vx[i] = z->mean_vy[i] = 0;
    }
}

/** Leaves to e what viscosity does not do: it makes what is not linear in a lattice fade at the rate mu/rho0 4/<r^2>
 *  sum |G| r, too. */
SPH2D__INLINE void spare_some(sph2d__system *s, size_t first, size_t last)
{
    const double unit = s->central_weight * s->lattice_slopes / s->rest_density,
                 wanted = SPH2D__SMOOTHING * s->sound_speed / s->spacing;
    for (size_t i = first; i < last; ++i) {
        const double rate = unit * (s->viscosities ? s->viscosities[i] : s->viscosity);
        s->frozen->smooth[i] *= sqrt(fmax(1 - rate / wanted, 0));
    }
}

#endif
