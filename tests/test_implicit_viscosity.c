/* SPDX-License-Identifier: MIT */
/** @file test_implicit_viscosity.c
 *  Viscosity that a step solves for, by method constraint: steps far longer than explicit ones, steady flow
 *  that does not depend on them, both momenta, friction and energy of walls that move, other laws of viscosity. */
#include <math.h>
#include <string.h>

#include "common.h"
#include "sim/simulation.h"

static sph2d_scene scene;
static sph2d_block block;

static void thick(double spacing, double width, double height, double viscosity)
{
    scene = sph2d_scene_default();
    scene.domain = (sph2d_box){{0, 0}, {width, height}};
    scene.spacing = spacing;
    scene.gravity = (sph2d_vec2){0, 0};
    scene.method.name = SPH2D_METHOD_CONSTRAINT;
    scene.fluid.dynamic_viscosity = viscosity;
    block = test_block(0, 0, width, height);
    scene.blocks = &block;
    scene.block_count = 1;
}

static void run_until(sph2d_sim *sim, double time)
{
    while (sph2d_sim_time(sim) < time)
        test_steps(sim, 1);
}

/* ---- channels ---------------------------------------------------------------------------------------------------- */

/** A channel 20 spacings wide with nu = 1 m^2/s, driven to 0.01 m/s; steps of nu dt/H^2 = `number`. */
static sph2d_sim *channel(double number)
{
    const double dx = 0.05, support = 2.4 * dx;
    thick(dx, 0.5, 1, 1000);
    scene.boundary = (sph2d_boundary){SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL};
    scene.wall_slip = SPH2D_SLIP_NONE;
    scene.gravity.x = 0.08;
    scene.method.time_step = number * support * support;
    return test_create(&scene, NULL);
}

/** Mean velocity over that of the parabola, and the rms difference from it over the largest. */
static double mean_of(const sph2d_sim *sim, double *rms)
{
    sph2d_view f = sph2d_sim_fluid(sim);
    double sum = 0, exact = 0, square = 0;
    for (size_t i = 0; i < f.count; ++i) {
        double u = 0.04 * f.y[i] * (1 - f.y[i]);
        sum += f.vx[i];
        exact += u;
        square += (f.vx[i] - u) * (f.vx[i] - u);
    }
    *rms = sqrt(square / (double)f.count) / 0.01;
    return sum / exact;
}

START_TEST(a_steady_flow_does_not_depend_on_the_step)
{
    double means[2], rms;
    for (int k = 0; k < 2; ++k) {
        sph2d_sim *sim = channel(k == 0 ? 10 : 0.3);
        run_until(sim, 3);
        means[k] = mean_of(sim, &rms);
        ck_assert_double_eq_tol(means[k], 1, 0.04); /* the lattice has 0.97 of the viscosity */
        ck_assert_double_lt(rms, 0.03);
        sph2d_summary sum = sph2d_sim_summary(sim);
        ck_assert_uint_eq(sum.limited_by[2], 0);
        sph2d_sim_destroy(sim);
    }
    ck_assert_double_eq_tol(means[0], means[1], 0.005);
}
END_TEST

/* Implicit steps of Euler's method: a mode that decays at the rate s is 1/(1 + s dt) of it after a step. */
START_TEST(shear_decays_by_the_law)
{
    const double dx = 0.02, nu = 0.5, dt = 4e-3, k = 2 * 3.14159265358979323846;
    thick(dx, 1, 1, 1000 * nu);
    scene.boundary =
        (sph2d_boundary){SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC};
    scene.method.time_step = dt;
    scene.method.sound_speed = 10;
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d__store *f = &sim->system.fluid;
    double steps = 10, before = 0, after = 0;
    for (size_t i = 0; i < f->count; ++i) {
        f->vx[i] = 1e-3 * sin(k * f->y[i]);
        before += f->vx[i] * sin(k * f->y[i]);
    }
    test_steps(sim, (int)steps);
    for (size_t i = 0; i < f->count; ++i)
        after += f->vx[i] * sin(k * f->y[i]);
    /* 0.97 of the viscosity on a lattice that slides along its rows */
    ck_assert_double_eq_tol(pow(before / after, 1 / steps) - 1, nu * k * k * dt, 0.05 * nu * k * k * dt);
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- what is kept ------------------------------------------------------------------------------------------------ */

static void momenta(const sph2d_sim *sim, double out[3], double *scale)
{
    sph2d_view f = sph2d_sim_fluid(sim);
    out[0] = out[1] = out[2] = *scale = 0;
    for (size_t i = 0; i < f.count; ++i) {
        out[0] += f.vx[i];
        out[1] += f.vy[i];
        out[2] += f.x[i] * f.vy[i] - f.y[i] * f.vx[i];
        *scale += hypot(f.vx[i], f.vy[i]);
    }
}

/* A disc of liquid as thick as pitch, in the air, goes on turning: a rotation has no stress. What shears it dies out, and
 * both momenta are kept. */
START_TEST(a_disc_goes_on_turning)
{
    const double dx = 0.02, turn = 1;
    thick(dx, 1, 1, 2e3);
    scene.domain = (sph2d_box){{-1, -1}, {1, 1}};
    scene.boundary = (sph2d_boundary){SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN};
    block.shape.kind = SPH2D_SHAPE_CIRCLE;
    block.shape.circle = (sph2d_circle){{0, 0}, 0.2};
    scene.method.sound_speed = 10;
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d__store *f = &sim->system.fluid;
    for (size_t i = 0; i < f->count; ++i) { /* turns, drifts and is sheared */
        f->vx[i] = -turn * f->y[i] + 0.1 + 0.5 * f->y[i] * f->y[i];
        f->vy[i] = turn * f->x[i];
    }
    double before[3], after[3], scale;
    momenta(sim, before, &scale);
    while (sph2d_sim_time(sim) < 0.2)
        test_steps(sim, 1);
    momenta(sim, after, &scale);
    for (int k = 0; k < 3; ++k)
        ck_assert_double_le(fabs(after[k] - before[k]), 1e-6 * scale);
    double mx = after[0] / (double)f->count, my = after[1] / (double)f->count, x = 0, y = 0, l = 0, r2 = 0, rest = 0;
    for (size_t i = 0; i < f->count; ++i) {
        x += f->x[i] / (double)f->count;
        y += f->y[i] / (double)f->count;
    }
    for (size_t i = 0; i < f->count; ++i) {
        l += (f->x[i] - x) * (f->vy[i] - my) - (f->y[i] - y) * (f->vx[i] - mx);
        r2 += pow(f->x[i] - x, 2) + pow(f->y[i] - y, 2);
    }
    for (size_t i = 0; i < f->count; ++i)
        rest += pow(f->vx[i] - mx + l / r2 * (f->y[i] - y), 2) + pow(f->vy[i] - my - l / r2 * (f->x[i] - x), 2);
    ck_assert_double_gt(l / r2, 0.9 * turn);
    ck_assert_double_lt(sqrt(rest / (double)f->count), 0.03 * turn * 0.2);
    sph2d_sim_destroy(sim);
}
END_TEST

/* The upper wall slides: its work is what friction takes and the liquid keeps, and the force on it that of Couette. */
START_TEST(a_sliding_wall_works)
{
    const double dx = 0.05, mu = 100, speed = 0.1;
    thick(dx, 0.5, 1, mu);
    scene.boundary = (sph2d_boundary){SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL};
    scene.wall_slip = SPH2D_SLIP_NONE;
    scene.wall_speeds.top = speed;
    scene.method.time_step = 0.02;
    sph2d_probe probe = sph2d_probe_default();
    probe.name = "top";
    probe.on = "top";
    probe.kind = SPH2D_PROBE_FORCE;
    probe.rate.every = 0.02;
    scene.probes = &probe;
    scene.probe_count = 1;
    sph2d_sim *sim = test_create(&scene, NULL);
    run_until(sim, 20);
    double first = sph2d_sim_summary(sim).energy_walls;
    run_until(sim, 40);
    double values[SPH2D_PROBE_MAX_COLUMNS] = {0};
    ck_assert_uint_ge(sph2d_sim_probe(sim, 0, values), 2);
    ck_assert_double_eq_tol(values[0], -mu * speed * 0.5, 0.04 * mu * speed * 0.5);
    sph2d_summary sum = sph2d_sim_summary(sim);
    double work = mu * speed * speed * 0.5 * 20;
    ck_assert_double_eq_tol(sum.energy_walls - first, work, 0.05 * work);
    ck_assert_double_eq_tol(sum.energy_viscous, sum.energy_walls - sum.kinetic, 5e-3 * work);
    ck_assert_double_le(fabs(sum.energy_error), 5e-3 * work);
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- what else there is ------------------------------------------------------------------------------------------ */

/* A power law, at a fifth of the shear rate on average: its profile between plates (test_rheology.c). */
START_TEST(other_laws_of_viscosity)
{
    thick(0.05, 0.5, 1, 1e-3);
    scene.boundary = (sph2d_boundary){SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL};
    scene.wall_slip = SPH2D_SLIP_NONE;
    scene.gravity.x = 1;
    scene.fluid = (sph2d_fluid){.density = 1,
                                .dynamic_viscosity = 1e-3,
                                .model = SPH2D_RHEOLOGY_POWER_LAW,
                                .consistency = 1,
                                .index = 0.6,
                                .regularisation = 50};
    block.perturb.amplitude = 0.2;
    sph2d_sim *sim = test_create(&scene, NULL);
    run_until(sim, 2);
    sph2d_view f = sph2d_sim_fluid(sim);
    double sum = 0, exact = 0;
    for (size_t i = 0; i < f.count; ++i) {
        sum += f.vx[i];
        exact += 0.6 / 1.6 * (pow(0.5, 1 + 1 / 0.6) - pow(fabs(f.y[i] - 0.5), 1 + 1 / 0.6));
    }
    ck_assert_double_eq_tol(sum / exact, 1, 0.06);
    sph2d_sim_destroy(sim);
}
END_TEST

/* With few neighbours a particle's pressure is another in each step. By the last step's pressures friction gave 1.5 J here at 2 Pa s. */
START_TEST(a_column_that_collapses_gets_no_energy)
{
    static const double viscosities[] = {2, 100};
    thick(0.01, 1, 0.6, viscosities[_i]);
    block = test_block(0, 0, 0.3, 0.5);
    scene.gravity.y = -9.81;
    scene.method.support_ratio = 2;
    sph2d_sim *sim = test_create(&scene, NULL);
    run_until(sim, 0.4);
    const sph2d_summary sum = sph2d_sim_summary(sim);
    ck_assert_double_lt(sum.energy_rise, 1e-5 * sum.energy_scale);
    ck_assert_double_lt(fabs(sum.energy_error), 1e-6 * sum.energy_scale);
    ck_assert_double_gt(sum.energy_viscous, 0);
    ck_assert_double_gt(sum.energy_viscous + sum.energy_pressed, 0);
    sph2d_sim_destroy(sim);
}
END_TEST

/* Honey that is poured onto a floor folds, and has as much volume as was poured: density goes to that of where particles are,
 * as far as friction pays for it. With the friction of an explicit step, which is none here, it swelled by 14 %. */
START_TEST(poured_honey_keeps_its_volume)
{
    thick(0.0014, 0.12, 0.06, 10);
    scene.fluid.density = 1420;
    scene.gravity.y = -9.81;
    scene.wall_slip = SPH2D_SLIP_NONE;
    scene.block_count = 0;
    sph2d_source source = sph2d_source_default();
    source.at = (sph2d_vec2){0.06, 0.05};
    source.width = 0.006;
    source.speed = 0.25;
    source.stop = 1;
    scene.sources = &source;
    scene.source_count = 1;
    sph2d_sim *sim = test_create(&scene, NULL);
    run_until(sim, 1.2);
    const sph2d_summary sum = sph2d_sim_summary(sim);
    ck_assert_double_le(fabs(sph2d_sim_densities(sim).covered - 1), 0.03);
    ck_assert_double_le(sum.energy_rise, 1e-6 * sum.energy_scale);
    ck_assert_double_le(fabs(sum.energy_error), 1e-6 * sum.energy_scale);
    sph2d_sim_destroy(sim);
}
END_TEST

/* Honey poured onto a floor, with one thread and three. */
START_TEST(any_number_of_threads)
{
    double sums[2] = {0};
    for (int k = 0; k < 2; ++k) {
        thick(0.01, 1, 0.6, 10);
        scene.gravity.y = -9.81;
        scene.wall_slip = SPH2D_SLIP_NONE;
        block = test_block(0.3, 0, 0.7, 0.4);
        sph2d_sim_options options = sph2d_sim_options_default();
        options.threads = k == 0 ? 1 : 3;
        sph2d_sim *sim = test_create(&scene, &options);
        test_steps(sim, 40);
        sph2d_view f = sph2d_sim_fluid(sim);
        for (size_t i = 0; i < f.count; ++i)
            sums[k] += (double)(i + 1) * f.x[i] + f.vy[i];
        sph2d_summary sum = sph2d_sim_summary(sim);
        ck_assert_double_le(sum.energy_rise, 1e-3 * sum.energy_scale);
        ck_assert_double_le(fabs(sum.energy_error), 0.01 * sum.energy_scale);
        sph2d_sim_destroy(sim);
    }
    ck_assert(memcmp(&sums[0], &sums[1], sizeof sums[0]) == 0);
}
END_TEST

Suite *suite_implicit_viscosity(void)
{
    Suite *suite = suite_create("implicit_viscosity");
    TCase *test = tcase_create("implicit_viscosity");
    tcase_add_test(test, a_steady_flow_does_not_depend_on_the_step);
    tcase_add_test(test, shear_decays_by_the_law);
    tcase_add_test(test, a_disc_goes_on_turning);
    tcase_add_test(test, other_laws_of_viscosity);
    suite_add_tcase(suite, test);
    TCase *slow = test_long(suite);
    tcase_add_test(slow, a_sliding_wall_works);
    tcase_add_loop_test(slow, a_column_that_collapses_gets_no_energy, 0, 2);
    tcase_add_test(slow, poured_honey_keeps_its_volume);
    tcase_add_test(slow, any_number_of_threads);
    return suite;
}
