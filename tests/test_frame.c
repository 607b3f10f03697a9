/* SPDX-License-Identifier: MIT */
/** @file test_frame.c
 *  Tanks that move, and gravity that changes: a particle that touches nothing flies a parabola, whatever the tank around
 *  it does, and a tank that moves does work on its liquid. */
#include <math.h>
#include <string.h>

#include "common.h"
#include "sim/simulation.h"

static const sph2d_method methods[] = {SPH2D_METHOD_WCSPH, SPH2D_METHOD_MULLER, SPH2D_METHOD_PCISPH,
                                       SPH2D_METHOD_CONSTRAINT};
enum { METHODS = sizeof methods / sizeof *methods };

static sph2d_scene scene;
static sph2d_block block;

/** A particle at rest in a tank that is shifted, swung and turned about a point beside its centre. */
static void start(sph2d_method method)
{
    scene = test_scene(0.02, -2, -2, 2, 2);
    scene.boundary = (sph2d_boundary){SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN};
    scene.method = sph2d_scene_default().method;
    scene.method.name = method;
    scene.gravity = (sph2d_vec2){0.3, -2};
    block = test_particle(0.02, 0.5, 0.4, 0, 0);
    scene.blocks = &block;
    scene.block_count = 1;
    scene.run.until = 1;
}

static sph2d_vec2 position(const sph2d_sim *sim)
{
    sph2d_view f = sph2d_sim_fluid(sim);
    ck_assert_uint_eq(f.count, 1);
    return (sph2d_vec2){f.x[0], f.y[0]};
}

/** Where a particle is in the world, less where it would be by its start and gravity alone, after about 0.8 s [m]. */
static double error_of_flight(double time_step)
{
    static const sph2d_pose_point way[] = {
        {0, 0, 0, 0}, {0.2, 0.05, 0, 0.1}, {0.5, 0.3, 0.2, 0.2}, {0.8, 0.1, 0.3, -0.2}, {1.2, 0, 0, 0}};
    scene.method.time_step = time_step;
    scene.motion.path = (sph2d_pose_path){way, 5};
    scene.motion.rate = 1.5;
    scene.motion.amplitude = (sph2d_vec2){0.1, -0.2};
    scene.motion.angle = 0.3;
    scene.motion.frequency = 0.7;
    scene.motion.center = (sph2d_vec2){0.2, -0.3};
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d__pose pose = sph2d__course_at(&sim->tank, 0);
    sph2d_vec2 from = sph2d__pose_apply(&pose, position(sim)), v = sph2d__pose_velocity(&pose, from);
    while (sph2d_sim_time(sim) < 0.8 - time_step / 2)
        test_steps(sim, 1);
    double t = sph2d_sim_time(sim);
    pose = sph2d__course_at(&sim->tank, t);
    sph2d_vec2 p = sph2d__pose_apply(&pose, position(sim));
    double error = hypot(p.x - (from.x + t * v.x + t * t / 2 * scene.gravity.x),
                         p.y - (from.y + t * v.y + t * t / 2 * scene.gravity.y));
    sph2d_sim_destroy(sim);
    return error;
}

START_TEST(a_particle_flies_on_in_a_tank_that_moves)
{
    start(methods[_i]);
    double coarse = error_of_flight(2e-3), fine = error_of_flight(1e-3);
    /* it goes 1.5 m; the projected methods evaluate forces once for a step */
    double order = log2(coarse / fine), least = _i < 2 ? 1.9 : 0.9;
    ck_assert_msg(fine < (_i < 2 ? 5e-5 : 5e-3) && order > least, "errors %g and %g m", coarse, fine);
}
END_TEST

/** Gravity that grows from nothing to (0, -3) in half a second, and is constant then. */
START_TEST(gravity_follows_its_path)
{
    static const sph2d_path_point path[] = {{0, 0, 0}, {0.5, 0, -3}};
    start(methods[_i]);
    scene.gravity_path = (sph2d_path){path, 2};
    scene.method.time_step = 1e-3;
    sph2d_sim *sim = test_create(&scene, NULL);
    double y0 = position(sim).y;
    while (sph2d_sim_time(sim) < 0.8 - 5e-4)
        test_steps(sim, 1);
    double late = sph2d_sim_time(sim) - 0.5;
    double expected = -3 * 0.25 / 6 - 0.75 * late - 1.5 * late * late;
    ck_assert_double_eq_tol(position(sim).y - y0, expected, _i < 2 ? 1e-5 : 2e-3);
    ck_assert_double_eq_tol(position(sim).x, 0.5, 1e-12);
    sph2d_sim_destroy(sim);
}
END_TEST

/** What the tank gives to its liquid is in the balance of energy, and turning alone, of liquid that rests in it, gives
 *  nothing but the rise against the centre. */
START_TEST(a_tank_that_pitches_balances_energy)
{
    scene = test_scene(0.025, 0, 0, 1, 0.6);
    scene.method = sph2d_scene_default().method;
    scene.method.name = methods[_i];
    scene.gravity = (sph2d_vec2){0, -9.81};
    block = test_block(0, 0, 1, 0.25);
    scene.blocks = &block;
    scene.block_count = 1;
    scene.motion = sph2d_motion_default();
    scene.motion.angle = 0.06;
    scene.motion.frequency = 0.6;
    scene.motion.ramp = 1;
    scene.run.until = 2;
    sph2d_sim *sim = test_create(&scene, NULL);
    double scale = sph2d__sim_energy_scale(sim);
    while (sph2d_sim_time(sim) < 2)
        test_steps(sim, 1);
    sph2d_summary s = sph2d_sim_summary(sim);
    ck_assert_double_gt(s.energy_forces, 0.005 * scale);
    ck_assert_msg(fabs(s.energy_error) < (_i == 1 ? 0.05 : 0.02) * scale, "%g of %g", s.energy_error, scale);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(a_run_in_a_moving_tank_goes_on_from_its_state_bit_by_bit)
{
    start(methods[_i]);
    block = test_block(0, 0, 0.3, 0.2);
    scene.motion.rate = 1;
    scene.motion.amplitude = (sph2d_vec2){0.1, 0};
    scene.motion.frequency = 1;
    sph2d_sim *sim = test_create(&scene, NULL), *back = NULL;
    test_steps(sim, 30);
    test_state state = test_state_copy(sim);
    ck_assert_int_eq(sph2d_sim_restore(&scene, NULL, &state.state, &back, NULL), SPH2D_OK);
    test_steps(sim, 30);
    test_steps(back, 30);
    sph2d_view a = sph2d_sim_fluid(sim), b = sph2d_sim_fluid(back);
    ck_assert_uint_eq(a.count, b.count);
    ck_assert_mem_eq(a.x, b.x, a.count * sizeof *a.x);
    ck_assert_mem_eq(a.vy, b.vy, a.count * sizeof *a.vy);
    test_state_free(&state);
    sph2d_sim_destroy(sim);
    sph2d_sim_destroy(back);
}
END_TEST

START_TEST(a_tank_that_jumps_is_refused)
{
    static const sph2d_pose_point way[] = {{0, 0, 0, 0}, {0.3, 0.1, 0, 0}, {0.6, 0, 0, 0}};
    static const sph2d_path_point back[] = {{0, 0, 0}, {0, 0, -3}};
    sph2d_report report = {0};
    start(SPH2D_METHOD_WCSPH);
    scene.motion.path = (sph2d_pose_path){way, 3};
    scene.motion.between = SPH2D_BETWEEN_LINES;
    ck_assert_int_eq(sph2d_scene_check(&scene, &report), SPH2D_SCENE);
    ck_assert_str_eq(report.items[0].path, "motion.path");
    sph2d_report_clear(&report);
    start(SPH2D_METHOD_WCSPH);
    scene.gravity_path = (sph2d_path){back, 2};
    ck_assert_int_eq(sph2d_scene_check(&scene, &report), SPH2D_SCENE);
    ck_assert_str_eq(report.items[0].path, "gravity_path");
    sph2d_report_clear(&report);
}
END_TEST

Suite *suite_frame(void)
{
    Suite *suite = suite_create("frame");
    TCase *tests = tcase_create("frame");
    tcase_add_loop_test(tests, a_particle_flies_on_in_a_tank_that_moves, 0, METHODS);
    tcase_add_loop_test(tests, gravity_follows_its_path, 0, METHODS);
    tcase_add_loop_test(tests, a_tank_that_pitches_balances_energy, 0, METHODS);
    tcase_add_loop_test(tests, a_run_in_a_moving_tank_goes_on_from_its_state_bit_by_bit, 0, METHODS);
    tcase_add_test(tests, a_tank_that_jumps_is_refused);
    suite_add_tcase(suite, tests);
    return suite;
}
