/* SPDX-License-Identifier: MIT */
/** @file test_fitted.c
 *  Fitted operators of method `wcsph` on fields whose derivatives they must give exactly: quadratic polynomials in the
 *  interior, and between no-slip walls. The equations are those of wcsph_fitted.h. */
#include <math.h>
#include <string.h>

#include "common.h"
#include "methods/wcsph_fitted.h"
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
            double ax = -C0 * C0 * rx / rho + NU * 10 + wx * ux + wy * uy;
            double ay = -C0 * C0 * ry / rho - NU * 10 + wx * vx + wy * vy;
            ck_assert_double_eq_tol(f->ax[i], ax, 1e-9);
            ck_assert_double_eq_tol(f->ay[i], ay, 1e-9);
            ck_assert_double_eq_tol(f->density_rate[i], -rho * (ux + vy) + wx * rx + wy * ry, 1e-6);
            ck_assert((hypot(wx, wy) > 0) == (_i == 1));
        }
        finish();
    }
}
END_TEST

/* Three neighbours are too few for a parabola and enough for a plane; two on a line are too few for that. */
START_TEST(few_neighbours_give_a_plane_or_nothing)
{
    static const double x[4] = {0.5, 0.55, 0.49, 0.44}, y[4] = {0.5, 0.51, 0.56, 0.47};
    sph2d__store *f = make(SPH2D_ISA_AUTO);
    f->count = _i ? 3 : 4;
    for (size_t i = 0; i < f->count; ++i) {
        f->x[i] = x[i];
        f->y[i] = _i ? 0.5 : y[i];
        f->vx[i] = 1 + 2 * f->x[i] - 3 * f->y[i];
        f->vy[i] = 4 * f->x[i] + 5 * f->y[i];
        f->density[i] = RHO0 + 6 * f->x[i] - 7 * f->y[i];
    }
    sim->system.speed = 0;
    ck_assert(sph2d__cells_build(&sim->system.fluid_cells, f, sim->system.support, &sim->memory, 1));
    sph2d__wcsph_fitted.evaluate(&sim->system);
    for (size_t i = 0; i < f->count; ++i) {
        double rho = f->density[i];
        ck_assert_double_eq_tol(f->ax[i], _i ? 0 : -C0 * C0 * 6 / rho, 1e-9);
        ck_assert_double_eq_tol(f->ay[i], _i ? 0 : C0 * C0 * 7 / rho, 1e-9);
        ck_assert_double_eq_tol(f->density_rate[i], _i ? 0 : -7 * rho, 1e-6);
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

/* ---- walls ------------------------------------------------------------------------------------------------------- */

/** Rough walls below and above, the upper one moving. */
static void between_walls(double top)
{
    scene.boundary = (sph2d_boundary){SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL};
    scene.wall_slip = SPH2D_SLIP_NONE;
    scene.wall_speeds.top = top;
}

START_TEST(flow_between_walls_is_exact)
{
    between_walls(_i ? 3 : 0);
    sph2d__store *f = make(SPH2D_ISA_AUTO);
    for (size_t i = 0; i < f->count; ++i) {
        f->vx[i] = _i ? 3 * f->y[i] : f->y[i] * (1 - f->y[i]);
        f->vy[i] = 0;
    }
    sim->system.speed = 0;
    sph2d__wcsph_fitted.evaluate(&sim->system);
    for (size_t i = 0; i < f->count; ++i) { /* on the lines beside the walls, too */
        ck_assert_double_eq_tol(f->ax[i], _i ? 0 : -2 * NU, 1e-9);
        ck_assert_double_eq_tol(f->ay[i], 0, 1e-9);
        ck_assert_double_eq_tol(f->density_rate[i], 0, 1e-7);
    }
}
END_TEST

/** A least-squares fit that is filled row by row: weight, basis, value. */
typedef struct rows {
    double a[5][5], b[5];        /* normal equations */
    double plain[5], sum, trace; /* sums of w phi, w df and w r^2 over the rows that are differences */
} rows;

static void add_row(rows *r, double weight, const double basis[5], double value)
{
    for (int n = 0; n < 5; ++n) {
        for (int m = 0; m < 5; ++m)
            r->a[n][m] += weight * basis[n] * basis[m];
        r->b[n] += weight * basis[n] * value;
    }
}

/** The row of a difference at (x, y), in units of the support radius. */
static void add_difference(rows *r, double x, double y, double value)
{
    double q = hypot(x, y), w = q < 1 ? pow(1 - q, 3) : 0, basis[5] = {x, y, x * x, x * y, y * y};
    add_row(r, w, basis, value);
    for (int n = 0; n < 5; ++n)
        r->plain[n] += w * basis[n];
    r->sum += w * value;
    r->trace += w * q * q;
}

/** The row of a slope along y there: weight 1/10, d/dy of the basis. */
static void add_slope_along_y(rows *r, double x, double y, double value)
{
    double q = hypot(x, y), w = q < 1 ? 0.1 * pow(1 - q, 3) : 0, basis[5] = {0, 1, 0, x, 2 * y};
    add_row(r, w, basis, value);
}

/** Gauss' elimination; the answer is left in b. */
static void solve(rows *r)
{
    for (int n = 0; n < 5; ++n)
        for (int m = n + 1; m < 5; ++m) {
            double part = r->a[m][n] / r->a[n][n];
            for (int k = n; k < 5; ++k)
                r->a[m][k] -= part * r->a[n][k];
            r->b[m] -= part * r->b[n];
        }
    for (int n = 4; n >= 0; --n) {
        for (int m = n + 1; m < 5; ++m)
            r->b[n] -= r->a[n][m] * r->b[m];
        r->b[n] /= r->a[n][n];
    }
}

/** Residual of the solved fit as a Laplacian, in units of H. */
static double residual_of(const rows *r)
{
    double rest = r->sum;
    for (int n = 0; n < 5; ++n)
        rest -= r->b[n] * r->plain[n];
    return 4 * rest / r->trace;
}

/** Fits around particle i: of vx and vy over neighbours and the surfaces at y = 0 and 1, which move with `top` and
 * rest; of density over neighbours and the slopes that the walls know, for the body force `gy`. */
static void fit_around(const sph2d__system *s, size_t i, double top, double gy, rows fits[3])
{
    const sph2d__store *f = &s->fluid, *w = &s->walls;
    double h = s->support, length = SIDE * DX;
    for (size_t j = 0; j < f->count; ++j) {
        double x = remainder(f->x[j] - f->x[i], length) / h, y = (f->y[j] - f->y[i]) / h;
        add_difference(&fits[0], x, y, f->vx[j] - f->vx[i]);
        add_difference(&fits[1], x, y, f->vy[j] - f->vy[i]);
        add_difference(&fits[2], x, y, f->density[j] - f->density[i]);
    }
    for (size_t b = 0; b < w->count; ++b) {
        double surface = w->y[b] < 0.5 ? 0 : 1;
        if (fabs(w->y[b] - surface) > 0.75 * DX)
            continue;
        double x = remainder(w->x[b] - f->x[i], length) / h, y = (surface - f->y[i]) / h;
        add_difference(&fits[0], x, y, (surface > 0 ? top : 0) - f->vx[i]);
        add_difference(&fits[1], x, y, -f->vy[i]);
        add_slope_along_y(&fits[2], x, y, f->density[i] / (C0 * C0) * h * gy);
    }
    for (int v = 0; v < 3; ++v)
        solve(&fits[v]);
}

/** S of wcsph_fitted.h around particle i, over neighbours and all layers of walls. */
static sph2d_vec2 crowding(const sph2d__system *s, size_t i)
{
    const sph2d__store *stores[2] = {&s->fluid, &s->walls};
    double h = s->support, at_dx = pow(1 - DX / h, 4) * (1 + 4 * DX / h), sum[2] = {0, 0};
    for (int k = 0; k < 2; ++k)
        for (size_t j = 0; j < stores[k]->count; ++j) {
            double x = remainder(stores[k]->x[j] - s->fluid.x[i], SIDE * DX) / h;
            double y = (stores[k]->y[j] - s->fluid.y[i]) / h, q = hypot(x, y);
            double near = q < 1 ? pow(1 - q, 4) * (1 + 4 * q) / at_dx : 0;
            double w = q < 1 ? pow(1 - q, 3) * (1 + 0.2 * pow(near, 4)) : 0;
            sum[0] += w * x;
            sum[1] += w * y;
        }
    double scale = 140 / TEST_PI * pow(DX / h, 2);
    return (sph2d_vec2){scale * sum[0], scale * sum[1]};
}

/** Rates at random velocities and densities against fits that are assembled here, for every particle. */
START_TEST(rates_are_those_of_least_squares)
{
    const double top = 0.7, gy = -4;
    between_walls(top);
    scene.gravity = (sph2d_vec2){1.5, gy};
    sph2d__store *f = make(_i ? SPH2D_ISA_BASELINE : SPH2D_ISA_AUTO);
    sph2d__system *s = &sim->system;
    uint64_t seed = 5;
    for (size_t i = 0; i < f->count; ++i) {
        f->vx[i] = test_random(&seed, -1, 1);
        f->vy[i] = test_random(&seed, -1, 1);
        f->density[i] = RHO0 * test_random(&seed, 0.99, 1.01);
    }
    s->speed = 0.6;
    s->shift_gain = 0.9;
    sph2d__wcsph_fitted.evaluate(s);
    double h = s->support, gain = s->residual_gain, delta = s->method.density_diffusion;
    size_t capped = 0;
    for (size_t i = 0; i < f->count; ++i) {
        sph2d_vec2 crowd = crowding(s, i);
        double wx = -0.9 * 0.6 * crowd.x, wy = -0.9 * 0.6 * crowd.y, less = fmin(1, 0.3 / hypot(wx, wy));
        capped += less < 1;
        ck_assert_double_eq_tol(f->shift_x[i], wx *= less, 1e-10);
        ck_assert_double_eq_tol(f->shift_y[i], wy *= less, 1e-10);
        rows fits[3];
        memset(fits, 0, sizeof fits);
        fit_around(s, i, top, gy, fits);
        double lap_x = 2 * (fits[0].b[2] + fits[0].b[4]) + gain * residual_of(&fits[0]);
        double lap_y = 2 * (fits[1].b[2] + fits[1].b[4]) + gain * residual_of(&fits[1]);
        double push = -C0 * C0 / f->density[i] / h;
        double along[3]; /* (w . grad) of the three fields */
        for (int v = 0; v < 3; ++v)
            along[v] = (wx * fits[v].b[0] + wy * fits[v].b[1]) / h;
        double rate = -f->density[i] * (fits[0].b[0] + fits[1].b[1]) / h + delta * C0 / 2 * residual_of(&fits[2]) / h;
        ck_assert_double_eq_tol(f->ax[i], push * fits[2].b[0] + NU * lap_x / (h * h) + along[0] + 1.5, 1e-7);
        ck_assert_double_eq_tol(f->ay[i], push * fits[2].b[1] + NU * lap_y / (h * h) + along[1] + gy, 1e-7);
        ck_assert_double_eq_tol(f->density_rate[i], rate + along[2], 1e-6);
    }
    ck_assert_uint_lt(capped, f->count);
}
END_TEST

START_TEST(a_wall_at_another_speed_drags)
{
    between_walls(1);
    sph2d__store *f = make(SPH2D_ISA_AUTO);
    sim->system.speed = 0;
    sph2d__wcsph_fitted.evaluate(&sim->system);
    for (size_t i = 0; i < f->count; ++i) {
        if (f->y[i] > 1 - DX)
            ck_assert_double_gt(f->ax[i], 0);
        if (f->y[i] < 0.5)
            ck_assert_double_eq_tol(f->ax[i], 0, 1e-12);
    }
}
END_TEST

START_TEST(steps_are_as_long_as_is_stable)
{
    scene.method.cfl = 0.25;
    scene.fluid.dynamic_viscosity = _i ? 400 : 0;
    make(SPH2D_ISA_AUTO);
    sph2d__system *s = &sim->system;
    double h = s->support, acoustic = 0.25 * h / (C0 + 2), viscous = _i ? 0.016 * h * h / 0.4 : INFINITY;
    s->densest = RHO0;
    sph2d__limit limit;
    ck_assert_double_eq_tol(sph2d__wcsph_fitted.stable_step(s, 2, 0, &limit), fmin(acoustic, viscous), 1e-15);
    double force = 0.25 * sqrt(h / 1e6);
    ck_assert_double_eq_tol(sph2d__wcsph_fitted.stable_step(s, 2, 1e6, &limit), fmin(force, viscous), 1e-15);
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
    test_steps(sim, 20);
    for (size_t i = 0; i < f->count; ++i)
        after += f->density[i] / (double)f->count;
    ck_assert_double_eq_tol(after, before, 1e-10);
}
END_TEST

/* The whole scheme: errors of a decaying vortex at two resolutions. */
static double vortex_error(double dx, double c0)
{
    scene.spacing = dx;
    scene.method.sound_speed = c0;
    block.start = sph2d_flow_default();
    block.start.kind = SPH2D_FLOW_TAYLOR_GREEN;
    block.start.speed = 1;
    block.start.length = 1;
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
    tcase_add_loop_test(tests, flow_between_walls_is_exact, 0, 2);
    tcase_add_loop_test(tests, rates_are_those_of_least_squares, 0, 2);
    tcase_add_test(tests, a_wall_at_another_speed_drags);
    tcase_add_loop_test(tests, steps_are_as_long_as_is_stable, 0, 2);
    tcase_add_test(tests, the_mean_density_is_kept);
    tcase_add_test(tests, the_scheme_is_of_second_order);
    suite_add_tcase(suite, tests);
    return suite;
}
