/* SPDX-License-Identifier: MIT */
/** @file test_study_front.c
 *  Error against time: the front, the cheapest row, orders, names, and rows that go on from the front. All numbers are
 *  made up here, so that what must come out can be read off. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common.h"
#include "study/parts.h"

enum { MOST = 8 };

static sph2d_study_measure measures[2];
static sph2d_study study;
static sph2d_override overrides[MOST][3];
static const char *places[MOST][3];
static sph2d_study_results s;

static void set_up(void)
{
    memset(measures, 0, sizeof measures);
    measures[0] = (sph2d_study_measure){.name = "mass", .expectation = SPH2D_EXPECT_NOTHING};
    measures[1] = (sph2d_study_measure){.name = "speed", .expectation = SPH2D_EXPECT_NUMBER, .order = 1};
    study = (sph2d_study){.scene = "scene.yaml", .measures = measures, .measure_count = 2, .along = "spacing"};
    s = (sph2d_study_results){.study = &study, .judge = 1, .rows = calloc(MOST, sizeof *s.rows)};
    ck_assert_ptr_nonnull(s.rows);
}

static void tear_down(void)
{
    for (size_t r = 0; r < s.row_count; ++r)
        sph2d__row_free(&s.rows[r]);
    free(s.rows);
}

/** Adds a row that finished: kernel and spacing as set, the error of "speed", and its CPU seconds. */
static sph2d_study_row *add(const char *name, const char *kernel, const char *spacing, double error, double cpu)
{
    size_t r = s.row_count++;
    ck_assert_uint_lt(r, MOST);
    overrides[r][0] = (sph2d_override){"kernel", kernel};
    overrides[r][1] = (sph2d_override){"spacing", spacing};
    sph2d_study_row *row = &s.rows[r];
    *row = (sph2d_study_row){.number = r + 1, .there = true, .wanted = true, .values = calloc(2, sizeof *row->values)};
    ck_assert_ptr_nonnull(row->values);
    row->run = (sph2d_study_run){.name = name,
                                 .overrides = overrides[r],
                                 .override_count = 2,
                                 .places = places[r],
                                 .given = strchr(name, '=') ? NULL : name,
                                 .given_count = strchr(name, '=') ? 0 : 2};
    row->record = (sph2d_study_record){.end = SPH2D_STUDY_FINISHED, .spacing = strtod(spacing, NULL), .cpu = cpu};
    row->values[1].error = error;
    return row;
}

/* ---- the front --------------------------------------------------------------------------------------------------- */

START_TEST(front_needs_less_time_or_a_smaller_error)
{
    sph2d_study_row *cheap = add("a", "c2", "0.1", 0.1, 1);
    sph2d_study_row *good = add("b", "c2", "0.05", 0.01, 10);
    sph2d_study_row *between = add("c", "c4", "0.1", 0.05, 2);
    sph2d_study_row *needless = add("d", "c4", "0.05", 0.05, 3);
    sph2d_study_row *dear = add("e", "c6", "0.05", 0.02, 10);
    sph2d__front_mark(&s);
    ck_assert(cheap->on_front && good->on_front && between->on_front);
    ck_assert(!needless->on_front && !dear->on_front);
    ck_assert_ptr_eq(sph2d_study_best(&s), good);
}
END_TEST

START_TEST(of_equal_rows_the_first_is_on_the_front)
{
    sph2d_study_row *first = add("a", "c2", "0.1", 0.1, 1), *second = add("b", "c4", "0.1", 0.1, 1);
    sph2d__front_mark(&s);
    ck_assert(first->on_front && !second->on_front);
}
END_TEST

START_TEST(cheapest_is_the_fastest_that_is_good_enough)
{
    add("a", "c2", "0.1", 0.1, 1);
    sph2d_study_row *fast = add("b", "c4", "0.05", 0.01, 5);
    add("c", "c2", "0.05", 0.001, 10);
    ck_assert_ptr_eq(sph2d_study_cheapest(&s, 0.01), fast);
    ck_assert_ptr_eq(sph2d_study_cheapest(&s, 0.0099), &s.rows[2]);
    ck_assert_ptr_null(sph2d_study_cheapest(&s, 0.0009));
}
END_TEST

START_TEST(rows_that_did_not_finish_are_nowhere)
{
    sph2d_study_row *row = add("a", "c2", "0.1", 0.001, 0.1);
    row->record.end = SPH2D_STUDY_GUARD;
    ck_assert(isnan(sph2d_study_row_error(&s, row)));
    sph2d_study_row *missing = add("b", "c2", "0.05", 0.001, 0.1);
    missing->there = false;
    ck_assert_ptr_null(sph2d__finest(&s));
    ck_assert_ptr_null(sph2d_study_best(&s));
    ck_assert_ptr_null(sph2d_study_cheapest(&s, 1));
    sph2d_study_row *whole = add("c", "c2", "0.1", 0.5, 3);
    sph2d__front_mark(&s);
    ck_assert(whole->on_front && !row->on_front && !missing->on_front);
    ck_assert_ptr_eq(sph2d__finest(&s), &s.rows[2]);
}
END_TEST

START_TEST(errors_without_a_number_are_not_good)
{
    add("a", "c2", "0.1", NAN, 0.1);
    add("b", "c2", "0.1", INFINITY, 0.1);
    sph2d__front_mark(&s);
    ck_assert(!s.rows[0].on_front && !s.rows[1].on_front);
    ck_assert_ptr_null(sph2d_study_best(&s));
}
END_TEST

START_TEST(judge_is_the_named_measure_or_the_first_with_an_error)
{
    ck_assert_uint_eq(sph2d__judge(&study), 1);
    study.judge = "speed";
    ck_assert_uint_eq(sph2d__judge(&study), 1);
    study.judge = "mass"; /* nothing is expected of it */
    ck_assert_uint_eq(sph2d__judge(&study), 2);
    study.judge = NULL;
    measures[1].expectation = SPH2D_EXPECT_NOTHING;
    ck_assert_uint_eq(sph2d__judge(&study), 2);
}
END_TEST

/* ---- orders ------------------------------------------------------------------------------------------------------ */

START_TEST(order_is_the_slope_of_the_logarithms)
{
    study.vary_count = 1;
    add("a", "c2", "0.4", 0.16, 1);
    add("b", "c4", "0.4", 0.4, 1);
    add("c", "c2", "0.2", 0.04, 1);
    add("d", "c4", "0.2", 0.2, 1);
    sph2d_study_row *last = add("e", "c2", "0.1", 0.01, 1);
    ck_assert_double_eq_tol(sph2d_study_row_order(&s, last), 2, 1e-12);
    ck_assert_double_eq_tol(sph2d_study_row_order(&s, &s.rows[1]), 1, 1e-12);
    last->values[1].error = 0.02; /* least squares: slopes 2 and 1 at equal distances give 1.5 */
    ck_assert_double_eq_tol(sph2d_study_row_order(&s, last), 1.5, 1e-12);
    sph2d__order_all(&s);
    ck_assert_double_eq_tol(last->values[1].order, 1, 1e-12);
    ck_assert_double_eq_tol(s.rows[2].values[1].order, 2, 1e-12);
    ck_assert_double_eq_tol(s.rows[3].values[1].order, 1, 1e-12);
}
END_TEST

START_TEST(one_row_or_one_spacing_has_no_order)
{
    add("a", "c2", "0.4", 0.16, 1);
    ck_assert(isnan(sph2d_study_row_order(&s, &s.rows[0])));
    add("b", "c2", "0.40", 0.08, 1); /* the same setting, written otherwise */
    ck_assert(isnan(sph2d_study_row_order(&s, &s.rows[0])));
}
END_TEST

START_TEST(along_another_key_rows_need_its_number)
{
    study.along = "kernel";
    add("a", "1.5", "0.1", 0.1, 1);
    add("b", "wendland_c4", "0.1", 0.1, 1);
    ck_assert_double_eq(sph2d_study_row_along(&s, &s.rows[0]), 1.5);
    ck_assert(isnan(sph2d_study_row_along(&s, &s.rows[1])));
    study.along = "cfl";
    ck_assert(isnan(sph2d_study_row_along(&s, &s.rows[0])));
    study.along = "spacing";
    ck_assert_double_eq(sph2d_study_row_along(&s, &s.rows[0]), 0.1);
}
END_TEST

/* ---- settings and names ------------------------------------------------------------------------------------------ */

START_TEST(the_last_override_of_a_key_counts)
{
    sph2d_study_row *row = add("a", "c2", "0.1", 0, 1);
    overrides[0][2] = (sph2d_override){"spacing", "0.05"};
    row->run.override_count = 3;
    ck_assert_str_eq(sph2d__setting(&row->run, "spacing"), "0.05");
    ck_assert_str_eq(sph2d__setting(&row->run, "kernel"), "c2");
    ck_assert_ptr_null(sph2d__setting(&row->run, "method.cfl"));
    sph2d_study_row *other = add("b", "c2", "0.050", 0, 1);
    ck_assert(sph2d__same_settings(&row->run, &other->run, "", false));
    overrides[1][1].value = "0.051";
    ck_assert(!sph2d__same_settings(&row->run, &other->run, "", false));
    ck_assert(sph2d__same_settings(&row->run, &other->run, "spacing", false));
    overrides[1][0].value = "c4";
    ck_assert(!sph2d__same_settings(&row->run, &other->run, "spacing", false));
}
END_TEST

START_TEST(names_list_what_a_given_one_does_not_stand_for)
{
    static const struct {
        const char *given, *paths[3], *but, *name;
        size_t count, given_count;
    } cases[] = {
        {NULL, {NULL}, NULL, "scene", 0, 0},
        {"", {NULL}, NULL, "scene", 0, 0},
        {"fine", {NULL}, NULL, "fine", 0, 0},
        {NULL, {"kernel", "method.spacing"}, NULL, "kernel=1, spacing=2", 2, 0},
        {NULL, {"kernel", "odd."}, "kernel", "odd.=2", 2, 0},
        {NULL, {"kernel"}, "kernel", "scene", 1, 0},
        {"fine", {"kernel", "cfl"}, NULL, "fine, cfl=2", 2, 1},
        {"fine", {"kernel", "cfl"}, "cfl", "fine", 2, 1},
        {"fine", {"kernel", "cfl"}, "kernel", "cfl=2", 2, 1}, /* with its key goes the name */
        {"fine", {"kernel", "cfl", "kernel"}, NULL, "fine, cfl=2, kernel=3", 3, 1},
        {NULL, {"kernel", "cfl", "kernel"}, NULL, "kernel=3, cfl=2", 3, 0}, /* the last value, in the first place */
        {"a\033b", {"cfl"}, NULL, "a?b, cfl=1", 1, 0},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        static const char *const values[] = {"1", "2", "3"};
        sph2d_override set[3];
        for (size_t k = 0; k < cases[i].count; ++k)
            set[k] = (sph2d_override){cases[i].paths[k], values[k]};
        sph2d_study_run run = {.overrides = set,
                               .override_count = cases[i].count,
                               .given = cases[i].given,
                               .given_count = cases[i].given_count};
        char out[64], part[5];
        ck_assert_uint_eq(sph2d_study_run_name(&run, cases[i].but, out, sizeof out), strlen(cases[i].name));
        ck_assert_str_eq(out, cases[i].name);
        ck_assert_uint_eq(sph2d_study_run_name(&run, cases[i].but, NULL, 0), strlen(cases[i].name));
        sph2d_study_run_name(&run, cases[i].but, part, sizeof part);
        ck_assert_msg(strncmp(part, out, 4) == 0 && strlen(part) <= 4, "%s", part);
    }
}
END_TEST

/* ---- rows that go on --------------------------------------------------------------------------------------------- */

static const sph2d_override finer[] = {{"spacing", "0.05"}};
static const char *const finer_places[] = {"refine[0].set.spacing"};
static const sph2d_study_run refinement = {
    .name = "spacing=0.05", .overrides = finer, .override_count = 1, .places = finer_places};

START_TEST(refinements_take_the_front_of_the_finest)
{
    study.refinements = &refinement;
    study.refinement_count = 1;
    add("kernel=c2, spacing=0.2", "c2", "0.2", 0.01, 0.1); /* on the front of all, but not of the finest */
    add("kernel=c2, spacing=0.1", "c2", "0.1", 0.3, 1);
    add("kernel=c4, spacing=0.1", "c4", "0.1", 0.4, 2);
    add("fine", "c6", "0.1", 0.1, 3);
    ck_assert_int_eq(sph2d_study_results_refine(&s, 0), SPH2D_OK);
    ck_assert_uint_eq(s.row_count, 6);
    const sph2d_study_run *a = &s.rows[4].run, *b = &s.rows[5].run;
    ck_assert_str_eq(a->name, "kernel=c2, spacing=0.05");
    ck_assert_str_eq(b->name, "fine, spacing=0.05");
    ck_assert_str_eq(sph2d__setting(a, "spacing"), "0.05");
    ck_assert_str_eq(sph2d__setting(b, "kernel"), "c6");
    ck_assert_str_eq(b->places[2], "refine[0].set.spacing");
    ck_assert_uint_eq(s.rows[4].number, 5);
    ck_assert(s.rows[4].owned && s.rows[4].wanted && !s.rows[4].there);
}
END_TEST

START_TEST(a_step_with_a_name_of_its_own_adds_it)
{
    sph2d_study_run step = refinement;
    step.name = step.given = "best";
    step.given_count = 1;
    study.refinements = &step;
    add("kernel=c2, spacing=0.1", "c2", "0.1", 0.3, 1);
    ck_assert_int_eq(sph2d_study_results_refine(&s, 0), SPH2D_OK);
    ck_assert_str_eq(s.rows[1].run.name, "kernel=c2, spacing=0.1, best");
}
END_TEST

START_TEST(what_the_others_are_compared_with_goes_on_too)
{
    study.refinements = &refinement;
    measures[1].expectation = SPH2D_EXPECT_FINEST;
    add("kernel=c2, spacing=0.2", "c2", "0.2", 0.1, 1);
    add("kernel=c2, spacing=0.1", "c2", "0.1", NAN, 5);
    ck_assert_int_eq(sph2d_study_results_refine(&s, 0), SPH2D_OK);
    ck_assert_uint_eq(s.row_count, 3);
    ck_assert_str_eq(s.rows[2].run.name, "kernel=c2, spacing=0.05");
}
END_TEST

Suite *suite_study_front(void)
{
    Suite *suite = suite_create("study_front");
    TCase *cases = tcase_create("study_front");
    tcase_add_checked_fixture(cases, set_up, tear_down);
    tcase_add_test(cases, front_needs_less_time_or_a_smaller_error);
    tcase_add_test(cases, of_equal_rows_the_first_is_on_the_front);
    tcase_add_test(cases, cheapest_is_the_fastest_that_is_good_enough);
    tcase_add_test(cases, rows_that_did_not_finish_are_nowhere);
    tcase_add_test(cases, errors_without_a_number_are_not_good);
    tcase_add_test(cases, judge_is_the_named_measure_or_the_first_with_an_error);
    tcase_add_test(cases, order_is_the_slope_of_the_logarithms);
    tcase_add_test(cases, one_row_or_one_spacing_has_no_order);
    tcase_add_test(cases, along_another_key_rows_need_its_number);
    tcase_add_test(cases, the_last_override_of_a_key_counts);
    tcase_add_test(cases, names_list_what_a_given_one_does_not_stand_for);
    tcase_add_test(cases, refinements_take_the_front_of_the_finest);
    tcase_add_test(cases, what_the_others_are_compared_with_goes_on_too);
    tcase_add_test(cases, a_step_with_a_name_of_its_own_adds_it);
    suite_add_tcase(suite, cases);
    return suite;
}
