/* SPDX-License-Identifier: MIT */
/** @file wcsph_sweeps.h
 *  The sweeps of an acoustic step over pairs that stand still, in C and in OpenCL C. Every lane is a particle. */
#ifndef SPH2D_METHODS_WCSPH_WCSPH_SWEEPS_H
#define SPH2D_METHODS_WCSPH_WCSPH_SWEEPS_H

#include "methods/wcsph/wcsph_force.h"

/** Velocities by the forces of an acoustic step. */
SPH2D__INLINE void kick(sph2d__system *s, size_t i, size_t last, const force_sums *f, const force_sums *without,
                        double once, sph2d__slab_sum *sum)
{
    sph2d__frozen *z = s->frozen;
    sph2d__store *t = &s->fluid;
    const double dt = z->dt, m = s->mass;
    /* P B as rounded as neighbours see it, so that forces of pairs are opposite. */
    const sph2d__four q = sph2d__four_load(z->press + 4 * i);
    const vectors n = load(z->nx, z->ny, i), v = load(t->vx, t->vy, i);
    const vectors d = dissipate(s, i, f, smoothing(s, once));
    const double thick = viscosity(s, once);
    vectors drag = {thick * f->vx, thick * f->vy};
    vectors force = {d.x + drag.x - f->px - (q.a * n.x + q.b * n.y), d.y + drag.y - f->py - (q.b * n.x + q.c * n.y)};
    const bool walls = s->neighbours.slices[i / SPH2D__LANES].walls > 0;
    sph2d__lanes brake = {0}, repel = {0};
    const vectors front = load(z->front_nx, z->front_ny, i);
    if (walls)
        brake = add_walls(s, i, f, &force);
    const bool imaged = z->imaged[i / SPH2D__LANES] > 0;
    vectors driven = fall(s, i, v);
    vectors at = v;
    if (z->varies) { /* Coriolis' force by the velocity in the middle: of second order, and without work */
        at = (vectors){v.x + dt / 2 * (driven.x + force.x / m), v.y + dt / 2 * (driven.y + force.y / m)};
        driven = fall(s, i, at);
    }
    vectors a = driven, turned = {0};
    const bool mirrored = z->images.count > 0;
    if (mirrored) {
        turned = turn(z, i, driven);
        a = (vectors){a.x + turned.x, a.y + turned.y};
    }
    if (imaged)
        push_by_sides(s, i, f, without, once);
    a = (vectors){a.x + force.x / m, a.y + force.y / m};
    if (z->pulls)
        a = (vectors){a.x + sph2d__lanes_load(z->pull_x + i), a.y + sph2d__lanes_load(z->pull_y + i)};
    if (walls) {
        repel = repelled(s, i, front, (vectors){v.x + dt * a.x, v.y + dt * a.y});
        a = (vectors){a.x + repel * front.x / m, a.y + repel * front.y / m};
    }
    if (z->rubs || z->sticks)
        rub(s, i, v, &a, &drag);
    if (z->holds)
        hold(s, i, last, v, &a, sum);
    const vectors middle = {v.x + dt / 2 * a.x, v.y + dt / 2 * a.y}, next = {v.x + dt * a.x, v.y + dt * a.y};
    sph2d__lanes lost = dt * dot(drag, middle);
    if (z->driven)
        lost += drive(s, i, last, driven, at, middle, sum);
    sph2d__lanes work = dt * dot(d, middle);
    if (mirrored)
        work += dt * m * dot(turned, middle);
    if (walls)
        work += dt * (repel * (dot(front, middle) - sph2d__lanes_load(z->front_speed + i)) -
                      brake * (dot(load(z->sx, z->sy, i), middle) - 0.5 * sph2d__lanes_load(z->wall_rate + i)));
    add_lanes(&sum->first, work, i, last);
    add_lanes(&sum->second, lost, i, last);
    sph2d__lanes_store(z->diffused + i, -once * dt * SPH2D__DIFFUSION * s->sound_speed * f->diffused);
    sph2d__lanes_store(t->ax + i, a.x);
    sph2d__lanes_store(t->ay + i, a.y);
    sph2d__lanes_store(t->vx + i, next.x);
    sph2d__lanes_store(t->vy + i, next.y);
    sph2d__four seen = seen_motion(z, i, next, walls);
    if (walls) {
        seen.c += sph2d__lanes_load(z->wall_zx + i);
        seen.d += sph2d__lanes_load(z->wall_zy + i);
    }
    sph2d__four_store(z->next_velocity + 4 * i, seen);
}

SPH2D__INLINE void force_span(sph2d__system *s, size_t first, size_t last, double once, sph2d__slab_sum *to)
{
    sph2d__slab_sum sum = *to;
    for (size_t i = first; i < last; i += SPH2D__LANES) {
        force_sums without = {0}, f = sum_forces(s, i, once > 0, &without);
        if (s->frozen->close[i / SPH2D__LANES] > 0)
            add_repulsion(s, i, &f, &without);
        kick(s, i, last, &f, &without, once, &sum);
    }
    *to = sum;
}

static void force(sph2d__system *s, size_t first, size_t last, double once, sph2d__slab_sum *sum)
{
    if (once > 0)
        force_span(s, first, last, once, sum);
    else
        force_span(s, first, last, 0, sum);
}

/** For how long rates act before diffusion, and after it [s]. */
typedef struct times {
    double before, after;
} times;

/** D before walls begin or cease to act, and after it. */
typedef struct wall_rates {
    sph2d__lanes before, after;
} wall_rates;

/** Adds what walls do to D, `liquid`, over `time` as they acted so far. */
SPH2D__INLINE wall_rates add_wall_rate(sph2d__system *s, size_t i, vectors v, double time, sph2d__lanes liquid)
{
    sph2d__frozen *z = s->frozen;
    const sph2d__four own = sph2d__four_load(z->velocity + 4 * i);
    const sph2d__lanes by = 2 * dot(v, load(z->sx, z->sy, i)) - sph2d__lanes_load(z->wall_rate + i);
    liquid += own.c * sph2d__lanes_load(z->nx + i) + own.d * sph2d__lanes_load(z->ny + i);
    wall_rates d = {.before = liquid + sph2d__lanes_load(z->acts + i) * by};
    const sph2d__lanes acts = acts_at(s, i, sph2d__lanes_load(s->fluid.log_density + i) + time * d.before, by);
    sph2d__lanes_store(z->acts + i, acts);
    d.after = liquid + acts * by;
    return d;
}

/** The logarithm of density by its rate and diffusion, then P. */
SPH2D__INLINE void drift(sph2d__system *s, size_t i, size_t last, const rate_sums *r, times time, sph2d__slab_sum *sum)
{
    sph2d__frozen *z = s->frozen;
    sph2d__store *t = &s->fluid;
    const double stiffness = s->mass * s->sound_speed * s->sound_speed;
    const double drift = time.before + time.after;
    const sph2d__lanes bxx = sph2d__lanes_load(z->bxx + i), bxy = sph2d__lanes_load(z->bxy + i),
                       byy = sph2d__lanes_load(z->byy + i);
    const vectors v = load(t->vx, t->vy, i), at = load(z->px, z->py, i);
    const sph2d__lanes liquid = liquid_rate(z, i, r);
    wall_rates d = {liquid, liquid};
    if (s->neighbours.slices[i / SPH2D__LANES].walls > 0)
        d = add_wall_rate(s, i, v, time.before, liquid);
    sph2d__lanes change = sph2d__lanes_load(z->diffused + i);
    if (z->holds) {
        const sph2d__lanes held = sph2d__lanes_load(z->held + i);
        const sph2d__lanes now = sph2d__lanes_load(t->log_density + i),
                           old = sph2d__lanes_load(z->held_log_density + i);
        add_lanes(&sum->fourth,
                  stiffness * held * (time.before * d.before * old + time.after * d.after * now + change * now), i,
                  last);
        sph2d__lanes_store(z->held_log_density + i, now);
        d = (wall_rates){(1 - held) * d.before, (1 - held) * d.after};
        change = (1 - held) * change;
    }
    const sph2d__lanes rate = d.after;
    const sph2d__lanes before = sph2d__lanes_load(t->log_density + i) + time.before * d.before;
    const sph2d__lanes damping = sph2d__lanes_load(z->damping + i), damped = damping * rate;
    const sph2d__lanes theta = before + change + time.after * rate;
    const sph2d__lanes work = stiffness * theta + damped;
    const double kept = time.before > 0 ? stiffness * z->dt * z->dt / 8 : 0; /* of D^2 in what a kick keeps */
    add_lanes(&sum->first,
              damping * sph2d__lanes_load(z->rate + i) * time.before * d.before + time.after * damped * rate +
                  kept * (rate * rate - d.before * d.before),
              i, last);
    sph2d__lanes_store(z->rate + i, rate);
    add_lanes(&sum->second, stiffness * change * (before + 0.5 * change), i, last);
    add_lanes(&sum->third, rate * rate, i, last);
    sph2d__lanes_store(t->log_density + i, theta);
    sph2d__lanes_store(z->px + i, at.x + drift * v.x);
    sph2d__lanes_store(z->py + i, at.y + drift * v.y);
    sph2d__lanes_store(z->work + i, work);
    sph2d__four_store(z->press + 4 * i, (sph2d__four){work * bxx, work * bxy, work * byy, theta});
}

SPH2D__INLINE void rate_span(sph2d__system *s, size_t first, size_t last, times time, bool rest, sph2d__slab_sum *to)
{
    sph2d__slab_sum sum = *to;
    for (size_t i = first; i < last; i += SPH2D__LANES) {
        const rate_sums r = sum_rates(s, i, rest);
        if (rest)
            keep_rest(s, i, &r);
        drift(s, i, last, &r, time, &sum);
    }
    *to = sum;
}

static void rate(sph2d__system *s, size_t first, size_t last, double before, double after, bool rest,
                 sph2d__slab_sum *sum)
{
    if (rest)
        rate_span(s, first, last, (times){before, after}, true, sum);
    else
        rate_span(s, first, last, (times){before, after}, false, sum);
}

#endif
