/* SPDX-License-Identifier: MIT */
/** @file test_tracers.c
 *  Probes that move: tracers, which follow a particle, and those that a wall takes along or that have a way of their own. */
#include <math.h>
#include <string.h>

#include "common.h"

static sph2d_scene scene;
static sph2d_block block;
static sph2d_source source;
static sph2d_probe probes[3];
static sph2d_report report;

static sph2d_probe probe_of(const char *name, sph2d_probe_kind kind, double x, double y)
{
    sph2d_probe probe = sph2d_probe_default();
    probe.name = name;
    probe.kind = kind;
    probe.at = (sph2d_vec2){x, y};
    probe.rate.every = 0.01;
    return probe;
}

/** Water that falls to one side of a tank of 2 m by 1 m. */
static void set_up(void)
{
    scene = test_scene(0.05, 0, 0, 2, 1);
    scene.method = sph2d_scene_default().method;
    scene.gravity = (sph2d_vec2){0, -9.81};
    block = test_block(0, 0, 0.5, 0.7);
    scene.blocks = &block;
    scene.block_count = 1;
    probes[0] = probe_of("a", SPH2D_PROBE_TRACER, 0.32, 0.41);
    probes[1] = probe_of("b", SPH2D_PROBE_TRACER, 1.5, 0.7);
    scene.probes = probes;
    scene.probe_count = 2;
}

static void tear_down(void)
{
    sph2d_report_clear(&report);
}

static size_t index_of(const sph2d_view *fluid, uint64_t id)
{
    for (size_t i = 0; i < fluid->count; ++i)
        if (fluid->id[i] == id)
            return i;
    ck_abort_msg("no particle %llu", (unsigned long long)id);
    return 0;
}

/* ---- tracers ----------------------------------------------------------------------------------------------------- */

START_TEST(a_tracer_follows_the_nearest_particle)
{
    sph2d_sim *sim = test_create(&scene, NULL);
    double v[SPH2D_PROBE_MAX_COLUMNS];
    ck_assert_uint_eq(sph2d_sim_probe(sim, 0, v), 6);
    ck_assert_double_eq_tol(v[0], 0.325, 1e-12); /* of a lattice from 0.025 on */
    ck_assert_double_eq_tol(v[1], 0.425, 1e-12);
    const uint64_t id = (uint64_t)v[5];
    for (int k = 0; k < 10; ++k) {
        test_steps(sim, 20);
        sph2d_sim_probe(sim, 0, v);
        const sph2d_view fluid = sph2d_sim_fluid(sim);
        const size_t i = index_of(&fluid, id);
        const double expected[] = {fluid.x[i], fluid.y[i], fluid.vx[i], fluid.vy[i], fluid.pressure[i], (double)id};
        for (int column = 0; column < 6; ++column)
            ck_assert_double_eq(v[column], expected[column]);
        sph2d_sim_output_done(sim, SPH2D_OUTPUT_PROBE);
        const sph2d_paths paths = sph2d_sim_paths(sim);
        ck_assert_uint_eq(paths.count, (size_t)k + 1);
        ck_assert_double_eq(paths.places[2 * k], fluid.x[i]);
        ck_assert_double_eq(paths.places[2 * k + 1], fluid.y[i]);
        ck_assert_uint_eq(paths.probes[k], 0);
    }
    ck_assert_double_gt(v[0], 0.4); /* it was worth while */
    sph2d_sim_destroy(sim);
    ck_assert_uint_eq(sph2d_sim_paths(NULL).count, 0);
}
END_TEST

START_TEST(a_tracer_waits_for_liquid_and_ends_with_it)
{
    source = sph2d_source_default();
    source.at = (sph2d_vec2){1.5, 0.95};
    source.speed = 1;
    scene.sources = &source;
    scene.source_count = 1;
    sph2d_sim *sim = test_create(&scene, NULL);
    double v[SPH2D_PROBE_MAX_COLUMNS];
    sph2d_sim_probe(sim, 1, v);
    for (int k = 0; k < 6; ++k)
        ck_assert(isnan(v[k]));
    sph2d_sim_output_done(sim, SPH2D_OUTPUT_PROBE + 1);
    ck_assert_uint_eq(sph2d_sim_paths(sim).count, 0);
    while (isnan(v[5]) && sph2d_sim_time(sim) < 1) {
        test_steps(sim, 1);
        sph2d_sim_probe(sim, 1, v);
    }
    ck_assert_double_gt(sph2d_sim_time(sim), 0.1); /* of 0.14 s for a fall of 0.2 m, and a step */
    ck_assert_double_lt(sph2d_sim_time(sim), 0.2);
    ck_assert_double_lt(hypot(v[0] - 1.5, v[1] - 0.7), 0.05);
    sph2d_sim_output_done(sim, SPH2D_OUTPUT_PROBE + 1);
    ck_assert_uint_eq(sph2d_sim_paths(sim).count, 1);
    const sph2d_shape all = {.kind = SPH2D_SHAPE_BOX, .box = {{1, 0}, {2, 1}}};
    ck_assert_int_eq(sph2d_sim_remove_particles(sim, &all, NULL), SPH2D_OK);
    test_steps(sim, 40); /* others come */
    sph2d_sim_probe(sim, 1, v);
    ck_assert(isnan(v[0]) && isnan(v[5]));
    sph2d_sim_output_done(sim, SPH2D_OUTPUT_PROBE + 1);
    ck_assert_uint_eq(sph2d_sim_paths(sim).count, 1);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(paths_are_part_of_the_state)
{
    sph2d_sim *sim = test_create(&scene, NULL), *again = NULL;
    for (int k = 0; k < 5; ++k) {
        test_steps(sim, 10);
        sph2d_sim_output_done(sim, SPH2D_OUTPUT_PROBE);
        sph2d_sim_output_done(sim, SPH2D_OUTPUT_PROBE + 1); /* which has no particle */
    }
    const sph2d_state state = sph2d_sim_state(sim);
    ck_assert_int_eq(sph2d_sim_restore(&scene, NULL, &state, &again, NULL), SPH2D_OK);
    test_steps(sim, 10);
    test_steps(again, 10);
    sph2d_sim_output_done(sim, SPH2D_OUTPUT_PROBE);
    sph2d_sim_output_done(again, SPH2D_OUTPUT_PROBE);
    const sph2d_paths a = sph2d_sim_paths(sim), b = sph2d_sim_paths(again);
    ck_assert_uint_eq(a.count, 6);
    ck_assert_uint_eq(b.count, 6);
    ck_assert_mem_eq(a.places, b.places, 12 * sizeof(double));
    ck_assert_mem_eq(a.probes, b.probes, 6 * sizeof(uint64_t));
    sph2d_sim_destroy(sim);
    sph2d_sim_destroy(again);
}
END_TEST

/* ---- probes that are taken along, or have a way ------------------------------------------------------------------- */

enum { STEPS = 100 };
static const double DT = 2.5e-4, RATE = 20;

/** Two probes of a kind, one that moves and one at rest where that will be after STEPS steps of DT. */
static void compare_at_the_end(double least)
{
    scene.method.time_step = DT;
    scene.run.until = 1;
    sph2d_sim *sim = test_create(&scene, NULL);
    test_steps(sim, STEPS);
    ck_assert_double_eq_tol(sph2d_sim_time(sim), STEPS * DT, 1e-12);
    double moves[SPH2D_PROBE_MAX_COLUMNS], rests[SPH2D_PROBE_MAX_COLUMNS];
    sph2d_sim_probe(sim, 0, moves);
    sph2d_sim_probe(sim, 1, rests);
    ck_assert_double_gt(fabs(rests[0]), least);
    ck_assert_double_eq_tol(moves[0], rests[0], 1e-9 * fabs(rests[0]));
    sph2d_sim_probe(sim, 2, rests); /* where it was */
    ck_assert_double_gt(fabs(moves[0] - rests[0]), 3e-4 * fabs(rests[0]));
    sph2d_sim_destroy(sim);
}

/** A blade in the water turns by half a radian, and takes a gauge with a face along. */
START_TEST(a_wall_takes_probes_along)
{
    static sph2d_obstacle blade;
    const sph2d_probe_kind kind = _i == 0 ? SPH2D_PROBE_PRESSURE : SPH2D_PROBE_SPEED;
    blade = sph2d_obstacle_default();
    blade.name = "blade";
    blade.shape = (sph2d_shape){.kind = SPH2D_SHAPE_CIRCLE, .circle = {{1, 0.4}, 0.12}};
    blade.motion.rate = RATE;
    scene.obstacles = &blade;
    scene.obstacle_count = 1;
    block = test_block(0, 0, 2, 0.8);
    const double angle = RATE * STEPS * DT, c = cos(angle), s = sin(angle);
    probes[0] = probe_of("moves", kind, 1.2, 0.35);
    probes[0].on = "blade";
    probes[1] = probe_of("rests", kind, 1 + 0.2 * c + 0.05 * s, 0.4 + 0.2 * s - 0.05 * c);
    probes[2] = probe_of("before", kind, 1.2, 0.35);
    if (kind == SPH2D_PROBE_PRESSURE) {
        probes[0].size = probes[1].size = probes[2].size = 0.1;
        probes[0].along = probes[2].along = (sph2d_vec2){2, 1};
        probes[1].along = (sph2d_vec2){2 * c - s, 2 * s + c};
        probes[0].rise_time = probes[1].rise_time = probes[2].rise_time = 0;
    } else {
        scene.wall_slip = SPH2D_SLIP_NONE;
        scene.fluid.dynamic_viscosity = 100;
    }
    scene.probe_count = 3;
    compare_at_the_end(kind == SPH2D_PROBE_PRESSURE ? 1000 : 0.01);
}
END_TEST

START_TEST(a_probe_has_a_way)
{
    static const sph2d_path_point way[] = {{0.01, 0.1, 0.1}, {0.04, 0.4, 0.4}};
    const sph2d_probe_kind kinds[] = {SPH2D_PROBE_SPEED, SPH2D_PROBE_PRESSURE, SPH2D_PROBE_ELEVATION};
    for (int k = 0; k < 3; ++k) {
        probes[k] = probe_of(k == 0   ? "moves"
                             : k == 1 ? "rests"
                                      : "before",
                             kinds[_i], k == 1 ? 0.25 : 0.1, k == 1 ? 0.25 : 0.1);
        probes[k].rise_time = 0;
    }
    probes[0].at = (sph2d_vec2){NAN, NAN};
    probes[0].path = (sph2d_path){way, 2}; /* half of it by 0.025 s */
    scene.probe_count = 3;
    scene.gravity = (sph2d_vec2){3, -9.81}; /* so that the surface slopes */
    compare_at_the_end(1e-3);
    static const sph2d_path_point early[] = {{-2, 0.1, 0.1}, {-1, 0.25, 0.25}}; /* at rest after its end */
    probes[0].path = (sph2d_path){early, 2};
    compare_at_the_end(1e-3);
}
END_TEST

START_TEST(faults_are_told)
{
    static const sph2d_path_point back[] = {{1, 0.1, 0.1}, {0, 0.4, 0.4}}, out[] = {{0, 0.1, 0.1}, {1, 2.4, 0.4}};
    static const struct {
        sph2d_probe_kind kind;
        const char *on;
        sph2d_path path;
        double x;
        const char *key;
        double size;
    } faults[] = {{SPH2D_PROBE_SPEED, "left", {NULL, 0}, 0.1, "probes[0].on", 0},
                  {SPH2D_PROBE_PRESSURE, "raft", {NULL, 0}, 0.1, "probes[0].on", 0},
                  {SPH2D_PROBE_SPEED, NULL, {back, 2}, NAN, "probes[0].path", 0},
                  {SPH2D_PROBE_ELEVATION, NULL, {out, 2}, NAN, "probes[0].path", 0},
                  {SPH2D_PROBE_TRACER, NULL, {out, 1}, NAN, "probes[0].path", 0},
                  {SPH2D_PROBE_ENERGY, NULL, {out, 1}, NAN, "probes[0].path", 0},
                  {SPH2D_PROBE_TRACER, "left", {NULL, 0}, 0.1, "probes[0].on", 0},
                  {SPH2D_PROBE_TRACER, NULL, {NULL, 0}, 2.1, "probes[0].at", 0},
                  {SPH2D_PROBE_SPEED, "bar", {out, 1}, NAN, "probes[0].on", 0},
                  {SPH2D_PROBE_SPEED, NULL, {NULL, 0}, NAN, "probes[0].at", 0},
                  {SPH2D_PROBE_TRACER, NULL, {NULL, 0}, NAN, "probes[0].at", 0},
                  {SPH2D_PROBE_SPEED, NULL, {out, 1}, 0.1, "probes[0].path", 0},
                  {SPH2D_PROBE_PRESSURE, NULL, {out, 1}, NAN, "probes[0].size", 0.3}};
    sph2d_obstacle bar = sph2d_obstacle_default();
    bar.name = "bar";
    bar.shape = (sph2d_shape){.kind = SPH2D_SHAPE_CIRCLE, .circle = {{1, 0.4}, 0.12}};
    scene.obstacles = &bar;
    scene.obstacle_count = 1;
    const double x = faults[_i].x;
    probes[0] = probe_of("p", faults[_i].kind, x, isnan(x) ? x : 0.1);
    probes[0].on = faults[_i].on;
    probes[0].path = faults[_i].path;
    probes[0].size = faults[_i].size;
    ck_assert_int_eq(sph2d_scene_check(&scene, &report), SPH2D_SCENE);
    ck_assert_msg(report.count == 1 && strcmp(report.items[0].path, faults[_i].key) == 0, "%s",
                  test_report_text(&report));
}
END_TEST

Suite *suite_tracers(void)
{
    Suite *suite = suite_create("tracers");
    TCase *cases = tcase_create("tracers");
    tcase_add_checked_fixture(cases, set_up, tear_down);
    tcase_add_test(cases, a_tracer_follows_the_nearest_particle);
    tcase_add_test(cases, a_tracer_waits_for_liquid_and_ends_with_it);
    tcase_add_test(cases, paths_are_part_of_the_state);
    tcase_add_loop_test(cases, a_wall_takes_probes_along, 0, 2);
    tcase_add_loop_test(cases, a_probe_has_a_way, 0, 3);
    tcase_add_loop_test(cases, faults_are_told, 0, 13);
    suite_add_tcase(suite, cases);
    return suite;
}
