/* SPDX-License-Identifier: MIT */
/** @file study_rows_refusals.c
 *  What a study must not say about its rows, and about what is judged, repeated and expected of them: each fault is
 *  told once, with its code and its place. */
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

static const struct fault {
    const char *text;
    sph2d_code code;
    const char *path;
    int line, column;
    const char *message, *hint; /**< parts of them */
} faults[] = {
    /* vary */
    {SCENE "vary: {spacing: 0.1}\n", SPH2D_CODE_WRONG_TYPE, "vary[0]", 2, 17, "a list of one value or more", ""},
    {SCENE "vary: {spacing: []}\n", SPH2D_CODE_WRONG_TYPE, "vary[0]", 2, 17, "a list of one value or more", ""},
    {SCENE "vary: {spacing: {a: 1}}\n", SPH2D_CODE_WRONG_TYPE, "vary[0]", 2, 17, "a list of one value or more", ""},
    {SCENE "vary:\n  spacing:\n", SPH2D_CODE_WRONG_TYPE, "vary[0]", 3, 3, "a list of one value or more", ""},
    {SCENE "vary:\n  a: [1]\n  b: 3\n", SPH2D_CODE_WRONG_TYPE, "vary[1]", 4, 6, "a list of one value or more", ""},
    {SCENE "vary: [spacing]\n", SPH2D_CODE_WRONG_TYPE, "vary", 2, 7, "expected a mapping, got a list", ""},
    {SCENE "vary:\n", SPH2D_CODE_WRONG_TYPE, "vary", 2, 1, "expected a mapping, got nothing", ""},
    {SCENE "vary: {a: [1], a: [2]}\n", SPH2D_CODE_DUPLICATE_KEY, "vary", 2, 16, "'a' is given twice", "line 2"},
    /* refine */
    {SCENE "refine: {}\n", SPH2D_CODE_WRONG_TYPE, "refine", 2, 9, "expected a list, got a mapping", ""},
    {SCENE "refine: [3]\n", SPH2D_CODE_WRONG_TYPE, "refine[0]", 2, 10, "expected a mapping, got '3'", ""},
    {SCENE "refine: [{set: {}}]\n", SPH2D_CODE_MISSING_KEY, "refine[0]", 2, 10, "a refinement must set a key",
     "set: {spacing: 0.01}"},
    {SCENE "refine: [{sett: {}}]\n", SPH2D_CODE_UNKNOWN_KEY, "refine[0].sett", 2, 11, "'sett'", "did you mean 'set'?"},
    {SCENE "refine: [{set: [1]}]\n", SPH2D_CODE_WRONG_TYPE, "refine[0].set", 2, 16, "a mapping, got a list", ""},
    /* runs */
    {SCENE "runs: []\n", SPH2D_CODE_MISSING_KEY, "runs", 2, 7, "there is no run", "set: {}"},
    {SCENE "runs: []\nvary: {a: [1]}\n", SPH2D_CODE_MISSING_KEY, "runs", 2, 7, "there is no run", "set: {}"},
    /* judge, target, repeat */
    {MEASURES "judge: judgd\n", SPH2D_CODE_WRONG_TYPE, "judge", 5, 8, "no measure is called 'judgd'", ""},
    {SCENE "judge: a\n", SPH2D_CODE_WRONG_TYPE, "judge", 2, 8, "no measure is called 'a'", ""},
    {MEASURES "judge: \"\"\n", SPH2D_CODE_WRONG_TYPE, "judge", 5, 8, "no measure is called ''", ""},
    {MEASURES "judge: seen\n", SPH2D_CODE_CONFLICT, "judge", 5, 8, "that measure has no error", ""},
    {MEASURES "judge: [judged]\n", SPH2D_CODE_WRONG_TYPE, "judge", 5, 8, "expected a text, got a list", ""},
    {SCENE "target: 0\n", SPH2D_CODE_OUT_OF_RANGE, "target", 2, 9, "a number above 0", "1%"},
    {SCENE "target: -0.1\n", SPH2D_CODE_OUT_OF_RANGE, "target", 2, 9, "a number above 0", ""},
    {SCENE "target: .nan\n", SPH2D_CODE_OUT_OF_RANGE, "target", 2, 9, "a number above 0", ""},
    {SCENE "target: 1 per cent\n", SPH2D_CODE_OUT_OF_RANGE, "target", 2, 9, "a number above 0", ""},
    {SERIES "    expect: 1\n    relative: true\ntarget: 5\n", SPH2D_CODE_OUT_OF_RANGE, "target", 8, 9, "500 %",
     "5% or 0.05"},
    {SCENE "along: spacign\n", SPH2D_CODE_WRONG_TYPE, "along", 2, 8, "no row sets that key", "'vary' or 'set'"},
    {SCENE "repeat: 0\n", SPH2D_CODE_OUT_OF_RANGE, "repeat", 2, 9,
     "0 is out of range: must be at least 1 and at most 100", "least"},
    {SCENE "repeat: 101\n", SPH2D_CODE_OUT_OF_RANGE, "repeat", 2, 9,
     "101 is out of range: must be at least 1 and at most 100", ""},
    {SCENE "repeat: -1\n", SPH2D_CODE_OUT_OF_RANGE, "repeat", 2, 9, "at least 1 and at most 100", ""},
    {SCENE "repeat: 1.5\n", SPH2D_CODE_WRONG_TYPE, "repeat", 2, 9, "expected a whole number, got '1.5'", ""},
    {SCENE "repeat: \"2\"\n", SPH2D_CODE_WRONG_TYPE, "repeat", 2, 9, "expected a whole number", ""},
    /* finest */
    {SERIES "    finest: false\n", SPH2D_CODE_CONFLICT, "measures[0].finest", 6, 13, "true or is left out", ""},
    {SERIES "    finest: maybe\n", SPH2D_CODE_WRONG_TYPE, "measures[0].finest", 6, 13, "unknown value 'maybe'",
     "false, true"},
    {SERIES "    finest: true\n    expect: 1\n", SPH2D_CODE_CONFLICT, "measures[0].expect", 7, 5,
     "'expect' excludes 'finest' on line 6", "one of expect, reference, finest"},
    {SERIES "    expect: 1\n    finest: true\n", SPH2D_CODE_CONFLICT, "measures[0].finest", 7, 5,
     "'finest' excludes 'expect' on line 6", ""},
    {SERIES "    finest: true\n    reference: {file: r, x: x, y: y}\n", SPH2D_CODE_CONFLICT, "measures[0].reference", 7,
     5, "'reference' excludes 'finest' on line 6", ""},
    {LINE "    reference: {file: r, x: x, y: y}\n    finest: true\n", SPH2D_CODE_CONFLICT, "measures[0].finest", 6, 5,
     "'finest' excludes 'reference' on line 5", ""},
    {SERIES "    finest: true\n    take: max\n    norm: rms\n", SPH2D_CODE_CONFLICT, "measures[0].norm", 8, 11,
     "where 'take' makes one number of the series", ""},
    {LINE "    finest: true\n    take: max\n", SPH2D_CODE_CONFLICT, "measures[0].take", 6, 11, "with a profile", ""},
    {LINE, SPH2D_CODE_MISSING_KEY, "measures[0]", 3, 5, "'reference' must be given with a profile, or 'finest'", ""},
    {SERIES "    norm: rms\n", SPH2D_CODE_CONFLICT, "measures[0].norm", 6, 11, "without 'reference' or 'finest'", ""},
    {SERIES "    bound: 1\n", SPH2D_CODE_CONFLICT, "measures[0].bound", 6, 12,
     "without 'expect', 'reference' or 'finest'", ""},
};

START_TEST(each_fault_has_its_place)
{
    sph2d_report report = {0};
    sph2d_study_file *file = NULL;
    const struct fault *f = &faults[_i];
    ck_assert_int_eq(sph2d_study_file_parse(f->text, strlen(f->text), "s.yaml", &file, &report), SPH2D_SCENE);
    ck_assert_ptr_null(file);
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

TCase *study_rows_refusals(void);

TCase *study_rows_refusals(void)
{
    TCase *refusals = tcase_create("refusals");
    tcase_add_loop_test(refusals, each_fault_has_its_place, 0, sizeof faults / sizeof faults[0]);
    return refusals;
}
