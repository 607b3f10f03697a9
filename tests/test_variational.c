/* SPDX-License-Identifier: MIT */
/** @file test_variational.c
 *  Method `wcsph` with variational operators: what is exact for linear velocities, the balances of energy and momentum,
 *  waves and drops that keep their height, viscosity, walls, the same bits. */
#include <math.h>
#include <string.h>

#include "common.h"
#include "sim/simulation.h"

static const double G = 9.81, DX = 0.05;

static struct {
    sph2d_scene scene;
    sph2d_block blocks[2];
    sph2d_obstacle obstacle;
    sph2d_probe probe;
    sph2d_sim *sim;
} pool;

/** Lays out a domain [0, width] x [0, height], open at the top, of water with gravity. */
static void lay_out(double dx, double width, double height, double viscosity)
{
    memset(&pool, 0, sizeof pool);
    pool.scene = sph2d_scene_default();
    pool.scene.domain = (sph2d_box){{0, 0}, {width, height}};
    pool.scene.spacing = dx;
    pool.scene.method.operators = SPH2D_OPERATORS_VARIATIONAL;
    pool.scene.fluid.dynamic_viscosity = viscosity;
    pool.scene.blocks = pool.blocks;
}

static sph2d_block *add(double x0, double y0, double x1, double y1)
{
    sph2d_block *block = &pool.blocks[pool.scene.block_count++];
    *block = test_block(x0, y0, x1, y1);
    return block;
}

static void open_all(void)
{
    pool.scene.boundary = (sph2d_boundary){SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN};
    pool.scene.gravity = (sph2d_vec2){0, 0};
}

static void start(void)
{
    pool.sim = test_create(&pool.scene, NULL);
}

static sph2d_summary run_until(double time)
{
    while (sph2d_sim_time(pool.sim) < time)
        test_steps(pool.sim, 1);
    return sph2d_sim_summary(pool.sim);
}

/* ---- what is exact ----------------------------------------------------------------------------------------------- */

/** Inside a disordered square of liquid in pure strain density does not change; by the plain sum of the same pairs it
 *  would by up to a fifth of the strain; some 0.01 is relaxation, which what the surface dissipates pays for. Dissipation
 *  sees nothing in it. */
START_TEST(linear_velocities_have_their_exact_rate)
{
    lay_out(DX, 2, 2, 0);
    open_all();
    pool.scene.method.sound_speed = 20;
    sph2d_block *block = add(0.5, 0.5, 1.5, 1.5);
    block->perturb.amplitude = 0.15;
    block->perturb.seed = 3;
    block->start.flow = (sph2d_flow){SPH2D_FLOW_STRAIN, .speed = 10, .length = 1, .center = {1, 1}};
    pool.scene.method.time_step = 1e-5;
    start();
    const sph2d__store *f = &pool.sim->system.fluid;
    for (size_t i = 0; i < f->count; ++i) { /* the flow's own pressure would move it */
        f->density[i] = pool.sim->system.rest_density;
        f->log_density[i] = 0;
    }
    test_steps(pool.sim, 1);
    for (size_t i = 0; i < f->count; ++i)
        ck_assert_msg(fmax(fabs(f->x[i] - 1), fabs(f->y[i] - 1)) > 0.5 - 3 * DX || fabs(f->log_density[i]) < 2e-6,
                      "rate %g of the strain at (%g, %g)", f->log_density[i] / 1e-4, f->x[i], f->y[i]);
    ck_assert_double_le(fabs(pool.sim->record.energy_pressed), 1e-3); /* by rates at the surface: 100 J/(m s) in all */
    sph2d_sim_destroy(pool.sim);
}
END_TEST

/* ---- balances ---------------------------------------------------------------------------------------------------- */

/** A block falls on liquid around an obstacle that is at rest or shaken, in a closed box. */
START_TEST(energy_and_momentum_are_kept_to_rounding)
{
    lay_out(DX, 2, 1.5, _i == 2 ? 5 : 0);
    pool.scene.boundary.top = SPH2D_SIDE_WALL;
    add(0, 0, 2, 0.5);
    add(0.3, 0.8, 0.8, 1.3)->velocity.x = 1;
    pool.obstacle = sph2d_obstacle_default();
    pool.obstacle.shape = (sph2d_shape){.kind = SPH2D_SHAPE_CIRCLE, .circle = {.center = {1.3, 0.6}, .radius = 0.25}};
    if (_i == 1) {
        pool.obstacle.motion.amplitude = (sph2d_vec2){0.1, 0};
        pool.obstacle.motion.frequency = 1;
    }
    pool.scene.obstacles = &pool.obstacle;
    pool.scene.obstacle_count = 1;
    start();
    const sph2d_summary s = run_until(0.8);
    const sph2d__record *r = &pool.sim->record;
    ck_assert_double_le(fabs(s.energy_error), 1e-7 * sph2d__sim_energy_scale(pool.sim));
    ck_assert_double_le(s.momentum_error_max, 1e-9 * s.momentum_moved);
    ck_assert(_i != 1 || fabs(r->energy_walls) > 1);
    ck_assert(_i != 2 || r->energy_viscous > 10);
    ck_assert_double_gt(r->energy_pressed, 10); /* an impact dissipates */
    sph2d_sim_destroy(pool.sim);
}
END_TEST

/* ---- known motions ----------------------------------------------------------------------------------------------- */

/** Half the range of the first mode cos(pi x/2 m) of the liquid over the period before `time`. */
static double mode_until(double time, double period)
{
    double low = INFINITY, high = -INFINITY;
    while (sph2d_sim_time(pool.sim) < time) {
        test_steps(pool.sim, 1);
        const sph2d__store *f = &pool.sim->system.fluid;
        double sum = 0;
        for (size_t i = 0; i < f->count; ++i)
            sum += cos(TEST_PI * f->x[i]);
        if (sph2d_sim_time(pool.sim) > time - period) {
            low = fmin(low, sum);
            high = fmax(high, sum);
        }
    }
    return (high - low) / 2;
}

/** 20 spacings deep, amplitude a tenth of the depth; an ideal liquid keeps all. */
START_TEST(a_standing_wave_keeps_its_height)
{
    lay_out(DX, 2, 1.5, 0);
    add(0, 0, 2, 1)->start.flow =
        (sph2d_flow){SPH2D_FLOW_STANDING_WAVE, .speed = 0.554, .length = 2, .depth = 1, .center = {0, 1}};
    start();
    const double period = 2 * TEST_PI / sqrt(G * TEST_PI * tanh(TEST_PI));
    const double first = mode_until(period, period), last = mode_until(6 * period, period);
    ck_assert_double_ge(last, 0.98 * first);
    ck_assert_double_le(last, 1.02 * first);
    sph2d_sim_destroy(pool.sim);
}
END_TEST

/** A drop in a central force oscillates as an ellipse (Monaghan & Rafiee 2013): of its energy at the start at most
 *  0.5 % of the kinetic is lost in two periods. */
START_TEST(a_drop_in_a_central_force_goes_on)
{
    lay_out(0.08, 4, 4, 0);
    open_all();
    pool.scene.central_force.center = (sph2d_vec2){2, 2};
    pool.scene.central_force.rate = 1;
    pool.scene.method.sound_speed = 15;
    sph2d_block *block = add(0, 0, 0, 0);
    block->shape.kind = SPH2D_SHAPE_CIRCLE;
    block->shape.circle.center = (sph2d_vec2){2, 2};
    block->shape.circle.radius = 1;
    block->start.flow = (sph2d_flow){SPH2D_FLOW_STRAIN, .speed = 0.5, .length = 1, .center = {2, 2}};
    start();
    const sph2d_summary before = sph2d_sim_summary(pool.sim);
    const sph2d_summary after = run_until(2 * 4.567374);
    const double lost = before.kinetic + before.potential - after.kinetic - after.potential;
    ck_assert_double_le(lost, 0.02 * before.kinetic);
    ck_assert_double_ge(lost, -0.005 * before.kinetic);
    sph2d_sim_destroy(pool.sim);
}
END_TEST

/** Water in a corner between two mirrors, with its surface at 45 degrees to the lattice. Without a bound of how uneven B is
 *  it shrinks, and what it falls drives it: 16 J/m after 12.5 s, and 1.9 % of its volume after 30 s; now 0.02 J/m. */
START_TEST(a_corner_full_comes_to_rest)
{
    sph2d_vec2 corners[] = {{0, 0}, {sqrt(2), 0}, {0, sqrt(2)}};
    lay_out(DX, 1.7, 1.7, 0.001);
    pool.scene.gravity = (sph2d_vec2){-G / sqrt(2), -G / sqrt(2)};
    sph2d_block *block = add(0, 0, 0, 0);
    block->shape = (sph2d_shape){.kind = SPH2D_SHAPE_POLYGON, .points = {corners, 3}};
    block->start = (sph2d_start){.flow = {.kind = SPH2D_FLOW_STILL, .center = {sqrt(0.5), sqrt(0.5)}}};
    start();
    const double before = run_until(0).potential;
    const sph2d_summary s = run_until(12.5);
    ck_assert_double_le(s.kinetic, 0.5);
    ck_assert_double_le(before - s.potential, 3);
    ck_assert_double_le(s.energy_rise, 1e-4 * s.energy_scale);
    sph2d_sim_destroy(pool.sim);
}
END_TEST

/** Shear sin(2 pi y) between periodic sides decays by exp(-nu k^2 t). */
START_TEST(shear_decays_by_its_viscosity)
{
    lay_out(0.02, 1, 1, 50);
    pool.scene.boundary =
        (sph2d_boundary){SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC};
    pool.scene.gravity = (sph2d_vec2){0, 0};
    pool.scene.method.sound_speed = 10;
    add(0, 0, 1, 1);
    start();
    const sph2d__store *f = &pool.sim->system.fluid;
    for (size_t i = 0; i < f->count; ++i)
        f->vx[i] = 0.1 * sin(2 * TEST_PI * f->y[i]);
    double before = 0, after = 0;
    for (size_t i = 0; i < f->count; ++i)
        before += f->vx[i] * sin(2 * TEST_PI * f->y[i]);
    run_until(0.3);
    for (size_t i = 0; i < f->count; ++i)
        after += f->vx[i] * sin(2 * TEST_PI * f->y[i]);
    const double rate = -log(after / before) / sph2d_sim_time(pool.sim), exact = 0.05 * 4 * TEST_PI * TEST_PI;
    ck_assert_double_eq_tol(rate, exact, 0.015 * exact);
    sph2d_sim_destroy(pool.sim);
}
END_TEST

/** Liquid that falls between an obstacle and the sides is held by them: a guard hardly stops any of it, 3.2 of 10,000
 *  particles a step (known weakness: at the edges), where it stopped 2 in 1000 without images. */
START_TEST(walls_hold_by_themselves)
{
    lay_out(0.02, 1, 1, 0);
    add(0, 0, 0.4, 0.6);
    pool.obstacle = sph2d_obstacle_default();
    pool.obstacle.shape = (sph2d_shape){.kind = SPH2D_SHAPE_BOX, .box = {{0.7, 0}, {0.8, 0.2}}};
    pool.scene.obstacles = &pool.obstacle;
    pool.scene.obstacle_count = 1;
    start();
    const sph2d_summary s = run_until(1);
    const double hits = (double)pool.sim->record.backstop_hits;
    ck_assert_double_le(hits, 4e-4 * (double)(pool.sim->record.steps * pool.sim->system.fluid.count));
    ck_assert_double_le(fabs(s.energy_error), 1e-7 * sph2d__sim_energy_scale(pool.sim));
    sph2d_sim_destroy(pool.sim);
}
END_TEST

/* ---- walls, and particles that meet ------------------------------------------------------------------------------ */

/** The floor carries the liquid, and pressure is that of the depth. */
START_TEST(a_tank_carries_its_liquid)
{
    lay_out(DX, 2, 1.5, 20);
    add(0, 0, 2, 1)->start.flow = (sph2d_flow){SPH2D_FLOW_STILL, .depth = 1, .center = {0, 1}};
    pool.probe = sph2d_probe_default();
    pool.probe.kind = SPH2D_PROBE_FORCE;
    pool.probe.name = "floor";
    pool.probe.on = "bottom";
    pool.probe.rate.every = 1;
    pool.scene.probes = &pool.probe;
    pool.scene.probe_count = 1;
    start();
    run_until(4);
    double values[SPH2D_PROBE_MAX_COLUMNS] = {0}, sum = 0;
    int samples = 0;
    for (; samples < 200; ++samples) {
        test_steps(pool.sim, 1);
        ck_assert_uint_ge(sph2d_sim_probe(pool.sim, 0, values), 2);
        sum += values[1];
    }
    ck_assert_double_eq_tol(sum / samples, -2000 * G, 0.02 * 2000 * G);
    const sph2d__store *f = &pool.sim->system.fluid;
    double squares = 0, fastest = 0;
    for (size_t i = 0; i < f->count; ++i) {
        squares += pow(f->pressure[i] / (1000 * G) - (1 - f->y[i]), 2);
        fastest = fmax(fastest, hypot(f->vx[i], f->vy[i]));
        ck_assert_double_gt(f->y[i], 0.2 * DX);
    }
    ck_assert_double_le(sqrt(squares / (double)f->count), 0.01);
    ck_assert_double_le(fastest, 0.02 * sqrt(G));
    sph2d_sim_destroy(pool.sim);
}
END_TEST

/** Two particles at a tenth of the speed of sound come apart again, and nothing is lost that is not booked. */
START_TEST(particles_that_meet_come_apart)
{
    lay_out(DX, 2, 2, 0);
    open_all();
    pool.scene.method.sound_speed = 20;
    *add(0, 0, 0, 0) = test_particle(DX, 0.8, 1, 1, 0);
    *add(0, 0, 0, 0) = test_particle(DX, 1.2, 1.001, -1, 0);
    start();
    const sph2d__store *f = &pool.sim->system.fluid;
    double nearest = INFINITY;
    while (sph2d_sim_time(pool.sim) < 0.6) {
        test_steps(pool.sim, 1);
        nearest = fmin(nearest, hypot(f->x[0] - f->x[1], f->y[0] - f->y[1]));
    }
    ck_assert_double_ge(nearest, 0.1 * DX);
    ck_assert_double_le(fabs(sph2d_sim_summary(pool.sim).energy_error), 1e-7);
    sph2d_sim_destroy(pool.sim);
}
END_TEST

/* ---- bits -------------------------------------------------------------------------------------------------------- */

/** One thread, two, every instruction set: the same bits. */
START_TEST(the_bits_are_always_the_same)
{
    lay_out(0.02, 1, 1, 0);
    add(0, 0, 0.5, 0.8);
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = 1;
    pool.sim = test_create(&pool.scene, &options);
    test_steps(pool.sim, 120);
    static const sph2d_isa sets[] = {SPH2D_ISA_AUTO, SPH2D_ISA_BASELINE, SPH2D_ISA_AVX2, SPH2D_ISA_AVX512};
    for (size_t k = 0; k < sizeof sets / sizeof *sets; ++k) {
        if (k > 1 && !sph2d_isa_available(sets[k]))
            continue;
        options.threads = 2;
        options.isa = sets[k];
        sph2d_sim *other = test_create(&pool.scene, &options);
        test_steps(other, 120);
        const sph2d__store *a = &pool.sim->system.fluid, *b = &other->system.fluid;
        ck_assert_uint_eq(a->count, b->count);
        ck_assert_mem_eq(a->x, b->x, a->count * sizeof *a->x);
        ck_assert_mem_eq(a->vy, b->vy, a->count * sizeof *a->vy);
        ck_assert_mem_eq(a->density, b->density, a->count * sizeof *a->density);
        sph2d_sim_destroy(other);
    }
    sph2d_sim_destroy(pool.sim);
}
END_TEST

Suite *suite_variational(void)
{
    Suite *suite = suite_create("variational");
    TCase *tests = tcase_create("variational");
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, linear_velocities_have_their_exact_rate);
    tcase_add_loop_test(tests, energy_and_momentum_are_kept_to_rounding, 0, 3);
    tcase_add_test(tests, a_standing_wave_keeps_its_height);
    tcase_add_test(tests, a_drop_in_a_central_force_goes_on);
    tcase_add_test(tests, shear_decays_by_its_viscosity);
    tcase_add_test(tests, particles_that_meet_come_apart);
    suite_add_tcase(suite, tests);
    TCase *slow = test_long(suite);
    tcase_set_timeout(slow, 60);
    tcase_add_test(slow, a_corner_full_comes_to_rest);
    tcase_add_test(slow, walls_hold_by_themselves);
    tcase_add_test(slow, a_tank_carries_its_liquid);
    tcase_add_test(slow, the_bits_are_always_the_same);
    return suite;
}
