/* SPDX-License-Identifier: MIT */
/** @file test_stick.c
 *  Liquid that sticks to walls pair by pair (terms/stick.h), of method `wcsph`: the Laplacian beside a wall, what the
 *  wall feels of it, and in which liquids it does. */
#include <math.h>
#include <string.h>

#include "hand_made.h"
#include "methods/wcsph/wcsph.h"

enum { MOST = 2000 };
static const double DX = 0.05, RHO = 1000, NU = 0.02;

static sph2d_sim *sim;
static double ax[MOST], ay[MOST];

static sph2d_scene channel_scene(double nu)
{
    sph2d_scene scene = test_scene(DX, 0, 0, 0.6, 1);
    scene.boundary.left = scene.boundary.right = SPH2D_SIDE_PERIODIC;
    scene.method = sph2d_scene_default().method;
    scene.method.sound_speed = 20;
    scene.method.viscosity_form = SPH2D_VISCOSITY_MORRIS;
    scene.method.turbulence = SPH2D_TURBULENCE_NONE;
    scene.wall_slip = SPH2D_SLIP_NONE;
    scene.fluid.density = RHO;
    scene.fluid.dynamic_viscosity = RHO * nu;
    return scene;
}

/** Liquid between two walls at rest, periodic along x, 12 by 20 spacings. */
static void make_channel(double nu, sph2d_precision precision, double jitter)
{
    sph2d_scene scene = channel_scene(nu);
    scene.method.precision = precision;
    sim = hand_made(scene, MOST, 1);
    add_lattice(sim, (sph2d_box){{0, 0}, {0.6, 1}}, jitter, 7);
    sort_particles(sim);
}

static void end(void)
{
    sph2d_sim_destroy(sim);
    sim = NULL;
}

/** The part of the acceleration that is odd in velocity: that of viscosity. The system keeps that of the velocities. */
static void find_drag(void)
{
    sph2d__store *f = &sim->system.fluid, *w = &sim->system.walls;
    ck_assert_uint_le(f->count, MOST);
    for (int sign = -1; sign <= 1; sign += 2) {
        for (size_t i = 0; i < f->count; ++i) {
            f->vx[i] = -f->vx[i];
            f->vy[i] = -f->vy[i];
        }
        for (size_t b = 0; b < w->count; ++b) {
            w->vx[b] = -w->vx[b];
            w->vy[b] = -w->vy[b];
        }
        for (size_t b = 0; sim->system.wall_spin && b < w->count; ++b)
            sim->system.wall_spin[b] = -sim->system.wall_spin[b];
        ck_assert(sph2d__wcsph.evaluate(&sim->system));
        for (size_t i = 0; i < f->count; ++i) {
            ax[i] = (sign < 0 ? 0 : ax[i]) + sign * f->ax[i] / 2;
            ay[i] = (sign < 0 ? 0 : ay[i]) + sign * f->ay[i] / 2;
        }
    }
}

/** Gives the liquid the profile u + g y + c y^2 of the height. */
static void set_profile(double u, double g, double c)
{
    sph2d__store *f = &sim->system.fluid;
    for (size_t i = 0; i < f->count; ++i) {
        f->vx[i] = u + g * f->y[i] + c * f->y[i] * f->y[i];
        f->vy[i] = 0;
    }
}

/** Largest error of the Laplacian within the support of the lower wall, over `size`. */
static double laplacian_error(double expect, double size)
{
    const sph2d__store *f = &sim->system.fluid;
    double worst = 0;
    for (size_t i = 0; i < f->count; ++i)
        if (f->y[i] < sim->system.support)
            worst = fmax(worst, fabs(ax[i] / NU - expect));
    return worst / size;
}

/* A parabola that is 0 at the wall: its second derivative from the first row on, in doubles and floats. By images in
 * the mean that of the first row is two thirds of it. */
START_TEST(a_parabola_has_its_laplacian_at_the_wall)
{
    const sph2d_precision precision = _i & 1 ? SPH2D_PRECISION_MIXED : SPH2D_PRECISION_DOUBLE;
    make_channel(NU, precision, 0);
    ck_assert(sim->system.walls_stick);
    set_profile(0, 0, -5);
    find_drag();
    ck_assert_double_le(laplacian_error(-10, 10), 0.02);
    set_profile(0, 2, 0);
    find_drag();
    ck_assert_double_le(laplacian_error(0, 2 / DX), 0.001);
}
END_TEST

/* What liquid in disorder gets from both walls is minus what they feel, and what changes its momentum. */
START_TEST(walls_feel_what_the_liquid_loses)
{
    make_channel(NU, SPH2D_PRECISION_DOUBLE, 0.2);
    set_profile(0.3, 2, -5);
    find_drag();
    const sph2d__store *f = &sim->system.fluid, *w = &sim->system.walls;
    double lost = 0, felt = 0, size = 0;
    for (size_t i = 0; i < f->count; ++i)
        lost += sim->system.mass * ax[i];
    for (size_t b = 0; b < w->count; ++b) {
        double friction = sph2d__sim_force_of_wall(sim, b).friction.x;
        felt += friction;
        size += fabs(friction);
    }
    ck_assert_double_gt(size, 0);
    ck_assert_double_eq_tol(felt, lost, 1e-10 * size);
}
END_TEST

/* Walls that move with the liquid are felt as at rest. */
START_TEST(the_velocity_of_the_wall_counts)
{
    static double at_rest[MOST];
    make_channel(NU, SPH2D_PRECISION_DOUBLE, 0.2);
    sph2d__store *f = &sim->system.fluid, *w = &sim->system.walls;
    set_profile(0, 2, -5);
    find_drag();
    memcpy(at_rest, ax, sizeof ax);
    set_profile(0.7, 2, -5);
    sim->system.walls_move = true;
    for (size_t b = 0; b < w->count; ++b)
        w->vx[b] = 0.7;
    find_drag();
    for (size_t i = 0; i < f->count; ++i)
        ck_assert_double_eq_tol(ax[i], at_rest[i], 1e-9 * NU * 10);
}
END_TEST

/** Liquid in rings round a post, or inside a drum, that turns at 2 rad/s. */
static void make_rings(bool drum)
{
    sph2d_obstacle obstacle = sph2d_obstacle_default();
    obstacle.outline = (sph2d_outline){.kind = SPH2D_OUTLINE_CIRCLE, .circle = {{1, 1}, drum ? 0.5 : 0.25}};
    obstacle.motion.rate = 2;
    obstacle.motion.ramp = 1;
    if (drum)
        obstacle.liquid = SPH2D_LIQUID_INSIDE;
    sph2d_scene scene = channel_scene(NU);
    scene.domain = (sph2d_box){{0, 0}, {2, 2.8}};
    scene.boundary = (sph2d_boundary){SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN};
    scene.obstacles = &obstacle;
    scene.obstacle_count = 1;
    sim = hand_made(scene, MOST, 1);
    for (int row = 0; row < 10; ++row) {
        double r = drum ? 0.5 - (row + 0.5) * DX : 0.25 + (row + 0.5) * DX;
        int count = (int)round(2 * TEST_PI * r / DX);
        for (int k = 0; k < count; ++k)
            add_particle(sim, 1 + r * cos(2 * TEST_PI * k / count), 1 + r * sin(2 * TEST_PI * k / count));
    }
    sort_particles(sim);
    sph2d__store *w = &sim->system.walls;
    for (size_t b = 0; b < w->count; ++b) {
        w->vx[b] = -2 * (w->y[b] - 1);
        w->vy[b] = 2 * (w->x[b] - 1);
        sim->system.wall_spin[w->id[b]] = 2;
    }
}

/* Flow round a wall that turns, r w + 3 (r - R^2/r), has no Laplacian; its slope at the wall is 6/s. */
START_TEST(round_walls_turn_with_the_liquid)
{
    double R = _i ? 0.5 : 0.25, worst = 0;
    make_rings(_i);
    ck_assert(sim->system.walls_stick);
    sph2d__store *f = &sim->system.fluid;
    for (size_t i = 0; i < f->count; ++i) {
        double x = f->x[i] - 1, y = f->y[i] - 1, r = hypot(x, y), speed = 2 * r + 3 * (r - R * R / r);
        f->vx[i] = -speed * y / r;
        f->vy[i] = speed * x / r;
    }
    find_drag();
    for (size_t i = 0; i < f->count; ++i)
        if (fabs(hypot(f->x[i] - 1, f->y[i] - 1) - R) < sim->system.support)
            worst = fmax(worst, hypot(ax[i], ay[i]) / NU);
    ck_assert_double_le(worst, 0.1 * 6 / DX);
}
END_TEST

/* Over a box liquid is braked less at an edge than in the middle, though it is behind the other face there or right
 * before its plane. */
START_TEST(edges_brake_less)
{
    sph2d_obstacle box = sph2d_obstacle_default();
    box.outline = (sph2d_outline){.kind = SPH2D_OUTLINE_BOX, .box = {{0.5, 0.2}, {1.1, 0.6}}};
    sph2d_scene scene = channel_scene(NU);
    scene.domain = (sph2d_box){{0, 0}, {1.6, 1.6}};
    scene.boundary.left = scene.boundary.right = SPH2D_SIDE_WALL;
    scene.obstacles = &box;
    scene.obstacle_count = 1;
    sim = hand_made(scene, MOST, 1);
    add_lattice(sim, (sph2d_box){{0.5, 0.6}, {1.15, 1}}, 0, 1);
    sort_particles(sim);
    sph2d__store *f = &sim->system.fluid;
    for (size_t i = 0; i < f->count; ++i)
        f->vx[i] = 1;
    find_drag();
    double least = INFINITY, edge = 0;
    for (size_t i = 0; i < f->count; ++i) {
        if (f->y[i] > 0.6 + DX)
            continue;
        if (fabs(f->x[i] - 0.8) < DX)
            least = fmin(least, -ax[i]);
        if (f->x[i] > 1.1 - DX)
            edge = fmax(edge, -ax[i]);
    }
    ck_assert_double_gt(edge, 0);
    ck_assert_double_lt(edge, least);
}
END_TEST

/* In liquid so thick that viscosity limits the step, or nearly, images are those of the mean; it may be changed. */
START_TEST(thick_liquid_does_not)
{
    make_channel(1, SPH2D_PRECISION_DOUBLE, 0);
    ck_assert(!sim->system.walls_stick);
    sim->system.viscosity = NU * RHO;
    ck_assert(sph2d__wcsph.evaluate(&sim->system));
    ck_assert(sim->system.walls_stick);
}
END_TEST

Suite *suite_stick(void)
{
    Suite *suite = suite_create("stick");
    TCase *tests = tcase_create("stick");
    tcase_add_checked_fixture(tests, NULL, end);
    tcase_add_loop_test(tests, a_parabola_has_its_laplacian_at_the_wall, 0, 2);
    tcase_add_test(tests, walls_feel_what_the_liquid_loses);
    tcase_add_test(tests, the_velocity_of_the_wall_counts);
    tcase_add_loop_test(tests, round_walls_turn_with_the_liquid, 0, 2);
    tcase_add_test(tests, edges_brake_less);
    tcase_add_test(tests, thick_liquid_does_not);
    suite_add_tcase(suite, tests);
    return suite;
}
