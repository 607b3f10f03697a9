/* SPDX-License-Identifier: MIT */
/** @file test_methods.c
 *  The table of methods agrees with the keys, with the checker and with the forces that there are. */
#include <stdio.h>
#include <string.h>

#include "common.h"
#include "methods/common/method.h"
#include "scene/method_table.h"
#include "sph2d/key.h"

static sph2d_method_options options_of(const sph2d_method_info *row)
{
    return (sph2d_method_options){.name = row->method, .operators = row->operators};
}

START_TEST(every_method_has_its_row_and_its_forces)
{
    const sph2d_keys *keys = sph2d_scene_keys();
    const sph2d_key *words = NULL;
    for (size_t k = 0; k < keys->count; ++k)
        if (strcmp(keys->items[k].name, "method") == 0)
            words = &keys->items[k].keys->items[0];
    ck_assert_ptr_nonnull(words);
    ck_assert_str_eq(words->name, "name");
    for (int m = 0; words->words[m]; ++m) {
        const sph2d_method_info *row = sph2d_method_of(&(sph2d_method_options){.name = (sph2d_method)m});
        ck_assert_int_eq(row->method, m);
        ck_assert_str_eq(row->word, words->words[m]);
    }
    const sph2d_method_info *row, *other;
    for (size_t k = 0; (row = sph2d_method_row(k)); ++k) {
        sph2d_method_options options = options_of(row);
        ck_assert_ptr_eq(sph2d_method_of(&options), row);
        ck_assert_ptr_nonnull(sph2d__method_find(&options));
        for (size_t n = 0; n < k && (other = sph2d_method_row(n)); ++n) {
            sph2d_method_options others = options_of(other);
            ck_assert_ptr_ne(sph2d__method_find(&options), sph2d__method_find(&others));
            ck_assert_str_ne(row->name, other->name);
        }
    }
}
END_TEST

START_TEST(a_row_says_what_a_scene_needs)
{
    const sph2d_method_info *row;
    for (size_t k = 0; (row = sph2d_method_row(k)); ++k) {
        sph2d_method_options options = options_of(row);
        const sph2d__method_row *all = sph2d__method_row_of(&options);
        ck_assert(row->support_ratio >= 1.2 && row->support_ratio <= 6);
        ck_assert(all->cfl > 0 && row->max_compression > 0 && all->sound_compression > 0);
        ck_assert(row->wall_forms >> all->side_form & 1);
        ck_assert(row->wall_forms >> all->obstacle_form & 1);
        ck_assert(all->max_density > 1 && all->min_density < 1 && all->energy_rise > 0);
        ck_assert(*row->use && *row->scheme && *row->source && *all->damping_hint);
        ck_assert_int_eq(all->convergence_hint != NULL, sph2d_method_has(row, SPH2D_FEATURE_MAX_ITERATIONS));
    }
}
END_TEST

/** Finds a key of `method` and checks that what it asks for is named so. */
static void find_key(const sph2d_key *key, bool *found)
{
    char path[64];
    snprintf(path, sizeof path, "method.%s", key->name);
    if (key->feature == SPH2D_FEATURE_NONE)
        return;
    ck_assert_str_eq(sph2d_feature_key((sph2d_feature)key->feature), path);
    found[key->feature] = true;
}

START_TEST(every_feature_has_a_key_and_a_method)
{
    bool found[32] = {false};
    found[SPH2D_FEATURE_SURFACE_TENSION] = found[SPH2D_FEATURE_WALL_SLIP] = true; /* of other groups */
    found[SPH2D_FEATURE_SMOOTH_WALLS] = found[SPH2D_FEATURE_FREE_SURFACE] = true; /* of no key alone */
    found[SPH2D_FEATURE_OPENINGS] = found[SPH2D_FEATURE_BODIES] = true;           /* of lists */
    found[SPH2D_FEATURE_WALL_FORCES] = true;                                      /* of kinds of probes */
    found[SPH2D_FEATURE_RHEOLOGY] = true;                                         /* of fluid */
    const sph2d_keys *keys = sph2d_scene_keys();
    for (size_t k = 0; k < keys->count; ++k)
        if (strcmp(keys->items[k].name, "method") == 0)
            for (size_t n = 0; n < keys->items[k].keys->count; ++n)
                find_key(&keys->items[k].keys->items[n], found);
    int last = SPH2D_FEATURE_NONE;
#define CHECK(name, key)                                                                                               \
    ck_assert_msg(found[SPH2D_FEATURE_##name], "no key asks for " #name);                                              \
    ck_assert_str_eq(sph2d_feature_key(SPH2D_FEATURE_##name), key);                                                    \
    last = SPH2D_FEATURE_##name;
    SPH2D_FEATURE_MAP(CHECK)
    for (int f = 1; f <= last; ++f) {
        const sph2d_method_info *row;
        size_t have = 0, rows = 0;
        for (; (row = sph2d_method_row(rows)); ++rows)
            have += sph2d_method_has(row, (sph2d_feature)f);
        ck_assert_msg(have > 0 && have < rows, "%s is of %zu rows", sph2d_feature_key((sph2d_feature)f), have);
    }
    ck_assert(sph2d_method_has(sph2d_method_row(0), SPH2D_FEATURE_NONE));
    ck_assert_ptr_null(sph2d_feature_key(SPH2D_FEATURE_NONE));
}
END_TEST

/** A scene by each method, with its own defaults, is fine; with a key of others it is refused with a hint that
 *  helps. */
START_TEST(keys_of_other_methods_are_refused)
{
    const sph2d_method_info *row = sph2d_method_row((size_t)_i);
    sph2d_scene scene = sph2d_scene_default();
    scene.domain = (sph2d_box){{0, 0}, {1, 1}};
    scene.spacing = 0.05;
    scene.method.name = row->method;
    scene.method.operators = row->operators;
    scene.boundary.top = SPH2D_SIDE_WALL;
    scene.wall_slip = sph2d_method_has(row, SPH2D_FEATURE_FREE_SURFACE) ? SPH2D_SLIP_FREE : SPH2D_SLIP_NONE;
    sph2d_block block = sph2d_block_default();
    block.shape.kind = SPH2D_SHAPE_BOX;
    block.shape.box = scene.domain;
    scene.blocks = &block;
    scene.block_count = 1;
    ck_assert_int_eq(sph2d_scene_check(&scene, NULL), SPH2D_OK);
    scene.method.tolerance = 1e-3;
    scene.method.shifting = 0.5;
    sph2d_report report = {0};
    ck_assert_int_eq(sph2d_scene_check(&scene, &report), SPH2D_SCENE);
    size_t wanted = 0, count = report.count;
    static const sph2d_feature features[] = {SPH2D_FEATURE_TOLERANCE, SPH2D_FEATURE_SHIFTING};
    for (size_t k = 0; k < sizeof features / sizeof *features; ++k)
        wanted += sph2d_method_has(row, features[k]) ? 0 : 1;
    ck_assert_uint_eq(count, wanted);
    for (size_t k = 0; k < count; ++k) {
        const sph2d_diagnostic *d = &report.items[k];
        ck_assert_int_eq(d->code, SPH2D_CODE_UNSUPPORTED);
        ck_assert_ptr_nonnull(strstr(d->message, row->name));
        const char *other = row->method == SPH2D_METHOD_WCSPH ? "operators: fitted" : "wcsph";
        ck_assert_ptr_nonnull(strstr(d->hint, strcmp(d->path, "method.tolerance") == 0 ? "constraint" : other));
    }
}
END_TEST

Suite *suite_methods(void)
{
    Suite *suite = suite_create("methods");
    TCase *tests = tcase_create("methods");
    tcase_add_test(tests, every_method_has_its_row_and_its_forces);
    tcase_add_test(tests, a_row_says_what_a_scene_needs);
    tcase_add_test(tests, every_feature_has_a_key_and_a_method);
    int rows = 0;
    while (sph2d_method_row((size_t)rows))
        ++rows;
    tcase_add_loop_test(tests, keys_of_other_methods_are_refused, 0, rows);
    suite_add_tcase(suite, tests);
    return suite;
}
