/* SPDX-License-Identifier: MIT */
/** @file constraint.c
 *  Method `constraint`: the system of a step, its solution, step limits. */
#include "methods/constraint.h"

#include <math.h>

#include "base/threads.h"
#include "methods/projection.h"

/* Step limits as fractions of H^2/nu and sqrt(H/a): viscosity is explicit; liquid that is let go must not fall far in a
 * step. */
static const double VISCOUS = 0.03;
static const double FORCE = 0.1;

/** The numbers of the step that is being taken. */
typedef struct spook {
    double dt, gamma;
    double soft; /**< S */
} spook;

static spook spook_of(const sph2d__system *s)
{
    spook k = {.dt = s->step, .gamma = 1 / (1 + 4 * s->method.damping)};
    k.soft = s->sound_speed < INFINITY ? 4 * k.gamma / (s->sound_speed * s->sound_speed * k.dt * k.dt) : 0;
    return k;
}

/* ---- the system -------------------------------------------------------------------------------------------------- */

/** The rows of one store: those of the fluid, or those of the boundary particles. */
typedef struct part {
    sph2d__store *store;
    const sph2d__neighbours *neighbours;
    int threads;
} part;

enum { PARTS = 2 };

static void list_parts(sph2d__system *s, part parts[PARTS])
{
    parts[0] = (part){&s->fluid, &s->neighbours, sph2d__threads_for(s->threads, s->fluid.count)};
    parts[1] = (part){&s->walls, &s->wall_neighbours, sph2d__threads_for(s->threads, s->walls.count)};
}

/** How many parts have rows. */
static int part_count(const sph2d__system *s)
{
    return s->walls_press ? PARTS : 1;
}

/** product = (D D' + S) direction. */
static void apply(sph2d__system *s, const spook *k, const part *parts)
{
    sph2d__rows out = {s->fluid.product, s->walls.product};
    sph2d__projection_spread(s, (sph2d__rows){s->fluid.direction, s->walls.direction});
    sph2d__projection_collect(s, 0, out);
    for (int n = 0; n < part_count(s); ++n) {
        const part *p = &parts[n];
#pragma omp parallel for schedule(static) num_threads(p->threads) if (p->threads > 1)
        for (size_t i = 0; i < p->store->count; ++i)
            p->store->product[i] += k->soft * p->store->direction[i];
    }
}

/** The residual of the multipliers of the step before: the right-hand side less the matrix times them, both with one
 *  sum over neighbours. */
static void load(sph2d__system *s, const spook *k, const part *parts)
{
    const sph2d__store *f = &s->fluid;
    double keep = k->dt * (1 - k->gamma), fall = k->dt * k->dt;
    sph2d__projection_begin(s);
    sph2d__projection_spread(s, (sph2d__rows){f->multiplier, s->walls.multiplier});
#pragma omp parallel for schedule(static) num_threads(parts[0].threads) if (parts[0].threads > 1)
    for (size_t i = 0; i < f->count; ++i) {
        f->push_x[i] = keep * f->vx[i] + fall * f->ax[i] - f->push_x[i];
        f->push_y[i] = keep * f->vy[i] + fall * f->ay[i] - f->push_y[i];
    }
    sph2d__projection_collect(s, keep, (sph2d__rows){f->residual, s->walls.residual});
    for (int n = 0; n < part_count(s); ++n) {
        sph2d__store *t = parts[n].store;
#pragma omp parallel for schedule(static) num_threads(parts[n].threads) if (parts[n].threads > 1)
        for (size_t i = 0; i < t->count; ++i) {
            double weight = n == 0 ? 1 : t->mass[i] / s->mass, g = weight * (t->density[i] / s->rest_density - 1);
            t->residual[i] += 4 * k->gamma * g - k->soft * t->multiplier[i];
            t->diagonal[i] = t->diagonal[i] > 0 ? 1 / (t->diagonal[i] + k->soft) : 0;
        }
    }
}

/* ---- conjugate gradients ----------------------------------------------------------------------------------------- */

/** What is left to correct, as compressions: r . r/diagonal, the sum and the largest of its sizes. Of either sign:
 * where the pressure is too large it must fall. */
static inline void add_residual(sph2d__slab_sum *sum, double r, double inverse)
{
    double size = fabs(r);
    sum->first += r * r * inverse;
    sum->second += size;
    sum->most = size > sum->most ? size : sum->most;
}

/** Which rows are active is kept in the sign of the inverse diagonal: that of the others is negative. */
static sph2d__slab_sum begin_rows(const part *p, double unused)
{
    sph2d__store *t = p->store;
    (void)unused;
#pragma omp parallel for schedule(static) num_threads(p->threads) if (p->threads > 1)
    SPH2D__FOR_SLABS(p->neighbours, t->count, i, sum)
    {
        double inverse = fabs(t->diagonal[i]), r = t->residual[i];
        bool active = t->multiplier[i] > 0 || r > 0;
        t->diagonal[i] = active ? inverse : -inverse;
        t->direction[i] = active ? r * inverse : 0;
        if (active && inverse > 0)
            add_residual(&sum, r, inverse);
    }
    return sph2d__neighbours_total(p->neighbours, t->count);
}

/** direction . product. */
static sph2d__slab_sum curve_rows(const part *p, double unused)
{
    const sph2d__store *t = p->store;
    (void)unused;
#pragma omp parallel for schedule(static) num_threads(p->threads) if (p->threads > 1)
    SPH2D__FOR_SLABS(p->neighbours, t->count, i, sum)
    sum.first += t->direction[i] * t->product[i];
    return sph2d__neighbours_total(p->neighbours, t->count);
}

/** One step along the direction. */
static sph2d__slab_sum advance_rows(const part *p, double length)
{
    sph2d__store *t = p->store;
#pragma omp parallel for schedule(static) num_threads(p->threads) if (p->threads > 1)
    SPH2D__FOR_SLABS(p->neighbours, t->count, i, sum)
    {
        t->multiplier[i] += length * t->direction[i];
        t->residual[i] -= length * t->product[i];
        if (t->diagonal[i] > 0)
            add_residual(&sum, t->residual[i], t->diagonal[i]);
    }
    return sph2d__neighbours_total(p->neighbours, t->count);
}

/** The next direction. */
static sph2d__slab_sum turn_rows(const part *p, double keep)
{
    sph2d__store *t = p->store;
#pragma omp parallel for schedule(static) num_threads(p->threads) if (p->threads > 1)
    for (size_t i = 0; i < t->count; ++i)
        t->direction[i] = t->diagonal[i] > 0 ? t->diagonal[i] * t->residual[i] + keep * t->direction[i] : 0;
    return (sph2d__slab_sum){0};
}

/** The way from multipliers that pull back to none. The sum: how far. */
static sph2d__slab_sum clamp_rows(const part *p, double unused)
{
    sph2d__store *t = p->store;
    (void)unused;
#pragma omp parallel for schedule(static) num_threads(p->threads) if (p->threads > 1)
    SPH2D__FOR_SLABS(p->neighbours, t->count, i, sum)
    {
        double pull = t->multiplier[i] < 0 ? -t->multiplier[i] : 0;
        t->direction[i] = pull;
        sum.second += pull;
    }
    return sph2d__neighbours_total(p->neighbours, t->count);
}

/** Does the same to all parts and adds up what they sum. */
static sph2d__slab_sum over(const part *parts, int count, sph2d__slab_sum (*what)(const part *, double), double value)
{
    sph2d__slab_sum sum = {0};
    for (int n = 0; n < count; ++n) {
        sph2d__slab_sum one = what(&parts[n], value);
        sum.first += one.first;
        sum.second += one.second;
        sum.most = one.most > sum.most ? one.most : sum.most;
    }
    return sum;
}

/* A round ends where so much is left of what it began with: the active rows are others then. */
static const double ROUND = 0.3;
/* The last one ends where so much of what may be left is left: multipliers below zero are still to be cut off. */
static const double LAST = 0.7;

/** Rounds of preconditioned conjugate gradients (Hestenes & Stiefel 1952) on the rows that are active, until what is
 *  left is small. */
static void solve(sph2d__system *s, const spook *k)
{
    part parts[PARTS];
    int count = part_count(s);
    double wanted = s->method.tolerance * (double)s->fluid.count;
    uint64_t steps = 0, most = s->method.max_iterations;
    list_parts(s, parts);
    load(s, k, parts);
    sph2d__slab_sum now = over(parts, count, begin_rows, 0);
    bool falls = true; /* not where nothing but an even compression is left, in a room that is full */
    while (now.second > wanted && steps < most && falls) {
        double round = fmax(ROUND * now.second, LAST * wanted);
        while (now.second > round && steps < most) {
            apply(s, k, parts);
            double curve = over(parts, count, curve_rows, 0).first, before = now.first;
            falls = curve > 0;
            if (!falls)
                break;
            now = over(parts, count, advance_rows, before / curve);
            over(parts, count, turn_rows, now.first / before);
            ++steps;
        }
        if (over(parts, count, clamp_rows, 0).second > 0) {
            apply(s, k, parts);
            over(parts, count, advance_rows, 1);
        }
        now = over(parts, count, begin_rows, 0);
    }
    s->iterations = steps;
    s->left = now.second / fmax(1, (double)s->fluid.count);
    s->wanted = s->method.tolerance;
    s->unconverged = !(now.second <= wanted);
}

/* ---- the step ---------------------------------------------------------------------------------------------------- */

static void project(sph2d__system *s)
{
    spook k = spook_of(s);
    solve(s, &k);
    sph2d__projection_end(s);
}

static double stable_step(const sph2d__system *s, double speed, double acceleration, sph2d__limit *limit)
{
    return sph2d__projection_step(s, speed, acceleration, VISCOUS, FORCE, limit);
}

const sph2d__method sph2d__constraint = {
    .name = "constraint",
    .integrator = SPH2D__PROJECTED,
    .fluid = SPH2D__PROJECTION_FLUID | SPH2D__BIT(direction) | SPH2D__BIT(product),
    .carried = SPH2D__STORE_BASIC | SPH2D__BIT(pressure),
    .walls = SPH2D__PROJECTION_WALLS | SPH2D__BIT(direction) | SPH2D__BIT(product),
    .prepare = sph2d__projection_prepare,
    .evaluate = sph2d__projection_gather,
    .project = project,
    .stable_step = stable_step,
};
