/* SPDX-License-Identifier: MIT */
/** @file test_overrides.c
 *  Keys that are changed beside a scene file: what they change, and that their faults name them. */
#include <string.h>

#include "common.h"
#include "sph2d/io.h"

#define SOUND                                                                                                          \
    "domain: {min: [0, 0], max: [1, 1]}\nspacing: 0.1\nblocks:\n  - box: {min: [0, 0], max: [0.4, 0.8]}\n"             \
    "fluid: {dynamic_viscosity: 100}\n"

static sph2d_status parse(const char *text, const sph2d_override *overrides, size_t count, sph2d_scene_file **file,
                          sph2d_report *report)
{
    return sph2d_scene_file_parse(text, strlen(text), "s.yaml", overrides, count, file, report);
}

START_TEST(overrides_change_single_keys)
{
    static const sph2d_override overrides[] = {{"run.until", "0.5"},     {"blocks[0].velocity", "[1, 0]"},
                                               {"method", "{cfl: 0.2}"}, {"method.support_ratio", "3"},
                                               {"run.until", "0.25"},    {"name", "'x y'"}};
    sph2d_report report = {0};
    sph2d_scene_file *file = NULL;
    sph2d_status status = parse(SOUND, overrides, 6, &file, &report);
    ck_assert_msg(status == SPH2D_OK, "%s", test_report_text(&report));
    const sph2d_scene *s = sph2d_scene_file_scene(file);
    ck_assert(s->run.until == 0.25 && s->blocks[0].velocity.x == 1);
    ck_assert(s->method.cfl == 0.2 && s->method.support_ratio == 3);
    ck_assert_str_eq(s->name, "x y");
    ck_assert_str_eq(sph2d_scene_file_text(file), SOUND);
    size_t count = 0;
    const sph2d_override *kept = sph2d_scene_file_overrides(file, &count);
    ck_assert_uint_eq(count, 6);
    ck_assert_str_eq(kept[5].path, "name");
    ck_assert_str_eq(kept[5].value, "'x y'");
    sph2d_scene_file_destroy(file);
}
END_TEST

static const struct {
    sph2d_override override;
    sph2d_code code;
    const char *file, *message;
} bad_overrides[] = {
    {{"run.untl", "1"}, SPH2D_CODE_UNKNOWN_KEY, "--set run.untl=1", "unknown key 'untl'"},
    {{"run.until", "soon"}, SPH2D_CODE_WRONG_TYPE, "--set run.until=soon", "expected a number, got 'soon'"},
    {{"run.until", ""}, SPH2D_CODE_WRONG_TYPE, "--set run.until=", "expected a number, got nothing"},
    {{"spacing", "-1"}, SPH2D_CODE_OUT_OF_RANGE, "--set spacing=-1", "-1 is out of range"},
    {{"blocks[1].velocity", "[0, 0]"}, SPH2D_CODE_UNKNOWN_KEY, "--set blocks[1].velocity=[0, 0]", "the list has 1"},
    {{"sources[0].at", "[0, 0]"}, SPH2D_CODE_UNKNOWN_KEY, "--set sources[0].at=[0, 0]", "no list"},
    {{"spacing.x", "1"}, SPH2D_CODE_UNKNOWN_KEY, "--set spacing.x=1", "no mapping for the key 'x'"},
    {{"run..until", "1"}, SPH2D_CODE_SYNTAX, "--set run..until=1", "not a key path"},
    {{"", "1"}, SPH2D_CODE_SYNTAX, "--set =1", "not a key path"},
    {{"motion.path", "[[0, 0], [1, 1]]"}, /* both are wrong, said once */
     SPH2D_CODE_WRONG_TYPE,
     "--set motion.path=[[0, 0], [1, 1]]",
     "got a list of 2"},
    {{"blocks[", "1"}, SPH2D_CODE_SYNTAX, "--set blocks[=1", "not a key path"},
    {{"blocks[99999999999999999999]", "1"},
     SPH2D_CODE_SYNTAX,
     "--set blocks[99999999999999999999]=1",
     "not a key path"},
    {{"gravity", "[0"}, SPH2D_CODE_SYNTAX, "--set gravity=[0", "not closed"},
    {{"gravity", "&a [0, 1]"}, SPH2D_CODE_SYNTAX, "--set gravity=&a [0, 1]", "anchors"},
    {{"blocks[0].disc", "{center: [0, 0], radius: 1}"},
     SPH2D_CODE_CONFLICT,
     "--set blocks[0].disc={center: [0, 0], radius: 1}",
     "'disc' excludes 'box' on line 4"},
};

START_TEST(faults_of_overrides_name_the_override)
{
    sph2d_report report = {0};
    sph2d_scene_file *file = NULL;
    ck_assert_int_eq(parse(SOUND, &bad_overrides[_i].override, 1, &file, &report), SPH2D_SCENE);
    const sph2d_diagnostic *d = &report.items[0];
    ck_assert_msg(report.count == 1 && d->code == bad_overrides[_i].code, "%s", test_report_text(&report));
    ck_assert_str_eq(d->file, bad_overrides[_i].file);
    ck_assert_int_eq(d->line, 0);
    ck_assert_msg(strstr(d->message, bad_overrides[_i].message) != NULL, "%s", test_report_text(&report));
}
END_TEST

Suite *suite_overrides(void)
{
    Suite *suite = suite_create("overrides");
    TCase *tests = tcase_create("overrides");
    tcase_add_test(tests, overrides_change_single_keys);
    tcase_add_loop_test(tests, faults_of_overrides_name_the_override, 0,
                        sizeof bad_overrides / sizeof bad_overrides[0]);
    suite_add_tcase(suite, tests);
    return suite;
}
