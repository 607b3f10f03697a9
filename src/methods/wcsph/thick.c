/* SPDX-License-Identifier: MIT */
/** @file thick.c
 *  Viscosity that an implicit step (implicit.c) solves for, where the liquid is so thick that it is not stable at once over
 *  a step: with the forces of wcsph.h and of walls without slip (wcsph_friction.c), V v = K v - sum of viscosity,
 *
 *      (1 + dt V) v* = v_0 + dt (a + k),   a_v = k - V v*
 *
 *  a is the acceleration by all else: with pressure, without which liquid that it holds would seem to fall for a step, and a
 *  steady flow would depend on the step's length. a_v then acts with other pressures, and with an acceleration a' by all else
 *  v_1 = v* + dt (a' - a), so that v_1 - dt a' = v* - dt a and, with k = 0,
 *
 *      (v_1^2 - v_0^2)/2 = dt v_1 . a' - dt v* . V v* - (v* - v_0)^2/2 + dt^2 (a^2 - a'^2)/2
 *
 *  The first term is the work of pressure, which acts at the end of the step, and forces; V takes. The last is energy that
 *  is borrowed. With a of the last step it was 2.8 % of a column that collapses, of 2 Pa s and with 13 neighbours, where a
 *  particle's pressure is another in each step. So a is that of the last step in a first solve alone, and by
 *  the pressures that follow from it in the second, which starts from the first; then the column gained 0.0002 %. A third
 *  changes no more.
 *
 *  After Weiler, Koschier, Brand & Bender 2018 (Computer Graphics Forum 37), by conjugate gradients with the matrix's
 *  diagonal as preconditioner. a_v is summed over pairs from v*, opposite in both particles of one, whatever the
 *  tolerance. */
#include <math.h>

#include "methods/wcsph/thick_sweeps.h"
#include "methods/wcsph/wcsph.h"

/* What may be left of the equations: of velocities in the mean over the particles, and of the scene's speed. It is no
 * error of momentum, and gone with the next step. */
static const double TOLERANCE = 1e-4, FLOOR = 1e-8;
/* 1 + dt V has condition numbers up to some 10^5: bounds of yield stress in one cell. */
enum { MOST = 1000 };

static const sph2d__thick_pass *pass_of(const sph2d__system *s)
{
    return sph2d__thick_pass_find(s->isa);
}

static void load_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    (void)with;
    pass_of(s)->load(s, slab->first, slab->last, sum);
}

static void multiply_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    (void)with;
    pass_of(s)->multiply(s, slab->first, slab->last, sum);
}

SPH2D__SLAB_WORK(step_slab, thick_step(s, i, with, sum))

SPH2D__SLAB_WORK(turn_slab, thick_turn(s, i, with))

void sph2d__thick_solve(sph2d__system *s, bool again)
{
    const size_t n = s->fluid.count;
    if (!again)
        sph2d__over_particles(s, n, thick_start, "thick_start_pass");
    sph2d__over_particles(s, n, show_found, "show_found_pass");
    sph2d__images_of_velocity(s);
    const sph2d__slab_sum sum = sph2d__over_fluid(s, load_slab, NULL, "thick_load_pass", 0);
    const double wanted = TOLERANCE * TOLERANCE * sum.second +
                          FLOOR * FLOOR * (double)n * s->method.max_compression * s->sound_speed * s->sound_speed;
    double left = sum.first;
    sph2d__over_particles(s, n, show_way, "show_way_pass");
    for (int k = 0; left > wanted && k < MOST; ++k) {
        sph2d__images_of_velocity(s);
        const double bent = sph2d__over_fluid(s, multiply_slab, NULL, "thick_multiply_pass", 0).first;
        if (!(bent > 0))
            break;
        const double length = left / bent, before = left;
        left = sph2d__over_fluid(s, step_slab, &length, "thick_step_pass", sizeof length).first;
        const double keep = left / before;
        sph2d__each_of_fluid(s, turn_slab, &keep, "thick_turn_pass", sizeof keep);
    }
    sph2d__over_particles(s, n, show_found, "show_found_pass");
    sph2d__images_of_velocity(s);
    sph2d__over_particles(s, n, pass_of(s)->finish, "thick_finish_pass");
    if (again)
        sph2d__over_particles(s, n, pass_of(s)->push_sides, "thick_sides_pass");
}
