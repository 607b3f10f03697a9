/* SPDX-License-Identifier: MIT */
/** @file test_basin.c
 *  The height of the liquid that the sound speed is for: over the lowest place that it can get to, past walls that
 *  stand, no higher than its energy lets it. */
#include <math.h>

#include "common.h"

static const double DX = 0.02, G = 9.81;

static sph2d_vec2 basin[4], second[2];
static sph2d_block block;
static sph2d_obstacle obstacles[2];
static sph2d_scene scene;

/** A basin 0.6 m wide and 0.3 m deep that hangs 1.5 m over the floor of a domain of 1 m by 2 m, filled to 0.2 m. */
static void start(void)
{
    scene = sph2d_scene_default();
    scene.domain = (sph2d_box){{0, 0}, {1, 2}};
    scene.spacing = DX;
    scene.method.name = SPH2D_METHOD_WCSPH;
    basin[0] = (sph2d_vec2){0.2, 1.8};
    basin[1] = (sph2d_vec2){0.2, 1.5};
    basin[2] = (sph2d_vec2){0.8, 1.5};
    basin[3] = (sph2d_vec2){0.8, 1.8};
    obstacles[0] = obstacles[1] = sph2d_obstacle_default();
    obstacles[0].shape.kind = SPH2D_SHAPE_POLYLINE;
    obstacles[0].shape.points = (sph2d_points){basin, 4};
    block = test_block(0.2, 1.5, 0.8, 1.7);
    scene.blocks = &block;
    scene.block_count = 1;
    scene.obstacles = obstacles;
    scene.obstacle_count = 1;
}

/** The height that the scene's head is made of. */
static double height(void)
{
    sph2d_plan plan = {0};
    sph2d_report report = {0};
    sph2d_status status = sph2d_scene_plan(&scene, &plan, &report);
    ck_assert_msg(status == SPH2D_OK, "%s", test_report_text(&report));
    double v = hypot(block.velocity.x, block.velocity.y);
    double c0 = sqrt(2 * plan.head / 0.01);
    ck_assert_double_eq_tol(plan.sound_speed, c0, 1e-12 * c0);
    return (plan.head - v * v / 2) / hypot(scene.gravity.x, scene.gravity.y);
}

START_TEST(liquid_in_a_basin_counts_from_the_bottom_of_the_basin)
{
    ck_assert_double_eq_tol(height(), 0.2, 0.02 + 1e-9); /* to a square of the spacing */
    scene.obstacle_count = 0;
    ck_assert_double_eq_tol(height(), 1.7, 1e-12);
}
END_TEST

START_TEST(liquid_that_stands_higher_than_the_rim_falls_to_the_floor)
{
    basin[3].y = _i ? 1.72 : 1.65;
    ck_assert_double_eq_tol(height(), _i ? 0.2 : 1.7, 0.02 + 1e-9);
}
END_TEST

START_TEST(liquid_that_is_fast_enough_for_the_rim_falls_to_the_floor)
{
    block.velocity.x = (_i ? 0.8 : 1.2) * sqrt(2 * G * 0.1); /* the rim is 0.1 m above it */
    ck_assert_double_eq_tol(height(), _i ? 0.2 : 1.7, 0.02 + 1e-9);
}
END_TEST

START_TEST(liquid_runs_out_through_a_hole)
{
    /* The bottom in two pieces, with a hole of 0.05 m between them, or none. */
    second[0] = (sph2d_vec2){_i ? 0.4 : 0.45, 1.5};
    second[1] = (sph2d_vec2){0.8, 1.5};
    basin[2].x = 0.4;
    obstacles[0].shape.points.count = 3;
    obstacles[1].shape.kind = SPH2D_SHAPE_LINE;
    obstacles[1].shape.points = (sph2d_points){second, 2};
    sph2d_obstacle right = sph2d_obstacle_default();
    static sph2d_vec2 side[2] = {{0.8, 1.5}, {0.8, 1.8}};
    right.shape.kind = SPH2D_SHAPE_LINE;
    right.shape.points = (sph2d_points){side, 2};
    static sph2d_obstacle all[3];
    all[0] = obstacles[0];
    all[1] = obstacles[1];
    all[2] = right;
    scene.obstacles = all;
    scene.obstacle_count = 3;
    ck_assert_double_eq_tol(height(), _i ? 0.2 : 1.7, 0.02 + 1e-9);
}
END_TEST

START_TEST(a_basin_that_moves_holds_nothing)
{
    obstacles[0].motion.amplitude.x = 0.01;
    obstacles[0].motion.frequency = 1;
    ck_assert_double_eq_tol(height(), 1.7, 1e-3); /* its own speed adds a little */
}
END_TEST

START_TEST(down_is_where_gravity_points)
{
    /* Towards +x the basin lies on its side: what was its right wall is its floor, 0.2 m above the domain's. */
    scene.gravity = (sph2d_vec2){G, 0};
    ck_assert_double_eq_tol(height(), 0.8, 1e-12); /* and it runs out over its bottom's rim: the block is as high */
    block = test_block(0.6, 1.5, 0.8, 1.7);
    basin[0].x = basin[1].x = 0.5;
    basin[3].y = 1.9;                              /* the floor of the turned basin is longer than its other wall */
    ck_assert_double_eq_tol(height(), 0.4, 1e-12); /* still open at the top of the picture */
    basin[3].y = 2;
    ck_assert_double_eq_tol(height(), 0.2, 0.02 + 1e-9);
}
END_TEST

START_TEST(liquid_goes_round_a_period)
{
    /* A wall from floor to top keeps it on its left, unless it can go the other way. */
    sph2d_vec2 shelf[3] = {{0.5, 2}, {0.5, 1}, {0, 1}};
    obstacles[0].shape.points = (sph2d_points){shelf, 3};
    block = test_block(0, 1, 0.5, 1.5);
    ck_assert_double_eq_tol(height(), 0.5, 0.02 + 1e-9);
    scene.boundary.left = scene.boundary.right = SPH2D_SIDE_PERIODIC;
    ck_assert_double_eq_tol(height(), 1.5, 1e-12);
}
END_TEST

START_TEST(a_corner_is_reached_to_its_tip)
{
    sph2d_vec2 wedge[3] = {{0.4, 1.9}, {0.5, 1}, {0.6, 1.9}};
    obstacles[0].shape.points = (sph2d_points){wedge, 3};
    sph2d_vec2 corners[3] = {{0.5, 1}, {0.58, 1.72}, {0.42, 1.72}};
    block = sph2d_block_default();
    block.shape.kind = SPH2D_SHAPE_POLYGON;
    block.shape.points = (sph2d_points){corners, 3};
    ck_assert_double_eq_tol(height(), 0.72, 1e-9);
}
END_TEST

START_TEST(a_source_counts_from_its_nozzle)
{
    static sph2d_source source;
    source = sph2d_source_default();
    source.at = (sph2d_vec2){0.5, 1.75};
    source.speed = 0.1;
    scene.sources = &source;
    scene.source_count = 1;
    scene.block_count = 0;
    sph2d_plan plan = {0};
    ck_assert_int_eq(sph2d_scene_plan(&scene, &plan, NULL), SPH2D_OK);
    ck_assert_double_eq_tol((plan.head - 0.005) / G, 0.25, 0.02 + 1e-9);
    scene.source_count = 0; /* the list ends here */
}
END_TEST

Suite *suite_basin(void)
{
    Suite *suite = suite_create("basin");
    TCase *tests = tcase_create("basin");
    tcase_add_checked_fixture(tests, start, NULL);
    tcase_add_test(tests, liquid_in_a_basin_counts_from_the_bottom_of_the_basin);
    tcase_add_loop_test(tests, liquid_that_stands_higher_than_the_rim_falls_to_the_floor, 0, 2);
    tcase_add_loop_test(tests, liquid_that_is_fast_enough_for_the_rim_falls_to_the_floor, 0, 2);
    tcase_add_loop_test(tests, liquid_runs_out_through_a_hole, 0, 2);
    tcase_add_test(tests, a_basin_that_moves_holds_nothing);
    tcase_add_test(tests, down_is_where_gravity_points);
    tcase_add_test(tests, liquid_goes_round_a_period);
    tcase_add_test(tests, a_corner_is_reached_to_its_tip);
    tcase_add_test(tests, a_source_counts_from_its_nozzle);
    suite_add_tcase(suite, tests);
    return suite;
}
