/* SPDX-License-Identifier: MIT */
/** @file test_null.c
 *  What public functions answer to NULL, by the rule of sph2d/status.h: every function that takes a pointer, with NULL
 *  for each that must not be; test_null_render.c has those that draw. `make test` checks that none is missing. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "snapshot_fixture.h"
#include "sph2d/contacts.h"
#include "sph2d/flow.h"
#include "sph2d/study_results.h"

static sph2d_report report;

/** A status with a message that names what is NULL. */
static void check_refused(const char *call, const char *what, sph2d_status status)
{
    ck_assert_msg(status == SPH2D_INVALID, "%s returns %s", call, sph2d_status_name(status));
    ck_assert_msg(!what || report.errors == 1, "%s: %zu errors", call, report.errors);
    ck_assert_msg(!what || strstr(report.items[0].message, what), "%s: %s", call, report.items[0].message);
    sph2d_report_clear(&report);
}

/** Whether all bytes are zero. */
static void check_zeros(const char *call, const void *bytes, size_t size)
{
    for (size_t i = 0; i < size; ++i)
        ck_assert_msg(((const unsigned char *)bytes)[i] == 0, "%s: byte %zu is not 0", call, i);
}

/* A call that is refused, with a word of its message; the same without a report; one that returns zero, false or NULL,
 * one that returns NaN, one that returns a struct of zeros, and one that returns nothing. */
#define REFUSED(what, call) check_refused(#call, what, call)
#define REFUSED_SILENTLY(call) check_refused(#call, NULL, call)
#define NOTHING(call) ck_assert_msg(!(call), "%s", #call)
#define UNKNOWN(call) ck_assert_msg(isnan(call), "%s", #call)
#define ZEROS(type, call)                                                                                              \
    do {                                                                                                               \
        type answer = call;                                                                                            \
        check_zeros(#call, &answer, sizeof answer);                                                                    \
    } while (0)

/** What is made is set to NULL: this points elsewhere before. */
#define ELSEWHERE(type) (type *)(void *)&report

static bool never(void *user, sph2d_sim *sim)
{
    (void)user;
    (void)sim;
    return false;
}

START_TEST(simulations)
{
    sph2d_sim *sim = fixture.sim, *made = ELSEWHERE(sph2d_sim);
    const sph2d_scene *scene = sph2d_sim_scene(sim);
    sph2d_state state = sph2d_sim_state(sim), hollow = {state.version, NULL, 3};
    sph2d_plan plan;
    sph2d_sample sample = {{0, 0}, 0, 0, 9};
    sph2d_vec2 at = {0.1, 0.1};
    REFUSED("scene", sph2d_sim_create(NULL, NULL, &made, &report));
    ck_assert_ptr_null(made);
    REFUSED("sim", sph2d_sim_create(scene, NULL, NULL, &report));
    made = ELSEWHERE(sph2d_sim);
    REFUSED("state", sph2d_sim_restore(scene, NULL, NULL, &made, &report));
    ck_assert_ptr_null(made);
    REFUSED("state->arrays", sph2d_sim_restore(scene, NULL, &hollow, &made, &report));
    REFUSED("scene", sph2d_sim_restore(NULL, NULL, &state, &made, &report));
    REFUSED("sim", sph2d_sim_restore(scene, NULL, &state, NULL, &report));
    REFUSED("scene", sph2d_scene_plan(NULL, &plan, &report));
    REFUSED("plan", sph2d_scene_plan(scene, NULL, &report));
    REFUSED("scene", sph2d_scene_check(NULL, &report));
    REFUSED("scene", sph2d_scene_fits(NULL, &report));
    NOTHING(sph2d_scene_particles(NULL) != 0);
    UNKNOWN(sph2d_shape_centroid(NULL).x);
    NOTHING(sph2d_shape_corners(NULL, 1, NULL));
    REFUSED("sim", sph2d_sim_step(NULL, &report));
    REFUSED("sim", sph2d_sim_device_status(NULL, &report));
    ck_assert_str_eq(sph2d_device_refuses(NULL), "there is no scene");
    ck_assert_uint_eq(sph2d_devices(NULL, 0), sph2d_devices(NULL, 9)); /* also with room for them */
    REFUSED("sim", sph2d_sim_run(NULL, never, NULL, &report));
    REFUSED("go_on", sph2d_sim_run(sim, NULL, NULL, &report));
    REFUSED_SILENTLY(sph2d_sim_set_gravity(NULL, at));
    REFUSED_SILENTLY(sph2d_sim_set_pointer(NULL, at, 1, 1));
    REFUSED_SILENTLY(sph2d_sim_add_particles(NULL, NULL, 0, NULL));
    REFUSED_SILENTLY(sph2d_sim_remove_particles(NULL, NULL, NULL));
    REFUSED_SILENTLY(sph2d_sim_set_body_velocity(NULL, 0, at, 1));
    REFUSED_SILENTLY(sph2d_sim_set_contacts(NULL, NULL, NULL));
    UNKNOWN(sph2d_sim_body(NULL, 0).center.x);
    UNKNOWN(sph2d_sim_obstacle(NULL, 0).center.x);
    REFUSED_SILENTLY(sph2d_contacts_attach(NULL));
    sph2d_sim_destroy(NULL);
    sph2d_shared_hold(NULL);
    sph2d_shared_release(NULL);
    sph2d_sim_output_done(NULL, 0);
    NOTHING(sph2d_sim_time(NULL) != 0 || sph2d_sim_time_step(NULL) != 0);
    NOTHING(sph2d_sim_steps(NULL) + (uint64_t)sph2d_sim_threads(NULL) + sph2d_sim_memory(NULL) +
            sph2d_sim_device_memory(NULL));
    ck_assert_uint_eq(sph2d_sim_device_use(NULL).launches, 0);
    NOTHING(sph2d_sim_isa(NULL));
    NOTHING(sph2d_sim_scene(NULL));
    NOTHING(sph2d_sim_plan(NULL));
    NOTHING(sph2d_sim_output_due(NULL, 0));
    NOTHING(sph2d_sim_output_count(NULL, 0));
    double values[SPH2D_PROBE_MAX_COLUMNS];
    NOTHING(sph2d_sim_probe(NULL, 0, values));
    NOTHING(sph2d_sim_probe(sim, 0, NULL));
    NOTHING(sph2d_sim_sample(NULL, at, &sample));
    ck_assert(isnan(sample.pressure) && sample.neighbours == 0);
    NOTHING(sph2d_sim_sample(sim, at, NULL));
    UNKNOWN(sph2d_sim_densities(NULL).reported);
    ck_assert_int_eq(sph2d_sim_densities(NULL).status, SPH2D_INVALID);
    const double one[1] = {0};
    double curl[1];
    REFUSED("'x'", sph2d_vorticity(1, NULL, one, one, one, 1, curl, &report));
    REFUSED("'y'", sph2d_vorticity(1, one, NULL, one, one, 1, curl, &report));
    REFUSED("'vx'", sph2d_vorticity(1, one, one, NULL, one, 1, curl, &report));
    REFUSED("'vy'", sph2d_vorticity(1, one, one, one, NULL, 1, curl, &report));
    REFUSED("'out'", sph2d_vorticity(1, one, one, one, one, 1, NULL, &report));
    REFUSED_SILENTLY(sph2d_vorticity(1, one, one, one, one, 1, NULL, NULL));
    ck_assert_uint_eq(sph2d_sim_count(NULL), 0);
    ZEROS(sph2d_view, sph2d_sim_fluid(NULL));
    ZEROS(sph2d_view, sph2d_sim_walls(NULL));
    ZEROS(sph2d_state, sph2d_sim_state(NULL));
    ZEROS(sph2d_summary, sph2d_sim_summary(NULL));
    ZEROS(sph2d_profile, sph2d_sim_profile(NULL));
    NOTHING(sph2d_field(NULL, SPH2D_GROUP_FLUID, 0).count);
}
END_TEST

START_TEST(tables_and_reports)
{
    char text[8] = "before";
    const sph2d_key *key = &sph2d_scene_keys()->items[0];
    sph2d_diagnostic d = {.message = "m"};
    double one = 1;
    sph2d_flow flow = sph2d_flow_default();
    sph2d_flow_context context = {.density = 1};
    flow.kind = SPH2D_FLOW_STILL;
    ck_assert_ptr_nonnull(sph2d_materials(NULL));
    uint32_t rgb = 7;
    const sph2d_fluid red = {.color = "red"};
    ck_assert(!sph2d_color_parse(NULL, &rgb) && !sph2d_color_parse("red", NULL));
    ck_assert(!sph2d_fluid_color(NULL, &rgb) && !sph2d_fluid_color(&red, NULL));
    ck_assert_uint_eq(rgb, 7);
    ck_assert_ptr_null(sph2d_sim_colors(NULL));
    ck_assert_uint_eq(sph2d_sim_paths(NULL).count, 0);
    ck_assert_ptr_eq(sph2d_method_of(NULL), sph2d_method_row(0));
    NOTHING(sph2d_method_has(NULL, SPH2D_FEATURE_NONE));
    NOTHING(sph2d_key_accepts(NULL, 1, text, sizeof text));
    for (size_t k = 0; k < sph2d_scene_keys()->count; ++k)
        if (sph2d_scene_keys()->items[k].kind == SPH2D_KEY_NUMBER)
            NOTHING(sph2d_key_accepts(&sph2d_scene_keys()->items[k], -INFINITY, NULL, 7));
    REFUSED("keys", sph2d_keys_check(NULL, key, &report));
    REFUSED("owner", sph2d_keys_check(sph2d_scene_keys(), NULL, &report));
    REFUSED("flow", sph2d_flow_values(NULL, &context, 0, 1, &one, &one, NULL, NULL, NULL, &report));
    REFUSED("context", sph2d_flow_values(&flow, NULL, 0, 1, &one, &one, NULL, NULL, NULL, &report));
    REFUSED("points", sph2d_flow_values(&flow, &context, 0, 1, NULL, &one, NULL, NULL, NULL, &report));
    REFUSED("flow", sph2d_flow_axes(NULL, &context, 0, NULL, NULL, NULL, &report));
    sph2d_report_clear(NULL);
    NOTHING(sph2d_report_add(NULL, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL, "text"));
    const char *no_format = NULL;
    NOTHING(sph2d_report_add(&report, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL, no_format, 0));
    sph2d_diagnostic_hint(NULL, "text");
    sph2d_diagnostic_hint(&d, no_format, 0);
    NOTHING(sph2d_diagnostic_format(NULL, text, sizeof text));
    ck_assert_str_eq(text, "");
    ck_assert_uint_eq(sph2d_diagnostic_format(&d, NULL, 7), strlen("error[G000]: m"));
}
END_TEST

START_TEST(files)
{
    const sph2d_override hollow[2] = {{"spacing", NULL}, {NULL, "1"}};
    const sph2d_table_column columns[1] = {{.name = NULL}}, column[1] = {{.name = "x"}};
    sph2d_scene_file *file = ELSEWHERE(sph2d_scene_file);
    sph2d_snapshot *snapshot = ELSEWHERE(sph2d_snapshot);
    sph2d_series *series = ELSEWHERE(sph2d_series);
    sph2d_table *table = ELSEWHERE(sph2d_table);
    size_t count = 7;
    REFUSED("path", sph2d_scene_file_read(NULL, NULL, 0, &file, &report));
    ck_assert_ptr_null(file);
    REFUSED("file", sph2d_scene_file_read("x", NULL, 0, NULL, &report));
    REFUSED("name", sph2d_scene_file_read_open(0, NULL, NULL, 0, &file, &report));
    ck_assert_ptr_null(file);
    REFUSED("file", sph2d_scene_file_read_open(0, "x", NULL, 0, NULL, &report));
    REFUSED("text", sph2d_scene_file_parse(NULL, 1, "x", NULL, 0, &file, &report));
    REFUSED("name", sph2d_scene_file_parse("", 0, NULL, NULL, 0, &file, &report));
    REFUSED("overrides", sph2d_scene_file_parse("", 0, "x", NULL, 1, &file, &report));
    REFUSED("overrides", sph2d_scene_file_parse("", 0, "x", hollow, 1, &file, &report));
    REFUSED("overrides", sph2d_scene_file_parse("", 0, "x", hollow + 1, 1, &file, &report));
    REFUSED("file", sph2d_scene_file_parse("", 0, "x", NULL, 0, NULL, &report));
    sph2d_scene_file_destroy(NULL);
    sph2d_scene_file_locate(NULL, &report.items[0]);
    sph2d_scene_file_locate(fixture.file, NULL);
    NOTHING(sph2d_scene_file_scene(NULL));
    NOTHING(sph2d_scene_file_text(NULL));
    NOTHING(sph2d_scene_file_overrides(NULL, &count) || count);
    sph2d_scene_file_overrides(fixture.file, NULL);
    NOTHING(sph2d_scene_text(NULL, NULL, 0));
    ck_assert_uint_gt(sph2d_scene_text(sph2d_sim_scene(fixture.sim), NULL, 7), 0);

    write_snapshot("x.h5", 0);
    REFUSED("sim", sph2d_snapshot_write(NULL, NULL, 0, "y.h5", &report));
    REFUSED("path", sph2d_snapshot_write(fixture.sim, NULL, 0, NULL, &report));
    REFUSED("deflate level", sph2d_snapshot_write(fixture.sim, NULL, 10, "y.h5", &report));
    sph2d_snapshot_draft *draft = (sph2d_snapshot_draft *)(void *)&report; /* not NULL */
    REFUSED("sim", sph2d_snapshot_begin(NULL, NULL, 0, "y.h5", &draft, &report));
    ck_assert_ptr_null(draft);
    REFUSED("path", sph2d_snapshot_begin(fixture.sim, NULL, 0, NULL, &draft, &report));
    REFUSED("draft", sph2d_snapshot_begin(fixture.sim, NULL, 0, "y.h5", NULL, &report));
    REFUSED("draft", sph2d_snapshot_commit(NULL, &report));
    sph2d_snapshot_abort(NULL);
    REFUSED("path", sph2d_snapshot_read(NULL, &snapshot, &report));
    ck_assert_ptr_null(snapshot);
    REFUSED("snapshot", sph2d_snapshot_read("x.h5", NULL, &report));
    REFUSED("path", sph2d_snapshot_read_unchecked(NULL, &snapshot, &report));
    ck_assert_ptr_null(snapshot);
    REFUSED("snapshot", sph2d_snapshot_read_unchecked("x.h5", NULL, &report));
    snapshot = read_snapshot("x.h5");
    file = ELSEWHERE(sph2d_scene_file);
    REFUSED("snapshot", sph2d_snapshot_scene(NULL, NULL, 0, &file, &report));
    ck_assert_ptr_null(file);
    REFUSED("file", sph2d_snapshot_scene(snapshot, NULL, 0, NULL, &report));
    REFUSED("more", sph2d_snapshot_scene(snapshot, NULL, 1, &file, &report));
    REFUSED("more", sph2d_snapshot_scene(snapshot, hollow, 1, &file, &report));
    NOTHING(sph2d_snapshot_array(NULL, SPH2D_GROUP_FLUID, "Coordinates"));
    NOTHING(sph2d_snapshot_array(snapshot, SPH2D_GROUP_FLUID, NULL));
    ZEROS(sph2d_snapshot_info, sph2d_snapshot_get_info(NULL));
    ZEROS(sph2d_state, sph2d_snapshot_state(NULL));
    sph2d_snapshot_destroy(snapshot);
    sph2d_snapshot_destroy(NULL);

    REFUSED("path", sph2d_series_open(NULL, "x", 0, &series, &report));
    ck_assert_ptr_null(series);
    REFUSED("columns", sph2d_series_open("x.csv", NULL, 0, &series, &report));
    REFUSED("series", sph2d_series_open("x.csv", "x", 0, NULL, &report));
    REFUSED("series", sph2d_series_append(NULL, 0, NULL, 0, &report));
    ck_assert_int_eq(sph2d_series_open("x.csv", "x", 0, &series, &report), SPH2D_OK);
    REFUSED("values", sph2d_series_append(series, 0, NULL, 1, &report));
    ck_assert_int_eq(sph2d_series_close(series, &report), SPH2D_OK);
    ck_assert_int_eq(sph2d_series_close(NULL, &report), SPH2D_OK);
    REFUSED("path", sph2d_table_read(NULL, column, 1, &table, &report));
    ck_assert_ptr_null(table);
    REFUSED("columns", sph2d_table_read("x.csv", NULL, 1, &table, &report));
    REFUSED("columns", sph2d_table_read("x.csv", columns, 1, &table, &report));
    REFUSED("table", sph2d_table_read("x.csv", column, 1, NULL, &report));
    NOTHING(sph2d_table_rows(NULL));
    NOTHING(sph2d_table_has(NULL, 0));
    UNKNOWN(sph2d_table_value(NULL, 0, 0));
    sph2d_table_locate(NULL, 0, &report.items[0]);
    sph2d_table_destroy(NULL);
    REFUSED("path", sph2d_text_write(NULL, "x", 1, &report));
    REFUSED("text", sph2d_text_write("x.txt", NULL, 1, &report));
    ck_assert_int_ne(access("y.h5", F_OK), 0);
    ck_assert_int_ne(access("x.txt", F_OK), 0);
    unlink("x.h5");
    unlink("x.csv");
}
END_TEST

static const char study_text[] = "scene: scene.yaml\n"
                                 "measures: [{name: late, summary: steps_left, expect: 1}]\n";

START_TEST(studies)
{
    sph2d_study_file *file = ELSEWHERE(sph2d_study_file);
    sph2d_study_results *results = ELSEWHERE(sph2d_study_results);
    sph2d_scene_file *scene = ELSEWHERE(sph2d_scene_file);
    sph2d_study_run run = {.name = "x"};
    sph2d_study study = {.along = "spacing"};
    sph2d_study_results empty = {.study = &study};
    sph2d_study_row row = {.run = {.name = "x"}};
    sph2d_study_record record = {0};
    char text[8] = "before", *made = text;
    REFUSED("path", sph2d_study_file_read(NULL, &file, &report));
    ck_assert_ptr_null(file);
    REFUSED("file", sph2d_study_file_read("x", NULL, &report));
    REFUSED("text", sph2d_study_file_parse(NULL, 1, "x", &file, &report));
    REFUSED("name", sph2d_study_file_parse(study_text, strlen(study_text), NULL, &file, &report));
    REFUSED("file", sph2d_study_file_parse(study_text, strlen(study_text), "x", NULL, &report));
    sph2d_study_file_destroy(NULL);
    sph2d_study_file_locate(NULL, &report.items[0]);
    NOTHING(sph2d_study_file_study(NULL));
    NOTHING(sph2d_study_run_name(NULL, NULL, text, sizeof text) || text[0]);
    ck_assert_uint_eq(sph2d_study_run_name(&run, NULL, NULL, 7), strlen("scene"));
    REFUSED("file", sph2d_study_results_create(NULL, NULL, 0, false, &results, &report));
    ck_assert_ptr_null(results);
    REFUSED("results", sph2d_study_results_create(file, NULL, 0, false, NULL, &report));
    sph2d_study_results_destroy(NULL);
    REFUSED("path", sph2d_study_text_for_scene(NULL, NULL, 0, &made, &report));
    ck_assert_ptr_null(made);
    REFUSED("text", sph2d_study_text_for_scene("x", NULL, 0, NULL, &report));
    REFUSED("results", sph2d_study_run_scene(NULL, &run, &scene, &report));
    ck_assert_ptr_null(scene);
    REFUSED("run", sph2d_study_run_scene(&empty, NULL, &scene, &report));
    REFUSED("file", sph2d_study_run_scene(&empty, &run, NULL, &report));
    REFUSED("results", sph2d_study_run_scene_text(NULL, &run, &made, &report));
    REFUSED("run", sph2d_study_run_scene_text(&empty, NULL, &made, &report));
    REFUSED("text", sph2d_study_run_scene_text(&empty, &run, NULL, &report));
    REFUSED("results", sph2d_study_row_run(NULL, &row, NULL, &report));
    REFUSED("row", sph2d_study_row_run(&empty, NULL, NULL, &report));
    REFUSED("results", sph2d_study_row_key(NULL, &row, "p", &report));
    REFUSED("row", sph2d_study_row_key(&empty, NULL, "p", &report));
    REFUSED("program", sph2d_study_row_key(&empty, &row, NULL, &report));
    REFUSED("row", sph2d_study_row_keep(NULL, ".", &report));
    REFUSED("folder", sph2d_study_row_keep(&row, NULL, &report));
    REFUSED("key", sph2d_study_row_keep(&row, ".", &report));
    NOTHING(sph2d_study_row_find(NULL, &row, ".") || sph2d_study_row_find(&empty, NULL, "."));
    NOTHING(sph2d_study_row_find(&empty, &row, NULL));
    REFUSED_SILENTLY(sph2d_study_results_measure(NULL));
    REFUSED_SILENTLY(sph2d_study_results_refine(NULL, 0));
    REFUSED_SILENTLY(sph2d_study_record_unpack(NULL, text, 1));
    REFUSED_SILENTLY(sph2d_study_record_unpack(&record, NULL, 1));
    NOTHING(sph2d_study_record_pack(NULL, text, sizeof text));
    ck_assert_uint_gt(sph2d_study_record_pack(&record, NULL, SIZE_MAX), sizeof record);
    sph2d_study_record_free(NULL);
    NOTHING(sph2d_study_has_value(NULL) || sph2d_study_has_error(NULL));
    sph2d_study_row_judge(NULL, &row, &report);
    sph2d_study_row_judge(&empty, NULL, &report);
    UNKNOWN(sph2d_study_row_error(NULL, &row));
    UNKNOWN(sph2d_study_row_error(&empty, NULL));
    UNKNOWN(sph2d_study_row_order(NULL, &row));
    UNKNOWN(sph2d_study_row_order(&empty, NULL));
    UNKNOWN(sph2d_study_row_along(NULL, &row));
    UNKNOWN(sph2d_study_row_along(&empty, NULL));
    NOTHING(sph2d_study_cheapest(NULL, 1) || sph2d_study_best(NULL));
    NOTHING(sph2d_study_rows_belong(NULL, &row, &row) || sph2d_study_rows_belong(&empty, NULL, &row));
    NOTHING(sph2d_study_rows_belong(&empty, &row, NULL));
}
END_TEST

static void clear_report(void)
{
    sph2d_report_clear(&report);
}

Suite *suite_null(void)
{
    Suite *suite = suite_create("null");
    TCase *tests = tcase_create("null");
    tcase_add_checked_fixture(tests, snapshot_set_up, snapshot_tear_down);
    tcase_add_checked_fixture(tests, clear_report, NULL);
    tcase_add_test(tests, simulations);
    tcase_add_test(tests, tables_and_reports);
    tcase_add_test(tests, files);
    tcase_add_test(tests, studies);
    suite_add_tcase(suite, tests);
    return suite;
}
