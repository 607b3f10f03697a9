/* SPDX-License-Identifier: MIT */
/** @file constraint.c
 *  Method `constraint`: Constraint Fluids (Bodin, Lacoursiere & Servin 2011). Incompressibility is one constraint
 *  g_i = rho_i/rho0 - 1 a particle, and the pressure is the force that keeps it. The stepper is SPOOK (Lacoursiere
 *  2007): with J = dg/dx = D of projection.h, compliance e = 1/(m c0^2), damping of n steps and gamma = 1/(1 + 4 n)
 *
 *      (J M^-1 J' + 4 e gamma/dt^2) l = -(4/dt) gamma g + gamma J v - J (v + dt f/m)          v+ = v + dt f/m + J' l/m
 *
 *  With y = -l dt/m, which is dt^2 p/rho0, this is
 *
 *      (D D' + S) y = 4 gamma g + dt D (v* - gamma v)      S = 4 gamma/(c0 dt)^2,  v* = v + dt a
 *      v+ = v* - D' y/dt,  x+ = x + dt v+
 *
 *  At rest g = p/(rho0 c0^2), as in method wcsph, whatever the step. A compression fades within a few steps: n = 2 is
 *  the least without overshoot of a rigid constraint.
 *
 *  The constraints only push: y >= 0. Rows that would pull are left out, which are those of the free surface. The
 *  system is solved by conjugate gradients from the last step's pressure on; the residual is a compression, the part of
 *  it that the step leaves uncorrected. Where the density that follows is not what the linear system says, particles
 *  are corrected one by one (local_correction.h). */
#include <math.h>
#include <string.h>

#include "methods/projection/constraint_pass.h"
#include "methods/projection/local_correction.h"

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

/** Nothing, in the rows behind the last one that a pass may reach. */
static void end_rows(const sph2d__slab *slab)
{
    sph2d__store *t = slab->rows;
    double *all[] = {t->diagonal, t->residual, t->multiplier, t->direction, t->product};
    for (size_t k = 0; k < sizeof all / sizeof *all; ++k)
        memset(all[k] + slab->last, 0, (SPH2D__WIDEST - slab->last % SPH2D__WIDEST) * sizeof *all[k]);
}

/** The residual of the multipliers of the step before: the right-hand side less the matrix times them, both with one
 *  sum over neighbours. */
static void load_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const spook *k = with;
    sph2d__store *t = slab->rows;
    (void)sum;
    sph2d__projection_apply(s, slab, k->dt * (1 - k->gamma), t->residual);
    for (size_t i = slab->first; i < slab->last; ++i) {
        double weight = slab->walls ? t->mass[i] / s->mass : 1, g = weight * (t->density[i] / s->rest_density - 1);
        t->residual[i] += 4 * k->gamma * g - k->soft * t->multiplier[i];
        t->diagonal[i] = t->diagonal[i] > 0 ? 1 / (t->diagonal[i] + k->soft) : 0;
    }
    if (slab->last % SPH2D__WIDEST > 0)
        end_rows(slab);
}

static void load(sph2d__system *s, const spook *k)
{
    sph2d__projection_begin(s, 1);
    sph2d__projection_remaining_motion(s, k->dt * (1 - k->gamma), k->dt * k->dt);
    sph2d__over_rows(s, load_slab, k);
}

/* ---- conjugate gradients ----------------------------------------------------------------------------------------- */

/** How far to go, and the part of the direction to keep. */
typedef struct way {
    double length, keep;
} way;

static void begin_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    (void)with;
    sph2d__constraint_passes_find(s->isa)->begin(slab, sum);
}

static void apply_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const spook *k = with;
    sph2d__projection_apply(s, slab, 0, slab->rows->product);
    sph2d__constraint_passes_find(s->isa)->apply(slab, k->soft, sum);
}

static void advance_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const way *w = with;
    sph2d__constraint_passes_find(s->isa)->advance(slab, w->length, w->keep, sum);
}

static void clamp_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    (void)with;
    sph2d__constraint_passes_find(s->isa)->clamp(slab, sum);
}

/** product = (D D' + S) direction, and what apply sums up. */
static sph2d__slab_sum apply(sph2d__system *s, const spook *k)
{
    sph2d__projection_apply_transpose(s);
    return sph2d__over_rows(s, apply_slab, k);
}

/** One iteration from where `left` is left; that is set anew. What will be left, and with it the next direction,
 *  follows from the sums of the product, so that rows are read once less. False where the matrix bends nothing. */
static bool iterate(sph2d__system *s, const spook *k, sph2d__slab_sum *left)
{
    sph2d__slab_sum sum = apply(s, k);
    if (!(sum.first > 0))
        return false;
    double length = left->first / sum.first, next = left->first - length * (2 * sum.second - length * sum.third);
    *left = sph2d__over_rows(s, advance_slab, &(way){length, fmax(next, 0) / left->first});
    return true;
}

/* A round ends where so much is left of what it began with: the active rows are others then. */
static const double ROUND = 0.3;
/* The last one ends where so much of what may be left is left: multipliers below zero are still to be cut off. */
static const double LAST = 0.75;
/* What cutting off may leave in all rows, over what it leaves in its own: 1 at most in a collapsing column. */
static const double BESIDE = 2;

/** Rounds of preconditioned conjugate gradients (Hestenes & Stiefel 1952) on the rows that are active, until what is
 *  left is small. Returns the most that is left in one. */
static double solve(sph2d__system *s, const spook *k)
{
    double wanted = s->method.tolerance * (double)s->fluid.count;
    uint64_t steps = 0, most = s->method.max_iterations;
    load(s, k);
    sph2d__slab_sum now = sph2d__over_rows(s, begin_slab, NULL);
    bool falls = true; /* not where nothing but an even compression is left, in a room that is full */
    while (now.second > wanted && isfinite(now.second) && steps < most && falls) {
        double round = fmax(ROUND * now.second, LAST * wanted);
        while (falls && now.second > round && steps < most) {
            falls = iterate(s, k, &now);
            steps += falls;
        }
        double cut = BESIDE * sph2d__over_rows(s, clamp_slab, NULL).second;
        if (now.second + cut <= wanted) { /* the usual end: little is cut off, and is not worth a look */
            now.second += cut;
            break;
        }
        if (cut > 0) {
            apply(s, k);
            sph2d__over_rows(s, advance_slab, &(way){1, 0});
        }
        now = sph2d__over_rows(s, begin_slab, NULL);
    }
    s->iterations = steps;
    s->residual = now.second / fmax(1, (double)s->fluid.count);
    s->wanted_residual = s->method.tolerance;
    s->unconverged = !(now.second <= wanted);
    return now.most;
}

/* ---- the step ---------------------------------------------------------------------------------------------------- */

/* Part of the support radius: over shorter ways the matrix of a step holds, and nobody has to look. */
static const double STILL = 0.02;

static void project(sph2d__system *s)
{
    spook k = spook_of(s);
    double most = solve(s, &k), limit = s->method.max_compression;
    sph2d__projection_end(s);
    if (most > limit / 2 || s->speed * s->step > STILL * s->support)
        sph2d__stragglers_correct(s, limit, k.soft / (4 * k.gamma));
}

const sph2d__method sph2d__constraint = {
    .name = "constraint",
    .step = sph2d__projected,
    .fluid = SPH2D__PROJECTION_FLUID | SPH2D__BIT(product) | SPH2D__BIT(next_x) | SPH2D__BIT(next_y),
    .carried = SPH2D__PROJECTION_CARRIED,
    .walls = SPH2D__PROJECTION_WALLS | SPH2D__BIT(product),
    .prepare = sph2d__projection_prepare,
    .evaluate = sph2d__projection_gather,
    .project = project,
    .wall_force = sph2d__projection_wall_force,
    .elastic = sph2d__projection_elastic,
    .books_pressure = true,
    .mean_forces = true,
    .couples_bodies = true,
    .stable_step = sph2d__projection_step,
};
