/* SPDX-License-Identifier: MIT */
/** @file test_momentum.c
 *  The momentum balance: closed to rounding where forces are equal and opposite, whatever walls, bodies and forces do;
 *  what comes from nothing is told, and stops a run. And pairs of particles that act as one are counted. */
#include <math.h>

#include "common.h"
#include "sim/simulation.h"

/* What a block meets that is thrown into a closed box. */
enum { BOX, OBSTACLE, MOVING, BODY, TURNING, PULLED, TENSE, THINGS };

static const sph2d_method methods[] = {SPH2D_METHOD_MULLER, SPH2D_METHOD_WCSPH, SPH2D_METHOD_PCISPH,
                                       SPH2D_METHOD_CONSTRAINT};
enum { METHODS = sizeof methods / sizeof *methods };

static struct {
    sph2d_scene scene;
    sph2d_block block;
    sph2d_obstacle obstacle;
    sph2d_body body;
    sph2d_interaction pull;
} box;

static const sph2d_path_point middle = {0, 0.5, 0.5};

static void start_box(int method, int thing)
{
    box.scene = test_scene(0.04, 0, 0, 1, 1);
    box.scene.method.name = methods[method];
    box.scene.method.stiffness = 0;
    box.scene.gravity = (sph2d_vec2){1, -9.81};
    box.scene.fluid.dynamic_viscosity = 1;
    box.block = test_block(0.28, 0.28, 0.72, 0.72);
    box.block.velocity = (sph2d_vec2){1.5, 0.5};
    box.scene.blocks = &box.block;
    box.scene.block_count = 1;
    box.obstacle = sph2d_obstacle_default();
    box.obstacle.shape = (sph2d_shape){.kind = SPH2D_SHAPE_BOX, .box = {{0.8, 0}, {0.92, 0.2}}};
    if (thing == MOVING) {
        box.obstacle.motion.amplitude = (sph2d_vec2){0.04, 0};
        box.obstacle.motion.frequency = 2;
    }
    box.scene.obstacles = &box.obstacle;
    box.scene.obstacle_count = thing == OBSTACLE || thing == MOVING;
    box.body = sph2d_body_default();
    box.body.shape = (sph2d_shape){.kind = SPH2D_SHAPE_BOX, .box = {{0.44, 0.8}, {0.56, 0.92}}};
    box.body.density = 600;
    box.scene.bodies = &box.body;
    box.scene.body_count = thing == BODY;
    box.pull = sph2d_interaction_default();
    box.pull.path = (sph2d_path){&middle, 1};
    box.pull.radius = 0.4;
    box.pull.acceleration = 20;
    box.scene.interactions = &box.pull;
    box.scene.interaction_count = thing == PULLED;
    box.scene.motion.rate = thing == TURNING ? 1 : 0;
    box.scene.fluid.surface_tension = thing == TENSE ? 0.5 : 0;
}

static sph2d_summary run_until(sph2d_sim *sim, double time)
{
    while (sph2d_sim_time(sim) < time)
        test_steps(sim, 1);
    return sph2d_sim_summary(sim);
}

START_TEST(momentum_comes_from_walls_bodies_and_forces_alone)
{
    start_box(_i % METHODS, _i / METHODS);
    sph2d_sim *sim = test_create(&box.scene, NULL);
    const double m = sim->system.mass * (double)sph2d_sim_fluid(sim).count;
    const sph2d_summary s = run_until(sim, 0.35);
    ck_assert_double_ge(s.momentum_moved, 0.99 * m * hypot(1.5, 0.5));
    ck_assert_double_gt(s.momentum_error_max, 0); /* it was looked at */
    /* Coriolis' force and that of a pull change within a step, pressure of a projection acts in its middle. */
    const double bound = _i / METHODS == TURNING || _i / METHODS == PULLED ? 0.01 : 1e-8;
    ck_assert_msg(s.momentum_error_max <= bound * s.momentum_moved, "%g of %g kg/s", s.momentum_error_max,
                  s.momentum_moved);
    sph2d_sim_destroy(sim);
}
END_TEST

/** Walls that push back by more than the liquid pushes them. */
static const sph2d__method *honest;
static double excess;
static sph2d__wall_force more(const sph2d__system *s, size_t i, size_t b, double dx, double dy)
{
    sph2d__wall_force f = honest->wall_force(s, i, b, dx, dy);
    f.pressure.x *= 1 + excess;
    f.pressure.y *= 1 + excess;
    return f;
}

START_TEST(momentum_from_nothing_is_told_and_bounded)
{
    start_box(2, BOX);
    box.block = test_block(0, 0, 1, 0.4);
    box.scene.gravity.x = 0;
    sph2d_sim *sim = test_create(&box.scene, NULL);
    sph2d__method method = *sim->method;
    honest = sim->method;
    method.wall_force = more;
    sim->method = &method;
    excess = 0.01;
    const sph2d_summary s = run_until(sim, 1);
    /* The walls bear the weight, and the liquid did not get the hundredth: it is missing. */
    const double borne = 9.81 * sim->system.mass * (double)s.particles * s.time;
    ck_assert_double_eq_tol(s.momentum_error[0], 0, 0.0002 * borne);
    ck_assert_double_eq_tol(s.momentum_error[1], -0.01 * borne, 0.001 * borne);
    ck_assert_double_ge(s.momentum_error_max, fabs(s.momentum_error[1]));
    excess = 0.5;
    sph2d_report report = {0};
    while (sph2d_sim_time(sim) < 2 && sph2d_sim_step(sim, &report) == SPH2D_OK)
        ;
    ck_assert_msg(test_report_has(&report, SPH2D_CODE_MOMENTUM, NULL), "%s", test_report_text(&report));
    sph2d_report_clear(&report);
    sim->method = honest;
    sph2d_sim_destroy(sim);
}
END_TEST

/** Particles that come before every step do not hide it. */
START_TEST(momentum_from_nothing_is_seen_while_particles_come)
{
    start_box(2, BOX);
    box.block = test_block(0, 0, 1, 0.4);
    sph2d_sim *sim = test_create(&box.scene, NULL);
    sph2d__method method = *sim->method;
    honest = sim->method;
    method.wall_force = more;
    sim->method = &method;
    excess = 0.5;
    sph2d_report report = {0};
    sph2d_status status = SPH2D_OK;
    for (int k = 0; k < 64 && status == SPH2D_OK; ++k) {
        const sph2d_particle drop = {0.1 + 0.1 * (k % 8), 0.5 + 0.05 * (k / 8), 0, 0, 0, 0};
        ck_assert_int_eq(sph2d_sim_add_particles(sim, &drop, 1, NULL), SPH2D_OK);
        status = sph2d_sim_step(sim, &report);
    }
    ck_assert_msg(test_report_has(&report, SPH2D_CODE_MOMENTUM, NULL), "%s", test_report_text(&report));
    sph2d_report_clear(&report);
    sim->method = honest;
    sph2d_sim_destroy(sim);
}
END_TEST

/** Liquid that is taken away takes its momentum with it; what it and walls did to each other before is no error. */
START_TEST(liquid_that_is_taken_away_is_no_error)
{
    const sph2d_shape right = {.kind = SPH2D_SHAPE_BOX, .box = {{0.5, -1}, {2, 2}}},
                      all = {.kind = SPH2D_SHAPE_BOX, .box = {{-1, -1}, {2, 2}}};
    start_box(_i, BOX);
    box.block = test_block(0, 0, 1, 0.4);
    for (int before = 0; before < 17; before += 4) { /* the balance of some methods looks at one step of 8 */
        size_t removed;
        sph2d_sim *sim = test_create(&box.scene, NULL);
        test_steps(sim, before);
        ck_assert_int_eq(sph2d_sim_remove_particles(sim, before == 8 ? &right : &all, &removed), SPH2D_OK);
        ck_assert_uint_gt(removed, 0);
        test_steps(sim, 20);
        const sph2d_summary s = sph2d_sim_summary(sim);
        ck_assert_double_le(s.momentum_error_max, 1e-8 * fmax(s.momentum_moved, 1));
        sph2d_sim_destroy(sim);
    }
}
END_TEST

START_TEST(fitted_operators_have_no_balance_of_momentum)
{
    start_box(2, BOX);
    box.block = test_block(0, 0, 1, 1);
    sph2d_method_options fitted = sph2d_scene_default().method;
    fitted.name = SPH2D_METHOD_WCSPH;
    fitted.operators = SPH2D_OPERATORS_FITTED;
    fitted.sound_speed = 10;
    box.scene.method = fitted;
    box.scene.wall_slip = SPH2D_SLIP_NONE;
    sph2d_sim *sim = test_create(&box.scene, NULL);
    test_steps(sim, 3);
    const sph2d_summary s = sph2d_sim_summary(sim);
    ck_assert(isnan(s.momentum_error[0]) && isnan(s.momentum_error[1]) && isnan(s.momentum_error_max));
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(particles_in_one_place_are_counted)
{
    sph2d_scene scene = test_open_scene(0.1, 0, 0, 2, 1);
    const double x[] = {0.2, 0.229, 0.6, 0.631, 1.2, 1.2, 1.215};
    sph2d_particle particles[7];
    for (int i = 0; i < 7; ++i)
        particles[i] = (sph2d_particle){x[i], i == 5 ? 0.51 : 0.5, 0, 0, 1000, 0};
    scene.particles = (sph2d_particles){NULL, particles, 7};
    sph2d_sim *sim = test_create(&scene, NULL);
    ck_assert_uint_eq(sph2d_sim_summary(sim).paired, 5); /* 0.29 spacings are near, 0.31 are not */
    sph2d_sim_destroy(sim);
}
END_TEST

Suite *suite_momentum(void)
{
    Suite *suite = suite_create("momentum");
    TCase *tests = tcase_create("momentum");
    tcase_add_loop_test(tests, momentum_comes_from_walls_bodies_and_forces_alone, 0, METHODS * THINGS);
    tcase_add_test(tests, momentum_from_nothing_is_told_and_bounded);
    tcase_add_test(tests, momentum_from_nothing_is_seen_while_particles_come);
    tcase_add_loop_test(tests, liquid_that_is_taken_away_is_no_error, 0, METHODS);
    tcase_add_test(tests, fitted_operators_have_no_balance_of_momentum);
    tcase_add_test(tests, particles_in_one_place_are_counted);
    suite_add_tcase(suite, tests);
    return suite;
}
