/* SPDX-License-Identifier: MIT */
/** @file test_smoothing.c
 *  The kernels of method `wcsph` against what defines them: the polynomials of Wendland 1995 (Adv. Comput. Math. 4) in
 *  the form of Dehnen & Aly 2012 (MNRAS 425, table 1), by the support radius H = 1. */
#include <math.h>

#include "common.h"
#include "kernels/kernel.h"

#define KIND(name, word) SPH2D_KERNEL_##name,
static const sph2d_kernel kinds[] = {SPH2D_KERNEL_MAP(KIND)};
enum { KINDS = SPH2D_KERNEL_COUNT };

static double power(double base, int exponent)
{
    return base > 0 ? pow(base, exponent) : 0;
}

/** W of the literature, constant and all, for H = 1. */
static double known(sph2d_kernel kind, double q)
{
    switch (kind) {
    case SPH2D_KERNEL_WENDLAND_C4:
        return 9 / TEST_PI * power(1 - q, 6) * (1 + 6 * q + 35.0 / 3 * q * q);
    case SPH2D_KERNEL_WENDLAND_C2:
        return 7 / TEST_PI * power(1 - q, 4) * (1 + 4 * q);
    }
    return NAN;
}

static double value(sph2d_kernel kind, double q)
{
    return sph2d__kernel_constant(kind) * sph2d__kernel_value_at(kind, q);
}

START_TEST(values_are_those_of_the_literature)
{
    for (int i = 0; i <= 120; ++i)
        ck_assert_double_eq_tol(value(kinds[_i], i / 100.0), known(kinds[_i], i / 100.0), 1e-12);
}
END_TEST

/* Simpson's rule over q. */
START_TEST(the_integral_over_the_plane_is_one)
{
    enum { INTERVALS = 6000 };
    double sum = 0, moment = 0, step = 1.0 / INTERVALS;
    for (int i = 0; i <= INTERVALS; ++i) {
        double q = step * i, weight = i == 0 || i == INTERVALS ? 1 : i % 2 ? 4 : 2;
        sum += weight * 2 * TEST_PI * q * value(kinds[_i], q);
        /* -x dW/dx = -q^2 cos^2 g */
        moment -=
            weight * TEST_PI * q * q * q * sph2d__kernel_constant(kinds[_i]) * sph2d__kernel_slope_at(kinds[_i], q);
    }
    ck_assert_double_eq_tol(sum * step / 3, 1, 1e-10);
    ck_assert_double_eq_tol(moment * step / 3, 1, 1e-10);
}
END_TEST

START_TEST(the_slope_is_the_derivative)
{
    const double d = 1e-5;
    for (int i = 1; i < 100; ++i) {
        double q = i / 100.0 + 0.003;
        double rise = (sph2d__kernel_value_at(kinds[_i], q + d) - sph2d__kernel_value_at(kinds[_i], q - d)) / (2 * d);
        double slope = q * sph2d__kernel_slope_at(kinds[_i], q), size = sph2d__kernel_value_at(kinds[_i], 0);
        ck_assert_double_eq_tol(slope, rise, 2e-8 * size);
        ck_assert(slope <= 0);
    }
}
END_TEST

START_TEST(nothing_acts_from_the_support_radius_on)
{
    static const double far[] = {1, 1 + 1e-15, 1.5, 100};
    for (int k = 0; k < 4; ++k) {
        ck_assert(sph2d__kernel_value_at(kinds[_i], far[k]) == 0);
        ck_assert(sph2d__kernel_slope_at(kinds[_i], far[k]) == 0);
    }
    ck_assert(sph2d__kernel_value_at(kinds[_i], 0.999) > 0);
}
END_TEST

/* f''(0) = g(0). */
START_TEST(the_slope_is_finite_at_no_distance)
{
    static const double curvature[KINDS] = {[SPH2D_KERNEL_WENDLAND_C2] = -20, [SPH2D_KERNEL_WENDLAND_C4] = -56.0 / 3};
    ck_assert_msg(curvature[_i] < 0, "the curvature of kernel %d is missing above", _i);
    ck_assert_double_eq_tol(sph2d__kernel_slope_at(kinds[_i], 0), curvature[_i], 1e-12 * fabs(curvature[_i]));
    double near = sph2d__kernel_slope_at(kinds[_i], 1e-300);
    ck_assert_double_eq_tol(near, curvature[_i], 1e-12 * fabs(curvature[_i]));
}
END_TEST

START_TEST(lanes_are_computed_alike)
{
    sph2d__lanes q;
    for (int l = 0; l < SPH2D__LANES; ++l)
        q[l] = 1.2 * l / SPH2D__LANES;
    sph2d__lanes f = sph2d__kernel_value(kinds[_i], q), g = sph2d__kernel_slope(kinds[_i], q);
    for (int l = 0; l < SPH2D__LANES; ++l) {
        ck_assert(f[l] == sph2d__kernel_value_at(kinds[_i], q[l]));
        ck_assert(g[l] == sph2d__kernel_slope_at(kinds[_i], q[l]));
    }
}
END_TEST

Suite *suite_smoothing(void)
{
    Suite *suite = suite_create("smoothing");
    TCase *tests = tcase_create("kernels");
    tcase_add_loop_test(tests, values_are_those_of_the_literature, 0, KINDS);
    tcase_add_loop_test(tests, the_integral_over_the_plane_is_one, 0, KINDS);
    tcase_add_loop_test(tests, the_slope_is_the_derivative, 0, KINDS);
    tcase_add_loop_test(tests, nothing_acts_from_the_support_radius_on, 0, KINDS);
    tcase_add_loop_test(tests, the_slope_is_finite_at_no_distance, 0, KINDS);
    tcase_add_loop_test(tests, lanes_are_computed_alike, 0, KINDS);
    suite_add_tcase(suite, tests);
    return suite;
}
