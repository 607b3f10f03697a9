/* SPDX-License-Identifier: MIT */
/** @file test_fitted_walls.c
 *  Fitted operators of method `wcsph` between no-slip walls: flows that are quadratic, and rates at random velocities
 *  and densities against fits that are assembled here row by row. The equations are those of fitted.h. */
#include <math.h>
#include <string.h>

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

/** The row of a slope along x or y there: weight 1/10, derivatives of the basis. */
static void add_slope(rows *r, bool along_x, double x, double y, double value)
{
    double q = hypot(x, y), w = q < 1 ? 0.1 * pow(1 - q, 3) : 0;
    double by_x[5] = {1, 0, 2 * x, y, 0}, by_y[5] = {0, 1, 0, x, 2 * y};
    add_row(r, w, along_x ? by_x : by_y, value);
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

/** The difference of two coordinates, across a period or not. */
static double difference(double a, double b, bool periodic)
{
    return periodic ? remainder(a - b, SIDE * DX) : a - b;
}

/** Fits around particle i: of vx and vy over neighbours and the surfaces at 0 and 1 of y, or of x with `upright`, which
 *  rest and move along themselves with `speed`; of density over neighbours and the slopes that the walls know, `pull`
 *  being the body force across them less their own acceleration. */
static void fit_around(const sph2d__system *s, size_t i, bool upright, double speed, double pull, rows fits[3])
{
    const sph2d__store *f = &s->fluid, *w = &s->walls;
    double h = s->support;
    for (size_t j = 0; j < f->count; ++j) {
        double x = difference(f->x[j], f->x[i], !upright) / h, y = difference(f->y[j], f->y[i], upright) / h;
        add_difference(&fits[0], x, y, f->vx[j] - f->vx[i]);
        add_difference(&fits[1], x, y, f->vy[j] - f->vy[i]);
        add_difference(&fits[2], x, y, f->density[j] - f->density[i]);
    }
    for (size_t b = 0; b < w->count; ++b) {
        double across = upright ? w->x[b] : w->y[b], surface = across < 0.5 ? 0 : 1, moving = surface * speed;
        if (fabs(across - surface) > 0.75 * DX)
            continue;
        double x = difference(upright ? surface : w->x[b], f->x[i], !upright) / h;
        double y = difference(upright ? w->y[b] : surface, f->y[i], upright) / h;
        add_difference(&fits[0], x, y, (upright ? 0 : moving) - f->vx[i]);
        add_difference(&fits[1], x, y, (upright ? moving : 0) - f->vy[i]);
        add_slope(&fits[2], upright, x, y, f->density[i] / (C0 * C0) * h * pull);
    }
    for (int v = 0; v < 3; ++v)
        solve(&fits[v]);
}

/** S of fitted.h around particle i, over neighbours and all layers of walls. */
static sph2d_vec2 crowding(const sph2d__system *s, size_t i, bool upright)
{
    const sph2d__store *stores[2] = {&s->fluid, &s->walls};
    double h = s->support, at_dx = pow(1 - DX / h, 4) * (1 + 4 * DX / h), sum[2] = {0, 0};
    for (int k = 0; k < 2; ++k)
        for (size_t j = 0; j < stores[k]->count; ++j) {
            double x = difference(stores[k]->x[j], s->fluid.x[i], !upright) / h;
            double y = difference(stores[k]->y[j], s->fluid.y[i], upright) / h, q = hypot(x, y);
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
    const bool upright = _i >= 2;
    const double speed = 0.7, gx = 1.5, gy = -4, swing = 0.8;
    between_walls(speed);
    if (upright) {
        scene.boundary = (sph2d_boundary){SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC};
        scene.wall_speeds = (sph2d_side_speeds){.right = speed};
    }
    scene.gravity = (sph2d_vec2){gx, gy};
    sph2d__store *f = make(_i & 1 ? SPH2D_ISA_BASELINE : SPH2D_ISA_AUTO);
    sph2d__system *s = &sim->system;
    uint64_t seed = 5;
    for (size_t i = 0; i < f->count; ++i) {
        f->vx[i] = test_random(&seed, -1, 1);
        f->vy[i] = test_random(&seed, -1, 1);
        f->density[i] = RHO0 * test_random(&seed, 0.99, 1.01);
    }
    for (size_t b = 0; b < s->walls.count; ++b) /* as if the walls were shaken */
        s->walls.ax[b] = s->walls.ay[b] = swing;
    s->speed = 0.6;
    s->shift_gain = 0.9;
    sph2d__wcsph_fitted.evaluate(s);
    double h = s->support, gain = s->residual_gain, delta = s->method.density_diffusion;
    size_t capped = 0;
    for (size_t i = 0; i < f->count; ++i) {
        sph2d_vec2 crowd = crowding(s, i, upright);
        double wx = -0.9 * 0.6 * crowd.x, wy = -0.9 * 0.6 * crowd.y, less = fmin(1, 0.3 / hypot(wx, wy));
        capped += less < 1;
        ck_assert_double_eq_tol(f->shift_x[i], wx *= less, 1e-10);
        ck_assert_double_eq_tol(f->shift_y[i], wy *= less, 1e-10);
        rows fits[3];
        memset(fits, 0, sizeof fits);
        fit_around(s, i, upright, speed, (upright ? gx : gy) - swing, fits);
        double lap_x = 2 * (fits[0].b[2] + fits[0].b[4]) + gain * residual_of(&fits[0]);
        double lap_y = 2 * (fits[1].b[2] + fits[1].b[4]) + gain * residual_of(&fits[1]);
        double push = -C0 * C0 / f->density[i] / h;
        double along[3]; /* (w . grad) of the three fields */
        for (int v = 0; v < 3; ++v)
            along[v] = (wx * fits[v].b[0] + wy * fits[v].b[1]) / h;
        double rate = -f->density[i] * (fits[0].b[0] + fits[1].b[1]) / h + delta * C0 / 2 * residual_of(&fits[2]) / h;
        ck_assert_double_eq_tol(f->ax[i], push * fits[2].b[0] + NU * lap_x / (h * h) + gx, 1e-7);
        ck_assert_double_eq_tol(f->ay[i], push * fits[2].b[1] + NU * lap_y / (h * h) + gy, 1e-7);
        ck_assert_double_eq_tol(f->density_rate[i], rate, 1e-6);
        ck_assert_double_eq_tol(f->shift_ax[i], along[0], 1e-7);
        ck_assert_double_eq_tol(f->shift_ay[i], along[1], 1e-7);
        ck_assert_double_eq_tol(f->shift_density_rate[i], along[2], 1e-6);
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

START_TEST(steps_are_shorter_where_liquid_sticks_to_walls)
{
    scene.fluid.dynamic_viscosity = 20 * NU * RHO0;
    between_walls(1);
    make(SPH2D_ISA_AUTO);
    sph2d__system *s = &sim->system;
    sph2d__limit limit;
    double step = sph2d__wcsph_fitted.stable_step(s, 0, 0, &limit);
    ck_assert_double_eq_tol(step, 0.005 * s->support * s->support / (20 * NU), 1e-15);
    ck_assert_int_eq(limit, SPH2D__LIMIT_VISCOUS);
}
END_TEST

Suite *suite_fitted_walls(void)
{
    Suite *suite = suite_create("fitted_walls");
    TCase *tests = tcase_create("between walls");
    tcase_add_checked_fixture(tests, start, finish);
    tcase_add_loop_test(tests, flow_between_walls_is_exact, 0, 2);
    tcase_add_loop_test(tests, rates_are_those_of_least_squares, 0, 4);
    tcase_add_test(tests, a_wall_at_another_speed_drags);
    tcase_add_test(tests, steps_are_shorter_where_liquid_sticks_to_walls);
    suite_add_tcase(suite, tests);
    return suite;
}
