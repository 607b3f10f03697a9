/* SPDX-License-Identifier: MIT */
/** @file test_openings_around.c
 *  Openings where there is more than a stream: tanks that drain and fill, as Torricelli says, and solids round which liquid
 *  goes without a void behind them. */
#include <math.h>

#include "channel.h"

static void lay_tank(double level)
{
    channel_lay(1, 1, true);
    channel.scene.boundary.top = SPH2D_SIDE_OPEN;
    channel.scene.gravity.y = -9.81;
    channel.blocks[0] = test_block(0, 0, 1, level);
    channel.openings[0] = channel.openings[1];
    channel.probes[0].on = "out";
    channel.scene.opening_count = channel.scene.probe_count = 1;
}

START_TEST(a_tank_with_its_own_pressure_at_a_side_stays_at_rest)
{
    lay_tank(0.5);
    channel.openings[0].from = 0.1;
    channel.openings[0].to = 0.3;
    channel.openings[0].pressure = 1000 * 9.81 * (0.5 - 0.2);
    channel_start();
    channel_run_until(2);
    sph2d_view f = sph2d_sim_fluid(channel.sim);
    double inside = 0;
    for (size_t i = 0; i < f.count; ++i)
        inside += f.x[i] < 1;
    ck_assert_double_le(fabs(inside - 800), 20);               /* half a row */
    ck_assert_double_le(fabs(channel_read(0).velocity), 0.18); /* that of a head of 1.6 mm, 1/15 of a spacing */
    channel_finish();
}
END_TEST

START_TEST(a_tank_drains_as_torricelli_says)
{
    /* Torricelli: v = sqrt(2 g h/(1 - (a/A)^2)), with the head down to the end of the duct, three spacings below the side.
     * A duct that liquid fills has all of that; where the stream comes off the edges it is as little as 0.61. Known
     * weakness: it is 0.54 with these eight spacings across, and 0.68 and 0.60 with half and a quarter of the spacing. */
    lay_tank(0.6);
    channel.openings[0].side = SPH2D_SIDE_NAME_BOTTOM;
    channel.openings[0].from = 0.4;
    channel.openings[0].to = 0.6;
    channel_start();
    double past = 0, wanted = 0, time = 0, rate = 0;
    while (sph2d_sim_time(channel.sim) < 0.6) {
        test_steps(channel.sim, 1);
        double dt = sph2d_sim_time(channel.sim) - time, head = 0.6 + channel_read(0).let_in + 3 * CHANNEL_DX;
        time += dt;
        past += time > 0.3 ? dt : 0;
        wanted += time > 0.3 ? dt * sqrt(2 * 9.81 * head / 0.96) : 0;
        rate += time > 0.3 ? -dt * channel_read(0).velocity : 0;
    }
    ck_assert_double_gt(past, 0.29);
    ck_assert_double_ge(rate / wanted, 0.52);
    ck_assert_double_le(rate / wanted, 1);
    sph2d_summary s = sph2d_sim_summary(channel.sim);
    ck_assert_double_le(fabs(s.energy_error), 0.03 * s.energy_scale);
    channel_finish();
}
END_TEST

START_TEST(a_jet_fills_an_empty_tank)
{
    lay_tank(0.5);
    channel.scene.block_count = 0;
    channel.openings[0].from = 0.6;
    channel.openings[0].to = 0.7;
    channel.openings[0].pressure = NAN;
    channel.openings[0].velocity = 1;
    channel_start();
    uint64_t at_start = sph2d_sim_summary(channel.sim).particles;
    channel_run_until(1);
    channel_check_count(at_start);
    ck_assert_double_le(fabs(channel_read(0).let_in - 0.1), 0.1 * CHANNEL_DX);
    sph2d_summary s = sph2d_sim_summary(channel.sim);
    ck_assert_double_le(s.energy_rise, 0.001 * s.energy_scale);
    ck_assert_double_le(s.compression_p99, 0.026); /* 0.017 is measured */
    channel_finish();
}
END_TEST

START_TEST(volume_and_level_are_those_of_the_domain)
{
    /* Water enters below its surface; what is in the reservoir is not in the tank. */
    static const sph2d_probe_kind kinds[] = {SPH2D_PROBE_VOLUME, SPH2D_PROBE_LEVEL};
    double v[SPH2D_PROBE_MAX_COLUMNS], at_start = 0;
    lay_tank(0.4);
    channel.openings[0] = sph2d_opening_default();
    channel.openings[0].name = "in";
    channel.openings[0].side = SPH2D_SIDE_NAME_LEFT;
    channel.openings[0].to = 0.1;
    channel.openings[0].velocity = 0.5;
    sph2d_probe probes[3] = {channel.probes[0], channel.probes[0], channel.probes[0]};
    for (int k = 0; k < 2; ++k) {
        probes[1 + k] = sph2d_probe_default();
        probes[1 + k].kind = kinds[k];
        probes[1 + k].rate.every = 1;
        probes[1 + k].name = k == 0 ? "volume" : "level";
    }
    probes[0].on = "in";
    channel.scene.probes = probes;
    channel.scene.probe_count = 3;
    channel_start();
    for (int end = 0; end < 2; ++end) {
        channel_run_until(1.0 * end);
        ck_assert_uint_eq(sph2d_sim_probe(channel.sim, 1, v), 2);
        at_start = end == 0 ? v[1] : at_start;
        ck_assert_double_eq_tol(v[1], at_start + channel_read(0).let_in, 1e-12);
        ck_assert_double_eq_tol(v[0], v[1], 0.01);
        ck_assert_uint_eq(sph2d_sim_probe(channel.sim, 2, v), 1);
        ck_assert_double_eq_tol(v[0], 0.4 + channel_read(0).let_in, 0.01);
    }
    ck_assert_double_eq_tol(at_start, 0.4, 1e-12);
    ck_assert_double_ge(channel_read(0).let_in, 0.045);
    channel_finish();
}
END_TEST

START_TEST(no_void_stays_behind_a_cylinder)
{
    /* Pressure in the wake is below that of the outlet, 0. */
    channel_lay(4, 2, false);
    channel.scene.spacing = 0.1;
    channel.scene.fluid.dynamic_viscosity = 10;
    sph2d_obstacle cylinder = sph2d_obstacle_default();
    cylinder.shape.kind = SPH2D_SHAPE_CIRCLE;
    cylinder.shape.circle = (sph2d_circle){{1, 1}, 0.3};
    channel.scene.obstacles = &cylinder;
    channel.scene.obstacle_count = 1;
    channel_start();
    channel_run_until(8);
    sph2d_view f = sph2d_sim_fluid(channel.sim);
    double lowest = 0, inside = 0;
    for (size_t i = 0; i < f.count; ++i) {
        lowest = fmin(lowest, f.pressure[i]);
        inside += f.x[i] > 0 && f.x[i] < 4;
    }
    ck_assert_double_le(lowest, -100);
    double area = 4 * 2 - TEST_PI * 0.3 * 0.3;
    ck_assert_double_le(fabs(inside * 0.01 / area - 1), 0.05); /* two columns */
    channel_finish();
}
END_TEST

START_TEST(no_void_stays_behind_a_corner)
{
    /* A river that turns round a corner: of blocks that fill the domain with a solid, water of nearly no viscosity. */
    static const sph2d_vec2 solid[] = {{0, 0}, {1.2, 0}, {1.2, 1}, {1, 1.2}, {0, 1.2}};
    static const sph2d_vec2 liquid[] = {{0, 1.2}, {1, 1.2}, {1.2, 1}, {1.2, 0}, {2, 0}, {2, 2}, {0, 2}};
    channel_lay(2, 2, true);
    channel.scene.spacing = 0.05;
    sph2d_obstacle bank = sph2d_obstacle_default();
    bank.shape.kind = SPH2D_SHAPE_POLYGON;
    bank.shape.points = (sph2d_points){solid, 5};
    channel.scene.obstacles = &bank;
    channel.scene.obstacle_count = 1;
    channel.blocks[0] = sph2d_block_default();
    channel.blocks[0].shape.kind = SPH2D_SHAPE_POLYGON;
    channel.blocks[0].shape.points = (sph2d_points){liquid, 7};
    channel.openings[0].from = 1.2;
    channel.openings[0].ramp = 0.5;
    channel.openings[1].side = SPH2D_SIDE_NAME_BOTTOM;
    channel.openings[1].from = 1.2;
    channel_start();
    double at_start = 0, now = 0;
    for (int end = 0; end < 2; ++end) {
        channel_run_until(3.0 * end);
        sph2d_view f = sph2d_sim_fluid(channel.sim);
        for (size_t i = 0; i < f.count; ++i)
            *(end ? &now : &at_start) += f.x[i] > 0 && f.y[i] > 0;
    }
    ck_assert_double_le(fabs(now / at_start - 1), 0.02);
    ck_assert_double_ge(channel_read(1).wet, 0.79);
    sph2d_summary s = sph2d_sim_summary(channel.sim);
    ck_assert_double_le(fabs(s.energy_error), 0.03 * s.energy_scale);
    channel_finish();
}
END_TEST

/* Liquid at rest under a pressure presses on a box on the floor by that pressure, and by nothing that keeps particles
 * together. */
START_TEST(a_box_on_the_floor_feels_the_pressure)
{
    const double pressure = 400;
    channel_lay(1, 0.5, true);
    channel.blocks[0].velocity.x = 0;
    sph2d_obstacle box = sph2d_obstacle_default();
    box.name = "box";
    box.shape.kind = SPH2D_SHAPE_BOX;
    box.shape.box = (sph2d_box){{0.4, 0}, {0.6, 0.2}};
    channel.scene.obstacles = &box;
    channel.scene.obstacle_count = 1;
    channel.openings[0].velocity = NAN;
    channel.openings[0].pressure = channel.openings[1].pressure = pressure;
    channel.scene.wall_slip = SPH2D_SLIP_NONE;
    channel.scene.method.operators = _i ? SPH2D_OPERATORS_FITTED : SPH2D_OPERATORS_VARIATIONAL;
    channel.probes[0].kind = SPH2D_PROBE_FORCE;
    channel.probes[0].on = "box";
    channel_start();
    double v[SPH2D_PROBE_MAX_COLUMNS], mean = 0, force = 0;
    const int count = 50;
    for (int k = 1; k <= count; ++k) { /* sound still comes and goes, by 95 Pa */
        sph2d_sample above;
        channel_run_until(2 + 1.0 * k / count);
        ck_assert(sph2d_sim_sample(channel.sim, (sph2d_vec2){0.5, 0.2}, &above));
        ck_assert_uint_eq(sph2d_sim_probe(channel.sim, 0, v), 12);
        ck_assert_double_le(fabs(v[0]), 0.01 * pressure * 0.2);
        mean += above.pressure / count;
        force += v[1] / count;
    }
    ck_assert_double_le(fabs(mean - pressure), (_i ? 0.03 : 0.16) * pressure); /* 394 and 460 Pa are measured */
    ck_assert_double_le(fabs(force / (pressure * 0.2) + 1), _i ? 0.03 : 0.08); /* 394 and 378 Pa */
    channel_finish();
}
END_TEST

Suite *suite_openings_around(void)
{
    Suite *suite = suite_create("openings_around");
    TCase *test = tcase_create("openings_around");
    tcase_add_test(test, a_jet_fills_an_empty_tank);
    suite_add_tcase(suite, test);
    TCase *slow = test_long(suite);
    tcase_add_test(slow, a_tank_with_its_own_pressure_at_a_side_stays_at_rest);
    tcase_add_test(slow, a_tank_drains_as_torricelli_says);
    tcase_add_test(slow, volume_and_level_are_those_of_the_domain);
    tcase_add_test(slow, no_void_stays_behind_a_cylinder);
    tcase_add_test(slow, no_void_stays_behind_a_corner);
    tcase_add_loop_test(slow, a_box_on_the_floor_feels_the_pressure, 0, 2);
    return suite;
}
