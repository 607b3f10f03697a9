/* SPDX-License-Identifier: MIT */
/** @file common.h
 *  What several test suites need: scenes of a few lines, simulations that must work, states that can be changed. */
#ifndef SPH2D_TESTS_COMMON_H
#define SPH2D_TESTS_COMMON_H

#include <check.h>

#include "scene/world.h"
#include "sph2d/field.h"
#include "sph2d/sph2d.h"

#define TEST_PI 3.14159265358979323846

/** A test case of the suite for tests that take more than a second or two, which `make test` leaves to `make test-full`. */
TCase *test_long(Suite *suite);

/** A uniform number in [low, high); *state is any start value. */
double test_random(uint64_t *state, double low, double high);

/** A scene with domain (x0, y0) to (x1, y1): four walls, no gravity, no viscosity, stiffness 100 (c0 = 10 m/s). */
sph2d_scene test_scene(double spacing, double x0, double y0, double x1, double y1);
/** The same with four open sides. */
sph2d_scene test_open_scene(double spacing, double x0, double y0, double x1, double y1);
/** A block (x0, y0) to (x1, y1) at rest. */
sph2d_block test_block(double x0, double y0, double x1, double y1);
/** A block of one particle, at (x, y) to round-off. */
sph2d_block test_particle(double spacing, double x, double y, double vx, double vy);

/** Makes a simulation on one thread (or with `options`) that must not fail. */
sph2d_sim *test_create(const sph2d_scene *scene, const sph2d_sim_options *options);
/** What a scene, even one that is refused for want of a sound speed, is resolved to. Static storage. */
const sph2d__world *test_world(const sph2d_scene *scene);
/** Takes steps, none of which may fail. */
void test_steps(sph2d_sim *sim, int steps);

/** Index of the particle with an id; the test fails when there is none. */
size_t test_find(sph2d_view view, uint64_t id);

/** Whether a report holds an error of this code at this path; NULL for any path. */
bool test_report_has(const sph2d_report *report, sph2d_code code, const char *path);
/** All messages of a report, for the text of a failed test. Static storage. */
const char *test_report_text(const sph2d_report *report);

/** Expects that two simulations of a scene are the same to the last bit: state, fields, bodies, probes, summary. */
void test_same(sph2d_sim *a, sph2d_sim *b, const char *when);

/** Memory of the C library as sph2d_allocator wants it: aligned to 64 bytes, freed by size 0, NULL when there is none.
 */
void *test_resize(void *block, size_t old_size, size_t new_size);

/** Ends the process after so many seconds by the clock, times limits_factor(), with a sentence, for what may wait for
 *  ever; never for 0. */
void test_limit(unsigned seconds);

/** A state with data of its own, to be changed at will. */
typedef struct test_state {
    sph2d_state state;
    sph2d_array *arrays;
    size_t count;
} test_state;

/** A deep copy of a simulation's state. */
test_state test_state_copy(sph2d_sim *sim);
void test_state_free(test_state *state);
/** An array of it; the test fails when there is none. */
sph2d_array *test_state_array(test_state *state, sph2d_group group, const char *name);
/** Its data, to write to. */
double *test_state_reals(test_state *state, sph2d_group group, const char *name, unsigned component);
uint64_t *test_state_counts(test_state *state, sph2d_group group, const char *name);

#endif
