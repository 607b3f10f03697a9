/* SPDX-License-Identifier: MIT */
/** @file test_reported_pressure.c
 *  Pressures that methods `pcisph` and `constraint` report (projection.h): a fit to those of the liquid around, which
 *  leaves linear fields as they are and takes away what changes sign from particle to particle. */
#include <math.h>

#include "common.h"
#include "methods/projection/projection.h"
#include "sim/stages.h"

static sph2d_scene scene;
static sph2d_block block;
static sph2d_sim *sim;

static const double DX = 0.02;

static void finish(void)
{
    sph2d_sim_destroy(sim);
    sim = NULL;
}

/** A pool with a free surface between walls, its particles off their lattice by up to `jitter` spacings. */
static void pool(sph2d_method method, double jitter)
{
    scene = test_scene(DX, 0, 0, 0.6, 0.8);
    scene.boundary.top = SPH2D_SIDE_OPEN;
    scene.gravity.y = -9.81;
    scene.method = sph2d_scene_default().method;
    scene.method.name = method;
    block = test_block(0, 0, 0.6, 0.5);
    block.perturb = (sph2d_perturb){.amplitude = jitter, .seed = 7};
    scene.blocks = &block;
    scene.block_count = 1;
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = 1;
    sim = test_create(&scene, &options);
}

static double linear_at(double x, double y)
{
    return 3000 + 700 * x - 4000 * y;
}

START_TEST(linear_fields_stay_as_they_are)
{
    pool(SPH2D_METHOD_PCISPH, 0.2);
    sph2d__store *f = &sim->system.fluid, *w = &sim->system.walls;
    for (size_t i = 0; i < f->count; ++i)
        f->acting_pressure[i] = linear_at(f->x[i], f->y[i]);
    for (size_t b = 0; b < w->count; ++b)
        w->acting_pressure[b] = fmax(linear_at(w->x[b], w->y[b]), 0);
    sph2d__projection_average(&sim->system);
    for (size_t i = 0; i < f->count; ++i)
        ck_assert_double_eq_tol(f->pressure[i], linear_at(f->x[i], f->y[i]), 1e-9 * 3000);
}
END_TEST

/** Nor does a fit make a pressure of none. */
START_TEST(without_a_pressure_none_is_reported)
{
    pool(SPH2D_METHOD_PCISPH, 0.2);
    sph2d__store *f = &sim->system.fluid, *w = &sim->system.walls;
    for (size_t i = 0; i < f->count; ++i) {
        f->acting_pressure[i] = 0;
        f->pressure[i] = 7;
    }
    for (size_t b = 0; b < w->count; ++b)
        w->acting_pressure[b] = 0;
    sph2d__projection_average(&sim->system);
    for (size_t i = 0; i < f->count; ++i)
        ck_assert_double_eq(f->pressure[i], 0);
}
END_TEST

/* Particle i of the lattice in column a, row b has 1000 Pa, plus 100 Pa times (-1)^(a + b), (-1)^a or (-1)^b. */
static double sign_of(const sph2d__store *f, size_t i, int kind)
{
    long a = lround(f->x[i] / DX - 0.5), b = lround(f->y[i] / DX - 0.5), n = kind == 0 ? a + b : kind == 1 ? a : b;
    return n % 2 ? -1 : 1;
}

START_TEST(what_alternates_is_gone)
{
    pool(SPH2D_METHOD_PCISPH, 0);
    sph2d__store *f = &sim->system.fluid;
    for (size_t i = 0; i < f->count; ++i)
        f->acting_pressure[i] = 1000 + 100 * sign_of(f, i, _i);
    sph2d__projection_average(&sim->system);
    double h = sim->system.support, most = 0;
    for (size_t i = 0; i < f->count; ++i)
        if (f->x[i] > h && f->x[i] < 0.6 - h && f->y[i] > h && f->y[i] < 0.5 - h)
            most = fmax(most, fabs(f->pressure[i] - 1000));
    ck_assert_double_lt(most, 8);
    ck_assert_double_gt(most, 0);
}
END_TEST

START_TEST(lone_particles_keep_their_own)
{
    pool(SPH2D_METHOD_PCISPH, 0);
    sph2d__store *f = &sim->system.fluid;
    sph2d_sim_step(sim, NULL);
    size_t i = f->count - 1;
    f->x[i] = 0.3;
    f->y[i] = 0.75;
    ck_assert(sph2d__cells_build(&sim->system.fluid_cells, f, sim->system.reach, &sim->memory));
    ck_assert(sim->method->evaluate(&sim->system));
    for (size_t k = 0; k < f->count; ++k)
        f->acting_pressure[k] = f->y[k] > 0.7 ? 250 : 1000;
    sph2d__projection_average(&sim->system);
    for (size_t k = 0; k < f->count; ++k)
        if (f->y[k] > 0.7)
            ck_assert_double_eq(f->pressure[k], 250);
}
END_TEST

Suite *suite_reported_pressure(void)
{
    Suite *suite = suite_create("reported_pressure");
    TCase *tests = tcase_create("reported_pressure");
    tcase_add_checked_fixture(tests, NULL, finish);
    tcase_add_test(tests, linear_fields_stay_as_they_are);
    tcase_add_test(tests, without_a_pressure_none_is_reported);
    tcase_add_loop_test(tests, what_alternates_is_gone, 0, 3);
    tcase_add_test(tests, lone_particles_keep_their_own);
    suite_add_tcase(suite, tests);
    return suite;
}
