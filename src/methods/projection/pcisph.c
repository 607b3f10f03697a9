/* SPDX-License-Identifier: MIT */
/** @file pcisph.c
 *  Method `pcisph`: predictive-corrective incompressible SPH (Solenthaler & Pajarola 2009). With the notation of
 *  projection.h and y = dt^2 p/rho0, a step repeats
 *
 *      x+ = x + dt v + dt^2 a - D' z        rho+ at x+, with the neighbours of x
 *      r = rho+/rho0 - 1 - z/(c0 dt)^2
 *      y <- max(0, z + w r/(2 sum |G|^2)),  z = max(0, y + b (y - last y))
 *
 *  until the largest |r| where z > 0 or r > 0 is at most max_compression, three times at least (their minIterations). The
 *  sum is that of a filled lattice, for all particles (their prototype): 1/(2 sum |G|^2) is delta of their eq. 8 in the
 *  units of y. Beyond the paper:
 *  - A relaxation w < 1, halved where r grows: unrelaxed the loop diverges for wide kernels and where particles are
 *    disordered.
 *  - Going ahead by b of the last way, starting anew where that goes too far (Nesterov 1983; O'Donoghue & Candes 2015,
 *    who restart by the sign of r . (y - last y)): a third of the iterations.
 *  - The compliance of a sound speed c0. Where there is more liquid than room, pressures then have an end.
 *  - A start from a part of the last step's pressure. */
#include <math.h>

#include "kernels/kernel.h"
#include "methods/projection/projection.h"
#include "simd/lanes.h"

/* w */
static const double RELAXATION = 0.9;
/* Part of the last step's pressure that a step starts from: all of it, where little of it has to change, keeps what is
 * wrong with it from step to step. */
static const double WARMTH = 0.3;
/* The step along what is left was too long when more is left than so much of the least. */
static const double GROWTH = 1.5;
/* Iterations in a step. */
enum { LEAST = 3 };

/** One correction of a store's multipliers, which are ahead of those of the last correction: a step along what is left,
 *  and on by `ahead` of the way from there. */
typedef struct correction {
    double factor; /**< of the step */
    double ahead;
    double soft; /**< compression that a multiplier keeps */
} correction;

/** Predicts the densities of a slab, then corrects. Sums and largest: what was left of the fluid, compression and
 *  pressure that is too large. Second sum: left . way, below zero where going ahead went too far. */
static void correct_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const correction *c = with;
    sph2d__store *rows = slab->rows;
    double total = 0, most = 0;
    sph2d__projection_predict(s, slab);
    for (size_t i = slab->first; i < slab->last; ++i) {
        double ahead = sph2d__splat_value(rows->direction[i]), r = rows->residual[i] - c->soft * ahead;
        double left = r > 0 ? r : ahead > 0 ? -r : 0, y = ahead + c->factor * r;
        y = y > 0 ? y : 0;
        double way = y - rows->multiplier[i];
        ahead = y + c->ahead * way;
        rows->multiplier[i] = y;
        rows->direction[i] = sph2d__splat(ahead > 0 ? ahead : 0);
        total += left;
        sum->second += r * way;
        most = left > most ? left : most;
    }
    if (slab->walls)
        return;
    sum->first = total;
    sum->most = most;
}

static void project(sph2d__system *s)
{
    double sound = s->sound_speed * s->step, t = 1, least = INFINITY;
    correction c = {RELAXATION / (2 * sph2d__projection_prototype(s)), 0, 1 / (sound * sound)};
    uint64_t n = 0;
    sph2d__projection_begin(s, WARMTH);
    s->wanted_residual = s->method.max_compression;
    s->unconverged = true;
    while (n < s->method.max_iterations && (s->unconverged || n < LEAST)) {
        double next = (1 + sqrt(1 + 4 * t * t)) / 2;
        c.ahead = (t - 1) / next;
        sph2d__projection_next_positions(s);
        sph2d__slab_sum left = sph2d__over_rows(s, correct_slab, &c);
        s->residual = left.most;
        s->unconverged = !(s->residual <= s->wanted_residual);
        bool grows = left.first > GROWTH * least;
        c.factor *= grows ? 0.5 : 1;
        t = grows || left.second < 0 ? 1 : next;
        least = fmin(least, left.first);
        ++n;
    }
    s->iterations = n;
    sph2d__projection_end(s);
}

const sph2d__method sph2d__pcisph = {
    .name = "pcisph",
    .step = sph2d__projected,
    .fluid = SPH2D__PROJECTION_FLUID | SPH2D__BIT(next_x) | SPH2D__BIT(next_y),
    .carried = SPH2D__PROJECTION_CARRIED,
    .walls = SPH2D__PROJECTION_WALLS,
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
