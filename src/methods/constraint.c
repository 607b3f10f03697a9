/* SPDX-License-Identifier: MIT */
/** @file constraint.c
 *  Method `constraint`: the system of a step, its solution, step limits. */
#include "methods/constraint.h"

#include <math.h>

#include "base/lanes.h"
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

/** The residual of the multipliers of the step before: the right-hand side less the matrix times them, both with one
 *  sum over neighbours. */
static void load_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const spook *k = with;
    sph2d__store *t = slab->rows;
    (void)sum;
    sph2d__projection_collect(s, slab, k->dt * (1 - k->gamma), t->residual);
    for (size_t i = slab->first; i < slab->last; ++i) {
        double weight = slab->walls ? t->mass[i] / s->mass : 1, g = weight * (t->density[i] / s->rest_density - 1);
        t->residual[i] += 4 * k->gamma * g - k->soft * t->multiplier[i];
        t->diagonal[i] = t->diagonal[i] > 0 ? 1 / (t->diagonal[i] + k->soft) : 0;
    }
}

static void load(sph2d__system *s, const spook *k)
{
    sph2d__projection_begin(s, 1);
    sph2d__projection_lead(s, k->dt * (1 - k->gamma), k->dt * k->dt);
    sph2d__over_rows(s, load_slab, k);
}

/** product = (D D' + S) direction; the sum is direction . product. */
static void apply_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const spook *k = with;
    sph2d__store *t = slab->rows;
    sph2d__projection_collect(s, slab, 0, t->product);
    for (size_t i = slab->first; i < slab->last; ++i) {
        double direction = sph2d__twin_value(t->direction[i]);
        t->product[i] += k->soft * direction;
        sum->first += direction * t->product[i];
    }
}

static double apply(sph2d__system *s, const spook *k)
{
    sph2d__projection_spread(s);
    return sph2d__over_rows(s, apply_slab, k).first;
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
static void begin_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    sph2d__store *t = slab->rows;
    (void)s;
    (void)with;
    for (size_t i = slab->first; i < slab->last; ++i) {
        double inverse = fabs(t->diagonal[i]), r = t->residual[i];
        bool active = t->multiplier[i] > 0 || r > 0;
        t->diagonal[i] = active ? inverse : -inverse;
        t->direction[i] = sph2d__twin(active ? r * inverse : 0);
        if (active && inverse > 0)
            add_residual(sum, r, inverse);
    }
}

/** One step along the direction. */
static void advance_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const double *length = with;
    sph2d__store *t = slab->rows;
    (void)s;
    for (size_t i = slab->first; i < slab->last; ++i) {
        t->multiplier[i] += *length * sph2d__twin_value(t->direction[i]);
        t->residual[i] -= *length * t->product[i];
        if (t->diagonal[i] > 0)
            add_residual(sum, t->residual[i], t->diagonal[i]);
    }
}

/** The next direction. */
static void turn_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const double *keep = with;
    sph2d__store *t = slab->rows;
    (void)s;
    (void)sum;
    for (size_t i = slab->first; i < slab->last; ++i) {
        double next = t->diagonal[i] * t->residual[i] + *keep * sph2d__twin_value(t->direction[i]);
        t->direction[i] = sph2d__twin(t->diagonal[i] > 0 ? next : 0);
    }
}

/** The way from multipliers that pull back to none. The sum: what that does to residuals, as far as a row's own goes.
 */
static void clamp_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    sph2d__store *t = slab->rows;
    (void)s;
    (void)with;
    for (size_t i = slab->first; i < slab->last; ++i) {
        double kept = sph2d__twin(t->multiplier[i] < 0 ? -t->multiplier[i] : 0), pull = sph2d__twin_value(kept);
        t->direction[i] = kept;
        if (!(pull > 0))
            continue;
        t->multiplier[i] = -pull; /* so that the way ends at 0 */
        sum->second += pull / fabs(t->diagonal[i]);
    }
}

/* A round ends where so much is left of what it began with: the active rows are others then. */
static const double ROUND = 0.3;
/* The last one ends where so much of what may be left is left: multipliers below zero are still to be cut off. */
static const double LAST = 0.75;
/* What cutting off may leave in all rows, over what it leaves in its own: 1 at most in a collapsing column. */
static const double BESIDE = 2;

/** Rounds of preconditioned conjugate gradients (Hestenes & Stiefel 1952) on the rows that are active, until what is
 *  left is small. */
static void solve(sph2d__system *s, const spook *k)
{
    const double whole = 1;
    double wanted = s->method.tolerance * (double)s->fluid.count;
    uint64_t steps = 0, most = s->method.max_iterations;
    load(s, k);
    sph2d__slab_sum now = sph2d__over_rows(s, begin_slab, NULL);
    bool falls = true; /* not where nothing but an even compression is left, in a room that is full */
    while (now.second > wanted && steps < most && falls) {
        double round = fmax(ROUND * now.second, LAST * wanted);
        while (now.second > round && steps < most) {
            double curve = apply(s, k), before = now.first, length = before / curve;
            falls = curve > 0;
            if (!falls)
                break;
            now = sph2d__over_rows(s, advance_slab, &length);
            double keep = now.first / before;
            sph2d__over_rows(s, turn_slab, &keep);
            ++steps;
        }
        double cut = BESIDE * sph2d__over_rows(s, clamp_slab, NULL).second;
        if (now.second + cut <= wanted) { /* the usual end: little is cut off, and is not worth a look */
            now.second += cut;
            break;
        }
        if (cut > 0) {
            apply(s, k);
            sph2d__over_rows(s, advance_slab, &whole);
        }
        now = sph2d__over_rows(s, begin_slab, NULL);
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
    .fluid = SPH2D__PROJECTION_FLUID | SPH2D__BIT(product),
    .carried = SPH2D__STORE_BASIC | SPH2D__BIT(pressure),
    .walls = SPH2D__PROJECTION_WALLS | SPH2D__BIT(product),
    .prepare = sph2d__projection_prepare,
    .evaluate = sph2d__projection_gather,
    .project = project,
    .stable_step = stable_step,
};
