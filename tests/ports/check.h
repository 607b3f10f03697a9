/* SPDX-License-Identifier: MIT */
/** @file check.h
 *  As much of Check as the suites of the core use, for machines that do not have it: each test in a process of its own,
 *  with a limit of its time. */
#ifndef SPH2D_PORTS_CHECK_H
#define SPH2D_PORTS_CHECK_H

#include <inttypes.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

typedef struct port_case TCase;
typedef struct port_suite Suite;

Suite *suite_create(const char *name);
TCase *tcase_create(const char *name);
void suite_add_tcase(Suite *suite, TCase *tests);
#define tcase_set_tags(tests, tags) ((void)(tests)) /* all are run */
void tcase_set_timeout(TCase *tests, double seconds);
void tcase_add_checked_fixture(TCase *tests, void (*before)(void), void (*after)(void));
void tcase_add_loop_test(TCase *tests, void (*test)(int), int first, int end);
#define tcase_add_test(tests, test) tcase_add_loop_test(tests, test, 0, 1)

#define START_TEST(name) static void name(int _i __attribute__((unused)))
#define END_TEST

/** Ends the test with its place and a sentence. */
_Noreturn void port_fail(const char *file, int line, const char *format, ...) __attribute__((format(printf, 3, 4)));

#define ck_abort_msg(...) port_fail(__FILE__, __LINE__, __VA_ARGS__)
#define ck_assert_msg(holds, ...) ((holds) ? (void)0 : ck_abort_msg("" __VA_ARGS__))
#define ck_assert(holds) ck_assert_msg(holds, "%s", #holds)

/* Both sides are evaluated once. */
#define PORT_COMPARE(type, form, x, relation, y)                                                                       \
    do {                                                                                                               \
        const type port_x = (x), port_y = (y);                                                                         \
        ck_assert_msg(port_x relation port_y, "%s %s %s: " form ", " form, #x, #relation, #y, port_x, port_y);         \
    } while (0)
#define PORT_INT(x, relation, y) PORT_COMPARE(intmax_t, "%" PRIdMAX, x, relation, y)
#define PORT_UINT(x, relation, y) PORT_COMPARE(uintmax_t, "%" PRIuMAX, x, relation, y)
#define PORT_DOUBLE(x, relation, y) PORT_COMPARE(double, "%.17g", x, relation, y)
#define PORT_POINTER(x, relation, y) PORT_COMPARE(uintptr_t, "%#" PRIxPTR, (uintptr_t)(x), relation, (uintptr_t)(y))
#define PORT_TEXT(x, relation, y)                                                                                      \
    do {                                                                                                               \
        const char *const port_x = (x), *const port_y = (y);                                                           \
        ck_assert_msg(port_x &&port_y &&strcmp(port_x, port_y) relation 0, "%s %s %s: \"%s\", \"%s\"", #x, #relation,  \
                      #y, port_x ? port_x : "NULL", port_y ? port_y : "NULL");                                         \
    } while (0)

#define ck_assert_int_eq(x, y) PORT_INT(x, ==, y)
#define ck_assert_int_ne(x, y) PORT_INT(x, !=, y)
#define ck_assert_int_lt(x, y) PORT_INT(x, <, y)
#define ck_assert_int_le(x, y) PORT_INT(x, <=, y)
#define ck_assert_int_gt(x, y) PORT_INT(x, >, y)
#define ck_assert_int_ge(x, y) PORT_INT(x, >=, y)
#define ck_assert_uint_eq(x, y) PORT_UINT(x, ==, y)
#define ck_assert_uint_ne(x, y) PORT_UINT(x, !=, y)
#define ck_assert_uint_lt(x, y) PORT_UINT(x, <, y)
#define ck_assert_uint_le(x, y) PORT_UINT(x, <=, y)
#define ck_assert_uint_gt(x, y) PORT_UINT(x, >, y)
#define ck_assert_uint_ge(x, y) PORT_UINT(x, >=, y)
#define ck_assert_double_eq(x, y) PORT_DOUBLE(x, ==, y)
#define ck_assert_double_ne(x, y) PORT_DOUBLE(x, !=, y)
#define ck_assert_double_lt(x, y) PORT_DOUBLE(x, <, y)
#define ck_assert_double_le(x, y) PORT_DOUBLE(x, <=, y)
#define ck_assert_double_gt(x, y) PORT_DOUBLE(x, >, y)
#define ck_assert_double_ge(x, y) PORT_DOUBLE(x, >=, y)
#define ck_assert_double_eq_tol(x, y, tolerance)                                                                       \
    do {                                                                                                               \
        const double port_x = (x), port_y = (y), port_t = (tolerance);                                                 \
        ck_assert_msg(fabs(port_x - port_y) < port_t, "%s == %s: %.17g, %.17g within %g", #x, #y, port_x, port_y,      \
                      port_t);                                                                                         \
    } while (0)
#define ck_assert_ptr_eq(x, y) PORT_POINTER(x, ==, y)
#define ck_assert_ptr_ne(x, y) PORT_POINTER(x, !=, y)
#define ck_assert_ptr_null(x) PORT_POINTER(x, ==, NULL)
#define ck_assert_ptr_nonnull(x) PORT_POINTER(x, !=, NULL)
#define ck_assert_str_eq(x, y) PORT_TEXT(x, ==, y)
#define ck_assert_str_ne(x, y) PORT_TEXT(x, !=, y)
#define ck_assert_mem_eq(x, y, size) ck_assert_msg(memcmp(x, y, size) == 0, "%s and %s differ in memory", #x, #y)
#define ck_assert_mem_ne(x, y, size) ck_assert_msg(memcmp(x, y, size) != 0, "%s and %s are the same in memory", #x, #y)

#endif
