/* SPDX-License-Identifier: MIT */
/** @file test_tension.c
 *  Surface tension: its force is the gradient of an energy, which is that of perimeters (perimeters.h). */
#include <math.h>

#include "methods/common/method.h"
#include "methods/terms/tension.h"
#include "perimeters.h"
#include "sim/simulation.h"

static const double RHO0 = 1000;

static sph2d_scene scene;
static sph2d_block blocks[2];
static sph2d_sim *sim;

static void start(void)
{
    scene = test_open_scene(DX, -1, -1, 1, 1);
    scene.method = sph2d_scene_default().method;
    scene.method.name = SPH2D_METHOD_WCSPH;
    scene.method.sound_speed = 10;
    scene.fluid.surface_tension = SIGMA;
    blocks[0] = test_block(0, 0, 8 * DX, 6 * DX);
    blocks[0].perturb.amplitude = 0.25;
    scene.blocks = blocks;
    scene.block_count = 1;
}

static void finish(void)
{
    sph2d_sim_destroy(sim);
    sim = NULL;
}

static sph2d__system *make(void)
{
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = 1;
    sim = test_create(&scene, &options);
    return &sim->system;
}

/** The tension's forces alone, in ax and ay. */
static void only_tension(sph2d__system *s)
{
    for (size_t i = 0; i < s->fluid.count; ++i)
        s->fluid.ax[i] = s->fluid.ay[i] = 0;
    sph2d__tension_add(s);
}

/* ---- tests ------------------------------------------------------------------------------------------------------- */

/* muller as it is, which looks less far than two discs are wide; wcsph; wcsph with few neighbours. */
static void choose_method(int i)
{
    if (i == 1)
        scene.method = test_open_scene(DX, -1, -1, 1, 1).method;
    if (i == 2)
        scene.method.support_ratio = 1.5;
}

/** The energy with one coordinate changed by so little that the cells stay as they are. */
static double energy_at(const sph2d__system *s, double *place, double at)
{
    *place = at;
    return sph2d__tension_energy(s);
}

/** How far forces are from -dE/dx by differences, and the largest of those [N/m]. */
static double worst_difference(sph2d__system *s, double *most)
{
    sph2d__store *f = &s->fluid;
    double step = 1e-5 * DX, worst = 0;
    for (size_t i = 0; i < f->count; ++i)
        for (int axis = 0; axis < 2; ++axis) {
            double *place = axis ? &f->y[i] : &f->x[i], at = *place;
            double ahead = energy_at(s, place, at + step), behind = energy_at(s, place, at - step);
            *place = at;
            double force = -(ahead - behind) / (2 * step), got = (axis ? f->ay[i] : f->ax[i]) * s->mass;
            worst = fmax(worst, fabs(got - force));
            *most = fmax(*most, fabs(force));
        }
    return worst;
}

/** For a disordered block and a particle far from it; on a floor, too. */
START_TEST(force_is_the_gradient_of_the_energy)
{
    choose_method(_i);
    if (_i == 3) {
        scene.boundary.bottom = SPH2D_SIDE_WALL;
        blocks[0] = test_block(0, -1, 8 * DX, -1 + 6 * DX);
        blocks[0].perturb.amplitude = 0.25;
    }
    blocks[1] = test_particle(DX, -0.5, -0.5, 0, 0);
    scene.block_count = 2;
    sph2d__system *s = make();
    ck_assert(s->walls_press == (_i == 3));
    only_tension(s);
    double most = 0;
    ck_assert_double_lt(worst_difference(s, &most), 1e-5 * SIGMA);
    ck_assert_double_gt(most, 0.3 * SIGMA);
}
END_TEST

/** Of a block, of two that are about to meet and of one by itself. */
START_TEST(energy_is_that_of_perimeters)
{
    blocks[1] = test_block(-4 * DX, 0, -DX, 3 * DX);
    blocks[1].perturb.amplitude = 0.25;
    scene.block_count = 2;
    sph2d__system *s = make();
    ck_assert_uint_lt(s->fluid.count, MOST);
    double expected = energy_by_perimeters(s->fluid.x, s->fluid.y, s->fluid.count, 400);
    ck_assert_double_eq_tol(sph2d__tension_energy(s), expected, 1e-4 * expected);
    double alone[1] = {0}, whole = energy_by_perimeters(alone, alone, 1, 400);
    finish();
    blocks[0] = test_particle(DX, 0, 0, 0, 0);
    scene.block_count = 1;
    ck_assert_double_eq_tol(sph2d__tension_energy(make()), whole, 1e-4 * whole);
}
END_TEST

/** Loose heaps of particles, in which each place of a cell matters, against perimeters. */
START_TEST(heaps_have_the_energy_of_perimeters)
{
    enum { HEAP = 7 };
    blocks[0] = test_block(0, 0, HEAP * DX, DX);
    blocks[0].perturb.amplitude = 0;
    sph2d__system *s = make();
    sph2d__store *f = &s->fluid;
    ck_assert_uint_eq(f->count, HEAP);
    uint64_t seed = 9;
    for (int heap = 0; heap < 200; ++heap) {
        for (size_t i = 0; i < HEAP; ++i) {
            f->x[i] = test_random(&seed, 0, 6 * DX);
            f->y[i] = test_random(&seed, 0, 6 * DX);
        }
        ck_assert(sph2d__cells_build(&s->fluid_cells, f, s->reach, s->memory));
        double expected = energy_by_perimeters(f->x, f->y, HEAP, 200);
        ck_assert_double_eq_tol(sph2d__tension_energy(s), expected, 1e-3 * expected);
    }
}
END_TEST

/** A particle crosses the way of others, near enough to meet, part, and lie between: the energy has no jump. */
START_TEST(energy_has_no_jumps)
{
    blocks[0].perturb.amplitude = 0.25;
    blocks[1] = test_particle(DX, -0.5, -0.5, 0, 0);
    scene.block_count = 2;
    sph2d__system *s = make();
    sph2d__store *f = &s->fluid;
    uint64_t lone = f->id[0];
    for (size_t i = 0; i < f->count; ++i)
        lone = f->x[i] < -0.4 ? f->id[i] : lone;
    double last = NAN, jump = 0;
    enum { PLACES = 4000 };
    for (int k = 0; k <= PLACES; ++k) {
        for (size_t i = 0; i < f->count; ++i)
            if (f->id[i] == lone) {
                f->x[i] = 0.3 * DX;
                f->y[i] = (-5 + 16.0 * k / PLACES) * DX;
            }
        ck_assert(sph2d__cells_build(&s->fluid_cells, f, s->reach, s->memory));
        double now = sph2d__tension_energy(s);
        jump = fmax(jump, fabs(now - last)); /* passes over NaN */
        last = now;
    }
    ck_assert_double_gt(jump, 0);
    ck_assert_double_lt(jump, 8 * SIGMA * 16 * DX / PLACES); /* no force is larger than 8 sigma */
}
END_TEST

/** Opposite pairs of central forces. */
START_TEST(momentum_and_angular_momentum_are_kept)
{
    choose_method(_i % 3);
    blocks[1] = test_block(10 * DX, 2 * DX, 15 * DX, 5 * DX);
    blocks[1].perturb.amplitude = 0.5; /* loose */
    blocks[1].spacing = 1.05 * DX;
    scene.block_count = 2;
    sph2d__system *s = make();
    only_tension(s);
    double sum[3] = {0};
    for (size_t i = 0; i < s->fluid.count; ++i) {
        sum[0] += s->fluid.ax[i];
        sum[1] += s->fluid.ay[i];
        sum[2] += s->fluid.x[i] * s->fluid.ay[i] - s->fluid.y[i] * s->fluid.ax[i];
    }
    for (int k = 0; k < 3; ++k)
        ck_assert_double_eq_tol(sum[k] * s->mass, 0, 1e-12 * SIGMA);
}
END_TEST

/** A film has two surfaces, even that of a single row. */
START_TEST(a_film_has_two_surfaces)
{
    int rows = _i + 1;
    blocks[0] = test_block(0, 0, 20 * DX, rows * DX);
    sph2d__system *s = make();
    only_tension(s);
    double pull = 0;
    for (size_t i = 0; i < s->fluid.count; ++i) {
        if (s->fluid.x[i] < 10 * DX)
            pull += s->fluid.ax[i] * s->mass;
        if (s->fluid.x[i] > 4 * DX && s->fluid.x[i] < 16 * DX) {
            ck_assert_double_eq_tol(s->fluid.ax[i] * s->mass, 0, 1e-12 * SIGMA);
            ck_assert_double_eq_tol(s->fluid.ay[i] * s->mass, 0, 1e-12 * SIGMA);
        }
    }
    ck_assert_double_eq_tol(pull, 2 * SIGMA * film(), 1e-6 * SIGMA); /* of the right half on the left */
    ck_assert_double_eq_tol(film(), 1, 0.03);
}
END_TEST

/** Half a block on a floor: its surface grows by both ends when it is lifted, so that it is drawn straight down with
 *  sigma a side, by what two rows' energy says. */
START_TEST(a_surface_meets_a_wall_at_a_right_angle)
{
    scene.boundary.bottom = SPH2D_SIDE_WALL;
    blocks[0] = test_block(0, -1, 8 * DX, -1 + 6 * DX);
    if (_i == 2) { /* the same on the left */
        scene.boundary.bottom = SPH2D_SIDE_OPEN;
        scene.boundary.left = SPH2D_SIDE_WALL;
        blocks[0] = test_block(-1, 0, -1 + 6 * DX, 8 * DX);
    }
    blocks[0].perturb.amplitude = 0;
    if (_i == 1) { /* heavy walls are wetted, too */
        scene.method = test_open_scene(DX, -1, -1, 1, 1).method;
        scene.walls = SPH2D_WALL_HEAVY;
    }
    sph2d__system *s = make();
    ck_assert(s->walls_press);
    only_tension(s);
    double sum[2] = {0};
    for (size_t i = 0; i < s->fluid.count; ++i) {
        sum[0] += s->fluid.ax[i] * s->mass;
        sum[1] += s->fluid.ay[i] * s->mass;
    }
    ck_assert_double_eq_tol(sum[0], _i == 2 ? -2 * SIGMA : 0, _i == 2 ? 0.1 * SIGMA : 1e-9 * SIGMA);
    ck_assert_double_eq_tol(sum[1], _i == 2 ? 0 : -2 * SIGMA, _i == 2 ? 1e-9 * SIGMA : 0.1 * SIGMA);
}
END_TEST

/** Obstacles that only reflect do not cover, whatever others there are. */
START_TEST(what_only_reflects_is_no_wall)
{
    sph2d_obstacle obstacles[2] = {sph2d_obstacle_default(), sph2d_obstacle_default()};
    obstacles[0].shape.kind = obstacles[1].shape.kind = SPH2D_SHAPE_BOX;
    obstacles[0].shape.box = (sph2d_box){{-0.1, -0.1}, {0.3, -0.5 * DX}};
    obstacles[0].form = SPH2D_WALL_REFLECT;
    scene.method = test_open_scene(DX, -1, -1, 1, 1).method;
    obstacles[1].shape.box = (sph2d_box){{0.5, 0.5}, {0.6, 0.6}};
    scene.obstacles = obstacles;
    scene.obstacle_count = 2;
    blocks[0].perturb.amplitude = 0;
    sph2d__system *s = make();
    ck_assert(s->walls_press);
    only_tension(s);
    double below = 0, above = 0;
    for (size_t i = 0; i < s->fluid.count; ++i) {
        bool low = s->fluid.y[i] < 3 * DX;
        *(low ? &below : &above) += fabs(s->fluid.ax[i]) * s->mass;
    }
    ck_assert_double_gt(above, SIGMA);
    ck_assert_double_eq_tol(below, above, 1e-9 * SIGMA);
}
END_TEST

/** A film through a periodic side has no ends; seen from a cut it pulls with both its surfaces. */
START_TEST(strings_go_on_across_periodic_sides)
{
    bool along_x = _i == 0;
    sph2d_side *low = along_x ? &scene.boundary.left : &scene.boundary.bottom;
    sph2d_side *high = along_x ? &scene.boundary.right : &scene.boundary.top;
    *low = *high = SPH2D_SIDE_PERIODIC;
    blocks[0] = along_x ? test_block(-1, 0, 1, 4 * DX) : test_block(0, -1, 4 * DX, 1);
    sph2d__system *s = make();
    only_tension(s);
    for (size_t i = 0; i < s->fluid.count; ++i) {
        ck_assert_double_eq_tol(s->fluid.ax[i] * s->mass, 0, 1e-9 * SIGMA);
        ck_assert_double_eq_tol(s->fluid.ay[i] * s->mass, 0, 1e-9 * SIGMA);
    }
    ck_assert_double_eq_tol(sph2d__tension_energy(s), 2 * 2 * SIGMA * (2 - film()), 1e-6); /* 2 m, two surfaces */
}
END_TEST

/** It is in what a step begins with. */
START_TEST(accelerations_have_it)
{
    blocks[0].perturb.amplitude = 0;
    scene.method = test_open_scene(DX, -1, -1, 1, 1).method; /* muller */
    sph2d__system *s = make();
    double with_tension = s->fluid.ax[0] * s->mass;
    only_tension(s);
    double alone = s->fluid.ax[0] * s->mass;
    finish();
    scene.fluid.surface_tension = 0;
    s = make();
    ck_assert_double_gt(fabs(alone), 0.5 * SIGMA);
    ck_assert_double_eq_tol(with_tension - s->fluid.ax[0] * s->mass, alone, 1e-9 * SIGMA);
}
END_TEST

/** A square and a smaller one that meets it pull each other round; nothing is fed. */
START_TEST(drops_that_meet_make_no_energy)
{
    scene.method.sound_speed = 0;
    blocks[0].perturb.amplitude = 0.1;
    blocks[1] = test_block(9.5 * DX, DX, 14.5 * DX, 5 * DX);
    blocks[1].velocity.x = -0.1;
    scene.block_count = 2;
    sph2d__system *s = make();
    double before = sph2d__tension_energy(s);
    sph2d_report report = {0};
    while (sph2d_sim_time(sim) < 20 * sqrt(RHO0 * DX * DX * DX / SIGMA))
        ck_assert_int_eq(sph2d_sim_step(sim, &report), SPH2D_OK);
    sph2d_summary sum = sph2d_sim_summary(sim);
    ck_assert_double_lt(sum.energy_rise,
                        0.008 * sum.energy_scale); /* known weakness: tension stands still over a step */
    ck_assert_double_lt(sph2d__tension_energy(s), 0.9 * before);
    sph2d_report_clear(&report);
}
END_TEST

/** What a drain takes out of a block, and what a source adds to it, has a surface, which is booked with the rest: the
 *  block rests, so that nothing else changes, and the source feeds one row at a speed that has no energy. */
START_TEST(what_comes_and_goes_has_a_surface)
{
    sph2d_drain drain = sph2d_drain_default();
    drain.shape.kind = SPH2D_SHAPE_BOX;
    drain.shape.box = (sph2d_box){{3 * DX, -DX}, {9 * DX, 7 * DX}};
    sph2d_source source = sph2d_source_default();
    source.at = (sph2d_vec2){4 * DX, 8 * DX};
    source.width = 5 * DX;
    source.speed = 1e-6;
    scene.method.name = _i / 2 == 0 ? SPH2D_METHOD_WCSPH : SPH2D_METHOD_PCISPH;
    scene.method.time_step = 1e-6; /* nobody moves */
    scene.gravity = (sph2d_vec2){0, 0};
    scene.drains = &drain;
    scene.drain_count = _i % 2 == 0;
    scene.sources = &source;
    scene.source_count = _i % 2 == 1;
    sph2d__system *s = make();
    double before = sph2d__tension_energy(s);
    size_t count = s->fluid.count;
    test_steps(sim, 1);
    double change = sph2d__tension_energy(s) - before;
    ck_assert_uint_eq(s->fluid.count, _i % 2 == 0 ? 18 : count + 5);
    ck_assert_double_gt(fabs(change), 4 * DX * SIGMA);
    ck_assert_double_eq_tol(sph2d_sim_summary(sim).energy_fed, change, 0.03 * fabs(change));
    ck_assert_double_le(sph2d_sim_summary(sim).energy_rise, 0.03 * fabs(change));
}
END_TEST

START_TEST(ripples_limit_the_step)
{
    scene.fluid.surface_tension = 1e6;
    sph2d__system *s = make();
    sph2d__limit limit;
    ck_assert_double_eq_tol(sim->method->stable_step(s, 0, 0, &limit), 0.5 * sqrt(RHO0 * DX * DX * DX / 1e6), 1e-12);
    ck_assert_int_eq(limit, SPH2D__LIMIT_FORCE);
    scene.fluid.surface_tension = 0;
    finish();
    ck_assert_double_eq(sph2d__tension_step(make()), INFINITY);
}
END_TEST

/** Without gravity and speeds, ripples give the sound speed: sqrt(8 sigma/(rho dx)). */
START_TEST(ripples_give_the_sound_speed)
{
    scene.method.sound_speed = 0;
    sph2d__system *s = make();
    ck_assert_double_eq_tol(s->sound_speed, sqrt(8 * SIGMA / (RHO0 * DX)), 1e-12);
}
END_TEST

Suite *suite_tension(void)
{
    Suite *suite = suite_create("tension");
    TCase *tests = tcase_create("strings");
    tcase_add_checked_fixture(tests, start, finish);
    tcase_add_loop_test(tests, force_is_the_gradient_of_the_energy, 0, 4);
    tcase_add_test(tests, energy_is_that_of_perimeters);
    tcase_add_test(tests, heaps_have_the_energy_of_perimeters);
    tcase_add_test(tests, energy_has_no_jumps);
    tcase_add_loop_test(tests, momentum_and_angular_momentum_are_kept, 0, 3);
    tcase_add_loop_test(tests, a_film_has_two_surfaces, 0, 3);
    tcase_add_loop_test(tests, a_surface_meets_a_wall_at_a_right_angle, 0, 3);
    tcase_add_loop_test(tests, strings_go_on_across_periodic_sides, 0, 2);
    tcase_add_test(tests, what_only_reflects_is_no_wall);
    tcase_add_test(tests, accelerations_have_it);
    tcase_add_test(tests, drops_that_meet_make_no_energy);
    tcase_add_loop_test(tests, what_comes_and_goes_has_a_surface, 0, 4);
    tcase_add_test(tests, ripples_limit_the_step);
    tcase_add_test(tests, ripples_give_the_sound_speed);
    suite_add_tcase(suite, tests);
    return suite;
}
