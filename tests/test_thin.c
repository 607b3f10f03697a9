/* SPDX-License-Identifier: MIT */
/** @file test_thin.c
 *  The warning of obstacles through which liquids feel each other: where pressures differ, and nowhere else. */
#include <string.h>

#include "common.h"
#include "sph2d/sim.h"

static const double DX = 0.025;
static const double LAYERS = 3; /* H = 3 dx */

static sph2d_vec2 points[4];
static sph2d_block blocks[2];
static sph2d_obstacle obstacles[3];
static sph2d_scene scene;
static sph2d_report report;

/** A wall at x = 1 that is so thick [spacings], with liquid of 1 m on its left and of 0.5 m on its right. */
static void start_with(double thick)
{
    double right = 1 + thick * DX;
    scene = sph2d_scene_default();
    scene.domain = (sph2d_box){{0, 0}, {right + 1, 1.2}};
    scene.spacing = DX;
    obstacles[0] = sph2d_obstacle_default();
    obstacles[0].shape.kind = SPH2D_SHAPE_BOX;
    obstacles[0].shape.box = (sph2d_box){{1, 0}, {right, 1.15}};
    obstacles[1] = obstacles[2] = obstacles[0];
    blocks[0] = test_block(0, 0, 1, 1);
    blocks[1] = test_block(right, 0, right + 1, 0.5);
    scene.obstacles = obstacles;
    scene.obstacle_count = 1;
    scene.blocks = blocks;
    scene.block_count = 2;
    scene.side_slip.bottom = SPH2D_WALL_SLIP_FREE; /* on purpose, also where the liquid is thick */
    scene.method.name = SPH2D_METHOD_PCISPH;
}

/** Whether the scene is warned of, and is sound apart from that. */
static bool is_warned(const char *path)
{
    sph2d_report_clear(&report);
    ck_assert_msg(sph2d_scene_check(&scene, &report) == SPH2D_OK, "%s", test_report_text(&report));
    ck_assert_uint_le(report.count, 1);
    if (report.count == 0)
        return false;
    ck_assert_int_eq(report.items[0].severity, SPH2D_WARNING);
    ck_assert_int_eq(report.items[0].code, SPH2D_CODE_CONFLICT);
    ck_assert_str_eq(report.items[0].path, path);
    return true;
}

START_TEST(walls_thinner_than_their_layers_are_told)
{
    static const struct {
        double thick;
        bool warned;
    } cases[] = {{0.5, true}, {1, true}, {2, true}, {2.8, true}, {LAYERS, false}, {4, false}};
    start_with(cases[_i].thick);
    ck_assert_int_eq(is_warned("obstacles[0].box"), cases[_i].warned);
}
END_TEST

START_TEST(the_message_has_the_place_and_what_to_do)
{
    start_with(1);
    ck_assert(is_warned("obstacles[0].box"));
    ck_assert_ptr_nonnull(strstr(report.items[0].message, "surfaces are 0.5 m apart"));
    ck_assert_ptr_nonnull(strstr(report.items[0].message, "near (1.02, 0.0128), where it is 0.025 m thick"));
    ck_assert_str_eq(report.items[0].hint, "make it 0.075 m thick or thicker, or the spacing 0.0083 m");
}
END_TEST

START_TEST(several_walls_are_one_warning)
{
    start_with(1);
    obstacles[0].shape.box.max.y = 0.2;
    obstacles[1].shape.box.min.y = 0.2;
    obstacles[1].shape.box.max.y = 0.4;
    obstacles[2].shape.box.min.y = 0.6; /* beside the liquid on the left alone */
    scene.obstacle_count = 3;
    ck_assert(is_warned("obstacles[0].box"));
    ck_assert_ptr_nonnull(strstr(report.items[0].message, "thick; the same holds for 1 more"));
}
END_TEST

START_TEST(no_warning_where_both_sides_press_the_same)
{
    start_with(1);
    if (_i == 0) /* the same height on both sides */
        blocks[1].shape.box.max.y = 1;
    else if (_i == 1) /* within the thickness of the wall */
        blocks[1].shape.box.max.y = 1 - 0.9 * DX;
    else if (_i == 2) /* nothing on the right */
        scene.block_count = 1;
    else if (_i == 3) /* not near */
        blocks[1].shape.box.min.x += 2.1 * DX;
    else if (_i == 4) /* no weight: it needs a sound speed then */
        scene.gravity.y = 0, scene.method.sound_speed = 40;
    else { /* a shelf in a pool, which blocks are drawn through */
        obstacles[0].shape.box = (sph2d_box){{0.3, 0.4}, {0.7, 0.4 + DX}};
        scene.block_count = 1;
    }
    ck_assert(!is_warned("obstacles[0].box"));
}
END_TEST

START_TEST(gravity_says_what_is_high)
{
    /* It pulls to the left: a shelf between blocks of 1 and of 0.5 m in length. */
    start_with(1);
    scene.gravity = (sph2d_vec2){-9.81, 0};
    scene.domain.max.y = 2;
    obstacles[0].shape.box = (sph2d_box){{0, 0.5}, {2, 0.5 + DX}};
    blocks[0] = test_block(0, 0, 1, 0.5);
    blocks[1] = test_block(0, 0.5 + DX, _i ? 1 : 0.5, 1);
    ck_assert_int_eq(is_warned("obstacles[0].box"), !_i);
}
END_TEST

START_TEST(discs_and_polygons_are_measured_across)
{
    start_with(1.9);
    double middle = 1 + 0.95 * DX;
    if (_i == 0) {
        obstacles[0].shape.kind = SPH2D_SHAPE_CIRCLE;
        obstacles[0].shape.circle = (sph2d_circle){{middle, 0.25}, 0.95 * DX};
        ck_assert(is_warned("obstacles[0].circle"));
        return;
    }
    sph2d_vec2 plate[4] = {{1, 0}, {1.9 * DX + 1, 0}, {1.9 * DX + 1, 1.1}, {1, 1.1}};
    for (int k = 0; k < 4; ++k)
        points[k] = plate[_i == 1 ? k : 3 - k]; /* either way round */
    obstacles[0].shape.kind = SPH2D_SHAPE_POLYGON;
    obstacles[0].shape.points = (sph2d_points){points, 4};
    ck_assert(is_warned("obstacles[0].polygon"));
}
END_TEST

/** The default method sees nothing through walls of a spacing or more. */
START_TEST(faces_hide_what_is_behind_them)
{
    start_with(_i ? 1.1 : 0.9); /* thickness is told to a tenth of a spacing */
    scene.method.name = SPH2D_METHOD_WCSPH;
    ck_assert_int_eq(is_warned("obstacles[0].box"), !_i);
    if (!_i)
        ck_assert_str_eq(report.items[0].hint, "make it 0.025 m thick or thicker, or the spacing 0.022 m");
}
END_TEST

START_TEST(walls_of_one_layer_are_as_thick_as_the_support)
{
    /* muller: H = 2 dx. A line has no thickness at all. */
    start_with(_i == 0 ? 1.5 : _i == 1 ? 2 : 0);
    scene.method.name = SPH2D_METHOD_MULLER;
    scene.fluid.dynamic_viscosity = 1000;
    if (_i < 2) {
        ck_assert_int_eq(is_warned("obstacles[0].box"), _i == 0);
        return;
    }
    points[0] = (sph2d_vec2){1, 0};
    points[1] = (sph2d_vec2){1, 1.1};
    obstacles[0].shape.kind = SPH2D_SHAPE_LINE;
    obstacles[0].shape.points = (sph2d_points){points, 2};
    ck_assert(is_warned("obstacles[0].line"));
    ck_assert_str_eq(report.items[0].hint, "draw it as a box or a polygon, 0.05 m thick or thicker");
}
END_TEST

START_TEST(layers_are_whole_and_the_support_is_not)
{
    /* H = 2.6 dx: three layers; of one layer H itself counts. */
    start_with(2.8);
    scene.method.name = _i ? SPH2D_METHOD_MULLER : SPH2D_METHOD_PCISPH;
    scene.method.support_ratio = 2.6;
    scene.fluid.dynamic_viscosity = 1000;
    ck_assert_int_eq(is_warned("obstacles[0].box"), !_i);
}
END_TEST

START_TEST(a_line_that_becomes_a_solid_is_thick_enough)
{
    start_with(0);
    points[0] = (sph2d_vec2){1, 0};
    points[1] = (sph2d_vec2){1, 1.1};
    obstacles[0].shape.kind = SPH2D_SHAPE_LINE;
    obstacles[0].shape.points = (sph2d_points){points, 2};
    obstacles[0].liquid = SPH2D_LIQUID_BOTH;
    ck_assert(!is_warned("obstacles[0].line"));
    points[0] = (sph2d_vec2){0.975, 0.3}; /* across its ends it is thinner */
    points[1] = (sph2d_vec2){1.025, 0.3};
    ck_assert(!is_warned("obstacles[0].line"));
}
END_TEST

Suite *suite_thin(void)
{
    Suite *suite = suite_create("thin");
    TCase *tests = tcase_create("thin");
    tcase_add_loop_test(tests, walls_thinner_than_their_layers_are_told, 0, 6);
    tcase_add_test(tests, the_message_has_the_place_and_what_to_do);
    tcase_add_test(tests, several_walls_are_one_warning);
    tcase_add_loop_test(tests, no_warning_where_both_sides_press_the_same, 0, 6);
    tcase_add_loop_test(tests, gravity_says_what_is_high, 0, 2);
    tcase_add_loop_test(tests, discs_and_polygons_are_measured_across, 0, 3);
    tcase_add_loop_test(tests, faces_hide_what_is_behind_them, 0, 2);
    tcase_add_loop_test(tests, walls_of_one_layer_are_as_thick_as_the_support, 0, 3);
    tcase_add_loop_test(tests, layers_are_whole_and_the_support_is_not, 0, 2);
    tcase_add_test(tests, a_line_that_becomes_a_solid_is_thick_enough);
    suite_add_tcase(suite, tests);
    return suite;
}
