/* SPDX-License-Identifier: MIT */
/** @file test_slip.c
 *  Walls that differ in their slip: channels with one rough wall and another one, what walls tell of forces, and what
 *  is refused. */
#include <math.h>
#include <string.h>

#include "common.h"
#include "sim/simulation.h"

static sph2d_scene scene;
static sph2d_block block;
static sph2d_obstacle obstacle;
static sph2d_probe probes[2];

static const double RHO = 1000, DX = 0.05, WIDTH = 0.6, DEPTH = 1;

/** A channel between walls below and above, periodic along x, with nu = 1 m^2/s, and the forces on both walls. */
static void channel(void)
{
    scene = test_scene(DX, 0, 0, WIDTH, DEPTH);
    scene.boundary.left = scene.boundary.right = SPH2D_SIDE_PERIODIC;
    scene.method = sph2d_scene_default().method;
    scene.method.sound_speed = 20;
    scene.fluid.density = RHO;
    scene.fluid.dynamic_viscosity = RHO;
    block = test_block(0, 0, WIDTH, DEPTH);
    scene.blocks = &block;
    scene.block_count = 1;
    for (int k = 0; k < 2; ++k) {
        probes[k] = sph2d_probe_default();
        probes[k].kind = SPH2D_PROBE_FORCE;
        probes[k].name = probes[k].on = k ? "top" : "bottom";
        probes[k].rate.every = 0.1;
    }
    scene.probes = probes;
    scene.probe_count = 2;
}

/** Largest error of vx against a profile of the height, in parts of the largest speed, 1. */
static double profile_error(const sph2d_sim *sim, double (*profile)(double y))
{
    const sph2d__store *f = &sim->system.fluid;
    double worst = 0;
    for (size_t i = 0; i < f->count; ++i)
        worst = fmax(worst, fabs(f->vx[i] - profile(f->y[i])));
    return worst;
}

static void run_to(sph2d_sim *sim, double time)
{
    while (sph2d_sim_time(sim) < time)
        test_steps(sim, 20);
}

/** Friction on a wall along x [N/m]. */
static double friction_on(sph2d_sim *sim, size_t probe)
{
    double values[SPH2D_PROBE_MAX_COLUMNS];
    ck_assert(sph2d_sim_probe(sim, probe, values));
    return values[5];
}

/* ---- channels ---------------------------------------------------------------------------------------------------- */

static double half_parabola(double y)
{
    return y / DEPTH * (2 - y / DEPTH);
}

static double half_parabola_from_above(double y)
{
    return half_parabola(DEPTH - y);
}

/** Poiseuille flow is symmetric about its middle, where there is no stress: between a wall without slip and one with
 *  free slip it is one half (Batchelor, An Introduction to Fluid Dynamics, section 4.2). The rough wall carries the
 *  whole weight. By the slips of sides, of the scene and a side, and of a floor that is an obstacle. */
START_TEST(half_a_channel_between_a_rough_and_a_free_wall)
{
    channel();
    scene.gravity = (sph2d_vec2){2, 0};
    size_t rough = _i == 1;
    if (_i == 0) {
        scene.side_slip.bottom = SPH2D_WALL_SLIP_NONE;
    } else if (_i == 1) {
        scene.wall_slip = SPH2D_SLIP_NONE;
        scene.side_slip.bottom = SPH2D_WALL_SLIP_FREE;
    } else {
        obstacle = sph2d_obstacle_default();
        static const sph2d_vec2 ends[2] = {{0, 0}, {0.6, 0}};
        obstacle.shape = (sph2d_shape){.kind = SPH2D_SHAPE_LINE, .points = {ends, 2}};
        obstacle.name = probes[0].on = "floor";
        obstacle.slip = SPH2D_WALL_SLIP_NONE;
        scene.domain.min.y = -4 * DX;
        scene.obstacles = &obstacle;
        scene.obstacle_count = 1;
    }
    sph2d_sim *sim = test_create(&scene, NULL);
    run_to(sim, 3);
    double error = profile_error(sim, rough ? half_parabola_from_above : half_parabola);
    ck_assert_msg(error < 0.01, "%g", error);
    double weight = 2 * RHO * WIDTH * DEPTH;
    ck_assert_double_eq_tol(friction_on(sim, rough) / weight, 1, 0.003);
    ck_assert_double_eq(friction_on(sim, !rough), 0);
    sph2d_sim_destroy(sim);
}
END_TEST

static const double SLIP = 0.5;

static double slipping_couette(double y)
{
    return 1 - y / (DEPTH + SLIP);
}

/** A belt without slip below a smooth wall with a slip length: u = U (1 - y/(D + L)), by which mu U/(D + L) is the
 *  stress on both. */
START_TEST(a_belt_below_a_smooth_wall)
{
    channel();
    scene.wall_slip = SPH2D_SLIP_NONE;
    scene.side_slip.top = SPH2D_WALL_SLIP_SMOOTH;
    scene.slip_length = SLIP;
    scene.wall_speeds.bottom = 1;
    sph2d_sim *sim = test_create(&scene, NULL);
    run_to(sim, 3);
    double error = profile_error(sim, slipping_couette), drag = RHO * WIDTH / (DEPTH + SLIP);
    ck_assert_msg(error < 0.01, "%g", error);
    ck_assert_double_eq_tol(friction_on(sim, 0) / -drag, 1, 0.01);
    ck_assert_double_eq_tol(friction_on(sim, 1) / drag, 1, 0.01);
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- forces ------------------------------------------------------------------------------------------------------ */

/** Liquid that strikes a disc: a rough one, in a tank with a smooth floor and free sides. */
static void splash(void)
{
    scene = test_scene(DX, 0, 0, 1.5, 1.5);
    scene.boundary.top = SPH2D_SIDE_OPEN;
    scene.method = sph2d_scene_default().method;
    scene.method.sound_speed = 20;
    scene.fluid.dynamic_viscosity = 2;
    scene.side_slip.bottom = SPH2D_WALL_SLIP_SMOOTH;
    obstacle = sph2d_obstacle_default();
    obstacle.shape = (sph2d_shape){.kind = SPH2D_SHAPE_CIRCLE, .circle = {{0.6, 0.5}, 0.2}};
    obstacle.slip = SPH2D_WALL_SLIP_NONE;
    scene.obstacles = &obstacle;
    scene.obstacle_count = 1;
    block = test_block(0.2, 0, 1.2, 1.1);
    block.velocity = (sph2d_vec2){0.7, -0.9};
    scene.blocks = &block;
    scene.block_count = 1;
}

/** What the walls tell is what the liquid gets, and each kind of wall tells of its own friction alone. */
START_TEST(walls_of_three_kinds_tell_the_force_that_liquid_gets)
{
    static const char *const names[] = {"disc", "bottom", "left"};
    sph2d_probe on[3];
    splash();
    obstacle.name = names[0];
    for (int k = 0; k < 3; ++k) {
        on[k] = sph2d_probe_default();
        on[k].kind = SPH2D_PROBE_FORCE;
        on[k].name = on[k].on = names[k];
        on[k].rate.every = 1;
    }
    scene.probes = on;
    scene.probe_count = 3;
    sph2d_sim *sim = test_create(&scene, NULL);
    double rubbed[3] = {0};
    for (int step = 0; step < 20; ++step) {
        test_steps(sim, 1);
        for (size_t k = 0; k < 3; ++k)
            rubbed[k] = fmax(rubbed[k], fabs(friction_on(sim, k)));
    }
    const sph2d_summary s = sph2d_sim_summary(sim);
    ck_assert_double_gt(rubbed[0], 0.5);
    ck_assert_double_gt(rubbed[1], 0.5);
    ck_assert_double_eq(rubbed[2], 0);
    ck_assert_double_le(s.momentum_error_max, 1e-8 * s.momentum_moved);
    sph2d_sim_destroy(sim);
}
END_TEST

/** Walls that all have the same slip by themselves are those of a scene with it, bit by bit. */
START_TEST(slips_that_are_alike_are_that_of_the_scene)
{
    sph2d_sim *sims[2];
    for (int k = 0; k < 2; ++k) {
        splash();
        scene.side_slip = (sph2d_side_slips){0};
        obstacle.slip = SPH2D_WALL_SLIP_DEFAULT;
        if (k) {
            sph2d_wall_slip slip = (sph2d_wall_slip)(_i + 1);
            scene.wall_slip = (sph2d_slip)((_i + 1) % 3);
            scene.side_slip = (sph2d_side_slips){slip, slip, slip, SPH2D_WALL_SLIP_DEFAULT};
            obstacle.slip = slip;
        } else {
            scene.wall_slip = (sph2d_slip)_i;
        }
        sims[k] = test_create(&scene, NULL);
        test_steps(sims[k], 30);
    }
    sph2d_view a = sph2d_sim_fluid(sims[0]), b = sph2d_sim_fluid(sims[1]);
    ck_assert_uint_eq(a.count, b.count);
    ck_assert_mem_eq(a.vx, b.vx, a.count * sizeof *a.vx);
    ck_assert_mem_eq(a.y, b.y, a.count * sizeof *a.y);
    sph2d_sim_destroy(sims[0]);
    sph2d_sim_destroy(sims[1]);
}
END_TEST

/** In the corner of a rough floor and a free side the floor goes on, as in a mirror; in one of a smooth floor and a
 *  rough side the side does. */
START_TEST(in_corners_the_rougher_wall_goes_on)
{
    splash();
    scene.side_slip = (sph2d_side_slips){.left = SPH2D_WALL_SLIP_NONE, .bottom = _i ? 0 : SPH2D_WALL_SLIP_SMOOTH};
    sph2d_sim *sim = test_create(&scene, NULL);
    const sph2d__store *w = &sim->system.walls;
    int corners[2] = {0};
    for (size_t b = 0; b < w->count; ++b) {
        if (w->y[b] > 0 || (w->x[b] > 0 && w->x[b] < 1.5))
            continue;
        bool left = w->x[b] < 0;
        sph2d_slip expected = left ? SPH2D_SLIP_NONE : _i ? SPH2D_SLIP_FREE : SPH2D_SLIP_SMOOTH;
        ck_assert_int_eq(sph2d__slip_of(&sim->system, b), expected);
        ++corners[left];
    }
    ck_assert_int_gt(corners[0], 4);
    ck_assert_int_eq(corners[0], corners[1]);
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- checks ------------------------------------------------------------------------------------------------------ */

/** What is set, where it is refused, and why. */
#define REFUSALS(X)                                                                                                    \
    X("side_slip.left", CONFLICT, scene.boundary.left = scene.boundary.right = SPH2D_SIDE_PERIODIC;                    \
      scene.side_slip.left = SPH2D_WALL_SLIP_NONE)                                                                     \
    X("side_slip.top", CONFLICT, scene.side_slip.top = SPH2D_WALL_SLIP_SMOOTH)                                         \
    X("side_slip.bottom", UNSUPPORTED, scene.method.name = SPH2D_METHOD_PCISPH)                                        \
    X("side_slip.bottom", UNSUPPORTED, scene.method.name = SPH2D_METHOD_MULLER)                                        \
    X("side_slip.bottom", UNSUPPORTED, scene.method.operators = SPH2D_OPERATORS_FITTED)                                \
    X("obstacles[0].slip", UNSUPPORTED, scene.method.operators = SPH2D_OPERATORS_FITTED;                               \
      obstacle.slip = SPH2D_WALL_SLIP_FREE)                                                                            \
    X("wall_speeds", CONFLICT, scene.wall_slip = SPH2D_SLIP_NONE; scene.side_slip.left = SPH2D_WALL_SLIP_FREE;         \
      scene.wall_speeds.left = 1)                                                                                      \
    X("slip_length", CONFLICT, scene.side_slip.bottom = SPH2D_WALL_SLIP_NONE; scene.slip_length = 0.1)                 \
    X("obstacles[0].slip", OUT_OF_RANGE, obstacle.slip = (sph2d_wall_slip)4)

#define NUMBER(at, code, what) +1
enum { REFUSED = 0 REFUSALS(NUMBER) };

START_TEST(what_cannot_work_is_refused)
{
    sph2d_report report = {0};
    int k = 0;
#define REFUSE(at, code, what)                                                                                         \
    if (k++ == _i) {                                                                                                   \
        splash();                                                                                                      \
        what;                                                                                                          \
        ck_assert_int_eq(sph2d_scene_check(&scene, &report), SPH2D_SCENE);                                             \
        ck_assert_msg(test_report_has(&report, SPH2D_CODE_##code, at), "%s: %s", at, test_report_text(&report));       \
    }
    REFUSALS(REFUSE)
    sph2d_report_clear(&report);
}
END_TEST

/** Fitted operators take walls that are all rough by themselves, and hybrid those that are all free. */
START_TEST(what_works_is_taken)
{
    sph2d_report report = {0};
    channel();
    scene.probe_count = 0;
    if (_i == 0) {
        scene.method = sph2d_scene_default().method;
        scene.method.operators = SPH2D_OPERATORS_FITTED;
        scene.side_slip.bottom = scene.side_slip.top = SPH2D_WALL_SLIP_NONE;
        scene.wall_speeds.top = 1;
    } else {
        scene.method = sph2d_scene_default().method;
        scene.method.name = SPH2D_METHOD_HYBRID;
        scene.gravity.y = -9.81;
        scene.side_slip.bottom = SPH2D_WALL_SLIP_FREE;
    }
    ck_assert_msg(sph2d_scene_check(&scene, &report) == SPH2D_OK, "%s", test_report_text(&report));
    sph2d_report_clear(&report);
}
END_TEST

Suite *suite_slip(void)
{
    Suite *suite = suite_create("slip");
    TCase *flows = tcase_create("flows"), *checks = tcase_create("checks");
    tcase_add_test(flows, walls_of_three_kinds_tell_the_force_that_liquid_gets);
    tcase_add_loop_test(flows, in_corners_the_rougher_wall_goes_on, 0, 2);
    tcase_add_loop_test(checks, what_cannot_work_is_refused, 0, REFUSED);
    tcase_add_loop_test(checks, what_works_is_taken, 0, 2);
    suite_add_tcase(suite, flows);
    TCase *slow = test_long(suite);
    tcase_add_loop_test(slow, half_a_channel_between_a_rough_and_a_free_wall, 0, 3);
    tcase_add_test(slow, a_belt_below_a_smooth_wall);
    tcase_add_loop_test(slow, slips_that_are_alike_are_that_of_the_scene, 0, 3);
    suite_add_tcase(suite, checks);
    return suite;
}
