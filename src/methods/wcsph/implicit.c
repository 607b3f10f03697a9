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
#include <string.h>

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
static void bound(sph2d__system *s, double dt)
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

/** Particles where they are expected in the middle of the step, and no pressures. */
static void expect_some(sph2d__system *s, size_t first, size_t last)
{
    sph2d__frozen *z = s->frozen;
    const sph2d__store *f = &s->fluid;
    for (size_t i = first; i < last; ++i) {
        const float row[4] = {0, 0, 0, (float)f->log_density[i]};
        memcpy(z->press + 4 * i, row, sizeof row);
        z->px[i] += z->dt / 2 * f->vx[i];
        z->py[i] += z->dt / 2 * f->vy[i];
        z->work[i] = z->body_rate[i] = 0;
    }
}

static void loosen_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    (void)with;
    pass_of(s)->loosen(s, slab->first, slab->last, sum);
}

/** What acts once, by the velocities at the start. Returns what it dissipates [J/m]. */
static double loosen(sph2d_sim *sim)
{
    sph2d__system *s = &sim->system;
    sph2d__over_particles(s, s->fluid.count, pass_of(s)->rest, NULL);
    sph2d__over_particles(s, s->fluid.count, expect_some, NULL);
    sph2d__images_of_pressure(s);
    sph2d__close_find(s);
    sph2d__images_of_rest(s);
    const sph2d__slab_sum work = sph2d__over_fluid(s, loosen_slab, NULL, NULL, 0);
    sim->record.energy_pressed -= work.first;
    sim->record.energy_fed -= work.third;
    sim->record.energy_diffused -= work.fourth;
    return -work.first - work.fourth;
}

/* ---- relaxation of density --------------------------------------------------------------------------------------- */

/** What theta changes by over the step, into `summed`, if all of it is paid for. */
static void relax_some(sph2d__system *s, size_t first, size_t last)
{
    sph2d__frozen *z = s->frozen;
    const double part = fmin(z->dt * sqrt(sph2d__head_of_sound(s)) / (RELAXATION * s->spacing), 1);
    for (size_t i = first; i < last; ++i)
        z->summed[i] *= part / sph2d__density_ratio(s->fluid.log_density[i]);
}

/** What friction takes of particle i, which had velocity v, in the step [J/kg]. Where the liquid is thick, of the flow that it
 *  had: what relaxation itself drives takes friction as the square of it, and cannot pay for it. */
static double rubbed(const sph2d__frozen *z, size_t i, double vx, double vy)
{
    const double x = z->rubbed_x[i], y = z->rubbed_y[i], late = z->thick ? 0 : z->dt / 2;
    return -z->dt * (x * (vx + late * x) + y * (vy + late * y));
}

/** Sums up what it costs by the pressures that were found, what damping takes with them, and friction [J/m]. */
static void pay_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const sph2d__frozen *z = s->frozen;
    const sph2d__store *f = &s->fluid;
    const double c2 = s->sound_speed * s->sound_speed, m = s->mass, part = z->ahead / z->dt;
    (void)with;
    for (size_t i = slab->first; i < slab->last; ++i) {
        const double p = z->solved[i], relaxed = z->summed[i];
        const double then = z->soft[i] * p + (1 - c2 * z->soft[i]) * f->log_density[i];
        const double squeezed = (then - f->log_density[i]) / part, before = f->log_density[i] - part * relaxed;
        const double cost = m * c2 * relaxed * then, change = squeezed + relaxed;
        sum->first += cost;
        sum->second += cost + m * (p * squeezed - c2 * change * (before + change / 2));
        sum->third += m * rubbed(z, i, f->vx[i], f->vy[i]);
    }
}

/* ---- the matrix -------------------------------------------------------------------------------------------------- */

static void multiply_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    (void)with;
    pass_of(s)->multiply(s, slab->first, slab->last, sum);
    for (size_t i = slab->first; i < slab->last; ++i)
        sum->first += sph2d__close_multiply(s, i);
}

/** The motion D^T of the pressures in `press`, of the liquid and of bodies. */
static void transpose(sph2d__system *s)
{
    sph2d__images_of_pressure(s);
    sph2d__over_particles(s, s->fluid.count, pass_of(s)->transpose, NULL);
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
    return sph2d__over_fluid(s, multiply_slab, NULL, NULL, 0).first;
}

/** The pressures of a particle, as neighbours see them. */
static void press(sph2d__frozen *z, size_t i, double p)
{
    const float row[4] = {(float)(p * z->bxx[i]), (float)(p * z->bxy[i]), (float)(p * z->byy[i]), (float)p};
    memcpy(z->press + 4 * i, row, sizeof row);
}

/* ---- the right side ---------------------------------------------------------------------------------------------- */

static double known(const sph2d__system *s, size_t i)
{
    const double c2 = s->sound_speed * s->sound_speed;
    return s->frozen->holds && s->frozen->known[i] > 0 ? c2 * s->fluid.log_density[i] : 0;
}

/** The pressures that are known: those of reservoirs. */
static void press_known(sph2d__system *s, size_t first, size_t last)
{
    for (size_t i = first; i < last; ++i)
        press(s->frozen, i, known(s, i));
}

/** The liquid's motion in the middle of the step, without the pressures that are not known. */
static void start_motion(sph2d__system *s, size_t first, size_t last)
{
    sph2d__frozen *z = s->frozen;
    const sph2d__store *f = &s->fluid;
    for (size_t i = first; i < last; ++i) {
        const double w = z->ahead * (z->holds ? 1 - z->held[i] : 1);
        double x = f->vx[i] + w * (f->ax[i] + z->rubbed_x[i]), y = f->vy[i] + w * (f->ay[i] + z->rubbed_y[i]);
        if (z->holds) {
            x -= w * z->pull_back_x[i];
            y -= w * z->pull_back_y[i];
        }
        const float row[4] = {(float)x, (float)y, (float)(z->cxx[i] * x + z->cyx[i] * y + z->wall_zx[i]),
                              (float)(z->cxy[i] * x + z->cyy[i] * y + z->wall_zy[i])};
        memcpy(z->velocity + 4 * i, row, sizeof row);
    }
}

/** The right side, with D of that motion in `product`, and where the solve starts: `with` something, in `direction`. Sums up
 *  their squares and product. */
static void load_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    sph2d__frozen *z = s->frozen;
    const double w = z->ahead, c2 = s->sound_speed * s->sound_speed;
    const double stiff = c2 + SPH2D__DAMPING * s->sound_speed * s->support / w;
    const bool again = with != NULL;
    for (size_t i = slab->first; i < slab->last; ++i) {
        const bool held = z->holds && z->known[i] > 0;
        const double theta = s->fluid.log_density[i] + (again ? 0 : z->diffused[i] + w / z->dt * z->summed[i]),
                     p = known(s, i);
        s->fluid.log_density[i] = theta;
        z->soft[i] = 1 / (held ? c2 : stiff);
        z->solved[i] = held ? p : 0;
        z->residual[i] = w * (z->product[i] - z->acts[i] * z->wall_rate[i]) + (held ? 0 : c2 / stiff * theta);
        z->first[i] = z->direction[i] = held ? 0 : again ? z->direction[i] : c2 * theta;
        press(z, i, z->direction[i]);
        sph2d__close_load(s, i, again, sum);
        if (held)
            continue;
        sum->first += z->residual[i] * z->residual[i];
        sum->second += z->first[i] * z->residual[i];
        sum->third += z->first[i] * z->first[i];
    }
}

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
    sph2d__over_particles(s, n, start_motion, NULL);
    if (s->rigid_count > 0)
        sph2d__frozen_bodies_feed(s);
    sph2d__images_of_velocity(s);
    sph2d__over_particles(s, n, pass_of(s)->diverge, NULL);
    return sph2d__over_fluid(s, load_slab, again ? &again : NULL, NULL, 0);
}

/* ---- conjugate gradients ----------------------------------------------------------------------------------------- */

/** How far a step goes along the direction; what the next direction has of this one, and of the first pressures, to which it
 *  is made conjugate. */
typedef struct factors {
    double alpha, beta, gamma;
} factors;

/** A step along the direction. Sums up the square of the residual, and its product with that of the first pressures. */
static void step_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const factors *f = with;
    sph2d__frozen *z = s->frozen;
    double square = 0, first = 0;
    for (size_t i = slab->first; i < slab->last; ++i) {
        const double residual = z->residual[i] - f->alpha * z->product[i];
        const bool held = z->holds && z->known[i] > 0;
        z->solved[i] += f->alpha * z->direction[i];
        z->residual[i] = residual;
        square += held ? 0 : residual * residual;
        first += held ? 0 : residual * z->of_first[i];
        sph2d__close_step(s, i, f->alpha, sum);
    }
    sum->first += square;
    sum->second += first;
}

/** The next direction. */
static void direct_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const factors *f = with;
    sph2d__frozen *z = s->frozen;
    (void)sum;
    for (size_t i = slab->first; i < slab->last; ++i) {
        const bool held = z->holds && z->known[i] > 0;
        z->direction[i] = held ? 0 : z->residual[i] + f->beta * z->direction[i] - f->gamma * z->first[i];
        press(z, i, z->direction[i]);
        sph2d__close_direct(s, i, f->beta, f->gamma);
    }
}

static void keep_first(sph2d__system *s, size_t first, size_t last)
{
    memcpy(s->frozen->of_first + first, s->frozen->product + first, (last - first) * sizeof *s->frozen->product);
    for (size_t i = first; i < last; ++i)
        sph2d__close_keep_first(s, i);
}

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
        sph2d__over_particles(s, s->fluid.count, keep_first, NULL);
        ++count;
        f.alpha = sum.second / first_curvature;
        sum = sph2d__over_fluid(s, step_slab, &f, NULL, 0);
        square = sum.first;
        f.gamma = sum.second / first_curvature;
    } else {
        sph2d__over_particles(s, s->fluid.count, keep_first, NULL);
    }
    while (square > wanted && count < s->method.max_iterations) {
        sph2d__over_fluid(s, direct_slab, &f, NULL, 0);
        const double curvature = multiply(s);
        ++count;
        if (!(curvature > 0))
            break;
        f.alpha = square / curvature;
        sum = sph2d__over_fluid(s, step_slab, &f, NULL, 0);
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

/** Makes the next solve start from what was found. */
static void keep_found(sph2d__system *s, size_t first, size_t last)
{
    sph2d__frozen *z = s->frozen;
    for (size_t i = first; i < last; ++i) {
        z->direction[i] = z->solved[i];
        sph2d__close_push(s, i, false);
        z->pushed_x[i] = z->pushed_y[i] = z->stopped[i] = 0;
    }
}

/** Whether a wall holds a film by tension. */
static bool clings(const sph2d__system *s, size_t i)
{
    const sph2d__frozen *z = s->frozen;
    const bool beside = z->sx[i] * z->sx[i] + z->sy[i] * z->sy[i] > 0;
    return beside && !s->fills && !(z->walled[i] > 0) && z->acts[i] > 0 && z->solved[i] < 0;
}

static void count_clinging(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    (void)with;
    for (size_t i = slab->first; i < slab->last; ++i)
        sum->first += clings(s, i);
}

/** Keeps a part of the relaxation, and nothing that draws. */
static void take_back_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const double *part = with;
    sph2d__frozen *z = s->frozen;
    (void)sum;
    for (size_t i = slab->first; i < slab->last; ++i) {
        s->fluid.log_density[i] -= (1 - *part) * z->ahead / z->dt * z->summed[i];
        z->summed[i] *= *part;
        if (clings(s, i))
            z->acts[i] = 0;
        sph2d__close_drop(s, i);
    }
}

/** Takes back what of relaxation is not paid for, and what would draw particles together or to walls. Of a part of it the
 *  cost is no more than that part, as p is the larger the more of it there is, and damping takes its square:
 *
 *      part cost = paid + part^2 damped */
static void pay(sph2d__system *s, double paid)
{
    const sph2d__slab_sum of = sph2d__over_fluid(s, pay_slab, NULL, NULL, 0);
    const double cost = of.first, damped = fmax(of.second, 0);
    paid = fmax(paid + of.third, 0);
    const bool enough = cost <= paid + damped,
               draws = sph2d__close_pull(s) || sph2d__over_fluid(s, count_clinging, NULL, NULL, 0).first > 0;
    if ((enough && !draws) || s->unconverged || s->iterations >= s->method.max_iterations)
        return;
    const double part = enough ? 1 : 2 * paid / (cost + sqrt(cost * cost - 4 * paid * damped));
    sph2d__over_fluid(s, take_back_slab, &part, NULL, 0);
    sph2d__over_particles(s, s->fluid.count, keep_found, NULL);
    solve(s, load(s, true));
}

/* ---- where the liquid is thick ----------------------------------------------------------------------------------- */

static void press_found(sph2d__system *s, size_t first, size_t last)
{
    for (size_t i = first; i < last; ++i) {
        press(s->frozen, i, s->frozen->solved[i]);
        sph2d__close_push(s, i, false);
    }
}

/** The accelerations by all but friction with the pressures that were found, which the next solve starts from. */
static void expect_pressed(sph2d__system *s, size_t first, size_t last)
{
    sph2d__frozen *z = s->frozen;
    for (size_t i = first; i < last; ++i) {
        z->rubbed_x[i] = s->fluid.ax[i] - z->pull_back_x[i];
        z->rubbed_y[i] = s->fluid.ay[i] - z->pull_back_y[i];
    }
}

/** Friction and pressure twice, by turns. */
static void solve_thick(sph2d__system *s)
{
    sph2d__thick_solve(s, false);
    solve(s, load(s, false));
    sph2d__over_particles(s, s->fluid.count, press_found, NULL);
    transpose(s);
    sph2d__over_particles(s, s->fluid.count, expect_pressed, NULL);
    sph2d__over_particles(s, s->fluid.count, keep_found, NULL);
    sph2d__thick_solve(s, true);
    solve(s, load(s, true));
}

/* ---- the step ---------------------------------------------------------------------------------------------------- */

static void press_solved(sph2d__system *s, size_t first, size_t last)
{
    for (size_t i = first; i < last; ++i) {
        press(s->frozen, i, s->frozen->solved[i]);
        sph2d__close_push(s, i, true);
    }
}

static void finish_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    (void)with;
    double left = 0;
    for (size_t i = slab->first; i < slab->last; ++i)
        left += sph2d__close_residual(s, i);
    pass_of(s)->finish(s, slab->first, slab->last, sum);
    sum->first += s->mass * s->frozen->dt / s->frozen->ahead * left;
}

/** Velocities and densities by the pressures that were found. */
static void finish(sph2d_sim *sim)
{
    sph2d__system *s = &sim->system;
    sph2d__record *r = &sim->record;
    sph2d__over_particles(s, s->fluid.count, press_solved, NULL);
    transpose(s);
    const sph2d__slab_sum work = sph2d__over_fluid(s, finish_slab, NULL, NULL, 0);
    sph2d__images_of_velocity(s); /* where they are now */
    r->energy_pressed -= work.first;
    r->energy_viscous -= work.second;
    r->energy_fed -= work.third;
    r->energy_forces += work.fourth;
    s->external = (sph2d_vec2){s->external.x + work.x, s->external.y + work.y};
    if (s->rigid_count > 0) {
        double friction;
        r->energy_pressed -= sph2d__frozen_bodies_kick(s, 1, &friction);
        r->energy_pressed -= sph2d__frozen_bodies_late(s);
        r->energy_viscous -= friction;
    }
}

void sph2d__implicit_sound(sph2d_sim *sim, double dt)
{
    sph2d__system *s = &sim->system;
    bound(s, dt);
    sph2d__over_particles(s, s->fluid.count, relax_some, NULL);
    sph2d__frozen_begin(s);
    sph2d__frozen_start_external(s);
    sph2d__images_of_velocity(s);
    sim->record.energy_fed += sph2d__frozen_store(s);
    const double paid = loosen(sim);
    sph2d__profile_enter(&s->profile, SPH2D_PHASE_SOLVE);
    s->iterations = 0;
    if (s->frozen->thick)
        solve_thick(s);
    else
        solve(s, load(s, false));
    pay(s, paid);
    finish(sim);
    sim->record.energy_pressed -= sph2d__frozen_store(s); /* is not dissipated */
    sim->record.iterations += s->iterations;
    sim->record.unconverged += s->unconverged;
    sim->record.unconverged_row = s->unconverged ? sim->record.unconverged_row + 1 : 0;
}
