/* SPDX-License-Identifier: MIT */
/** @file test_variational_walls.c
 *  What walls of variational operators hold and what they let go: films, jets past edges, what is thrown at them. */
#include <math.h>
#include <string.h>

#include "common.h"
#include "sim/simulation.h"

static const sph2d_vec2 sheet[] = {{0.2, 0.6}, {0.5, 0.6}};

static struct {
    sph2d_scene scene;
    sph2d_block block;
    sph2d_obstacle obstacle;
    sph2d_body body;
    sph2d_opening opening;
    sph2d_sim *sim;
} thrown;

/** Ideal liquid without surface tension and an obstacle, in a domain that is open on all sides. */
static void lay_out(double dx, sph2d_shape obstacle)
{
    memset(&thrown, 0, sizeof thrown);
    thrown.scene = sph2d_scene_default();
    thrown.scene.domain = (sph2d_box){{0, 0}, {1.5, 1}};
    thrown.scene.boundary = (sph2d_boundary){SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN};
    thrown.scene.spacing = dx;
    thrown.scene.fluid.dynamic_viscosity = 0;
    thrown.scene.blocks = &thrown.block;
    thrown.scene.block_count = 1;
    thrown.obstacle = sph2d_obstacle_default();
    thrown.obstacle.shape = obstacle;
    thrown.scene.obstacles = &thrown.obstacle;
    thrown.scene.obstacle_count = 1;
}

static sph2d_summary run_until(double time)
{
    thrown.sim = test_create(&thrown.scene, NULL);
    while (sph2d_sim_time(thrown.sim) < time)
        test_steps(thrown.sim, 1);
    return sph2d_sim_summary(thrown.sim);
}

/** Energy and momentum that are unaccounted for are rounding. */
static void balances(const sph2d_summary *s)
{
    ck_assert_double_le(fabs(s->energy_error), 1e-7 * s->energy_scale);
    ck_assert_double_le(s->momentum_error_max, 1e-8 * s->momentum_moved);
}

/** What is let go below a shelf falls, all of it: what is left is a film, which no wall holds by tension. */
START_TEST(a_shelf_lets_water_go)
{
    lay_out(0.01, (sph2d_shape){.kind = SPH2D_SHAPE_BOX, .box = {{0.2, 0.8}, {0.8, 0.9}}});
    thrown.block = test_block(0.45, 0.75, 0.55, 0.8);
    sph2d_summary s = run_until(0.8);
    balances(&s);
    const sph2d_view f = sph2d_sim_fluid(thrown.sim);
    for (size_t i = 0; i < f.count; ++i)
        ck_assert_double_lt(f.y[i], 0.5); /* 0.25 is measured of the last: it hangs for 0.45 s */
    sph2d_sim_destroy(thrown.sim);
}
END_TEST

/** A drop that meets a circle without gravity leaves it in two sheets, since no pressure turns it round the back. */
START_TEST(a_drop_leaves_a_circle_in_two_sheets)
{
    lay_out(0.01, (sph2d_shape){.kind = SPH2D_SHAPE_CIRCLE, .circle = {{1, 0.5}, 0.12}});
    thrown.obstacle.liquid = SPH2D_LIQUID_BOTH;
    thrown.scene.gravity = (sph2d_vec2){0, 0};
    thrown.block = sph2d_block_default();
    thrown.block.shape = (sph2d_shape){.kind = SPH2D_SHAPE_CIRCLE, .circle = {{0.4, 0.53}, 0.2}};
    thrown.block.velocity = (sph2d_vec2){1.5, 0};
    sph2d_summary s = run_until(0.8);
    balances(&s);
    sph2d_view f = sph2d_sim_fluid(thrown.sim);
    size_t behind = 0, clinging = 0;
    for (size_t i = 0; i < f.count; ++i) {
        const double x = f.x[i] - 1, y = fabs(f.y[i] - 0.5);
        behind += y < 0.05 && x > 0.12;
        clinging += hypot(x, y) < 0.14 && x > 0.14 * sin(20 * TEST_PI / 180);
    }
    ck_assert_uint_eq(f.count, s.particles);
    ck_assert_double_le((double)behind, 0.015 * (double)f.count);
    ck_assert_double_le((double)clinging, 0.005 * (double)f.count);
    sph2d_sim_destroy(thrown.sim);
}
END_TEST

/** What falls past the end of a sheet, half a spacing beside it, goes on. */
START_TEST(a_jet_passes_the_end_of_a_sheet)
{
    lay_out(0.01, (sph2d_shape){.kind = SPH2D_SHAPE_POLYLINE, .points = {sheet, 2}});
    thrown.block = test_block(0.505, 0.8, 0.56, 1);
    thrown.block.velocity = (sph2d_vec2){0, -2};
    sph2d_summary s = run_until(0.2);
    balances(&s);
    const double fallen = 11 * (2 + 9.81 * sph2d_sim_time(thrown.sim)); /* kg/s */
    ck_assert_double_le(fabs(s.momentum[1] + fallen), 0.2 * fallen);
    sph2d_sim_destroy(thrown.sim);
}
END_TEST

/** A jet leaves a duct as wide as it was: beside the duct's end no wall is, which it would leave. */
START_TEST(a_jet_leaves_a_duct_straight)
{
    lay_out(0.02, (sph2d_shape){0});
    thrown.scene.obstacle_count = thrown.scene.block_count = 0;
    thrown.scene.gravity = (sph2d_vec2){0, 0};
    thrown.opening = sph2d_opening_default();
    thrown.opening.name = "tap";
    thrown.opening.side = SPH2D_SIDE_NAME_LEFT;
    thrown.opening.from = 0.5;
    thrown.opening.to = 0.6;
    thrown.opening.velocity = 1;
    thrown.scene.boundary.left = SPH2D_SIDE_WALL;
    thrown.scene.openings = &thrown.opening;
    thrown.scene.opening_count = 1;
    run_until(1);
    sph2d_view f = sph2d_sim_fluid(thrown.sim);
    double widest = 0, farthest = 0;
    for (size_t i = 0; i < f.count; ++i) {
        widest = fmax(widest, fabs(f.y[i] - 0.55));
        farthest = fmax(farthest, f.x[i]);
    }
    ck_assert_double_le(widest, 0.055); /* 0.04 of the outer rows, whose tip opens */
    ck_assert_double_eq_tol(farthest, 1, 0.04);
    sph2d_sim_destroy(thrown.sim);
}
END_TEST

/** A heavy box that sinks to a floor, which mirrors the liquid, takes and gives as much as the liquid does: forces on it
 *  are those of the same boundary particles, none of them beyond the floor. */
START_TEST(a_box_sinks_to_a_mirror)
{
    lay_out(0.02, (sph2d_shape){0});
    thrown.scene.obstacle_count = 0;
    thrown.scene.boundary = (sph2d_boundary){SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_OPEN};
    thrown.block = test_block(0, 0, 1.5, 0.3);
    thrown.body = sph2d_body_default();
    thrown.body.name = "box";
    thrown.body.density = 6000;
    thrown.body.rate = 0.5;
    thrown.body.shape = (sph2d_shape){.kind = SPH2D_SHAPE_BOX, .box = {{0.6, 0.305}, {0.8, 0.4}}};
    thrown.scene.bodies = &thrown.body;
    thrown.scene.body_count = 1;
    sph2d_summary s = run_until(0.6);
    ck_assert_double_lt(sph2d_sim_body(thrown.sim, 0).center.y, 0.12);
    balances(&s);
    sph2d_sim_destroy(thrown.sim);
}
END_TEST

/** Few particles splash on a floor, which mirrors them, and run off: their energy never rises, whatever neighbours they have. */
START_TEST(a_floor_gives_no_energy)
{
    lay_out(0.05, (sph2d_shape){0});
    thrown.scene.obstacle_count = 0;
    thrown.scene.boundary = (sph2d_boundary){SPH2D_SIDE_WALL, SPH2D_SIDE_OPEN, SPH2D_SIDE_WALL, SPH2D_SIDE_OPEN};
    thrown.block = test_block(0, 0, 0.2, 0.6);
    sph2d_summary s = run_until(6);
    balances(&s);
    ck_assert_double_le(s.energy_rise, 1e-6 * s.energy_scale); /* 1.6e-3 with w by sums over images */
    sph2d_sim_destroy(thrown.sim);
}
END_TEST

/** Mean height of the liquid from x0 to x1. */
static double mean_height(double x0, double x1)
{
    const sph2d_view f = sph2d_sim_fluid(thrown.sim);
    double sum = 0, count = 0;
    for (size_t i = 0; i < f.count; ++i)
        if (f.x[i] > x0 && f.x[i] < x1) {
            sum += f.y[i];
            ++count;
        }
    return sum / count;
}

/** Liquids on both sides of a wall a spacing thick do not see each other. */
START_TEST(a_thin_wall_holds_a_head)
{
    lay_out(0.02, (sph2d_shape){.kind = SPH2D_SHAPE_BOX, .box = {{0.49, 0}, {0.51, 0.55}}});
    sph2d_block blocks[] = {test_block(0, 0, 0.49, 0.4), test_block(0.51, 0, 1, 0.2)};
    thrown.scene.domain = (sph2d_box){{0, 0}, {1, 0.6}};
    thrown.scene.boundary = sph2d_scene_default().boundary;
    thrown.scene.blocks = blocks;
    thrown.scene.block_count = 2;
    sph2d_summary s = run_until(1.5);
    balances(&s);
    ck_assert_uint_eq(s.backstop_hits, 0);
    ck_assert_double_le(fabs(mean_height(0, 0.5) / 0.2 - 1), 0.012);
    ck_assert_double_le(fabs(mean_height(0.5, 1) / 0.1 - 1), 0.012);
    ck_assert_double_le(s.kinetic, 3e-4 * s.energy_scale);
    sph2d_sim_destroy(thrown.sim);
}
END_TEST

/** A wedge of 1 to 30 in a tank at rest drives no flow, by which the tank would lose volume. */
START_TEST(a_wedge_leaves_a_tank_at_rest)
{
    static const sph2d_vec2 wedge[] = {{0.3, 0.3}, {1.8, 0.32}, {1.8, 0.35}};
    lay_out(0.025, (sph2d_shape){.kind = SPH2D_SHAPE_POLYGON, .points = {wedge, 3}});
    thrown.block = test_block(0, 0, 2, 0.6);
    thrown.scene.domain = (sph2d_box){{0, 0}, {2, 1}};
    thrown.scene.boundary = sph2d_scene_default().boundary;
    sph2d_summary s = run_until(1.5);
    balances(&s);
    const double before = mean_height(0, 2);
    while (sph2d_sim_time(thrown.sim) < 3)
        test_steps(thrown.sim, 1);
    s = sph2d_sim_summary(thrown.sim);
    ck_assert_double_le(fabs(mean_height(0, 2) / before - 1), 1e-3);
    ck_assert_double_le(s.kinetic, 2e-4 * s.energy_scale);
    sph2d_sim_destroy(thrown.sim);
}
END_TEST

/** Water that runs over the end of a chute meets the tip of a blade 1.5 spacings thick. Between both, walls on each side of a
 *  particle have normals that look much the same way; only the one before it is thin. */
START_TEST(a_tip_beside_a_sheet_is_as_thick_as_a_wall)
{
    static const sph2d_vec2 chute[] = {{0.4, 0.8}, {0.9, 0.8}},
                            blade[] = {{1.1602, 0.5757}, {0.9304, 0.7685}, {0.9496, 0.7915}, {1.1794, 0.5987}};
    lay_out(0.02, (sph2d_shape){.kind = SPH2D_SHAPE_POLYLINE, .points = {chute, 2}});
    sph2d_obstacle walls[] = {thrown.obstacle, sph2d_obstacle_default()};
    walls[0].liquid = SPH2D_LIQUID_LEFT;
    walls[1].shape = (sph2d_shape){.kind = SPH2D_SHAPE_POLYGON, .points = {blade, 4}};
    thrown.scene.domain.max.y = 1.2;
    thrown.scene.obstacles = walls;
    thrown.scene.obstacle_count = 2;
    thrown.block = test_block(0.6, 0.8, 0.88, 0.9);
    thrown.block.velocity = (sph2d_vec2){2, 0};
    sph2d_summary s = run_until(0.3);
    balances(&s);
    ck_assert_double_le(s.energy_rise, 1e-3 * s.energy_scale);
    sph2d_sim_destroy(thrown.sim);
}
END_TEST

Suite *suite_variational_walls(void)
{
    Suite *suite = suite_create("variational_walls");
    TCase *tests = tcase_create("variational_walls");
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, a_shelf_lets_water_go);
    tcase_add_test(tests, a_jet_passes_the_end_of_a_sheet);
    tcase_add_test(tests, a_jet_leaves_a_duct_straight);
    tcase_add_test(tests, a_floor_gives_no_energy);
    tcase_add_test(tests, a_tip_beside_a_sheet_is_as_thick_as_a_wall);
    suite_add_tcase(suite, tests);
    TCase *slow = test_long(suite);
    tcase_set_timeout(slow, 60);
    tcase_add_test(slow, a_drop_leaves_a_circle_in_two_sheets);
    tcase_add_test(slow, a_box_sinks_to_a_mirror);
    tcase_add_test(slow, a_thin_wall_holds_a_head);
    tcase_add_test(slow, a_wedge_leaves_a_tank_at_rest);
    return suite;
}
