/* SPDX-License-Identifier: MIT */
/** @file test_pose.c
 *  Motions (boundary/pose.h) and obstacles that follow them (boundary/moving.h): rates against differences of places,
 *  places against each other, and a sweep against one where the wall rests. */
#include <math.h>

#include "boundary/moving.h"
#include "common.h"

static sph2d_path_point points[] = {{.t = 0.5, .x = 0, .y = 0}, {.t = 1.5, .x = 2, .y = -1}, {.t = 2, .x = 2, .y = 3}};

static sph2d_motion swing(void)
{
    return (sph2d_motion){.amplitude = {0.3, -0.2}, .frequency = 0.7, .phase = 0.4};
}

START_TEST(rests_where_the_scene_places_it_at_the_start)
{
    sph2d_motion motion = swing();
    sph2d__pose pose = sph2d__pose_at(&motion, 0);
    ck_assert_double_eq_tol(pose.displacement.x, 0, 1e-15);
    ck_assert_double_eq_tol(pose.displacement.y, 0, 1e-15);
    ck_assert(sph2d__motion_moves(&motion));
    motion.frequency = 0;
    ck_assert(!sph2d__motion_moves(&motion));
}
END_TEST

START_TEST(rates_are_slopes_of_places)
{
    sph2d_motion motion = swing();
    motion.path = (sph2d_path){points, 3};
    const double h = 1e-5;
    for (double t = 0.1; t < 2.5; t += 0.17) {
        sph2d__pose a = sph2d__pose_at(&motion, t - h), pose = sph2d__pose_at(&motion, t);
        sph2d__pose b = sph2d__pose_at(&motion, t + h);
        ck_assert_double_eq_tol(pose.velocity.x, (b.displacement.x - a.displacement.x) / (2 * h), 1e-8);
        ck_assert_double_eq_tol(pose.velocity.y, (b.displacement.y - a.displacement.y) / (2 * h), 1e-8);
        ck_assert_double_eq_tol(pose.acceleration.x, (b.velocity.x - a.velocity.x) / (2 * h), 1e-8);
        ck_assert_double_eq_tol(pose.acceleration.y, (b.velocity.y - a.velocity.y) / (2 * h), 1e-8);
    }
}
END_TEST

START_TEST(a_path_is_straight_between_its_points_and_rests_beyond)
{
    sph2d_motion motion = {.path = {points, 3}};
    const double expected[][3] = {{0, 0, 0}, {0.5, 0, 0}, {1, 1, -0.5}, {1.5, 2, -1}, {1.75, 2, 1}, {9, 2, 3}};
    for (size_t k = 0; k < sizeof expected / sizeof *expected; ++k) {
        sph2d__pose pose = sph2d__pose_at(&motion, expected[k][0]);
        ck_assert_double_eq_tol(pose.displacement.x, expected[k][1], 1e-15);
        ck_assert_double_eq_tol(pose.displacement.y, expected[k][2], 1e-15);
    }
}
END_TEST

START_TEST(a_pose_takes_points_there_and_back)
{
    sph2d_motion motion = swing();
    sph2d__pose pose = sph2d__pose_at(&motion, 0.9);
    sph2d_vec2 p = {0.125, -3}, there = sph2d__pose_apply(&pose, p), back = sph2d__pose_invert(&pose, there);
    ck_assert_double_eq_tol(there.x - p.x, pose.displacement.x, 1e-15);
    ck_assert_double_eq_tol(there.y - p.y, pose.displacement.y, 1e-15);
    ck_assert_double_eq_tol(back.x, p.x, 1e-15);
    ck_assert_double_eq_tol(back.y, p.y, 1e-15);
}
END_TEST

/* A wall along y at x = 0 that moves to the right by 1 in a second. */
START_TEST(a_wall_that_moves_takes_a_particle_along)
{
    sph2d_path_point way[] = {{.t = 0, .x = 0, .y = 0}, {.t = 1, .x = 1, .y = 0}};
    sph2d_motion motion = {.path = {way, 2}};
    sph2d__memory memory = sph2d__memory_from((sph2d_allocator){0});
    sph2d__moving wall = {.motion = &motion};
    ck_assert(sph2d__barrier_add(&wall.barrier, (sph2d__segment){{0, -1}, {0, 1}}, &memory));
    ck_assert(sph2d__barrier_build(&wall.barrier, 0.5, 0.01, &memory));
    sph2d__moving_set_drift(&wall, 0.25, 0.5);
    sph2d_vec2 from = {0.3, 0}, to = from, v = {0, 0.5};
    ck_assert_int_eq(sph2d__moving_sweep(&wall, from, &to, &v), 1);
    ck_assert_double_eq_tol(to.x, 0.51, 1e-12); /* in front of the wall, which is at 0.5 then */
    ck_assert_double_eq_tol(v.x, 1, 1e-12);     /* as fast as the wall */
    ck_assert_double_eq(v.y, 0.5);              /* along it as before */
    ck_assert(sph2d__moving_crosses(&wall, (sph2d_vec2){0.4, 0}, (sph2d_vec2){0.6, 0}));
    ck_assert(!sph2d__moving_crosses(&wall, (sph2d_vec2){0.2, 0}, (sph2d_vec2){0.4, 0}));
    sph2d__barrier_free(&wall.barrier, &memory);
    ck_assert_uint_eq(memory.bytes, 0);
}
END_TEST

Suite *suite_pose(void)
{
    Suite *suite = suite_create("pose");
    TCase *tests = tcase_create("pose");
    tcase_add_test(tests, rests_where_the_scene_places_it_at_the_start);
    tcase_add_test(tests, rates_are_slopes_of_places);
    tcase_add_test(tests, a_path_is_straight_between_its_points_and_rests_beyond);
    tcase_add_test(tests, a_pose_takes_points_there_and_back);
    tcase_add_test(tests, a_wall_that_moves_takes_a_particle_along);
    suite_add_tcase(suite, tests);
    return suite;
}
