/* SPDX-License-Identifier: MIT */
/** @file test_extremes.c
 *  Every number of a scene at 0, below 0, tiny and huge, through the reader and its overrides, by every method: the scene
 *  is refused with a sentence, or made and stepped with values that are finite, or stopped by a guard that says why; and
 *  never takes more than a few seconds. SPH2D_TEST_FULL tries every value by every method. */
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/time.h>
#include <unistd.h>

#include "common.h"
#include "sph2d/io.h"
#include "sph2d/key.h"
#include "time_limits.h"

enum { STEPS = 4, LONGEST = 3, PATH = 128, VALUE = 160 };

/* Scenes that give all keys, where they may stand together. */
static const char free_surface[] =
    "domain: {min: [0, 0], max: [1, 1]}\n"
    "spacing: 0.1\n"
    "fluid: {density: 1000, dynamic_viscosity: 1, surface_tension: 0.1}\n"
    "blocks:\n"
    "  - {box: {min: [0, 0], max: [0.4, 0.4]}, velocity: [0.1, 0], perturb: {amplitude: 0.1, seed: 2}}\n"
    "  - {disc: {center: [0.7, 0.8], radius: 0.15}}\n"
    "sources:\n"
    "  - {at: [0.2, 0.8], direction: [1, 0], width: 0.1, speed: 1, spread: 0.1, rate: 0.05, start: 0, stop: 3, seed: "
    "4}\n"
    "drains:\n"
    "  - {box: {min: [0.9, 0], max: [1, 0.1]}, start: 0.1, stop: 9}\n"
    "obstacles:\n"
    "  - {name: post, circle: {center: [0.7, 0.3], radius: 0.12}, motion: {amplitude: [0.01, 0], frequency: 1, phase: "
    "-1.5708}}\n"
    "  - {line: [[0.5, 0.55], [0.9, 0.55]], form: reflect, restitution: 0.4, motion: {path: [[0, 0, 0], [1, 0.1, "
    "0]]}}\n"
    "interactions:\n"
    "  - {path: [[0, 0.5, 0.5], [0.3, 0.8, 0.5]], radius: 0.3, acceleration: 20}\n"
    "probes:\n"
    "  - {name: gauge, kind: pressure, at: [0, 0.1], size: 0.1, along: [0, 1], rise_time: 0.001, every: 0.01}\n"
    "  - {name: energy, kind: energy, per_second: 50}\n"
    "  - {name: push, kind: force, on: post, at: [0.7, 0.3], every: 0.02}\n"
    "run: {until: 1, snapshots: {every: 0.1}, frames: {per_second: 10, size: [64, 64]}}\n";

static const char filled[] = "domain: {min: [0, 0], max: [1, 1]}\n"
                             "boundary: {left: periodic, right: periodic}\n"
                             "gravity: [0.1, 0]\n"
                             "spacing: 0.1\n"
                             "wall_speeds: {top: 1, bottom: 0}\n"
                             "fluid: {density: 1000, dynamic_viscosity: 10}\n"
                             "blocks:\n"
                             "  - {box: {min: [0, 0], max: [1, 1]}}\n"
                             "run: {until: 1}\n";

static const char *const values[] = {"-1",  "0",     "1e-300", "1e-12",   "1e12", "1e300", /* the short test's */
                                     "1",   "1e-13", "1e-6",   "1e-3",    "1e3",  "1e6",    "1e13",
                                     "0.1", "-1e12", "-1e300", "-1e-300", ".nan", "1e99999"};
enum { SHORT = 6, VALUES = sizeof values / sizeof *values };

/* What is being tried, for the handler of the timer. */
static char trying[PATH + VALUE + 64];

static void too_long(int signal)
{
    static const char words[] = "limit of 3 s of CPU time (" LIMITS_HINT "): ";
    (void)signal;
    ssize_t told = write(STDERR_FILENO, words, sizeof words - 1);
    told += write(STDERR_FILENO, trying, strlen(trying));
    _exit(told > 0 ? EXIT_FAILURE : 2);
}

/** Ends the test after so many seconds of CPU time, since other jobs take time, too; never for 0. */
static void limit_time(int seconds)
{
    struct itimerval limit = {{0, 0}, {seconds * (int)limits_factor(), 0}}; /* sanitizers are slow */
    setitimer(ITIMER_PROF, &limit, NULL);
}

/* Failures are counted, so that a run tells all. */
static size_t failures;

static bool is_finite(const sph2d_sim *sim)
{
    sph2d_view f = sph2d_sim_fluid(sim);
    bool finite = isfinite(sph2d_sim_time(sim)) && isfinite(sph2d_sim_time_step(sim));
    for (size_t i = 0; i < f.count; ++i)
        finite = finite && isfinite(f.x[i] + f.y[i]) && isfinite(f.vx[i] + f.vy[i]) && isfinite(f.density[i]) &&
                 isfinite(f.pressure[i]);
    return finite;
}

static void try_scene(const char *text, const char *method, const char *path, const char *value)
{
    sph2d_report report = {0};
    sph2d_scene_file *file = NULL;
    sph2d_sim *sim = NULL;
    sph2d_override overrides[] = {{"method.name", method}, {"fluid.surface_tension", "0"}, {path, value}};
    bool fitted = strcmp(method, "fitted") == 0;
    if (fitted)
        overrides[0] = (sph2d_override){"method", "{name: wcsph, operators: fitted}"};
    snprintf(trying, sizeof trying, "%s, %s: %s", method, path, value);
    limit_time(LONGEST);
    sph2d_status status = sph2d_scene_file_parse(text, strlen(text), "s.yaml", overrides, 3, &file, &report);
    if (status == SPH2D_OK) {
        sph2d_sim_options options = sph2d_sim_options_default();
        options.threads = 1;
        status = sph2d_sim_create(sph2d_scene_file_scene(file), &options, &sim, &report);
    }
    bool finite = true;
    for (int n = 0; status == SPH2D_OK && n < STEPS; ++n) {
        finite = finite && is_finite(sim);
        status = sph2d_sim_step(sim, &report);
    }
    limit_time(0);
    bool known = status == SPH2D_OK || status == SPH2D_SCENE || status == SPH2D_GUARD || status == SPH2D_FORMAT;
    if (!finite || !known || (status != SPH2D_OK && report.errors == 0)) {
        fprintf(stderr, "%s: %s, %s %s\n", trying, sph2d_status_text(status), test_report_text(&report),
                finite ? "" : "and values that are not finite");
        ++failures;
    }
    sph2d_sim_destroy(sim);
    sph2d_scene_file_destroy(file);
}

static const char *const free_methods[] = {"muller", "wcsph", "pcisph", "constraint"};

static void try_value(const char *path, const char *value, size_t turn)
{
    bool full = getenv("SPH2D_TEST_FULL");
    for (size_t m = 0; m < 4; ++m)
        if (full || m == turn % 4)
            try_scene(free_surface, free_methods[m], path, value);
    if (full || turn % 4 == 0)
        try_scene(filled, "fitted", path, value);
}

/** Puts a number into the value of a key as a file writes it; false for kinds without numbers. */
static bool write_value(const sph2d_key *key, const char *number, char *out)
{
    switch (key->kind) {
    case SPH2D_KEY_NUMBER:
    case SPH2D_KEY_COUNT:
        return snprintf(out, VALUE, "%s", number) > 0;
    case SPH2D_KEY_COUNTS2:
    case SPH2D_KEY_POINT:
        return snprintf(out, VALUE, "[0.5, %s]", number) > 0;
    case SPH2D_KEY_NUMBERS:
        return snprintf(out, VALUE, "[%s]", number) > 0;
    case SPH2D_KEY_POSES:
    case SPH2D_KEY_PATH:
        return snprintf(out, VALUE, "[[0, 0, 0], [%s, %s, 0]]", number, number) > 0;
    case SPH2D_KEY_POINTS:
        return snprintf(out, VALUE,
                        strcmp(key->name, "polygon") == 0 ? "[[0.5, 0.5], [0.6, 0.5], [0.6, %s]]"
                                                          : "[[0.5, 0.5], [0.6, %s]]",
                        number) > 0;
    default:
        return false;
    }
}

static size_t tried;

static void try_keys(const sph2d_keys *keys, const char *prefix)
{
    for (size_t k = 0; k < keys->count; ++k) {
        const sph2d_key *key = &keys->items[k];
        char path[PATH], value[VALUE];
        snprintf(path, sizeof path, "%s%s%s", prefix, prefix[0] ? "." : "", key->name);
        if (key->kind == SPH2D_KEY_GROUP || (key->kind == SPH2D_KEY_LIST && key->keys && !key->as_mapping)) {
            char inside[PATH + 4];
            snprintf(inside, sizeof inside, key->kind == SPH2D_KEY_LIST ? "%s[0]" : "%s", path);
            try_keys(key->keys, inside);
            continue;
        }
        for (size_t v = 0; v < (getenv("SPH2D_TEST_FULL") ? VALUES : SHORT) && write_value(key, values[v], value); ++v)
            try_value(path, value, tried++);
    }
}

START_TEST(every_number_is_refused_or_harmless)
{
    signal(SIGPROF, too_long);
    tried = 0;
    try_keys(sph2d_scene_keys(), "");
    ck_assert_uint_gt(tried, 400);
    ck_assert_uint_eq(failures, 0);
}
END_TEST

/* Numbers that are in range, each, and do not fit together. */
static const struct {
    const char *path, *value;
} pairs[] = {
    {"spacing", "110946"},
    {"spacing", "1e-9"},
    {"domain", "{min: [-3e2, -3e2], max: [3e2, 3e2]}"},
    {"domain", "{min: [0, 0], max: [1, 1e12]}"},
    {"domain", "{min: [1e11, 1e11], max: [1.0000001e11, 1.0000001e11]}"},
    {"gravity", "[0, -1e12]"},
    {"fluid", "{density: 1e-12, dynamic_viscosity: 1e12}"},
    {"fluid", "{density: 1e12, dynamic_viscosity: 1e-12}"},
    {"method.time_step", "1e12"},
    {"method.sound_speed", "1e12"},
    {"obstacles", "[{circle: {center: [0.5, 0.5], radius: 1e9}}]"},
    {"obstacles", "[{line: [[0, 0.5], [1e9, 0.5]]}]"},
    {"obstacles", "[{circle: {center: [0.7, 0.7], radius: 1e-11}}]"},
    {"blocks", "[{disc: {center: [0.5, 0.5], radius: 1e9}}]"},
    {"blocks", "[{box: {min: [0, 0], max: [0.4, 0.4]}, spacing: 0.001}]"},
    {"sources", "[{at: [0.5, 0.5], width: 1e9, speed: 1e9}]"},
    {"probes", "[{name: a, kind: energy, per_second: 1e12}]"},
    {"probes", "[{name: a, kind: pressure, at: [0.5, 0.5], size: 0.5, every: 1e-12}]"},
    {"run", "{until: 1e12, snapshots: {every: 1e-12}}"},
};

START_TEST(numbers_that_do_not_fit_are_refused_or_harmless)
{
    signal(SIGPROF, too_long);
    for (size_t m = 0; m < 4; ++m)
        try_scene(free_surface, free_methods[m], pairs[_i].path, pairs[_i].value);
    try_scene(filled, "fitted", pairs[_i].path, pairs[_i].value);
    ck_assert_uint_eq(failures, 0);
}
END_TEST

/** A scene with `count` polylines of `points` points each. */
static sph2d_status check_outlines(size_t count, size_t points, sph2d_report *report)
{
    sph2d_vec2 *at = calloc(count * points, sizeof *at);
    sph2d_obstacle *obstacles = calloc(count, sizeof *obstacles);
    ck_assert(at && obstacles);
    sph2d_scene scene = test_scene(0.1, 0, 0, 1, 1);
    sph2d_block block = test_block(0, 0, 1, 0.2);
    for (size_t i = 0; i < count; ++i) {
        for (size_t k = 0; k < points; ++k)
            at[i * points + k] = (sph2d_vec2){(double)k / (double)points, 0.5 + 0.4 * (double)i / (double)count};
        obstacles[i] = sph2d_obstacle_default();
        obstacles[i].shape = (sph2d_shape){.kind = SPH2D_SHAPE_POLYLINE, .points = {at + i * points, points}};
    }
    scene.blocks = &block;
    scene.block_count = 1;
    scene.obstacles = obstacles;
    scene.obstacle_count = count;
    sph2d_status status = sph2d_scene_check(&scene, report);
    free(obstacles);
    free(at);
    return status;
}

START_TEST(outlines_have_points_that_can_be_compared)
{
    sph2d_report report = {0};
    ck_assert_int_eq(check_outlines(1, 2000, &report), SPH2D_OK);
    ck_assert_int_eq(check_outlines(1, 2001, &report), SPH2D_SCENE);
    ck_assert(test_report_has(&report, SPH2D_CODE_OUT_OF_RANGE, "obstacles[0].polyline"));
    sph2d_report_clear(&report);
    ck_assert_int_eq(check_outlines(50, 100, &report), SPH2D_OK);
    ck_assert_int_eq(check_outlines(51, 100, &report), SPH2D_SCENE);
    ck_assert(test_report_has(&report, SPH2D_CODE_OUT_OF_RANGE, "obstacles"));
}
END_TEST

Suite *suite_extremes(void)
{
    Suite *suite = suite_create("extremes");
    TCase *t = tcase_create("numbers");
    tcase_add_test(t, every_number_is_refused_or_harmless);
    tcase_add_loop_test(t, numbers_that_do_not_fit_are_refused_or_harmless, 0, sizeof pairs / sizeof *pairs);
    tcase_add_test(t, outlines_have_points_that_can_be_compared);
    suite_add_tcase(suite, t);
    return suite;
}
