/* SPDX-License-Identifier: MIT */
/** @file wcsph_rate.h
 *  Sums of the rate of density and of r. Every lane is a particle. */
#ifndef SPH2D_METHODS_WCSPH_WCSPH_RATE_H
#define SPH2D_METHODS_WCSPH_WCSPH_RATE_H

#include "methods/wcsph/wcsph_force.h"

/** Sums of a rate of density: (v_i - v_j) G^T, and z_k . G_ik; and (v_i - v_j) |G|. */
typedef struct rate_sums {
    sph2d__lanes xx, xy, yx, yy, z, x, y;
} rate_sums;

SPH2D__INLINE rate_sums sum_rates(const sph2d__system *s, size_t first, bool rest)
{
    const sph2d__neighbours *n = &s->neighbours;
    const sph2d__frozen *z = s->frozen;
    const sph2d__slice *at = &n->slices[first / SPH2D__LANES];
    const sph2d__four own = sph2d__four_load(z->velocity + 4 * first);
    const bool beside = z->flags[first / SPH2D__LANES] & SPH2D__FROZEN_BESIDE;
    rate_sums sum = {0};
    for (size_t k = at->begin, slot = 0; slot < at->fluid; ++slot, k += SPH2D__LANES) {
        const uint32_t *j = n->index + k;
        const sph2d__four v = sph2d__four_gather(z->velocity, j);
        const sph2d__lanes gx = sph2d__floats_load(z->gx + k), gy = sph2d__floats_load(z->gy + k);
        const sph2d__lanes vx = own.a - v.a, vy = own.b - v.b;
        sum.xx += vx * gx;
        sum.xy += vx * gy;
        sum.yx += vy * gx;
        sum.yy += vy * gy;
        if (rest) {
            const sph2d__lanes size = (gx * gx + gy * gy) * sph2d__floats_load(z->inverse + k);
            sum.x += vx * size;
            sum.y += vy * size;
        }
        if (beside)
            sum.z += v.c * gx + v.d * gy;
    }
    return sum;
}

/** r, over sum |G|, and A s. */
SPH2D__INLINE void keep_rest(sph2d__system *s, size_t i, const rate_sums *r)
{
    sph2d__frozen *z = s->frozen;
    const sph2d__lanes smooth = sph2d__lanes_load(z->smooth + i), weight = sph2d__lanes_load(z->weight + i);
    const vectors k = load(z->kx, z->ky, i);
    const sph2d__lanes part = smooth * sph2d__lanes_where(weight, (sph2d__lanes){0}, 1 / weight);
    const sph2d__lanes rx = part * r->x + smooth * (r->xx * k.x + r->xy * k.y);
    const sph2d__lanes ry = part * r->y + smooth * (r->yx * k.x + r->yy * k.y);
    sph2d__four_store(z->rest + 4 * i, (sph2d__four){part * rx, part * ry, weight * k.x, weight * k.y});
}

#endif
