/* SPDX-License-Identifier: MIT */
/** @file test_twins.c
 *  Twins: a simulation that a program has changed between two steps, and one restored from its state, are the same to
 *  the last bit, at once and for good. Every function that changes a simulation, by every method, before the first step
 *  and after some. */
#include <stdio.h>
#include <string.h>

#include "common.h"
#include "sph2d/contacts.h"
#include "sph2d/io.h"

/* ---- scenes ------------------------------------------------------------------------------------------------------ */

/* A tank with a paddle that swings in the water, bodies, a source, a drain, probes of all that is kept between steps. */
#define TANK POOL "  - {name: push, kind: force, every: 0.01}\n"
#define POOL                                                                                                           \
    "domain: {min: [0, 0], max: [1, 0.6]}\n"                                                                           \
    "spacing: 0.05\n"                                                                                                  \
    "fluid: {density: 1000, dynamic_viscosity: 1}\n"                                                                   \
    "run: {until: 1}\n"                                                                                                \
    "blocks: [{box: {min: [0, 0], max: [1, 0.3]}}]\n"                                                                  \
    "interactions: [{path: [[0, 0.2, 0.3]], radius: 0.2, acceleration: 5}]\n"                                          \
    "sources: [{at: [0.2, 0.5], direction: [0, -1], width: 0.1, speed: 1}]\n"                                          \
    "drains: [{box: {min: [0.9, 0], max: [1, 0.05]}}]\n"                                                               \
    "probes:\n"                                                                                                        \
    "  - {name: gauge, kind: pressure, at: [0.4, 0], along: [1, 0], size: 0.1, rise_time: 0.05, every: 0.01}\n"        \
    "  - {name: energy, kind: energy, every: 0.01}\n"
#define MOVING                                                                                                         \
    "obstacles: [{name: paddle, box: {min: [0.6, 0.1], max: [0.7, 0.5]}, motion: {amplitude: [0.02, 0],\n"             \
    "  frequency: 2}}]\n"
#define BODIES                                                                                                         \
    "bodies:\n"                                                                                                        \
    "  - {name: float, circle: {center: [0.3, 0.3], radius: 0.08}, density: 500, springs: [{to: [0.3, 0.5],\n"         \
    "      stiffness: 100, damping: 1}]}\n"                                                                            \
    "  - {name: wheel, box: {min: [0.8, 0.2], max: [0.9, 0.3]}, density: 1500, hold: {x: on},\n"                       \
    "      motor: {rate: 3, torque: 5}}\n"
/* Liquid that fills its domain, for fitted operators. */
#define FULL                                                                                                           \
    "domain: {min: [0, 0], max: [1, 0.6]}\n"                                                                           \
    "boundary: {top: wall}\n"                                                                                          \
    "spacing: 0.05\n"                                                                                                  \
    "gravity: [0, -1]\n"                                                                                               \
    "wall_slip: none\n"                                                                                                \
    "fluid: {density: 1000, dynamic_viscosity: 1}\n"                                                                   \
    "blocks: [{box: {min: [0, 0], max: [1, 0.6]}}]\n"                                                                  \
    "interactions: [{path: [[0, 0.2, 0.3]], radius: 0.2, acceleration: 1}]\n"                                          \
    "probes: [{name: push, kind: force, every: 0.01}, {name: energy, kind: energy, every: 0.01}]\n"                    \
    "run: {until: 1}\n"
#define STREAM                                                                                                         \
    "domain: {min: [0, 0], max: [1, 0.4]}\n"                                                                           \
    "boundary: {top: wall}\n"                                                                                          \
    "spacing: 0.05\n"                                                                                                  \
    "gravity: [0, 0]\n"                                                                                                \
    "fluid: {density: 1000, dynamic_viscosity: 1}\n"                                                                   \
    "blocks: [{box: {min: [0, 0], max: [1, 0.4]}, velocity: [1, 0]}]\n"                                                \
    "openings: [{name: in, side: left, velocity: 1}, {name: out, side: right, pressure: 0}]\n"                         \
    "probes: [{name: out, kind: opening, on: out, every: 0.01}, {name: energy, kind: energy, every: 0.01}]\n"          \
    "run: {until: 1}\n"

static const char *const scenes[] = {
    TANK MOVING "method: wcsph\n",
    TANK MOVING BODIES "method: wcsph\n",
    TANK "method: wcsph\nwall_slip: smooth\n",
    TANK
    "method: wcsph\nwall_slip: none\nmotion: {angle: 0.1, frequency: 1}\ngravity_path: [[0, 0, -9.81], [1, 1, -9]]\n",
    STREAM "method: wcsph\n",
    FULL "method: {name: wcsph, operators: fitted, sound_speed: 10}\n",
    FULL MOVING "method: {name: wcsph, operators: fitted, sound_speed: 10}\n",
    FULL MOVING "method: {name: wcsph, operators: fitted, sound_speed: 10}\nmotion: {angle: 0.1, frequency: 1}\n",
    STREAM "method: {name: wcsph, operators: fitted, sound_speed: 10}\nwall_slip: none\n",
    TANK MOVING "method: muller\n",
    TANK MOVING BODIES "method: {name: muller}\nwalls: heavy\n",
    TANK "method: muller\n",
    TANK MOVING "method: pcisph\n",
    TANK MOVING BODIES "method: {name: pcisph}\nwalls: generalised\n",
    TANK MOVING "method: constraint\n",
    TANK MOVING BODIES "method: {name: constraint}\nwalls: generalised\n",
    POOL MOVING "method: hybrid\n",
    POOL BODIES "method: hybrid\n",
};
enum { SCENES = sizeof scenes / sizeof scenes[0] };

/* ---- edits ------------------------------------------------------------------------------------------------------- */

static void pull(sph2d_sim *sim)
{
    ck_assert_int_eq(sph2d_sim_set_gravity(sim, (sph2d_vec2){3, -5}), SPH2D_OK);
}

static void point(sph2d_sim *sim)
{
    ck_assert_int_eq(sph2d_sim_set_pointer(sim, (sph2d_vec2){0.55, 0.2}, 0.5, 5), SPH2D_OK);
}

static void let_go(sph2d_sim *sim)
{
    ck_assert_int_eq(sph2d_sim_set_pointer(sim, (sph2d_vec2){0, 0}, 0, 0), SPH2D_OK);
}

static void strike(sph2d_sim *sim)
{
    for (size_t k = 0; k < sph2d_sim_scene(sim)->body_count; ++k)
        ck_assert_int_eq(sph2d_sim_set_body_velocity(sim, k, (sph2d_vec2){0.5, -0.3}, 2), SPH2D_OK);
}

static void take(sph2d_sim *sim)
{
    const sph2d_shape shape = {.kind = SPH2D_SHAPE_CIRCLE, .circle = {{0.5, 0.16}, 0.06}};
    ck_assert_int_eq(sph2d_sim_remove_particles(sim, &shape, NULL), SPH2D_OK);
}

/** Where there is room: above the water, and in the hole that take() leaves. */
static void pour(sph2d_sim *sim)
{
    const sph2d_particle drops[] = {{.x = 0.4, .y = 0.5, .vx = 1}, {.x = 0.45, .y = 0.5}, {.x = 0.5, .y = 0.16}};
    ck_assert_int_eq(sph2d_sim_add_particles(sim, drops, 3, NULL), SPH2D_OK);
}

static void take_outputs(sph2d_sim *sim)
{
    for (size_t k = 0; k < SPH2D_OUTPUT_PROBE + sph2d_sim_scene(sim)->probe_count; ++k)
        sph2d_sim_output_done(sim, k);
}

typedef void edit(sph2d_sim *sim);
enum { MOST_EDITS = 6 };

/** What is done between two steps. */
static const struct {
    const char *name;
    edit *edits[MOST_EDITS];
} cases[] = {
    {"nothing", {NULL}},
    {"gravity", {pull}},
    {"pointer", {point}},
    {"pointer on and off", {point, let_go}},
    {"blow", {strike}},
    {"removed", {take}},
    {"added", {pour}},
    {"outputs", {take_outputs}},
    {"gravity, then removed", {pull, take}},
    {"removed, then gravity", {take, pull}},
    {"pointer, then removed and added", {point, take, pour}},
    {"blow, then added", {strike, pour}},
    {"added, then blow and pointer", {pour, strike, point}},
    {"everything", {take, pour, pull, point, strike, take_outputs}},
};
enum { CASES = sizeof cases / sizeof cases[0] };

/* ---- twins ------------------------------------------------------------------------------------------------------- */

/** Edits a simulation, makes its twin, and expects both to stay the same. */
static void go_on(sph2d_sim *sim, const sph2d_scene *scene, size_t index, const char *when)
{
    static sph2d_report report;
    char text[200];
    sph2d_sim *twin = NULL;
    for (int k = 0; k < MOST_EDITS && cases[index].edits[k]; ++k)
        cases[index].edits[k](sim);
    const sph2d_state state = sph2d_sim_state(sim);
    sph2d_report_clear(&report);
    ck_assert_msg(sph2d_sim_restore(scene, NULL, &state, &twin, &report) == SPH2D_OK, "%s", test_report_text(&report));
    ck_assert_int_eq(sph2d_contacts_attach(twin), SPH2D_OK);
    for (int steps = 0; steps < 4; ++steps) {
        snprintf(text, sizeof text, "%s %s, %d steps later", cases[index].name, when, steps);
        test_same(sim, twin, text);
        test_steps(sim, 1);
        test_steps(twin, 1);
    }
    sph2d_sim_destroy(twin);
}

START_TEST(a_change_is_whole_in_the_state)
{
    static sph2d_report report;
    sph2d_scene_file *file = NULL;
    sph2d_report_clear(&report);
    ck_assert_msg(sph2d_scene_file_parse(scenes[_i], strlen(scenes[_i]), "twins", NULL, 0, &file, &report) == SPH2D_OK,
                  "%s", test_report_text(&report));
    const sph2d_scene *scene = sph2d_scene_file_scene(file);
    for (size_t index = 0; index < CASES; ++index) {
        sph2d_sim *sim = test_create(scene, NULL);
        ck_assert_int_eq(sph2d_contacts_attach(sim), SPH2D_OK);
        go_on(sim, scene, index, "at the start");
        go_on(sim, scene, index, "on the way");
        sph2d_sim_destroy(sim);
    }
    sph2d_scene_file_destroy(file);
}
END_TEST

Suite *suite_twins(void)
{
    Suite *suite = suite_create("twins");
    TCase *tests = tcase_create("twins");
    tcase_add_loop_test(tests, a_change_is_whole_in_the_state, 0, SCENES);
    tcase_set_tags(tests, "long");
    suite_add_tcase(suite, tests);
    return suite;
}
