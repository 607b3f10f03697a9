/* SPDX-License-Identifier: MIT */
/** @file wcsph_gather.h
 *  Finds the neighbours of method `wcsph`, and sums what stands still over a step, in C and in OpenCL C. Every lane is a
 *  particle. */
#ifndef SPH2D_METHODS_WCSPH_WCSPH_GATHER_H
#define SPH2D_METHODS_WCSPH_WCSPH_GATHER_H

#include <math.h>

#include "kernels/kernel.h"
#include "methods/common/shortest.h"
#include "methods/common/slices.h"
#include "methods/wcsph/wcsph_finish.h"
#include "methods/wcsph/wcsph_front.h"
#include "methods/wcsph/wcsph_sight.h"

/* (|G| H)^2 of pairs that are none: at the end of the support, or what a list ends with. */
SPH2D__FIXED double NO_PAIR = 1e-20;

/** Sums over pairs of the kernel, and of G |r|. */
typedef struct kept {
    sph2d__lanes value, kx, ky;
} kept;

/** Keeps the gradients and the distances of a slice's pairs with one store. In a loop of its own: GCC 12 with -O3 drops conversions to float and back that are in sight. */
SPH2D__INLINE kept keep_pairs(const sph2d__system *s, const sums *own, const sph2d__store *from, size_t at,
                              uint32_t slots, sph2d_kernel kernel)
{
    const sph2d__period *period = &s->fluid_cells.period;
    const double h2 = s->support * s->support, scale = sph2d__kernel_constant(kernel) / (h2 * h2);
    const double volume = s->mass / s->rest_density;
    const bool walls = from == &s->walls;
    const sph2d__frozen *z = s->frozen;
    const sph2d__lanes least = sph2d__lanes_all(NO_PAIR / (s->support * s->support));
    const sph2d__lanes none = {0};
    sph2d__lanes weight = sph2d__lanes_all(1);
    kept sum = {0};
    for (size_t k = at; k < at + (size_t)slots * SPH2D__STRIDE; k += SPH2D__STRIDE) {
        SPH2D__ARRAY const uint32_t *j = s->neighbours.index + k;
        const sph2d__lanes dx = sph2d__shortest(own->x - sph2d__lanes_gather(from->x, j), period->length_x);
        const sph2d__lanes dy = sph2d__shortest(own->y - sph2d__lanes_gather(from->y, j), period->length_y);
        const sph2d__lanes r2 = dx * dx + dy * dy, r = sph2d__lanes_sqrt(r2), q = r * (1 / s->support);
        if (walls)
            weight = sph2d__lanes_gather(s->frozen->part, j) * sph2d__lanes_gather(from->mass, j) * (1 / s->mass);
        sph2d__lanes slope = volume * scale * weight * sph2d__kernel_slope(kernel, q);
        slope = sph2d__lanes_where(slope * slope * r2, least, slope);
        const sph2d__lanes gx = slope * dx, gy = slope * dy;
        sum.value += weight * sph2d__kernel_value(kernel, q);
        sum.kx += r * gx;
        sum.ky += r * gy;
        sph2d__floats_store(z->gx + k, gx);
        sph2d__floats_store(z->gy + k, gy);
        sph2d__floats_store(z->inverse + k, sph2d__lanes_where(-slope, none, -1 / (slope * r)));
        sph2d__floats_store(z->rx + k, dx);
        sph2d__floats_store(z->ry + k, dy);
    }
    return sum;
}

/** Sums over the fluid's slots. */
SPH2D__INLINE void sum_fluid(const sph2d__system *s, size_t first, size_t begin, uint32_t slots, sph2d_kernel kernel,
                             sums *to, wall_sums *behind)
{
    const sph2d__neighbours *n = &s->neighbours;
    const sph2d__frozen *z = s->frozen;
    sums sum = *to;
    const kept kernels = keep_pairs(s, &sum, &s->fluid, begin, slots, kernel);
    sum.value += kernels.value;
    sum.kx += kernels.kx;
    sum.ky += kernels.ky;
    if (s->frozen->thin)
        hide_pairs(s, first, begin, slots, kernel, &sum, behind);
    for (size_t k = begin; k < begin + (size_t)slots * SPH2D__STRIDE; k += SPH2D__STRIDE) {
        SPH2D__ARRAY const uint32_t *j = n->index + k;
        const sph2d__lanes gx = sph2d__floats_load(z->gx + k), gy = sph2d__floats_load(z->gy + k),
                           rx = sph2d__floats_load(z->rx + k), ry = sph2d__floats_load(z->ry + k);
        const sph2d__four other = sph2d__four_gather(z->state, j);
        const sph2d__lanes ux = other.a - sum.vx, uy = other.b - sum.vy, jump = other.c - sum.theta;
        sum.gx += gx;
        sum.gy += gy;
        sum.xx -= gx * rx;
        sum.xy -= gx * ry;
        sum.yy -= gy * ry;
        sum.uxx += ux * gx;
        sum.uxy += ux * gy;
        sum.vxx += uy * gx;
        sum.vxy += uy * gy;
        sum.px += jump * gx;
        sum.py += jump * gy;
    }
    *to = sum;
}

SPH2D__INLINE void sum_walls(const sph2d__system *s, SPH2D__ARRAY const sph2d__slice *at, const sums *own,
                             sph2d_kernel kernel, wall_sums *to)
{
    const size_t begin = at->begin + (size_t)at->fluid * SPH2D__STRIDE;
    const sph2d__frozen *z = s->frozen;
    wall_sums sum = *to;
    const kept kernels = keep_pairs(s, own, &s->walls, begin, at->walls, kernel);
    sum.value = kernels.value;
    sum.kx = kernels.kx;
    sum.ky = kernels.ky;
    for (size_t k = begin; k < begin + (size_t)at->walls * SPH2D__STRIDE; k += SPH2D__STRIDE) {
        const sph2d__lanes gx = sph2d__floats_load(z->gx + k), gy = sph2d__floats_load(z->gy + k),
                           rx = sph2d__floats_load(z->rx + k), ry = sph2d__floats_load(z->ry + k);
        sum.xx -= gx * rx;
        sum.xy -= gx * ry;
        sum.yy -= gy * ry;
        sum.gx += gx;
        sum.gy += gy;
    }
    *to = sum;
}

/** Writes the slots of pairs that may come close during the step. */
SPH2D__INLINE uint32_t write_close(sph2d__system *s, sph2d__pairs *to, SPH2D__ARRAY const sph2d__slice *at)
{
    sph2d__neighbours *n = &s->neighbours;
    const double limit2 = s->frozen->apart * s->frozen->apart;
    size_t k = at->begin;
    sph2d__pairs_none(to);
    for (uint32_t slot = 0; slot < at->fluid; ++slot, k += SPH2D__STRIDE) {
        const sph2d__lanes rx = sph2d__floats_load(s->frozen->rx + k), ry = sph2d__floats_load(s->frozen->ry + k);
        unsigned close = sph2d__lanes_which(rx * rx + ry * ry, limit2);
        for (uint32_t l = 0; close; ++l, close >>= 1)
            if (close & 1)
                sph2d__pairs_put(to, l, n->index[k + l]);
    }
    return sph2d__pairs_write(n, to, s->fluid.count);
}

/** Everything about the particles `first` on of a slice. */
SPH2D__INLINE void gather_slice(sph2d__system *s, sph2d__pairs *to, size_t first, sph2d_kernel kernel)
{
    sph2d__neighbours *n = &s->neighbours;
    const sph2d__store *f = &s->fluid;
    SPH2D__ARRAY sph2d__slice *at = &n->slices[first / SPH2D__LANES];
    const double h2 = s->support * s->support;
    const sph2d__four own = sph2d__four_load(s->frozen->state + 4 * first);
    sums sum = {.x = sph2d__lanes_load(f->x + first),
                .y = sph2d__lanes_load(f->y + first),
                .vx = own.a,
                .vy = own.b,
                .theta = own.c};
    wall_sums walls = {0}, behind = {0};
    *at = (sph2d__slice){.begin = to->next};
    sph2d__pairs_search(to, &to->fluid, &s->fluid_cells, f, f, first, h2, true, NULL);
    at->fluid = sph2d__pairs_write(n, to, f->count);
    sum_fluid(s, first, at->begin, at->fluid, kernel, &sum, &behind);
    sums all = sum;
    SPH2D__ARRAY uint32_t *imaged = &s->frozen->imaged[first / SPH2D__LANES];
    *imaged = 0;
    if (s->frozen->images.count > 0) {
        const size_t start = to->next;
        sph2d__pairs_search(to, &to->images, &s->frozen->image_cells, &s->frozen->images, f, first, h2, false, NULL);
        *imaged = sph2d__pairs_write(n, to, s->frozen->images.count);
        for (size_t k = start; k < start + (size_t)*imaged * SPH2D__STRIDE; k += SPH2D__STRIDE)
            for (size_t l = 0; l < SPH2D__LANES; ++l)
                n->index[k + l] += (uint32_t)s->frozen->first_image;
        sum_fluid(s, first, start, *imaged, kernel, &all, &behind);
        at->fluid += *imaged;
    }
    if (s->walls_press && s->frozen->sides.first > 0) {
        sph2d__pairs_search(to, &to->walls, &s->wall_cells, &s->walls, f, first, h2, false, NULL);
        at->walls = sph2d__pairs_write(n, to, s->walls.count);
        sum_walls(s, at, &sum, kernel, &walls);
    }
    s->frozen->close[first / SPH2D__LANES] = write_close(s, to, at);
    const symmetric thick =
        thicken(s, first, at->begin + (size_t)at->fluid * SPH2D__STRIDE, at->walls, &walls, &behind);
    finish(s, first, &sum, &all, &walls, &behind, thick, kernel);
    if (at->walls > 0)
        finish_walls(s, first, at, &behind);
}

/* ---- what is linear ---------------------------------------------------------------------------------------------- */

/** Sums over a slice's pairs once all slopes are known. */
typedef struct compared {
    sph2d__lanes weight, image_weight, sx, sy; /* of |G|, with images and of them; and |G| r */
    sph2d__lanes walled;                       /* 1 where one of the neighbours is */
} compared;

/** Keeps what is linear in a slice's pairs. */
SPH2D__INLINE compared compare_pairs(const sph2d__system *s, size_t first, SPH2D__ARRAY const sph2d__slice *at)
{
    const sph2d__neighbours *n = &s->neighbours;
    sph2d__frozen *z = s->frozen;
    const sph2d__four v = sph2d__four_load(z->slope + 4 * first), p = sph2d__four_load(z->bend + 4 * first);
    const sph2d__lanes none = {0};
    const size_t own = at->begin + (size_t)(at->fluid - z->imaged[first / SPH2D__LANES]) * SPH2D__STRIDE;
    compared sum = {.walled = sph2d__lanes_load(z->walled + first)};
    for (size_t k = at->begin; k < at->begin + (size_t)at->fluid * SPH2D__STRIDE; k += SPH2D__STRIDE) {
        SPH2D__ARRAY const uint32_t *j = n->index + k;
        const sph2d__four other = sph2d__four_gather(z->slope, j), bend = sph2d__four_gather(z->bend, j);
        const sph2d__lanes xx = v.a + other.a, xy = v.b + other.b, yy = v.c + other.c;
        const sph2d__lanes gx = sph2d__floats_load(z->gx + k), gy = sph2d__floats_load(z->gy + k);
        const sph2d__lanes rx = sph2d__floats_load(z->rx + k), ry = sph2d__floats_load(z->ry + k);
        const sph2d__lanes inverse = sph2d__floats_load(z->inverse + k), size = (gx * gx + gy * gy) * inverse;
        /* e . S r with e = -G/|G| */
        const sph2d__lanes along = gx * (xx * rx + xy * ry) + gy * (xy * rx + yy * ry);
        const sph2d__lanes jump = (p.a + bend.a) * rx + (p.b + bend.b) * ry;
        sph2d__floats_store(z->linear_w + k, sph2d__lanes_where(inverse, none, -0.5 * inverse * along));
        sph2d__floats_store(z->linear_theta + k, sph2d__lanes_where(inverse, none, 0.5 * jump));
        sum.weight += size;
        if (k >= own)
            sum.image_weight += size;
        sum.sx += sph2d__lanes_where(inverse, none, size * rx);
        sum.sy += sph2d__lanes_where(inverse, none, size * ry);
        sum.walled = sph2d__lanes_max(sum.walled, sph2d__lanes_where(inverse, none, other.d));
    }
    return sum;
}

SPH2D__INLINE void compare_slice(const sph2d__system *s, size_t first)
{
    sph2d__frozen *z = s->frozen;
    SPH2D__ARRAY const sph2d__slice *at = &s->neighbours.slices[first / SPH2D__LANES];
    const compared sum = compare_pairs(s, first, at);
    const sph2d__lanes mean = sph2d__lanes_where(sum.weight, (sph2d__lanes){0}, 1 / sum.weight);
    const sph2d__lanes axy = sph2d__lanes_load(z->axy + first);
    sph2d__lanes_store(z->weight + first, sum.weight);
    sph2d__lanes_store(z->image_weight + first, sum.image_weight);
    sph2d__lanes_store(z->kx + first, mean * (sph2d__lanes_load(z->axx + first) * sum.sx + axy * sum.sy));
    sph2d__lanes_store(z->ky + first, mean * (axy * sum.sx + sph2d__lanes_load(z->ayy + first) * sum.sy));
    int flags = 0;
    for (int l = 0; l < SPH2D__LANES && first + (size_t)l < s->fluid.count; ++l) {
        const size_t i = first + (size_t)l;
        flags |=
            (z->walled[i] > 0 ? SPH2D__FROZEN_WALLED : 0) | (SPH2D__LANE(sum.walled, l) > 0 ? SPH2D__FROZEN_BESIDE : 0);
    }
    z->flags[first / SPH2D__LANES] = (unsigned char)flags;
}

static void compare(sph2d__system *s, size_t first, size_t last)
{
    for (size_t i = first; i < last; i += SPH2D__LANES)
        compare_slice(s, i);
}

#endif
