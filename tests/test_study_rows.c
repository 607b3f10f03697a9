/* SPDX-License-Identifier: MIT */
/** @file test_study_rows.c
 *  The rows of a study: which runs `runs`, `vary` and `refine` make, what they are called and where they stand in the
 *  file; and what `finest`, `judge`, `target` and `repeat` take. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common.h"
#include "sph2d/study.h"

#define SCENE "scene: a.yaml\n" /* one line */
#define MEASURES                                                                                                       \
    SCENE "measures:\n"                                                                                                \
          "  - {name: seen, probe: p, column: c}\n"                                                                    \
          "  - {name: judged, probe: p, column: c, expect: 1}\n"                                /* four lines */
#define SERIES SCENE "measures:\n  - name: a\n    probe: p\n    column: c\n"                    /* five lines */
#define LINE SCENE "measures:\n  - name: a\n    profile: {line: [[0, 0], [0, 1]], value: vx}\n" /* four lines */

static sph2d_report report;
static sph2d_study_file *file;

static void set_up(void)
{
    sph2d_report_clear(&report);
    file = NULL;
}

static void tear_down(void)
{
    sph2d_study_file_destroy(file);
}

static const sph2d_study *parse(const char *text)
{
    sph2d_study_file_destroy(file);
    sph2d_report_clear(&report);
    sph2d_status status = sph2d_study_file_parse(text, strlen(text), "s.yaml", &file, &report);
    ck_assert_msg(status == SPH2D_OK && report.count == 0, "%s\n%s", test_report_text(&report), text);
    return sph2d_study_file_study(file);
}

/** What a row must be; overrides up to the first NULL. */
typedef struct row {
    const char *name;
    struct {
        const char *path, *value, *place;
    } overrides[4];
} row;

static void check_rows(const sph2d_study_run *runs, size_t count, const row *rows, size_t row_count)
{
    ck_assert_uint_eq(count, row_count);
    for (size_t i = 0; i < count; ++i) {
        size_t k = 0;
        ck_assert_str_eq(runs[i].name, rows[i].name);
        for (; rows[i].overrides[k].path; ++k) {
            ck_assert_uint_lt(k, runs[i].override_count);
            ck_assert_str_eq(runs[i].overrides[k].path, rows[i].overrides[k].path);
            ck_assert_str_eq(runs[i].overrides[k].value, rows[i].overrides[k].value);
            ck_assert_str_eq(runs[i].places[k], rows[i].overrides[k].place);
        }
        ck_assert_uint_eq(runs[i].override_count, k);
    }
}
#define CHECK_ROWS(runs, count, rows) check_rows(runs, count, rows, sizeof(rows) / sizeof *(rows))

/* ---- rows -------------------------------------------------------------------------------------------------------- */

START_TEST(a_study_of_nothing_but_a_scene_runs_it_as_it_is)
{
    static const row rows[] = {{"scene", {{0}}}};
    const sph2d_study *study = parse(SCENE);
    CHECK_ROWS(study->runs, study->run_count, rows);
    ck_assert(study->runs[0].skip == 0 && study->refinement_count == 0 && study->measure_count == 0);
    ck_assert(study->repeat == 1 && study->target == 0.01 && study->judge == NULL && study->vary_count == 0);
    study = parse(SCENE "vary: {}\nrefine: []\n");
    CHECK_ROWS(study->runs, study->run_count, rows);
    study = parse(SCENE "runs: [{}]\n");
    CHECK_ROWS(study->runs, study->run_count, rows);
}
END_TEST

START_TEST(of_what_is_varied_the_first_key_turns_slowest)
{
    static const row rows[] = {
        {"spacing=0.2, cfl=0.1", {{"spacing", "0.2", "vary[0][0]"}, {"method.cfl", "0.1", "vary[1][0]"}}},
        {"spacing=0.2, cfl=0.2", {{"spacing", "0.2", "vary[0][0]"}, {"method.cfl", "0.2", "vary[1][1]"}}},
        {"spacing=0.2, cfl=0.30", {{"spacing", "0.2", "vary[0][0]"}, {"method.cfl", "0.30", "vary[1][2]"}}},
        {"spacing=1e-1, cfl=0.1", {{"spacing", "1e-1", "vary[0][1]"}, {"method.cfl", "0.1", "vary[1][0]"}}},
        {"spacing=1e-1, cfl=0.2", {{"spacing", "1e-1", "vary[0][1]"}, {"method.cfl", "0.2", "vary[1][1]"}}},
        {"spacing=1e-1, cfl=0.30", {{"spacing", "1e-1", "vary[0][1]"}, {"method.cfl", "0.30", "vary[1][2]"}}},
    };
    const sph2d_study *study = parse(SCENE "vary: {spacing: [0.2, 1e-1], method.cfl: [0.1, 0.2, 0.30]}\n");
    CHECK_ROWS(study->runs, study->run_count, rows);
    ck_assert_uint_eq(study->vary_count, 2);
    ck_assert_str_eq(study->vary[1].path, "method.cfl");
    ck_assert_str_eq(study->vary[1].value, "[0.1, 0.2, 0.30]");
}
END_TEST

START_TEST(three_keys_count_like_digits)
{
    const sph2d_study *study = parse(SCENE "vary: {a: [0, 1], b: [0, 1, 2], c: [0, 1, 2, 3, 4]}\n");
    ck_assert_uint_eq(study->run_count, 30);
    for (size_t i = 0; i < study->run_count; ++i) {
        const sph2d_override *o = study->runs[i].overrides;
        unsigned long number =
            strtoul(o[0].value, NULL, 10) * 15 + strtoul(o[1].value, NULL, 10) * 5 + strtoul(o[2].value, NULL, 10);
        ck_assert_uint_eq(number, i);
    }
}
END_TEST

START_TEST(each_run_is_made_with_each_combination)
{
    static const row rows[] = {
        {"coarse, cfl=0.1", {{"run.until", "1", "runs[0].set[0]"}, {"method.cfl", "0.1", "vary[0][0]"}}},
        {"coarse, cfl=0.2", {{"run.until", "1", "runs[0].set[0]"}, {"method.cfl", "0.2", "vary[0][1]"}}},
        {"spacing=0.1, velocity=[1, 0], cfl=0.1",
         {{"spacing", "0.1", "runs[1].set[0]"},
          {"blocks[0].velocity", "[1, 0]", "runs[1].set[1]"},
          {"method.cfl", "0.1", "vary[0][0]"}}},
        {"spacing=0.1, velocity=[1, 0], cfl=0.2",
         {{"spacing", "0.1", "runs[1].set[0]"},
          {"blocks[0].velocity", "[1, 0]", "runs[1].set[1]"},
          {"method.cfl", "0.2", "vary[0][1]"}}},
        {"cfl=0.1", {{"method.cfl", "0.1", "vary[0][0]"}}},
        {"cfl=0.2", {{"method.cfl", "0.2", "vary[0][1]"}}},
    };
    const sph2d_study *study = parse(SCENE "vary: {method.cfl: [0.1, 0.2]}\n"
                                           "runs:\n"
                                           "  - {name: coarse, set: {run.until: 1}}\n"
                                           "  - {set: {spacing: 0.1, \"blocks[0].velocity\": [1, 0]}, skip: true}\n"
                                           "  - {}\n");
    CHECK_ROWS(study->runs, study->run_count, rows);
    for (size_t i = 0; i < study->run_count; ++i)
        ck_assert_int_eq(study->runs[i].skip, i == 2 || i == 3);
}
END_TEST

START_TEST(runs_alone_are_called_what_the_file_calls_them_or_what_they_set)
{
    static const row rows[] = {
        {"a, b", {{"spacing", "0.1", "runs[0].set[0]"}}},
        {"spacing=0.2, name=x y", {{"spacing", "0.2", "runs[1].set[0]"}, {"name", "x y", "runs[1].set[1]"}}},
        {"spacing=0.3", {{"spacing", "0.3", "runs[2].set[0]"}}}, /* an empty name is none */
        {"scene", {{0}}},
        {"alone", {{0}}},
        {"odd.=1", {{"odd.", "1", "runs[5].set[0]"}}}, /* nothing behind the point */
    };
    const sph2d_study *study = parse(SCENE "runs:\n"
                                           "  - {name: \"a, b\", set: {spacing: 0.1}}\n"
                                           "  - {set: {spacing: 0.2, name: x y}}\n"
                                           "  - {name: \"\", set: {spacing: 0.3}}\n"
                                           "  - {name: \"\", set: {}}\n"
                                           "  - {name: alone}\n"
                                           "  - {set: {odd.: 1}}\n");
    CHECK_ROWS(study->runs, study->run_count, rows);
}
END_TEST

START_TEST(values_that_are_lists_or_quoted_stay_what_they_are)
{
    static const row rows[] = {
        {"v=[1, 0]", {{"v", "[1, 0]", "vary[0][0]"}}},
        {"v=[[0, 0], [1, 2]]", {{"v", "[[0, 0], [1, 2]]", "vary[0][1]"}}},
        {"v=\"0.1\"", {{"v", "\"0.1\"", "vary[0][2]"}}},
        {"v=\"a: \\\"b\\\"\"", {{"v", "\"a: \\\"b\\\"\"", "vary[0][3]"}}},
        {"v=null", {{"v", "null", "vary[0][4]"}}},
        {"v={\"min\": [0, 0]}", {{"v", "{\"min\": [0, 0]}", "vary[0][5]"}}},
        {"v=two words", {{"v", "two words", "vary[0][6]"}}},
        {"v=\"\\x1B\"", {{"v", "\"\\x1B\"", "vary[0][7]"}}},
    };
    const sph2d_study *study = parse(SCENE "vary:\n"
                                           "  v:\n"
                                           "    - [1, 0]\n"
                                           "    - - [0, 0]\n"
                                           "      - [1, 2]\n"
                                           "    - \"0.1\"\n"
                                           "    - 'a: \"b\"'\n"
                                           "    - ~\n"
                                           "    - {min: [0, 0]}\n"
                                           "    - two words\n"
                                           "    - \"\\e\"\n");
    CHECK_ROWS(study->runs, study->run_count, rows);
    study = parse(SCENE "vary: {\"a\\eb\": [1]}\n");
    ck_assert_str_eq(study->runs[0].name, "a?b=1"); /* nothing for a terminal to obey */
    ck_assert_str_eq(study->runs[0].overrides[0].path, "a\x1b"
                                                       "b");
}
END_TEST

START_TEST(refinements_have_names_and_places_of_their_own)
{
    static const row rows[] = {
        {"spacing=0.01, cfl=0.2", {{"spacing", "0.01", "refine[0].set[0]"}, {"method.cfl", "0.2", "refine[0].set[1]"}}},
        {"last", {{"spacing", "0.005", "refine[1].set[0]"}}},
    };
    const sph2d_study *study = parse(SCENE "vary: {spacing: [0.04, 0.02]}\n"
                                           "refine:\n"
                                           "  - set: {spacing: 0.01, method.cfl: 0.2}\n"
                                           "  - {name: last, set: {spacing: 0.005}}\n");
    CHECK_ROWS(study->refinements, study->refinement_count, rows);
    ck_assert_uint_eq(study->run_count, 2); /* which nothing that is varied goes into, nor they into that */
}
END_TEST

START_TEST(places_of_overrides_are_found_in_the_file)
{
    static const struct {
        const char *path;
        int line, column;
    } places[] = {
        {"runs[0].set[0]", 3, 23},   {"runs[0].set[1]", 3, 38}, {"runs[1].set[0]", 6, 16},
        {"runs[1].set[1]", 7, 16},   {"vary[0][0]", 9, 13},     {"vary[0][1]", 9, 18},
        {"vary[1][0]", 11, 7},       {"vary[1][1]", 12, 7},     {"refine[0].set[0]", 14, 21},
        {"refine[1].set[0]", 17, 7}, {"vary[1]", 10, 3},        {"vary", 8, 1},
        {"target", 18, 9},           {"runs[1]", 4, 5},         {"missing", 0, 0},
    };
    parse(SCENE "runs:\n"
                "  - {set: {run.until: 1, method.cfl: 0.2}}\n"
                "  - name: fine\n"
                "    set:\n"
                "      spacing: 0.01\n"
                "      gravity: [0, -1]\n"
                "vary:\n"
                "  spacing: [0.2, 0.1]\n"
                "  name:\n"
                "    - a\n"
                "    - \"b\"\n"
                "refine:\n"
                "  - {set: {spacing: 0.001}}\n"
                "  - set:\n"
                "\n"
                "      spacing:\n"
                "target: 0.5\n");
    for (size_t i = 0; i < sizeof places / sizeof *places; ++i) {
        sph2d_diagnostic d = {0};
        snprintf(d.path, sizeof d.path, "%s", places[i].path);
        sph2d_study_file_locate(file, &d);
        ck_assert_str_eq(d.file, "s.yaml");
        ck_assert_msg(d.line == places[i].line && d.column == places[i].column, "%s: %d:%d", d.path, d.line, d.column);
    }
    sph2d_diagnostic d = {.path = "vary[1][1]"};
    sph2d_study_file_locate(file, &d);
    ck_assert_str_eq(d.excerpt, "    - \"b\"");
}
END_TEST

START_TEST(each_override_of_a_row_is_found_where_it_was_read)
{
    const sph2d_study *study = parse(SCENE "vary: {name: [n1, n2], spacing: [0.3, 0.4]}\n"
                                           "runs: [{set: {gravity: g1}}, {set: {gravity: g2}}]\n"
                                           "refine: [{set: {name: r1}}]\n");
    ck_assert_uint_eq(study->run_count, 8);
    for (size_t i = 0; i <= study->run_count; ++i) {
        const sph2d_study_run *run = i < study->run_count ? &study->runs[i] : &study->refinements[0];
        for (size_t k = 0; k < run->override_count; ++k) {
            sph2d_diagnostic d = {0};
            snprintf(d.path, sizeof d.path, "%s", run->places[k]);
            sph2d_study_file_locate(file, &d);
            const char *value = run->overrides[k].value;
            ck_assert_msg(d.line > 0 && strncmp(d.excerpt + d.column - 1, value, strlen(value)) == 0, "%s: %s, not %s",
                          d.path, d.excerpt + d.column - 1, value);
        }
    }
}
END_TEST

/* ---- how many ---------------------------------------------------------------------------------------------------- */

/** A study of `keys` keys with `values` values each, and `runs` runs. */
static const char *large_study(size_t keys, size_t values, size_t runs)
{
    enum { SIZE = 400000 };
    static char text[SIZE];
    size_t used = (size_t)snprintf(text, SIZE, SCENE "vary: {");
    for (size_t k = 0; k < keys; ++k) {
        used += (size_t)snprintf(text + used, SIZE - used, "%sk%zu: [", k > 0 ? ", " : "", k);
        for (size_t i = 0; i < values; ++i)
            used += (size_t)snprintf(text + used, SIZE - used, "%s%zu", i > 0 ? ", " : "", i);
        used += (size_t)snprintf(text + used, SIZE - used, "]");
    }
    used += (size_t)snprintf(text + used, SIZE - used, "}\n%s", runs > 0 ? "runs:\n" : "");
    for (size_t i = 0; i < runs; ++i)
        used += (size_t)snprintf(text + used, SIZE - used, "  - {}\n");
    ck_assert_uint_lt(used + 1, SIZE);
    return text;
}

START_TEST(ten_thousand_rows_are_not_too_many)
{
    const sph2d_study *study = parse(large_study(2, 100, 0));
    ck_assert_uint_eq(study->run_count, SPH2D_STUDY_MOST_RUNS);
    ck_assert_str_eq(study->runs[9999].name, "k0=99, k1=99");
    ck_assert_str_eq(study->runs[9999].places[0], "vary[0][99]");
    study = parse(large_study(1, 5000, 2));
    ck_assert_uint_eq(study->run_count, SPH2D_STUDY_MOST_RUNS);
    ck_assert_str_eq(study->runs[5000].name, "k0=0");
    study = parse(large_study(0, 0, SPH2D_STUDY_MOST_RUNS));
    ck_assert_uint_eq(study->run_count, SPH2D_STUDY_MOST_RUNS);
}
END_TEST

START_TEST(more_rows_are_refused_however_many_they_are)
{
    static const struct {
        size_t keys, values, runs;
    } sizes[] = {{1, 10001, 0}, {2, 101, 0}, {1, 3334, 3}, {2, 100, 2}, {16, 16, 0}, /* 2^64 */ {200, 2, 0}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; ++i) {
        const char *text = large_study(sizes[i].keys, sizes[i].values, sizes[i].runs);
        sph2d_report_clear(&report);
        ck_assert_int_eq(sph2d_study_file_parse(text, strlen(text), "s.yaml", &file, &report), SPH2D_SCENE);
        ck_assert_ptr_null(file);
        const sph2d_diagnostic *d = &report.items[0];
        ck_assert_msg(report.count == 1 && d->code == SPH2D_CODE_TOO_MANY, "%s", test_report_text(&report));
        ck_assert_str_eq(d->path, "vary");
        ck_assert_msg(d->line == 2 && d->column == 7, "%d:%d", d->line, d->column);
        ck_assert_ptr_nonnull(strstr(d->message, "more than 10000 rows"));
    }
}
END_TEST

START_TEST(more_measures_than_columns_are_refused)
{
    enum { SIZE = 40000 };
    static char text[SIZE];
    for (int over = 0; over < 2; ++over) {
        size_t used = (size_t)snprintf(text, SIZE, "scene: s.yaml\nmeasures:\n");
        for (int i = 0; i < SPH2D_STUDY_MOST_MEASURES + over; ++i)
            used += (size_t)snprintf(text + used, SIZE - used, "- {name: %d, summary: iterations}\n", i);
        ck_assert_uint_lt(used + 1, SIZE);
        sph2d_report_clear(&report);
        sph2d_study_file_destroy(file);
        sph2d_status status = sph2d_study_file_parse(text, used, "s.yaml", &file, &report);
        ck_assert_msg(status == (over ? SPH2D_SCENE : SPH2D_OK), "%s", test_report_text(&report));
    }
    ck_assert_int_eq(report.items[0].code, SPH2D_CODE_TOO_MANY);
    ck_assert_ptr_nonnull(strstr(report.items[0].message, "more than 1000 measures"));
}
END_TEST

/* ---- what is taken ----------------------------------------------------------------------------------------------- */

START_TEST(the_finest_run_may_be_what_is_expected)
{
    const sph2d_study_measure *m = parse(SERIES "    finest: true\n")->measures;
    ck_assert(m->expectation == SPH2D_EXPECT_FINEST && m->finest == 1 && m->take == SPH2D_TAKE_DEFAULT);
    ck_assert(m->norm == SPH2D_NORM_MAX && m->relative == 0);
    m = parse(SERIES "    finest: true\n    norm: rms\n    relative: true\n    bound: 0.5\n    order: true\n")
            ->measures;
    ck_assert(m->norm == SPH2D_NORM_RMS && m->relative == 1 && m->bound == 0.5 && m->order == 1);
    m = parse(SERIES "    finest: true\n    take: max\n    relative: true\n")->measures;
    ck_assert(m->take == SPH2D_TAKE_MAX && m->relative == 1 && m->finest == 1);
    m = parse(LINE "    finest: true\n    norm: mean\n    scale: 2\n    relative: true\n    order: true\n")->measures;
    ck_assert(m->source == SPH2D_MEASURE_PROFILE && m->expectation == SPH2D_EXPECT_FINEST && m->finest == 1);
    ck_assert(m->norm == SPH2D_NORM_MEAN && m->scale == 2 && m->order == 1);
    ck_assert_ptr_null(m->reference.file);
}
END_TEST

START_TEST(judge_target_and_repeat_arrive)
{
    const sph2d_study *study = parse(MEASURES "judge: judged\ntarget: 1e-9\nrepeat: 100\n");
    ck_assert_str_eq(study->judge, "judged");
    ck_assert(study->target == 1e-9 && study->repeat == 100);
    study = parse(SERIES "    finest: true\njudge: a\nrepeat: 1\ntarget: 5\n");
    ck_assert_str_eq(study->judge, "a");
    ck_assert(study->target == 5 && study->repeat == 1 && !study->percent);
    study = parse(MEASURES "target: 2.5%\n");
    ck_assert(study->target == 0.025 && study->percent);
    study = parse(LINE "    finest: true\njudge: a\n");
    ck_assert_str_eq(study->judge, "a");
}
END_TEST

TCase *study_rows_refusals(void); /* study_rows_refusals.c */

Suite *suite_study_rows(void)
{
    Suite *suite = suite_create("study_rows");
    TCase *rows = tcase_create("rows");
    tcase_add_checked_fixture(rows, set_up, tear_down);
    tcase_add_test(rows, a_study_of_nothing_but_a_scene_runs_it_as_it_is);
    tcase_add_test(rows, of_what_is_varied_the_first_key_turns_slowest);
    tcase_add_test(rows, three_keys_count_like_digits);
    tcase_add_test(rows, each_run_is_made_with_each_combination);
    tcase_add_test(rows, runs_alone_are_called_what_the_file_calls_them_or_what_they_set);
    tcase_add_test(rows, values_that_are_lists_or_quoted_stay_what_they_are);
    tcase_add_test(rows, refinements_have_names_and_places_of_their_own);
    tcase_add_test(rows, places_of_overrides_are_found_in_the_file);
    tcase_add_test(rows, each_override_of_a_row_is_found_where_it_was_read);
    tcase_add_test(rows, ten_thousand_rows_are_not_too_many);
    tcase_add_test(rows, more_measures_than_columns_are_refused);
    tcase_add_test(rows, more_rows_are_refused_however_many_they_are);
    tcase_add_test(rows, the_finest_run_may_be_what_is_expected);
    tcase_add_test(rows, judge_target_and_repeat_arrive);
    suite_add_tcase(suite, rows);
    suite_add_tcase(suite, study_rows_refusals());
    return suite;
}
