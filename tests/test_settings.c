/* SPDX-License-Identifier: MIT */
/** @file test_settings.c
 *  Settings of the methods on three small scenes: cfl, H/dx, max_compression and what each method has beside them, drawn
 *  over all that keys may have, some beyond. A run is refused by a sentence, stopped by a guard that says why, or right:
 *  its energy, momentum and compression stay within bounds. Any other is wrong and silent, which no run may be.
 *  SPH2D_TEST_FULL draws six times as many; SPH2D_SETTINGS_VERBOSE prints a line for each run. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common.h"
#include "sph2d/io.h"

enum { TEXT = 1000, DRAWN = 100, DRAWN_FULL = 600 };

/* 128 particles at a spacing of 1/16 m, or 120 that fall; 512 and 480 at 1/32 m. */
static const struct {
    const char *name, *text;
} scenes[] = {
    {"dam break", "domain: {min: [0, 0], max: [2, 1]}\n"
                  "blocks:\n"
                  "  - box: {min: [0, 0], max: [1, 0.5]}\n"
                  "run: {until: 0.6}\n"},
    {"block falls", "domain: {min: [0, 0], max: [1.5, 1.5]}\n"
                    "blocks:\n"
                    "  - box: {min: [0.375, 0.375], max: [1.125, 1]}\n"
                    "run: {until: 0.5}\n"},
    {"blocks meet", "domain: {min: [0, 0], max: [2, 1]}\n"
                    "blocks:\n"
                    "  - {box: {min: [0.25, 0.25], max: [0.75, 0.75]}, velocity: [2, 0]}\n"
                    "  - {box: {min: [1.25, 0.25], max: [1.75, 0.75]}, velocity: [-2, 0]}\n"
                    "run: {until: 0.4}\n"},
};
enum { SCENES = sizeof scenes / sizeof *scenes };

static const struct {
    const char *name, *own[3]; /* keys that the method has alone, or that count for its bounds */
    double unknown;            /* energy that its balance may not know, over the scene's */
} methods[] = {
    {"constraint", {"", ", tolerance: 4e-4", ", tolerance: 0.02"}, 0.15},
    {"pcisph", {"", ", support_ratio: 3", ", kernel: wendland_c4"}, 0.15},
    {"wcsph", {"", ", kernel: wendland_c2", ", kernel: wendland_c4"}, 0.3},
    {"muller", {"", "", ""}, 0.75}, /* damping of its spring walls is sampled */
};
enum { METHODS = sizeof methods / sizeof *methods };

/* 0 is the method's own. */
static const double spacings[] = {1. / 16, 1. / 24, 1. / 32}, cfls[] = {0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.7, 0.9},
                    supports[] = {0, 1.8, 2, 2.4, 3, 4}, compressions[] = {0, 0.001, 0.01, 0.05, 0.1};

typedef struct settings {
    size_t scene, method, own;
    double spacing, cfl, support, compression;
} settings;

static size_t below(uint64_t *random, size_t count)
{
    return (size_t)test_random(random, 0, (double)count);
}
#define ONE_OF(random, values) ((values)[below(random, sizeof(values) / sizeof *(values))])

/** The settings of a number; those of smaller numbers are drawn before, so that all are of one sequence. */
static settings draw(int number)
{
    uint64_t random = 1;
    settings s = {0};
    for (int i = 0; i <= number; ++i) {
        s.method = (size_t)i % METHODS;
        s.scene = below(&random, SCENES);
        s.own = below(&random, 3);
        s.spacing = ONE_OF(&random, spacings);
        s.cfl = ONE_OF(&random, cfls);
        s.support = ONE_OF(&random, supports);
        s.compression = ONE_OF(&random, compressions);
    }
    return s;
}

static void write_scene(const settings *s, char out[TEXT])
{
    snprintf(out, TEXT,
             "spacing: %.6g\nmethod: {name: %s, cfl: %g, support_ratio: %g, max_compression: %g%s}\n"
             "boundary: {top: wall}\n%s",
             s->spacing, methods[s->method].name, s->cfl, s->support, s->compression, methods[s->method].own[s->own],
             scenes[s->scene].text);
}

/** What a run showed. */
typedef struct seen {
    size_t particles;
    double start, above; /**< energy at the start; kinetic and potential energy above that, at most [J/m] */
    bool finite;
} seen;

static void look(const sph2d_sim *sim, seen *all)
{
    const sph2d_view f = sph2d_sim_fluid(sim);
    const double mass = sph2d_sim_plan(sim)->particle_mass;
    double energy = 0;
    for (size_t i = 0; i < f.count; ++i) {
        energy += mass * ((f.vx[i] * f.vx[i] + f.vy[i] * f.vy[i]) / 2 + 9.81 * f.y[i]);
        all->finite = all->finite && isfinite(f.density[i]) && isfinite(f.pressure[i]);
    }
    all->finite = all->finite && isfinite(energy);
    all->above = fmax(all->above, energy - all->start);
}

/* Bounds of what is right. Energy is held against the scene's, a fall of all liquid to the floor, and against the largest
 * kinetic energy. Liquid that is stopped is pressed by U/c0 < sqrt(max_compression), at corners by more; that of a
 * projection by what moves in a step, so that two particles may come to half their distance; the sum of muller has more
 * than rest density at corners from the start, with wide supports. */
static const double ABOVE = 0.05, ABOVE_KINETIC = 0.1, RISE = 0.1, RISE_KINETIC = 0.25, MOMENTUM = 1e-6, PRESSED = 4,
                    PRESSED_TOGETHER = 2, PRESSED_AT_START = 0.25;

static double most_pressed(const settings *s)
{
    const bool muller = strcmp(methods[s->method].name, "muller") == 0;
    const double compression = s->compression > 0 ? s->compression : muller ? 0.1 : 0.01;
    if (muller || strcmp(methods[s->method].name, "wcsph") == 0)
        return fmax(PRESSED * sqrt(compression), muller ? PRESSED_AT_START : 0);
    return PRESSED_TOGETHER;
}

static const char *judge(const settings *s, const seen *all, const sph2d_summary *end)
{
    const double scale = end->energy_scale, kinetic = end->kinetic_max, unknown = methods[s->method].unknown;
    if (!all->finite)
        return "not finite";
    if (end->particles != all->particles)
        return "particles are lost";
    if (!(all->above <= fmin(ABOVE * scale, ABOVE_KINETIC * kinetic)))
        return "more energy than at the start";
    if (!(end->energy_rise <= fmin(RISE * scale, RISE_KINETIC * kinetic)))
        return "energy from nothing";
    if (!(fabs(end->energy_error) <= unknown * scale && end->energy_error_rise <= unknown * fmin(scale, 2 * kinetic)))
        return "energy that the balance does not know";
    if (!(end->momentum_error_max <= MOMENTUM * end->momentum_moved))
        return "momentum from nothing";
    if (!(end->compression_max <= most_pressed(s)))
        return "liquid is pressed together";
    return "right";
}

/** Runs settings; what became of them is "refused", "stopped", "right", or what is wrong. */
static const char *run(const settings *s, char text[TEXT])
{
    sph2d_report report = {0};
    sph2d_scene_file *file = NULL;
    sph2d_sim *sim = NULL;
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = 1;
    options.isa = SPH2D_ISA_BASELINE; /* the same bits everywhere */
    write_scene(s, text);
    sph2d_status status = sph2d_scene_file_parse(text, strlen(text), "settings", NULL, 0, &file, &report);
    if (status == SPH2D_OK)
        status = sph2d_sim_create(sph2d_scene_file_scene(file), &options, &sim, &report);
    const char *verdict = status == SPH2D_SCENE && report.errors > 0 ? "refused" : "neither made nor refused";
    if (status == SPH2D_OK) {
        const sph2d_summary start = sph2d_sim_summary(sim);
        seen all = {.particles = start.particles, .start = start.energy_start, .finite = true};
        const double until = sph2d_scene_file_scene(file)->run.until;
        while (status == SPH2D_OK && sph2d_sim_time(sim) < until) {
            status = sph2d_sim_step(sim, &report);
            look(sim, &all);
        }
        const sph2d_summary end = sph2d_sim_summary(sim);
        verdict = status == SPH2D_OK                           ? judge(s, &all, &end)
                  : status == SPH2D_GUARD && report.errors > 0 ? "stopped"
                                                               : "neither right nor stopped";
        if (getenv("SPH2D_SETTINGS_VERBOSE"))
            printf("above %.3g %.3g rise %.3g %.3g error %.3g %.3g lost %.3g momentum %.3g pressed %.3g: ",
                   all.above / end.energy_scale, all.above / end.kinetic_max, end.energy_rise / end.energy_scale,
                   end.energy_rise / end.kinetic_max, end.energy_error_rise / end.energy_scale,
                   end.energy_error_rise / end.kinetic_max, end.energy_error / end.energy_scale,
                   end.momentum_error_max / end.momentum_moved, end.compression_max);
    }
    if (getenv("SPH2D_SETTINGS_VERBOSE"))
        printf("%s: %s at 1/%.0f m by %.*s: %.70s\n", verdict, scenes[s->scene].name, 1 / s->spacing,
               (int)strcspn(strstr(text, "name: "), "}"), strstr(text, "name: "),
               report.errors > 0 ? test_report_text(&report) : "");
    fflush(stdout);
    sph2d_report_clear(&report);
    sph2d_sim_destroy(sim);
    sph2d_scene_file_destroy(file);
    return verdict;
}

START_TEST(settings_are_right_refused_or_stopped)
{
    char text[TEXT];
    const settings s = draw(_i);
    const char *verdict = run(&s, text);
    ck_assert_msg(!strcmp(verdict, "right") || !strcmp(verdict, "refused") || !strcmp(verdict, "stopped"),
                  "%s, and the run says nothing:\n%s", verdict, text);
}
END_TEST

START_TEST(defaults_are_right)
{
    char text[TEXT];
    const settings s = {.scene = (size_t)_i / METHODS, .method = (size_t)_i % METHODS, .spacing = 1. / 24};
    const char *verdict = run(&s, text);
    ck_assert_msg(!strcmp(verdict, "right"), "%s:\n%s", verdict, text);
}
END_TEST

Suite *suite_settings(void)
{
    Suite *suite = suite_create("settings");
    TCase *tests = tcase_create("settings");
    tcase_add_loop_test(tests, defaults_are_right, 0, SCENES * METHODS);
    tcase_add_loop_test(tests, settings_are_right_refused_or_stopped, 0,
                        getenv("SPH2D_TEST_FULL") ? DRAWN_FULL : DRAWN);
    tcase_set_tags(tests, "long");
    suite_add_tcase(suite, tests);
    return suite;
}
