/* SPDX-License-Identifier: MIT */
/** @file test_study.c
 *  Studies: how a series becomes a number, what a study file says, and what it is compared with. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../cli/study/study_reference.h"
#include "common.h"

static const double FINE = 1e-12;
static sph2d_report report;

static void set_up(void)
{
    sph2d_report_clear(&report);
}

/* ---- numbers of a series ----------------------------------------------------------------------------------------- */

static const double xs[4] = {0, 1, 2, 3}, ys[4] = {1, 3, -1, 2};

static double reduce(sph2d_take take, size_t count, double level, double at)
{
    return study_reduce(take, (study_curve){xs, ys, count}, level, at);
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
    static const sph2d_take all[] = {SPH2D_TAKE_LAST,   SPH2D_TAKE_MAX,      SPH2D_TAKE_MIN,
                                     SPH2D_TAKE_MEAN,   SPH2D_TAKE_RMS,      SPH2D_TAKE_SPREAD,
                                     SPH2D_TAKE_PERIOD, SPH2D_TAKE_CROSSING, SPH2D_TAKE_VALUE,
                                     SPH2D_TAKE_DECAY};
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
    study_curve still = {at_once, ys, 3};
    ck_assert(study_reduce(SPH2D_TAKE_MEAN, still, NAN, NAN) == -1);
    ck_assert(study_reduce(SPH2D_TAKE_RMS, still, NAN, NAN) == 1);
    ck_assert(isfinite(study_at(still, 1)));
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
    study_curve wave = {x, y, N};
    ck_assert_double_eq_tol(study_reduce(SPH2D_TAKE_PERIOD, wave, NAN, NAN), 0.7, 1e-4);
    ck_assert_double_eq_tol(study_reduce(SPH2D_TAKE_PERIOD, wave, 6.5, NAN), 0.7, 1e-4);
    ck_assert(isnan(study_reduce(SPH2D_TAKE_PERIOD, wave, 7.5, NAN)));
    wave.count = 140; /* two crossings of the level, one period between them */
    ck_assert_double_eq_tol(study_reduce(SPH2D_TAKE_PERIOD, wave, 6.5, NAN), 0.7, 1e-4);
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
    study_curve wave = {x, y, N};
    ck_assert_double_eq_tol(study_reduce(SPH2D_TAKE_DECAY, wave, 3, NAN), 0.6, 1e-3);
    ck_assert_double_ge(fabs(study_reduce(SPH2D_TAKE_DECAY, wave, 3.1, NAN) - 0.6), 1e-2); /* its level matters */
    wave.count = 80; /* from the first crossing to the second: one swing has no slope */
    ck_assert(isnan(study_reduce(SPH2D_TAKE_DECAY, wave, 3, NAN)));
    for (int i = 0; i < N; ++i)
        y[i] = 0.5 * exp(0.3 * x[i]) * sin(2 * TEST_PI * x[i] / 0.7); /* what grows has a negative one */
    wave.count = N;
    ck_assert_double_eq_tol(study_reduce(SPH2D_TAKE_DECAY, wave, 0, NAN), -0.3, 1e-3);
}
END_TEST

START_TEST(a_window_and_missing_values_leave_samples_out)
{
    static const double t[6] = {0, 1, 2, 3, 4, 5};
    static const double pairs[12] = {9, 10, 9, NAN, 9, 12, 9, INFINITY, 9, 14, 9, 15};
    double x[6], y[6];
    study_curve all = study_select(t, pairs + 1, 2, 6, NAN, NAN, x, y);
    ck_assert_uint_eq(all.count, 4);
    ck_assert(y[0] == 10 && y[1] == 12 && y[2] == 14 && y[3] == 15 && x[1] == 2);
    study_curve part = study_select(t, pairs + 1, 2, 6, 2, nextafter(4, 0), x, y); /* a hair short of a sample */
    ck_assert_uint_eq(part.count, 2);
    ck_assert(x[0] == 2 && x[1] == 4);
    ck_assert_uint_eq(study_select(t, pairs + 1, 2, 6, 2.5, 3.5, x, y).count, 0);
    ck_assert_uint_eq(study_select(t, pairs + 1, 2, 0, NAN, NAN, x, y).count, 0);
}
END_TEST

/* ---- errors ------------------------------------------------------------------------------------------------------ */

START_TEST(a_reference_is_moved_to_fit_best)
{
    static const double t[4] = {0, 1, 2, 3}, v[4] = {0, 1, 2, 3}, late_t[2] = {1.5, 2.5}, late_v[2] = {1.25, 2.25};
    study_curve curve = {t, v, 4}, late = {late_t, late_v, 2};
    ck_assert_double_eq_tol(study_compare(curve, 1, late, SPH2D_NORM_RMS, 0), 0.25, FINE);
    ck_assert_double_eq_tol(study_compare(curve, 1, late, SPH2D_NORM_RMS, 0.1), 0.15, FINE);
    ck_assert_double_eq_tol(study_compare(curve, 1, late, SPH2D_NORM_RMS, 0.5), 0, FINE);
}
END_TEST

START_TEST(a_series_is_compared_where_the_reference_has_points)
{
    static const double x[5] = {2.5, -1, 0.5, 3, 7}, y[5] = {0.5, 100, 1, 0, 100}; /* in any order, some outside */
    study_curve curve = {xs, ys, 4}, points = {x, y, 5};
    /* differences 0, 1, 2 */
    ck_assert(study_compare(curve, 1, points, SPH2D_NORM_MAX, 0) == 2);
    ck_assert_double_eq_tol(study_compare(curve, 1, points, SPH2D_NORM_MEAN, 0), 1, FINE);
    ck_assert_double_eq_tol(study_compare(curve, 1, points, SPH2D_NORM_RMS, 0), sqrt(5. / 3), FINE);
    ck_assert_double_eq_tol(study_compare(curve, 2, points, SPH2D_NORM_MAX, 0), 1,
                            FINE); /* values halved, points not */
    ck_assert(isnan(study_compare(curve, 1, (study_curve){x + 4, y + 4, 1}, SPH2D_NORM_MAX, 0)));
    ck_assert(isnan(study_compare((study_curve){xs, ys, 0}, 1, points, SPH2D_NORM_MAX, 0)));
}
END_TEST

START_TEST(norms_of_differences_and_orders_of_convergence)
{
    static const double d[4] = {3, -4, 0, NAN};
    ck_assert(study_norm(SPH2D_NORM_MAX, d, 3) == 4);
    ck_assert_double_eq_tol(study_norm(SPH2D_NORM_MEAN, d, 3), 7. / 3, FINE);
    ck_assert_double_eq_tol(study_norm(SPH2D_NORM_RMS, d, 3), sqrt(25. / 3), FINE);
    for (int norm = SPH2D_NORM_MAX; norm <= SPH2D_NORM_MEAN; ++norm) {
        ck_assert(isnan(study_norm((sph2d_norm)norm, d, 4))); /* a point that is missing is no small error */
        ck_assert(isnan(study_norm((sph2d_norm)norm, d, 0)));
    }
    ck_assert(study_error(3, 5, false) == 2);
    ck_assert_double_eq_tol(study_error(4, 5, true), 0.2, FINE);
    ck_assert_double_eq_tol(study_error(-4, -5, true), 0.2, FINE);
    ck_assert_double_eq_tol(study_order(0.08, 0.02, 0.2, 0.1), 2, FINE);
    ck_assert_double_eq_tol(study_order(0.02, 0.08, 0.2, 0.1), -2, FINE);
    ck_assert(isnan(study_order(0.08, 0, 0.2, 0.1)) && isnan(study_order(NAN, 1, 0.2, 0.1)));
    ck_assert(isnan(study_order(0.08, 0.02, 0.1, 0.1)) && isnan(study_order(0.08, 0.02, 0.1, 0)));
}
END_TEST

/* ---- study files: one fault, one sentence ------------------------------------------------------------------------ */

#define RUNS "scene: s.yaml\nruns:\n  - set: {spacing: 0.1}\n"
#define MEASURE RUNS "measures:\n  - name: a\n    probe: p\n    column: c\n" /* seven lines that are a study */
#define REFERENCE "    reference: {file: r, x: x, y: y}\n"
#define PROFILE RUNS "measures:\n  - name: a\n    profile: {line: [[0, 0], [0, 1]], value: vx}\n"

static const struct fault {
    const char *text;
    sph2d_code code;
    const char *path;
    int line, column;
    const char *message, *hint; /**< parts of them */
} faults[] = {
    /* keys and types */
    {"runs: [{}]\n", SPH2D_CODE_MISSING_KEY, "scene", 0, 0, "'scene' must be given", "the scene file"},
    {"scene: a\nruns: []\n", SPH2D_CODE_MISSING_KEY, "runs", 2, 7, "there is no run", "set: {}"},
    {RUNS "mesures: []\n", SPH2D_CODE_UNKNOWN_KEY, "mesures", 4, 1, "'mesures'", "did you mean 'measures'?"},
    {RUNS "  - sett: {}\n", SPH2D_CODE_UNKNOWN_KEY, "runs[1].sett", 4, 5, "'sett'", "did you mean 'set'?"},
    {RUNS "  - set: [spacing, 1]\n", SPH2D_CODE_WRONG_TYPE, "runs[1].set", 4, 10, "expected a mapping, got a list", ""},
    {RUNS "  - set: {a: 1, b: 2, a: 3}\n", SPH2D_CODE_DUPLICATE_KEY, "runs[1].set", 4, 23, "'a' is given twice",
     "line 4"},
    {RUNS "  - set: {a: &b 1}\n", SPH2D_CODE_SYNTAX, "", 4, 15, "anchors", ""},
    {RUNS "  - {skip: yes}\n", SPH2D_CODE_WRONG_TYPE, "runs[1].skip", 4, 12, "'yes' is none", "false, true"},
    {RUNS "  - 3\n", SPH2D_CODE_WRONG_TYPE, "runs[1]", 4, 5, "expected a mapping, got '3'", ""},
    {MEASURE "    take: lats\n", SPH2D_CODE_WRONG_TYPE, "measures[0].take", 8, 11, "'lats'", "did you mean 'last'?"},
    {MEASURE "    scale: x\n", SPH2D_CODE_WRONG_TYPE, "measures[0].scale", 8, 12, "expected a number, got 'x'", ""},
    {MEASURE "    expect: .nan\n", SPH2D_CODE_OUT_OF_RANGE, "measures[0].expect", 8, 13, "not a finite number", ""},
    {MEASURE "    scale: 0\n", SPH2D_CODE_OUT_OF_RANGE, "measures[0].scale", 8, 12,
     "0 is out of range: must be above 0", "divides"},
    {MEASURE "    expect: 1\n    bound: -1\n", SPH2D_CODE_OUT_OF_RANGE, "measures[0].bound", 9, 12, "at least 0", ""},
    {MEASURE "    to: -1\n", SPH2D_CODE_OUT_OF_RANGE, "measures[0].to", 8, 9, "at least 0", ""},
    {MEASURE "    reference: {file: r, x: x}\n", SPH2D_CODE_MISSING_KEY, "measures[0].reference.y", 8, 16,
     "'y' must be given", ""},
    /* keys beside each other */
    {RUNS "measures: [{name: a}]\n", SPH2D_CODE_MISSING_KEY, "measures[0]", 4, 12, "nothing to measure",
     "probe, profile"},
    {RUNS "measures: [{probe: a, column: b}]\n", SPH2D_CODE_MISSING_KEY, "measures[0].name", 4, 12, "'name'", ""},
    {RUNS "measures: [{name: a, probe: p}]\n", SPH2D_CODE_MISSING_KEY, "measures[0]", 4, 12, "'column' must be given",
     ""},
    {MEASURE "    take: crossing\n", SPH2D_CODE_MISSING_KEY, "measures[0]", 5, 5, "'level' must be given", ""},
    {MEASURE "    take: value\n", SPH2D_CODE_MISSING_KEY, "measures[0]", 5, 5, "'at' must be given", ""},
    {MEASURE "    level: 3\n", SPH2D_CODE_CONFLICT, "measures[0].level", 8, 12, "none of period, crossing and decay", ""},
    {MEASURE "    at: 3\n", SPH2D_CODE_CONFLICT, "measures[0].at", 8, 9, "'take' is not value", ""},
    {MEASURE "    from: 3\n    to: 2\n", SPH2D_CODE_CONFLICT, "measures[0].to", 9, 9, "'to' lies before 'from'", ""},
    {MEASURE "    bound: 3\n", SPH2D_CODE_CONFLICT, "measures[0].bound", 8, 12,
     "without 'expect', 'reference' or 'finest'", ""},
    {MEASURE "    order: true\n", SPH2D_CODE_CONFLICT, "measures[0].order", 8, 12, "without 'expect'", ""},
    {MEASURE "    expect: 1\n    norm: rms\n", SPH2D_CODE_CONFLICT, "measures[0].norm", 9, 11, "without 'reference'",
     ""},
    {MEASURE "    expect: 0\n    relative: true\n", SPH2D_CODE_OUT_OF_RANGE, "measures[0].expect", 8, 13,
     "relative to 0", ""},
    {MEASURE REFERENCE "    expect: 1\n", SPH2D_CODE_CONFLICT, "measures[0].expect", 9, 5,
     "'expect' excludes 'reference'", "one of expect, reference"},
    {MEASURE REFERENCE "    take: max\n", SPH2D_CODE_CONFLICT, "measures[0].take", 9, 11, "the whole series", ""},
    {MEASURE REFERENCE "    relative: true\n", SPH2D_CODE_CONFLICT, "measures[0].relative", 9, 15, "'scale'", ""},
    {MEASURE "    profile: {line: [[0, 0], [0, 1]], value: vx}\n", SPH2D_CODE_CONFLICT, "measures[0].profile", 8, 5,
     "'profile' excludes 'probe' on line 6", ""},
    {PROFILE, SPH2D_CODE_MISSING_KEY, "measures[0]", 5, 5, "'reference' must be given with a profile", ""},
    {PROFILE REFERENCE "    take: max\n", SPH2D_CODE_CONFLICT, "measures[0].take", 8, 11, "with a profile", ""},
    {PROFILE REFERENCE "    column: c\n", SPH2D_CODE_CONFLICT, "measures[0].column", 8, 13, "with a profile", ""},
    {RUNS "measures:\n  - name: a\n    profile: {line: [[0, 0]], value: vx}\n" REFERENCE, SPH2D_CODE_WRONG_TYPE,
     "measures[0].profile.line", 6, 21, "two ends", ""},
    {RUNS "measures:\n  - name: a\n    profile: {line: [[0, 1], [0, 1]], value: vx}\n" REFERENCE, SPH2D_CODE_CONFLICT,
     "measures[0].profile.line", 6, 21, "the same point", ""},
    {RUNS "measures: [{name: a, summary: compression, take: max}]\n", SPH2D_CODE_CONFLICT, "measures[0].take", 4, 50,
     "with a summary", ""},
    {RUNS "measures: [{name: a, summary: pressure}]\n", SPH2D_CODE_WRONG_TYPE, "measures[0].summary", 4, 31,
     "'pressure'", "compression_mean"},
    /* what is no study */
    {"", SPH2D_CODE_SYNTAX, "", 0, 0, "it is empty", "scene, runs and measures"},
    {"- a\n", SPH2D_CODE_SYNTAX, "", 1, 1, "expected the keys of a study, got a list of 1", ""},
    {"scene: [a\n", SPH2D_CODE_SYNTAX, "", 1, 8, "not closed", ""},
};

static sph2d_study_file *parse(const char *text, const char *name, sph2d_status expected)
{
    sph2d_study_file *file = NULL;
    sph2d_status status = sph2d_study_file_parse(text, strlen(text), name, &file, &report);
    ck_assert_msg(status == expected, "status %d:\n%s", (int)status, test_report_text(&report));
    ck_assert_int_eq(file != NULL, status == SPH2D_OK);
    return file;
}

START_TEST(each_fault_has_its_place)
{
    const struct fault *f = &faults[_i];
    parse(f->text, "s.yaml", SPH2D_SCENE);
    const char *all = test_report_text(&report);
    ck_assert_msg(report.count == 1 && report.errors == 1, "not one error:\n%s", all);
    const sph2d_diagnostic *d = &report.items[0];
    ck_assert_msg(d->code == f->code, "%s", all);
    ck_assert_str_eq(d->path, f->path);
    ck_assert_str_eq(d->file, "s.yaml");
    ck_assert_msg(d->line == f->line && d->column == f->column, "expected %d:%d in\n%s", f->line, f->column, all);
    ck_assert_msg(strstr(d->message, f->message) != NULL, "expected '%s' in\n%s", f->message, all);
    ck_assert_msg(strstr(d->hint, f->hint) != NULL, "expected '%s' in\n%s", f->hint, all);
}
END_TEST

START_TEST(faults_come_in_the_order_of_the_file)
{
    parse("measures: [{name: a, probe: p, column: c, at: 1, scale: -1}]\nruns: []\nscene: 3\nx: 1\n", "s.yaml",
          SPH2D_SCENE);
    ck_assert_msg(report.count == 4, "%s", test_report_text(&report));
    ck_assert_int_eq(report.items[0].column, 47);
    ck_assert_int_eq(report.items[1].column, 57);
    ck_assert_int_eq(report.items[2].line, 2);
    ck_assert_int_eq(report.items[3].line, 4);
    sph2d_study_file *file;
    ck_assert_int_eq(sph2d_study_file_parse("x", 1, "s", &file, NULL), SPH2D_SCENE);
    ck_assert_int_eq(sph2d_study_file_parse(NULL, 1, "s", &file, NULL), SPH2D_INVALID);
    ck_assert_int_eq(sph2d_study_file_parse("x", 1, "s", NULL, NULL), SPH2D_INVALID);
    ck_assert_int_eq(sph2d_study_file_read("/missing/study.yaml", &file, &report), SPH2D_NOINPUT);
    ck_assert_ptr_null(file);
    sph2d_study_file_destroy(NULL);
}
END_TEST

/* ---- study files: what is read ----------------------------------------------------------------------------------- */

START_TEST(every_key_arrives)
{
    sph2d_study_file *file =
        parse("scene: ../s.yaml\n"
              "runs:\n  - {name: first, set: {spacing: 0.1}, skip: true}\n"
              "  - set:\n      method.sound_speed: 10\n      blocks[0].velocity: [1, 0]\n  - {}\n"
              "measures:\n"
              "  - {name: a, probe: p, column: c, take: period, level: 1, from: 2, to: 3, scale: 4, expect: 5, "
              "relative: true, bound: 0.5, order: true}\n"
              "  - {name: b, profile: {line: [[1, 2], [3, 4]], value: density}, norm: mean, "
              "reference: {file: r.csv, x: u, y: v}}\n"
              "  - {name: c, probe: p, column: c, reference: {file: /r.csv, x: u, y: v}}\n",
              "in/here/study.yaml", SPH2D_OK);
    const sph2d_study *s = sph2d_study_file_study(file);
    ck_assert_str_eq(s->scene, "in/here/../s.yaml");
    ck_assert_uint_eq(s->run_count, 3);
    ck_assert_str_eq(s->runs[0].name, "first");
    ck_assert(s->runs[0].skip == 1 && s->runs[1].skip == 0 && s->runs[1].override_count == 2);
    ck_assert_str_eq(s->runs[1].name, "sound_speed=10, velocity=[1, 0]");
    ck_assert_str_eq(s->runs[1].overrides[1].path, "blocks[0].velocity");
    ck_assert_str_eq(s->runs[2].name, "scene");
    ck_assert_uint_eq(s->measure_count, 3);
    const sph2d_study_measure *m = s->measures;
    ck_assert(m[0].source == SPH2D_MEASURE_PROBE && m[0].take == SPH2D_TAKE_PERIOD && m[0].level == 1);
    ck_assert(m[0].from == 2 && m[0].to == 3 && m[0].scale == 4 && m[0].expect == 5 && m[0].bound == 0.5);
    ck_assert(m[0].relative == 1 && m[0].order == 1 && m[0].expectation == SPH2D_EXPECT_NUMBER);
    ck_assert(m[1].source == SPH2D_MEASURE_PROFILE && m[1].profile.value == SPH2D_QUANTITY_DENSITY);
    ck_assert(m[1].profile.line.count == 2 && m[1].profile.line.items[1].y == 4 && m[1].norm == SPH2D_NORM_MEAN);
    ck_assert_str_eq(m[1].reference.file, "in/here/r.csv");
    ck_assert_str_eq(m[2].reference.file, "/r.csv");
    ck_assert(m[2].take == SPH2D_TAKE_DEFAULT && m[2].scale == 1 && isnan(m[2].at) && isnan(m[2].bound));
    sph2d_diagnostic d = {.path = "runs[1].set[1]"};
    sph2d_study_file_locate(file, &d);
    ck_assert(d.line == 6 && d.column == 27);
    sph2d_study_file_destroy(file);
}
END_TEST

START_TEST(values_of_overrides_mean_the_same_again)
{
    static const struct {
        const char *written, *text;
    } values[] = {
        {"0.1", "0.1"},
        {"-1e-3", "-1e-3"},
        {"word", "word"},
        {"two words", "two words"},
        {"\"0.1\"", "\"0.1\""}, /* a text stays one */
        {"'it''s \"x\"'", "\"it's \\\"x\\\"\""},
        {"\"a\\nb\\\\\"", "\"a\\x0Ab\\\\\""},
        {"", "null"},
        {"~", "null"},
        {"[]", "[]"},
        {"[1, [2, a], \"b, c\"]", "[1, [2, a], \"b, c\"]"},
        {"\n      - x: 1\n        y: {z: [0, -1.5]}\n      - a, b",
         "[{\"x\": 1, \"y\": {\"z\": [0, -1.5]}}, \"a, b\"]"},
    };
    for (size_t i = 0; i < sizeof values / sizeof *values; ++i) {
        char text[400];
        snprintf(text, sizeof text, "scene: s\nruns:\n  - set:\n      name: %s\n", values[i].written);
        sph2d_study_file *file = parse(text, "s.yaml", SPH2D_OK);
        ck_assert_str_eq(sph2d_study_file_study(file)->runs[0].overrides[0].value, values[i].text);
        sph2d_study_file_destroy(file);
    }
    sph2d_study_file *file = parse("scene: s\nruns: [{name: \"a\\eb\", set: {}}]\n", "s.yaml", SPH2D_OK);
    ck_assert_str_eq(sph2d_study_file_study(file)->runs[0].name, "a?b"); /* nothing for a terminal to obey */
    sph2d_study_file_destroy(file);
}
END_TEST

/* ---- references -------------------------------------------------------------------------------------------------- */

static char folder[] = "/tmp/sph2d-study-XXXXXX";
static study_points points;

static void set_up_folder(void)
{
    ck_assert_ptr_nonnull(mkdtemp(folder));
    ck_assert_int_eq(chdir(folder), 0);
    sph2d_report_clear(&report);
}

static void tear_down_folder(void)
{
    study_points_free(&points);
    ck_assert_int_eq(chdir("/"), 0);
    char command[64];
    snprintf(command, sizeof command, "rm -rf %s", folder);
    ck_assert_int_eq(system(command), 0);
}

static sph2d_status read_points(const char *text, size_t length, bool along)
{
    FILE *stream = fopen("r.csv", "w");
    ck_assert_ptr_nonnull(stream);
    ck_assert_uint_eq(fwrite(text, 1, length, stream), length);
    ck_assert_int_eq(fclose(stream), 0);
    study_points_free(&points);
    sph2d_study_reference reference = {"r.csv", "t", "a", 0};
    return study_points_read(&points, &reference, along, &report);
}

START_TEST(references_are_tables_with_comments_units_and_gaps)
{
    static const char text[] = "\xef\xbb\xbf# who measured it, and when\r\n\r\n  \nx,a [m] , t [s]\r\n"
                               "7,1.5,2\r\n,nan,3\n1, ,4\n1,5,\n# a gap\nword,\t-2e-1 , .5\n1,3,0";
    sph2d_status status = read_points(text, sizeof text - 1, false);
    ck_assert_msg(status == SPH2D_OK, "%s", test_report_text(&report));
    study_curve c = study_points_curve(&points);
    ck_assert_uint_eq(c.count, 3);
    ck_assert(c.x[0] == 2 && c.y[0] == 1.5 && c.x[1] == 0.5 && c.y[1] == -0.2 && c.x[2] == 0 && c.y[2] == 3);
    char many[8000] = "t,a\n";
    for (int i = 0; i < 500; ++i)
        snprintf(many + strlen(many), sizeof many - strlen(many), "%g,%d\n", i / 500., i);
    ck_assert_int_eq(read_points(many, strlen(many), true), SPH2D_OK);
    ck_assert(points.count == 500 && points.y[499] == 499);
}
END_TEST

static const struct {
    const char *text;
    sph2d_code code;
    int line, column;
    const char *message, *hint;
} unsound[] = {
    {"", SPH2D_CODE_FILE_KIND, 0, 0, "it is empty", ""},
    {"# only\n# comments\n", SPH2D_CODE_FILE_KIND, 0, 0, "it is empty", ""},
    {"t,a\n", SPH2D_CODE_FILE_FIELD, 0, 0, "no row with both numbers", ""},
    {"t,a\n1,\n", SPH2D_CODE_FILE_FIELD, 0, 0, "no row with both numbers", ""},
    {"# x\nt,b\n1,2\n", SPH2D_CODE_FILE_FIELD, 2, 1, "no column 'a'", "columns here: t, b"},
    {"t,ab\n1,2\n", SPH2D_CODE_FILE_FIELD, 1, 1, "no column 'a'", ""},
    {"t,a\n1,x\n", SPH2D_CODE_FILE_FIELD, 2, 3, "expected a number, got 'x'", ""},
    {"t,a\n1,2 m\n", SPH2D_CODE_FILE_FIELD, 2, 3, "got '2 m'", ""},
    {"t,a\n1,inf\n", SPH2D_CODE_FILE_FIELD, 2, 3, "got 'inf'", ""},
    {"t,a\n\xc3\xa4 1,2\n", SPH2D_CODE_FILE_FIELD, 2, 1, "expected a number", ""},
    {"t,\xc3\xa4,a\n1,\xc3\xa4,2,3\n0,\xc3\xa4, x\n", SPH2D_CODE_FILE_FIELD, 3, 6, "got 'x'", ""},
    {"t,a\n1,2\n1\n", SPH2D_CODE_FILE_FIELD, 3, 2, "ends before its column 'a'", ""},
    {"t,a\n0,2\n1.5,2\n", SPH2D_CODE_OUT_OF_RANGE, 3, 1, "1.5 does not lie on the line", ""},
};

START_TEST(each_fault_of_a_reference_has_its_place)
{
    ck_assert_int_eq(read_points(unsound[_i].text, strlen(unsound[_i].text), true), SPH2D_FORMAT);
    const char *all = test_report_text(&report);
    ck_assert_msg(report.count == 1, "%s", all);
    const sph2d_diagnostic *d = &report.items[0];
    ck_assert_msg(d->code == unsound[_i].code, "%s", all);
    ck_assert_str_eq(d->file, "r.csv");
    ck_assert_msg(d->line == unsound[_i].line && d->column == unsound[_i].column, "%d:%d in\n%s", d->line, d->column,
                  all);
    ck_assert_msg(strstr(d->message, unsound[_i].message) != NULL, "%s", all);
    ck_assert_msg(strstr(d->hint, unsound[_i].hint) != NULL, "%s", all);
}
END_TEST

START_TEST(what_is_no_table_is_refused)
{
    static char garbage[100000] = {0};
    ck_assert_int_eq(read_points(garbage, sizeof garbage, false), SPH2D_FORMAT);
    ck_assert_msg(strstr(report.items[0].message, "no text") != NULL, "%s", test_report_text(&report));
    memset(garbage, ',', sizeof garbage);
    ck_assert_int_eq(read_points(garbage, sizeof garbage, false), SPH2D_FORMAT);
    ck_assert_uint_eq(report.errors, 2);
    sph2d_study_reference reference = {"missing.csv", "t", "a", 0};
    ck_assert_int_eq(study_points_read(&points, &reference, false, &report), SPH2D_NOINPUT);
    reference.file = ".";
    ck_assert_int_eq(study_points_read(&points, &reference, false, &report), SPH2D_NOINPUT);
    ck_assert_int_eq(study_points_read(&points, &reference, false, NULL), SPH2D_NOINPUT);
}
END_TEST

Suite *suite_study(void)
{
    Suite *suite = suite_create("study");
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
    TCase *files = tcase_create("study files");
    tcase_add_checked_fixture(files, set_up, NULL);
    tcase_add_loop_test(files, each_fault_has_its_place, 0, sizeof faults / sizeof faults[0]);
    tcase_add_test(files, faults_come_in_the_order_of_the_file);
    tcase_add_test(files, every_key_arrives);
    tcase_add_test(files, values_of_overrides_mean_the_same_again);
    suite_add_tcase(suite, files);
    TCase *references = tcase_create("references");
    tcase_add_checked_fixture(references, set_up_folder, tear_down_folder);
    tcase_add_test(references, references_are_tables_with_comments_units_and_gaps);
    tcase_add_loop_test(references, each_fault_of_a_reference_has_its_place, 0, sizeof unsound / sizeof unsound[0]);
    tcase_add_test(references, what_is_no_table_is_refused);
    suite_add_tcase(suite, references);
    return suite;
}
