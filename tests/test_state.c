/* SPDX-License-Identifier: MIT */
/** @file test_state.c
 *  A state taken out and restored goes on bit for bit, with everything that a run can have; a state that is not whole,
 *  not finite or not of its scene is refused; the field table and the views show the same data. */
#include <math.h>
#include <string.h>

#include "common.h"

static const double DX = 0.02;

/* ---- a run with everything --------------------------------------------------------------------------------------- */

static sph2d_block block;
static sph2d_source sources[2];
static sph2d_drain drain;
static sph2d_vec2 line[2] = {{0.5, 0.1}, {0.7, 0.25}};
static sph2d_obstacle obstacles[2];
static sph2d_path_point path[3] = {{0, 0.2, 0.3}, {0.1, 0.6, 0.4}, {9, 0.1, 0.1}};
static sph2d_interaction pull;
static sph2d_probe probes[2];
static sph2d_scene scene;

static void start(void)
{
    scene = test_scene(DX, 0, 0, 1, 0.8);
    scene.boundary.right = SPH2D_SIDE_OPEN;
    scene.gravity.y = -9.81;
    scene.fluid.dynamic_viscosity = 0.5;
    block = test_block(0, 0, 0.4, 0.4);
    for (int i = 0; i < 2; ++i) {
        sources[i] = sph2d_source_default();
        sources[i].at = (sph2d_vec2){0.55 + 0.2 * i, 0.7};
        sources[i].speed = 2;
        sources[i].width = 4 * DX;
        sources[i].spread = 0.2;
        obstacles[i] = sph2d_obstacle_default();
        probes[i] = sph2d_probe_default();
        probes[i].rate.every = 0.01;
    }
    sources[1].start = 0.1;
    drain = sph2d_drain_default();
    drain.shape.kind = SPH2D_SHAPE_CIRCLE;
    drain.shape.circle = (sph2d_circle){{0.4, 0.05}, 0.1};
    obstacles[0].shape.kind = SPH2D_SHAPE_LINE;
    obstacles[0].shape.points = (sph2d_points){line, 2};
    obstacles[1].shape.kind = SPH2D_SHAPE_CIRCLE;
    obstacles[1].shape.circle = (sph2d_circle){{0.55, 0.5}, 0.08};
    obstacles[1].form = SPH2D_WALL_REFLECT;
    pull = sph2d_interaction_default();
    pull.path = (sph2d_path){path, 3};
    pull.radius = 0.3;
    pull.acceleration = 20;
    probes[0].name = "energy";
    probes[1].name = "speed";
    probes[1].kind = SPH2D_PROBE_SPEED;
    probes[1].at = (sph2d_vec2){0.3, 0.2};
    scene.blocks = &block;
    scene.block_count = 1;
    scene.sources = sources;
    scene.source_count = 2;
    scene.drains = &drain;
    scene.drain_count = 1;
    scene.obstacles = obstacles;
    scene.obstacle_count = 2;
    scene.interactions = &pull;
    scene.interaction_count = 1;
    scene.probes = probes;
    scene.probe_count = 2;
    scene.run.snapshots.rate.every = 0.02;
}

/** Steps that take outputs as they fall due, as a program does. */
static void run(sph2d_sim *sim, int steps)
{
    for (int n = 0; n < steps; ++n) {
        for (size_t output = 0; output < 4; ++output)
            if (sph2d_sim_output_due(sim, output))
                sph2d_sim_output_done(sim, output);
        test_steps(sim, 1);
    }
}

/** In the middle of everything: fed, drained, steered. */
static sph2d_sim *run_to_the_middle(void)
{
    sph2d_sim *sim = test_create(&scene, NULL);
    run(sim, 150);
    sph2d_sim_set_pointer(sim, (sph2d_vec2){0.3, 0.5}, 0.4, -15);
    sph2d_sim_set_gravity(sim, (sph2d_vec2){1, -8});
    run(sim, 7);
    sph2d_summary s = sph2d_sim_summary(sim);
    ck_assert(s.fed > 0 && s.drained > 0 && s.reflections > 0 && s.time > 0.1);
    return sim;
}

START_TEST(a_restored_run_goes_on_bit_for_bit)
{
    sph2d_sim *went_on = run_to_the_middle(), *restored = NULL;
    test_state state = test_state_copy(went_on);
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = _i + 1;
    ck_assert_int_eq(sph2d_sim_restore(&scene, &options, &state.state, &restored, NULL), SPH2D_OK);
    test_state_free(&state); /* it was copied */
    test_same(went_on, restored, "restored");
    run(went_on, 50);
    run(restored, 50);
    test_same(went_on, restored, "restored");
    sph2d_sim_destroy(went_on);
    sph2d_sim_destroy(restored);
}
END_TEST

/* Fitted operators step by the rates of two steps before, which the first steps do not have. */
START_TEST(a_restored_vortex_goes_on_bit_for_bit)
{
    scene = test_scene(DX, 0, 0, 1, 1);
    scene.boundary =
        (sph2d_boundary){SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC};
    scene.fluid.dynamic_viscosity = 10;
    scene.method = sph2d_scene_default().method;
    scene.method.name = SPH2D_METHOD_WCSPH;
    scene.method.operators = SPH2D_OPERATORS_FITTED;
    scene.method.sound_speed = 10;
    block = test_block(0, 0, 1, 1);
    block.perturb.amplitude = 0.2;
    block.start.flow.kind = SPH2D_FLOW_TAYLOR_GREEN;
    block.start.flow.speed = 1;
    block.start.flow.length = 1;
    scene.blocks = &block;
    scene.block_count = 1;
    scene.probes = probes;
    scene.probe_count = 2;
    sph2d_sim *went_on = test_create(&scene, NULL), *restored = NULL;
    run(went_on, _i);
    test_state state = test_state_copy(went_on);
    ck_assert_int_eq(sph2d_sim_restore(&scene, NULL, &state.state, &restored, NULL), SPH2D_OK);
    test_state_free(&state);
    for (int n = 0; n < 3; ++n) {
        run(went_on, 2);
        run(restored, 2);
        test_same(went_on, restored, "restored");
    }
    sph2d_sim_destroy(went_on);
    sph2d_sim_destroy(restored);
}
END_TEST

START_TEST(the_state_at_the_start_and_of_nothing)
{
    scene.block_count = 0; /* sources alone: no particle yet */
    for (int steps = 0; steps < 3; ++steps) {
        sph2d_sim *went_on = test_create(&scene, NULL), *restored = NULL;
        run(went_on, steps);
        test_state state = test_state_copy(went_on);
        ck_assert_int_eq(sph2d_sim_restore(&scene, NULL, &state.state, &restored, NULL), SPH2D_OK);
        run(went_on, 20);
        run(restored, 20);
        test_same(went_on, restored, "restored");
        test_state_free(&state);
        sph2d_sim_destroy(went_on);
        sph2d_sim_destroy(restored);
    }
}
END_TEST

/** Without arrays of walls the liquid goes on among those of the scene: one more, where a block was at the start and
 *  liquid is no more, and an obstacle that has moved. */
START_TEST(a_state_without_walls_takes_those_of_the_scene)
{
    obstacles[1].motion.amplitude = (sph2d_vec2){0.05, 0};
    obstacles[1].motion.frequency = 1;
    sph2d_sim *sim = run_to_the_middle(), *walled = NULL;
    const sph2d_shape corner = {.kind = SPH2D_SHAPE_BOX, .box = {{0, 0}, {0.4, 0.5}}};
    ck_assert_int_eq(sph2d_sim_remove_particles(sim, &corner, NULL), SPH2D_OK);
    const sph2d_state whole = sph2d_sim_state(sim);
    sph2d_array arrays[200];
    sph2d_state state = {whole.version, arrays, 0};
    ck_assert_uint_lt(whole.array_count, 200);
    for (size_t i = 0; i < whole.array_count; ++i)
        if (whole.arrays[i].group != SPH2D_GROUP_WALL)
            arrays[state.array_count++] = whole.arrays[i];
    static const sph2d_vec2 drawn[3] = {{0.1, 0.3}, {0.2, 0.2}, {0.3, 0.3}};
    sph2d_obstacle all[3] = {obstacles[0], obstacles[1], sph2d_obstacle_default()};
    all[2].shape.kind = SPH2D_SHAPE_POLYLINE;
    all[2].shape.points = (sph2d_points){drawn, 3};
    all[2].liquid = SPH2D_LIQUID_BOTH;
    scene.obstacles = all;
    scene.obstacle_count = 3;
    ck_assert_int_eq(sph2d_sim_restore(&scene, NULL, &state, &walled, NULL), SPH2D_OK);
    const sph2d_view a = sph2d_sim_fluid(sim), b = sph2d_sim_fluid(walled);
    ck_assert_uint_eq(a.count, b.count);
    ck_assert_mem_eq(a.x, b.x, a.count * sizeof *a.x);
    ck_assert_uint_gt(sph2d_field(walled, SPH2D_GROUP_WALL, 0).count, sph2d_field(sim, SPH2D_GROUP_WALL, 0).count);
    ck_assert(sph2d_sim_time(sim) == sph2d_sim_time(walled));
    test_steps(walled, 50);
    sph2d_sim_destroy(walled);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(the_state_keeps_its_instruction_set)
{
    sph2d_sim_options options = sph2d_sim_options_default();
    options.isa = SPH2D_ISA_BASELINE;
    sph2d_sim *went_on = test_create(&scene, &options), *restored = NULL;
    run(went_on, 5);
    test_state state = test_state_copy(went_on);
    ck_assert_int_eq(sph2d_sim_restore(&scene, NULL, &state.state, &restored, NULL), SPH2D_OK);
    ck_assert_int_eq(sph2d_sim_isa(restored), SPH2D_ISA_BASELINE);
    run(went_on, 20);
    run(restored, 20);
    test_same(went_on, restored, "restored");
    test_state_free(&state);
    sph2d_sim_destroy(went_on);
    sph2d_sim_destroy(restored);
}
END_TEST

/* ---- states that are refused ------------------------------------------------------------------------------------- */

/** Whether a changed state is refused as no state of this scene, without a simulation. */
static bool refused(const test_state *state)
{
    static sph2d_report report;
    sph2d_report_clear(&report);
    sph2d_sim *sim = (sph2d_sim *)&scene;
    sph2d_status status = sph2d_sim_restore(&scene, NULL, &state->state, &sim, &report);
    bool good = status == SPH2D_FORMAT && sim == NULL && report.errors > 0;
    if (status == SPH2D_OK)
        sph2d_sim_destroy(sim);
    return good;
}

static test_state sound_state(void)
{
    sph2d_sim *sim = run_to_the_middle();
    test_state state = test_state_copy(sim);
    sph2d_sim_destroy(sim);
    return state;
}

START_TEST(every_array_must_be_there_whole)
{
    test_state state = sound_state();
    ck_assert(!refused(&state));
    for (size_t i = 0; i < state.count; ++i) {
        sph2d_array *array = &state.arrays[i], good = *array;
        array->name = "Nothing";
        ck_assert_msg(refused(&state), "%s missing", good.name);
        *array = good;
        array->group = (sph2d_group)((good.group + 1) % 3);
        ck_assert_msg(refused(&state), "%s in another group", good.name);
        *array = good;
        array->count = good.count - 1;
        ck_assert_msg(refused(&state), "%s too short", good.name);
        *array = good;
        array->count = 0;
        ck_assert_msg(refused(&state), "%s empty", good.name);
        *array = good;
        array->type = good.type == SPH2D_F64 ? SPH2D_U64 : SPH2D_F64;
        ck_assert_msg(refused(&state), "%s of another type", good.name);
        *array = good;
        array->components = 3 - good.components;
        ck_assert_msg(refused(&state), "%s with other components", good.name);
        *array = good;
        array->data[good.components - 1] = NULL;
        ck_assert_msg(refused(&state), "%s without data", good.name);
        *array = good;
    }
    ck_assert(!refused(&state));
    for (size_t count = 0; count < state.count; ++count) {
        state.state.array_count = count;
        ck_assert_msg(refused(&state), "%zu arrays", count);
    }
    state.state.array_count = state.count;
    state.state.version = SPH2D_STATE_VERSION + 1;
    ck_assert(refused(&state));
    state.state.version = 0;
    ck_assert(refused(&state));
    test_state_free(&state);
}
END_TEST

START_TEST(every_number_must_be_finite)
{
    test_state state = sound_state();
    static const double bad[3] = {NAN, INFINITY, -INFINITY};
    for (size_t i = 0; i < state.count; ++i) {
        const sph2d_array *array = &state.arrays[i];
        if (array->type != SPH2D_F64)
            continue;
        for (unsigned c = 0; c < array->components; ++c) {
            double *values = test_state_reals(&state, array->group, array->name, c);
            size_t last = array->stride ? array->count - 1 : 0, places[2] = {0, last};
            for (int k = 0; k < 6; ++k) {
                double good = values[places[k / 3]];
                values[places[k / 3]] = bad[k % 3];
                ck_assert_msg(refused(&state), "%s with %g", array->name, bad[k % 3]);
                values[places[k / 3]] = good;
            }
        }
    }
    ck_assert(!refused(&state));
    test_state_free(&state);
}
END_TEST

/** Numbers of the run that no run can have. */
static const struct {
    const char *name;
    double real;
    uint64_t count; /**< where it is a count */
} out_of_range[] = {
    {"Time", -1, 0},
    {"NextTimeStep", 0, 0},
    {"NextTimeStep", -1e-4, 0},
    {"LastTimeStep", -1e-4, 0},
    {"OlderTimeStep", -1e-4, 0},
    {"PointerRadius", -0.1, 0}, /* sph2d_sim_set_pointer refuses it too */
    {"InstructionSet", 0, 0},
    {"InstructionSet", 0, 4},
    {"InstructionSet", 0, UINT64_MAX},
    {"NextLimit", 0, 4},
    {"NextLimit", 0, UINT64_MAX},
};
enum { RANGES = sizeof out_of_range / sizeof out_of_range[0] };

START_TEST(numbers_of_the_run_must_be_in_range)
{
    test_state state = sound_state();
    const char *name = out_of_range[_i].name;
    if (test_state_array(&state, SPH2D_GROUP_RUN, name)->type == SPH2D_F64)
        test_state_reals(&state, SPH2D_GROUP_RUN, name, 0)[0] = out_of_range[_i].real;
    else
        test_state_counts(&state, SPH2D_GROUP_RUN, name)[0] = out_of_range[_i].count;
    ck_assert_msg(refused(&state), "%s is accepted", name);
    test_state_free(&state);
}
END_TEST

START_TEST(densities_must_be_positive)
{
    test_state state = sound_state();
    double *density = test_state_reals(&state, SPH2D_GROUP_FLUID, "Densities", 0), good = density[3];
    density[3] = 0;
    ck_assert(refused(&state));
    density[3] = -1000;
    ck_assert(refused(&state));
    density[3] = good;
    ck_assert(!refused(&state));
    test_state_free(&state);
}
END_TEST

START_TEST(places_must_be_near_and_in_order)
{
    test_state state = sound_state();
    size_t last = test_state_array(&state, SPH2D_GROUP_FLUID, "Coordinates")->count - 1;
    for (unsigned c = 0; c < 2; ++c) {
        double *x = test_state_reals(&state, SPH2D_GROUP_FLUID, "Coordinates", c), good = x[last];
        x[last] = c == 0 ? 1e9 : -1e9;
        ck_assert(refused(&state));
        x[last] = good;
    }
    ck_assert(!refused(&state));
    for (unsigned c = 0; c < 2; ++c) { /* the first and the last, in other cells, change places */
        double *x = test_state_reals(&state, SPH2D_GROUP_FLUID, "Coordinates", c), first = x[0];
        x[0] = x[last];
        x[last] = first;
    }
    ck_assert(refused(&state)); /* densities and pressures would be those of the other */
    test_state_free(&state);
}
END_TEST

/* They are indices when the walls are sorted. */
START_TEST(numbers_of_walls_must_be_theirs)
{
    test_state state = sound_state();
    uint64_t *ids = test_state_counts(&state, SPH2D_GROUP_WALL, "ParticleIDs"), good = ids[1];
    const uint64_t bad[] = {ids[0], good + 1, 1 << 20, UINT64_MAX};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        ids[1] = bad[i];
        ck_assert_msg(refused(&state), "%llu", (unsigned long long)bad[i]);
    }
    ids[1] = good;
    ck_assert(!refused(&state));
    test_state_free(&state);
}
END_TEST

START_TEST(a_state_of_another_scene_is_refused)
{
    test_state state = sound_state();
    sph2d_scene good = scene;
    scene.source_count = 1;
    ck_assert(refused(&state));
    scene = good;
    scene.probe_count = 1;
    ck_assert(refused(&state));
    scene = good;
    scene.obstacle_count = 1;
    ck_assert(refused(&state));
    scene = good;
    line[1].x += 1e-6; /* the same number of boundary particles, elsewhere */
    ck_assert(refused(&state));
    line[1].x = 0.7;
    ck_assert(!refused(&state));
    test_state_free(&state);
}
END_TEST

START_TEST(a_wrong_scene_is_told_apart)
{
    test_state state = sound_state();
    sph2d_sim *sim = (sph2d_sim *)&scene;
    scene.spacing = -1;
    ck_assert_int_eq(sph2d_sim_restore(&scene, NULL, &state.state, &sim, NULL), SPH2D_SCENE);
    ck_assert_ptr_null(sim);
    test_state_free(&state);
}
END_TEST

Suite *suite_state(void)
{
    Suite *suite = suite_create("state");
    TCase *tests = tcase_create("state");
    tcase_add_checked_fixture(tests, start, NULL);
    tcase_add_loop_test(tests, a_restored_run_goes_on_bit_for_bit, 0, 2);
    tcase_add_loop_test(tests, a_restored_vortex_goes_on_bit_for_bit, 0, 4);
    tcase_add_test(tests, the_state_at_the_start_and_of_nothing);
    tcase_add_test(tests, a_state_without_walls_takes_those_of_the_scene);
    tcase_add_test(tests, the_state_keeps_its_instruction_set);
    tcase_add_test(tests, every_number_must_be_finite);
    tcase_add_loop_test(tests, numbers_of_the_run_must_be_in_range, 0, RANGES);
    tcase_add_test(tests, densities_must_be_positive);
    tcase_add_test(tests, places_must_be_near_and_in_order);
    tcase_add_test(tests, numbers_of_walls_must_be_theirs);
    tcase_add_test(tests, a_state_of_another_scene_is_refused);
    tcase_add_test(tests, a_wrong_scene_is_told_apart);
    suite_add_tcase(suite, tests);
    TCase *slow = test_long(suite);
    tcase_add_checked_fixture(slow, start, NULL);
    tcase_add_test(slow, every_array_must_be_there_whole);
    return suite;
}
