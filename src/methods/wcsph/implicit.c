/* SPDX-License-Identifier: MIT */
/** @file implicit.c
 *  Method `constraint`: the operators of wcsph.h, and one implicit solve over a step in place of acoustic steps. With
 *  w = dt/2, p = P/m and the accelerations g_i of all that is neither pressure nor dissipation,
 *
 *      v_m = v_0 + w (g_i - D^T p),  theta_m = theta_0 + w D(v_m),  p = c0^2 theta_m + Z c0 H D(v_m)
 *      v_1 = 2 v_m - v_0,  theta_1 = 2 theta_m - theta_0
 *
 *  the midpoint rule, which keeps squares (Hairer, Lubich & Wanner 2006, sec. IV.2), and so K + U. With e = Z c0 H/w
 *
 *      (1/(c0^2 + e) + w^2 D D^T) p = theta_0 + w D(v_0 + w g) - e theta_0/(c0^2 + e)
 *
 *  where theta_0 has half of what relaxation adds over the step; the other half comes after. So that is a source, whose cost
 *  is m c0^2 theta_m times it, whatever c0. What of it the step's dissipation does not pay for is taken back, and solved for
 *  once more from there. theta_m follows from p, not from D. What is left of the equations is then the only energy that is
 *  not accounted for, 2 m p . left. With that of close pairs, which is their friction, it is none at any tolerance:
 *  conjugate gradients (Hestenes & Stiefel 1952) start from a multiple of c0^2 theta_0 and keep it out of all later
 *  directions (deflation: Saad, Yeung, Erhel & Guyomarc'h 2000, SIAM J. Sci. Comput. 21, 1909-1926), so that what is left is
 *  orthogonal to all that p is made of.
 *
 *  A body's velocity is one of the unknowns, as a particle's is: with G_b its rows of D (wcsph_bodies.c), M_b its mass,
 *  w^2 G_b M_b^-1 G_b^T is added to the matrix. So light ones are as stable as heavy ones. Particles in reservoirs have
 *  a known velocity; where an opening prescribes their pressure, p is known, too, and taken to the other side. Where it
 *  prescribes a velocity, p follows from the liquid before them: given from step to step it would answer a step later.
 *
 *  Where the liquid is thick (thick.c), w is dt: pressure is that at the end of the step, as friction is. Both act on the
 *  same motion, and what friction stops at the end the middle would send back. Viscosity has the energy anyway. Both are
 *  solved for twice, by turns: friction by a pressure of the last step gives energy.
 *
 *  Walls act on films (wcsph.h) that come nearer at the start of the step, and on none that they would hold by p < 0: a is 0
 *  for these in a second solve, which starts from the first, with what of relaxation is paid for.
 *
 *  Dissipation is explicit, by velocities at the start, before the solve: what it takes is known, whatever pressure is
 *  about to do. b, C and e are bounded by what a step of this length bears. Close pairs, and what walls stop, are in the
 *  matrix (implicit_close.c).
 *
 *  The step is not bound by sound but by order, as geometry stands still in it (wcsph.c). */
#include <math.h>

#include "methods/wcsph/implicit_spans.h"
#include "methods/wcsph/wcsph.h"
#include "sim/stages.h"

/* b c0 dt/dx at most: no row of d has a larger sum than 1.5 times this. */
static const double BRAKE = 0.4;
/* The most that l takes of the velocity of a body in a step, over what would stop it. */
static const double BODY_BRAKE = 0.5;

/* In how many dx/sqrt(head) of the sound speed density goes to its sum over the neighbours: with 1 % of compression, in the
 * 100 H/c0 of acoustic steps (advance.c). Not in H/c0: what flow makes of order is the same for any c0. */
static const double RELAXATION = 21;

static const sph2d__implicit_pass *pass_of(const sph2d__system *s)
{
    return sph2d__implicit_pass_find(s->isa);
}

/* ---- before the solve -------------------------------------------------------------------------------------------- */

/** What of this is bounded by the step's length. */
static void set_bounds(sph2d__system *s, double dt)
{
    sph2d__frozen *z = s->frozen;
    const double c = s->sound_speed;
    z->dt = dt;
    z->thick = !sph2d__viscous_at_once(s, dt);
    z->ahead = z->thick ? dt : dt / 2;
    z->share = z->past = 1;
    z->most_brake = fmin(1, BRAKE * s->spacing / (c * dt));
    if (s->rigid_count > 0) {
        sph2d__frozen_bodies_rate(s);
        for (size_t k = 0; k < s->rigid_count; ++k)
            z->most_brake = fmin(z->most_brake, BODY_BRAKE / fmax(z->bodies[k].brake * dt, 1e-300));
    }
}

static void loosen_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    (void)with;
    pass_of(s)->loosen(s, slab->first, slab->last, sum);
}

/** What acts once, by the velocities at the start; its work is at *to later (slabs.h). */
static void loosen(sph2d__system *s, sph2d__slab_sum *to)
{
    sph2d__over_particles(s, s->fluid.count, pass_of(s)->rest, "rest_pass");
    sph2d__over_particles(s, s->fluid.count, expect_some, "expect_pass");
    sph2d__images_of_pressure(s);
    sph2d__close_find(s);
    sph2d__images_of_rest(s);
    sph2d__over_fluid_later(s, loosen_slab, NULL, "loosen_pass", 0, to);
}

/* ---- relaxation of density --------------------------------------------------------------------------------------- */

SPH2D__SLAB_WORK(relax_slab, relax_step(s, i, with))

/** What theta changes by over the step, if all of it is paid for. */
static void relax(sph2d__system *s, double dt)
{
    const double part = fmin(dt * sqrt(sph2d__head_of_sound(s)) / (RELAXATION * s->spacing), 1);
    sph2d__each_of_fluid(s, relax_slab, &part, "relax_pass", sizeof part);
}

SPH2D__SLAB_WORK(cost_slab, add_cost(s, i, sum))

/* ---- the matrix -------------------------------------------------------------------------------------------------- */

static void multiply_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    (void)with;
    pass_of(s)->multiply(s, slab->first, slab->last, sum);
    for (size_t i = slab->first; i < slab->last; ++i)
        sum->second += close_multiply(s, i);
}

/** The motion D^T of the pressures in `press`, of the liquid and of bodies. */
static void transpose(sph2d__system *s)
{
    sph2d__images_of_pressure(s);
    sph2d__over_particles(s, s->fluid.count, pass_of(s)->transpose, "transpose_pass");
}

/** The product of the matrix with the direction, whose pressures are in `press`; returns their own product. */
static double multiply(sph2d__system *s)
{
    transpose(s);
    for (size_t k = 0; k < s->rigid_count; ++k)
        s->frozen->bodies[k].trial = (sph2d__twist){0, 0, 0};
    if (s->rigid_count > 0) {
        sph2d__frozen_bodies_pull(s, -1);
        sph2d__frozen_bodies_feed(s);
    }
    sph2d__images_of_velocity(s);
    const sph2d__slab_sum sum = sph2d__over_fluid(s, multiply_slab, NULL, "multiply_pass", 0);
    return sum.first + sum.second;
}

/* ---- the right side ---------------------------------------------------------------------------------------------- */

SPH2D__SLAB_WORK(load_slab, load_one(s, i, with, sum))

/** The right side; returns the sums of load_one(). */
static sph2d__slab_sum load(sph2d__system *s, bool again)
{
    sph2d__frozen *z = s->frozen;
    const size_t n = s->fluid.count;
    if (s->rigid_count > 0)
        sph2d__frozen_bodies_expect(s, z->ahead);
    if (z->holds) {
        sph2d__over_particles(s, n, press_known, NULL);
        transpose(s);
        if (s->rigid_count > 0)
            sph2d__frozen_bodies_pull(s, z->ahead);
    }
    sph2d__over_particles(s, n, start_flow, "start_flow_pass");
    if (s->rigid_count > 0)
        sph2d__frozen_bodies_feed(s);
    sph2d__images_of_velocity(s);
    sph2d__over_particles(s, n, pass_of(s)->diverge, "diverge_pass");
    return sph2d__over_fluid(s, load_slab, &again, "load_pass", sizeof again);
}

/* ---- conjugate gradients ----------------------------------------------------------------------------------------- */

SPH2D__SLAB_WORK(step_slab, step_one(s, i, with, sum))

SPH2D__SLAB_WORK(direct_slab, direct_one(s, i, with))

/* The matrix is symmetric to the rounding of floats alone. */
static const double LEAST_TOLERANCE = 1e-5;

/** The solve, from the sums of `load` on. */
static void solve(sph2d__system *s, sph2d__slab_sum sum)
{
    const double tolerance = fmax(s->method.tolerance, LEAST_TOLERANCE), wanted = tolerance * tolerance * sum.first;
    double square = sum.first, first_curvature = 0;
    uint64_t count = s->iterations;
    factors f = {0, 0, 0};
    if (sum.third > 0) {
        first_curvature = multiply(s);
        sph2d__over_particles(s, s->fluid.count, keep_first, "keep_first_pass");
        ++count;
        f.alpha = sum.second / first_curvature;
        sum = sph2d__over_fluid(s, step_slab, &f, "step_pass", sizeof f);
        square = sum.first;
        f.gamma = sum.second / first_curvature;
    } else {
        sph2d__over_particles(s, s->fluid.count, keep_first, "keep_first_pass");
    }
    while (square > wanted && count < s->method.max_iterations) {
        sph2d__each_of_fluid(s, direct_slab, &f, "direct_pass", sizeof f);
        const double curvature = multiply(s);
        ++count;
        if (!(curvature > 0))
            break;
        f.alpha = square / curvature;
        sum = sph2d__over_fluid(s, step_slab, &f, "step_pass", sizeof f);
        f.beta = sum.first / square;
        f.gamma = first_curvature > 0 ? sum.second / first_curvature : 0;
        square = sum.first;
    }
    s->iterations = count;
    s->wanted_residual = tolerance;
    s->residual = wanted > 0 ? tolerance * sqrt(square / wanted) : 0;
    s->unconverged = square > wanted;
}

/* ---- once more --------------------------------------------------------------------------------------------------- */

SPH2D__SLAB_WORK(count_drawn, sum->first += is_drawn(s, i))

SPH2D__SLAB_WORK(take_back_slab, take_back(s, i, with))

/** Takes back what of relaxation is not paid for, and what would draw particles together or to walls. Of a part of it the
 *  cost is no more than that part, as p is the larger the more of it there is, and damping takes its square:
 *
 *      part cost = paid + part^2 damped */
static void pay(sph2d__system *s, double paid, const sph2d__slab_sum *of, bool draws)
{
    const double cost = of->first, damped = fmax(of->second, 0);
    paid = fmax(paid + of->third, 0);
    const bool enough = cost <= paid + damped;
    if ((enough && !draws) || s->unconverged || s->iterations >= s->method.max_iterations)
        return;
    const double part = enough ? 1 : 2 * paid / (cost + sqrt(cost * cost - 4 * paid * damped));
    sph2d__each_of_fluid(s, take_back_slab, &part, "take_back_pass", sizeof part);
    sph2d__over_particles(s, s->fluid.count, keep_found, "keep_found_pass");
    solve(s, load(s, true));
}

/* ---- where the liquid is thick ----------------------------------------------------------------------------------- */

/** Friction and pressure twice, by turns. */
static void solve_thick(sph2d__system *s)
{
    sph2d__thick_solve(s, false);
    solve(s, load(s, false));
    sph2d__over_particles(s, s->fluid.count, press_found, "press_found_pass");
    transpose(s);
    sph2d__over_particles(s, s->fluid.count, expect_pressed, "expect_pressed_pass");
    sph2d__over_particles(s, s->fluid.count, keep_found, "keep_found_pass");
    sph2d__thick_solve(s, true);
    solve(s, load(s, true));
}

/* ---- the step ---------------------------------------------------------------------------------------------------- */

static void finish_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    (void)with;
    pass_of(s)->finish(s, slab->first, slab->last, sum);
}
SPH2D__SLAB_WORK(compress_slab, compress(s, i, sum))

/** Velocities and densities by the pressures that were found. */
static void finish(sph2d_sim *sim)
{
    sph2d__system *s = &sim->system;
    sph2d__record *r = &sim->record;
    sph2d__slab_sum work, squeezed, stored;
    double stopped = 0, late = 0, rubbed = 0;
    sph2d__over_particles(s, s->fluid.count, press_solved, "press_solved_pass");
    transpose(s);
    sph2d__over_fluid_later(s, finish_slab, NULL, "finish_pass", 0, &work);
    sph2d__over_fluid_later(s, compress_slab, NULL, "compress_pass", 0, &squeezed);
    sph2d__images_of_velocity(s); /* where they are now */
    if (s->rigid_count > 0) {
        stopped = sph2d__frozen_bodies_kick(s, 1, &rubbed);
        late = sph2d__frozen_bodies_late(s);
    }
    sph2d__frozen_store_later(s, &stored);
    sph2d__sums_settle(s);
    r->energy_pressed -= work.first + squeezed.first + s->mass * s->frozen->dt / s->frozen->ahead * squeezed.second;
    r->energy_viscous -= work.second;
    r->energy_fed -= work.third + squeezed.third;
    r->energy_forces += work.fourth;
    s->external = (sph2d_vec2){s->external.x + work.x, s->external.y + work.y};
    r->energy_pressed -= stopped;
    r->energy_pressed -= late;
    r->energy_viscous -= rubbed;
    r->energy_pressed -= s->mass * stored.first; /* is not dissipated */
}

void sph2d__implicit_sound(sph2d_sim *sim, double dt)
{
    sph2d__system *s = &sim->system;
    sph2d__record *r = &sim->record;
    sph2d__slab_sum stored, loose, cost, drawn;
    set_bounds(s, dt);
    relax(s, dt);
    sph2d__frozen_begin(s);
    sph2d__frozen_start_external(s);
    sph2d__images_of_velocity(s);
    sph2d__frozen_store_later(s, &stored);
    loosen(s, &loose);
    sph2d__profile_enter(&s->profile, SPH2D_PHASE_SOLVE);
    s->iterations = 0;
    if (s->frozen->thick)
        solve_thick(s);
    else
        solve(s, load(s, false));
    sph2d__over_fluid_later(s, cost_slab, NULL, "cost_pass", 0, &cost);
    sph2d__over_fluid_later(s, count_drawn, NULL, "count_drawn_pass", 0, &drawn);
    sph2d__sums_settle(s);
    r->energy_fed += s->mass * stored.first;
    r->energy_pressed -= loose.first;
    r->energy_fed -= loose.third;
    r->energy_diffused -= loose.fourth;
    pay(s, -loose.first - loose.fourth, &cost, drawn.first > 0);
    finish(sim);
    r->iterations += s->iterations;
    r->unconverged += s->unconverged;
    r->unconverged_row = s->unconverged ? r->unconverged_row + 1 : 0;
}
