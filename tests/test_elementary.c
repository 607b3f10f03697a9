/* SPDX-License-Identifier: MIT */
/** @file test_elementary.c
 *  Logarithm, exponential and power by four operations: close to those of the C library, and the same bits everywhere. */
#include <math.h>

#include "base/elementary.h"
#include "common.h"

/** How far a number is from another in units of its last place. */
static double units_apart(double a, double from)
{
    const double size = fabs(from);
    return fabs(a - from) / (nextafter(size, INFINITY) - size);
}

/* The C library's own result is up to one unit off. */
START_TEST(close_to_the_c_library)
{
    uint64_t random = 7;
    for (int k = 0; k < 200000; ++k) {
        const double a = exp(test_random(&random, -30, 30)), near = test_random(&random, 0.5, 1.5),
                     b = test_random(&random, 0, 8), e = test_random(&random, -200, 200);
        ck_assert_msg(units_apart(sph2d__log(a), log(a)) < 3, "log %.17g", a);
        ck_assert_msg(units_apart(sph2d__log(near), log(near)) < 3, "log %.17g", near);
        ck_assert_msg(units_apart(sph2d__exp(e), exp(e)) < 3, "exp %.17g", e);
        ck_assert_msg(units_apart(sph2d__power(near, b), pow(near, b)) < 1 + 2.5 * (1 + fabs(b * log(near))),
                      "%.17g^%.17g", near, b);
    }
}
END_TEST

START_TEST(at_the_ends)
{
    ck_assert_double_eq(sph2d__log(1), 0);
    ck_assert_double_eq(sph2d__exp(0), 1);
    ck_assert_double_eq(sph2d__power(1, 3.7), 1);
    ck_assert_double_eq(sph2d__exp(-800), 0);
    ck_assert_double_eq(sph2d__exp(800), sph2d__exp(700));
    ck_assert_double_gt(sph2d__exp(700), 1e304);
}
END_TEST

/* Of the function as it was written, on x86-64: another system, compiler or device makes the same. */
START_TEST(same_bits)
{
    uint64_t hash = 0;
    for (int k = 1; k <= 1000; ++k) {
        const double a = k / 137.0;
        hash = (hash ^ sph2d__bits_of(sph2d__log(a))) * 0x9e3779b97f4a7c15U;
        hash = (hash ^ sph2d__bits_of(sph2d__exp(a - 3))) * 0x9e3779b97f4a7c15U;
        hash = (hash ^ sph2d__bits_of(sph2d__power(a, 2.37))) * 0x9e3779b97f4a7c15U;
    }
    ck_assert_uint_eq(hash, 16999922969264826297U);
}
END_TEST

Suite *suite_elementary(void)
{
    Suite *suite = suite_create("elementary");
    TCase *tests = tcase_create("functions");
    tcase_add_test(tests, close_to_the_c_library);
    tcase_add_test(tests, at_the_ends);
    tcase_add_test(tests, same_bits);
    suite_add_tcase(suite, tests);
    return suite;
}
