/* SPDX-License-Identifier: MIT */
/** @file test_study_numbers.c
 *  How a series becomes a number, and how two are compared. */
#include <math.h>

#include "common.h"
#include "study/curve.h"

static const double FINE = 1e-12;

static const double xs[4] = {0, 1, 2, 3}, ys[4] = {1, 3, -1, 2};

static double reduce(sph2d_take take, size_t count, double level, double at)
{
    return sph2d__curve_reduce(take, (sph2d_study_curve){xs, ys, count}, level, at);
}

START_TEST(a_series_of_straight_lines_is_reduced_exactly)
{
    ck_assert(reduce(SPH2D_TAKE_DEFAULT, 4, NAN, NAN) == 2);
    ck_assert(reduce(SPH2D_TAKE_LAST, 4, NAN, NAN) == 2);
    ck_assert(reduce(SPH2D_TAKE_MAX, 4, NAN, NAN) == 3);
    ck_assert(reduce(SPH2D_TAKE_MIN, 4, NAN, NAN) == -1);
    ck_assert(reduce(SPH2D_TAKE_SPREAD, 4, NAN, NAN) == 4);
    ck_assert_double_eq_tol(reduce(SPH2D_TAKE_MEAN, 4, NAN, NAN), 3.5 / 3, FINE);
    ck_assert_double_eq_tol(reduce(SPH2D_TAKE_RMS, 4, NAN, NAN), sqrt(23. / 9), FINE);
    ck_assert(reduce(SPH2D_TAKE_CROSSING, 4, 2, NAN) == 0.5);
    ck_assert(reduce(SPH2D_TAKE_CROSSING, 4, 0, NAN) == 1.75); /* from above */
    ck_assert(reduce(SPH2D_TAKE_CROSSING, 4, 3, NAN) == 1);    /* touched, not passed */
    ck_assert(reduce(SPH2D_TAKE_CROSSING, 4, 1, NAN) == 1.5);  /* where it starts is no crossing */
    ck_assert(reduce(SPH2D_TAKE_VALUE, 4, NAN, 0.25) == 1.5);
    ck_assert(reduce(SPH2D_TAKE_VALUE, 4, NAN, 0) == 1);
    ck_assert(reduce(SPH2D_TAKE_VALUE, 4, NAN, 2) == -1);
    ck_assert(reduce(SPH2D_TAKE_VALUE, 4, NAN, 3) == 2);
    ck_assert(reduce(SPH2D_TAKE_VALUE, 4, NAN, nextafter(3, 4)) == 2); /* a clock is a sum of steps */
}
END_TEST

START_TEST(what_a_series_cannot_give_is_no_number)
{
    static const sph2d_take all[] = {SPH2D_TAKE_LAST,  SPH2D_TAKE_MAX,    SPH2D_TAKE_MIN,    SPH2D_TAKE_MEAN,
                                     SPH2D_TAKE_RMS,   SPH2D_TAKE_SPREAD, SPH2D_TAKE_PERIOD, SPH2D_TAKE_CROSSING,
                                     SPH2D_TAKE_VALUE, SPH2D_TAKE_DECAY};
    for (size_t i = 0; i < sizeof all / sizeof *all; ++i)
        ck_assert(isnan(reduce(all[i], 0, 0, 0)));
    ck_assert(isnan(reduce(SPH2D_TAKE_CROSSING, 4, 5, NAN)));
    ck_assert(isnan(reduce(SPH2D_TAKE_VALUE, 4, NAN, 3.1)));
    ck_assert(isnan(reduce(SPH2D_TAKE_VALUE, 4, NAN, -0.1)));
    ck_assert(isnan(reduce(SPH2D_TAKE_VALUE, 4, NAN, NAN)));
    ck_assert(isnan(reduce(SPH2D_TAKE_PERIOD, 4, 2.5, NAN))); /* one upward crossing is no period */
    ck_assert(isnan(reduce((sph2d_take)99, 4, NAN, NAN)));
}
END_TEST

START_TEST(one_sample_is_its_own_mean)
{
    ck_assert(reduce(SPH2D_TAKE_MEAN, 1, NAN, NAN) == 1);
    ck_assert(reduce(SPH2D_TAKE_RMS, 1, NAN, NAN) == 1);
    ck_assert(reduce(SPH2D_TAKE_SPREAD, 1, NAN, NAN) == 0);
    ck_assert(reduce(SPH2D_TAKE_VALUE, 1, NAN, 0) == 1);
    ck_assert(isnan(reduce(SPH2D_TAKE_CROSSING, 1, 1, NAN)));
    static const double at_once[3] = {1, 1, 1}; /* two samples at one time have no length between them */
    sph2d_study_curve still = {at_once, ys, 3};
    ck_assert(sph2d__curve_reduce(SPH2D_TAKE_MEAN, still, NAN, NAN) == -1);
    ck_assert(sph2d__curve_reduce(SPH2D_TAKE_RMS, still, NAN, NAN) == 1);
    ck_assert(isfinite(sph2d__curve_at(still, 1)));
}
END_TEST

START_TEST(periods_are_told_between_samples)
{
    enum { N = 501 };
    double x[N], y[N];
    for (int i = 0; i < N; ++i) {
        x[i] = 0.01 * i;
        y[i] = 5 + 2 * sin(2 * TEST_PI * x[i] / 0.7);
    }
    sph2d_study_curve wave = {x, y, N};
    ck_assert_double_eq_tol(sph2d__curve_reduce(SPH2D_TAKE_PERIOD, wave, NAN, NAN), 0.7, 1e-4);
    ck_assert_double_eq_tol(sph2d__curve_reduce(SPH2D_TAKE_PERIOD, wave, 6.5, NAN), 0.7, 1e-4);
    ck_assert(isnan(sph2d__curve_reduce(SPH2D_TAKE_PERIOD, wave, 7.5, NAN)));
    wave.count = 140; /* two crossings of the level, one period between them */
    ck_assert_double_eq_tol(sph2d__curve_reduce(SPH2D_TAKE_PERIOD, wave, 6.5, NAN), 0.7, 1e-4);
}
END_TEST

START_TEST(decays_are_the_slope_of_the_peaks)
{
    enum { N = 801 };
    double x[N], y[N];
    for (int i = 0; i < N; ++i) {
        x[i] = 0.005 * i;
        y[i] = 3 - 2 * exp(-0.6 * x[i]) * sin(2 * TEST_PI * x[i] / 0.7);
    }
    sph2d_study_curve wave = {x, y, N};
    ck_assert_double_eq_tol(sph2d__curve_reduce(SPH2D_TAKE_DECAY, wave, 3, NAN), 0.6, 1e-3);
    ck_assert_double_ge(fabs(sph2d__curve_reduce(SPH2D_TAKE_DECAY, wave, 3.1, NAN) - 0.6),
                        1e-2); /* its level matters */
    wave.count = 80;           /* from the first crossing to the second: one swing has no slope */
    ck_assert(isnan(sph2d__curve_reduce(SPH2D_TAKE_DECAY, wave, 3, NAN)));
    for (int i = 0; i < N; ++i)
        y[i] = 0.5 * exp(0.3 * x[i]) * sin(2 * TEST_PI * x[i] / 0.7); /* what grows has a negative one */
    wave.count = N;
    ck_assert_double_eq_tol(sph2d__curve_reduce(SPH2D_TAKE_DECAY, wave, 0, NAN), -0.3, 1e-3);
}
END_TEST

START_TEST(a_window_and_missing_values_leave_samples_out)
{
    static const double rows[18] = {0, 9, 10, 1, 9, NAN, 2, 9, 12, 3, 9, INFINITY, 4, 9, 14, 5, 9, 15};
    double room[12];
    sph2d_study_curve all = sph2d__curve_select(rows, 3, 2, 6, NAN, NAN, room);
    ck_assert_uint_eq(all.count, 4);
    ck_assert(all.y[0] == 10 && all.y[1] == 12 && all.y[2] == 14 && all.y[3] == 15 && all.x[1] == 2);
    sph2d_study_curve part =
        sph2d__curve_select(rows, 3, 2, 6, 2, nextafter(4, 0), room); /* a hair short of a sample */
    ck_assert_uint_eq(part.count, 2);
    ck_assert(part.x[0] == 2 && part.x[1] == 4);
    ck_assert_uint_eq(sph2d__curve_select(rows, 3, 2, 6, 2.5, 3.5, room).count, 0);
    ck_assert_uint_eq(sph2d__curve_select(rows, 3, 2, 0, NAN, NAN, room).count, 0);
}
END_TEST

/* ---- errors ------------------------------------------------------------------------------------------------------ */

START_TEST(a_reference_is_moved_to_fit_best)
{
    static const double t[4] = {0, 1, 2, 3}, v[4] = {0, 1, 2, 3}, late_t[2] = {1.5, 2.5}, late_v[2] = {1.25, 2.25};
    sph2d_study_curve curve = {t, v, 4}, late = {late_t, late_v, 2};
    ck_assert_double_eq_tol(sph2d__curve_compare(curve, 1, late, SPH2D_NORM_RMS, 0), 0.25, FINE);
    ck_assert_double_eq_tol(sph2d__curve_compare(curve, 1, late, SPH2D_NORM_RMS, 0.1), 0.15, FINE);
    ck_assert_double_eq_tol(sph2d__curve_compare(curve, 1, late, SPH2D_NORM_RMS, 0.5), 0, FINE);
}
END_TEST

START_TEST(a_series_is_compared_where_the_reference_has_points)
{
    static const double x[5] = {2.5, -1, 0.5, 3, 7}, y[5] = {0.5, 100, 1, 0, 100}; /* in any order, some outside */
    sph2d_study_curve curve = {xs, ys, 4}, points = {x, y, 5};
    /* differences 0, 1, 2 */
    ck_assert(sph2d__curve_compare(curve, 1, points, SPH2D_NORM_MAX, 0) == 2);
    ck_assert_double_eq_tol(sph2d__curve_compare(curve, 1, points, SPH2D_NORM_MEAN, 0), 1, FINE);
    ck_assert_double_eq_tol(sph2d__curve_compare(curve, 1, points, SPH2D_NORM_RMS, 0), sqrt(5. / 3), FINE);
    ck_assert_double_eq_tol(sph2d__curve_compare(curve, 2, points, SPH2D_NORM_MAX, 0), 1,
                            FINE); /* values halved, points not */
    ck_assert(isnan(sph2d__curve_compare(curve, 1, (sph2d_study_curve){x + 4, y + 4, 1}, SPH2D_NORM_MAX, 0)));
    ck_assert(isnan(sph2d__curve_compare((sph2d_study_curve){xs, ys, 0}, 1, points, SPH2D_NORM_MAX, 0)));
}
END_TEST

START_TEST(norms_of_differences_and_orders_of_convergence)
{
    static const double d[4] = {3, -4, 0, NAN};
    ck_assert(sph2d__norm(SPH2D_NORM_MAX, d, 3) == 4);
    ck_assert_double_eq_tol(sph2d__norm(SPH2D_NORM_MEAN, d, 3), 7. / 3, FINE);
    ck_assert_double_eq_tol(sph2d__norm(SPH2D_NORM_RMS, d, 3), sqrt(25. / 3), FINE);
    for (int norm = SPH2D_NORM_MAX; norm <= SPH2D_NORM_MEAN; ++norm) {
        ck_assert(isnan(sph2d__norm((sph2d_norm)norm, d, 4))); /* a point that is missing is no small error */
        ck_assert(isnan(sph2d__norm((sph2d_norm)norm, d, 0)));
    }
    ck_assert(sph2d__error(3, 5, false) == 2);
    ck_assert_double_eq_tol(sph2d__error(4, 5, true), 0.2, FINE);
    ck_assert_double_eq_tol(sph2d__error(-4, -5, true), 0.2, FINE);
    ck_assert_double_eq_tol(sph2d__order(0.08, 0.02, 0.2, 0.1), 2, FINE);
    ck_assert_double_eq_tol(sph2d__order(0.02, 0.08, 0.2, 0.1), -2, FINE);
    ck_assert(isnan(sph2d__order(0.08, 0, 0.2, 0.1)) && isnan(sph2d__order(NAN, 1, 0.2, 0.1)));
    ck_assert(isnan(sph2d__order(0.08, 0.02, 0.1, 0.1)) && isnan(sph2d__order(0.08, 0.02, 0.1, 0)));
}
END_TEST

Suite *suite_study_numbers(void)
{
    Suite *suite = suite_create("study_numbers");
    TCase *numbers = tcase_create("numbers of a series");
    tcase_add_test(numbers, a_series_of_straight_lines_is_reduced_exactly);
    tcase_add_test(numbers, what_a_series_cannot_give_is_no_number);
    tcase_add_test(numbers, one_sample_is_its_own_mean);
    tcase_add_test(numbers, periods_are_told_between_samples);
    tcase_add_test(numbers, decays_are_the_slope_of_the_peaks);
    tcase_add_test(numbers, a_window_and_missing_values_leave_samples_out);
    tcase_add_test(numbers, a_reference_is_moved_to_fit_best);
    tcase_add_test(numbers, a_series_is_compared_where_the_reference_has_points);
    tcase_add_test(numbers, norms_of_differences_and_orders_of_convergence);
    suite_add_tcase(suite, numbers);
    return suite;
}
