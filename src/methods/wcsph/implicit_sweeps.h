/* SPDX-License-Identifier: MIT */
/** @file implicit_sweeps.h
 *  The sweeps of implicit.c over pairs that stand still, in C and in OpenCL C. Every lane is a particle. */
#ifndef SPH2D_METHODS_WCSPH_IMPLICIT_SWEEPS_H
#define SPH2D_METHODS_WCSPH_IMPLICIT_SWEEPS_H

#include "methods/wcsph/wcsph_force.h"

/** a, by density and velocities at the start of the step. It stands for the whole of it: films that are drawn then are let go
 *  (implicit.c). */
SPH2D__INLINE void find_acts(sph2d__system *s, size_t i)
{
    const vectors v = load(s->fluid.vx, s->fluid.vy, i), wall = load(s->frozen->sx, s->frozen->sy, i);
    const sph2d__lanes by = 2 * dot(v, wall) - sph2d__lanes_load(s->frozen->wall_rate + i);
    sph2d__lanes_store(s->frozen->acts + i, acts_at(s, i, sph2d__lanes_load(s->fluid.log_density + i), by));
}

SPH2D__INLINE void rest_some(sph2d__system *s, size_t first, size_t last)
{
    for (size_t i = first; i < last; i += SPH2D__LANES) {
        const rate_sums r = sum_rates(s, i, true);
        keep_rest(s, i, &r);
        if (s->neighbours.slices[i / SPH2D__LANES].walls > 0)
            find_acts(s, i);
    }
}

/* ---- before the solve -------------------------------------------------------------------------------------------- */

/** Sums over the pairs of a slice, with and without images. */
typedef struct two_sums {
    force_sums all, without;
} two_sums;

/** Of what is dissipated. */
SPH2D__INLINE two_sums sum_loose(const sph2d__system *s, size_t i)
{
    two_sums of;
    of.all = of.without = (force_sums){0};
    if (s->viscosity > 0 && !s->frozen->thick)
        of.all = sum_pairs(s, i, (terms){true, true, false}, &of.without);
    else
        of.all = sum_pairs(s, i, (terms){true, false, false}, &of.without);
    return of;
}

/** Velocities by d, e and l: by themselves, so that they take energy from whatever pressure is about to do. */
SPH2D__INLINE void brake_particles(sph2d__system *s, size_t i, size_t last, const force_sums *f, sph2d__slab_sum *sum)
{
    sph2d__frozen *z = s->frozen;
    sph2d__store *t = &s->fluid;
    const double dt = z->dt, m = s->mass;
    const vectors v = load(t->vx, t->vy, i), wall = load(z->sx, z->sy, i), d = dissipate(s, i, f, smoothing(s, 1));
    vectors a = {d.x / m, d.y / m};
    sph2d__lanes brake = {0};
    if (s->neighbours.slices[i / SPH2D__LANES].walls > 0) {
        brake = wall_brake(s, i);
        a = (vectors){a.x - brake / m * wall.x, a.y - brake / m * wall.y};
        sph2d__lanes_store(z->brake + i, brake);
        sph2d__lanes_store(z->mean_work + i, brake);
    }
    if (z->holds)
        hold(s, i, last, v, &a, sum);
    const vectors middle = {v.x + dt / 2 * a.x, v.y + dt / 2 * a.y};
    add_lanes(&sum->first,
              dt * (dot(d, middle) - brake * (dot(wall, middle) - 0.5 * sph2d__lanes_load(z->wall_rate + i))), i, last);
    sph2d__lanes_store(t->vx + i, v.x + dt * a.x);
    sph2d__lanes_store(t->vy + i, v.y + dt * a.y);
}

/** Viscosity and the friction of walls, by velocities at the start. What walls without slip take is that of the velocities
 *  that the last step's accelerations lead to, which are `before`; where the liquid is thick, these wait for thick.c. */
SPH2D__INLINE void rub_particles(sph2d__system *s, size_t i, vectors v, vectors before, const force_sums *f)
{
    sph2d__frozen *z = s->frozen;
    vectors by = before;
    if (!z->thick) {
        const double m = s->mass, thick = viscosity(s, 1);
        vectors drag = {thick * f->vx, thick * f->vy}, a = {before.x + drag.x / m, before.y + drag.y / m};
        if (z->rubs || z->sticks)
            rub(s, i, v, &a, &drag);
        by = (vectors){drag.x / m, drag.y / m};
    }
    sph2d__lanes_store(z->rubbed_x + i, by.x);
    sph2d__lanes_store(z->rubbed_y + i, by.y);
}

/* Part of what differs that diffuses in a step, at most. */
SPH2D__FIXED double MOST_DIFFUSED = 0.25;

/** Density diffuses. */
SPH2D__INLINE void diffuse(sph2d__system *s, size_t i, size_t last, const force_sums *f, sph2d__slab_sum *sum)
{
    sph2d__frozen *z = s->frozen;
    const double stiffness = s->mass * s->sound_speed * s->sound_speed;
    const double rate = SPH2D__DIFFUSION * s->sound_speed * z->dt,
                 most = MOST_DIFFUSED * s->support / s->lattice_slopes;
    const sph2d__lanes theta = sph2d__lanes_load(s->fluid.log_density + i);
    sph2d__lanes change = -(rate < most ? rate : most) * f->diffused;
    if (z->holds)
        change = (1 - sph2d__lanes_load(z->known + i)) * change;
    add_lanes(&sum->fourth, stiffness * change * (theta + 0.5 * change), i, last);
    sph2d__lanes_store(z->diffused + i, change);
}

/** The accelerations that act with pressure. `v`: velocities at the start. */
SPH2D__INLINE void give(sph2d__system *s, size_t i, vectors v, const two_sums *loose)
{
    sph2d__frozen *z = s->frozen;
    sph2d__store *t = &s->fluid;
    vectors to = v; /* Coriolis' force by the velocity in the middle, as far as the last step foretells it */
    if (z->varies)
        to = (vectors){v.x + z->dt / 2 * sph2d__lanes_load(t->ax + i), v.y + z->dt / 2 * sph2d__lanes_load(t->ay + i)};
    const vectors driven = fall(s, i, to);
    vectors taken = {{0}, {0}};
    if (z->images.count > 0)
        taken = turn(z, i, driven);
    if (z->imaged[i / SPH2D__LANES] > 0)
        push_by_sides(s, i, &loose->all, &loose->without, 1);
    vectors a = {driven.x + taken.x, driven.y + taken.y};
    if (z->pulls)
        a = (vectors){a.x + sph2d__lanes_load(z->pull_x + i), a.y + sph2d__lanes_load(z->pull_y + i)};
    sph2d__lanes_store(t->ax + i, a.x);
    sph2d__lanes_store(t->ay + i, a.y);
    sph2d__lanes_store(z->taken_x + i, taken.x);
    sph2d__lanes_store(z->taken_y + i, taken.y);
    sph2d__lanes_store(z->driven_x + i, to.x);
    sph2d__lanes_store(z->driven_y + i, to.y);
}

SPH2D__INLINE void loosen_some(sph2d__system *s, size_t first, size_t last, sph2d__slab_sum *to)
{
    sph2d__slab_sum sum = *to;
    for (size_t i = first; i < last; i += SPH2D__LANES) {
        const vectors v = load(s->fluid.vx, s->fluid.vy, i), before = load(s->fluid.ax, s->fluid.ay, i);
        const two_sums loose = sum_loose(s, i);
        give(s, i, v, &loose);
        rub_particles(s, i, v, before, &loose.all);
        brake_particles(s, i, last, &loose.all, &sum);
        diffuse(s, i, last, &loose.all, &sum);
    }
    *to = sum;
}

/* ---- the solve --------------------------------------------------------------------------------------------------- */

SPH2D__INLINE void transpose_slice(sph2d__system *s, size_t i, bool walled)
{
    sph2d__frozen *z = s->frozen;
    SPH2D__ARRAY const sph2d__slice *at = &s->neighbours.slices[i / SPH2D__LANES];
    sph2d__lanes x = {0}, y = {0}, ex = {0}, ey = {0};
    for (size_t k = at->begin, slot = 0; slot < at->fluid; ++slot, k += SPH2D__STRIDE) {
        const sph2d__lanes gx = sph2d__floats_load(z->gx + k), gy = sph2d__floats_load(z->gy + k);
        const sph2d__four q = sph2d__four_gather(z->press, s->neighbours.index + k);
        x += q.a * gx + q.b * gy;
        y += q.b * gx + q.c * gy;
        if (walled) {
            ex += q.d * gx;
            ey += q.d * gy;
        }
    }
    const sph2d__four q = sph2d__four_load(z->press + 4 * i);
    const vectors n = load(z->nx, z->ny, i);
    x += q.a * n.x + q.b * n.y;
    y += q.b * n.x + q.c * n.y;
    if (at->walls > 0) {
        const vectors e = {ex - q.d * n.x, ey - q.d * n.y}, wall = load(z->sx, z->sy, i);
        sph2d__lanes_store(z->slope_x + i, e.x);
        sph2d__lanes_store(z->slope_y + i, e.y);
        const sph2d__lanes press = 2 * sph2d__lanes_load(z->acts + i) * q.d;
        x += press * wall.x - dot(load(z->cxx, z->cxy, i), e);
        y += press * wall.y - dot(load(z->cyx, z->cyy, i), e);
    }
    x -= sph2d__lanes_load(z->pushed_x + i);
    y -= sph2d__lanes_load(z->pushed_y + i);
    sph2d__lanes_store(z->pull_back_x + i, x);
    sph2d__lanes_store(z->pull_back_y + i, y);
    if (z->holds) {
        const sph2d__lanes free = 1 - sph2d__lanes_load(z->held + i);
        x *= free;
        y *= free;
    }
    sph2d__four_store(z->velocity + 4 * i, seen_motion(z, i, (vectors){x, y}, at->walls > 0));
}

SPH2D__INLINE void transpose_some(sph2d__system *s, size_t first, size_t last)
{
    for (size_t i = first; i < last; i += SPH2D__LANES)
        if (s->frozen->flags[i / SPH2D__LANES] & SPH2D__FROZEN_WALLED)
            transpose_slice(s, i, true);
        else
            transpose_slice(s, i, false);
}

/** D of the motion, but for q. */
SPH2D__INLINE sph2d__lanes motion_rate(const sph2d__system *s, size_t i)
{
    const sph2d__frozen *z = s->frozen;
    const rate_sums r = sum_rates(s, i, false);
    const sph2d__four own = sph2d__four_load(z->velocity + 4 * i);
    sph2d__lanes rate = liquid_rate(z, i, &r);
    if (s->neighbours.slices[i / SPH2D__LANES].walls > 0)
        rate += 2 * sph2d__lanes_load(z->acts + i) * dot((vectors){own.a, own.b}, load(z->sx, z->sy, i)) +
                own.c * sph2d__lanes_load(z->nx + i) + own.d * sph2d__lanes_load(z->ny + i);
    if (s->rigid_count > 0)
        rate += sph2d__lanes_load(z->body_rate + i);
    return rate;
}

SPH2D__INLINE void diverge_some(sph2d__system *s, size_t first, size_t last)
{
    for (size_t i = first; i < last; i += SPH2D__LANES)
        sph2d__lanes_store(s->frozen->product + i, motion_rate(s, i));
}

SPH2D__INLINE void multiply_some(sph2d__system *s, size_t first, size_t last, sph2d__slab_sum *sum)
{
    const sph2d__frozen *z = s->frozen;
    const double w = z->ahead;
    double all = 0;
    for (size_t i = first; i < last; i += SPH2D__LANES) {
        const sph2d__lanes d = sph2d__lanes_load(z->direction + i);
        const sph2d__lanes product = sph2d__lanes_load(z->soft + i) * d + w * w * motion_rate(s, i);
        sph2d__lanes_store(z->product + i, product);
        add_lanes(&all, d * product, i, last);
    }
    sum->first += all;
}

/* ---- after it ---------------------------------------------------------------------------------------------------- */

/** Adds the pressure of images to the mean force of sides. */
SPH2D__INLINE void press_sides(const sph2d__system *s, size_t i)
{
    sph2d__frozen *z = s->frozen;
    SPH2D__ARRAY const sph2d__slice *at = &s->neighbours.slices[i / SPH2D__LANES];
    const uint32_t images = z->imaged[i / SPH2D__LANES];
    sph2d__lanes x = {0}, y = {0};
    size_t k = at->begin + (size_t)(at->fluid - images) * SPH2D__STRIDE;
    for (uint32_t slot = 0; slot < images; ++slot, k += SPH2D__STRIDE) {
        const sph2d__lanes gx = sph2d__floats_load(z->gx + k), gy = sph2d__floats_load(z->gy + k);
        const sph2d__four q = sph2d__four_gather(z->press, s->neighbours.index + k);
        x += q.a * gx + q.b * gy;
        y += q.b * gx + q.c * gy;
    }
    const sph2d__four q = sph2d__four_load(z->press + 4 * i);
    const vectors n = load(z->image_nx, z->image_ny, i);
    sph2d__lanes_store(z->push_x + i, sph2d__lanes_load(z->push_x + i) - x - (q.a * n.x + q.b * n.y));
    sph2d__lanes_store(z->push_y + i, sph2d__lanes_load(z->push_y + i) - y - (q.b * n.x + q.c * n.y));
}

/** What the pressures do to walls. */
SPH2D__INLINE void press_walls(const sph2d__system *s, size_t i)
{
    sph2d__frozen *z = s->frozen;
    const vectors e = load(z->slope_x, z->slope_y, i);
    const sph2d__lanes walled = s->mass * sph2d__lanes_load(z->walled + i);
    const sph2d__lanes p = sph2d__lanes_load(z->acts + i) * sph2d__four_load(z->press + 4 * i).d;
    sph2d__lanes_store(z->mean_work + i, sph2d__lanes_load(z->mean_work + i) + 2 * s->mass * p);
    sph2d__lanes_store(z->mean_ex + i, walled * dot(load(z->axx, z->axy, i), e));
    sph2d__lanes_store(z->mean_ey + i, walled * dot(load(z->axy, z->ayy, i), e));
}

SPH2D__INLINE void move_on(sph2d__system *s, size_t i, size_t last, sph2d__slab_sum *sum)
{
    sph2d__frozen *z = s->frozen;
    sph2d__store *t = &s->fluid;
    const double dt = z->dt, m = s->mass;
    const vectors v = load(t->vx, t->vy, i), back = load(z->pull_back_x, z->pull_back_y, i),
                  at = load(t->next_x, t->next_y, i);
    const vectors rubbed = load(z->rubbed_x, z->rubbed_y, i), pushed = load(z->pushed_x, z->pushed_y, i),
                  pressed = {back.x + pushed.x, back.y + pushed.y};
    vectors a = {sph2d__lanes_load(t->ax + i) - back.x, sph2d__lanes_load(t->ay + i) - back.y};
    sph2d__lanes_store(t->ax + i, a.x);
    sph2d__lanes_store(t->ay + i, a.y);
    a = (vectors){a.x + rubbed.x, a.y + rubbed.y};
    if (z->holds)
        hold(s, i, last, v, &a, sum);
    const double late = z->ahead - dt / 2; /* of the velocities that pressure works with */
    sph2d__lanes work = late * dot(pressed, a);
    if (s->neighbours.slices[i / SPH2D__LANES].walls > 0)
        work -= sph2d__lanes_load(z->stopped + i) * sph2d__lanes_load(z->front_speed + i);
    const vectors middle = {v.x + dt / 2 * a.x, v.y + dt / 2 * a.y};
    work = dt * m * (work + dot(load(z->taken_x, z->taken_y, i), middle) + dot(pushed, middle));
    add_lanes(&sum->first, work, i, last);
    sph2d__lanes lost = dt * m * dot(rubbed, middle);
    if (z->driven) {
        const vectors to = load(z->driven_x, z->driven_y, i);
        lost += drive(s, i, last, fall(s, i, to), to, middle, sum);
    }
    add_lanes(&sum->second, lost, i, last);
    sph2d__lanes_store(t->vx + i, v.x + dt * a.x);
    sph2d__lanes_store(t->vy + i, v.y + dt * a.y);
    sph2d__lanes_store(z->px + i, at.x + dt * middle.x);
    sph2d__lanes_store(z->py + i, at.y + dt * middle.y);
}

SPH2D__INLINE void finish_some(sph2d__system *s, size_t first, size_t last, sph2d__slab_sum *to)
{
    sph2d__slab_sum sum = *to;
    for (size_t i = first; i < last; i += SPH2D__LANES) {
        if (s->frozen->imaged[i / SPH2D__LANES] > 0)
            press_sides(s, i);
        if (s->neighbours.slices[i / SPH2D__LANES].walls > 0)
            press_walls(s, i);
        move_on(s, i, last, &sum);
    }
    *to = sum;
}

#endif
