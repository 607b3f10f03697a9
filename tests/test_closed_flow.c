/* SPDX-License-Identifier: MIT */
/** @file test_closed_flow.c
 *  Ducts between openings: how fast the stream is taken to be behind a throat or a bend, how hard it is pulled, and that
 *  no voids are left there. */
#include <math.h>

#include "common.h"
#include "scene/derive.h"

/** A duct 2 m by 0.6 m, without gravity, into which liquid flows at 0.5 m/s, and what its scene points to. */
static sph2d_scene scene;
static sph2d_block block;
static sph2d_opening openings[2];
static sph2d_obstacle plates[2];

static void lay_duct(void)
{
    scene = sph2d_scene_default();
    scene.domain = (sph2d_box){{0, 0}, {2, 0.6}};
    scene.boundary.top = SPH2D_SIDE_WALL;
    scene.gravity = (sph2d_vec2){0, 0};
    scene.spacing = 0.02;
    block = test_block(0, 0, 2, 0.6);
    scene.blocks = &block;
    scene.block_count = 1;
    openings[0] = openings[1] = sph2d_opening_default();
    openings[0].side = SPH2D_SIDE_NAME_LEFT;
    openings[0].velocity = 0.5;
    openings[1].side = SPH2D_SIDE_NAME_RIGHT;
    openings[1].pressure = 0;
    scene.openings = openings;
    scene.opening_count = 2;
    plates[0] = plates[1] = sph2d_obstacle_default();
    plates[0].shape.kind = plates[1].shape.kind = SPH2D_SHAPE_BOX;
    plates[0].shape.box = (sph2d_box){{0.6, 0}, {0.72, 0.21}};
    plates[1].shape.box = (sph2d_box){{0.6, 0.39}, {0.72, 0.6}};
    scene.obstacles = plates;
}

START_TEST(the_jet_behind_plates_is_narrower_than_their_gap)
{
    ck_assert_double_eq_tol(sph2d__throat_speed(test_world(&scene)), 0.5, 1e-9);
    scene.obstacle_count = 2;
    ck_assert_double_eq_tol(sph2d__throat_speed(test_world(&scene)), 0.5 / (0.3 * (0.63 + 0.37 * 0.027)), 1e-9);
    scene.obstacle_count = 1;
    ck_assert_double_eq_tol(sph2d__throat_speed(test_world(&scene)), 0.5 / (0.65 * (0.63 + 0.37 * 0.274625)), 1e-9);
    openings[0].velocity = NAN;
    openings[0].flow_rate = 0.6;
    ck_assert_double_eq_tol(sph2d__throat_speed(test_world(&scene)), 1 / (0.65 * (0.63 + 0.37 * 0.274625)), 1e-9);
}
END_TEST

START_TEST(corners_and_lines_are_throats_and_walls_are_none)
{
    static const sph2d_vec2 corners[] = {{0.8, 0}, {1.2, 0}, {1, 0.3}}, line[] = {{1, 0.3}, {1, 0.6}};
    scene.obstacle_count = 1;
    plates[0].shape = (sph2d_shape){.kind = SPH2D_SHAPE_POLYGON, .points = {corners, 3}};
    double half = 0.5 / (0.5 * (0.63 + 0.37 * 0.125));
    ck_assert_double_eq_tol(sph2d__throat_speed(test_world(&scene)), half, 0.01 * half);
    plates[0].shape = (sph2d_shape){.kind = SPH2D_SHAPE_LINE, .points = {line, 2}};
    plates[0].liquid = SPH2D_LIQUID_LEFT;
    ck_assert_double_ge(sph2d__throat_speed(test_world(&scene)), half); /* it is half a spacing thick */
    ck_assert_double_lt(sph2d__throat_speed(test_world(&scene)), 1.1 * half);
    plates[0].liquid = SPH2D_LIQUID_BOTH; /* a solid with flat ends */
    ck_assert_double_eq_tol(sph2d__throat_speed(test_world(&scene)), half, 0.01 * half);
    plates[0].liquid = SPH2D_LIQUID_AUTO;
    for (int gap = 0; gap < 2; ++gap) { /* of a spacing and a half; it passes nothing */
        plates[0].shape = (sph2d_shape){.kind = SPH2D_SHAPE_BOX, .box = {{0.6, gap * 0.03}, {0.7, 0.6}}};
        ck_assert_double_eq_tol(sph2d__throat_speed(test_world(&scene)), 0.5, 1e-9);
    }
}
END_TEST

START_TEST(a_step_behind_the_inlet_is_no_throat)
{
    scene.obstacle_count = 1;
    plates[0].shape.box = (sph2d_box){{0, 0}, {0.5, 0.3}};
    openings[0].from = 0.3;
    ck_assert_double_eq_tol(sph2d__throat_speed(test_world(&scene)), 0.5, 1e-9);
}
END_TEST

START_TEST(an_outlet_is_a_throat)
{
    openings[1].from = 0.2;
    openings[1].to = 0.35;
    ck_assert_double_eq_tol(sph2d__throat_speed(test_world(&scene)), 0.5 / (0.25 * (0.63 + 0.37 * 0.015625)), 1e-9);
}
END_TEST

START_TEST(the_jet_round_a_corner_is_half_as_wide)
{
    openings[1].side = SPH2D_SIDE_NAME_TOP;
    openings[1].from = 1.4;
    scene.obstacle_count = 1;
    plates[0].shape.box = (sph2d_box){{0, 0.3}, {1.4, 0.6}};
    openings[0].to = 0.3;
    ck_assert_double_eq_tol(sph2d__throat_speed(test_world(&scene)), 0.5 / 0.53, 1e-9);
}
END_TEST

/* A duct to the top that is bounded on its outer side by a slope, which ends below the outlet by a gap. */
START_TEST(the_gap_between_the_outer_bank_and_an_outlet_is_no_throat)
{
    static const sph2d_vec2 bank[] = {{1.8, 0}, {2, 0}, {2, 0.55}};
    openings[1].side = SPH2D_SIDE_NAME_TOP;
    openings[1].from = 1.5;
    openings[0].to = 0.3;
    scene.obstacle_count = 2;
    plates[0].shape.box = (sph2d_box){{0, 0.3}, {1.5, 0.6}};
    plates[1].shape = (sph2d_shape){.kind = SPH2D_SHAPE_POLYGON, .points = {bank, 3}};
    ck_assert_double_eq_tol(sph2d__throat_speed(test_world(&scene)), 0.5 / 0.53, 1e-9);
    /* but a plate in the leg to the outlet is one, and one between inlet and bend */
    plates[1].shape = (sph2d_shape){.kind = SPH2D_SHAPE_BOX, .box = {{1.8, 0.4}, {2, 0.45}}};
    ck_assert_double_eq_tol(sph2d__throat_speed(test_world(&scene)), 0.5 / 0.53, 1e-9); /* 0.3 m, as the inlet */
    plates[1].shape.box.min.x = 1.6;
    ck_assert_double_eq_tol(sph2d__throat_speed(test_world(&scene)), 0.5 * 3 / 0.53, 0.05);
    plates[1].shape.box = (sph2d_box){{0.4, 0}, {0.5, 0.15}};
    ck_assert_double_eq_tol(sph2d__throat_speed(test_world(&scene)), 0.5 * 2 / 0.53, 0.05);
}
END_TEST

START_TEST(other_scenes_have_no_throat)
{
    scene.obstacle_count = 2;
    openings[1].pressure = NAN;
    openings[1].level = 0.4;
    ck_assert_double_eq(sph2d__throat_speed(test_world(&scene)), 0);
    scene.opening_count = 0;
    ck_assert_double_eq(sph2d__throat_speed(test_world(&scene)), 0);
    ck_assert_double_eq(sph2d__slowing_head(&scene), 0);
}
END_TEST

START_TEST(slowing_liquid_is_pulled_by_its_length)
{
    static const sph2d_vec2 tide[] = {{0, 0}, {1, 0.5}, {3, 0.1}, {3, -0.5}, {5, 0.2}};
    ck_assert_double_eq(sph2d__slowing_head(&scene), 0); /* a constant velocity */
    openings[0].ramp = 0.5;
    ck_assert_double_eq(sph2d__slowing_head(&scene), 0); /* it is pushed */
    openings[0].velocity = -0.5;
    ck_assert_double_eq_tol(sph2d__slowing_head(&scene), 2 * 1.875 * 0.5 / 0.5, 1e-12);
    openings[0].velocity = NAN;
    openings[0].history.velocity = (sph2d_history){tide, 5};
    ck_assert_double_eq_tol(sph2d__slowing_head(&scene), 2 * 0.2, 1e-12);
    openings[0].history.velocity.count = 0;
    openings[0].history.flow_rate = (sph2d_history){tide, 5};
    ck_assert_double_eq_tol(sph2d__slowing_head(&scene), 2 * 0.2 / 0.6, 1e-12);
}
END_TEST

START_TEST(no_voids_are_left_behind_plates)
{
    /* With the sound speed of the inlet there were: by counting 0.044 fewer particles than reported. */
    openings[0].ramp = 0.5;
    scene.obstacle_count = 2;
    sph2d_sim *sim = test_create(&scene, NULL);
    double apart = 0;
    while (sph2d_sim_time(sim) < 2) {
        test_steps(sim, 50);
        sph2d_densities d = sph2d_sim_densities(sim);
        apart = fmax(apart, fabs(d.counted - d.reported));
    }
    ck_assert_msg(apart < 0.02, "%g", apart);
    ck_assert_double_lt(fabs(sph2d_sim_summary(sim).energy_error / sph2d_sim_summary(sim).energy_scale), 0.02);
    sph2d_sim_destroy(sim);
}
END_TEST

Suite *suite_closed_flow(void)
{
    Suite *suite = suite_create("closed_flow");
    TCase *tests = tcase_create("closed_flow");
    tcase_add_checked_fixture(tests, lay_duct, NULL);
    tcase_add_test(tests, the_jet_behind_plates_is_narrower_than_their_gap);
    tcase_add_test(tests, corners_and_lines_are_throats_and_walls_are_none);
    tcase_add_test(tests, a_step_behind_the_inlet_is_no_throat);
    tcase_add_test(tests, an_outlet_is_a_throat);
    tcase_add_test(tests, the_jet_round_a_corner_is_half_as_wide);
    tcase_add_test(tests, the_gap_between_the_outer_bank_and_an_outlet_is_no_throat);
    tcase_add_test(tests, other_scenes_have_no_throat);
    tcase_add_test(tests, slowing_liquid_is_pulled_by_its_length);
    suite_add_tcase(suite, tests);
    TCase *slow = test_long(suite);
    tcase_add_checked_fixture(slow, lay_duct, NULL);
    tcase_add_test(slow, no_voids_are_left_behind_plates);
    return suite;
}
