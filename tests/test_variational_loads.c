/* SPDX-License-Identifier: MIT */
/** @file test_variational_loads.c
 *  Variational operators with bodies, friction, openings, surface tension and rheology: energy and momentum to rounding,
 *  and what is known exactly. */
#include <math.h>
#include <string.h>

#include "common.h"
#include "sim/simulation.h"

static struct {
    sph2d_scene scene;
    sph2d_block block;
    sph2d_body body;
    sph2d_opening openings[2];
    sph2d_obstacle obstacle;
    sph2d_sim *sim;
} pool;

/** Water, in a domain of width x height that is open at the top. */
static void lay_out(double dx, double width, double height)
{
    memset(&pool, 0, sizeof pool);
    pool.scene = sph2d_scene_default();
    pool.scene.domain = (sph2d_box){{0, 0}, {width, height}};
    pool.scene.spacing = dx;
    pool.scene.method.operators = SPH2D_OPERATORS_VARIATIONAL;
    pool.scene.fluid.dynamic_viscosity = 0;
    pool.scene.blocks = &pool.block;
    pool.scene.block_count = 1;
}

static void add_body(double x0, double y0, double x1, double y1, double density)
{
    pool.body = sph2d_body_default();
    pool.body.name = "body";
    pool.body.density = density;
    pool.body.shape = (sph2d_shape){.kind = SPH2D_SHAPE_BOX, .box = {{x0, y0}, {x1, y1}}};
    pool.scene.bodies = &pool.body;
    pool.scene.body_count = 1;
}

static sph2d_summary run_until(double time)
{
    pool.sim = test_create(&pool.scene, NULL);
    while (sph2d_sim_time(pool.sim) < time)
        test_steps(pool.sim, 1);
    return sph2d_sim_summary(pool.sim);
}

/** Of energy a part of the scene's may be unaccounted for, of momentum 1e-8 of what moved. */
static void balances(const sph2d_summary *s, double part)
{
    ck_assert_double_le(fabs(s->energy_error), part * sph2d__sim_energy_scale(pool.sim));
    ck_assert_double_le(s->momentum_error_max, 1e-8 * s->momentum_moved);
}

/* ---- bodies ------------------------------------------------------------------------------------------------------ */

/** A box falls into water and floats: as deep as Archimedes says, a cork of 20 kg/m^3 as calmly as wood. */
START_TEST(bodies_float_and_keep_energy)
{
    const double density = _i == 0 ? 500 : 20;
    lay_out(0.04, 1.2, 1.2);
    pool.block = test_block(0, 0, 1.2, 0.48);
    add_body(0.4, 0.5, 0.8, 0.7, density);
    const sph2d_summary s = run_until(6);
    balances(&s, 1e-7);
    const sph2d__rigid *r = &pool.sim->bodies.items[0];
    const double area = 1.2 * 0.48 + density / 1000 * 0.4 * 0.2, level = area / 1.2;
    const double bottom = 0.5 + r->state->place.y;
    ck_assert_double_eq_tol(level - bottom, density / 1000 * 0.2, 0.3 * 0.04);
    ck_assert_double_le(fabs(r->state->place.turn), 0.1);
    sph2d_sim_destroy(pool.sim);
}
END_TEST

/** Liquid thrown at a free body in free flight: both together keep their momentum and, what sticks, angular momentum. */
START_TEST(liquid_and_body_keep_their_momentum)
{
    lay_out(0.04, 4, 2);
    pool.scene.boundary = (sph2d_boundary){SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN};
    pool.scene.gravity = (sph2d_vec2){0, 0};
    pool.scene.method.sound_speed = 20;
    pool.scene.wall_slip = _i == 0 ? SPH2D_SLIP_FREE : SPH2D_SLIP_NONE;
    pool.scene.fluid.dynamic_viscosity = _i == 0 ? 0 : 5;
    pool.block = test_block(0.6, 0.8, 1.2, 1.2);
    pool.block.velocity = (sph2d_vec2){1, 0};
    add_body(1.4, 0.6, 1.8, 1.1, 600);
    const sph2d_summary s = run_until(0.8);
    const sph2d__rigid *r = &pool.sim->bodies.items[0];
    ck_assert_double_gt(r->state->velocity.x, 0.1);
    ck_assert_double_gt(fabs(r->state->velocity.turn), 0.01);
    ck_assert_double_eq_tol(s.momentum[0] + r->mass * r->state->velocity.x, 1000 * 0.24, 1e-7);
    ck_assert_double_eq_tol(s.momentum[1] + r->mass * r->state->velocity.y, 0, 1e-7);
    ck_assert_double_le(fabs(s.energy_error), 1e-7 * 1000 * 0.24 / 2);
    sph2d_sim_destroy(pool.sim);
}
END_TEST

/* ---- friction ---------------------------------------------------------------------------------------------------- */

/** Flow between plates, rho g/(2 mu) y (h - y), 16 spacings across; also as gravity brings it about from rest, with
 *  particles out of order. */
START_TEST(liquid_sticks_to_walls)
{
    const double h = 0.8, mu = 40, g = 0.5;
    lay_out(0.05, 0.8, h);
    pool.scene.boundary = (sph2d_boundary){SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL};
    pool.scene.gravity = (sph2d_vec2){g, 0};
    pool.scene.method.sound_speed = 10;
    pool.scene.wall_slip = SPH2D_SLIP_NONE;
    pool.scene.fluid.dynamic_viscosity = mu;
    pool.block = test_block(0, 0, 0.8, h);
    pool.block.perturb.amplitude = 0.15;
    const sph2d_summary s = run_until(20);
    balances(&s, 1e-6);
    const sph2d__store *f = &pool.sim->system.fluid;
    const double most = 1000 * g * h * h / (8 * mu);
    for (size_t i = 0; i < f->count; ++i)
        ck_assert_double_eq_tol(f->vx[i], 1000 * g / (2 * mu) * f->y[i] * (h - f->y[i]), 0.03 * most);
    sph2d_sim_destroy(pool.sim);
}
END_TEST

/** What a lid puts into a closed box, by a force or by its work, is in the liquid or has become heat. */
START_TEST(the_work_of_a_lid_is_known)
{
    lay_out(0.05, 1, 1);
    pool.scene.boundary.top = SPH2D_SIDE_WALL;
    pool.scene.gravity = (sph2d_vec2){0, 0};
    pool.scene.method.sound_speed = 10;
    pool.scene.wall_slip = _i == 0 ? SPH2D_SLIP_NONE : SPH2D_SLIP_SMOOTH;
    pool.scene.wall_speeds.top = 1;
    pool.scene.fluid.dynamic_viscosity = 10;
    pool.block = test_block(0, 0, 1, 1);
    const sph2d_summary s = run_until(1.5);
    ck_assert_double_gt(pool.sim->record.energy_walls, 1);
    ck_assert_double_gt(pool.sim->record.energy_viscous, 0.5);
    ck_assert_double_le(fabs(s.energy_error), 1e-7 * pool.sim->record.energy_walls);
    ck_assert_double_le(s.momentum_error_max, 1e-8 * s.momentum_moved);
    sph2d_sim_destroy(pool.sim);
}
END_TEST

/** A power law's flow between plates: u = n/(n+1) (rho g/K)^(1/n) ((h/2)^(1+1/n) - |y - h/2|^(1+1/n)). */
START_TEST(shear_thinning_liquid_has_its_profile)
{
    const double h = 0.8, n = 0.5, K = 40, g = 0.25;
    lay_out(0.05, 0.6, h);
    pool.scene.boundary = (sph2d_boundary){SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL};
    pool.scene.gravity = (sph2d_vec2){g, 0};
    pool.scene.method.sound_speed = 20;
    pool.scene.wall_slip = SPH2D_SLIP_NONE;
    pool.scene.fluid.dynamic_viscosity = sph2d_scene_default().fluid.dynamic_viscosity;
    pool.scene.fluid.model = SPH2D_RHEOLOGY_POWER_LAW;
    pool.scene.fluid.index = n;
    pool.scene.fluid.consistency = K;
    pool.scene.fluid.regularisation = 100;
    pool.block = test_block(0, 0, 0.6, h);
    const sph2d_summary s = run_until(30);
    balances(&s, 1e-6);
    const sph2d__store *f = &pool.sim->system.fluid;
    const double q = 1 + 1 / n, factor = n / (n + 1) * pow(1000 * g / K, 1 / n), most = factor * pow(h / 2, q);
    for (size_t i = 0; i < f->count; ++i)
        ck_assert_double_eq_tol(f->vx[i], factor * (pow(h / 2, q) - pow(fabs(f->y[i] - h / 2), q)), 0.07 * most);
    sph2d_sim_destroy(pool.sim);
}
END_TEST

/* ---- openings and tension ---------------------------------------------------------------------------------------- */

/** A uniform stream through a channel without friction stays uniform, and as much leaves as enters. */
START_TEST(a_stream_passes_through_openings)
{
    lay_out(0.05, 1, 0.5);
    pool.scene.boundary.top = SPH2D_SIDE_WALL;
    pool.scene.gravity = (sph2d_vec2){0, 0};
    pool.scene.method.sound_speed = 10;
    pool.scene.wall_slip = SPH2D_SLIP_FREE;
    pool.block = test_block(0, 0, 1, 0.5);
    pool.block.velocity = (sph2d_vec2){0.5, 0};
    pool.openings[0] = pool.openings[1] = sph2d_opening_default();
    pool.openings[0].side = SPH2D_SIDE_NAME_LEFT;
    pool.openings[0].velocity = 0.5;
    pool.openings[1].side = SPH2D_SIDE_NAME_RIGHT;
    pool.openings[1].pressure = 0;
    pool.scene.openings = pool.openings;
    pool.scene.opening_count = 2;
    const sph2d_summary s = run_until(4);
    ck_assert_double_le(fabs(s.energy_error), 1e-6 * 1000 * 0.5 * 0.125);
    ck_assert_uint_gt(s.let_in, 350);
    const sph2d__store *f = &pool.sim->system.fluid;
    for (size_t i = 0; i < f->count; ++i)
        ck_assert_double_eq_tol(f->vx[i], 0.5, 0.005);
    sph2d_sim_destroy(pool.sim);
}
END_TEST

/** A square drop becomes round; what its surface gives up is motion, or heat. */
START_TEST(surface_tension_gives_its_energy)
{
    lay_out(0.05, 2, 2);
    pool.scene.boundary = (sph2d_boundary){SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN};
    pool.scene.gravity = (sph2d_vec2){0, 0};
    pool.scene.method.sound_speed = 10;
    pool.scene.fluid.surface_tension = 10;
    pool.scene.fluid.dynamic_viscosity = 10;
    pool.block = test_block(0.6, 0.6, 1.4, 1.4);
    const sph2d_summary s = run_until(6);
    const double side = 0.8, radius = side / sqrt(TEST_PI), given = 10 * (4 * side - 2 * TEST_PI * radius);
    balances(&s, 0.01);
    ck_assert_double_ge(pool.sim->record.energy_viscous, 0.5 * given);
    const sph2d__store *f = &pool.sim->system.fluid;
    double farthest = 0;
    for (size_t i = 0; i < f->count; ++i)
        farthest = fmax(farthest, hypot(f->x[i] - 1, f->y[i] - 1));
    ck_assert_double_eq_tol(farthest, radius - 0.025, 0.04); /* the corners were at 0.53 */
    sph2d_sim_destroy(pool.sim);
}
END_TEST

/** Plane Poiseuille flow between an opening with its parabola and one with a pressure, at Re = 20: the channel stays full. */
START_TEST(a_channel_keeps_its_liquid_and_its_parabola)
{
    lay_out(0.1, 2, 1);
    pool.scene.boundary.top = SPH2D_SIDE_WALL;
    pool.scene.gravity = (sph2d_vec2){0, 0};
    pool.scene.wall_slip = SPH2D_SLIP_NONE;
    pool.scene.fluid.dynamic_viscosity = 50;
    pool.block = test_block(0, 0, 2, 1);
    pool.openings[0] = pool.openings[1] = sph2d_opening_default();
    pool.openings[0].side = SPH2D_SIDE_NAME_LEFT;
    pool.openings[0].velocity = 1;
    pool.openings[0].profile = SPH2D_OPENING_PROFILE_PARABOLA;
    pool.openings[0].ramp = 0.5;
    pool.openings[1].side = SPH2D_SIDE_NAME_RIGHT;
    pool.openings[1].pressure = 0;
    pool.scene.openings = pool.openings;
    pool.scene.opening_count = 2;
    pool.sim = test_create(&pool.scene, NULL);
    const size_t count = pool.sim->system.fluid.count;
    while (sph2d_sim_time(pool.sim) < 4)
        test_steps(pool.sim, 1);
    const sph2d__store *f = &pool.sim->system.fluid;
    ck_assert_uint_ge(f->count, count - 10); /* a sixth were lost where reservoirs were shifted */
    ck_assert_uint_le(f->count, count + 10);
    for (size_t i = 0; i < f->count; ++i)
        if (f->x[i] > 0.8 && f->x[i] < 1.2)
            ck_assert_double_eq_tol(f->vx[i], 6 * f->y[i] * (1 - f->y[i]), 0.06);
    sph2d_sim_destroy(pool.sim);
}
END_TEST

/** Liquid that thickens with its shear rate, and has no viscosity at rest, is held by plates all the same: u of a power law
 *  of index n between plates 1 m apart is n/(n + 1) (g rho/K)^(1/n) (0.5^(1 + 1/n) - |y|^(1 + 1/n)). */
START_TEST(shear_thickening_liquid_has_its_profile)
{
    const double dx = 1.0 / 16, n = 1.5, power = 1 + 1 / n;
    lay_out(dx, 10 * dx, 1);
    pool.scene.boundary = (sph2d_boundary){SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL};
    pool.scene.gravity = (sph2d_vec2){1, 0};
    pool.scene.wall_slip = SPH2D_SLIP_NONE;
    pool.scene.fluid.model = SPH2D_RHEOLOGY_POWER_LAW;
    pool.scene.fluid.dynamic_viscosity = sph2d_scene_default().fluid.dynamic_viscosity;
    pool.scene.fluid.density = 1;
    pool.scene.fluid.consistency = 1;
    pool.scene.fluid.index = n;
    pool.scene.fluid.regularisation = 10;
    pool.scene.method.sound_speed = 2;
    pool.block = test_block(0, 0, 10 * dx, 1);
    run_until(1.5);
    const sph2d__store *f = &pool.sim->system.fluid;
    const double most = n / (n + 1) * pow(0.5, power);
    for (size_t i = 0; i < f->count; ++i) {
        const double u = n / (n + 1) * (pow(0.5, power) - pow(fabs(f->y[i] - 0.5), power));
        ck_assert_double_eq_tol(f->vx[i], u, 0.035 * most);
    }
    sph2d_sim_destroy(pool.sim);
}
END_TEST

/** A probe on a body tells the force and the torque that move it. */
START_TEST(a_probe_tells_what_turns_a_body)
{
    lay_out(0.04, 1.2, 1);
    pool.block = test_block(0, 0, 0.48, 0.64);
    pool.block.velocity = (sph2d_vec2){1, 0};
    add_body(0.6, 0.24, 0.92, 0.48, 400);
    sph2d_probe probe = sph2d_probe_default();
    probe.name = probe.on = "body";
    probe.kind = SPH2D_PROBE_FORCE;
    probe.at = (sph2d_vec2){0.76, 0.36};
    probe.rate.every = 0.01;
    pool.scene.probes = &probe;
    pool.scene.probe_count = 1;
    pool.sim = test_create(&pool.scene, NULL);
    const sph2d__rigid *r = &pool.sim->bodies.items[0];
    double values[SPH2D_PROBE_MAX_COLUMNS], x = 0, turn = 0;
    while (sph2d_sim_time(pool.sim) < 0.2) {
        sph2d_sim_output_done(pool.sim, SPH2D_OUTPUT_PROBE);
        test_steps(pool.sim, 1);
        ck_assert_uint_eq(sph2d_sim_probe(pool.sim, 0, values), 12);
        x += values[9];
        turn += values[11];
    }
    const sph2d_body_state b = sph2d_sim_body(pool.sim, 0);
    ck_assert_double_gt(r->mass * b.velocity.x, 10);
    ck_assert_double_eq_tol(r->mass * b.velocity.x, x, 1e-5);
    ck_assert_double_eq_tol(r->inertia * b.rate, turn, 1e-6); /* 0.16 off about a point half a step behind */
    sph2d_sim_destroy(pool.sim);
}
END_TEST

/** A body of a fifth of a particle's mass gives way to five that strike it; energy never rises, nor where particles start
 *  a fifth of a spacing apart. */
START_TEST(what_is_struck_makes_no_energy)
{
    lay_out(0.04, 1.2, 1);
    pool.block = test_block(0, 0, 0.48, 0.64);
    pool.block.velocity = (sph2d_vec2){3, 0};
    add_body(0.5, 0.2, 0.58, 0.28, 50);
    const sph2d_summary s = run_until(0.1);
    balances(&s, 1e-6);
    ck_assert_double_le(s.energy_rise, 1e-3 * s.energy_scale);
    ck_assert_double_le(hypot(sph2d_sim_body(pool.sim, 0).velocity.x, sph2d_sim_body(pool.sim, 0).velocity.y), 8);
    sph2d_sim_destroy(pool.sim);
}
END_TEST

/** A disc of few particles that falls on a floor: they come close, and part again, without gain. */
START_TEST(close_pairs_give_back_what_they_took)
{
    lay_out(0.02, 0.6, 0.6);
    pool.block = sph2d_block_default();
    pool.block.shape = (sph2d_shape){.kind = SPH2D_SHAPE_CIRCLE, .circle = {{0.3, 0.2}, 0.12}};
    pool.block.velocity = (sph2d_vec2){0, -2};
    const sph2d_summary s = run_until(0.5);
    balances(&s, 1e-6);
    ck_assert_double_le(s.energy_rise, 5e-4 * s.energy_scale);
    sph2d_sim_destroy(pool.sim);
}
END_TEST

Suite *suite_variational_loads(void)
{
    Suite *suite = suite_create("variational_loads");
    TCase *tests = tcase_create("variational_loads");
    tcase_set_timeout(tests, 60);
    tcase_add_loop_test(tests, liquid_and_body_keep_their_momentum, 0, 2);
    tcase_add_loop_test(tests, the_work_of_a_lid_is_known, 0, 2);
    tcase_add_test(tests, a_stream_passes_through_openings);
    tcase_add_test(tests, surface_tension_gives_its_energy);
    tcase_add_test(tests, a_channel_keeps_its_liquid_and_its_parabola);
    tcase_add_test(tests, shear_thickening_liquid_has_its_profile);
    tcase_add_test(tests, a_probe_tells_what_turns_a_body);
    tcase_add_test(tests, what_is_struck_makes_no_energy);
    tcase_add_test(tests, close_pairs_give_back_what_they_took);
    suite_add_tcase(suite, tests);
    TCase *slow = test_long(suite);
    tcase_set_timeout(slow, 60);
    tcase_add_loop_test(slow, bodies_float_and_keep_energy, 0, 2);
    tcase_add_test(slow, liquid_sticks_to_walls);
    tcase_add_test(slow, shear_thinning_liquid_has_its_profile);
    return suite;
}
