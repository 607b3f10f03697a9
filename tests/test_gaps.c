/* SPDX-License-Identifier: MIT */
/** @file test_gaps.c
 *  Pressure in gaps between bodies and walls that are too thin for particles (sim/gaps.h). */
#include <math.h>

#include "common.h"
#include "sim/simulation.h"

enum { METHODS = SPH2D_METHOD_CONSTRAINT + 1 };
static const double DX = 0.02, DEPTH = 0.4, DENSITY = 1000, G = 9.81;

static struct {
    sph2d_scene scene;
    sph2d_block block;
    sph2d_body bodies[2];
} tank;

static sph2d_body box(double x0, double y0, double x1, double y1)
{
    sph2d_body body = sph2d_body_default();
    body.shape = (sph2d_shape){.kind = SPH2D_SHAPE_BOX, .box = {{x0, y0}, {x1, y1}}};
    body.density = 500;
    return body;
}

static void hold(sph2d_body *body)
{
    body->hold = (sph2d_hold){SPH2D_SWITCH_ON, SPH2D_SWITCH_ON, SPH2D_SWITCH_ON};
}

/** A box of half the density of water on the floor of a tank of water at rest. */
static void start_tank(int method)
{
    tank.scene = test_scene(DX, 0, 0, 0.8, 0.7);
    tank.scene.gravity = (sph2d_vec2){0, -G};
    tank.scene.method = sph2d_scene_default().method;
    tank.scene.method.name = (sph2d_method)method;
    tank.scene.fluid.dynamic_viscosity = 0.001;
    tank.block = test_block(0, 0, 0.8, DEPTH);
    tank.block.start.flow = (sph2d_flow){.kind = SPH2D_FLOW_STILL, .center = {0, DEPTH}};
    tank.scene.blocks = &tank.block;
    tank.scene.block_count = 1;
    tank.bodies[0] = box(0.3, 0, 0.5, 0.16);
    tank.scene.bodies = tank.bodies;
    tank.scene.body_count = 1;
}

/** The mean force of the liquid and of gaps on a body from 0.3 to 0.6 s. */
static sph2d__twist mean_force(sph2d_sim *sim, size_t body)
{
    sph2d__twist sum = {0, 0, 0};
    int count = 0;
    while (sph2d_sim_time(sim) < 0.6) {
        test_steps(sim, 1);
        if (sph2d_sim_time(sim) < 0.3)
            continue;
        sum = sph2d__twist_add(sum, 1, sim->bodies.items[body].state->pushed);
        ++count;
    }
    return (sph2d__twist){sum.x / count, sum.y / count, sum.turn / count};
}

/* Without gaps: -380 to -470 N/m. Measured parts of the buoyancy: muller 0.48, wcsph 0.68, constraint 0.65,
 * pcisph 1.09. */
START_TEST(a_body_on_the_floor_of_a_full_tank_has_its_buoyancy)
{
    static const double least[METHODS] = {0.4, 0.65, 1, 0.62}, most[METHODS] = {0.8, 1, 1.2, 1};
    start_tank(_i);
    hold(&tank.bodies[0]);
    sph2d_sim *sim = test_create(&tank.scene, NULL);
    sph2d__twist force = mean_force(sim, 0);
    double buoyancy = DENSITY * G * 0.2 * 0.16;
    ck_assert_double_gt(force.y, least[_i] * buoyancy);
    ck_assert_double_lt(force.y, most[_i] * buoyancy);
    ck_assert_double_eq_tol(force.x, 0, 0.02 * buoyancy);
    ck_assert_double_eq_tol(force.turn, 0, 0.02 * 0.2 * buoyancy);
    sph2d_sim_destroy(sim);
}
END_TEST

/** In place of contacts: the floor. */
static sph2d_status stand(void *user, const sph2d_sim *sim, double dt, sph2d_contact_body *bodies, size_t count,
                          double *wall_work)
{
    (void)user, (void)sim, (void)dt, (void)count, (void)wall_work;
    if (bodies[0].center.y <= 0.08)
        bodies[0].velocity.y = fmax(0, bodies[0].velocity.y);
    return SPH2D_OK;
}

/** The energy of all, less the work of gaps [J/m]. */
static double energy_of(const sph2d_sim *sim)
{
    sph2d_summary s = sph2d_sim_summary(sim);
    return s.kinetic + s.potential + s.bodies - s.energy_forces;
}

/* By muller it hovers in a gap that its particles do not enter. */
START_TEST(a_light_body_rises_from_the_floor)
{
    start_tank(_i);
    tank.bodies[0].density = 300;
    sph2d_sim *sim = test_create(&tank.scene, NULL);
    ck_assert_int_eq(sph2d_sim_set_contacts(sim, stand, NULL), SPH2D_OK);
    double start = energy_of(sim);
    while (sph2d_sim_time(sim) < 1.2)
        test_steps(sim, 1);
    ck_assert_double_gt(sph2d_sim_body(sim, 0).center.y, 0.3);
    ck_assert_double_gt(sph2d_sim_summary(sim).energy_forces, 0);
    ck_assert_double_lt(energy_of(sim), start + 1e-3 * sph2d_sim_summary(sim).energy_scale);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(a_gap_with_a_dry_end_has_no_pressure)
{
    start_tank(_i);
    hold(&tank.bodies[0]);
    tank.block = test_block(0, 0, 0.3, DEPTH);
    tank.bodies[0].shape.box = (sph2d_box){{0.3, 0}, {0.5, 0.6}};
    sph2d_sim *sim = test_create(&tank.scene, NULL);
    for (int k = 0; k < 40; ++k) {
        test_steps(sim, 1);
        sph2d__twist gap = sim->bodies.items[0].state->gap;
        ck_assert(gap.x == 0 && gap.y == 0 && gap.turn == 0);
    }
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(a_gap_presses_two_bodies_apart_alike)
{
    start_tank(_i);
    tank.bodies[0] = box(0.2, 0.1, 0.39, 0.26);
    tank.bodies[1] = box(0.394, 0.06, 0.6, 0.3);
    hold(&tank.bodies[0]);
    hold(&tank.bodies[1]);
    tank.scene.body_count = 2;
    sph2d_sim *sim = test_create(&tank.scene, NULL);
    double largest = 0;
    while (sph2d_sim_time(sim) < 0.3) {
        test_steps(sim, 1);
        sph2d__twist a = sim->bodies.items[0].state->gap, b = sim->bodies.items[1].state->gap;
        ck_assert_double_le(a.x, 0); /* the first is on the left */
        ck_assert(fabs(a.x + b.x) <= 1e-12 * fabs(a.x) && fabs(a.y + b.y) <= 1e-12 * fabs(a.x));
        largest = fmax(largest, b.x);
    }
    ck_assert_double_gt(largest, DENSITY * G * 0.2 * DX); /* the mean pressure there, on one piece */
    sph2d_sim_destroy(sim);
}
END_TEST

/* Normals times lengths of a closed outline add up to 0, and their sum of x . n to twice the area (Gauss), whichever way
 * round and wherever it is drawn. */
START_TEST(pieces_lead_outwards)
{
    static const sph2d_vec2 corners[] = {{-0.2, -0.1}, {0.18, -0.13}, {0.1, 0.02}, {0.2, 0.15}, {-0.15, 0.12}};
    enum { COUNT = sizeof corners / sizeof *corners };
    static const sph2d_vec2 places[] = {{0.3, 0.2}, {0.5, 0.55}};
    sph2d_vec2 points[COUNT];
    const bool clockwise = _i % 2;
    const sph2d_vec2 place = places[_i / 2];
    double area = 0, sum = 0, x = 0, y = 0;
    for (int k = 0; k < COUNT; ++k) {
        const sph2d_vec2 c = corners[clockwise ? COUNT - 1 - k : k], a = corners[k], b = corners[(k + 1) % COUNT];
        points[k] = (sph2d_vec2){place.x + c.x, place.y + c.y};
        area += (a.x * b.y - a.y * b.x) / 2;
    }
    start_tank(SPH2D_METHOD_WCSPH);
    tank.bodies[0].shape = (sph2d_shape){.kind = SPH2D_SHAPE_POLYGON, .points = {points, COUNT}};
    sph2d_sim *sim = test_create(&tank.scene, NULL);
    const sph2d__gaps *g = &sim->bodies.gaps;
    for (size_t k = g->first[0]; k < g->first[1]; ++k) {
        const sph2d__gap_piece *piece = &g->pieces[k];
        ck_assert_double_le(hypot(piece->normal.x, piece->normal.y), DX * (1 + 1e-9));
        sum += piece->at.x * piece->normal.x + piece->at.y * piece->normal.y;
        x += piece->normal.x;
        y += piece->normal.y;
    }
    ck_assert_double_eq_tol(x, 0, 1e-12);
    ck_assert_double_eq_tol(y, 0, 1e-12);
    ck_assert_double_eq_tol(sum, 2 * area, 1e-12);
    sph2d_sim_destroy(sim);
}
END_TEST

/* Liquid at rest has the pressure p0 + rho g.x. A film under a box, with liquid at both ends, has it too: its force is the
 * integral over the bottom, W p upwards with the torque rho g_x W^3/12, but for the ends of half a spacing, on which the
 * liquid presses by itself. */
START_TEST(a_gap_has_the_pressure_of_liquid_at_rest)
{
    const double bottom = 0.2 * DX, gx = 2, p0 = 3000, width = 0.2;
    start_tank(SPH2D_METHOD_WCSPH);
    tank.scene.gravity.x = gx;
    tank.bodies[0] = box(0.3, bottom, 0.3 + width, 0.16);
    hold(&tank.bodies[0]);
    const sph2d_block columns[2] = {test_block(0, 0, 0.3, DEPTH), test_block(0.3 + width, 0, 0.8, DEPTH)};
    tank.scene.blocks = columns;
    tank.scene.block_count = 2;
    sph2d_sim *sim = test_create(&tank.scene, NULL);
    sph2d__store *f = &sim->system.fluid;
    const sph2d__rigid_state *state = sim->bodies.items[0].state;
    for (size_t i = 0; i < f->count; ++i)
        f->pressure[i] = p0 + DENSITY * (gx * f->x[i] - G * f->y[i]);
    sim->system.step = 1; /* in which the pressure of the film follows in full */
    sph2d__gaps_press(sim);
    const double p = p0 + DENSITY * (gx * (0.3 + width / 2) - G * bottom);
    ck_assert_double_lt(p + DENSITY * gx * width / 2, DENSITY * sim->system.head);
    ck_assert_double_eq_tol(state->gap_pressure, p, 1e-9 * p);
    ck_assert_double_eq_tol(state->gap.x, 0, 1e-9 * p);
    ck_assert_double_lt(state->gap.y, width * p);
    ck_assert_double_gt(state->gap.y, (width - DX) * p);
    ck_assert_double_lt(state->gap.turn, DENSITY * gx * pow(width, 3) / 12);
    ck_assert_double_gt(state->gap.turn, DENSITY * gx * pow(width - DX, 3) / 12);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(threads_and_resuming_change_no_bit)
{
    start_tank(_i);
    hold(&tank.bodies[0]);
    sph2d_sim_options two = sph2d_sim_options_default();
    two.threads = 2;
    sph2d_sim *whole = test_create(&tank.scene, NULL), *team = test_create(&tank.scene, &two), *resumed = NULL;
    test_steps(whole, 60);
    test_steps(team, 60);
    sph2d_state state = sph2d_sim_state(whole);
    ck_assert_int_eq(sph2d_sim_restore(&tank.scene, NULL, &state, &resumed, NULL), SPH2D_OK);
    sph2d_sim *all[3] = {whole, team, resumed};
    for (int k = 0; k < 3; ++k)
        test_steps(all[k], 20);
    ck_assert_double_ne(whole->bodies.items[0].state->gap.y, 0);
    for (int k = 1; k < 3; ++k) {
        sph2d_body_state a = sph2d_sim_body(whole, 0), b = sph2d_sim_body(all[k], 0);
        ck_assert(a.center.x == b.center.x && a.center.y == b.center.y && a.angle == b.angle);
        ck_assert(a.velocity.y == b.velocity.y && a.force.y == b.force.y);
        ck_assert(whole->bodies.items[0].state->gap.y == all[k]->bodies.items[0].state->gap.y);
    }
    for (int k = 0; k < 3; ++k)
        sph2d_sim_destroy(all[k]);
}
END_TEST

Suite *suite_gaps(void)
{
    Suite *suite = suite_create("gaps");
    TCase *tests = tcase_create("gaps");
    tcase_add_loop_test(tests, a_gap_with_a_dry_end_has_no_pressure, 0, METHODS);
    tcase_add_loop_test(tests, pieces_lead_outwards, 0, 4);
    tcase_add_test(tests, a_gap_has_the_pressure_of_liquid_at_rest);
    tcase_add_loop_test(tests, threads_and_resuming_change_no_bit, 0, METHODS);
    suite_add_tcase(suite, tests);
    TCase *slow = test_long(suite);
    tcase_add_loop_test(slow, a_body_on_the_floor_of_a_full_tank_has_its_buoyancy, 0, METHODS);
    tcase_add_loop_test(slow, a_light_body_rises_from_the_floor, SPH2D_METHOD_WCSPH, METHODS);
    tcase_add_loop_test(slow, a_gap_presses_two_bodies_apart_alike, 0, METHODS);
    return suite;
}
