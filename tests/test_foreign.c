/* SPDX-License-Identifier: MIT */
/** @file test_foreign.c
 *  Names that other programs give to keys: each leads to a key that there is, and is none itself. */
#include <stdio.h>
#include <string.h>

#include "common.h"
#include "files/foreign.h"
#include "sph2d/io.h"

/** Calls `check` for each name of the table. */
static void for_each_name(void (*check)(const char *name, const char *path))
{
    const sph2d__foreign *row;
    size_t count = 0;
    for (size_t i = 0; (row = sph2d__foreign_row(i)); ++i)
        for (const char *name = row->names; *name; name += *name == ',', ++count) {
            char word[40] = "";
            const size_t length = strspn(name, "abcdefghijklmnopqrstuvwxyz0123456789");
            ck_assert(length > 0 && length < sizeof word);
            memcpy(word, name, length);
            name += length;
            ck_assert_msg(*name == '\0' || *name == ',', "%s: the names of %s are no lower-case words", word,
                          row->path);
            check(word, row->path);
        }
    ck_assert_uint_gt(count, 100);
}

static void is_for_a_key(const char *name, const char *path)
{
    const sph2d_key *key = sph2d__foreign_key(path), *found = NULL;
    ck_assert_msg(key, "%s: there is no key %s", name, path);
    ck_assert_msg(sph2d__foreign_path(name, NULL, &found) && found, "%s leads nowhere", name);
}

START_TEST(each_name_leads_to_a_key)
{
    for_each_name(is_for_a_key);
    ck_assert_ptr_null(sph2d__foreign_key("run.untl"));
    ck_assert_ptr_null(sph2d__foreign_key("spacing.until"));
    ck_assert_ptr_null(sph2d__foreign_key("run..until"));
    ck_assert_ptr_null(sph2d__foreign_key(""));
}
END_TEST

/** Also, a file with the name at its top is told of that key. */
static void is_told(const char *name, const char *path)
{
    char text[80], start[80];
    const sph2d_key *key = NULL;
    const char *first = sph2d__foreign_path(name, sph2d_scene_keys(), &key);
    sph2d_report report = {0};
    sph2d_scene_file *file = NULL;
    (void)path;
    if (sph2d__foreign_key(name)) /* another level's name for another key: `start` */
        return;
    snprintf(text, sizeof text, "%s: 1\n", name);
    snprintf(start, sizeof start, "did you mean '%s'", first);
    ck_assert_int_eq(sph2d_scene_file_parse(text, strlen(text), "s", NULL, 0, &file, &report), SPH2D_SCENE);
    bool told = false;
    for (size_t i = 0; i < report.count; ++i)
        told |=
            report.items[i].code == SPH2D_CODE_UNKNOWN_KEY && strncmp(report.items[i].hint, start, strlen(start)) == 0;
    ck_assert_msg(told, "%s: not %s, but %s", name, start, test_report_text(&report));
    sph2d_report_clear(&report);
}

START_TEST(each_name_is_told)
{
    for_each_name(is_told);
}
END_TEST

static const struct {
    const char *text, *hint;
} told[] = {
    {"viscosity: 1", "did you mean 'fluid.dynamic_viscosity', in Pa s?"},
    {"fluid: {viscosity: 1}", "did you mean 'dynamic_viscosity', in Pa s?"},
    {"fluid: {rho: 1}", "did you mean 'density', in kg/m^3?"},
    {"blocks: [{rho: 1}]", "did you mean 'fluid.density', in kg/m^3?"},
    {"time: 1", "did you mean 'run.until', in s?"},
    {"run: {time: 1}", "did you mean 'until', in s?"},
    {"t_end: 1", "did you mean 'run.until', in s?"},
    {"tEnd: 1", "did you mean 'run.until', in s?"},
    {"END-TIME: 1", "did you mean 'run.until', in s?"},
    {"_: 1", "keys here: "},
    {"dt: 1", "did you mean 'method.time_step', in s?"},
    {"probes: [{dt: 1}]", "did you mean 'every', in s?"},
    {"resolution: 1", "did you mean 'spacing', in m?"},
    {"run: {frames: {resolution: 1}}", "did you mean 'size', in pixels?"},
    {"width: 1", "did you mean 'domain.max', in m?"},
    {"domain: {width: 1}", "did you mean 'max', in m?"},
    {"fps: 1", "did you mean 'run.frames.per_second', in 1/s?"},
    {"blocks: [{size: 1}]", "did you mean 'box'?"},
    {"blocks: [{box: {end: 1}}]", "did you mean 'max', in m?"},
    {"sources: [{step: 1}]", "did you mean 'stop'?"}, /* what is near comes before what is far */
    {"step: 1", "did you mean 'method.time_step', in s?"},
    {"end: 1", "did you mean 'run.until', in s?"},
    /* one of the scene, in a group: its indentation is wrong */
    {"fluid: {blocks: 1}", "'blocks' is no part of a group"},
};

START_TEST(names_depend_on_where_they_are)
{
    sph2d_report report = {0};
    sph2d_scene_file *file = NULL;
    ck_assert_int_eq(sph2d_scene_file_parse(told[_i].text, strlen(told[_i].text), "s", NULL, 0, &file, &report),
                     SPH2D_SCENE);
    bool found = false;
    for (size_t i = 0; i < report.count; ++i)
        found |= report.items[i].code == SPH2D_CODE_UNKNOWN_KEY && strstr(report.items[i].hint, told[_i].hint);
    ck_assert_msg(found, "%s: not %s, but %s", told[_i].text, told[_i].hint, test_report_text(&report));
    sph2d_report_clear(&report);
}
END_TEST

Suite *suite_foreign(void)
{
    Suite *suite = suite_create("foreign");
    TCase *tests = tcase_create("names");
    tcase_add_test(tests, each_name_leads_to_a_key);
    tcase_add_test(tests, each_name_is_told);
    tcase_add_loop_test(tests, names_depend_on_where_they_are, 0, sizeof told / sizeof *told);
    suite_add_tcase(suite, tests);
    return suite;
}
