/* SPDX-License-Identifier: MIT */
/** @file test_conservation.c
 *  What whole runs of method `wcsph` keep: momentum, energy, the way back, the order of the steps. Energy needs a
 *  liquid in which nothing dissipates or shifts. */
#include <math.h>
#include <string.h>

#include "cloud.h"
#include "sim/simulation.h"

static const double RHO0 = 1000;

typedef struct totals {
    double px, py, turn, energy;
} totals;

/** Momentum, angular momentum about the origin, and kinetic plus elastic energy: m c0^2 (ln x + 1/x - 1), x = rho/rho0,
 *  is what p = c0^2 (rho - rho0) stores. */
static totals totals_of(const sph2d_sim *sim)
{
    const sph2d__system *s = &sim->system;
    const sph2d__store *f = &s->fluid;
    totals t = {0, 0, 0, 0};
    for (size_t i = 0; i < f->count; ++i) {
        double x = f->density[i] / RHO0, v2 = f->vx[i] * f->vx[i] + f->vy[i] * f->vy[i];
        t.px += s->mass * f->vx[i];
        t.py += s->mass * f->vy[i];
        t.turn += s->mass * (f->x[i] * f->vy[i] - f->y[i] * f->vx[i]);
        t.energy += s->mass * (v2 / 2 + s->sound_speed * s->sound_speed * (log(x) + 1 / x - 1));
    }
    return t;
}

/* ---- momentum ---------------------------------------------------------------------------------------------------- */

START_TEST(momentum_is_kept_to_round_off)
{
    cloud_start();
    cloud.scene.fluid.dynamic_viscosity = 2;
    sph2d_sim *sim = test_create(&cloud.scene, NULL);
    cloud_stir(sim, 0.5);
    totals start = totals_of(sim);
    test_steps(sim, 200);
    totals end = totals_of(sim);
    double size = 400 * sim->system.mass * 0.5;
    ck_assert_double_eq_tol(end.px, start.px, 1e-12 * size);
    ck_assert_double_eq_tol(end.py, start.py, 1e-12 * size);
    ck_assert_double_eq_tol(end.turn, start.turn, 4e-5 * size); /* dissipation of what is not linear turns pairs */
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- energy and time --------------------------------------------------------------------------------------------- */

/** A sound wave in a periodic box, of amplitude 0.02 c0. */
static sph2d_sim *wave(double time_step)
{
    cloud.scene = test_scene(0.05, 0, 0, 1, 1);
    cloud.scene.boundary =
        (sph2d_boundary){SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC};
    cloud_plain(10);
    cloud.scene.method.time_step = time_step;
    cloud.blocks[0] = test_block(0, 0, 1, 1);
    cloud.scene.blocks = cloud.blocks;
    cloud.scene.block_count = 1;
    sph2d_sim *sim = test_create(&cloud.scene, NULL);
    sph2d__store *f = &sim->system.fluid;
    for (size_t i = 0; i < f->count; ++i) {
        f->vx[i] = 0.2 * sin(2 * TEST_PI * f->x[i]);
        f->vy[i] = 0.1 * cos(2 * TEST_PI * f->x[i]);
    }
    return sim;
}

/** Places after 0.3 s, by particle number. */
static void places_after(double time_step, double x[400])
{
    sph2d_sim *sim = wave(time_step);
    test_steps(sim, (int)(0.3 / time_step + 0.5));
    for (size_t i = 0; i < sim->system.fluid.count; ++i)
        x[sim->system.fluid.id[i]] = sim->system.fluid.x[i];
    sph2d_sim_destroy(sim);
}

START_TEST(steps_are_better_than_of_first_order)
{
    static double x[3][400];
    for (int k = 0; k < 3; ++k)
        places_after(0.002 / (1 << k), x[k]);
    double first = 0, second = 0;
    for (int i = 0; i < 400; ++i) {
        first = fmax(first, fabs(sph2d__period_nearest(x[0][i] - x[1][i], 1)));
        second = fmax(second, fabs(sph2d__period_nearest(x[1][i] - x[2][i], 1)));
    }
    ck_assert_double_gt(log2(first / second), 1.1); /* limiters of dissipation and neighbours of a step's middle: 1.2 */
    ck_assert_double_lt(log2(first / second), 2.5);
}
END_TEST

/* ---- forces ------------------------------------------------------------------------------------------------------ */

/* a = g - B^2 (x - center), on a particle alone. */
START_TEST(a_central_force_pulls)
{
    cloud_start();
    cloud.blocks[0] = test_particle(0.05, 0.3, 0.4, 0, 0);
    cloud.scene.gravity = (sph2d_vec2){0.5, -0.25};
    cloud.scene.central_force.center = (sph2d_vec2){0.1, 0.9};
    cloud.scene.central_force.rate = 2;
    sph2d_sim *sim = test_create(&cloud.scene, NULL);
    ck_assert_double_eq_tol(sim->system.fluid.ax[0], 0.5 - 4 * 0.2, 1e-12);
    ck_assert_double_eq_tol(sim->system.fluid.ay[0], -0.25 + 4 * 0.5, 1e-12);
    sph2d_sim_destroy(sim);
}
END_TEST

/* A block falls onto a floor and splashes up the walls: nothing gains energy there. Spray is as fast as 9 m/s, and as
 * 13.3 in the worst of 110 runs that differ in round-off. */
START_TEST(a_splash_gains_no_energy)
{
    cloud.scene = test_scene(0.02, -0.8, -0.8, 0.8, 0.8);
    cloud.scene.boundary.top = SPH2D_SIDE_OPEN;
    cloud.scene.gravity.y = -9.81;
    cloud.scene.fluid.dynamic_viscosity = 1;
    cloud.scene.method = sph2d_scene_default().method;
    cloud.scene.method.name = SPH2D_METHOD_WCSPH;
    cloud.scene.method.max_compression = 0.1;
    cloud.blocks[0] = test_block(-0.24, -0.6, 0.24, -0.12);
    cloud.scene.blocks = cloud.blocks;
    cloud.scene.block_count = 1;
    sph2d_sim *sim = test_create(&cloud.scene, NULL);
    while (sph2d_sim_time(sim) < 0.6) {
        test_steps(sim, 20);
        sph2d_summary s = sph2d_sim_summary(sim);
        ck_assert_double_lt(s.kinetic + s.potential, s.energy_start * (1 + 1e-9));
        ck_assert_double_lt(s.speed_max, 15);
    }
    sph2d_sim_destroy(sim);
}
END_TEST

Suite *suite_conservation(void)
{
    Suite *suite = suite_create("conservation");
    TCase *tests = tcase_create("conservation");
    tcase_add_test(tests, momentum_is_kept_to_round_off);
    tcase_add_test(tests, a_central_force_pulls);
    tcase_add_test(tests, a_splash_gains_no_energy);
    suite_add_tcase(suite, tests);
    TCase *slow = test_long(suite);
    tcase_add_test(slow, steps_are_better_than_of_first_order);
    return suite;
}
