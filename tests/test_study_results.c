/* SPDX-License-Identifier: MIT */
/** @file test_study_results.c
 *  A study by the library alone: from files to rows, to numbers, to what is kept and found again. */
#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "common.h"
#include "sph2d/study_results.h"

static const char scene_text[] = "# A block that falls.\n"
                                 "domain: {min: [0, 0], max: [0.5, 0.5]}\n"
                                 "spacing: 0.05\n"
                                 "gravity: [0, -10]\n"
                                 "blocks: [{box: {min: [0.1, 0.1], max: [0.3, 0.3]}}]\n"
                                 "method: {sound_speed: 20}\n"
                                 "probes: [{name: energy, kind: energy, every: 0.01}]\n"
                                 "run: {until: 0.05}\n";

static const char study_text[] =
    "scene: scene.yaml\n"
    "vary: {spacing: [0.05, 0.04]}\n"
    "refine: [{set: {spacing: 0.03}}]\n"
    "measures:\n"
    "  - {name: fall, probe: energy, column: kinetic, take: last, expect: 1, order: true, bound: 1e-9}\n"
    "  - {name: curve, probe: energy, column: kinetic, finest: true, norm: mean, relative: true}\n"
    "  - {name: line, profile: {line: [[0.2, 0], [0.2, 0.5]], value: speed}, finest: true}\n"
    "  - {name: never, probe: energy, column: kinetic, take: crossing, level: -1}\n"
    "  - {name: left, summary: left}\n";

static char folder[] = "/tmp/sph2d-results-XXXXXX";
static sph2d_report report;
static sph2d_study_file *file;
static sph2d_study_results *results;

static void write_file(const char *name, const char *text)
{
    FILE *stream = fopen(name, "w");
    ck_assert_ptr_nonnull(stream);
    ck_assert_int_ge(fputs(text, stream), 0);
    ck_assert_int_eq(fclose(stream), 0);
}

static void set_up(void)
{
    ck_assert_ptr_nonnull(mkdtemp(folder));
    ck_assert_int_eq(chdir(folder), 0);
    write_file("scene.yaml", scene_text);
    sph2d_report_clear(&report);
}

static void tear_down(void)
{
    sph2d_study_results_destroy(results);
    sph2d_study_file_destroy(file);
    ck_assert_int_eq(chdir("/"), 0);
    char command[64];
    snprintf(command, sizeof command, "rm -rf %s", folder);
    ck_assert_int_eq(system(command), 0);
}

static sph2d_status create(const char *text, const sph2d_override *overrides, size_t count)
{
    sph2d_study_results_destroy(results);
    sph2d_study_file_destroy(file);
    results = NULL;
    ck_assert_msg(sph2d_study_file_parse(text, strlen(text), "study.yaml", &file, &report) == SPH2D_OK, "%s",
                  test_report_text(&report));
    return sph2d_study_results_create(file, overrides, count, false, &results, &report);
}

static void run_all(size_t first)
{
    for (size_t r = first; r < results->row_count; ++r)
        ck_assert_msg(sph2d_study_row_run(results, &results->rows[r], NULL, &report) == SPH2D_OK, "%s",
                      test_report_text(&report));
    ck_assert_int_eq(sph2d_study_results_measure(results), SPH2D_OK);
}

/* ---- running and measuring --------------------------------------------------------------------------------------- */

START_TEST(rows_become_numbers)
{
    ck_assert_int_eq(create(study_text, NULL, 0), SPH2D_OK);
    ck_assert_uint_eq(results->row_count, 2);
    ck_assert(results->rows[0].wanted && !results->rows[0].there && results->judge == 0);
    run_all(0);
    const sph2d_study_row *coarse = &results->rows[0], *fine = &results->rows[1];
    const sph2d_study_record *record = &coarse->record;
    ck_assert(coarse->there && record->end == SPH2D_STUDY_FINISHED && record->status == SPH2D_OK);
    ck_assert(record->spacing == 0.05 && record->time >= 0.05 * (1 - 1e-9) && record->repeats == 1);
    ck_assert(record->wall > 0 && record->particles == 16 && coarse->rate > 0);
    ck_assert(record->cpu >= 0); /* where it is counted in ticks, a run of a millisecond takes none */
    ck_assert_uint_eq(record->series_count, 2);
    ck_assert_str_eq(record->series[0].probe, "energy");
    ck_assert_uint_eq(record->series[0].count, 6);
    ck_assert_uint_eq(record->series[1].count, 101);
    ck_assert(record->series[1].rows[2 * 100] == 1 && record->series[1].quantity == SPH2D_QUANTITY_SPEED);
    /* free fall of 40 kg: m (g t)^2 / 2 */
    ck_assert_double_eq_tol(coarse->values[0].value, 40 * 0.25 / 2, 0.4);
    ck_assert(coarse->values[0].error == fabs(coarse->values[0].value - 1));
    ck_assert(isnan(coarse->values[0].order) && isfinite(fine->values[0].order));
    ck_assert(isnan(coarse->values[1].value) && coarse->values[1].error > 0 && isnan(fine->values[1].error));
    ck_assert(coarse->values[2].error > 0 && isnan(coarse->values[3].value) && coarse->values[4].value == 0);
    ck_assert(coarse->on_front || fine->on_front);
    ck_assert_ptr_nonnull(sph2d_study_cheapest(results, 100));
    ck_assert_ptr_null(sph2d_study_cheapest(results, 0.01));
}
END_TEST

START_TEST(what_is_wrong_with_numbers_is_reported)
{
    ck_assert_int_eq(create(study_text, NULL, 0), SPH2D_OK);
    run_all(0);
    sph2d_report_clear(&report);
    sph2d_study_row_judge(results, &results->rows[0], &report);
    const char *all = test_report_text(&report);
    ck_assert_msg(report.errors == 1 && report.count == 2, "%s", all);
    ck_assert_msg(strstr(all, "row 'spacing=0.05': 'fall' is ") && strstr(all, "exceeds the bound 1e-09"), "%s", all);
    ck_assert_msg(strstr(all, "no value of 'never': the series does not come to its level"), "%s", all);
}
END_TEST

START_TEST(the_finest_row_is_awaited)
{
    ck_assert_int_eq(create("scene: scene.yaml\nvary: {spacing: [0.05, 0.04, 0.03]}\nmeasures:\n"
                            "  - {name: curve, probe: energy, column: kinetic, finest: true, bound: 1e-9}\n",
                            NULL, 0),
                     SPH2D_OK);
    for (size_t r = 0; r < 3; ++r) {
        ck_assert_int_eq(sph2d_study_row_run(results, &results->rows[r], NULL, &report), SPH2D_OK);
        ck_assert_int_eq(sph2d_study_results_measure(results), SPH2D_OK);
        sph2d_report_clear(&report);
        sph2d_study_row_judge(results, &results->rows[0], &report);
        ck_assert_msg(report.errors == (r < 2 ? 0 : 1), "%s", test_report_text(&report));
    }
}
END_TEST

START_TEST(refinements_run_like_other_rows)
{
    ck_assert_int_eq(create(study_text, NULL, 0), SPH2D_OK);
    run_all(0);
    ck_assert_int_eq(sph2d_study_results_refine(results, 0), SPH2D_OK);
    ck_assert_uint_eq(results->row_count, 3);
    ck_assert_str_eq(results->rows[2].run.name, "spacing=0.03");
    run_all(2);
    ck_assert(results->rows[2].record.spacing == 0.03 && isnan(results->rows[2].values[1].error));
    ck_assert(isfinite(results->rows[1].values[1].error));
}
END_TEST

START_TEST(overrides_on_top_hold_for_every_row)
{
    const sph2d_override top[] = {{"run.until", "0.02"}};
    ck_assert_int_eq(create(study_text, top, 1), SPH2D_OK);
    run_all(0);
    ck_assert(results->rows[1].record.time < 0.03);
    char *text;
    ck_assert_int_eq(sph2d_study_run_scene_text(results, &results->rows[1].run, &text, &report), SPH2D_OK);
    ck_assert(strstr(text, "0.02") && strstr(text, "0.04"));
    free(text);
}
END_TEST

static bool stop_at_step_3(void *user, const sph2d_study_run *run, const sph2d_sim *sim)
{
    ck_assert_str_eq(run->name, "spacing=0.05");
    ++*(int *)user;
    return sph2d_sim_steps(sim) < 3;
}

START_TEST(the_caller_may_stop_a_row)
{
    int asked = 0;
    sph2d_study_run_options options = {
        .threads = 1, .isa = SPH2D_ISA_BASELINE, .beside_others = true, .go_on = stop_at_step_3, .user = &asked};
    ck_assert_int_eq(create(study_text, NULL, 0), SPH2D_OK);
    ck_assert_int_eq(sph2d_study_row_run(results, &results->rows[0], &options, &report), SPH2D_OK);
    const sph2d_study_record *record = &results->rows[0].record;
    ck_assert(record->end == SPH2D_STUDY_STOPPED && record->steps == 3 && asked == 4 && isnan(record->wall));
    ck_assert_str_eq(record->isa, "baseline");
    ck_assert_int_eq(sph2d_study_results_measure(results), SPH2D_OK);
    ck_assert(isnan(results->rows[0].values[0].value)); /* it did not come to its end */
}
END_TEST

START_TEST(a_guard_stops_its_row_with_a_reason)
{
    ck_assert_int_eq(
        create("scene: scene.yaml\nruns: [{name: bad, set: {method.time_step: 0.2, run.until: 5}}]\n", NULL, 0),
        SPH2D_OK);
    ck_assert_int_eq(sph2d_study_row_run(results, &results->rows[0], NULL, &report), SPH2D_GUARD);
    const sph2d_study_record *record = &results->rows[0].record;
    ck_assert(record->end == SPH2D_STUDY_GUARD && record->status == SPH2D_GUARD && record->reason[0] != '\0');
    ck_assert(report.errors == 1 && strncmp(report.items[report.count - 1].message, "row 'bad': ", 11) == 0);
    sph2d_study_record_free(&results->rows[0].record);
    ck_assert_int_eq(sph2d_study_row_run(results, &results->rows[0], NULL, NULL), SPH2D_GUARD);
    ck_assert(
        strstr(report.items[report.count - 1].message, results->rows[0].record.reason)); /* without a report too */
}
END_TEST

START_TEST(repeats_keep_the_least_time)
{
    sph2d_study_run_options options = {.threads = 1, .repeat = 3};
    ck_assert_int_eq(create(study_text, NULL, 0), SPH2D_OK);
    size_t told = report.count;
    ck_assert_int_eq(sph2d_study_row_run(results, &results->rows[0], &options, &report), SPH2D_OK);
    ck_assert(results->rows[0].record.repeats == 3 && report.count <= told + 2); /* warnings once */
}
END_TEST

/* ---- faults ------------------------------------------------------------------------------------------------------ */

START_TEST(measures_that_do_not_fit_have_their_place)
{
#define MEASURE "scene: scene.yaml\nmeasures:\n"
    static const struct {
        const char *text, *path, *message, *hint;
        int line, column;
    } faults[] = {
        {MEASURE "  - {name: a, probe: enrgy, column: kinetic}\n", "measures[0].probe", "no probe 'enrgy'",
         "did you mean 'energy'?", 3, 22},
        {MEASURE "  - {name: a, probe: energy, column: mass}\n", "measures[0].column", "no column 'mass'",
         "its columns: kinetic", 3, 38},
        {MEASURE "  - {name: a, probe: energy, column: kinetic, take: value, at: 3}\n", "measures[0].at",
         "3 s is after the end of the run", "", 3, 64},
        {MEASURE "  - {name: a, profile: {line: [[0, 0], [0, 3]], value: vx}, finest: true}\n",
         "measures[0].profile.line", "(0, 3) lies outside the domain", "", 3, 31},
        {"scene: scene.yaml\nruns: [{set: {spacign: 1}}]\n", "spacign", "'spacign'", "did you mean 'spacing'?", 2, 24},
    };
    for (size_t i = 0; i < sizeof faults / sizeof *faults; ++i) {
        sph2d_report_clear(&report);
        ck_assert_int_eq(create(faults[i].text, NULL, 0), SPH2D_SCENE);
        ck_assert_ptr_null(results);
        const sph2d_diagnostic *d = &report.items[0];
        const char *all = test_report_text(&report);
        ck_assert_msg(report.errors == 1 && strcmp(d->path, faults[i].path) == 0, "%s", all);
        ck_assert_msg(strstr(d->message, faults[i].message) && strstr(d->hint, faults[i].hint), "%s", all);
        ck_assert_msg(d->line == faults[i].line && d->column == faults[i].column, "%d:%d %s", d->line, d->column, all);
        ck_assert_str_eq(d->file, "study.yaml");
    }
}
END_TEST

START_TEST(what_is_missing_is_no_study)
{
    ck_assert_int_eq(create("scene: nothing.yaml\n", NULL, 0), SPH2D_NOINPUT);
    ck_assert_int_eq(
        create(MEASURE "  - {name: a, probe: energy, column: kinetic, reference: {file: no, x: t, y: u}}\n", NULL, 0),
        SPH2D_NOINPUT);
    ck_assert_int_eq(create("scene: nothing.yaml\nruns: [{}]\n", NULL, 0), SPH2D_NOINPUT);
    ck_assert_int_eq(sph2d_study_results_create(NULL, NULL, 0, false, &results, NULL), SPH2D_INVALID);
    ck_assert_int_eq(sph2d_study_results_create(file, NULL, 0, false, NULL, NULL), SPH2D_INVALID);
    sph2d_study_results_destroy(NULL);
}
END_TEST

/* ---- keeping ----------------------------------------------------------------------------------------------------- */

START_TEST(a_row_that_was_kept_is_found_by_all_that_it_depends_on)
{
    ck_assert_int_eq(create(study_text, NULL, 0), SPH2D_OK);
    sph2d_study_row *row = &results->rows[0];
    ck_assert_int_eq(sph2d_study_row_key(results, row, "this program", &report), SPH2D_OK);
    ck_assert(!sph2d_study_row_find(results, row, ".") && !row->there);
    run_all(0);
    double value = row->values[0].value, cpu = row->record.cpu;
    ck_assert_int_eq(sph2d_study_row_keep(row, ".", &report), SPH2D_OK);

    ck_assert_int_eq(create(study_text, NULL, 0), SPH2D_OK);
    row = &results->rows[0];
    ck_assert_int_eq(sph2d_study_row_key(results, row, "another program", &report), SPH2D_OK);
    ck_assert(!sph2d_study_row_find(results, row, "."));
    ck_assert_int_eq(sph2d_study_row_key(results, row, "this program", &report), SPH2D_OK);
    ck_assert(sph2d_study_row_find(results, row, ".") && row->there);
    ck_assert_int_eq(sph2d_study_results_measure(results), SPH2D_OK);
    ck_assert(row->values[0].value == value && row->record.cpu == cpu);

    const sph2d_override top[] = {{"gravity", "[0, -9]"}};
    ck_assert_int_eq(create(study_text, top, 1), SPH2D_OK);
    ck_assert_int_eq(sph2d_study_row_key(results, &results->rows[0], "this program", &report), SPH2D_OK);
    ck_assert(!sph2d_study_row_find(results, &results->rows[0], "."));
}
END_TEST

START_TEST(a_row_without_what_is_measured_now_is_not_found)
{
    static const char other[] =
        "scene: scene.yaml\nvary: {spacing: [0.05, 0.04]}\nmeasures:\n"
        "  - {name: line, profile: {line: [[0.1, 0], [0.2, 0.5]], value: speed}, finest: true}\n";
    ck_assert_int_eq(create(study_text, NULL, 0), SPH2D_OK);
    ck_assert_int_eq(sph2d_study_row_key(results, &results->rows[0], "p", &report), SPH2D_OK);
    run_all(0);
    ck_assert_int_eq(sph2d_study_row_keep(&results->rows[0], ".", &report), SPH2D_OK);
    ck_assert_int_eq(create(other, NULL, 0), SPH2D_OK);
    ck_assert_int_eq(sph2d_study_row_key(results, &results->rows[0], "p", &report), SPH2D_OK);
    ck_assert(!sph2d_study_row_find(results, &results->rows[0], ".") && !results->rows[0].there);
    ck_assert_ptr_null(results->rows[0].record.series);
}
END_TEST

/* ---- a study for a scene ----------------------------------------------------------------------------------------- */

START_TEST(a_study_for_a_scene_is_one_in_any_locale)
{
    setlocale(LC_ALL, "de_DE.UTF-8"); /* stays C where it is not installed */
    const sph2d_override top[] = {{"run.until", "0.02"}};
    char *text;
    sph2d_status status = sph2d_study_text_for_scene("scene.yaml", top, 1, &text, &report);
    ck_assert_int_eq(status, SPH2D_OK);
    ck_assert_msg(strstr(text, "spacing: [0.1, 0.07071, 0.05]") && strstr(text, "\"run.until\": 0.02") &&
                      strstr(text, "method.sound_speed: [10, 20]"),
                  "%s", text);
    ck_assert_int_eq(create(text, NULL, 0), SPH2D_OK);
    ck_assert_uint_eq(results->row_count, 6);
    ck_assert(sph2d_study_rows_belong(results, &results->rows[0], &results->rows[2]));
    ck_assert(!sph2d_study_rows_belong(results, &results->rows[0], &results->rows[1]));
    free(text);
    ck_assert_int_eq(sph2d_study_text_for_scene("nothing.yaml", NULL, 0, &text, &report), SPH2D_NOINPUT);
    ck_assert_ptr_null(text);
    setlocale(LC_ALL, "C");
}
END_TEST

Suite *suite_study_results(void)
{
    Suite *suite = suite_create("study_results");
    TCase *cases = tcase_create("results");
    tcase_add_checked_fixture(cases, set_up, tear_down);
    tcase_add_test(cases, rows_become_numbers);
    tcase_add_test(cases, what_is_wrong_with_numbers_is_reported);
    tcase_add_test(cases, the_finest_row_is_awaited);
    tcase_add_test(cases, refinements_run_like_other_rows);
    tcase_add_test(cases, overrides_on_top_hold_for_every_row);
    tcase_add_test(cases, the_caller_may_stop_a_row);
    tcase_add_test(cases, a_guard_stops_its_row_with_a_reason);
    tcase_add_test(cases, repeats_keep_the_least_time);
    tcase_add_test(cases, measures_that_do_not_fit_have_their_place);
    tcase_add_test(cases, what_is_missing_is_no_study);
    tcase_add_test(cases, a_row_that_was_kept_is_found_by_all_that_it_depends_on);
    tcase_add_test(cases, a_row_without_what_is_measured_now_is_not_found);
    tcase_add_test(cases, a_study_for_a_scene_is_one_in_any_locale);
    suite_add_tcase(suite, cases);
    return suite;
}
