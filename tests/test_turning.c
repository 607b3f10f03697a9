/* SPDX-License-Identifier: MIT */
/** @file test_turning.c
 *  Walls that turn and drag liquid along, and hollow obstacles, which hold it. */
#include <math.h>
#include <string.h>

#include "common.h"
#include "scene/liquid.h"
#include "sim/simulation.h"

static sph2d_scene scene;
static sph2d_block block;
static sph2d_obstacle obstacles[2];
static sph2d_probe probes[2];

/* ---- circular Couette flow --------------------------------------------------------------------------------------- */

static const double SHAFT = 0.25, DRUM = 0.5;

/** Ten spacings across the gap, viscous enough to be steady soon. */
static void start_couette(void)
{
    static const char *const names[2] = {"drum", "shaft"};
    scene = test_open_scene(0.025, -0.62, -0.62, 0.62, 0.62);
    scene.method = sph2d_scene_default().method;
    scene.method.sound_speed = 10;
    scene.method.support_ratio = 4;
    scene.wall_slip = SPH2D_SLIP_NONE;
    scene.fluid.dynamic_viscosity = 50;
    block = sph2d_block_default();
    block.shape = (sph2d_shape){.kind = SPH2D_SHAPE_CIRCLE, .circle = {{0, 0}, DRUM}};
    block.arrangement = SPH2D_ARRANGEMENT_RINGS;
    for (int k = 0; k < 2; ++k) {
        obstacles[k] = sph2d_obstacle_default();
        obstacles[k].name = names[k];
        obstacles[k].shape = (sph2d_shape){.kind = SPH2D_SHAPE_CIRCLE, .circle = {{0, 0}, k ? SHAFT : DRUM}};
        probes[k] = sph2d_probe_default();
        probes[k].name = names[k];
        probes[k].kind = SPH2D_PROBE_FORCE;
        probes[k].on = names[k];
        probes[k].rate.every = 0.1;
    }
    obstacles[0].liquid = SPH2D_LIQUID_INSIDE;
    scene.blocks = &block;
    scene.block_count = 1;
    scene.obstacles = obstacles;
    scene.obstacle_count = 2;
    scene.probes = probes;
    scene.probe_count = 2;
}

/** Largest error of the tangential velocity of all particles, over the largest speed: u = A r + B/r (Landau & Lifshitz,
 *  Fluid Mechanics, eq. 18.3). */
static double couette_error(const sph2d_sim *sim, double shaft, double drum)
{
    double r1 = SHAFT * SHAFT, r2 = DRUM * DRUM, worst = 0;
    double a = (drum * r2 - shaft * r1) / (r2 - r1), b = (shaft - drum) * r1 * r2 / (r2 - r1);
    sph2d_view f = sph2d_sim_fluid(sim);
    for (size_t i = 0; i < f.count; ++i) {
        double r = hypot(f.x[i], f.y[i]), u = (f.x[i] * f.vy[i] - f.y[i] * f.vx[i]) / r;
        ck_assert(r > SHAFT && r < DRUM);
        worst = fmax(worst, fabs(u - (a * r + b / r)));
    }
    return worst / fmax(fabs(shaft) * SHAFT, fabs(drum) * DRUM);
}

/** The shaft turns, or the drum, or both against each other. The torques on the two are opposite, and those of theory. */
START_TEST(liquid_between_circles_that_turn)
{
    static const double rates[3][2] = {{0, 1}, {0.5, 0}, {-0.4, 0.8}};
    double drum = rates[_i][0], shaft = rates[_i][1], values[2][SPH2D_PROBE_MAX_COLUMNS];
    start_couette();
    obstacles[0].motion.rate = drum;
    obstacles[1].motion.rate = shaft;
    obstacles[0].motion.ramp = obstacles[1].motion.ramp = 0.2;
    sph2d_sim *sim = test_create(&scene, NULL);
    while (sph2d_sim_time(sim) < 1.5)
        test_steps(sim, 1);
    double error = couette_error(sim, shaft, drum);
    ck_assert_msg(error < 0.03, "%g", error);
    double r1 = SHAFT * SHAFT, r2 = DRUM * DRUM, expected = 4 * TEST_PI * 50 * (shaft - drum) * r1 * r2 / (r2 - r1);
    for (size_t k = 0; k < 2; ++k)
        sph2d_sim_probe(sim, k, values[k]);
    for (int k = 0; k < 2; ++k)
        ck_assert_msg(fabs((k ? -1 : 1) * values[k][2] / expected - 1) < 0.05, "%d: %g", k, values[k][2] / expected);
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- hollow obstacles -------------------------------------------------------------------------------------------- */

static const double DX = 0.02;

/** A hollow box, polygon or circle half full of water: it stays in, weighs what it should, and comes to rest. */
START_TEST(a_hollow_obstacle_holds_water)
{
    sph2d_vec2 corners[] = {{0.1, 0.1}, {0.9, 0.1}, {0.9, 0.9}, {0.5, 0.7}, {0.1, 0.9}};
    double values[SPH2D_PROBE_MAX_COLUMNS];
    start_couette();
    scene = test_open_scene(DX, -0.1, -0.1, 1.1, 1.1);
    scene.method = sph2d_scene_default().method;
    scene.gravity = (sph2d_vec2){0, -9.81};
    scene.fluid.dynamic_viscosity = 5;
    block = test_block(0.1, 0.1, 0.9, 0.5);
    scene.blocks = &block;
    scene.block_count = 1;
    if (_i == 0)
        obstacles[0].shape = (sph2d_shape){.kind = SPH2D_SHAPE_BOX, .box = {{0.1, 0.1}, {0.9, 0.9}}};
    if (_i == 1)
        obstacles[0].shape = (sph2d_shape){.kind = SPH2D_SHAPE_POLYGON, .points = {corners, 5}};
    if (_i == 2) {
        obstacles[0].shape = (sph2d_shape){.kind = SPH2D_SHAPE_CIRCLE, .circle = {{0.5, 0.5}, 0.4}};
        block = test_block(0.24, 0.2, 0.76, 0.5);
    }
    scene.obstacles = obstacles;
    scene.obstacle_count = 1;
    scene.probes = probes;
    scene.probe_count = 1;
    sph2d_sim *sim = test_create(&scene, NULL);
    size_t count = sim->system.fluid.count;
    double impulse = 0, time = 0;
    while (time < (_i == 2 ? 3 : 1)) { /* in the bowl it still sloshes after 1 s */
        test_steps(sim, 1);
        ck_assert(sph2d_sim_probe(sim, 0, values));
        impulse += values[1] * (sph2d_sim_time(sim) - time); /* the mean over the step */
        time = sph2d_sim_time(sim);
    }
    sph2d_view f = sph2d_sim_fluid(sim);
    ck_assert_uint_eq(f.count, count);
    for (size_t i = 0; i < f.count; ++i)
        ck_assert(!sph2d__wall_fills(&scene, &sim->world.walls[SPH2D__WALL_OBSTACLE], (sph2d_vec2){f.x[i], f.y[i]}) &&
                  f.y[i] > 0.1);
    double weight = 9.81 * sim->system.mass * (double)count;
    double mean = (impulse + sph2d_sim_summary(sim).momentum[1]) / time; /* some of it still falls or sloshes */
    ck_assert_msg(fabs(mean / -weight - 1) < 1e-3, "%g", mean / -weight);
    ck_assert_double_lt(sph2d_sim_summary(sim).speed_max, _i == 2 ? 0.4 : 0.2);
    sph2d_sim_destroy(sim);
}
END_TEST

/** Its layers are around it, as thick as those of other walls. */
START_TEST(layers_of_a_hollow_obstacle_are_around_it)
{
    start_couette();
    obstacles[0].shape = (sph2d_shape){.kind = SPH2D_SHAPE_BOX, .box = {{-0.4, -0.4}, {0.4, 0.2}}};
    scene.obstacle_count = 1;
    scene.probe_count = 1;
    block = test_block(-0.4, -0.4, 0.4, 0);
    sph2d_sim *sim = test_create(&scene, NULL);
    const sph2d__store *w = &sim->system.walls;
    double area = 0, thick = 4 * 0.025;
    for (size_t i = 0; i < w->count; ++i) {
        double out = fmax(fmax(-0.4 - w->x[i], w->x[i] - 0.4), fmax(-0.4 - w->y[i], w->y[i] - 0.2));
        ck_assert_double_gt(out, 0.4 * 0.025);
        ck_assert_double_lt(out, thick);
        ck_assert_double_lt(w->normal_x[i] * w->x[i] + w->normal_y[i] * (w->y[i] + 0.1), 0); /* inwards */
        area += w->mass[i] / scene.fluid.density;
    }
    ck_assert_double_eq_tol(area, 2 * (0.8 + 0.6) * thick + 4 * thick * thick, 0.1 * thick);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(a_line_has_no_inside)
{
    static const sph2d_vec2 ends[] = {{0, 0}, {0.1, 0.1}};
    sph2d_report report = {0};
    start_couette();
    obstacles[1].shape = (sph2d_shape){.kind = SPH2D_SHAPE_LINE, .points = {ends, 2}};
    obstacles[1].liquid = SPH2D_LIQUID_INSIDE;
    ck_assert_int_eq(sph2d_scene_check(&scene, &report), SPH2D_SCENE);
    ck_assert_str_eq(report.items[0].path, "obstacles[1].liquid");
    sph2d_report_clear(&report);
}
END_TEST

Suite *suite_turning(void)
{
    Suite *suite = suite_create("turning");
    TCase *tests = tcase_create("turning");
    tcase_add_test(tests, layers_of_a_hollow_obstacle_are_around_it);
    tcase_add_test(tests, a_line_has_no_inside);
    suite_add_tcase(suite, tests);
    TCase *slow = test_long(suite);
    tcase_add_loop_test(slow, liquid_between_circles_that_turn, 0, 3);
    tcase_add_loop_test(slow, a_hollow_obstacle_holds_water, 0, 3);
    return suite;
}
