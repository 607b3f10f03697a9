/* SPDX-License-Identifier: MIT */
/** @file test_bodies_carried.c
 *  Walls that move bodies by contact: their work is what the bodies gain and what friction takes, in the balance and in
 *  probes, and goes on after resuming. */
#include <math.h>
#include <string.h>

#include "common.h"
#include "sim/simulation.h"
#include "sph2d/contacts.h"

#define MASS (2500 * 0.3 * 0.24)
#define GRAVITY 9.81

enum { WALL, ALL, FLOOR, PROBES };

static struct {
    sph2d_scene scene;
    sph2d_block block;
    sph2d_obstacle walls[2], *wall; /**< a post that rests, and the wall that moves */
    sph2d_body stone;
    sph2d_probe probes[PROBES];
} dry;

/** A stone at (x, y), its lower left corner, and a wall, far from a drop that rests between the sides of a trough. */
static void start_dry(sph2d_method method, double x, double y)
{
    static const char *const names[PROBES] = {"wall", "all", "floor"}, *const on[PROBES] = {"wall", NULL, "bottom"};
    dry.scene = test_scene(0.04, 0, 0, 2, 2);
    dry.scene.method.name = method;
    dry.scene.method.sound_speed = 20;
    dry.scene.method.stiffness = 0;
    dry.scene.gravity = (sph2d_vec2){0, -GRAVITY};
    dry.block = test_block(0, 0, 0.16, 0.04);
    dry.scene.blocks = &dry.block;
    dry.scene.block_count = 1;
    dry.walls[0] = dry.walls[1] = sph2d_obstacle_default();
    dry.walls[0].shape = (sph2d_shape){.kind = SPH2D_SHAPE_CIRCLE, .circle = {{0.3, 1.7}, 0.1}};
    dry.wall = &dry.walls[1];
    dry.wall->name = "wall";
    dry.scene.obstacles = dry.walls;
    dry.scene.obstacle_count = 2;
    dry.stone = sph2d_body_default();
    dry.stone.density = 2500;
    dry.stone.shape = (sph2d_shape){.kind = SPH2D_SHAPE_BOX, .box = {{x, y}, {x + 0.3, y + 0.24}}};
    dry.scene.bodies = &dry.stone;
    dry.scene.body_count = 1;
    for (int k = 0; k < PROBES; ++k) {
        dry.probes[k] = sph2d_probe_default();
        dry.probes[k].kind = SPH2D_PROBE_WORK;
        dry.probes[k].name = names[k];
        dry.probes[k].on = on[k];
        dry.probes[k].rate.every = 0.01;
    }
    dry.scene.probes = dry.probes;
    dry.scene.probe_count = PROBES;
}

/** A lift that rises from rest, with the stone on it, a clearance above. */
static void start_lift(sph2d_method method)
{
    start_dry(method, 0.9, 0.5 + 0.2 * 0.04);
    dry.wall->shape = (sph2d_shape){.kind = SPH2D_SHAPE_BOX, .box = {{0.8, 0.3}, {1.4, 0.5}}};
    dry.wall->motion.amplitude.y = 0.3;
    dry.wall->motion.frequency = 0.25;
    dry.wall->motion.phase = -TEST_PI / 2;
}

/** A ram that pushes the stone along the floor by half a metre, from rest to rest. */
static void start_ram(sph2d_method method)
{
    start_dry(method, 0.8 + 0.2 * 0.04, 0.2 * 0.04);
    dry.wall->shape = (sph2d_shape){.kind = SPH2D_SHAPE_BOX, .box = {{0.6, 0.04}, {0.8, 0.4}}};
    dry.wall->motion.amplitude.x = 0.25;
    dry.wall->motion.frequency = 0.5;
    dry.wall->motion.phase = -TEST_PI / 2;
}

static sph2d_sim *create(void)
{
    if (dry.scene.method.name == SPH2D_METHOD_CONSTRAINT)
        dry.scene.method.time_step = 0.002; /* contacts act once a step, half of which gravity is ahead */
    sph2d_sim *sim = test_create(&dry.scene, NULL);
    ck_assert_int_eq(sph2d_contacts_attach(sim), SPH2D_OK);
    return sim;
}

static sph2d_sim *run_to(double time)
{
    sph2d_sim *sim = create();
    while (sph2d_sim_time(sim) < time)
        test_steps(sim, 1);
    return sim;
}

static double work_on(sph2d_sim *sim, size_t probe)
{
    double values[SPH2D_PROBE_MAX_COLUMNS] = {0};
    ck_assert_uint_eq(sph2d_sim_probe(sim, probe, values), 2);
    return values[1];
}

/** The balance closes, and all work of walls is that of this one. */
static void check_balance(sph2d_sim *sim, const sph2d_summary *s)
{
    double all = s->energy_scale + s->energy_walls;
    ck_assert_double_le(fabs(s->energy_error), 1e-3 * all);
    ck_assert_double_le(s->energy_rise, 1e-3 * all);
    ck_assert_double_eq_tol(work_on(sim, WALL), s->energy_walls, 1e-9 * s->energy_walls);
    ck_assert_double_eq_tol(work_on(sim, ALL), s->energy_walls, 1e-9 * s->energy_walls);
    ck_assert_double_eq(work_on(sim, FLOOR), 0);
}

START_TEST(a_lift_brings_height_and_speed)
{
    start_lift((sph2d_method)_i);
    sph2d_sim *sim = run_to(1); /* half way up, where it is fastest */
    sph2d_summary s = sph2d_sim_summary(sim);
    double rise = sph2d_sim_body(sim, 0).center.y - (0.5 + 0.2 * 0.04 + 0.12), speed = 0.3 * TEST_PI / 2;
    double gained = MASS * (GRAVITY * rise + speed * speed / 2);
    ck_assert_double_eq_tol(rise, 0.3, 0.01);
    ck_assert_double_eq_tol(s.energy_walls, gained, 0.01 * gained);
    ck_assert_double_eq_tol(s.energy_contacts, 0, 1e-3 * gained);
    check_balance(sim, &s);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(a_ram_brings_what_friction_takes)
{
    start_ram((sph2d_method)_i);
    sph2d_sim *sim = run_to(1.3); /* at rest again */
    sph2d_summary s = sph2d_sim_summary(sim);
    double way = sph2d_sim_body(sim, 0).center.x - (0.8 + 0.2 * 0.04 + 0.15);
    double rubbed = dry.stone.friction * MASS * GRAVITY * way;
    ck_assert_double_eq_tol(way, 0.52, 0.03);                       /* it goes on where the ram slows down */
    ck_assert_double_eq_tol(s.energy_walls, rubbed, 0.05 * rubbed); /* the ram's face bears some of the weight */
    ck_assert_double_eq_tol(s.energy_contacts, s.energy_walls, 1e-3 * rubbed);
    check_balance(sim, &s);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(resuming_changes_no_bit_of_the_work)
{
    start_lift((sph2d_method)_i);
    sph2d_sim *whole = run_to(0.3), *rest = NULL;
    test_state state = test_state_copy(whole);
    ck_assert_int_eq(sph2d_sim_restore(&dry.scene, NULL, &state.state, &rest, NULL), SPH2D_OK);
    ck_assert_int_eq(sph2d_contacts_attach(rest), SPH2D_OK);
    test_steps(whole, 100);
    test_steps(rest, 100);
    sph2d_summary a = sph2d_sim_summary(whole), b = sph2d_sim_summary(rest);
    sph2d_body_state here = sph2d_sim_body(whole, 0), there = sph2d_sim_body(rest, 0);
    ck_assert_double_gt(a.energy_walls, 1);
    ck_assert(a.energy_walls == b.energy_walls && a.energy_contacts == b.energy_contacts);
    ck_assert(a.energy_error == b.energy_error && a.energy_rise == b.energy_rise);
    ck_assert(memcmp(&here, &there, sizeof here) == 0);
    for (size_t k = 0; k < PROBES; ++k)
        ck_assert(work_on(whole, k) == work_on(rest, k));
    test_state_free(&state);
    sph2d_sim_destroy(rest);
    sph2d_sim_destroy(whole);
}
END_TEST

/** An engine of a program, which lifts what falls to a speed that it tells, or keeps to itself. */
typedef struct engine {
    double speed;
    bool tells;
} engine;

static sph2d_status lift(void *user, const sph2d_sim *sim, double dt, sph2d_contact_body *bodies, size_t count,
                         double *wall_work)
{
    const engine *e = user;
    ck_assert_uint_eq(count, sph2d_sim_scene(sim)->body_count);
    ck_assert_double_gt(dt, 0);
    for (size_t k = 0; k < 6; ++k)
        ck_assert_double_eq(wall_work[k], 0);
    double impulse = fmax(0, e->speed - bodies[0].velocity.y) / bodies[0].inverse_mass_y;
    bodies[0].velocity.y += impulse * bodies[0].inverse_mass_y;
    wall_work[4 + 1] += e->tells ? impulse * e->speed : 0;
    return SPH2D_OK;
}

START_TEST(what_an_engine_tells_is_work_of_the_wall)
{
    engine e = {0.5, _i};
    start_lift(SPH2D_METHOD_WCSPH);
    dry.scene.run.max_energy_rise = 10;
    sph2d_sim *sim = test_create(&dry.scene, NULL);
    ck_assert_int_eq(sph2d_sim_set_contacts(sim, lift, &e), SPH2D_OK);
    double time = 0;
    for (; time < 0.1; time = sph2d_sim_time(sim))
        test_steps(sim, 1);
    sph2d_summary s = sph2d_sim_summary(sim);
    double gained = MASS * e.speed * (e.speed / 2 + GRAVITY * time), lost = MASS * e.speed * e.speed / 2;
    ck_assert_double_eq_tol(s.energy_walls, e.tells ? gained + lost : 0, 0.05 * gained);
    ck_assert_double_eq_tol(s.energy_contacts, e.tells ? lost : -gained, 0.05 * gained);
    ck_assert_double_eq_tol(work_on(sim, WALL), s.energy_walls, 1e-9 * gained);
    if (e.tells)
        ck_assert_double_le(s.energy_rise, 1e-3 * s.energy_scale);
    else
        ck_assert_double_ge(s.energy_rise, 0.5 * gained);
    sph2d_sim_destroy(sim);
}
END_TEST

Suite *suite_bodies_carried(void)
{
    Suite *suite = suite_create("bodies_carried");
    TCase *tests = tcase_create("bodies_carried");
    tcase_add_loop_test(tests, a_lift_brings_height_and_speed, 0, SPH2D_METHOD_CONSTRAINT + 1);
    tcase_add_loop_test(tests, a_ram_brings_what_friction_takes, 0, SPH2D_METHOD_CONSTRAINT + 1);
    tcase_add_loop_test(tests, resuming_changes_no_bit_of_the_work, 0, SPH2D_METHOD_CONSTRAINT + 1);
    tcase_add_loop_test(tests, what_an_engine_tells_is_work_of_the_wall, 0, 2);
    suite_add_tcase(suite, tests);
    return suite;
}
