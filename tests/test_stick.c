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

/** Liquid between two walls at rest, periodic along x, 12 by 20 spacings. */
static void make_channel(double nu, sph2d_precision precision, double jitter)
{
    sph2d_scene scene = test_scene(DX, 0, 0, 0.6, 1);
    scene.boundary.left = scene.boundary.right = SPH2D_SIDE_PERIODIC;
    scene.method = sph2d_scene_default().method;
    scene.method.precision = precision;
    scene.method.sound_speed = 20;
    scene.method.viscosity_form = SPH2D_VISCOSITY_MORRIS;
    scene.method.turbulence = SPH2D_TURBULENCE_NONE;
    scene.wall_slip = SPH2D_SLIP_NONE;
    scene.fluid.density = RHO;
    scene.fluid.dynamic_viscosity = RHO * nu;
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
    tcase_add_test(tests, thick_liquid_does_not);
    suite_add_tcase(suite, tests);
    return suite;
}
