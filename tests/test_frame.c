/* SPDX-License-Identifier: MIT */
/** @file test_frame.c
 *  Tanks that move, and gravity that changes: a particle that touches nothing flies a parabola, whatever the tank around
 *  it does, and a tank that moves does work on its liquid. */
#include <math.h>
#include <string.h>

#include "common.h"
#include "scene/derive.h"
#include "scene/frame.h"
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
    double order = log2(coarse / fine), least = _i == 1 ? 1.9 : 0.9;
    if (_i == 0) /* known weakness: it stops at 1.3e-4 m, right is 5e-5 by second order */
        ck_assert_msg(fine < 1.5e-4, "error %g m", fine);
    else
        ck_assert_msg(fine < (_i == 1 ? 5e-5 : 5e-3) && order > least, "errors %g and %g m", coarse, fine);
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

static const sph2d_pose_point late[] = {{0, 0, 0, 0},       {1, 0, 0, 0}, {1.5, 0.1, 0, 0.1},
                                        {2, -0.2, 0, -0.3}, {3, 0, 0, 0}, {4, 0, 0, 0}};
static const sph2d_path_point heavier[] = {{0, 0.3, -2}, {2, 0.3, -2}, {5, 1, -7}, {6, 0.3, -2}};
static const sph2d_swing sway[] = {{.amplitude = {0.02, 0}, .frequency = 0.31}, {.angle = 0.1, .frequency = 0.073}};

/** What moves the tank, or changes gravity, by its number; false beyond the last. */
static bool drive_by(int kind)
{
    start(SPH2D_METHOD_WCSPH);
    scene.motion = sph2d_motion_default();
    scene.motion.ramp = kind == 1 ? 7 : 0;
    if (kind <= 1)
        scene.motion.amplitude = (sph2d_vec2){0.1, 0}, scene.motion.frequency = 0.7;
    else if (kind == 2)
        scene.motion.path = (sph2d_pose_path){late, 6};
    else if (kind == 3)
        scene.gravity_path = (sph2d_path){heavier, 4};
    else if (kind == 4)
        scene.motion.swings = sway, scene.motion.swing_count = 2;
    else
        scene.motion.rate = 0.2;
    return kind <= 5;
}

/** Or a run that is made longer when it is resumed would be another one. */
START_TEST(the_length_of_a_run_does_not_change_its_sound_speed)
{
    for (int kind = 0; drive_by(kind); ++kind) {
        scene.run.until = 100;
        sph2d__derived whole = test_world(&scene)->derived;
        for (double until = 0; until < 50; until = 3 * until + 0.1) {
            scene.run.until = until;
            sph2d__derived part = test_world(&scene)->derived;
            ck_assert_msg(part.sound_speed == whole.sound_speed && part.head == whole.head,
                          "drive %d to %g s: %g of %g", kind, until, part.sound_speed, whole.sound_speed);
        }
    }
}
END_TEST

START_TEST(the_largest_gravity_and_tilt_are_found)
{
    double omega = 2 * TEST_PI * 0.7, g = hypot(0.3, 2);
    drive_by(0);
    scene.gravity = (sph2d_vec2){0, -2};
    sph2d__drive drive = sph2d__scene_drive(&scene);
    double sideways = 0.1 * omega * omega, size = hypot(2, sideways);
    ck_assert_double_eq_tol(drive.gravity, size, 1e-5 * size);
    ck_assert_double_eq_tol(drive.tilt, sideways / size, 1e-5);
    ck_assert_double_eq_tol(drive.speed, 0.1 * omega, 1e-12);
    drive_by(3);
    ck_assert(sph2d__scene_drive(&scene).gravity == hypot(1, 7));
    drive_by(4); /* of two swings that meet seldom */
    drive = sph2d__scene_drive(&scene);
    ck_assert_double_eq_tol(drive.tilt, 0.1 + 0.02 * pow(2 * TEST_PI * 0.31, 2) / g, 0.005);
    drive_by(5);
    ck_assert(sph2d__scene_drive(&scene).tilt == 1);
}
END_TEST

/** A swing with a ramp of one period: the acceleration is largest after the ramp, A omega^2. */
START_TEST(a_swing_is_looked_at_after_its_ramp)
{
    start(SPH2D_METHOD_WCSPH);
    scene.gravity = (sph2d_vec2){0, -2};
    scene.motion = sph2d_motion_default();
    scene.motion.amplitude = (sph2d_vec2){0.1, 0};
    scene.motion.frequency = 0.7;
    scene.motion.ramp = 1 / 0.7;
    const double omega = 2 * TEST_PI * 0.7, sideways = 0.1 * omega * omega, size = hypot(2, sideways);
    sph2d__drive drive = sph2d__scene_drive(&scene);
    ck_assert_double_ge(drive.gravity, size * (1 - 1e-5));
    ck_assert_double_ge(drive.tilt, sideways / size * (1 - 1e-5));
}
END_TEST

/** In no more time than this test has, whatever the ratio of the frequencies. */
START_TEST(the_longest_motions_are_looked_at_briefly)
{
    static sph2d_pose_point way[5000];
    static sph2d_swing swings[100];
    for (int k = 0; k < 5000; ++k)
        way[k] = (sph2d_pose_point){k * 1e6, 0.1 * sin(k), 0, 0};
    for (int k = 0; k < 100; ++k)
        swings[k] = (sph2d_swing){.angle = 1e-4, .frequency = k ? 1e6 * k : 1e-6};
    start(SPH2D_METHOD_WCSPH);
    scene.motion.path = (sph2d_pose_path){way, 5000};
    scene.motion.swings = swings;
    scene.motion.swing_count = 100;
    ck_assert_double_gt(sph2d__scene_drive(&scene).tilt, 1e-3);
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

/** A velocity at t = 0 is that of the liquid, too: said, not refused, and it does not hide a stop as large. */
START_TEST(a_tank_that_moves_already_is_warned_of)
{
    static const sph2d_pose_point way[] = {{0, 0, 0, 0}, {0.5, 0.1, 0, 0}};
    sph2d_report report = {0};
    start(SPH2D_METHOD_WCSPH);
    scene.motion.path = (sph2d_pose_path){way, 2};
    scene.run.until = 0.4;
    ck_assert_int_eq(sph2d_scene_check(&scene, &report), SPH2D_OK);
    ck_assert_ptr_nonnull(strstr(test_report_text(&report), "0.2 m/s at t = 0 already, and its liquid with it"));
    sph2d_report_clear(&report);
    scene.run.until = 0.6;
    ck_assert_int_eq(sph2d_scene_check(&scene, &report), SPH2D_SCENE);
    ck_assert_ptr_nonnull(strstr(report.items[0].message, "jumps by 0.2 m/s at t = 0.5 s"));
    ck_assert_ptr_null(strstr(report.items[0].hint, "use `between: cubic`")); /* which it is */
    ck_assert_ptr_nonnull(strstr(report.items[0].hint, "three equal points"));
    sph2d_report_clear(&report);
    start(SPH2D_METHOD_WCSPH);
    scene.motion = (sph2d_motion){.amplitude = {0.1, 0}, .frequency = 1, .ramp = 1, .center = scene.motion.center};
    ck_assert_int_eq(sph2d_scene_check(&scene, &report), SPH2D_OK);
    ck_assert_ptr_null(strstr(test_report_text(&report), "at t = 0 already"));
    sph2d_report_clear(&report);
}
END_TEST

Suite *suite_frame(void)
{
    Suite *suite = suite_create("frame");
    TCase *tests = tcase_create("frame");
    tcase_add_loop_test(tests, a_particle_flies_on_in_a_tank_that_moves, 0, METHODS);
    tcase_add_loop_test(tests, gravity_follows_its_path, 0, METHODS);
    tcase_add_loop_test(tests, a_run_in_a_moving_tank_goes_on_from_its_state_bit_by_bit, 0, METHODS);
    tcase_add_test(tests, the_length_of_a_run_does_not_change_its_sound_speed);
    tcase_add_test(tests, the_largest_gravity_and_tilt_are_found);
    tcase_add_test(tests, a_swing_is_looked_at_after_its_ramp);
    tcase_add_test(tests, the_longest_motions_are_looked_at_briefly);
    tcase_add_test(tests, a_tank_that_jumps_is_refused);
    tcase_add_test(tests, a_tank_that_moves_already_is_warned_of);
    suite_add_tcase(suite, tests);
    TCase *slow = test_long(suite);
    tcase_add_loop_test(slow, a_tank_that_pitches_balances_energy, 0, METHODS);
    return suite;
}
