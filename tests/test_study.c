/* SPDX-License-Identifier: MIT */
/** @file test_study.c
 *  Studies: what a study file says, and what it is compared with. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "common.h"
#include "study/curve.h"

static sph2d_report report;

static void set_up(void)
{
    sph2d_report_clear(&report);
}

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
    {RUNS "  - {skip: yes}\n", SPH2D_CODE_WRONG_TYPE, "runs[1].skip", 4, 12, "unknown value 'yes'", "false, true"},
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
    {MEASURE "    level: 3\n", SPH2D_CODE_CONFLICT, "measures[0].level", 8, 12, "none of period, crossing and decay",
     ""},
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
static sph2d_study_curve points;

static void set_up_folder(void)
{
    ck_assert_ptr_nonnull(mkdtemp(folder));
    ck_assert_int_eq(chdir(folder), 0);
    sph2d_report_clear(&report);
}

static void tear_down_folder(void)
{
    sph2d__reference_free(&points);
    ck_assert_int_eq(chdir("/"), 0);
    char command[64];
    snprintf(command, sizeof command, "rm -rf %s", folder);
    ck_assert_int_eq(system(command), 0);
}

static sph2d_status make_points(const char *name, bool along, sph2d_report *to)
{
    sph2d_study_measure measure = {.source = along ? SPH2D_MEASURE_PROFILE : SPH2D_MEASURE_PROBE,
                                   .expectation = SPH2D_EXPECT_REFERENCE,
                                   .reference = {name, "t", "a", 0}};
    return sph2d__reference_make(&points, &measure, to);
}

static sph2d_status read_points(const char *text, size_t length, bool along)
{
    FILE *stream = fopen("r.csv", "w");
    ck_assert_ptr_nonnull(stream);
    ck_assert_uint_eq(fwrite(text, 1, length, stream), length);
    ck_assert_int_eq(fclose(stream), 0);
    sph2d__reference_free(&points);
    return make_points("r.csv", along, &report);
}

START_TEST(references_are_tables_with_comments_units_and_gaps)
{
    static const char text[] = "\xef\xbb\xbf# who measured it, and when\r\n\r\n  \nx,a [m] , t [s]\r\n"
                               "7,1.5,2\r\n,nan,3\n1, ,4\n1,5,\n# a gap\nword,\t-2e-1 , .5\n1,3,0";
    sph2d_status status = read_points(text, sizeof text - 1, false);
    ck_assert_msg(status == SPH2D_OK, "%s", test_report_text(&report));
    sph2d_study_curve c = points;
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

/* The time to find a column must not grow faster than the line: this took half a minute. */
START_TEST(lines_of_many_cells_are_read)
{
    enum { CELLS = 60000 };
    static const char head[4] = "t,a\n", row[4] = "1,2\n";
    static char text[2 * CELLS + 20];
    memset(text, ',', sizeof text - 1);
    memcpy(text + CELLS, head, sizeof head);
    memcpy(text + 2 * CELLS + 4, row, sizeof row);
    clock_t start = clock();
    ck_assert_int_eq(read_points(text, 2 * CELLS + 8, false), SPH2D_OK);
    ck_assert(points.count == 1 && points.x[0] == 1 && points.y[0] == 2);
    ck_assert_int_lt(clock() - start, CLOCKS_PER_SEC);
}
END_TEST

START_TEST(what_is_no_table_is_refused)
{
    static char garbage[100000] = {0};
    ck_assert_int_eq(read_points(garbage, sizeof garbage, false), SPH2D_FORMAT);
    ck_assert_msg(strstr(report.items[0].message, "not text") != NULL, "%s", test_report_text(&report));
    memset(garbage, ',', sizeof garbage);
    ck_assert_int_eq(read_points(garbage, sizeof garbage, false), SPH2D_FORMAT);
    ck_assert_uint_eq(report.errors, 2);
    ck_assert_int_eq(mkfifo("pipe.csv", 0644), 0); /* and nobody writes it */
    test_limit(20);
    ck_assert_int_eq(make_points("pipe.csv", false, &report), SPH2D_FORMAT);
    ck_assert_msg(strstr(report.items[2].message, "it is empty") != NULL, "%s", test_report_text(&report));
    test_limit(0);
    ck_assert_int_eq(make_points("missing.csv", false, &report), SPH2D_NOINPUT);
    ck_assert_int_eq(make_points(".", false, &report), SPH2D_NOINPUT);
    ck_assert_int_eq(make_points(".", false, NULL), SPH2D_NOINPUT);
}
END_TEST

Suite *suite_study(void)
{
    Suite *suite = suite_create("study");
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
    tcase_add_test(references, lines_of_many_cells_are_read);
    tcase_add_test(references, what_is_no_table_is_refused);
    suite_add_tcase(suite, references);
    return suite;
}
