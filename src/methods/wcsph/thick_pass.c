/* SPDX-License-Identifier: MIT */
/** @file thick_pass.c
 *  The sweeps of thick.c. Compiled once for each instruction set, named by SPH2D__ISA. Every lane is a particle. */
#include "methods/wcsph/wcsph.h"
#include "methods/wcsph/wcsph_force.h"

/** Sums over the pairs of a slice: w r G, and the diagonal of that. */
typedef struct drags {
    vectors all, images, diagonal;
} drags;

SPH2D__INLINE drags sum_drags(const sph2d__system *s, size_t i, bool diagonal)
{
    const sph2d__frozen *z = s->frozen;
    const sph2d__slice *at = &s->neighbours.slices[i / SPH2D__LANES];
    const sph2d__four own = sph2d__four_load(z->velocity + 4 * i);
    const sph2d__lanes none = {0}, one = sph2d__lanes_all(1);
    const sph2d__lanes mu = s->viscosities ? sph2d__lanes_load(s->viscosities + i) : one;
    const uint32_t alone = at->fluid - z->imaged[i / SPH2D__LANES];
    drags sum = {{none, none}, {none, none}, {none, none}};
    vectors before = {none, none};
    size_t k = at->begin;
    for (uint32_t slot = 0; slot < at->fluid; ++slot, k += SPH2D__LANES) {
        if (slot == alone)
            before = sum.all;
        const uint32_t *j = s->neighbours.index + k;
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
SPH2D__INLINE double strength(const sph2d__system *s)
{
    return (s->viscosities ? 1 : s->viscosity) / s->rest_density * s->central_weight;
}

/** Adds -K v. */
SPH2D__INLINE void stick(const sph2d__system *s, size_t i, vectors v, vectors *a)
{
    const sph2d__frozen *z = s->frozen;
    if (!z->sticks)
        return;
    const sph2d__lanes xy = sph2d__lanes_load(z->stick_xy + i);
    a->x -= sph2d__lanes_load(z->stick_xx + i) * v.x + xy * v.y;
    a->y -= xy * v.x + sph2d__lanes_load(z->stick_yy + i) * v.y;
}

/** Adds what does not depend on velocities. */
SPH2D__INLINE void push(const sph2d__system *s, size_t i, vectors *a)
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
    vectors a = {strength(s) * f->all.x, strength(s) * f->all.y};
    stick(s, i, (vectors){own.a, own.b}, &a);
    return a;
}

SPH2D__INLINE sph2d__lanes free_part(const sph2d__frozen *z, size_t i)
{
    return z->holds ? 1 - sph2d__lanes_load(z->held + i) : sph2d__lanes_all(1);
}

static void load_span(sph2d__system *s, size_t first, size_t last, sph2d__slab_sum *sum)
{
    sph2d__frozen *z = s->frozen;
    const double dt = z->dt;
    for (size_t i = first; i < last; i += SPH2D__LANES) {
        const drags f = sum_drags(s, i, true);
        const sph2d__lanes part = free_part(z, i);
        vectors a = resist(s, i, &f),
                diagonal = {1 - dt * strength(s) * f.diagonal.x, 1 - dt * strength(s) * f.diagonal.y};
        if (z->sticks) {
            diagonal.x += dt * sph2d__lanes_load(z->stick_xx + i);
            diagonal.y += dt * sph2d__lanes_load(z->stick_yy + i);
        }
        push(s, i, &a);
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

static void multiply(sph2d__system *s, size_t first, size_t last, sph2d__slab_sum *sum)
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

static void finish(sph2d__system *s, size_t first, size_t last)
{
    sph2d__frozen *z = s->frozen;
    for (size_t i = first; i < last; i += SPH2D__LANES) {
        const drags f = sum_drags(s, i, false);
        const sph2d__four own = sph2d__four_load(z->velocity + 4 * i);
        vectors a = resist(s, i, &f);
        push(s, i, &a);
        sph2d__lanes_store(z->rubbed_x + i, a.x);
        sph2d__lanes_store(z->rubbed_y + i, a.y);
        sph2d__lanes_store(z->mean_vx + i, own.a);
        sph2d__lanes_store(z->mean_vy + i, own.b);
    }
}

/** Once for both solves. */
static void push_sides(sph2d__system *s, size_t first, size_t last)
{
    sph2d__frozen *z = s->frozen;
    for (size_t i = first; i < last; i += SPH2D__LANES)
        if (z->imaged[i / SPH2D__LANES] > 0) {
            const drags f = sum_drags(s, i, false);
            sph2d__lanes_store(z->push_x + i, sph2d__lanes_load(z->push_x + i) + strength(s) * f.images.x);
            sph2d__lanes_store(z->push_y + i, sph2d__lanes_load(z->push_y + i) + strength(s) * f.images.y);
        }
}

const sph2d__thick_pass SPH2D__OF_ISA(sph2d__thick_pass) = {
    .load = load_span, .multiply = multiply, .finish = finish, .push_sides = push_sides};
