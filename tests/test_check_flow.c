/* SPDX-License-Identifier: MIT */
/** @file test_check_flow.c
 *  What `check` says of liquid that cannot flow: nozzles without room, outlets that nothing can get to, velocities that
 *  come at once. */
#include <math.h>
#include <string.h>

#include "channel.h"

static sph2d_obstacle wall;
static sph2d_drain drain;
static sph2d_source source;
static sph2d_report report;

/** Checks the scene, which may have warnings only; whether one says this of that place, or, without words, there is none. */
static bool says(const char *path, const char *words)
{
    sph2d_report_clear(&report);
    ck_assert_msg(sph2d_scene_check(&channel.scene, &report) == SPH2D_OK, "%s", test_report_text(&report));
    bool said = !words && report.count == 0;
    for (size_t k = 0; words && k < report.count; ++k)
        said = said || (strcmp(report.items[k].path, path) == 0 && strstr(report.items[k].message, words));
    return said;
}

/** A basin 1 m by 0.5 m under air, with water on the left of a wall, and an outlet at the right. */
static void lay_basin(void)
{
    channel_lay(1, 0.5, true);
    channel.scene.gravity.y = -9.81;
    channel.blocks[0] = test_block(0, 0, 0.4, 0.3);
    channel.openings[0] = channel.openings[1];
    channel.scene.opening_count = 1;
    channel.scene.probe_count = 0;
    wall = sph2d_obstacle_default();
    wall.shape.kind = SPH2D_SHAPE_BOX;
    wall.shape.box = (sph2d_box){{0.5, 0}, {0.7, 0.5}};
    channel.scene.obstacles = &wall;
    channel.scene.obstacle_count = 1;
}

static void put_source(double x, double y)
{
    source = sph2d_source_default();
    source.at = (sph2d_vec2){x, y};
    source.width = 0.1;
    source.speed = 1;
    channel.scene.sources = &source;
    channel.scene.source_count = 1;
}

static void finish(void)
{
    sph2d_report_clear(&report);
}

START_TEST(an_outlet_behind_a_wall_is_told)
{
    lay_basin();
    ck_assert(says("openings[0]", "no liquid can get there"));
    wall.shape.box.max.y = 0.45; /* over it, once it splashes */
    ck_assert(says("", NULL));
    wall.shape.box.max.y = 0.5;
    wall.shape.box.min.y = 0.05;
    ck_assert(says("", NULL));
    wall.shape.box.min.y = 0;
    put_source(0.8, 0.3);
    ck_assert(says("", NULL));
    channel.scene.source_count = 0;
    wall.motion.frequency = 1; /* a gate, which may open */
    wall.motion.amplitude.y = 0.02;
    ck_assert(!says("openings[0]", "no liquid can get there"));
}
END_TEST

START_TEST(an_outlet_behind_a_line_is_told)
{
    static const sph2d_vec2 ends[2] = {{0.5, 0}, {0.7, 0.5}};
    lay_basin();
    wall.shape.kind = SPH2D_SHAPE_LINE;
    wall.shape.points = (sph2d_points){ends, 2};
    ck_assert(says("openings[0]", "no liquid can get there"));
    channel.openings[0].pressure = NAN; /* from there, through the opening itself */
    channel.openings[0].velocity = 0.1;
    ck_assert(says("", NULL));
    channel.openings[0].velocity = -0.1;
    ck_assert(says("openings[0]", "no liquid can get there"));
}
END_TEST

START_TEST(a_drain_that_nothing_reaches_is_told)
{
    lay_basin();
    channel.scene.opening_count = 0;
    drain = sph2d_drain_default();
    channel.scene.drains = &drain;
    channel.scene.drain_count = 1;
    const struct {
        sph2d_box box;
        bool told;
    } cases[] = {{{{0.1, 0}, {0.2, 0.1}}, false},   {{{0.1, 0.4}, {0.2, 0.5}}, false},
                 {{{0.8, 0}, {0.9, 0.1}}, true},    {{{0.55, 0.2}, {0.6, 0.3}}, true},
                 {{{0.4, 0.2}, {0.9, 0.3}}, false}, {{{-0.5, -0.5}, {0.2, 0.1}}, false},
                 {{{0.801, 0}, {0.802, 0.1}}, true}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; ++k) {
        drain.shape.kind = SPH2D_SHAPE_BOX;
        drain.shape.box = cases[k].box;
        ck_assert_msg(says("drains[0]", cases[k].told ? "no liquid can get there" : NULL), "%zu: %s", k,
                      test_report_text(&report));
    }
}
END_TEST

START_TEST(a_nozzle_without_room_is_told_or_refused)
{
    lay_basin();
    channel.scene.opening_count = 0;
    put_source(0.2, 0.4);
    ck_assert(says("", NULL));
    put_source(0.2, 0.2);
    ck_assert(says("sources[0].at", "lies in the liquid of blocks[0]"));
    source.start = 1; /* it may have gone by then */
    ck_assert(says("", NULL));
    put_source(0.6, 0.2);
    sph2d_report_clear(&report);
    ck_assert_int_eq(sph2d_scene_check(&channel.scene, &report), SPH2D_SCENE);
    ck_assert_msg(test_report_has(&report, SPH2D_CODE_OVERLAP, "sources[0].at"), "%s", test_report_text(&report));
}
END_TEST

START_TEST(a_velocity_that_comes_at_once_is_told)
{
    static const char words[] = "changes the velocity of the liquid before it by 1 m/s at once";
    channel_lay(1, 0.5, true);
    ck_assert(says("", NULL)); /* the block moves */
    channel.blocks[0].velocity.x = 0;
    ck_assert(says("openings[0]", words));
    ck_assert_msg(strstr(test_report_text(&report), "`ramp: 1` starts it"), "%s", test_report_text(&report));
    channel.openings[0].ramp = 0.5;
    ck_assert(says("", NULL));
    channel.openings[0].ramp = 0;
    channel.openings[0].velocity = -1;
    channel.openings[0].profile = SPH2D_OPENING_PROFILE_PARABOLA;
    ck_assert(says("openings[0]", words));
    channel.blocks[0].start.flow =
        (sph2d_flow){.kind = SPH2D_FLOW_TAYLOR_GREEN, .speed = 1, .length = 1}; /* it has a flow of its own */
    ck_assert(says("", NULL));
    channel.blocks[0].start = sph2d_block_default().start;
    channel.scene.boundary.top = SPH2D_SIDE_OPEN; /* room to give way */
    channel.scene.gravity.y = -9.81;
    ck_assert(says("", NULL));
}
END_TEST

Suite *suite_check_flow(void)
{
    Suite *suite = suite_create("check_flow");
    TCase *test = tcase_create("check_flow");
    tcase_add_checked_fixture(test, NULL, finish);
    tcase_add_test(test, an_outlet_behind_a_wall_is_told);
    tcase_add_test(test, an_outlet_behind_a_line_is_told);
    tcase_add_test(test, a_drain_that_nothing_reaches_is_told);
    tcase_add_test(test, a_nozzle_without_room_is_told_or_refused);
    tcase_add_test(test, a_velocity_that_comes_at_once_is_told);
    suite_add_tcase(suite, test);
    return suite;
}
