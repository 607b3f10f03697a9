/* SPDX-License-Identifier: MIT */
/** @file test_solver_limits.c
 *  Methods `pcisph` and `constraint` where their solvers come to an end: tall columns, iterations that do not suffice,
 *  stiffness at its ends. U = sqrt(g H) with the depth H. */
#include <math.h>
#include <stdlib.h>

#include "sim/simulation.h"
#include "tank.h"

static sph2d_report report;

/* ---- a hundred times as high as wide ----------------------------------------------------------------------------- */

START_TEST(a_tall_column_keeps_its_compression)
{
    const double H = 8;
    tank_empty(both[_i], DX, H / 100, 8.4, 1e-3);
    tank_add(0, 0, H / 100, H);
    tank_start();
    tank_span s = tank_run_until(0.4);
    sph2d_summary sum = sph2d_sim_summary(tank.sim);
    ck_assert_double_le(sum.compression_p99, 0.01);
    ck_assert_double_le(sum.compression_max, 0.08);
    ck_assert_double_lt(s.fastest, 0.6 * sqrt(G * H));
    ck_assert_double_eq_tol(2 * tank_middle() / H, 1, 0.03);
    ck_assert_uint_gt(sum.iterations, sum.steps);
    ck_assert_uint_eq(sum.unconverged, 0);
}
END_TEST

START_TEST(a_tall_column_stops_where_too_few_iterations_are_allowed)
{
    const double H = 8;
    tank_empty(both[_i], DX, H / 100, 8.4, 1e-3);
    tank_add(0, 0, H / 100, H);
    tank.scene.method.max_iterations = 2;
    tank_start();
    sph2d_status status = SPH2D_OK;
    sph2d_report_clear(&report);
    while (status == SPH2D_OK && sph2d_sim_time(tank.sim) < 1)
        status = sph2d_sim_step(tank.sim, &report);
    sph2d_summary s = sph2d_sim_summary(tank.sim);
    ck_assert_int_eq(status, SPH2D_GUARD);
    ck_assert(test_report_has(&report, SPH2D_CODE_NOT_CONVERGED, "method.max_iterations"));
    ck_assert_uint_ge(s.unconverged, 100);
    ck_assert_uint_le(s.iterations, 2 * s.steps);
    ck_assert(tank_is_finite());
    ck_assert_double_lt(s.compression_max, 0.1);
}
END_TEST

/* ---- limits ------------------------------------------------------------------------------------------------------ */

static void dam(sph2d_method method)
{
    tank_empty(method, DX, 1, 1, 1e-3);
    tank_add(0, 0, 0.3, 0.6);
}

START_TEST(limits_that_cannot_be_kept_are_counted)
{
    dam(both[_i]);
    tank.scene.method.max_iterations = both[_i] == SPH2D_METHOD_PCISPH ? 20 : 14;
    if (both[_i] == SPH2D_METHOD_PCISPH)
        tank.scene.method.max_compression = 1e-6;
    else
        tank.scene.method.tolerance = 1e-10; /* it keeps 1e-5, in some 20 iterations */
    tank.scene.method.time_step = both[_i] == SPH2D_METHOD_PCISPH ? 0 : 3e-3;
    tank_start();
    test_steps(tank.sim, 99);
    sph2d_summary s = sph2d_sim_summary(tank.sim);
    ck_assert_uint_ge(s.unconverged, 95);
    ck_assert_uint_le(s.iterations, 20 * s.steps);
    ck_assert(tank_is_finite());
    /* A step ends as far beyond the middle, where pressure acts, as it began before it. */
    ck_assert_double_lt(s.compression_max, both[_i] == SPH2D_METHOD_PCISPH ? 0.03 : 0.1);
    ck_assert_double_eq_tol((s.kinetic + s.potential) / s.energy_start, 1, 0.05);
}
END_TEST

START_TEST(a_solver_that_has_time_keeps_a_narrow_tolerance)
{
    dam(SPH2D_METHOD_CONSTRAINT);
    tank.scene.method.tolerance = 1e-10;
    tank_start();
    tank_run_until(0.4);
    sph2d_summary s = sph2d_sim_summary(tank.sim);
    ck_assert_uint_eq(s.unconverged, 0);
    ck_assert_uint_gt(s.iterations, 10 * s.steps);
    ck_assert_uint_lt(s.iterations, 100 * s.steps);
}
END_TEST

START_TEST(a_soft_liquid_collapses_without_harm)
{
    dam(SPH2D_METHOD_PCISPH);
    tank.scene.method.sound_speed = 0.1;
    tank_start();
    tank_span s = tank_run_until(0.5);
    sph2d_summary sum = sph2d_sim_summary(tank.sim);
    ck_assert(tank_is_finite());
    ck_assert_uint_eq(sum.particles, 450);
    ck_assert_double_gt(sum.compression_max, 5);
    ck_assert_double_le(s.fastest, 1.05 * sqrt(2 * G * 0.6)); /* it falls, and nothing throws it */
}
END_TEST

/* Let go at rest density, a column sinks by its compliance, in the mean by g H^2/(3 c0^2), whatever its step. wcsph 1.03,
 * constraint 1.24: what diffuses pays for no more of the relaxation. */
START_TEST(a_stiff_lattice_settles_by_its_compliance)
{
    const double H = 0.4, c0 = 1000, exact = G * H * H / (3 * c0 * c0);
    tank_empty(SPH2D_METHOD_CONSTRAINT, DX, 0.2, 0.5, 100);
    tank.scene.boundary.left = tank.scene.boundary.right = SPH2D_SIDE_PERIODIC;
    tank.scene.method.sound_speed = c0;
    tank.scene.method.tolerance = 1e-8;
    tank_add(0, 0, 0.2, H);
    tank_start();
    const double before = tank_middle();
    tank_run_until(0.3);
    ck_assert_double_eq_tol((before - tank_middle()) / exact, 1, 0.3);
}
END_TEST

/* What stands behind the last row of a store can be anything, also no number: arrays change their places as particles are
 * sorted, and drains leave what was there. It must reach no sum. */
START_TEST(rows_behind_the_last_count_as_nothing)
{
    sph2d_scene scene = test_scene(0.1, 0, 0, 1, 1);
    scene.method = sph2d_scene_default().method;
    scene.method.name = SPH2D_METHOD_CONSTRAINT;
    scene.gravity.y = -9.81;
    sph2d_block block = test_block(0, 0, 0.5, 0.7); /* 35 particles: 3 of the last 8 rows */
    scene.blocks = &block;
    scene.block_count = 1;
    sph2d_sim *clean = test_create(&scene, NULL), *soiled = test_create(&scene, NULL);
    sph2d__store *f = &soiled->system.fluid;
    for (int n = 0; n < 30; ++n) {
        double *arrays[] = {f->x, f->vy, f->ax, f->ay, f->next_x, f->log_density, f->stored, f->density};
        for (size_t k = 0; k < sizeof arrays / sizeof *arrays; ++k)
            for (size_t i = f->count; arrays[k] && i < f->count + 8; ++i)
                arrays[k][i] = NAN;
        test_steps(clean, 1);
        test_steps(soiled, 1);
        ck_assert_uint_eq(soiled->system.iterations, clean->system.iterations);
    }
    ck_assert_uint_gt(sph2d_sim_summary(clean).iterations, 0);
    ck_assert_mem_eq(f->vy, clean->system.fluid.vy, f->count * sizeof(double));
    sph2d_sim_destroy(clean);
    sph2d_sim_destroy(soiled);
}
END_TEST

Suite *suite_solver_limits(void)
{
    Suite *suite = suite_create("solver_limits");
    TCase *cases = tcase_create("limits of the solvers");
    tcase_add_checked_fixture(cases, NULL, tank_finish);
    tcase_add_loop_test(cases, limits_that_cannot_be_kept_are_counted, 0, 2);
    tcase_add_test(cases, a_solver_that_has_time_keeps_a_narrow_tolerance);
    tcase_add_test(cases, rows_behind_the_last_count_as_nothing);
    suite_add_tcase(suite, cases);
    TCase *slow = test_long(suite);
    tcase_add_checked_fixture(slow, NULL, tank_finish);
    tcase_add_loop_test(slow, a_tall_column_keeps_its_compression, 0, 2);
    tcase_add_loop_test(slow, a_tall_column_stops_where_too_few_iterations_are_allowed, 0, 2);
    tcase_add_test(slow, a_soft_liquid_collapses_without_harm);
    tcase_add_test(slow, a_stiff_lattice_settles_by_its_compliance);
    return suite;
}
