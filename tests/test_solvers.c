/* SPDX-License-Identifier: MIT */
/** @file test_solvers.c
 *  What the solvers of methods `pcisph` and `constraint` promise: compression, momentum, an end, the same bits. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "kernels/kernel.h"
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
    column(SPH2D_METHOD_PCISPH, 0, 0);
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
    /* A loose block falls beside a slope; all its energy at every step. */
    static const sph2d_vec2 slope[2] = {{0.3, 0}, {0.9, 0.35}};
    column(both[_i], 0, 0);
    tank.blocks[0] = test_block(0.1, 0.1, 0.5, 0.5);
    tank.blocks[0].perturb.amplitude = 0.3;
    tank.blocks[0].velocity = (sph2d_vec2){1, 0};
    tank.obstacle = sph2d_obstacle_default();
    tank.obstacle.shape.kind = SPH2D_SHAPE_LINE;
    tank.obstacle.shape.points = (sph2d_points){slope, 2};
    tank.scene.obstacles = &tank.obstacle;
    tank.scene.obstacle_count = 1;
    tank_start();
    sph2d_summary s = sph2d_sim_summary(tank.sim);
    double low = s.kinetic + s.potential + s.elastic, scale = low;
    while (sph2d_sim_time(tank.sim) < 1) {
        test_steps(tank.sim, 1);
        s = sph2d_sim_summary(tank.sim);
        low = fmin(low, s.kinetic + s.potential + s.elastic);
        ck_assert_double_le(s.kinetic + s.potential + s.elastic, low + 1e-3 * scale);
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
    /* The first is along what a solve starts from, which is no solution for close pairs. */
    const uint64_t each = both[_i] == SPH2D_METHOD_CONSTRAINT ? 2 : 1;
    tank.scene.method.max_iterations = each;
    tank_start();
    sph2d_report report = {0};
    uint64_t steps = 0;
    while (steps < 300 && sph2d_sim_step(tank.sim, &report) == SPH2D_OK)
        ++steps;
    sph2d_summary s = sph2d_sim_summary(tank.sim);
    ck_assert_uint_ge(steps, 99);
    ck_assert_uint_lt(steps, 150);
    ck_assert_uint_eq(s.iterations, each * s.steps);
    ck_assert_uint_ge(s.unconverged, 100);
    ck_assert(isfinite(s.kinetic));
    ck_assert(test_report_has(&report, SPH2D_CODE_NOT_CONVERGED, "method.max_iterations"));
    ck_assert_ptr_nonnull(
        strstr(test_report_text(&report), "the tolerance is 1e-05" /* which is the least of constraint */));
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
    tcase_add_test(cases, pressure_makes_no_energy);
    tcase_add_loop_test(cases, momentum_is_kept, 0, 2);
    tcase_add_loop_test(cases, compression_stays_where_it_is_wanted, 0, 2);
    tcase_add_loop_test(cases, too_few_iterations_are_counted_and_stop_a_run_in_the_end, 0, 2);
    tcase_add_loop_test(cases, threads_do_not_matter, 0, 2);
    tcase_add_loop_test(cases, a_state_goes_on_as_if_nothing_was, 0, 2);
    suite_add_tcase(suite, cases);
    TCase *slow = test_long(suite);
    tcase_add_checked_fixture(slow, NULL, tank_finish);
    tcase_add_loop_test(slow, energy_never_rises_where_walls_stand, 0, 2);
    tcase_add_loop_test(slow, instruction_sets_do_not_matter, 0, 2);
    return suite;
}
