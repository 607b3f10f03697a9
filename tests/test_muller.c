/* SPDX-License-Identifier: MIT */
/** @file test_muller.c
 *  Method `muller` against sums over all pairs (muller_pairs.h), and in special places. */
#include <math.h>
#include <string.h>

#include "methods/common/state_equation.h"
#include "muller_pairs.h"
#include "sim/simulation.h"

/** G as the simulation has it, between the two densities next to one. */
static double gain_of(const sph2d_sim *sim, double density)
{
    double place = fmin(fmax(density - 1, 0) * SPH2D__PAIR_GAINS / (SPH2D__PAIR_GAIN_TOP - 1), SPH2D__PAIR_GAINS);
    size_t k = (size_t)fmin(place, SPH2D__PAIR_GAINS - 1);
    const double *gain = sim->system.tables->pair_gain;
    return gain[k] * ((double)k + 1 - place) + gain[k + 1] * (place - (double)k);
}

/* ---- the simulation under test ----------------------------------------------------------------------------------- */

static sph2d_vec2 line[2] = {{-0.05, 0.013}, {0.08, -0.031}};

/** A simulation of side^2 particles, whose scene outlives it. */
static sph2d_sim *make(sph2d_isa isa, double ratio, double mu, bool walled, int side, int threads)
{
    static sph2d_obstacle obstacle;
    static sph2d_block block;
    obstacle = sph2d_obstacle_default();
    obstacle.shape.kind = SPH2D_SHAPE_LINE;
    obstacle.shape.points = (sph2d_points){line, 2};
    sph2d_scene scene = test_open_scene(DX, -1, -1, 1, 1);
    block = test_block(-0.9, -0.9, -0.9 + side * DX, -0.9 + side * DX);
    scene.blocks = &block;
    scene.block_count = 1;
    scene.obstacles = walled ? &obstacle : NULL;
    scene.obstacle_count = walled;
    scene.method.support_ratio = ratio;
    scene.fluid.dynamic_viscosity = mu;
    scene.method.artificial_viscosity = mu > 0 ? 0 : 1e-30; /* its default, or next to none */
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = threads;
    options.isa = isa;
    return test_create(&scene, &options);
}

/** Puts `count` particles at random into a square of liquid pressed together, and evaluates. */
static void scatter(sph2d_sim *sim, size_t count, uint64_t seed)
{
    sph2d__system *s = &sim->system;
    ck_assert_uint_le(count, s->fluid.count);
    s->fluid.count = count;
    double half = 0.4 * DX * sqrt((double)count); /* 1/0.64 times rest density */
    for (size_t i = 0; i < count; ++i) {
        s->fluid.x[i] = test_random(&seed, -half, half);
        s->fluid.y[i] = test_random(&seed, -half, half);
        s->fluid.vx[i] = test_random(&seed, -1, 1);
        s->fluid.vy[i] = test_random(&seed, -1, 1);
    }
    ck_assert(sph2d__cells_build(&s->fluid_cells, &s->fluid, s->support, s->memory));
    sim->method->evaluate(s);
}

static void look(const sph2d_sim *sim)
{
    sph2d_view f = sph2d_sim_fluid(sim), w = sph2d_sim_walls(sim);
    ck_assert_uint_le(f.count, 4 * COUNT);
    ck_assert_uint_le(w.count, WALLS_MOST);
    memset(&walls, 0, sizeof walls);
    fluid.count = f.count;
    walls.count = w.count;
    memcpy(fluid.x, f.x, f.count * sizeof(double));
    memcpy(fluid.y, f.y, f.count * sizeof(double));
    memcpy(fluid.vx, f.vx, f.count * sizeof(double));
    memcpy(fluid.vy, f.vy, f.count * sizeof(double));
    if (w.count > 0) {
        memcpy(walls.x, w.x, w.count * sizeof(double));
        memcpy(walls.y, w.y, w.count * sizeof(double));
    }
}

/** Compares everything with the sums over all pairs; `g` is what gravity adds. */
static void compare(const sph2d_sim *sim, sph2d_vec2 g)
{
    liquid l = liquid_of(sph2d_sim_scene(sim));
    look(sim);
    sum_densities(&l);
    for (size_t i = 0; i < fluid.count; ++i)
        fluid.gain[i] = gain_of(sim, fluid.rho[i] / l.rho0);
    sph2d_view f = sph2d_sim_fluid(sim), w = sph2d_sim_walls(sim);
    double rho_error = 0, p_error = 0, a_error = 0;
    for (size_t i = 0; i < f.count; ++i) {
        double a[2] = {0, 0}, size = hypot(g.x, g.y) + 1e-300;
        add_forces(&l, i, &fluid, a, &size);
        add_forces(&l, i, &walls, a, &size);
        rho_error = fmax(rho_error, fabs(f.density[i] / fluid.rho[i] - 1));
        p_error = fmax(p_error, fabs(f.pressure[i] - l.carried * fluid.p[i]) / (l.stiffness * l.rho0));
        a_error = fmax(a_error, hypot(f.ax[i] - a[0] - g.x, f.ay[i] - a[1] - g.y) / size);
    }
    for (size_t b = 0; b < w.count; ++b) {
        rho_error = fmax(rho_error, fabs(w.density[b] / walls.rho[b] - 1));
        p_error = fmax(p_error, fabs(w.pressure[b] - l.carried * walls.p[b]) / (l.stiffness * l.rho0));
    }
    ck_assert_double_le(rho_error, 1e-12);
    ck_assert_double_le(p_error, 1e-11);
    ck_assert_double_le(a_error, 1e-12);
}

static bool missing(sph2d_isa isa)
{
    return !sph2d_isa_available(isa);
}

/** Loop index: instruction set, viscosity or none, obstacle or none. */
enum { CASES = 3 * 2 * 2 };

static sph2d_isa isa_of(int index)
{
    return (sph2d_isa)(SPH2D_ISA_BASELINE + index / 4);
}

START_TEST(all_pairs_agree)
{
    static const double ratios[] = {2.0, 2.6, 4.0};
    if (missing(isa_of(_i)))
        return;
    for (int k = 0; k < 3; ++k) {
        sph2d_sim *sim = make(isa_of(_i), ratios[k], _i & 1 ? 30 : 0, _i & 2, SIDE, 1);
        ck_assert_int_eq(sph2d_sim_isa(sim), isa_of(_i));
        ck_assert_uint_eq(sph2d_sim_walls(sim).count, _i & 2 ? 15 : 0); /* 13.7 spacings: 14 pieces */
        scatter(sim, COUNT, 100 + (uint64_t)k);
        compare(sim, (sph2d_vec2){0, 0});
        sph2d_sim_destroy(sim);
    }
}
END_TEST

START_TEST(any_number_of_particles_agrees)
{
    /* Blocks of lanes end in the middle of cells, and at the store's end. */
    if (missing(isa_of(_i)))
        return;
    sph2d_sim *sim = make(isa_of(_i), 2.6, _i & 1 ? 30 : 0, _i & 2, SIDE, 1);
    for (size_t count = 1; count <= 36; count += count < 19 ? 1 : 17) {
        sim->system.fluid.count = COUNT;
        scatter(sim, count, count);
        compare(sim, (sph2d_vec2){0, 0});
    }
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(threads_and_gravity_agree)
{
    if (missing(isa_of(_i)))
        return;
    /* Two particle grains and more: a second thread takes part. */
    sph2d_sim *sim = make(isa_of(_i), 2.0, _i & 1 ? 5 : 0, _i & 2, 40, 2);
    sim->system.forces.gravity.x = 3;
    sim->system.forces.gravity.y = -9.81;
    scatter(sim, 4 * COUNT, 9);
    compare(sim, (sph2d_vec2){3, -9.81});
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(inner_forces_do_not_push_or_turn_the_whole)
{
    /* Pair forces are antisymmetric; without viscosity they act along the line between the two. */
    if (missing(isa_of(_i)) || _i & 2)
        return;
    sph2d_sim *sim = make(isa_of(_i), 2.6, _i & 1 ? 30 : 0, false, SIDE, 1);
    scatter(sim, COUNT, 31);
    sph2d_view f = sph2d_sim_fluid(sim);
    double sum[2] = {0, 0}, turn = 0, size = 0, turn_size = 0;
    for (size_t i = 0; i < f.count; ++i) {
        sum[0] += f.ax[i];
        sum[1] += f.ay[i];
        turn += f.x[i] * f.ay[i] - f.y[i] * f.ax[i];
        size += hypot(f.ax[i], f.ay[i]);
        turn_size += hypot(f.x[i], f.y[i]) * hypot(f.ax[i], f.ay[i]);
    }
    ck_assert_double_gt(size / (double)f.count, 100); /* there are forces */
    ck_assert_double_le(hypot(sum[0], sum[1]), 1e-14 * size);
    if (!(_i & 1))
        ck_assert_double_le(fabs(turn), 1e-14 * turn_size);
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- special places ---------------------------------------------------------------------------------------------- */

START_TEST(a_filled_lattice_has_rest_density)
{
    static const double ratios[] = {1.2, 2.0, 2.6, 3.0, 4.0, 6.0};
    sph2d_sim *sim = make(SPH2D_ISA_AUTO, ratios[_i], 0, false, SIDE, 1);
    sph2d_view f = sph2d_sim_fluid(sim);
    double middle = -0.9 + SIDE / 2 * DX, inner = 0;
    for (size_t i = 0; i < f.count; ++i)
        if (fmax(fabs(f.x[i] - middle), fabs(f.y[i] - middle)) < 3 * DX)
            inner = fmax(inner, fabs(f.density[i] / 1000 - 1));
    ck_assert_double_le(inner, 1e-12);
    sph2d_sim_destroy(sim);
}
END_TEST

/** Evaluates two particles `distance` apart along x and tells the first's acceleration. */
static sph2d_vec2 pair(sph2d_sim *sim, double distance)
{
    sph2d__store *f = &sim->system.fluid;
    f->count = 2;
    for (size_t i = 0; i < 2; ++i) {
        f->x[i] = i == 0 ? 0 : distance;
        f->y[i] = 0;
        f->vx[i] = f->vy[i] = 0;
        f->id[i] = i;
    }
    ck_assert(sph2d__cells_build(&sim->system.fluid_cells, f, sim->system.support, sim->system.memory));
    sim->method->evaluate(&sim->system);
    size_t first = f->id[0] == 0 ? 0 : 1;
    ck_assert(isfinite(f->ax[0]) && isfinite(f->ay[0]) && isfinite(f->density[0]) && isfinite(f->pressure[0]));
    ck_assert(f->ay[0] == 0 && f->ay[1] == 0);
    ck_assert(f->ax[0] == -f->ax[1]);
    return (sph2d_vec2){f->ax[first], f->ay[first]};
}

START_TEST(particles_on_each_other_stay_finite)
{
    /* At H/dx = 1.2 two on one place have 1.77 c of rest density, so they press. No direction: no force at r = 0. */
    static const double distances[] = {0, 1e-300, 1e-160, 1e-22, 1e-17, 1e-12};
    sph2d_isa isa = (sph2d_isa)_i;
    if (missing(isa))
        return;
    sph2d_sim *sim = make(isa, 1.2, 5, false, SIDE, 1);
    for (size_t k = 0; k < sizeof distances / sizeof distances[0]; ++k) {
        sph2d_vec2 a = pair(sim, distances[k]);
        ck_assert_double_gt(sim->system.fluid.pressure[0], 0);
        /* V p slope(0) / rho is the force at r -> 0+; no distance may give more. */
        liquid l = liquid_of(sph2d_sim_scene(sim));
        double rho = sim->system.fluid.density[0], p = sim->system.fluid.pressure[0] / l.carried;
        double most = l.mass / rho * gain_of(sim, rho / l.rho0) * p * 30 / (TEST_PI * pow(l.support, 3)) / rho;
        ck_assert_double_le(-a.x, most * (1 + 1e-12));
        ck_assert_double_ge(-a.x, 0);
        if (distances[k] == 0)
            ck_assert(a.x == 0);
        if (distances[k] >= 1e-12)
            ck_assert_double_ge(-a.x, most * 0.999);
    }
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(particles_at_the_support_do_not_meet)
{
    sph2d_sim *sim = make(SPH2D_ISA_AUTO, 2.0, 5, false, SIDE, 1);
    liquid l = liquid_of(sph2d_sim_scene(sim));
    double alone = l.calibration * l.mass * kernel(l.support, 0);
    static const double factors[] = {1, 1 + 1e-15, 1 - 1e-15, 1 + 1e-9, 1.5};
    for (size_t k = 0; k < sizeof factors / sizeof factors[0]; ++k) {
        sph2d_vec2 a = pair(sim, l.support * factors[k]);
        ck_assert_double_le(fabs(a.x), 1e-20);
        ck_assert_double_eq_tol(sim->system.fluid.density[0] / alone, 1, 1e-14);
        ck_assert_double_eq_tol(sim->system.fluid.density[1] / alone, 1, 1e-14);
    }
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(pairs_of_a_pressed_lattice_do_the_work_that_is_told)
{
    static const double ratios[] = {1.32, 1.6, 2, 2.4, 3};
    sph2d_sim *sim = make(SPH2D_ISA_AUTO, ratios[_i], 0, false, SIDE, 1);
    liquid l = liquid_of(sph2d_sim_scene(sim));
    for (int k = 0; k <= SPH2D__PAIR_GAINS; k += 8) {
        double density = 1 + (double)k * (SPH2D__PAIR_GAIN_TOP - 1) / SPH2D__PAIR_GAINS;
        ck_assert_double_eq_tol(sim->system.tables->pair_gain[k] / pair_gain(&l, density), 1, 1e-6);
    }
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(tension_is_cut_off)
{
    sph2d_sim *sim = make(SPH2D_ISA_AUTO, 2.0, 0, false, SIDE, 1);
    sph2d_vec2 a = pair(sim, 0.9 * DX); /* far below rest density */
    ck_assert(sim->system.fluid.density[0] < 700);
    ck_assert(sim->system.fluid.pressure[0] == 0 && a.x == 0);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(steps_are_as_long_as_is_stable)
{
    sph2d_sim *sim = make(SPH2D_ISA_AUTO, 2.0, 0, false, SIDE, 1);
    sph2d__system *s = &sim->system;
    double h = s->support, acoustic = s->method.cfl * h / (s->sound_speed + 2);
    s->viscosity = _i ? 100 * s->rest_density : 0;
    double viscous = _i ? 0.04 * h * h / 100 : INFINITY, force = 0.25 * sqrt(h / 1e7);
    sph2d__limit limit;
    ck_assert_double_eq_tol(sim->method->stable_step(s, 2, 0, &limit), fmin(acoustic, viscous), 1e-15);
    ck_assert_int_eq(limit, viscous < acoustic ? SPH2D__LIMIT_VISCOUS : SPH2D__LIMIT_ACOUSTIC);
    ck_assert_double_eq_tol(sim->method->stable_step(s, 2, 1e7, &limit), fmin(force, viscous), 1e-15);
    sph2d_sim_destroy(sim);
}
END_TEST

Suite *suite_muller(void)
{
    Suite *suite = suite_create("muller");
    TCase *sums = tcase_create("sums");
    tcase_add_loop_test(sums, all_pairs_agree, 0, CASES);
    tcase_add_loop_test(sums, any_number_of_particles_agrees, 0, CASES);
    tcase_add_loop_test(sums, threads_and_gravity_agree, 0, CASES);
    tcase_add_loop_test(sums, inner_forces_do_not_push_or_turn_the_whole, 0, CASES);
    suite_add_tcase(suite, sums);
    TCase *places = tcase_create("places");
    tcase_add_loop_test(places, a_filled_lattice_has_rest_density, 0, 6);
    tcase_add_loop_test(places, particles_on_each_other_stay_finite, SPH2D_ISA_BASELINE, SPH2D_ISA_AVX512 + 1);
    tcase_add_test(places, particles_at_the_support_do_not_meet);
    tcase_add_loop_test(places, pairs_of_a_pressed_lattice_do_the_work_that_is_told, 0, 5);
    tcase_add_test(places, tension_is_cut_off);
    tcase_add_loop_test(places, steps_are_as_long_as_is_stable, 0, 2);
    suite_add_tcase(suite, places);
    return suite;
}
