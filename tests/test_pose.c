/* SPDX-License-Identifier: MIT */
/** @file test_pose.c
 *  Motions (scene/motion.h) and obstacles that follow them (boundary/moving.h): rates against differences of places,
 *  places against each other, and a sweep against one where the wall rests. */
#include <math.h>

#include "base/pi.h"
#include "boundary/moving.h"
#include "common.h"
#include "scene/shape.h"

static sph2d_pose_point points[] = {{.t = 0.5, .x = 0, .y = 0}, {.t = 1.5, .x = 2, .y = -1}, {.t = 2, .x = 2, .y = 3}};

static const sph2d_shape nowhere = {.kind = SPH2D_SHAPE_NONE};

static sph2d__pose pose_at(const sph2d_motion *motion, double time)
{
    sph2d_pose_point bends[8];
    ck_assert_uint_le(sph2d__motion_bends(motion), 8);
    sph2d__course course = sph2d__course_of(motion, &nowhere, sph2d__motion_bends(motion) ? bends : NULL);
    return sph2d__course_at(&course, time);
}

static sph2d_motion swing(void)
{
    return (sph2d_motion){.amplitude = {0.3, -0.2}, .frequency = 0.7, .phase = 0.4};
}

START_TEST(rests_where_the_scene_places_it_at_the_start)
{
    sph2d_motion motion = swing();
    sph2d__pose pose = pose_at(&motion, 0);
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
    motion.path = (sph2d_pose_path){points, 3};
    const double h = 1e-5;
    for (double t = 0.1; t < 2.5; t += 0.17) {
        sph2d__pose a = pose_at(&motion, t - h), pose = pose_at(&motion, t);
        sph2d__pose b = pose_at(&motion, t + h);
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
        sph2d__pose pose = pose_at(&motion, expected[k][0]);
        ck_assert_double_eq_tol(pose.displacement.x, expected[k][1], 1e-15);
        ck_assert_double_eq_tol(pose.displacement.y, expected[k][2], 1e-15);
    }
}
END_TEST

START_TEST(a_pose_takes_points_there_and_back)
{
    sph2d_motion motion = swing();
    sph2d__pose pose = pose_at(&motion, 0.9);
    sph2d_vec2 p = {0.125, -3}, there = sph2d__pose_apply(&pose, p), back = sph2d__pose_invert(&pose, there);
    ck_assert_double_eq_tol(there.x - p.x, pose.displacement.x, 1e-15);
    ck_assert_double_eq_tol(there.y - p.y, pose.displacement.y, 1e-15);
    ck_assert_double_eq_tol(back.x, p.x, 1e-15);
    ck_assert_double_eq_tol(back.y, p.y, 1e-15);
}
END_TEST

/** A motion of everything: a cubic path with angles, a rate, two swings, a ramp. */
static sph2d_motion all(void)
{
    static const sph2d_pose_point way[] = {
        {0, 0, 0, 0}, {0.4, 0.2, 0.1, 0.3}, {1, 0.1, 0.4, -0.2}, {1.5, -0.3, 0.2, 0.4}, {2.2, 0, 0, 0.1}};
    static const sph2d_swing swings[] = {{{0.1, 0}, 0.2, 0.9, -0.5}, {{0, 0.05}, 0, 2.3, 0.2}};
    sph2d_motion motion = sph2d_motion_default();
    motion.path = (sph2d_pose_path){way, 5};
    motion.between = SPH2D_BETWEEN_CUBIC;
    motion.rate = 0.7;
    motion.amplitude = (sph2d_vec2){0.3, -0.2};
    motion.angle = 0.4;
    motion.frequency = 0.7;
    motion.phase = 0.4;
    motion.swings = swings;
    motion.swing_count = 2;
    motion.ramp = 1.1;
    motion.center = (sph2d_vec2){0.5, -1};
    return motion;
}

START_TEST(points_of_a_turning_body_move_as_their_rates_say)
{
    const double h = 1e-5;
    const sph2d_vec2 p = {2, 0.5};
    sph2d_motion motion = all();
    double largest = 0;
    ck_assert(sph2d__motion_turns(&motion));
    for (double t = 0.05; t < 2.5; t += 0.17) {
        sph2d__pose before = pose_at(&motion, t - h), pose = pose_at(&motion, t), after = pose_at(&motion, t + h);
        sph2d_vec2 a = sph2d__pose_apply(&before, p), b = sph2d__pose_apply(&pose, p), c = sph2d__pose_apply(&after, p);
        sph2d_vec2 v = sph2d__pose_velocity(&pose, b), acc = sph2d__pose_acceleration(&pose, b);
        sph2d_vec2 u = sph2d__pose_velocity(&before, a), w = sph2d__pose_velocity(&after, c);
        ck_assert_double_eq_tol(v.x, (c.x - a.x) / (2 * h), 1e-7);
        ck_assert_double_eq_tol(v.y, (c.y - a.y) / (2 * h), 1e-7);
        ck_assert_double_eq_tol(acc.x, (w.x - u.x) / (2 * h), 1e-6);
        ck_assert_double_eq_tol(acc.y, (w.y - u.y) / (2 * h), 1e-6);
        sph2d_vec2 back = sph2d__pose_invert(&pose, b);
        ck_assert_double_eq_tol(back.x, p.x, 1e-14);
        ck_assert_double_eq_tol(back.y, p.y, 1e-14);
        largest = fmax(largest, hypot(v.x, v.y));
    }
    sph2d_pose_point bends[8];
    sph2d__course course = sph2d__course_of(&motion, &nowhere, bends);
    double bound = sph2d__course_speed(&course, hypot(p.x - motion.center.x, p.y - motion.center.y));
    ck_assert_double_ge(bound, largest);
    ck_assert_double_lt(bound, 4 * largest);
}
END_TEST

/** A body that turns at 2 rad/s about (1, 1): a quarter turn takes its point on the right to the top. */
START_TEST(a_positive_angle_is_anticlockwise)
{
    sph2d_motion motion = sph2d_motion_default();
    motion.rate = 2;
    motion.center = (sph2d_vec2){1, 1};
    sph2d__pose pose = pose_at(&motion, SPH2D__PI / 4);
    sph2d_vec2 p = sph2d__pose_apply(&pose, (sph2d_vec2){1.5, 1}), v = sph2d__pose_velocity(&pose, p);
    sph2d_vec2 a = sph2d__pose_acceleration(&pose, p);
    ck_assert_double_eq_tol(p.x, 1, 1e-14);
    ck_assert_double_eq_tol(p.y, 1.5, 1e-14);
    ck_assert_double_eq_tol(v.x, -1, 1e-14);
    ck_assert_double_eq_tol(v.y, 0, 1e-14);
    ck_assert_double_eq_tol(a.x, 0, 1e-14);
    ck_assert_double_eq_tol(a.y, -2, 1e-14); /* omega^2 r, towards the centre */
}
END_TEST

/** A sine in 21 points: cubics are within 1e-4 of its amplitude, its velocity within 1e-3 and its acceleration within
 *  1.5 % away from the ends, and with twice the points the error of places is 14 times smaller or less. */
START_TEST(cubics_follow_a_sine)
{
    double errors[2];
    for (int fine = 0; fine < 2; ++fine) {
        sph2d_pose_point points_of_sine[41], bends[41];
        int n = fine ? 40 : 20;
        for (int k = 0; k <= n; ++k) {
            double t = (double)k / n;
            points_of_sine[k] = (sph2d_pose_point){t, sin(2 * SPH2D__PI * t), 0, -3 * sin(2 * SPH2D__PI * t)};
        }
        sph2d_motion motion = sph2d_motion_default();
        motion.path = (sph2d_pose_path){points_of_sine, (size_t)n + 1};
        motion.between = SPH2D_BETWEEN_CUBIC;
        sph2d__course course = sph2d__course_of(&motion, &nowhere, bends);
        errors[fine] = 0;
        for (double t = 0.003; t < 1; t += 0.007) {
            const double w = 2 * SPH2D__PI;
            sph2d__pose pose = sph2d__course_at(&course, t);
            errors[fine] = fmax(errors[fine], fabs(pose.displacement.x - sin(w * t)));
            ck_assert_double_eq_tol(pose.angle, -3 * pose.displacement.x, 1e-12);
            ck_assert_double_eq_tol(pose.velocity.x, w * cos(w * t), 1e-3 * w);
            ck_assert_double_eq_tol(pose.acceleration.x, -w * w * sin(w * t), 0.015 * w * w);
        }
    }
    ck_assert_double_lt(errors[0], 1e-4);
    ck_assert_double_lt(errors[1], errors[0] / 14);
}
END_TEST

START_TEST(a_ramp_starts_at_rest_and_ends_at_full_size)
{
    sph2d_motion motion = {.rate = 3, .amplitude = {0.2, 0}, .frequency = 1, .ramp = 0.5}, full = motion;
    full.ramp = 0;
    sph2d__pose start = pose_at(&motion, 0), end = pose_at(&motion, 0.5), late = pose_at(&motion, 2.3);
    sph2d__pose other = pose_at(&full, 2.3);
    ck_assert(start.velocity.x == 0 && start.omega == 0 && start.acceleration.x == 0 && start.alpha == 0);
    ck_assert_double_eq_tol(end.omega, 3, 1e-14);
    ck_assert_double_eq_tol(end.alpha, 0, 1e-12);
    ck_assert_double_eq_tol(end.angle, 3 * 0.25, 1e-14); /* half of what the full rate would have turned */
    ck_assert_double_eq_tol(late.angle, other.angle - 0.75, 1e-13);
    ck_assert_double_eq(late.displacement.x, other.displacement.x);
}
END_TEST

START_TEST(an_obstacle_turns_about_its_centroid)
{
    sph2d_vec2 corners[] = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}, ends[] = {{0, 1}, {2, 1}, {2, 2}};
    const struct {
        sph2d_shape shape;
        sph2d_vec2 expected;
        double farthest; /* from the origin */
    } cases[] = {
        {{.kind = SPH2D_SHAPE_POLYGON, .points = {corners, 6}}, {0.75, 1.25}, sqrt(10)},
        {{.kind = SPH2D_SHAPE_POLYLINE, .points = {ends, 3}}, {4.0 / 3, 3.5 / 3}, sqrt(8)},
        {{.kind = SPH2D_SHAPE_BOX, .box = {{1, 2}, {3, 6}}}, {2, 4}, sqrt(45)},
        {{.kind = SPH2D_SHAPE_CIRCLE, .circle = {{3, 4}, 2}}, {3, 4}, 7},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; ++k) {
        sph2d_vec2 c = sph2d_shape_centroid(&cases[k].shape);
        ck_assert_double_eq_tol(c.x, cases[k].expected.x, 1e-14);
        ck_assert_double_eq_tol(c.y, cases[k].expected.y, 1e-14);
        double farthest = sph2d__shape_distance(&cases[k].shape, (sph2d_vec2){0, 0});
        ck_assert_double_eq_tol(farthest, cases[k].farthest, 1e-14);
    }
}
END_TEST

START_TEST(corners_of_shapes)
{
    sph2d_vec2 ends[] = {{0, 1}, {2, 1}, {2, 2}}, c[64];
    const sph2d_shape box = {.kind = SPH2D_SHAPE_BOX, .box = {{1, 2}, {3, 6}}};
    const sph2d_shape open = {.kind = SPH2D_SHAPE_POLYLINE, .points = {ends, 3}};
    const sph2d_shape arc = {.kind = SPH2D_SHAPE_ARC, .arc = {{1, 1}, 2, 0, TEST_PI / 2}};
    sph2d_shape circle = {.kind = SPH2D_SHAPE_CIRCLE, .circle = {{3, 4}, 2}};
    ck_assert_uint_eq(sph2d_shape_corners(&box, 1, c), 4);
    ck_assert(c[0].x == 1 && c[0].y == 2 && c[1].x == 3 && c[1].y == 2 && c[2].y == 6 && c[3].x == 1);
    ck_assert_uint_eq(sph2d_shape_corners(&open, 1, c), 3);
    ck_assert(c[0].y == 1 && c[2].x == 2 && c[2].y == 2);
    ck_assert_uint_eq(sph2d_shape_corners(&arc, 0.2, c), 17); /* pi/0.2 = 15.7 pieces */
    for (int k = 0; k < 17; ++k)
        ck_assert_double_eq_tol(hypot(c[k].x - 1, c[k].y - 1), 2, 1e-14);
    ck_assert(fabs(c[0].x - 3) < 1e-14 && fabs(c[16].y - 3) < 1e-14);
    const size_t count = sph2d_shape_corners(&circle, 0.5, c);
    ck_assert_uint_eq(count, 26); /* 4 pi/0.5 = 25.1 */
    double area = 0;
    for (size_t k = 0; k < count; ++k) {
        const sph2d_vec2 a = c[k], b = c[(k + 1) % count];
        area += ((a.x - 3) * (b.y - 4) - (b.x - 3) * (a.y - 4)) / 2;
    }
    ck_assert_double_eq_tol(area, 4 * TEST_PI, 1e-12);
    circle.circle.radius = NAN;
    ck_assert_uint_eq(sph2d_shape_corners(&circle, 0.5, NULL), 8);
    ck_assert_uint_eq(sph2d_shape_corners(&box, 0, NULL), 0);
}
END_TEST

/* A blade from the origin to (1, 0) that turns by half a turn in one drift takes a particle above it along, and lets one
 * beyond its end alone: a straight sweep of the frame would see neither. */
START_TEST(a_blade_that_turns_sweeps_arcs)
{
    sph2d_motion motion = {.rate = SPH2D__PI};
    sph2d__memory memory = sph2d__memory_from((sph2d_allocator){0});
    sph2d__pose poses[SPH2D__MOST_CHORDS + 1];
    sph2d__moving blade = {.course = sph2d__course_of(&motion, &nowhere, NULL), .poses = poses};
    ck_assert(sph2d__barrier_add(&blade.barrier, (sph2d__segment){{0, 0}, {1, 0}}, &memory));
    ck_assert(sph2d__barrier_build(&blade.barrier, 0.2, 0.01, &memory));
    sph2d__moving_start(&blade, NULL, NULL);
    sph2d__moving_set_drift(&blade, 0, 1);
    ck_assert_double_eq_tol(sph2d__moving_shift(&blade), SPH2D__PI, 1e-12);
    sph2d_vec2 from = {0.4, 0.1}, to = from, v = {0, 0};
    ck_assert(!sph2d__moving_far_from(&blade, from, to, 0));
    ck_assert_int_gt(sph2d__moving_sweep(&blade, from, &to, &v), 10);
    ck_assert_double_lt(to.x, 0); /* in front of the blade, which points to the left now */
    ck_assert_double_eq_tol(to.y, -0.01, 2e-3);
    ck_assert_double_eq_tol(v.y, SPH2D__PI * to.x, 5e-3); /* as fast as the blade there */
    sph2d_vec2 beyond = {0.8, 0.8}, still = beyond, none = {0, 0};
    ck_assert_int_eq(sph2d__moving_sweep(&blade, beyond, &still, &none), 0);
    ck_assert(still.x == 0.8 && still.y == 0.8);
    ck_assert(sph2d__moving_far_from(&blade, (sph2d_vec2){5, 5}, (sph2d_vec2){6, 6}, 0.1));
    sph2d__barrier_free(&blade.barrier, &memory);
    ck_assert_uint_eq(memory.bytes, 0);
}
END_TEST

/* A wall along y at x = 0 that moves to the right by 1 in a second. */
START_TEST(a_wall_that_moves_takes_a_particle_along)
{
    sph2d_pose_point way[] = {{.t = 0, .x = 0, .y = 0}, {.t = 1, .x = 1, .y = 0}};
    sph2d_motion motion = {.path = {way, 2}};
    sph2d__memory memory = sph2d__memory_from((sph2d_allocator){0});
    sph2d__pose poses[SPH2D__MOST_CHORDS + 1];
    sph2d__moving wall = {.course = sph2d__course_of(&motion, &nowhere, NULL), .poses = poses};
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
    tcase_add_test(tests, points_of_a_turning_body_move_as_their_rates_say);
    tcase_add_test(tests, a_positive_angle_is_anticlockwise);
    tcase_add_test(tests, cubics_follow_a_sine);
    tcase_add_test(tests, a_ramp_starts_at_rest_and_ends_at_full_size);
    tcase_add_test(tests, an_obstacle_turns_about_its_centroid);
    tcase_add_test(tests, corners_of_shapes);
    tcase_add_test(tests, a_blade_that_turns_sweeps_arcs);
    tcase_add_test(tests, a_wall_that_moves_takes_a_particle_along);
    suite_add_tcase(suite, tests);
    return suite;
}
