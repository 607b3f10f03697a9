/* SPDX-License-Identifier: MIT */
/** @file test_limited_viscosity.c
 *  Artificial viscosity of methods `pcisph` and `constraint`, limited_viscosity.h: against sums over all pairs in double
 *  precision, in linear flow, and what it keeps and takes. */
#include <math.h>
#include <string.h>

#include "common.h"
#include "kernels/kernel.h"
#include "methods/projection/limited_viscosity.h"
#include "sim/stages.h"

enum { SIDE = 14, MOST = SIDE * SIDE };

static sph2d_scene scene;
static sph2d_block block;
static sph2d_sim *sim;

static const double DX = 0.02, G = 10, ALPHA = 0.3, DT = 1e-4;

static void finish(void)
{
    sph2d_sim_destroy(sim);
    sim = NULL;
}

/** A square of liquid without walls, its lattice disturbed. */
static void start(sph2d_method method, double alpha)
{
    scene = test_open_scene(DX, 0, 0, 2 * SIDE * DX, 2 * SIDE * DX);
    scene.method = sph2d_scene_default().method;
    scene.method.name = method;
    scene.method.artificial_viscosity = alpha;
    scene.gravity.y = -G;
    scene.fluid.dynamic_viscosity = 0;
    block = test_block(0.5 * SIDE * DX, 0.5 * SIDE * DX, 1.5 * SIDE * DX, 1.5 * SIDE * DX);
    scene.blocks = &block;
    scene.block_count = 1;
    sim = test_create(&scene, NULL);
    uint64_t random = 7;
    sph2d__store *f = &sim->system.fluid;
    ck_assert_uint_eq(f->count, MOST);
    for (size_t i = 0; i < f->count; ++i) {
        f->x[i] += test_random(&random, -0.2, 0.2) * DX;
        f->y[i] += test_random(&random, -0.2, 0.2) * DX;
    }
}

/** The acceleration by artificial viscosity, in the order that the particles are in then; velocities stay. */
static void evaluate(double ax[], double ay[])
{
    sph2d__store *f = &sim->system.fluid;
    double before = 0, after = 0;
    ck_assert_int_eq(sph2d__sort_fluid(sim), SPH2D_OK);
    ck_assert(sim->method->evaluate(&sim->system));
    for (size_t i = 0; i < f->count; ++i) {
        before += (f->vx[i] * f->vx[i] + f->vy[i] * f->vy[i]) / 2;
        ax[i] = -f->vx[i];
        ay[i] = -f->vy[i];
    }
    double taken = sph2d__limited_viscosity_apply(&sim->system, DT);
    for (size_t i = 0; i < f->count; ++i) {
        after += (f->vx[i] * f->vx[i] + f->vy[i] * f->vy[i]) / 2;
        ax[i] = (ax[i] + f->vx[i]) / DT;
        ay[i] = (ay[i] + f->vy[i]) / DT;
        f->vx[i] -= DT * ax[i];
        f->vy[i] -= DT * ay[i];
    }
    ck_assert_double_ge(taken, 0);
    ck_assert_double_eq_tol(taken, sim->system.mass * (before - after), 1e-12 * sim->system.mass * before);
}

/* ---- the sums ---------------------------------------------------------------------------------------------------- */

/** (c m/rho0) W'/r of particles i and j; r from j to i. */
static double slope(size_t i, size_t j, double *x, double *y)
{
    const sph2d__system *s = &sim->system;
    double h2 = s->support * s->support;
    *x = s->fluid.x[i] - s->fluid.x[j];
    *y = s->fluid.y[i] - s->fluid.y[j];
    return s->calibration * s->mass / s->rest_density * sph2d__kernel_constant(s->method.kernel) / (h2 * h2) *
           sph2d__kernel_slope_at(s->method.kernel, hypot(*x, *y) / s->support);
}

/** grad v of particle i: xx, xy, yx, yy. */
static void gradient_of(size_t i, double l[4])
{
    const sph2d__store *f = &sim->system.fluid;
    double m[3] = {0}, v[4] = {0}, x, y;
    for (size_t j = 0; j < f->count; ++j) {
        double g = j == i ? 0 : slope(i, j, &x, &y), ux = f->vx[i] - f->vx[j], uy = f->vy[i] - f->vy[j];
        if (j == i)
            continue;
        m[0] -= g * x * x;
        m[1] -= g * x * y;
        m[2] -= g * y * y;
        v[0] -= g * ux * x;
        v[1] -= g * ux * y;
        v[2] -= g * uy * x;
        v[3] -= g * uy * y;
    }
    double det = m[0] * m[2] - m[1] * m[1], half = (m[0] + m[2]) / 2;
    bool known = half - sqrt(half * half - det) > 0.3;
    for (int k = 0; k < 4; k += 2) {
        l[k] = known ? (v[k] * m[2] - v[k + 1] * m[1]) / det : 0;
        l[k + 1] = known ? (v[k + 1] * m[0] - v[k] * m[1]) / det : 0;
    }
}

START_TEST(it_is_the_sum_over_all_pairs)
{
    static double l[MOST][4], ax[MOST], ay[MOST];
    double power = 0, px = 0, py = 0, turn = 0, size = 0, worst = 0;
    uint64_t random = 3;
    start(SPH2D_METHOD_PCISPH, ALPHA);
    sph2d__store *f = &sim->system.fluid;
    for (size_t i = 0; i < f->count; ++i) {
        f->vx[i] = 3 * f->y[i] + test_random(&random, -0.1, 0.1);
        f->vy[i] = 2 * f->x[i] - f->y[i] + test_random(&random, -0.1, 0.1);
    }
    evaluate(ax, ay);
    const double nu = ALPHA * sqrt(sim->system.head) * sim->system.support / 16;
    for (size_t i = 0; i < f->count; ++i)
        gradient_of(i, l[i]);
    for (size_t i = 0; i < f->count; ++i) {
        double sx = 0, sy = 0, x = 0, y = 0;
        for (size_t j = 0; j < f->count; ++j) {
            double g = j == i ? 0 : slope(i, j, &x, &y);
            if (g == 0)
                continue;
            double along = (f->vx[i] - f->vx[j]) * x + (f->vy[i] - f->vy[j]) * y;
            double xx = (l[i][0] + l[j][0]) / 2, yy = (l[i][3] + l[j][3]) / 2;
            double xy = (l[i][1] + l[j][1] + l[i][2] + l[j][2]) / 2;
            double rest = along - xx * x * x - xy * x * y - yy * y * y;
            double w = along * rest <= 0 ? 0 : fabs(along) < fabs(rest) ? along : rest;
            sx += 8 * nu * w / (x * x + y * y) * g * x;
            sy += 8 * nu * w / (x * x + y * y) * g * y;
        }
        worst = fmax(worst, hypot(ax[i] - sx, ay[i] - sy));
        size = fmax(size, hypot(sx, sy));
        px += ax[i];
        py += ay[i];
        turn += f->x[i] * ay[i] - f->y[i] * ax[i];
        power += f->vx[i] * ax[i] + f->vy[i] * ay[i];
    }
    ck_assert_double_gt(size, 1);
    ck_assert_double_le(worst, 1e-6 * size); /* gradients are kept as floats */
    ck_assert_double_le(hypot(px, py), 1e-12 * MOST * size);
    ck_assert_double_le(fabs(turn), 1e-6 * size * DX);
    ck_assert_double_lt(power, -1);
}
END_TEST

/** Rotation, strain and expansion that are the same everywhere are not damped, but in corners, where no gradient is
 *  known. */
START_TEST(linear_flow_is_not_damped)
{
    static double ax[MOST], ay[MOST];
    start(SPH2D_METHOD_PCISPH, ALPHA);
    sph2d__store *f = &sim->system.fluid;
    for (size_t i = 0; i < f->count; ++i) {
        f->vx[i] = 3 * f->x[i] - 7 * f->y[i];
        f->vy[i] = 4 * f->x[i] + 2 * f->y[i];
    }
    evaluate(ax, ay);
    double middle = SIDE * DX, reach = (SIDE / 2 + 0.5) * DX - 2 * sim->system.support;
    int checked = 0;
    for (size_t i = 0; i < f->count; ++i) {
        double x = fabs(f->x[i] - middle), y = fabs(f->y[i] - middle);
        if (x > reach && y > reach)
            continue;
        ck_assert_double_le(hypot(ax[i], ay[i]), 1e-9);
        ++checked;
    }
    ck_assert_int_gt(checked, MOST / 3);
}
END_TEST

Suite *suite_limited_viscosity(void)
{
    Suite *suite = suite_create("limited_viscosity");
    TCase *cases = tcase_create("limited_viscosity");
    tcase_add_checked_fixture(cases, NULL, finish);
    tcase_add_test(cases, it_is_the_sum_over_all_pairs);
    tcase_add_test(cases, linear_flow_is_not_damped);
    suite_add_tcase(suite, cases);
    return suite;
}
