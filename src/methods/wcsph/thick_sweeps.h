/* SPDX-License-Identifier: MIT */
/** @file thick_sweeps.h
 *  The sweeps of thick.c, and what it does to particles one by one, in C and in OpenCL C. Every lane is a particle. */
#ifndef SPH2D_METHODS_WCSPH_THICK_SWEEPS_H
#define SPH2D_METHODS_WCSPH_THICK_SWEEPS_H

#include "methods/wcsph/wcsph_force.h"

/** Sums over the pairs of a slice: w r G, and the diagonal of that. */
typedef struct drags {
    vectors all, images, diagonal;
} drags;

SPH2D__INLINE drags sum_drags(const sph2d__system *s, size_t i, bool diagonal)
{
    const sph2d__frozen *z = s->frozen;
    SPH2D__ARRAY const sph2d__slice *at = &s->neighbours.slices[i / SPH2D__LANES];
    const sph2d__four own = sph2d__four_load(z->velocity + 4 * i);
    const sph2d__lanes none = {0}, one = sph2d__lanes_all(1);
    const sph2d__lanes mu = s->viscosities ? sph2d__lanes_load(s->viscosities + i) : one;
    const uint32_t alone = at->fluid - z->imaged[i / SPH2D__LANES];
    drags sum = {{none, none}, {none, none}, {none, none}};
    vectors before = {none, none};
    size_t k = at->begin;
    for (uint32_t slot = 0; slot < at->fluid; ++slot, k += SPH2D__STRIDE) {
        if (slot == alone)
            before = sum.all;
        SPH2D__ARRAY const uint32_t *j = s->neighbours.index + k;
        sph2d__lanes gx = sph2d__floats_load(z->gx + k), gy = sph2d__floats_load(z->gy + k);
        const sph2d__lanes rx = sph2d__floats_load(z->rx + k), ry = sph2d__floats_load(z->ry + k);
        if (s->viscosities) {
            const sph2d__lanes other = sph2d__lanes_gather(s->viscosities, j);
            const sph2d__lanes mean = sph2d__lanes_where(mu + other, none, 2 * mu * other / (mu + other));
            gx *= mean;
            gy *= mean;
        }
        const sph2d__four v = sph2d__four_gather(z->velocity, j);
        const sph2d__lanes rate = (own.a - v.a) * rx + (own.b - v.b) * ry;
        sum.all.x += rate * gx;
        sum.all.y += rate * gy;
        if (diagonal) {
            sum.diagonal.x += sph2d__lanes_where(gx * gx, none, rx * gx); /* what lists end with is far away */
            sum.diagonal.y += sph2d__lanes_where(gy * gy, none, ry * gy);
        }
    }
    if (alone < at->fluid)
        sum.images = (vectors){sum.all.x - before.x, sum.all.y - before.y};
    return sum;
}

/** The factor of the sums, over mass. */
SPH2D__INLINE double thick_strength(const sph2d__system *s)
{
    return (s->viscosities ? 1 : s->viscosity) / s->rest_density * s->central_weight;
}

/** Adds -K v. */
SPH2D__INLINE void add_stick(const sph2d__system *s, size_t i, vectors v, vectors *a)
{
    const sph2d__frozen *z = s->frozen;
    if (!z->sticks)
        return;
    const sph2d__lanes xy = sph2d__lanes_load(z->stick_xy + i);
    a->x -= sph2d__lanes_load(z->stick_xx + i) * v.x + xy * v.y;
    a->y -= xy * v.x + sph2d__lanes_load(z->stick_yy + i) * v.y;
}

/** Adds what does not depend on velocities. */
SPH2D__INLINE void add_given(const sph2d__system *s, size_t i, vectors *a)
{
    const sph2d__frozen *z = s->frozen;
    if (z->sticks) {
        a->x += sph2d__lanes_load(z->stick_x + i);
        a->y += sph2d__lanes_load(z->stick_y + i);
    }
    if (z->rubs) {
        a->x += sph2d__lanes_load(z->rub_x + i);
        a->y += sph2d__lanes_load(z->rub_y + i);
    }
}

/** -V v of a slice, whose velocities are in the records. */
SPH2D__INLINE vectors resist(const sph2d__system *s, size_t i, const drags *f)
{
    const sph2d__four own = sph2d__four_load(s->frozen->velocity + 4 * i);
    vectors a = {thick_strength(s) * f->all.x, thick_strength(s) * f->all.y};
    add_stick(s, i, (vectors){own.a, own.b}, &a);
    return a;
}

SPH2D__INLINE sph2d__lanes free_part(const sph2d__frozen *z, size_t i)
{
    return z->holds ? 1 - sph2d__lanes_load(z->held + i) : sph2d__lanes_all(1);
}

SPH2D__INLINE void thick_load(sph2d__system *s, size_t first, size_t last, sph2d__slab_sum *sum)
{
    sph2d__frozen *z = s->frozen;
    const double dt = z->dt;
    for (size_t i = first; i < last; i += SPH2D__LANES) {
        const drags f = sum_drags(s, i, true);
        const sph2d__lanes part = free_part(z, i);
        vectors a = resist(s, i, &f),
                diagonal = {1 - dt * thick_strength(s) * f.diagonal.x, 1 - dt * thick_strength(s) * f.diagonal.y};
        if (z->sticks) {
            diagonal.x += dt * sph2d__lanes_load(z->stick_xx + i);
            diagonal.y += dt * sph2d__lanes_load(z->stick_yy + i);
        }
        add_given(s, i, &a);
        const vectors before = load(z->rubbed_x, z->rubbed_y, i), v = load(s->fluid.vx, s->fluid.vy, i),
                      from = load(z->thick_x, z->thick_y, i);
        const vectors rest = {part * (v.x - from.x + dt * (a.x + before.x)),
                              part * (v.y - from.y + dt * (a.y + before.y))};
        sph2d__lanes_store(z->rest_x + i, rest.x);
        sph2d__lanes_store(z->rest_y + i, rest.y);
        sph2d__lanes_store(z->way_x + i, rest.x / diagonal.x);
        sph2d__lanes_store(z->way_y + i, rest.y / diagonal.y);
        sph2d__lanes_store(z->eased_x + i, 1 / diagonal.x);
        sph2d__lanes_store(z->eased_y + i, 1 / diagonal.y);
        add_lanes(&sum->first, rest.x * rest.x / diagonal.x + rest.y * rest.y / diagonal.y, i, last);
        const vectors right = {v.x + dt * before.x, v.y + dt * before.y};
        add_lanes(&sum->second, dot(right, right), i, last);
    }
}

SPH2D__INLINE void thick_multiply(sph2d__system *s, size_t first, size_t last, sph2d__slab_sum *sum)
{
    sph2d__frozen *z = s->frozen;
    for (size_t i = first; i < last; i += SPH2D__LANES) {
        const drags f = sum_drags(s, i, false);
        const sph2d__lanes part = free_part(z, i);
        const vectors a = resist(s, i, &f), way = load(z->way_x, z->way_y, i);
        const vectors to = {part * (way.x - z->dt * a.x), part * (way.y - z->dt * a.y)};
        sph2d__lanes_store(z->slowed_x + i, to.x);
        sph2d__lanes_store(z->slowed_y + i, to.y);
        add_lanes(&sum->first, dot(way, to), i, last);
    }
}

SPH2D__INLINE void thick_finish(sph2d__system *s, size_t first, size_t last)
{
    sph2d__frozen *z = s->frozen;
    for (size_t i = first; i < last; i += SPH2D__LANES) {
        const drags f = sum_drags(s, i, false);
        const sph2d__four own = sph2d__four_load(z->velocity + 4 * i);
        vectors a = resist(s, i, &f);
        add_given(s, i, &a);
        sph2d__lanes_store(z->rubbed_x + i, a.x);
        sph2d__lanes_store(z->rubbed_y + i, a.y);
        sph2d__lanes_store(z->mean_vx + i, own.a);
        sph2d__lanes_store(z->mean_vy + i, own.b);
    }
}

/** Once for both solves. */
SPH2D__INLINE void thick_sides(sph2d__system *s, size_t first, size_t last)
{
    sph2d__frozen *z = s->frozen;
    for (size_t i = first; i < last; i += SPH2D__LANES)
        if (z->imaged[i / SPH2D__LANES] > 0) {
            const drags f = sum_drags(s, i, false);
            sph2d__lanes_store(z->push_x + i, sph2d__lanes_load(z->push_x + i) + thick_strength(s) * f.images.x);
            sph2d__lanes_store(z->push_y + i, sph2d__lanes_load(z->push_y + i) + thick_strength(s) * f.images.y);
        }
}

/* ---- one by one -------------------------------------------------------------------------------------------------- */

/** Where the first solve starts. */
SPH2D__INLINE void thick_start(sph2d__system *s, size_t first, size_t last)
{
    for (size_t i = first; i < last; ++i) {
        s->frozen->thick_x[i] = s->fluid.vx[i];
        s->frozen->thick_y[i] = s->fluid.vy[i];
    }
}

/** Makes neighbours see a velocity. */
SPH2D__INLINE void show(sph2d__frozen *z, size_t i, double x, double y)
{
    SPH2D__ARRAY float *row = z->velocity + 4 * i;
    row[0] = (float)x;
    row[1] = (float)y;
    row[2] = row[3] = 0;
}

SPH2D__INLINE void show_way(sph2d__system *s, size_t first, size_t last)
{
    for (size_t i = first; i < last; ++i)
        show(s->frozen, i, s->frozen->way_x[i], s->frozen->way_y[i]);
}

SPH2D__INLINE void show_found(sph2d__system *s, size_t first, size_t last)
{
    for (size_t i = first; i < last; ++i)
        show(s->frozen, i, s->frozen->thick_x[i], s->frozen->thick_y[i]);
}

/** A step along the direction; adds the square of what is left over the diagonal. */
SPH2D__INLINE void thick_step(sph2d__system *s, size_t i, const double *length, sph2d__slab_sum *sum)
{
    sph2d__frozen *z = s->frozen;
    const double x = z->rest_x[i] - *length * z->slowed_x[i], y = z->rest_y[i] - *length * z->slowed_y[i];
    z->thick_x[i] += *length * z->way_x[i];
    z->thick_y[i] += *length * z->way_y[i];
    z->rest_x[i] = x;
    z->rest_y[i] = y;
    sum->first += z->eased_x[i] * x * x + z->eased_y[i] * y * y;
}

/** The next direction, which has a part of this one. */
SPH2D__INLINE void thick_turn(sph2d__system *s, size_t i, const double *keep)
{
    sph2d__frozen *z = s->frozen;
    z->way_x[i] = z->eased_x[i] * z->rest_x[i] + *keep * z->way_x[i];
    z->way_y[i] = z->eased_y[i] * z->rest_y[i] + *keep * z->way_y[i];
    show(z, i, z->way_x[i], z->way_y[i]);
}

#endif
