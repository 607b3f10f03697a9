/* SPDX-License-Identifier: MIT */
/** @file test_solvers.c
 *  What the solvers of methods `pcisph` and `constraint` promise: compression, momentum, an end, the same bits. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "kernels/kernel.h"
#include "methods/projection/local_correction.h"
#include "sim/simulation.h"
#include "simd/lanes.h"
#include "tank.h"

static const double RHO0 = 1000;
/* Instruction sets at most. */
enum { ISAS = SPH2D_ISA_AVX512 - SPH2D_ISA_BASELINE + 1 };

/** A column on the ground of a box of 1 m. */
static void column(sph2d_method method, double width, double height)
{
    tank_empty(method, DX, 1, 1, 0.5);
    tank_add(0, 0, width, height);
}

/** A simulation of the tank's scene of its own. */
static sph2d_sim *another(int threads, sph2d_isa isa)
{
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = threads;
    options.isa = isa;
    return test_create(&tank.scene, &options);
}

/* ---- compression ------------------------------------------------------------------------------------------------- */

START_TEST(momentum_is_kept)
{
    column(both[_i], 0, 0);
    tank.scene.boundary = (sph2d_boundary){SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN};
    tank.scene.gravity.y = 0;
    tank.scene.method.sound_speed = 10;
    tank.blocks[0] = test_block(0.3, 0.3, 0.5, 0.7);
    tank_add(0.5, 0.4, 0.7, 0.6);
    tank.blocks[0].perturb.amplitude = 0.3;
    tank.blocks[0].velocity = (sph2d_vec2){1, 0};
    tank.blocks[1].velocity = (sph2d_vec2){-2, 0}; /* of half as many */
    tank_start();
    test_steps(tank.sim, 20);
    sph2d_summary s = sph2d_sim_summary(tank.sim);
    ck_assert_double_gt(s.kinetic, 1e-3); /* it was not at rest density everywhere */
    double size = sqrt(2 * s.kinetic * (double)s.particles * tank.sim->system.mass);
    ck_assert_double_le(hypot(s.momentum[0], s.momentum[1]), 1e-12 * size);
}
END_TEST

START_TEST(pressure_makes_no_energy)
{
    /* Liquid that starts in too little room takes its room without ever moving by itself. */
    column(both[_i], 0, 0);
    tank.scene.boundary = (sph2d_boundary){SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN};
    tank.scene.gravity.y = 0;
    tank.scene.method.sound_speed = 10;
    tank.blocks[0] = test_block(0.4, 0.4, 0.6, 0.6);
    tank.blocks[0].spacing = 0.9 * DX;
    tank_start();
    ck_assert_double_ge(sph2d_sim_summary(tank.sim).compression_max, 0.2);
    test_steps(tank.sim, 50);
    sph2d_view f = sph2d_sim_fluid(tank.sim);
    double size = 0, most = 0;
    for (size_t i = 0; i < f.count; ++i) {
        size = fmax(size, fabs(f.x[i] - 0.5));
        most = fmax(most, f.density[i] / RHO0 - 1);
    }
    ck_assert_double_ge(size, 0.101); /* the outermost were less than 0.1 from the middle */
    ck_assert_double_le(most, 0.03);
    ck_assert_double_le(sph2d_sim_summary(tank.sim).speed_max, 1e-9);
}
END_TEST

START_TEST(energy_never_rises_where_walls_stand)
{
    /* A loose block falls beside a slope; kinetic and potential energy at every step. */
    static const sph2d_vec2 slope[2] = {{0.3, 0}, {0.9, 0.35}};
    column(both[_i], 0, 0);
    tank.blocks[0] = test_block(0.1, 0.1, 0.5, 0.5);
    tank.blocks[0].perturb.amplitude = 0.3;
    tank.blocks[0].velocity = (sph2d_vec2){1, 0};
    tank.obstacle = sph2d_obstacle_default();
    tank.obstacle.outline.kind = SPH2D_OUTLINE_LINE;
    tank.obstacle.outline.line = (sph2d_points){slope, 2};
    tank.scene.obstacles = &tank.obstacle;
    tank.scene.obstacle_count = 1;
    tank_start();
    sph2d_summary s = sph2d_sim_summary(tank.sim);
    double low = s.kinetic + s.potential, scale = low;
    while (sph2d_sim_time(tank.sim) < 1) {
        test_steps(tank.sim, 1);
        s = sph2d_sim_summary(tank.sim);
        low = fmin(low, s.kinetic + s.potential);
        ck_assert_double_le(s.kinetic + s.potential, low + 1e-3 * scale);
    }
    ck_assert_uint_eq(s.particles, tank.sim->plan.fluid_particles);
}
END_TEST

START_TEST(compression_stays_where_it_is_wanted)
{
    column(both[_i], 0.3, 0.6);
    tank.scene.method.max_compression = 0.01;
    tank.scene.method.support_ratio = 2.4;
    tank_start();
    while (sph2d_sim_time(tank.sim) < 0.15)
        test_steps(tank.sim, 1);
    sph2d_summary s = sph2d_sim_summary(tank.sim);
    ck_assert_double_le(s.compression_p99, 0.01);
    ck_assert_uint_gt(s.iterations, s.steps);
    ck_assert_uint_eq(s.unconverged, 0);
    ck_assert_double_eq_tol((s.kinetic + s.potential) / s.energy_start, 1, 0.02);
    ck_assert_double_gt(s.speed_max, 1);
    ck_assert_uint_eq(s.particles, 15 * 30);
}
END_TEST

START_TEST(too_few_iterations_are_counted_and_stop_a_run_in_the_end)
{
    column(both[_i], 0.3, 0.6);
    tank.scene.method.max_compression = 1e-5;
    tank.scene.method.tolerance = both[_i] == SPH2D_METHOD_CONSTRAINT ? 1e-12 : 0;
    tank.scene.method.max_iterations = 1;
    tank_start();
    sph2d_report report = {0};
    uint64_t steps = 0;
    while (steps < 300 && sph2d_sim_step(tank.sim, &report) == SPH2D_OK)
        ++steps;
    sph2d_summary s = sph2d_sim_summary(tank.sim);
    ck_assert_uint_ge(steps, 99);
    ck_assert_uint_lt(steps, 150);
    ck_assert_uint_eq(s.iterations, s.steps);
    ck_assert_uint_ge(s.unconverged, 100);
    ck_assert(isfinite(s.kinetic));
    ck_assert(test_report_has(&report, SPH2D_CODE_NOT_CONVERGED, "method.max_iterations"));
    ck_assert_ptr_nonnull(
        strstr(test_report_text(&report), _i == 0 ? "the tolerance is 1e-05" : "the tolerance is 1e-12"));
}
END_TEST

/* ---- rows that the linear system leaves compressed --------------------------------------------------------------- */

/** One of the instruction sets: what is corrected one by one reads pairs that loops of their width have laid. */
static sph2d_isa isa_of(int index)
{
    return (sph2d_isa)(SPH2D_ISA_BASELINE + index);
}

/** Particles in a periodic box that pass close by each other in a step of 2 ms, with nothing solved for. NULL where the
 *  processor has not this instruction set. */
static sph2d__system *passing(sph2d_isa isa)
{
    if (!sph2d_isa_available(isa))
        return NULL;
    tank_empty(SPH2D_METHOD_CONSTRAINT, DX, 16 * DX, 16 * DX, 0);
    tank.scene.boundary =
        (sph2d_boundary){SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC};
    tank.scene.gravity.y = 0;
    tank.scene.method.sound_speed = 10;
    tank_add(0, 0, 16 * DX, 16 * DX);
    tank.sim = another(1, isa);
    sph2d__system *s = &tank.sim->system;
    uint64_t random = 11;
    s->step = 2e-3;
    for (size_t i = 0; i < s->fluid.count; ++i) {
        s->fluid.vx[i] = test_random(&random, -2, 2);
        s->fluid.vy[i] = test_random(&random, -2, 2);
        s->fluid.multiplier[i] = s->fluid.acting_pressure[i] = s->fluid.ax[i] = s->fluid.ay[i] = 0;
        s->fluid.diagonal[i] = 1 / s->fluid.diagonal[i];
    }
    return s;
}

/** The largest compression when all have gone a step, all particles with each other. */
static double largest_ahead(const sph2d__system *s)
{
    const sph2d__store *f = &s->fluid;
    double most = 0, dt = s->step, h = s->support, side = 16 * DX;
    for (size_t i = 0; i < f->count; ++i) {
        double sum = 0;
        for (size_t j = 0; j < f->count; ++j) {
            double dx = f->x[i] - f->x[j] + dt * (f->vx[i] - f->vx[j] + dt * (f->ax[i] - f->ax[j]));
            double dy = f->y[i] - f->y[j] + dt * (f->vy[i] - f->vy[j] + dt * (f->ay[i] - f->ay[j]));
            double q = hypot(remainder(dx, side), remainder(dy, side)) / h;
            sum += sph2d__kernel_value_at(s->method.kernel, q);
        }
        double density = s->calibration * s->mass * sph2d__kernel_constant(s->method.kernel) / (h * h) * sum;
        most = fmax(most, density / RHO0 - 1);
    }
    return most;
}

START_TEST(stragglers_are_brought_back)
{
    sph2d__system *s = passing(isa_of(_i));
    if (!s)
        return;
    ck_assert_double_gt(largest_ahead(s), 0.2);
    for (int k = 0; k < 2; ++k)
        sph2d__stragglers_correct(s, 0.05, 0);
    ck_assert_double_le(largest_ahead(s), 0.06); /* pairs that the step begins too far apart for are not looked for */
}
END_TEST

/* With a share that explains all of it nothing is done; nor where nothing is compressed as much. */
START_TEST(what_pressure_explains_stays)
{
    sph2d__system *s = passing(isa_of(_i));
    if (!s)
        return;
    for (size_t i = 0; i < s->fluid.count; ++i)
        s->fluid.multiplier[i] = 1;
    sph2d__stragglers_correct(s, 0.05, 1);
    sph2d__stragglers_correct(s, 1, 0);
    for (size_t i = 0; i < s->fluid.count; ++i) {
        ck_assert_double_eq(s->fluid.multiplier[i], 1);
        ck_assert_double_eq(s->fluid.ax[i], 0);
    }
}
END_TEST

/* What corrections push is D' of what they add to the multipliers, and has no momentum. */
START_TEST(corrections_push_like_multipliers)
{
    sph2d__system *s = passing(isa_of(_i));
    if (!s)
        return;
    sph2d__store *f = &s->fluid;
    double dt2 = s->step * s->step, x = 0, y = 0, most = 0;
    sph2d__stragglers_correct(s, 0.05, 0);
    for (size_t i = 0; i < f->count; ++i) {
        ck_assert_double_ge(f->multiplier[i], 0);
        ck_assert_double_le(f->acting_pressure[i], 0); /* none is raised above the largest */
        f->direction[i] = sph2d__splat(f->multiplier[i]);
        most = fmax(most, hypot(f->ax[i], f->ay[i]));
        x += f->ax[i];
        y += f->ay[i];
    }
    ck_assert_double_gt(most, 100);
    ck_assert_double_le(hypot(x, y), 1e-12 * most * (double)f->count);
    sph2d__projection_apply_transpose(s);
    for (size_t i = 0; i < f->count; ++i) {
        float push[2];
        memcpy(push, &f->push[i], sizeof push);
        ck_assert_double_eq_tol(f->ax[i], -push[0] / dt2, 1e-5 * most);
        ck_assert_double_eq_tol(f->ay[i], -push[1] / dt2, 1e-5 * most);
    }
}
END_TEST

/* A pressure is that of its multiplier, up to the largest that there was. */
START_TEST(corrections_raise_pressures)
{
    sph2d__system *s = passing(SPH2D_ISA_AUTO);
    sph2d__store *f = &s->fluid;
    const double share = s->moment * RHO0 / (s->step * s->step);
    f->acting_pressure[0] = 1e12;
    sph2d__stragglers_correct(s, 0.05, 0);
    double most = 0;
    for (size_t i = 1; i < f->count; ++i) {
        ck_assert_double_eq_tol(f->acting_pressure[i], share * f->multiplier[i], 1e-9 * share);
        most = fmax(most, f->multiplier[i]);
    }
    ck_assert_double_gt(most, 1e-6);
}
END_TEST

/* Liquid at rest that a wall will come nearer to by a third of a spacing is pushed ahead of it, and one that a wall
 * will leave is let be. */
START_TEST(walls_that_come_push_stragglers)
{
    bool up = _i / 2, comes = _i % 2 == 0;
    column(SPH2D_METHOD_CONSTRAINT, 0.3, 0.3);
    tank.scene.method.sound_speed = 10;
    tank_start();
    sph2d__system *s = &tank.sim->system;
    sph2d__store *f = &s->fluid, *w = &s->walls;
    s->step = 1e-3;
    for (size_t i = 0; i < f->count; ++i) {
        f->vx[i] = f->vy[i] = f->ax[i] = f->ay[i] = f->multiplier[i] = f->acting_pressure[i] = 0;
        f->diagonal[i] = 1 / f->diagonal[i];
    }
    for (size_t b = 0; b < w->count; ++b)
        (up ? w->vy : w->vx)[b] = (comes ? 1 : -1) * 0.33 * DX / s->step;
    sph2d__stragglers_correct(s, 0.05, 0);
    double ahead = 0, any = 0;
    for (size_t i = 0; i < f->count; ++i) {
        ahead = fmax(ahead, up ? f->ay[i] : f->ax[i]);
        any = fmax(any, hypot(f->ax[i], f->ay[i]));
    }
    if (comes)
        ck_assert_double_gt(ahead * s->step * s->step, 0.01 * DX);
    else
        ck_assert_double_eq(any, 0);
}
END_TEST

/* A column that falls together at large steps: the largest of all compressions. */
START_TEST(the_largest_compression_is_bounded)
{
    tank_empty(SPH2D_METHOD_CONSTRAINT, DX, 2, 2, 0.001);
    tank_add(0, 0, 0.5, 1);
    tank.scene.method.support_ratio = 2;
    tank.scene.method.max_compression = 0.005;
    tank.scene.method.cfl = 0.3;
    tank_start();
    while (sph2d_sim_time(tank.sim) < 0.2)
        test_steps(tank.sim, 1);
    sph2d_summary s = sph2d_sim_summary(tank.sim);
    ck_assert_double_gt(s.speed_max, 2);
    ck_assert_double_le(s.compression_max, 0.015);
}
END_TEST

/* ---- the same bits ----------------------------------------------------------------------------------------------- */

static void same_bits(const sph2d_sim *a, const sph2d_sim *b)
{
    const sph2d__store *f = &a->system.fluid, *g = &b->system.fluid;
    ck_assert_uint_eq(f->count, g->count);
    ck_assert_int_eq(memcmp(f->x, g->x, f->count * sizeof *f->x), 0);
    ck_assert_int_eq(memcmp(f->y, g->y, f->count * sizeof *f->y), 0);
    ck_assert_int_eq(memcmp(f->vx, g->vx, f->count * sizeof *f->vx), 0);
    ck_assert_int_eq(memcmp(f->pressure, g->pressure, f->count * sizeof *f->pressure), 0);
}

/** A disturbed square of 50 by 50, stiff enough that not all of it is right at once. */
static void disturbed(sph2d_method method)
{
    column(method, 1, 1);
    tank.blocks[0].perturb.amplitude = 0.2;
    tank.scene.method.max_iterations = 30;
}

START_TEST(threads_do_not_matter)
{
    disturbed(both[_i]);
    tank_start();
    sph2d_sim *other = another(3, SPH2D_ISA_AUTO);
    ck_assert_uint_ge(tank.sim->system.fluid.count, 2400);
    test_steps(tank.sim, 20);
    test_steps(other, 20);
    same_bits(tank.sim, other);
    sph2d_sim_destroy(other);
}
END_TEST

/* Every lane is a particle, and sums over rows have the same strands at any width. */
START_TEST(instruction_sets_do_not_matter)
{
    disturbed(both[_i]);
    tank_start();
    test_steps(tank.sim, 20);
    for (int isa = SPH2D_ISA_BASELINE; isa <= SPH2D_ISA_AVX512; ++isa) {
        if (!sph2d_isa_available((sph2d_isa)isa))
            continue;
        sph2d_sim *other = another(1, (sph2d_isa)isa);
        test_steps(other, 20);
        same_bits(tank.sim, other);
        sph2d_sim_destroy(other);
    }
}
END_TEST

START_TEST(a_state_goes_on_as_if_nothing_was)
{
    column(both[_i], 0.3, 0.6);
    tank_start();
    test_steps(tank.sim, 30);
    test_state state = test_state_copy(tank.sim);
    sph2d_sim *other = NULL;
    ck_assert_int_eq(sph2d_sim_restore(&tank.scene, NULL, &state.state, &other, NULL), SPH2D_OK);
    test_steps(tank.sim, 20);
    test_steps(other, 20);
    same_bits(tank.sim, other);
    sph2d_sim_destroy(other);
    test_state_free(&state);
}
END_TEST

Suite *suite_solvers(void)
{
    Suite *suite = suite_create("solvers");
    TCase *cases = tcase_create("solvers");
    tcase_add_checked_fixture(cases, NULL, tank_finish);
    tcase_add_loop_test(cases, pressure_makes_no_energy, 0, 2);
    tcase_add_loop_test(cases, energy_never_rises_where_walls_stand, 0, 2);
    tcase_add_loop_test(cases, momentum_is_kept, 0, 2);
    tcase_add_loop_test(cases, compression_stays_where_it_is_wanted, 0, 2);
    tcase_add_loop_test(cases, too_few_iterations_are_counted_and_stop_a_run_in_the_end, 0, 2);
    tcase_add_loop_test(cases, stragglers_are_brought_back, 0, ISAS);
    tcase_add_loop_test(cases, what_pressure_explains_stays, 0, ISAS);
    tcase_add_loop_test(cases, corrections_push_like_multipliers, 0, ISAS);
    tcase_add_test(cases, corrections_raise_pressures);
    tcase_add_loop_test(cases, walls_that_come_push_stragglers, 0, 4);
    tcase_add_test(cases, the_largest_compression_is_bounded);
    tcase_add_loop_test(cases, threads_do_not_matter, 0, 2);
    tcase_add_loop_test(cases, instruction_sets_do_not_matter, 0, 2);
    tcase_add_loop_test(cases, a_state_goes_on_as_if_nothing_was, 0, 2);
    suite_add_tcase(suite, cases);
    return suite;
}
