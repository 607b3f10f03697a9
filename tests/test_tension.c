/* SPDX-License-Identifier: MIT */
/** @file test_tension.c
 *  Surface tension: its force is the gradient of sigma times the length of the surface's edges, which are found here in
 *  another way: by the arcs of each circle that the other discs leave bare. */
#include <math.h>

#include "common.h"
#include "methods/method.h"
#include "methods/tension.h"
#include "sim/simulation.h"

static const double DX = 0.02, SIGMA = 0.7, RHO0 = 1000, RADIUS = 1.25;
enum { MOST = 256 };

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

/* ---- the surface by arcs ----------------------------------------------------------------------------------------- */

/** Whether the angle lies within `half` of the direction to (dx, dy). */
static bool within(double angle, double dx, double dy, double half)
{
    return fabs(remainder(angle - atan2(dy, dx), 2 * TEST_PI)) < half;
}

/** Half the arc of particle i's circle that particle j covers; below 0 where none. */
static double covered_half(const double *x, const double *y, size_t i, size_t j)
{
    double r = hypot(x[j] - x[i], y[j] - y[i]);
    return i != j && r < 2 * RADIUS * DX ? acos(r / (2 * RADIUS * DX)) : -1;
}

/** How many ends of the arc of i that j covers are covered by no other. */
static int bare_ends(const double *x, const double *y, size_t count, size_t i, size_t j)
{
    double half = covered_half(x, y, i, j);
    if (half < 0)
        return 0;
    int bare = 0;
    for (int side = -1; side <= 1; side += 2) {
        double angle = atan2(y[j] - y[i], x[j] - x[i]) + side * half;
        bool covered = false;
        for (size_t k = 0; k < count; ++k)
            covered |= k != j && within(angle, x[k] - x[i], y[k] - y[i], covered_half(x, y, i, k));
        bare += !covered;
    }
    return bare;
}

/** Length of all edges [m]. */
static double edges(const double *x, const double *y, size_t count)
{
    double length = 0;
    for (size_t i = 0; i < count; ++i)
        for (size_t j = i + 1; j < count; ++j)
            length += bare_ends(x, y, count, i, j) * hypot(x[j] - x[i], y[j] - y[i]);
    return length;
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

/** -dE/dx by differences of E = sigma times the edges, for a disordered block and a particle far from it. */
START_TEST(force_is_the_gradient_of_the_surface)
{
    choose_method(_i);
    blocks[1] = test_particle(DX, -0.5, -0.5, 0, 0);
    scene.block_count = 2;
    sph2d__system *s = make();
    only_tension(s);
    sph2d__store *f = &s->fluid;
    ck_assert_uint_lt(f->count, MOST);
    double x[MOST], y[MOST], step = 1e-6 * DX, most = 0;
    for (size_t i = 0; i < f->count; ++i) {
        x[i] = f->x[i];
        y[i] = f->y[i];
    }
    for (size_t i = 0; i < f->count; ++i)
        for (int axis = 0; axis < 2; ++axis) {
            double *place = axis ? &y[i] : &x[i], at = *place;
            *place = at + step;
            double ahead = edges(x, y, f->count);
            *place = at - step;
            double behind = edges(x, y, f->count);
            *place = at;
            double force = -SIGMA * (ahead - behind) / (2 * step);
            double got = (axis ? f->ay[i] : f->ax[i]) * s->mass;
            ck_assert_msg(fabs(got - force) < 1e-6 * SIGMA, "particle %zu: %g, not %g", i, got, force);
            most = fmax(most, fabs(force));
        }
    ck_assert_double_gt(most, 0.3 * SIGMA);
    ck_assert_double_eq_tol(sph2d__tension_energy(s), SIGMA * edges(x, y, f->count), 1e-12);
}
END_TEST

/** Loose heaps of particles, in which each place of a disc matters, against edges found by arcs. */
START_TEST(edges_are_those_that_arcs_leave_bare)
{
    enum { HEAP = 7 };
    blocks[0] = test_block(0, 0, HEAP * DX, DX);
    blocks[0].perturb.amplitude = 0;
    sph2d__system *s = make();
    sph2d__store *f = &s->fluid;
    ck_assert_uint_eq(f->count, HEAP);
    uint64_t seed = 9;
    for (int heap = 0; heap < 500; ++heap) {
        for (size_t i = 0; i < HEAP; ++i) {
            f->x[i] = test_random(&seed, 0, 4 * DX);
            f->y[i] = test_random(&seed, 0, 4 * DX);
        }
        ck_assert(sph2d__cells_build(&s->fluid_cells, f, s->reach, s->memory, NULL));
        only_tension(s);
        for (size_t i = 0; i < HEAP; ++i) {
            double pull[2] = {0, 0};
            for (size_t j = 0; j < HEAP; ++j) {
                double dx = f->x[j] - f->x[i], dy = f->y[j] - f->y[i], r = hypot(dx, dy);
                int bare = bare_ends(f->x, f->y, HEAP, i, j);
                pull[0] += r > 0 ? bare * dx / r : 0;
                pull[1] += r > 0 ? bare * dy / r : 0;
            }
            ck_assert_double_eq_tol(f->ax[i] * s->mass, SIGMA * pull[0], 1e-9 * SIGMA);
            ck_assert_double_eq_tol(f->ay[i] * s->mass, SIGMA * pull[1], 1e-9 * SIGMA);
        }
    }
}
END_TEST

/** Opposite pairs of central forces. */
START_TEST(momentum_and_angular_momentum_are_kept)
{
    choose_method(_i % 3);
    blocks[1] = test_block(10 * DX, 2 * DX, 15 * DX, 5 * DX);
    blocks[1].perturb.amplitude = 0.5; /* loose */
    blocks[1].spacing = 1.4 * DX;
    scene.block_count = 2;
    sph2d__system *s = make();
    if (s->fluid.surface) /* a surface that is known in part: strings need both ends near it */
        for (size_t i = 0; _i >= 3 && i < s->fluid.count; ++i)
            s->fluid.surface[i] = s->fluid.id[i] % 3 == 0 ? s->support : 0;
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
    ck_assert_double_eq_tol(pull, 2 * SIGMA, 1e-12 * SIGMA); /* of the right half on the left */
}
END_TEST

/** Half a block on a floor: each end of the surface is drawn straight down with sigma, and nothing along the floor. */
START_TEST(a_surface_meets_a_wall_at_a_right_angle)
{
    scene.boundary.bottom = SPH2D_SIDE_WALL;
    blocks[0] = test_block(0, -1, 8 * DX, -1 + 6 * DX);
    if (_i == 2) { /* the same on the left */
        scene.boundary.bottom = SPH2D_SIDE_OPEN;
        scene.boundary.left = SPH2D_SIDE_WALL;
        blocks[0] = test_block(-1, 0, -1 + 6 * DX, 8 * DX);
    }
    blocks[0].perturb.amplitude = 0.15;
    if (_i == 1) /* heavy walls have no layers and are not wetted */
        scene.method = test_open_scene(DX, -1, -1, 1, 1).method;
    scene.walls = _i == 1 ? SPH2D_WALL_HEAVY : SPH2D_WALL_DEFAULT;
    sph2d__system *s = make();
    ck_assert(s->walls_press);
    only_tension(s);
    double sum[2] = {0};
    for (size_t i = 0; i < s->fluid.count; ++i) {
        sum[0] += s->fluid.ax[i] * s->mass;
        sum[1] += s->fluid.ay[i] * s->mass;
    }
    ck_assert_double_eq_tol(sum[0], _i == 2 ? -2 * SIGMA : 0, 1e-12 * SIGMA);
    ck_assert_double_eq_tol(sum[1], _i == 0 ? -2 * SIGMA : 0, 1e-12 * SIGMA);
}
END_TEST

/** Obstacles that only reflect do not cover, whatever others there are. */
START_TEST(what_only_reflects_is_no_wall)
{
    sph2d_obstacle obstacles[2] = {sph2d_obstacle_default(), sph2d_obstacle_default()};
    obstacles[0].outline.kind = obstacles[1].outline.kind = SPH2D_OUTLINE_BOX;
    obstacles[0].outline.box = (sph2d_box){{-0.1, -0.1}, {0.3, -0.5 * DX}};
    obstacles[0].form = SPH2D_WALL_REFLECT;
    obstacles[1].outline.box = (sph2d_box){{0.5, 0.5}, {0.6, 0.6}};
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
    ck_assert_double_eq_tol(sph2d__tension_energy(s), 2 * 2 * SIGMA, 1e-9); /* 2 m long, two surfaces */
}
END_TEST

/** Both methods add it to their accelerations. */
START_TEST(methods_have_it)
{
    blocks[0].perturb.amplitude = 0;
    if (_i == 1)
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
    tcase_add_loop_test(tests, force_is_the_gradient_of_the_surface, 0, 3);
    tcase_add_test(tests, edges_are_those_that_arcs_leave_bare);
    tcase_add_loop_test(tests, momentum_and_angular_momentum_are_kept, 0, 6);
    tcase_add_loop_test(tests, a_film_has_two_surfaces, 0, 3);
    tcase_add_loop_test(tests, a_surface_meets_a_wall_at_a_right_angle, 0, 3);
    tcase_add_loop_test(tests, strings_go_on_across_periodic_sides, 0, 2);
    tcase_add_test(tests, what_only_reflects_is_no_wall);
    tcase_add_loop_test(tests, methods_have_it, 0, 2);
    tcase_add_test(tests, ripples_limit_the_step);
    tcase_add_test(tests, ripples_give_the_sound_speed);
    suite_add_tcase(suite, tests);
    return suite;
}
