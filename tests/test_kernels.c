/* SPDX-License-Identifier: MIT */
/** @file test_kernels.c
 *  The kernels of method `muller` against what defines them in the plane (Mueller, Charypar & Gross 2003 with
 *  two-dimensional constants). With q = r/H:
 *
 *      poly6      W = 4/(pi H^2) (1 - q^2)^3                       viscosity  lap W = 40/(pi H^4) (1 - q)
 *      spiky      W = 10/(pi H^2) (1 - q)^3,  W' = -30/(pi H^3) (1 - q)^2
 *
 *      integral of W over the plane = 1, of -x dW/dx = 1, of x^2/2 lap W = 1
 *
 *  The three-dimensional constants miss these by 1.2305/H, 1.5/H and 1.125/H. */
#include <math.h>

#include "common.h"
#include "kernels/muller.h"

static const double supports[] = {0.02, 1.0, 3.7, 2000.0};
enum { SUPPORTS = sizeof supports / sizeof supports[0] };

static double poly6(double support, double r)
{
    return sph2d__poly6_constant(support) * sph2d__poly6_shape(support * support, r * r);
}

/** -dW/dr of spiky and lap W of viscosity as the header says they are built from their constants. */
static double spiky_slope(double support, double r)
{
    return sph2d__spiky_constant(support) * (support - r) * (support - r);
}

static double viscosity_laplacian(double support, double r)
{
    return sph2d__viscosity_constant(support) * (support - r);
}

/** Integral from 0 to H of pi r^power f(r) dr by Simpson's rule: over the plane, the angle gives 2 pi for functions of
 *  r and pi for those times cos^2. */
static double radial(double (*f)(double, double), double support, int power)
{
    enum { INTERVALS = 2000 };
    double sum = 0, step = support / INTERVALS;
    for (int i = 0; i <= INTERVALS; ++i) {
        double r = step * i, weight = i == 0 || i == INTERVALS ? 1 : i % 2 ? 4 : 2;
        sum += weight * pow(r, power) * f(support, r);
    }
    return TEST_PI * sum * step / 3;
}

START_TEST(poly6_integrates_to_one)
{
    double integral = 2 * radial(poly6, supports[_i], 1);
    ck_assert_double_eq_tol(integral, 1, 1e-9);
}
END_TEST

START_TEST(spiky_integrates_to_one_and_has_unit_gradient_moment)
{
    /* By parts, the integral of 2 pi r W is that of -pi r^2 W', which is also the integral of -x dW/dx. */
    double integral = radial(spiky_slope, supports[_i], 2);
    ck_assert_double_eq_tol(integral, 1, 1e-9);
}
END_TEST

START_TEST(viscosity_has_unit_laplacian_moment)
{
    double moment = radial(viscosity_laplacian, supports[_i], 3) / 2;
    ck_assert_double_eq_tol(moment, 1, 1e-9);
}
END_TEST

START_TEST(poly6_has_unit_gradient_moment)
{
    /* W' by central differences of the code's W. */
    enum { INTERVALS = 2000 };
    double support = supports[_i], step = support / INTERVALS, moment = 0;
    for (int i = 1; i < INTERVALS; ++i) {
        double r = step * i, slope = (poly6(support, r + step / 2) - poly6(support, r - step / 2)) / step;
        moment -= TEST_PI * r * r * slope * step;
    }
    ck_assert_double_eq_tol(moment, 1, 1e-6);
}
END_TEST

START_TEST(values_at_the_centre)
{
    double h = supports[_i];
    ck_assert_double_eq_tol(poly6(h, 0) * TEST_PI * h * h / 4, 1, 1e-14);
    ck_assert_double_eq_tol(spiky_slope(h, 0) * TEST_PI * h * h * h / 30, 1, 1e-14);
    ck_assert_double_eq_tol(viscosity_laplacian(h, 0) * TEST_PI * h * h * h * h / 40, 1, 1e-14);
    ck_assert_double_eq_tol(poly6(h, h / 2) * TEST_PI * h * h / 4, 27.0 / 64.0, 1e-14);
}
END_TEST

START_TEST(derivatives_equal_finite_differences)
{
    double h = supports[_i], e = 1e-4 * h, worst_slope = 0, worst_laplacian = 0;
    for (double q = 0.1; q < 0.95; q += 0.05) {
        /* spiky from its W; the viscosity kernel from 40/(pi H^2) (-q^3/9 + q^2/4 - ln(q)/6 - 5/36) */
        double r = q * h, w[3], v[3];
        for (int k = 0; k < 3; ++k) {
            double p = (r + (k - 1) * e) / h;
            w[k] = 10 / (TEST_PI * h * h) * (1 - p) * (1 - p) * (1 - p);
            v[k] = 40 / (TEST_PI * h * h) * (-p * p * p / 9 + p * p / 4 - log(p) / 6 - 5.0 / 36);
        }
        double slope = (w[2] - w[0]) / (2 * e);
        double laplacian = (v[2] - 2 * v[1] + v[0]) / (e * e) + (v[2] - v[0]) / (2 * e) / r;
        worst_slope = fmax(worst_slope, fabs(slope + spiky_slope(h, r)) / spiky_slope(h, 0));
        worst_laplacian =
            fmax(worst_laplacian, fabs(laplacian - viscosity_laplacian(h, r)) / viscosity_laplacian(h, 0));
    }
    ck_assert_double_le(worst_slope, 1e-7);
    ck_assert_double_le(worst_laplacian, 1e-5);
}
END_TEST

START_TEST(poly6_is_zero_from_the_support_on)
{
    double h = supports[_i], h2 = h * h;
    ck_assert(sph2d__poly6_shape(h2, h2) == 0);
    ck_assert(sph2d__poly6_shape(h2, nextafter(h2, INFINITY)) == 0);
    ck_assert(sph2d__poly6_shape(h2, 4 * h2) == 0);
    ck_assert(sph2d__poly6_shape(h2, 1e300) == 0);
    ck_assert(sph2d__poly6_shape(h2, h2 * (1 - 1e-9)) > 0);
}
END_TEST

START_TEST(lattice_sums)
{
    /* Summation density over rest density of poly6 with mass rho0 dx^2 on a filled square lattice. */
    static const struct {
        double ratio, sum;
    } rows[] = {{2.0, 1.0146}, {2.6, 0.9953}, {3.0, 1.0023}, {4.0, 1.0005}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; ++i)
        for (int k = 0; k < SUPPORTS; ++k) {
            double spacing = supports[k];
            double sum = sph2d__poly6_lattice_sum(rows[i].ratio * spacing, spacing);
            ck_assert_double_eq_tol(sum, rows[i].sum, 5.1e-5);
        }
}
END_TEST

START_TEST(lattice_sum_sums_the_kernel)
{
    for (double ratio = 1.2; ratio <= 6; ratio += 0.17) {
        double sum = 0;
        for (int i = -8; i <= 8; ++i)
            for (int j = -8; j <= 8; ++j) {
                double q2 = (i * i + j * j) / (ratio * ratio);
                sum += q2 < 1 ? 4 / (TEST_PI * ratio * ratio) * pow(1 - q2, 3) : 0;
            }
        ck_assert_double_eq_tol(sph2d__poly6_lattice_sum(ratio, 1), sum, 1e-13);
    }
}
END_TEST

START_TEST(kernels_scale_with_the_unit_of_length)
{
    /* W is 1/length^2, its slope 1/length^3, its Laplacian 1/length^4: in millimetres 1e-6, 1e-9, 1e-12 times as much.
     */
    double h = supports[_i], mm = 1000 * h;
    for (double q = 0; q < 1; q += 0.24) {
        ck_assert_double_eq_tol(1e6 * poly6(mm, q * mm) / poly6(h, q * h), 1, 1e-12);
        ck_assert_double_eq_tol(1e9 * spiky_slope(mm, q * mm) / spiky_slope(h, q * h), 1, 1e-12);
        ck_assert_double_eq_tol(1e12 * viscosity_laplacian(mm, q * mm) / viscosity_laplacian(h, q * h), 1, 1e-12);
    }
}
END_TEST

Suite *suite_kernels(void)
{
    Suite *suite = suite_create("kernels");
    TCase *tests = tcase_create("muller");
    tcase_add_loop_test(tests, poly6_integrates_to_one, 0, SUPPORTS);
    tcase_add_loop_test(tests, spiky_integrates_to_one_and_has_unit_gradient_moment, 0, SUPPORTS);
    tcase_add_loop_test(tests, viscosity_has_unit_laplacian_moment, 0, SUPPORTS);
    tcase_add_loop_test(tests, poly6_has_unit_gradient_moment, 0, SUPPORTS);
    tcase_add_loop_test(tests, values_at_the_centre, 0, SUPPORTS);
    tcase_add_loop_test(tests, derivatives_equal_finite_differences, 0, SUPPORTS);
    tcase_add_loop_test(tests, poly6_is_zero_from_the_support_on, 0, SUPPORTS);
    tcase_add_test(tests, lattice_sums);
    tcase_add_test(tests, lattice_sum_sums_the_kernel);
    tcase_add_loop_test(tests, kernels_scale_with_the_unit_of_length, 0, SUPPORTS);
    suite_add_tcase(suite, tests);
    return suite;
}
