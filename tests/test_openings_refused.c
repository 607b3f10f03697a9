/* SPDX-License-Identifier: MIT */
/** @file test_openings_refused.c
 *  Openings that cannot be, each refused at its place, and those that surprise, which are told. */
#include <math.h>
#include <string.h>

#include "channel.h"

static void nothing_given(void)
{
    channel.openings[0].velocity = NAN;
}
static void two_given(void)
{
    channel.openings[1].flow_rate = -1;
}
static void ramp_of_pressure(void)
{
    channel.openings[1].ramp = 1;
}
static void outside(void)
{
    channel.openings[0].to = 2;
}
static void narrow(void)
{
    channel.openings[0].from = 0.1;
    channel.openings[0].to = 0.1 + 2 * CHANNEL_DX;
}
static void open_side(void)
{
    channel.scene.boundary.left = SPH2D_SIDE_OPEN;
}
static void same_side(void)
{
    channel.openings[1].side = SPH2D_SIDE_NAME_LEFT;
}
static void corner(void)
{
    channel.openings[1].side = SPH2D_SIDE_NAME_BOTTOM;
}
static void unbalanced(void)
{
    channel.openings[1].pressure = NAN;
    channel.openings[1].velocity = -0.5;
}
static void other_method(void)
{
    channel.scene.method.name = SPH2D_METHOD_PCISPH;
}
static void moving_tank(void)
{
    channel.scene.motion.amplitude.x = 0.1;
    channel.scene.motion.frequency = 1;
}
static void belt(void)
{
    channel.scene.wall_speeds.left = 1;
}
static void force_on_side(void)
{
    channel.probes[0].kind = SPH2D_PROBE_FORCE;
    channel.probes[0].on = "left";
}
static void unknown_opening(void)
{
    channel.probes[0].on = "door";
}
static void same_name(void)
{
    channel.openings[1].name = "in";
}

static const struct fault {
    const char *path;
    sph2d_code code;
    void (*break_it)(void);
} all_faults[] = {
    {"openings[0]", SPH2D_CODE_MISSING_KEY, nothing_given},
    {"openings[1]", SPH2D_CODE_CONFLICT, two_given},
    {"openings[1].ramp", SPH2D_CODE_CONFLICT, ramp_of_pressure},
    {"openings[0].to", SPH2D_CODE_OUTSIDE, outside},
    {"openings[0].to", SPH2D_CODE_OUT_OF_RANGE, narrow},
    {"openings[0].side", SPH2D_CODE_CONFLICT, open_side},
    {"openings[1]", SPH2D_CODE_OVERLAP, same_side},
    {"openings[1]", SPH2D_CODE_OVERLAP, corner},
    {"openings", SPH2D_CODE_CONFLICT, unbalanced},
    {"openings", SPH2D_CODE_UNSUPPORTED, other_method},
    {"motion", SPH2D_CODE_UNSUPPORTED, moving_tank},
    {"openings[0].side", SPH2D_CODE_CONFLICT, belt},
    {"probes[0].on", SPH2D_CODE_UNSUPPORTED, force_on_side},
    {"probes[0].on", SPH2D_CODE_CONFLICT, unknown_opening},
    {"openings[1].name", SPH2D_CODE_CONFLICT, same_name},
};
enum { FAULTS = sizeof all_faults / sizeof *all_faults };

START_TEST(bad_openings_are_refused)
{
    channel_lay(0.5, 0.25, true);
    all_faults[_i].break_it();
    sph2d_report report = {0};
    ck_assert_int_eq(sph2d_scene_check(&channel.scene, &report), SPH2D_SCENE);
    ck_assert_msg(test_report_has(&report, all_faults[_i].code, all_faults[_i].path), "%s", test_report_text(&report));
    sph2d_report_clear(&report);
}
END_TEST

START_TEST(a_solid_before_an_opening_is_refused)
{
    channel_lay(0.5, 0.25, true);
    sph2d_obstacle box = sph2d_obstacle_default();
    box.shape.kind = SPH2D_SHAPE_BOX;
    box.shape.box = (sph2d_box){{0, 0}, {0.1, 0.1}};
    channel.scene.obstacles = &box;
    channel.scene.obstacle_count = 1;
    sph2d_report report = {0};
    ck_assert_int_eq(sph2d_scene_check(&channel.scene, &report), SPH2D_SCENE);
    ck_assert_msg(test_report_has(&report, SPH2D_CODE_OVERLAP, "openings[0]"), "%s", test_report_text(&report));
    channel.openings[0].from = 0.1;
    ck_assert_int_eq(sph2d_scene_check(&channel.scene, NULL), SPH2D_OK);
    sph2d_report_clear(&report);
}
END_TEST

START_TEST(what_has_a_surface_is_refused_by_fitted_operators)
{
    static const char *const paths[] = {"openings[1]", "openings[0]", "blocks"};
    sph2d_report report = {0};
    channel_lay(1, 0.5, true);
    channel.scene.method.operators = SPH2D_OPERATORS_FITTED;
    channel.scene.wall_slip = SPH2D_SLIP_NONE;
    ck_assert_int_eq(sph2d_scene_check(&channel.scene, &report), SPH2D_OK);
    channel.scene.gravity.y = -9.81;
    if (_i == 0) {
        channel.openings[1].pressure = NAN;
        channel.openings[1].level = 0.3;
    } else if (_i == 1) {
        channel.openings[0].free_surface = SPH2D_SWITCH_ON;
    } else {
        channel.blocks[0].shape.box.max.y = 0.3;
    }
    ck_assert_int_eq(sph2d_scene_check(&channel.scene, &report), SPH2D_SCENE);
    ck_assert_msg(test_report_has(&report, SPH2D_CODE_UNSUPPORTED, paths[_i]), "%s", test_report_text(&report));
    sph2d_report_clear(&report);
}
END_TEST

/* An inflow over a whole side is told where liquid stands lower; not one that ends there, has a surface, lets out, or lies
 * above dry ground. */
START_TEST(an_inflow_above_the_level_is_told)
{
    static const struct {
        double depth, velocity, to;
        sph2d_switch surface;
        bool told;
    } cases[] = {{0.1, 1, NAN, SPH2D_SWITCH_OFF, true},   {0.1, 1, 0.1, SPH2D_SWITCH_OFF, false},
                 {0.1, 1, NAN, SPH2D_SWITCH_ON, false},   {0.1, -1, NAN, SPH2D_SWITCH_OFF, false},
                 {0.25, 1, NAN, SPH2D_SWITCH_OFF, false}, {0, 1, NAN, SPH2D_SWITCH_OFF, false}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; ++k) {
        channel_lay(0.5, 0.25, true);
        channel.scene.gravity.y = -9.81;
        channel.scene.boundary.top = SPH2D_SIDE_OPEN;
        channel.blocks[0] = cases[k].depth > 0 ? test_block(0, 0, 0.5, cases[k].depth) : test_block(0.25, 0, 0.5, 0.1);
        channel.openings[0].velocity = cases[k].velocity;
        channel.openings[0].to = cases[k].to;
        channel.openings[0].free_surface = cases[k].surface;
        sph2d_report report = {0};
        ck_assert_msg(sph2d_scene_check(&channel.scene, &report) == SPH2D_OK, "%zu: %s", k, test_report_text(&report));
        bool told = report.count == 1 && report.items[0].severity == SPH2D_WARNING &&
                    strcmp(report.items[0].path, "openings[0]") == 0;
        ck_assert_msg(told == cases[k].told, "%zu: %s", k, test_report_text(&report));
        sph2d_report_clear(&report);
    }
}
END_TEST

Suite *suite_openings_refused(void)
{
    Suite *suite = suite_create("openings_refused");
    TCase *test = tcase_create("openings_refused");
    tcase_add_loop_test(test, bad_openings_are_refused, 0, FAULTS);
    tcase_add_test(test, a_solid_before_an_opening_is_refused);
    tcase_add_loop_test(test, what_has_a_surface_is_refused_by_fitted_operators, 0, 3);
    tcase_add_test(test, an_inflow_above_the_level_is_told);
    suite_add_tcase(suite, test);
    return suite;
}
