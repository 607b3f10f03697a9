/* SPDX-License-Identifier: MIT */
/** @file test_loads.c
 *  Forces on walls: with gravity they are the change of the liquid's momentum, step by step, by every method and with
 *  every form of wall. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "common.h"
#include "sim/simulation.h"

enum { LEFT, RIGHT, BOTTOM, POST, ALL, LIFT, PROBES };

static struct {
    sph2d_scene scene;
    sph2d_block block;
    sph2d_obstacle post;
    sph2d_probe probes[PROBES];
} flood;

/** A column that falls against a post which swings. */
static void flood_start(void)
{
    static const char *const names[PROBES] = {"left", "right", "bottom", "post", NULL, "post"};
    flood.scene = test_scene(0.04, 0, 0, 1, 1);
    flood.scene.method.name = SPH2D_METHOD_WCSPH;
    flood.scene.gravity = (sph2d_vec2){0, -9.81};
    flood.scene.boundary.top = SPH2D_SIDE_OPEN;
    flood.block = test_block(0, 0, 0.4, 0.64);
    flood.block.velocity = (sph2d_vec2){1, 0};
    flood.scene.blocks = &flood.block;
    flood.scene.block_count = 1;
    flood.post = sph2d_obstacle_default();
    flood.post.name = "post";
    flood.post.shape = (sph2d_shape){.kind = SPH2D_SHAPE_CIRCLE, .circle = {{0.6, 0.3}, 0.12}};
    flood.post.motion = (sph2d_motion){.amplitude = {0.03, 0.02}, .frequency = 2};
    flood.scene.obstacles = &flood.post;
    flood.scene.obstacle_count = 1;
    for (int k = 0; k < PROBES; ++k) {
        static char text[PROBES][8];
        flood.probes[k] = sph2d_probe_default();
        snprintf(text[k], sizeof text[k], "probe%d", k);
        flood.probes[k].name = text[k];
        flood.probes[k].kind = k == LIFT ? SPH2D_PROBE_WORK : SPH2D_PROBE_FORCE;
        flood.probes[k].on = names[k];
        flood.probes[k].rate.every = 0.01;
    }
    flood.scene.probes = flood.probes;
    flood.scene.probe_count = PROBES;
}

static sph2d_vec2 momentum_of(const sph2d_sim *sim)
{
    const sph2d__store *f = &sim->system.fluid;
    sph2d_vec2 sum = {0, 0};
    for (size_t i = 0; i < f->count; ++i) {
        sum.x += sim->system.mass * f->vx[i];
        sum.y += sim->system.mass * f->vy[i];
    }
    return sum;
}

/** The values of a probe; the next impulses are from now on. */
static void read(sph2d_sim *sim, size_t probe, double values[SPH2D_PROBE_MAX_COLUMNS])
{
    ck_assert_uint_eq(sph2d_sim_probe(sim, probe, values), probe == LIFT ? 2 : 12);
    sph2d_sim_output_done(sim, SPH2D_OUTPUT_PROBE + probe);
}

static const struct {
    const char *name;
    sph2d_method method;
    sph2d_wall_form sides, post;
    sph2d_slip slip;
    double tension;
} kinds[] = {
    {"wcsph", SPH2D_METHOD_WCSPH, SPH2D_WALL_GENERALISED, SPH2D_WALL_GENERALISED, SPH2D_SLIP_FREE, 0},
    {"wcsph, no slip", SPH2D_METHOD_WCSPH, SPH2D_WALL_GENERALISED, SPH2D_WALL_GENERALISED, SPH2D_SLIP_NONE, 0},
    {"wcsph, smooth", SPH2D_METHOD_WCSPH, SPH2D_WALL_GENERALISED, SPH2D_WALL_GENERALISED, SPH2D_SLIP_SMOOTH, 0},
    {"wcsph, tension", SPH2D_METHOD_WCSPH, SPH2D_WALL_GENERALISED, SPH2D_WALL_GENERALISED, SPH2D_SLIP_FREE, 5},
    {"muller", SPH2D_METHOD_MULLER, SPH2D_WALL_SPRING, SPH2D_WALL_HEAVY, SPH2D_SLIP_FREE, 0},
    {"muller, heavy", SPH2D_METHOD_MULLER, SPH2D_WALL_HEAVY, SPH2D_WALL_HEAVY, SPH2D_SLIP_FREE, 0},
    {"muller, reflect", SPH2D_METHOD_MULLER, SPH2D_WALL_REFLECT, SPH2D_WALL_REFLECT, SPH2D_SLIP_FREE, 5},
    {"pcisph", SPH2D_METHOD_PCISPH, SPH2D_WALL_GENERALISED, SPH2D_WALL_GENERALISED, SPH2D_SLIP_FREE, 0},
    {"constraint", SPH2D_METHOD_CONSTRAINT, SPH2D_WALL_GENERALISED, SPH2D_WALL_GENERALISED, SPH2D_SLIP_FREE, 0},
    {"constraint, tension", SPH2D_METHOD_CONSTRAINT, SPH2D_WALL_GENERALISED, SPH2D_WALL_GENERALISED, SPH2D_SLIP_FREE,
     5},
};

static sph2d_sim *flood_of(int kind, int threads)
{
    flood_start();
    flood.scene.method.name = kinds[kind].method;
    flood.scene.walls = kinds[kind].sides;
    flood.post.form = kinds[kind].post;
    flood.scene.wall_slip = kinds[kind].slip;
    flood.scene.fluid.surface_tension = kinds[kind].tension;
    flood.scene.fluid.dynamic_viscosity = 0.5;
    flood.post.motion.angle = 0.05; /* about a point beside its centre */
    flood.post.motion.rate = 0.4;
    flood.post.motion.center = (sph2d_vec2){0.62, 0.33};
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = threads;
    return test_create(&flood.scene, &options);
}

START_TEST(forces_are_the_change_of_momentum)
{
    sph2d_sim *sim = flood_of(_i, 2);
    double values[SPH2D_PROBE_MAX_COLUMNS], largest = 0;
    double scale = sim->system.mass * (double)sim->system.fluid.count * sqrt(2 * sim->system.head);
    for (int step = 0; step < 300 && sph2d_sim_time(sim) < 0.6; ++step) {
        sph2d_vec2 before = momentum_of(sim);
        double count = (double)sim->system.fluid.count, x = 0, y = 0;
        for (int k = 0; k < PROBES; ++k)
            sph2d_sim_output_done(sim, SPH2D_OUTPUT_PROBE + (size_t)k);
        test_steps(sim, 1);
        ck_assert_uint_eq(sim->system.fluid.count, (size_t)count);
        sph2d_vec2 after = momentum_of(sim);
        for (size_t k = LEFT; k <= POST; ++k) {
            read(sim, k, values);
            x += values[9];
            y += values[10];
        }
        double dt = sim->record.last_step, gravity = -9.81 * dt * count * sim->system.mass;
        double error_x = after.x - before.x + x, error_y = after.y - before.y + y - gravity;
        largest = fmax(largest, fmax(fabs(error_x), fabs(error_y)) / scale);
        read(sim, ALL, values);
        ck_assert_double_eq_tol(values[9], x, 1e-12 * scale);
        ck_assert_double_eq_tol(values[10], y, 1e-12 * scale);
    }
    /* Where liquid sticks, velocities are floats in the sum of forces. */
    ck_assert_msg(largest < (_i == 1 ? 1e-9 : 1e-10), "%s: %g", kinds[_i].name, largest);
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- known answers ----------------------------------------------------------------------------------------------- */

/** A scene with one particle that flies at a wall, and a probe. */
static sph2d_sim *fly(sph2d_probe *probe, sph2d_block *particle, sph2d_vec2 at, sph2d_vec2 v)
{
    flood.scene = test_scene(0.1, 0, 0, 2, 2);
    flood.scene.walls = SPH2D_WALL_REFLECT;
    flood.scene.method.name = SPH2D_METHOD_MULLER;
    *particle = test_particle(0.1, at.x, at.y, v.x, v.y);
    flood.scene.blocks = particle;
    flood.scene.block_count = 1;
    flood.scene.probes = probe;
    flood.scene.probe_count = 1;
    return test_create(&flood.scene, NULL);
}

START_TEST(a_stop_is_an_impulse_at_its_place)
{
    sph2d_probe probe = sph2d_probe_default();
    probe.name = "push";
    probe.kind = SPH2D_PROBE_FORCE;
    probe.on = "right";
    probe.at = (sph2d_vec2){2, 0.25};
    probe.rate.every = 1;
    sph2d_block block;
    sph2d_sim *sim = fly(&probe, &block, (sph2d_vec2){1.5, 1}, (sph2d_vec2){3, 0});
    double values[SPH2D_PROBE_MAX_COLUMNS], m = sim->system.mass, impulse = 0, turn = 0;
    for (int k = 0; k < 4000 && sim->system.fluid.vx[0] > -1e-3; ++k) {
        double before = sim->system.fluid.vx[0];
        test_steps(sim, 1);
        read(sim, 0, values);
        ck_assert_double_eq_tol(values[7] * sim->record.last_step, m * (before - sim->system.fluid.vx[0]), 1e-8 * m);
        ck_assert_double_eq_tol(values[0], values[7], 1e-12 * m);
        impulse += values[9];
        turn += values[11];
    }
    /* From 3 m/s to -1.5 with restitution 0.5, 0.75 m above the point; clockwise is negative. */
    ck_assert_double_eq_tol(impulse, 4.5 * m, 1e-8 * m);
    ck_assert_double_eq_tol(turn, -0.75 * 4.5 * m, 1e-8 * m);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(a_column_weighs_on_its_floor_and_leans_on_its_sides)
{
    const sph2d_method methods[] = {SPH2D_METHOD_WCSPH, SPH2D_METHOD_MULLER, SPH2D_METHOD_PCISPH,
                                    SPH2D_METHOD_CONSTRAINT};
    flood.scene = test_scene(0.05, 0, 0, 1, 1.2);
    flood.scene.gravity = (sph2d_vec2){0, -9.81};
    flood.scene.boundary.top = SPH2D_SIDE_OPEN;
    flood.scene.method = sph2d_scene_default().method;
    flood.scene.method.name = methods[_i];
    flood.scene.fluid.dynamic_viscosity = 20;
    flood.block = test_block(0, 0, 1, 1);
    flood.scene.blocks = &flood.block;
    flood.scene.block_count = 1;
    enum { COUNT = 4 };
    static const char *const names[COUNT] = {"left", "right", "bottom", "all"};
    for (int k = 0; k < COUNT; ++k) {
        flood.probes[k] = sph2d_probe_default();
        flood.probes[k].name = names[k];
        flood.probes[k].on = k < 3 ? names[k] : NULL;
        flood.probes[k].kind = SPH2D_PROBE_FORCE;
        flood.probes[k].rate.every = 1;
    }
    flood.scene.probes = flood.probes;
    flood.scene.probe_count = COUNT;
    sph2d_sim *sim = test_create(&flood.scene, NULL);
    double values[SPH2D_PROBE_MAX_COLUMNS], start = 0.6, weight = 9810, lean = weight / 2;
    while (sim->record.time < start)
        test_steps(sim, 1);
    for (size_t k = 0; k < COUNT; ++k)
        sph2d_sim_output_done(sim, SPH2D_OUTPUT_PROBE + k);
    start = sim->record.time;
    double before = momentum_of(sim).y; /* the column rings */
    while (sim->record.time < 1.2)
        test_steps(sim, 1);
    double span = sim->record.time - start, mean[COUNT] = {0};
    for (size_t k = 0; k < COUNT; ++k) {
        read(sim, k, values);
        mean[k] = (k < 2 ? fabs(values[9]) : before - momentum_of(sim).y - values[10]) / span;
        ck_assert(k > 1 || (k == 0) == (values[9] < 0));
    }
    /* The sides carry a little, as liquid within the support radius of them sees pressures of theirs. */
    ck_assert_msg(fabs(mean[2] - weight) < 0.03 * weight, "%g", mean[2] / weight);
    ck_assert_msg(fabs(mean[3] - weight) < 1e-9 * weight, "%g", mean[3] / weight);
    const double bound = methods[_i] == SPH2D_METHOD_MULLER ? 0.1 : 0.06; /* it is compressed: its column is lower */
    for (int k = 0; k < 2; ++k)
        ck_assert_msg(fabs(mean[k] - lean) < bound * lean, "%d: %g", k, mean[k] / lean);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(torque_is_about_a_point_that_moves_with_the_wall)
{
    flood_start();
    flood.probes[ALL].on = "post"; /* beside `post`, about another point */
    flood.probes[ALL].at = (sph2d_vec2){0.2, -0.1};
    sph2d_sim *sim = test_create(&flood.scene, NULL);
    double one[SPH2D_PROBE_MAX_COLUMNS], two[SPH2D_PROBE_MAX_COLUMNS];
    /* Each contact is counted in quanta, twice. */
    double quantum = sim->system.mass * sqrt(2 * sim->system.head) * hypot(1, 1) / 4e10;
    for (int k = 0; k < 60; ++k) {
        uint64_t hits = sim->record.backstop_hits;
        test_steps(sim, 4);
        double rounding = (double)(sim->record.backstop_hits - hits) * quantum;
        read(sim, POST, one);
        read(sim, ALL, two);
        ck_assert(one[0] == two[0] && one[1] == two[1] && one[9] == two[9]);
        /* T' = T - r x F with r the way to the other point */
        double shift = 0.2 * one[1] + 0.1 * one[0], turned = 0.2 * one[10] + 0.1 * one[9],
               size = fabs(one[0]) + fabs(one[1]);
        ck_assert_double_eq_tol(two[2], one[2] - shift, 1e-8 * (1 + size));
        ck_assert_double_eq_tol(two[11], one[11] - turned, 1e-10 + rounding);
    }
    ck_assert(one[0] != 0);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(work_is_that_of_the_forces)
{
    sph2d_sim *sim = flood_of((int[]){4, 0, 8}[_i], 1);
    double work[SPH2D_PROBE_MAX_COLUMNS] = {0}, force[SPH2D_PROBE_MAX_COLUMNS] = {0};
    for (int k = 0; k < 400; ++k) {
        test_steps(sim, 1);
        read(sim, LIFT, work);
        read(sim, POST, force);
        const sph2d__load_state *now = &sim->loads.states[sim->loads.of_probe[POST]];
        const sph2d__pose *pose = &sim->moving[0].to; /* where the forces were evaluated last */
        sph2d_vec2 v = sph2d__pose_velocity(pose, sph2d__pose_apply(pose, (sph2d_vec2){0, 0}));
        double power = -v.x * (force[0] - force[7]) - v.y * (force[1] - force[8]) -
                       pose->omega * (now->pressure.torque + now->friction.torque);
        if (_i == 0) /* wcsph has forces of the middle of the step, a method with a projection has moved on since */
            ck_assert_double_eq_tol(work[0], power, 1e-9 * (1 + fabs(force[0]) + fabs(force[1])));
    }
    double booked = sim->record.energy_walls; /* sampled every few steps */
    ck_assert(fabs(booked) > 1);
    ck_assert_msg(fabs(work[1] - booked) < 0.05 * fabs(booked), "%g, booked %g", work[1], booked);
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- states, threads, refusals ----------------------------------------------------------------------------------- */

START_TEST(loads_go_on_after_a_resume_and_on_any_threads)
{
    sph2d_sim *whole = flood_of(_i, 1);
    test_steps(whole, 120);
    test_state state = test_state_copy(whole);
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = 3;
    sph2d_sim *rest = NULL;
    ck_assert_int_eq(sph2d_sim_restore(&flood.scene, &options, &state.state, &rest, NULL), SPH2D_OK);
    for (int k = 0; k < 10; ++k) {
        test_steps(whole, 5);
        test_steps(rest, 5);
        for (size_t probe = 0; probe < PROBES; ++probe) {
            double a[SPH2D_PROBE_MAX_COLUMNS] = {0}, b[SPH2D_PROBE_MAX_COLUMNS] = {0};
            read(whole, probe, a);
            read(rest, probe, b);
            ck_assert_msg(memcmp(a, b, sizeof a) == 0, "%s, probe %zu", kinds[_i].name, probe);
        }
    }
    test_state_free(&state);
    sph2d_sim_destroy(rest);
    sph2d_sim_destroy(whole);
}
END_TEST

/** Then walls count in steps alone whose momentum is balanced: each, by methods whose forces are means over a step, one
 *  of eight by others. */
START_TEST(a_scene_without_such_probes_has_the_load_on_all_walls_alone)
{
    flood_start();
    flood.scene.probe_count = 0;
    flood.scene.method.name = _i ? SPH2D_METHOD_WCSPH : SPH2D_METHOD_MULLER;
    sph2d_sim *sim = test_create(&flood.scene, NULL);
    ck_assert_uint_eq(sim->loads.count, 0);
    test_steps(sim, 7); /* of which the first was */
    ck_assert(sph2d__loads_wanted(sim) == (_i == 1));
    test_steps(sim, 1); /* before the ninth */
    ck_assert(sph2d__loads_wanted(sim));
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(walls_that_are_not_there_are_refused)
{
    static const struct {
        const char *name, *on;
        sph2d_probe_kind kind;
        sph2d_code code;
        const char *path, *text;
    } cases[] = {
        {"post", "past", SPH2D_PROBE_FORCE, SPH2D_CODE_CONFLICT, "probes[0].on", "post"},
        {"post", "nothing of the kind", SPH2D_PROBE_FORCE, SPH2D_CODE_CONFLICT, "probes[0].on",
         "the name of an obstacle, body or side: post, left, right, bottom, top"},
        {"post", "top", SPH2D_PROBE_WORK, SPH2D_CODE_CONFLICT, "probes[0].on", "not a wall"},
        {"post", "post", SPH2D_PROBE_ENERGY, SPH2D_CODE_CONFLICT, "probes[0].on", "force"},
        {"left", "left", SPH2D_PROBE_FORCE, SPH2D_CODE_CONFLICT, "obstacles[0].name", "side"},
        {"a b", "left", SPH2D_PROBE_FORCE, SPH2D_CODE_OUT_OF_RANGE, "obstacles[0].name", "letters"},
        {"", "left", SPH2D_PROBE_FORCE, SPH2D_CODE_OUT_OF_RANGE, "obstacles[0].name", "letters"},
    };
    flood_start();
    flood.scene.probe_count = 1;
    flood.scene.method = sph2d_scene_default().method;
    for (size_t k = 0; k < sizeof cases / sizeof *cases; ++k) {
        flood.post.name = cases[k].name;
        flood.probes[0].on = cases[k].on;
        flood.probes[0].kind = cases[k].kind;
        sph2d_report report = {0};
        ck_assert_int_eq(sph2d_scene_check(&flood.scene, &report), SPH2D_SCENE);
        ck_assert_msg(test_report_has(&report, cases[k].code, cases[k].path) &&
                          strstr(test_report_text(&report), cases[k].text),
                      "%zu: %s", k, test_report_text(&report));
        sph2d_report_clear(&report);
    }
    sph2d_obstacle two[2] = {flood.post, flood.post};
    two[0].name = two[1].name = "post";
    flood.scene.obstacles = two;
    flood.scene.obstacle_count = 2;
    sph2d_report report = {0};
    sph2d_scene_check(&flood.scene, &report);
    ck_assert(test_report_has(&report, SPH2D_CODE_CONFLICT, "obstacles[1].name"));
    sph2d_report_clear(&report);
}
END_TEST

/** Work of a wall that turns about a point at rest is its rate times the torque about that point. */
START_TEST(power_of_a_mill_is_rate_times_torque)
{
    double force[SPH2D_PROBE_MAX_COLUMNS], work[SPH2D_PROBE_MAX_COLUMNS];
    flood_start();
    flood.post.shape = (sph2d_shape){.kind = SPH2D_SHAPE_BOX, .box = {{0.36, 0.2}, {0.8, 0.36}}};
    flood.post.motion = (sph2d_motion){.rate = -5, .center = {0.58, 0.28}};
    flood.probes[POST].at = flood.post.motion.center;
    flood.scene.wall_slip = SPH2D_SLIP_NONE;
    flood.scene.fluid.dynamic_viscosity = 0.5;
    sph2d_sim *sim = test_create(&flood.scene, NULL);
    double largest = 0;
    for (int step = 0; step < 200; ++step) {
        test_steps(sim, 1);
        read(sim, POST, force);
        read(sim, LIFT, work);
        const sph2d__load *load = &sim->loads.items[sim->loads.of_probe[POST]];
        const sph2d__load_state *now = &sim->loads.states[sim->loads.of_probe[POST]];
        double torque = now->pressure.torque + now->friction.torque;
        ck_assert_double_eq_tol(work[0], -load->moving->to.omega * torque, 1e-10 * (1 + fabs(work[0])));
        largest = fmax(largest, fabs(work[0]));
    }
    ck_assert_double_gt(largest, 10);
    sph2d_sim_destroy(sim);
}
END_TEST

Suite *suite_loads(void)
{
    Suite *suite = suite_create("loads");
    TCase *tests = tcase_create("loads");
    const int count = sizeof kinds / sizeof *kinds;
    tcase_add_test(tests, a_stop_is_an_impulse_at_its_place);
    tcase_add_loop_test(tests, a_column_weighs_on_its_floor_and_leans_on_its_sides, 0, 4);
    tcase_add_test(tests, torque_is_about_a_point_that_moves_with_the_wall);
    tcase_add_loop_test(tests, work_is_that_of_the_forces, 0, 3);
    tcase_add_loop_test(tests, a_scene_without_such_probes_has_the_load_on_all_walls_alone, 0, 2);
    tcase_add_test(tests, walls_that_are_not_there_are_refused);
    tcase_add_test(tests, power_of_a_mill_is_rate_times_torque);
    suite_add_tcase(suite, tests);
    TCase *slow = test_long(suite);
    tcase_add_loop_test(slow, forces_are_the_change_of_momentum, 0, count);
    tcase_add_loop_test(slow, loads_go_on_after_a_resume_and_on_any_threads, 0, count);
    return suite;
}
