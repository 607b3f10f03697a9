/* SPDX-License-Identifier: MIT */
/** @file test_invariance.c
 *  What must not matter: units, mirror, order of the blocks, a frame that moves, number of threads, other
 *  simulations. */
#include <math.h>
#include <pthread.h>
#include <string.h>

#include "common.h"

/** Maps x to ax x + bx, y to ay y + by. */
typedef struct affine {
    double ax, bx, ay, by;
} affine;

/** Largest distance between a particle of `a` and its partner in `b`, mapped. The partner has the same id, or the one
 *  that `other` gives. */
static double largest_distance(sph2d_view a, sph2d_view b, affine m, uint64_t (*other)(uint64_t))
{
    ck_assert_uint_eq(a.count, b.count);
    double worst = 0;
    for (size_t i = 0; i < a.count; ++i) {
        size_t j = test_find(b, other ? other(a.id[i]) : a.id[i]);
        worst = fmax(worst, hypot(a.x[i] - m.ax * b.x[j] - m.bx, a.y[i] - m.ay * b.y[j] - m.by));
    }
    return worst;
}

/* ---- units ------------------------------------------------------------------------------------------------------- */

/** New units of length, mass and time: numbers are so many times as large. */
typedef struct units {
    double length, mass, time;
} units;

/** A dam break over a heavy line and a reflecting circle with a pull, in any units. */
static sph2d_sim *dam_in(units u)
{
    double l = u.length, dx = 0.02 * l, velocity = l / u.time, force = l / (u.time * u.time);
    sph2d_scene scene = sph2d_scene_default();
    scene.method.name = SPH2D_METHOD_MULLER;
    scene.domain = (sph2d_box){{0, 0}, {l, 0.8 * l}};
    scene.spacing = dx;
    scene.gravity.y = -9.81 * force;
    scene.fluid.density = 1000 * u.mass / (l * l * l);
    scene.fluid.dynamic_viscosity = 0.5 * u.mass / (l * u.time);
    scene.method.stiffness = 180 * velocity * velocity;
    sph2d_block block = test_block(0, 0, 0.4 * l, 0.6 * l);
    block.velocity.x = 0.5 * velocity;
    sph2d_vec2 line[2] = {{0.55 * l, 0}, {0.62 * l, 0.13 * l}};
    sph2d_obstacle obstacles[2] = {sph2d_obstacle_default(), sph2d_obstacle_default()};
    obstacles[0].shape.kind = SPH2D_SHAPE_LINE;
    obstacles[0].shape.points = (sph2d_points){line, 2};
    obstacles[1].shape.kind = SPH2D_SHAPE_CIRCLE;
    obstacles[1].shape.circle = (sph2d_circle){{0.25 * l, 0.3 * l}, 0.06 * l};
    obstacles[1].form = SPH2D_WALL_REFLECT;
    sph2d_path_point point = {0, 0.3 * l, 0.6 * l};
    sph2d_interaction pull = sph2d_interaction_default();
    pull.path.items = &point;
    pull.path.count = 1;
    pull.radius = 0.3 * l;
    pull.acceleration = 20 * force;
    scene.blocks = &block;
    scene.block_count = 1;
    scene.obstacles = obstacles;
    scene.obstacle_count = 2;
    scene.interactions = &pull;
    scene.interaction_count = 1;
    return test_create(&scene, NULL);
}

START_TEST(units_do_not_matter)
{
    /* Millimetres, kilograms, seconds; millimetres, grams, milliseconds; kilometres, tons, hours. */
    static const units all[] = {{1e3, 1, 1}, {1e3, 1e3, 1e3}, {1e-3, 1e-3, 1 / 3600.0}};
    sph2d_sim *si = dam_in((units){1, 1, 1}), *other = dam_in(all[_i]);
    for (int k = 0; k < 4; ++k) {
        test_steps(si, 50);
        test_steps(other, 50);
        double scale = 1 / all[_i].length;
        double apart =
            largest_distance(sph2d_sim_fluid(si), sph2d_sim_fluid(other), (affine){scale, 0, scale, 0}, NULL);
        ck_assert_double_le(apart, 1e-9);
    }
    ck_assert_double_eq_tol(sph2d_sim_time(other) / all[_i].time / sph2d_sim_time(si), 1, 1e-9);
    sph2d_summary a = sph2d_sim_summary(si), b = sph2d_sim_summary(other);
    ck_assert_double_eq_tol(b.kinetic / a.kinetic * all[_i].time * all[_i].time / all[_i].mass / all[_i].length, 1,
                            1e-8);
    ck_assert_double_eq_tol(b.compression_max, a.compression_max, 1e-8);
    ck_assert_uint_eq(a.reflections, b.reflections);
    ck_assert_double_gt(a.speed_max, 1);
    ck_assert_uint_gt(a.reflections, 0);
    sph2d_sim_destroy(si);
    sph2d_sim_destroy(other);
}
END_TEST

/* ---- mirror and order -------------------------------------------------------------------------------------------- */

enum { ROWS = 20, COLUMNS = 16 };

/** A dam at the left end, or at the right end, of a tank that is symmetric about x = 0; the line is mirrored too. */
static sph2d_sim *dam_at(double side)
{
    const double dx = 0.02;
    sph2d_scene scene = test_scene(dx, -0.5, 0, 0.5, 0.6);
    scene.gravity = (sph2d_vec2){1.5 * side, -9.81};
    scene.fluid.dynamic_viscosity = 0.3;
    double a = side * 0.5, b = side * (0.5 - COLUMNS * dx);
    sph2d_block block = test_block(fmin(a, b), 0, fmax(a, b), ROWS * dx);
    sph2d_vec2 line[2] = {{side * 0.1, 0}, {-side * 0.05, 0.1}};
    sph2d_obstacle obstacle = sph2d_obstacle_default();
    obstacle.shape.kind = SPH2D_SHAPE_LINE;
    obstacle.shape.points = (sph2d_points){line, 2};
    scene.blocks = &block;
    scene.block_count = 1;
    scene.obstacles = &obstacle;
    scene.obstacle_count = 1;
    return test_create(&scene, NULL);
}

/** Ids count along the rows of a block, from its lower left corner. */
static uint64_t mirrored(uint64_t id)
{
    return id / COLUMNS * COLUMNS + (COLUMNS - 1 - id % COLUMNS);
}

START_TEST(a_mirrored_scene_mirrors)
{
    sph2d_sim *left = dam_at(-1), *right = dam_at(1);
    affine flip = {-1, 0, 1, 0};
    ck_assert_double_le(largest_distance(sph2d_sim_fluid(left), sph2d_sim_fluid(right), flip, mirrored), 1e-14);
    test_steps(left, 20);
    test_steps(right, 20);
    ck_assert_double_le(largest_distance(sph2d_sim_fluid(left), sph2d_sim_fluid(right), flip, mirrored), 1e-12);
    test_steps(left, 80);
    test_steps(right, 80);
    ck_assert_double_le(largest_distance(sph2d_sim_fluid(left), sph2d_sim_fluid(right), flip, mirrored), 1e-9);
    ck_assert_double_gt(sph2d_sim_summary(left).speed_max, 0.5);
    sph2d_sim_destroy(left);
    sph2d_sim_destroy(right);
}
END_TEST

enum { BLOCK = 12 };

/** Two blocks thrown at each other, given in either order. */
static sph2d_sim *crash(bool swapped)
{
    const double dx = 0.02;
    sph2d_scene scene = test_scene(dx, 0, 0, 1, 0.5);
    scene.gravity.y = -9.81;
    scene.fluid.dynamic_viscosity = 0.3;
    sph2d_block a = test_block(0.1, 0.1, 0.1 + BLOCK * dx, 0.1 + BLOCK * dx), b = a;
    a.velocity.x = 2;
    b.shape.box.min.x += 0.3;
    b.shape.box.max.x += 0.3;
    b.velocity = (sph2d_vec2){-2, 0.5};
    sph2d_block blocks[2] = {swapped ? b : a, swapped ? a : b};
    scene.blocks = blocks;
    scene.block_count = 2;
    return test_create(&scene, NULL);
}

static uint64_t swapped_id(uint64_t id)
{
    return (id + BLOCK * BLOCK) % (2 * BLOCK * BLOCK);
}

START_TEST(the_order_of_the_blocks_does_not_matter)
{
    sph2d_sim *one = crash(false), *two = crash(true);
    test_steps(one, 100);
    test_steps(two, 100);
    affine same = {1, 0, 1, 0};
    ck_assert_double_le(largest_distance(sph2d_sim_fluid(one), sph2d_sim_fluid(two), same, swapped_id), 1e-9);
    ck_assert_double_gt(sph2d_sim_summary(one).compression_max, 0.01); /* they have met */
    sph2d_sim_destroy(one);
    sph2d_sim_destroy(two);
}
END_TEST

/* ---- a frame that moves ------------------------------------------------------------------------------------------ */

/** The same without walls and gravity, all of it with an added velocity. */
static sph2d_sim *crash_in_frame(sph2d_vec2 frame, double step)
{
    const double dx = 0.02;
    sph2d_scene scene = test_open_scene(dx, -10, -10, 10, 10);
    scene.fluid.dynamic_viscosity = 1;
    scene.method.time_step = step;
    sph2d_block blocks[2] = {test_block(0.1, 0.1, 0.34, 0.34), test_block(0.4, 0.15, 0.64, 0.39)};
    blocks[0].velocity = (sph2d_vec2){1 + frame.x, frame.y};
    blocks[1].velocity = (sph2d_vec2){-1 + frame.x, frame.y};
    scene.blocks = blocks;
    scene.block_count = 2;
    return test_create(&scene, NULL);
}

START_TEST(a_moving_frame_sees_the_same)
{
    const double step = 5e-4;
    const sph2d_vec2 frame = {16, -12}; /* 10 U, U = 2 m/s being what the two collide with */
    sph2d_sim *still = crash_in_frame((sph2d_vec2){0, 0}, step), *moving = crash_in_frame(frame, step);
    test_steps(still, 150);
    test_steps(moving, 150);
    double t = 150 * step;
    affine back = {1, -frame.x * t, 1, -frame.y * t};
    ck_assert_double_le(largest_distance(sph2d_sim_fluid(still), sph2d_sim_fluid(moving), back, NULL), 1e-9);
    ck_assert_double_gt(sph2d_sim_summary(still).compression_max, 0.01);
    sph2d_sim_destroy(still);
    sph2d_sim_destroy(moving);
}
END_TEST

/* ---- threads ----------------------------------------------------------------------------------------------------- */

/** 9216 particles, more than eight threads' worth, with everything that comes and goes. */
static sph2d_sim *busy_tank(int threads)
{
    const double dx = 0.01;
    sph2d_scene scene = test_scene(dx, 0, 0, 1.5, 1.2);
    scene.boundary.right = SPH2D_SIDE_OPEN;
    scene.gravity.y = -9.81;
    scene.fluid.dynamic_viscosity = 0.1;
    sph2d_block block = test_block(0, 0, 0.96, 0.96);
    block.velocity = (sph2d_vec2){1, -1};
    sph2d_source source = sph2d_source_default();
    source.at = (sph2d_vec2){1.2, 1.1};
    source.width = 0.1;
    source.speed = 5;
    source.spread = 0.1;
    sph2d_drain drain = sph2d_drain_default();
    drain.shape.kind = SPH2D_SHAPE_CIRCLE;
    drain.shape.circle = (sph2d_circle){{0.5, 0.2}, 0.05};
    sph2d_obstacle obstacle = sph2d_obstacle_default();
    obstacle.shape.kind = SPH2D_SHAPE_CIRCLE;
    obstacle.shape.circle = (sph2d_circle){{1.1, 0.4}, 0.1};
    scene.blocks = &block;
    scene.block_count = 1;
    scene.sources = &source;
    scene.source_count = 1;
    scene.drains = &drain;
    scene.drain_count = 1;
    scene.obstacles = &obstacle;
    scene.obstacle_count = 1;
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = threads;
    return test_create(&scene, &options);
}

START_TEST(threads_give_the_same_bits)
{
    static const int threads[] = {2, 3, 8};
    sph2d_sim *one = busy_tank(1);
    test_steps(one, 12);
    sph2d_view a = sph2d_sim_fluid(one);
    size_t bytes = a.count * sizeof(double);
    ck_assert_uint_gt(a.count, 8 * 1024);
    sph2d_sim *more = busy_tank(threads[_i]);
#ifdef _OPENMP
    ck_assert_int_eq(sph2d_sim_threads(more), threads[_i]);
#endif
    test_steps(more, 12);
    sph2d_view b = sph2d_sim_fluid(more);
    ck_assert_uint_eq(a.count, b.count);
    ck_assert(memcmp(a.x, b.x, bytes) == 0 && memcmp(a.y, b.y, bytes) == 0);
    ck_assert(memcmp(a.vx, b.vx, bytes) == 0 && memcmp(a.vy, b.vy, bytes) == 0);
    ck_assert(memcmp(a.ax, b.ax, bytes) == 0 && memcmp(a.ay, b.ay, bytes) == 0);
    ck_assert(memcmp(a.density, b.density, bytes) == 0 && memcmp(a.pressure, b.pressure, bytes) == 0);
    ck_assert_mem_eq(a.id, b.id, bytes);
    sph2d_summary sa = sph2d_sim_summary(one), sb = sph2d_sim_summary(more);
    ck_assert(sa.time == sb.time && sa.kinetic == sb.kinetic && sa.potential == sb.potential);
    ck_assert(sa.energy_fed == sb.energy_fed && sa.compression_p99 == sb.compression_p99);
    ck_assert_uint_gt(sa.fed, 0);
    ck_assert_uint_gt(sa.drained, 0);
    sph2d_sim_destroy(one);
    sph2d_sim_destroy(more);
}
END_TEST

/** One of several simulations that run at the same time. */
typedef struct worker {
    pthread_t thread;
    sph2d_sim *sim;
    bool failed;
} worker;

static void *work(void *argument)
{
    worker *w = argument;
    for (int n = 0; n < 12; ++n)
        w->failed = w->failed || sph2d_sim_step(w->sim, NULL) != SPH2D_OK;
    return NULL;
}

START_TEST(simulations_in_several_threads_do_not_meet)
{
    worker workers[3] = {{.failed = false}};
    sph2d_sim *alone = busy_tank(1);
    test_steps(alone, 12);
    for (int i = 0; i < 3; ++i)
        workers[i].sim = busy_tank(1 + i % 2);
    for (int i = 0; i < 3; ++i)
        ck_assert_int_eq(pthread_create(&workers[i].thread, NULL, work, &workers[i]), 0);
    for (int i = 0; i < 3; ++i)
        pthread_join(workers[i].thread, NULL);
    sph2d_view a = sph2d_sim_fluid(alone);
    for (int i = 0; i < 3; ++i) {
        sph2d_view b = sph2d_sim_fluid(workers[i].sim);
        ck_assert(!workers[i].failed && a.count == b.count);
        ck_assert(memcmp(a.x, b.x, a.count * sizeof *a.x) == 0 && memcmp(a.vy, b.vy, a.count * sizeof *a.vy) == 0);
        sph2d_sim_destroy(workers[i].sim);
    }
    sph2d_sim_destroy(alone);
}
END_TEST

Suite *suite_invariance(void)
{
    Suite *suite = suite_create("invariance");
    TCase *tests = tcase_create("invariance");
    tcase_add_loop_test(tests, units_do_not_matter, 0, 3);
    tcase_add_test(tests, a_mirrored_scene_mirrors);
    tcase_add_test(tests, the_order_of_the_blocks_does_not_matter);
    tcase_add_test(tests, a_moving_frame_sees_the_same);
    tcase_add_loop_test(tests, threads_give_the_same_bits, 0, 3);
    tcase_add_test(tests, simulations_in_several_threads_do_not_meet);
    suite_add_tcase(suite, tests);
    return suite;
}
