/* SPDX-License-Identifier: MIT */
/** @file test_fitted.c
 *  Fitted operators of method `wcsph` on fields whose derivatives they must give exactly: quadratic polynomials
 *  far from walls. The equations are those of fitted.h. */
#include <math.h>

#include "common.h"
#include "methods/fitted/fitted.h"
#include "sim/simulation.h"

enum { SIDE = 20 };
static const double DX = 0.05, C0 = 10, RHO0 = 1000, NU = 0.02;

static sph2d_scene scene;
static sph2d_block block;
static sph2d_sim *sim;

static void start(void)
{
    scene = test_scene(DX, 0, 0, SIDE * DX, SIDE * DX);
    scene.boundary =
        (sph2d_boundary){SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC};
    scene.fluid.dynamic_viscosity = NU * RHO0;
    scene.method = sph2d_scene_default().method;
    scene.method.name = SPH2D_METHOD_WCSPH;
    scene.method.operators = SPH2D_OPERATORS_FITTED;
    scene.method.sound_speed = C0;
    block = test_block(0, 0, SIDE * DX, SIDE * DX);
    block.perturb.amplitude = 0.2;
    scene.blocks = &block;
    scene.block_count = 1;
}

static void finish(void)
{
    sph2d_sim_destroy(sim);
    sim = NULL;
}

static sph2d__store *make(sph2d_isa isa)
{
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = 1;
    options.isa = isa;
    sim = test_create(&scene, &options);
    return &sim->system.fluid;
}

/** Whether all neighbours are met without crossing a side. */
static bool is_inside(const sph2d__store *f, size_t i)
{
    double h = sim->system.support, end = SIDE * DX - h;
    return f->x[i] > h && f->x[i] < end && f->y[i] > h && f->y[i] < end;
}

/** Quadratic velocity and density. */
static void set_quadratic(sph2d__store *f)
{
    for (size_t i = 0; i < f->count; ++i) {
        double x = f->x[i], y = f->y[i];
        f->vx[i] = 1 + x - 2 * y + 3 * x * x - x * y + 2 * y * y;
        f->vy[i] = -2 * x + y - x * x + 2 * x * y - 4 * y * y;
        f->density[i] = RHO0 + 5 * x - 3 * y + 2 * x * x + 4 * x * y - y * y;
    }
}

START_TEST(quadratic_fields_are_exact)
{
    for (int isa = SPH2D_ISA_BASELINE; isa <= SPH2D_ISA_AVX512; ++isa) {
        if (!sph2d_isa_available((sph2d_isa)isa))
            continue;
        sph2d__store *f = make((sph2d_isa)isa);
        set_quadratic(f);
        sim->system.speed = _i ? 2 : 0; /* with and without a shift */
        sim->system.shift_gain = 4;
        sph2d__wcsph_fitted.evaluate(&sim->system);
        for (size_t i = 0; i < f->count; ++i) {
            if (!is_inside(f, i))
                continue;
            double x = f->x[i], y = f->y[i], wx = f->shift_x[i], wy = f->shift_y[i], rho = f->density[i];
            double ux = 1 + 6 * x - y, uy = -2 - x + 4 * y, vx = -2 - 2 * x + 2 * y, vy = 1 + 2 * x - 8 * y;
            double rx = 5 + 4 * x + 4 * y, ry = -3 + 4 * x - 2 * y;
            double ax = -C0 * C0 * rx / rho + NU * 10;
            double ay = -C0 * C0 * ry / rho - NU * 10;
            ck_assert_double_eq_tol(f->ax[i], ax, 1e-9);
            ck_assert_double_eq_tol(f->ay[i], ay, 1e-9);
            ck_assert_double_eq_tol(f->density_rate[i], -rho * (ux + vy), 1e-6);
            ck_assert_double_eq_tol(f->shift_ax[i], wx * ux + wy * uy, 1e-9);
            ck_assert_double_eq_tol(f->shift_ay[i], wx * vx + wy * vy, 1e-9);
            ck_assert_double_eq_tol(f->shift_density_rate[i], wx * rx + wy * ry, 1e-6);
            ck_assert((hypot(wx, wy) > 0) == (_i == 1));
        }
        finish();
    }
}
END_TEST

/* Three neighbours are too few for a parabola and enough for a plane; two on a line are too few for that. Lonely
 * particles come first in the same row of cells, and what lies in memory behind the last particle would be near. */
START_TEST(few_neighbours_give_a_plane_or_nothing)
{
    enum { LONELY = 5 };
    static const double x[4] = {0, 0.05, -0.01, -0.06}, y[4] = {0, 0.01, 0.06, -0.03}, x0 = 0.8, y0 = 0.56;
    sph2d__store *f = make(SPH2D_ISA_AUTO);
    f->count = LONELY + (_i ? 3 : 4);
    for (size_t i = 0; i < f->count; ++i) {
        f->x[i] = i < LONELY ? 0.01 + 0.13 * (double)i : x0 + x[i - LONELY];
        f->y[i] = i < LONELY || _i ? y0 : y0 + y[i - LONELY];
        f->vx[i] = 1 + 2 * f->x[i] - 3 * f->y[i];
        f->vy[i] = 4 * f->x[i] + 5 * f->y[i];
        f->density[i] = RHO0 + 6 * f->x[i] - 7 * f->y[i];
    }
    sim->system.speed = 0;
    ck_assert(sph2d__cells_build(&sim->system.fluid_cells, f, sim->system.support, &sim->memory));
    for (size_t i = f->count; i < f->count + SPH2D__PADDING; ++i) {
        f->x[i] = x0 + 0.02;
        f->y[i] = y0 + 0.02;
    }
    sph2d__wcsph_fitted.evaluate(&sim->system);
    for (size_t i = 0; i < f->count; ++i) {
        bool sloped = !_i && i >= LONELY;
        ck_assert_double_eq_tol(f->ax[i], sloped ? -C0 * C0 * 6 / f->density[i] : 0, 1e-9);
        ck_assert_double_eq_tol(f->ay[i], sloped ? C0 * C0 * 7 / f->density[i] : 0, 1e-9);
        ck_assert_double_eq_tol(f->density_rate[i], sloped ? -7 * f->density[i] : 0, 1e-6);
    }
}
END_TEST

START_TEST(shifts_lead_away_from_the_crowd)
{
    sph2d__store *f = make(SPH2D_ISA_AUTO);
    sim->system.speed = 2;
    sim->system.shift_gain = 4;
    sph2d__wcsph_fitted.evaluate(&sim->system);
    double h = sim->system.support, near = DX / h;
    for (size_t i = 0; i < f->count; ++i) {
        if (!is_inside(f, i))
            continue;
        double sx = 0, sy = 0;
        for (size_t j = 0; j < f->count; ++j) {
            double x = (f->x[j] - f->x[i]) / h, y = (f->y[j] - f->y[i]) / h, q = hypot(x, y), t = fmax(1 - q, 0);
            double c2 = pow(t, 4) * (1 + 4 * q) / (pow(1 - near, 4) * (1 + 4 * near));
            double w = 140 / TEST_PI * DX / h * DX / h * pow(t, 3) * (1 + 0.2 * pow(c2, 4));
            sx += w * x;
            sy += w * y;
        }
        double size = 8 * hypot(sx, sy), less = size > 1 ? 1 / size : 1; /* half the speed at most */
        ck_assert_double_eq_tol(f->shift_x[i], -8 * less * sx, 1e-10);
        ck_assert_double_eq_tol(f->shift_y[i], -8 * less * sy, 1e-10);
    }
}
END_TEST

/* In the middle of r^4 the Laplacian is zero; a fit alone sees one. */
START_TEST(the_laplacian_of_a_lattice_is_of_fourth_order)
{
    block.perturb.amplitude = 0;
    sph2d__store *f = make(SPH2D_ISA_AUTO);
    size_t middle = 0;
    while (!is_inside(f, middle))
        ++middle;
    for (size_t i = 0; i < f->count; ++i)
        f->vx[i] = pow(hypot(f->x[i] - f->x[middle], f->y[i] - f->y[middle]), 4);
    sph2d__wcsph_fitted.evaluate(&sim->system);
    double size = NU * sim->system.support * sim->system.support;
    ck_assert_double_eq_tol(f->ax[middle], 0, 1e-10 * size);
}
END_TEST

START_TEST(noise_of_density_decays)
{
    block.perturb.amplitude = 0;
    sph2d__store *f = make(SPH2D_ISA_AUTO);
    size_t middle = 0;
    while (!is_inside(f, middle))
        ++middle;
    f->density[middle] += 1;
    sph2d__wcsph_fitted.evaluate(&sim->system);
    /* R = -4 sum w/((A11 + A22) H^2), with no slope and curvature for symmetry but c3 + c5 */
    double with = f->density_rate[middle];
    sim->system.method.density_diffusion *= 2;
    sph2d__wcsph_fitted.evaluate(&sim->system);
    ck_assert_double_lt(with, 0);
    ck_assert_double_eq_tol(f->density_rate[middle], 2 * with, 1e-9 * fabs(with));
    double h = sim->system.support, sum = 0, second = 0, fourth = 0, cross = 0;
    for (size_t j = 0; j < f->count; ++j) {
        double x = (f->x[j] - f->x[middle]) / h, y = (f->y[j] - f->y[middle]) / h;
        double w = j == middle ? 0 : pow(fmax(1 - hypot(x, y), 0), 3);
        sum += w;
        second += w * x * x;
        fourth += w * x * x * x * x;
        cross += w * x * x * y * y;
    }
    double c = -second / (fourth + cross), residual = 4 * (-sum - 2 * c * second) / (2 * second * h * h);
    double rate = 0.1 * h / 2 * C0 * residual;
    ck_assert_double_eq_tol(with, rate, 1e-9 * fabs(rate));
}
END_TEST

START_TEST(steps_are_as_long_as_is_stable)
{
    scene.method.cfl = 0.25;
    scene.fluid.dynamic_viscosity = _i ? 400 : 0;
    make(SPH2D_ISA_AUTO);
    sph2d__system *s = &sim->system;
    double h = s->support, acoustic = 0.25 * h / (C0 + 2), viscous = _i ? 0.0075 * h * h / 0.4 : INFINITY;
    sph2d__limit limit;
    ck_assert_double_eq_tol(sph2d__wcsph_fitted.stable_step(s, 2, 0, &limit), fmin(acoustic, viscous), 1e-15);
    double force = 0.25 * sqrt(h / 1e6);
    ck_assert_double_eq_tol(sph2d__wcsph_fitted.stable_step(s, 2, 1e6, &limit), fmin(force, viscous), 1e-15);
    s->method.density_diffusion = 1;
    double diffusive = 0.08 * h / C0;
    ck_assert_double_eq_tol(sph2d__wcsph_fitted.stable_step(s, 2, 0, &limit), fmin(diffusive, viscous), 1e-15);
}
END_TEST

START_TEST(the_mean_density_is_kept)
{
    scene.fluid.dynamic_viscosity = 0.01 * RHO0;
    sph2d__store *f = make(SPH2D_ISA_AUTO);
    uint64_t seed = 2;
    double before = 0, after = 0;
    for (size_t i = 0; i < f->count; ++i) {
        f->vx[i] = test_random(&seed, -1, 1);
        f->vy[i] = test_random(&seed, -1, 1);
        before += f->density[i] / (double)f->count;
    }
    sim->record.energy_low = sim->record.error_low = INFINITY; /* what comes in here comes from somewhere */
    test_steps(sim, 20);
    for (size_t i = 0; i < f->count; ++i)
        after += f->density[i] / (double)f->count;
    ck_assert_double_eq_tol(after, before, 1e-10);
}
END_TEST

/* Acceleration that is a parabola of time, and its integral. */
static double pull(double t)
{
    return 3 - 4 * t + 5 * t * t;
}

static double pulled(double t)
{
    return 3 * t - 2 * t * t + 5.0 / 3 * t * t * t;
}

START_TEST(parabolas_of_time_are_exact_in_unequal_steps)
{
    static const double steps[] = {0.01, 0.013, 0.007, 0.02, 0.011, 0.006, 0.009};
    scene.method.shifting = 0;
    sph2d__store *f = make(SPH2D_ISA_AUTO);
    sph2d__record *r = &sim->record;
    double speed = 0, expected = 0, x = f->x[0], y = f->y[0];
    uint64_t id = f->id[0];
    for (size_t k = 0; k < sizeof steps / sizeof steps[0]; ++k) {
        double t = r->time, now = pull(t), dt = steps[k];
        ck_assert_int_eq(sph2d_sim_set_gravity(sim, (sph2d_vec2){-2 * now, now}), SPH2D_OK);
        r->next_step = dt;
        test_steps(sim, 1);
        /* the first step knows a constant alone, the second a line */
        double slope = k == 1 ? (now - pull(0)) / t : 0;
        double gain = k < 2 ? dt * now + dt * dt / 2 * slope : pulled(t + dt) - pulled(t);
        expected += dt * (speed + gain / 2);
        speed += gain;
        for (size_t i = 0; i < f->count; ++i) {
            ck_assert_double_eq_tol(f->vx[i], -2 * speed, 1e-9);
            ck_assert_double_eq_tol(f->vy[i], speed, 1e-9);
            if (f->id[i] != id)
                continue;
            ck_assert_double_eq_tol(remainder(f->x[i] - x + 2 * expected, SIDE * DX), 0, 1e-9);
            ck_assert_double_eq_tol(remainder(f->y[i] - y - expected, SIDE * DX), 0, 1e-9);
        }
    }
}
END_TEST

/* Liquid at rest has no rate now, but those of the steps before, which leave the mean alone. */
START_TEST(rates_of_the_steps_before_act_on_density)
{
    scene.method.shifting = 0;
    sph2d__store *f = make(SPH2D_ISA_AUTO);
    const double dt = 0.001;
    for (size_t i = 0; i < f->count; ++i) {
        f->density[i] = RHO0;
        f->density_rate[i] = f->id[i] % 2 ? 3 : -3;
        f->old_density_rate[i] = f->id[i] % 2 ? 10 : -10;
    }
    sim->record.last_step = sim->record.older_step = sim->record.next_step = dt;
    test_steps(sim, 1);
    for (size_t i = 0; i < f->count; ++i) {
        double change = dt * (-16.0 / 12 * 3 + 5.0 / 12 * 10);
        ck_assert_double_eq_tol(f->density[i], RHO0 + (f->id[i] % 2 ? change : -change), 1e-12 * RHO0);
    }
}
END_TEST

/* Liquid of one speed has nothing to find on the way of a shift. */
START_TEST(a_shift_is_one_forward_step)
{
    enum { COUNT = SIDE * SIDE };
    static double x[COUNT], y[COUNT];
    const double dt = _i ? 0.001 : 0.01, speed = 2;
    sph2d__store *f = make(SPH2D_ISA_AUTO);
    for (size_t i = 0; i < f->count; ++i) {
        f->density[i] = RHO0;
        f->vx[i] = speed;
    }
    sph2d__system *s = &sim->system;
    s->speed = sim->record.speed = speed;
    s->shift_gain = fmin(2.5, 0.05 * s->support / (speed * dt));
    sph2d__wcsph_fitted.evaluate(s);
    for (size_t i = 0; i < f->count; ++i) {
        x[f->id[i]] = f->x[i] + dt * (speed + f->shift_x[i]);
        y[f->id[i]] = f->y[i] + dt * f->shift_y[i];
    }
    sim->record.next_step = dt;
    sim->record.energy_low = sim->record.error_low = INFINITY; /* what comes in here comes from somewhere */
    test_steps(sim, 1);
    for (size_t i = 0; i < f->count; ++i) {
        ck_assert_double_eq_tol(remainder(f->x[i] - x[f->id[i]], SIDE * DX), 0, 1e-12);
        ck_assert_double_eq_tol(remainder(f->y[i] - y[f->id[i]], SIDE * DX), 0, 1e-12);
    }
}
END_TEST

/* The whole scheme: errors of a decaying vortex at two resolutions. */
static double vortex_error(double dx, double c0)
{
    scene.spacing = dx;
    scene.method.sound_speed = c0;
    block.start.flow = sph2d_flow_default();
    block.start.flow.kind = SPH2D_FLOW_TAYLOR_GREEN;
    block.start.flow.speed = 1;
    block.start.flow.length = 1;
    scene.fluid.dynamic_viscosity = 0.01 * RHO0;
    sph2d_probe probe = sph2d_probe_default();
    probe.kind = SPH2D_PROBE_ERROR;
    probe.name = "error";
    probe.rate.every = 1;
    scene.probes = &probe;
    scene.probe_count = 1;
    make(SPH2D_ISA_AUTO);
    while (sph2d_sim_time(sim) < 0.5)
        test_steps(sim, 1);
    double values[SPH2D_PROBE_MAX_COLUMNS];
    sph2d_sim_probe(sim, 0, values);
    finish();
    return values[0];
}

START_TEST(the_scheme_is_of_second_order)
{
    double coarse = vortex_error(0.05, 10), fine = vortex_error(0.025, 20);
    ck_assert_double_lt(coarse, 0.01);
    ck_assert_double_gt(log2(coarse / fine), 1.8);
}
END_TEST

Suite *suite_fitted(void)
{
    Suite *suite = suite_create("fitted");
    TCase *tests = tcase_create("fitted");
    tcase_add_checked_fixture(tests, start, finish);
    tcase_add_loop_test(tests, quadratic_fields_are_exact, 0, 2);
    tcase_add_loop_test(tests, few_neighbours_give_a_plane_or_nothing, 0, 2);
    tcase_add_test(tests, shifts_lead_away_from_the_crowd);
    tcase_add_test(tests, the_laplacian_of_a_lattice_is_of_fourth_order);
    tcase_add_test(tests, noise_of_density_decays);
    tcase_add_loop_test(tests, steps_are_as_long_as_is_stable, 0, 2);
    tcase_add_test(tests, the_mean_density_is_kept);
    tcase_add_test(tests, parabolas_of_time_are_exact_in_unequal_steps);
    tcase_add_test(tests, rates_of_the_steps_before_act_on_density);
    tcase_add_loop_test(tests, a_shift_is_one_forward_step, 0, 2);
    tcase_add_test(tests, the_scheme_is_of_second_order);
    suite_add_tcase(suite, tests);
    return suite;
}
