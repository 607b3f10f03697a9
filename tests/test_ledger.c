/* SPDX-License-Identifier: MIT */
/** @file test_ledger.c
 *  Energy adds up: what viscosity, diffusion and walls take and what walls, interactions, periods and particles bring,
 *  each in a flow in which it is all that changes energy. */
#include <math.h>
#include <string.h>

#include "common.h"
#include "sim/stages.h"

static sph2d_scene scene;
static sph2d_block block;

/** Liquid of wcsph, c0 = 10 m/s, in a box of 1 m. */
static void plain_liquid(double dx)
{
    scene = test_scene(dx, 0, 0, 1, 1);
    scene.method = sph2d_scene_default().method;
    scene.method.name = SPH2D_METHOD_WCSPH;
    scene.method.sound_speed = 10;
    block = test_block(0, 0, 1, 1);
    scene.blocks = &block;
    scene.block_count = 1;
}

static void close_periods(void)
{
    scene.boundary =
        (sph2d_boundary){SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC};
}

static double energy_of(const sph2d_summary *s)
{
    return s->kinetic + s->potential + s->elastic;
}

/** Runs `steps` steps; the last of them is one of those in which powers are looked at, where `steps` is a multiple of
 *  60. */
static sph2d_summary run(sph2d_sim *sim, int steps)
{
    test_steps(sim, steps);
    return sph2d_sim_summary(sim);
}

/** The scale of energy is that of half the head of all particles there were, also of those that have left. */
START_TEST(what_has_left_counts_in_the_scale)
{
    plain_liquid(0.05);
    scene.gravity.y = -10;
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d__record *r = &sim->record;
    uint64_t *const counts[] = {&r->let_out, &r->drained, &r->left_left, &r->left_right, &r->left_bottom, &r->left_top};
    const double mass = 1000 * 0.05 * 0.05, head = sim->system.head, start = sph2d__sim_fall_energy(sim);
    ck_assert_double_gt(head, 1);
    ck_assert_double_eq_tol(start, 400 * mass * head / 2, 1e-9 * start);
    for (int k = 0; k < 6; ++k) {
        *counts[k] += 7;
        ck_assert_double_eq_tol(sph2d__sim_fall_energy(sim), start + 7 * (k + 1) * mass * head / 2, 1e-9 * start);
    }
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- what takes -------------------------------------------------------------------------------------------------- */

/** Vortices that decay, by both operators. */
START_TEST(viscosity_takes_what_vortices_lose)
{
    plain_liquid(0.05);
    close_periods();
    block.start.flow = (sph2d_flow){.kind = SPH2D_FLOW_TAYLOR_GREEN, .speed = 1, .length = 1};
    scene.fluid.dynamic_viscosity = 10;
    scene.method.operators = _i == 1 ? SPH2D_OPERATORS_FITTED : SPH2D_OPERATORS_VARIATIONAL;
    scene.method.time_step = 0.001;
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d_summary s = run(sim, 600);
    double lost = s.energy_start - energy_of(&s);
    ck_assert_double_gt(lost, 0.2 * s.energy_start);
    ck_assert_double_le(fabs(s.energy_viscous - lost), 0.012 * lost);
    ck_assert_double_le(fabs(s.energy_error), 0.01 * lost);
    ck_assert_double_le(s.energy_rise, 0.001 * lost);
    sph2d_sim_destroy(sim);
}
END_TEST

/** Sound in a periodic box. */
START_TEST(what_sound_loses_is_known)
{
    plain_liquid(0.05);
    close_periods();
    scene.method.time_step = 0.0003;
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d__store *f = &sim->system.fluid;
    for (size_t i = 0; i < f->count; ++i)
        f->density[i] = 1000 * (1 + 0.01 * sin(2 * TEST_PI * f->x[i]) + 0.003 * cos(6 * TEST_PI * f->y[i]));
    ck_assert(sim->method->evaluate(&sim->system));
    sph2d_summary s = sph2d_sim_summary(sim);
    sim->record.energy_start = energy_of(&s);
    double start = energy_of(&s);
    sim->record.energy_low = start;
    s = run(sim, 2400);
    double lost = start - energy_of(&s);
    ck_assert_double_gt(lost, 0.05 * start);
    ck_assert_double_le(fabs(s.energy_error), 1e-6 * lost);
    sph2d_sim_destroy(sim);
}
END_TEST

/** A lone particle that is stopped by a line, straight or at a slant: what it loses is booked, to the counted part. */
START_TEST(a_wall_at_rest_takes_what_it_stops)
{
    scene = test_open_scene(0.05, 0, 0, 1, 1);
    scene.method = sph2d_scene_default().method;
    scene.method.name = SPH2D_METHOD_MULLER;
    scene.method.sound_speed = 10;
    sph2d_vec2 ends[2] = {{0.5, 0}, {0.5 + 0.3 * _i, 1}};
    sph2d_obstacle wall = sph2d_obstacle_default();
    wall.shape.kind = SPH2D_SHAPE_LINE;
    wall.shape.points.items = ends;
    wall.shape.points.count = 2;
    wall.form = SPH2D_WALL_REFLECT;
    scene.obstacles = &wall;
    scene.obstacle_count = 1;
    block = test_particle(0.05, 0.3, 0.5, 8, 0);
    scene.blocks = &block;
    scene.block_count = 1;
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d_summary s;
    do
        s = run(sim, 1);
    while (s.reflections + s.backstop_hits == 0 && s.steps < 100);
    double lost = s.energy_start - energy_of(&s);
    ck_assert_uint_lt(s.steps, 100);
    ck_assert_double_gt(lost, 0.01 * s.energy_start);
    ck_assert_double_eq_tol(s.energy_stopped, lost, 1e-8 * s.energy_start);
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- what brings ------------------------------------------------------------------------------------------------- */

/** Forces between particles of the liquid are opposite: its momentum changes by what boundary particles do alone. */
START_TEST(forces_of_walls_are_the_whole_change_of_momentum)
{
    static const sph2d_method methods[] = {SPH2D_METHOD_MULLER, SPH2D_METHOD_PCISPH};
    plain_liquid(0.05);
    scene.method.name = methods[_i];
    scene.method.max_compression = 0.5; /* nobody is corrected by himself */
    scene.fluid.dynamic_viscosity = 5;
    sph2d_obstacle disc = sph2d_obstacle_default();
    disc.shape.kind = SPH2D_SHAPE_CIRCLE;
    disc.shape.circle = (sph2d_circle){{0.5, 0.5}, 0.15};
    scene.obstacles = &disc;
    scene.obstacle_count = 1;
    scene.boundary = (sph2d_boundary){SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN};
    block = test_block(0.25, 0.25, 0.75, 0.9);
    block.velocity = (sph2d_vec2){0.7, -0.9};
    sph2d_sim *sim = test_create(&scene, NULL);
    test_steps(sim, 12);
    const sph2d__system *s = &sim->system;
    const sph2d__store *f = &s->fluid, *w = &s->walls;
    if (sim->method->project) {
        sim->system.step = sim->record.next_step;
        sim->system.speed = sim->record.speed;
        ck_assert(sim->method->evaluate(&sim->system));
        sim->method->project(&sim->system);
    } else {
        ck_assert(sim->method->evaluate(&sim->system));
    }
    double px = 0, py = 0, fx = 0, fy = 0, size = 0;
    for (size_t i = 0; i < f->count; ++i) {
        px += s->mass * f->ax[i];
        py += s->mass * f->ay[i];
        for (size_t b = 0; b < w->count; ++b) {
            double dx = f->x[i] - w->x[b], dy = f->y[i] - w->y[b];
            if (!(hypot(dx, dy) < s->support))
                continue;
            sph2d__wall_force force = sim->method->wall_force(s, i, b, dx, dy);
            fx += force.pressure.x + force.friction.x;
            fy += force.pressure.y + force.friction.y;
            size += hypot(force.pressure.x, force.pressure.y);
        }
    }
    ck_assert_double_gt(size, 0);
    ck_assert_double_gt(hypot(fx, fy), 0.01 * size);
    ck_assert_double_le(hypot(px - fx, py - fy), 1e-6 * size);
    sph2d_sim_destroy(sim);
}
END_TEST

/** Heat of a slug on a plate, each with a velocity along it, after 120 steps by muller [J/m]. */
static double heat_on_plate(double plate, double slug)
{
    static const sph2d_vec2 ends[2] = {{-1, 0.3}, {2, 0.3}};
    const sph2d_pose_point way[2] = {{0, 0, 0, 0}, {1, plate, 0, 0}};
    plain_liquid(0.025);
    scene.domain = (sph2d_box){{-2, 0}, {3, 1}};
    scene.boundary = (sph2d_boundary){SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN};
    scene.method.name = SPH2D_METHOD_MULLER;
    scene.method.time_step = 2e-4;
    scene.fluid.dynamic_viscosity = 20;
    sph2d_obstacle obstacle = sph2d_obstacle_default();
    obstacle.shape = (sph2d_shape){.kind = SPH2D_SHAPE_LINE, .points = {ends, 2}};
    obstacle.form = SPH2D_WALL_HEAVY;
    obstacle.motion.path = (sph2d_pose_path){way, plate != 0 ? 2 : 0};
    scene.obstacles = &obstacle;
    scene.obstacle_count = 1;
    block = test_block(0.3, 0.3, 0.7, 0.5);
    block.velocity.x = slug;
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d_summary s = run(sim, 120);
    sph2d_sim_destroy(sim);
    return s.energy_viscous;
}

/* Friction makes the same heat whoever looks (Galileo): of a plate at rest, of a slug at rest, and of one that both pass. */
START_TEST(heat_of_friction_is_the_same_in_every_frame)
{
    const double still = heat_on_plate(0, -0.5), energy = 1000 * 0.4 * 0.2 * 0.25 / 2;
    ck_assert_double_gt(still, 0.02 * energy);
    ck_assert_double_eq_tol(heat_on_plate(0.5, 0), still, 0.02 * still);
    ck_assert_double_eq_tol(heat_on_plate(1, 0.5), still, 0.02 * still);
}
END_TEST

/** A lid drags liquid, a box shakes it: what walls bring less what friction takes is what the liquid has. */
START_TEST(moving_walls_bring_what_liquid_gains)
{
    plain_liquid(0.05);
    scene.fluid.dynamic_viscosity = 20;
    sph2d_obstacle box = sph2d_obstacle_default();
    if (_i != 1) {
        scene.boundary = (sph2d_boundary){SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL};
        scene.wall_slip = _i == 0 ? SPH2D_SLIP_NONE : SPH2D_SLIP_SMOOTH;
        scene.wall_speeds.top = 1;
    } else {
        scene.boundary = (sph2d_boundary){SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN};
        scene.gravity = (sph2d_vec2){0, -10};
        static const sph2d_vec2 corners[4] = {{0.2, 1}, {0.2, 0.2}, {0.8, 0.2}, {0.8, 1}};
        box.shape.kind = SPH2D_SHAPE_POLYLINE;
        box.shape.points.items = corners;
        box.shape.points.count = 4;
        box.motion.amplitude = (sph2d_vec2){0.02, 0.01};
        box.motion.frequency = 1;
        scene.obstacles = &box;
        scene.obstacle_count = 1;
        scene.wall_slip = SPH2D_SLIP_NONE;
        block = test_block(0.2, 0.2, 0.8, 0.6);
    }
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d_summary s = run(sim, 600);
    double brought = fabs(s.energy_walls) + s.energy_viscous, gained = energy_of(&s) - s.energy_start;
    ck_assert_double_gt(brought, _i != 1 ? 10 : 0.5);
    ck_assert_double_gt(s.energy_viscous, 0);
    ck_assert_double_le(fabs(gained - s.energy_walls + s.energy_viscous + s.energy_diffused), 0.05 * brought);
    ck_assert_double_le(fabs(s.energy_error), 0.05 * brought);
    sph2d_sim_destroy(sim);
}
END_TEST

/** Liquid that falls along a period, and a particle that an interaction pulls. */
START_TEST(forces_bring_what_falls_gain)
{
    plain_liquid(0.1);
    close_periods();
    scene.gravity = (sph2d_vec2){_i == 0 ? 2 : 0, _i == 1 ? -3 : 0};
    sph2d_interaction pull = sph2d_interaction_default();
    sph2d_path_point at = {0, 0.5, 0.5};
    pull.path.items = &at;
    pull.path.count = 1;
    pull.radius = 0.4;
    pull.acceleration = 1;
    scene.method.time_step = 0.002;
    if (_i == 2) {
        block = test_particle(0.1, 0.25, 0.5, 0, 0);
        scene.interactions = &pull;
        scene.interaction_count = 1;
    }
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d_summary s = run(sim, 240);
    ck_assert_double_gt(s.kinetic, 0);
    ck_assert_double_le(fabs(s.potential), 1e-9);
    ck_assert_double_le(fabs(s.energy_forces - s.kinetic), 0.002 * s.kinetic);
    if (_i < 2) /* m n (g t)^2/2 */
        ck_assert_double_eq_tol(s.kinetic, 1000 * pow((_i == 0 ? 2 : 3) * s.time, 2) / 2, 1e-6 * s.kinetic);
    ck_assert_double_le(fabs(s.energy_error), 0.002 * s.kinetic);
    sph2d_sim_destroy(sim);
}
END_TEST

/** What a drain takes is all that the particles had, that of compression too. */
START_TEST(drains_take_elastic_energy_along)
{
    plain_liquid(0.1);
    close_periods();
    sph2d_drain drain = sph2d_drain_default();
    drain.shape.kind = SPH2D_SHAPE_BOX;
    drain.shape.box = (sph2d_box){{0, 0}, {0.5, 1}};
    scene.drains = &drain;
    scene.drain_count = 1;
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d__store *f = &sim->system.fluid;
    double e = 0, c2 = 100;
    for (size_t i = 0; i < f->count; ++i) {
        f->log_density[i] = log(1.05);
        e = c2 * pow(log(1.05), 2) / 2;
    }
    sim->record.energy_low = sim->record.error_low = INFINITY; /* what comes in here comes from somewhere */
    test_steps(sim, 1);
    sph2d_summary s = sph2d_sim_summary(sim);
    ck_assert_uint_eq(s.drained, 50);
    ck_assert_double_eq_tol(s.energy_fed, -50 * 10 * e, 1e-9 * 500 * e);
    sph2d_sim_destroy(sim);
}
END_TEST

/** A particle thrown at a side without damping: at the deepest place its energy is the spring's k d^2/2, k = (c0/dx)^2,
 *  as potential and nowhere else, and all of it comes back. */
START_TEST(springs_hold_what_they_stop)
{
    enum { SPEED = 2 };
    const double dx = 0.05, c0 = 10;
    scene = test_scene(dx, 0, 0, 1, 1);
    scene.method = sph2d_scene_default().method;
    scene.method.name = SPH2D_METHOD_MULLER;
    scene.method.sound_speed = c0;
    scene.wall_damping = 0;
    scene.method.time_step = 1e-5;
    block = test_particle(dx, 0.5, 0.6 * dx, 0, -SPEED);
    scene.blocks = &block;
    scene.block_count = 1;
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d_view f = sph2d_sim_fluid(sim);
    double start = sph2d_sim_summary(sim).energy_start, most = 0, depth = 0;
    ck_assert_double_eq_tol(start, 1000 * dx * dx * SPEED * SPEED / 2, 1e-12 * start);
    while (!(f.vy[0] > 0 && f.y[0] > dx / 2)) {
        test_steps(sim, 1);
        f = sph2d_sim_fluid(sim);
        sph2d_summary s = sph2d_sim_summary(sim);
        ck_assert_double_eq_tol(energy_of(&s), start, 1e-4 * start);
        ck_assert(s.elastic == 0);
        if (s.potential > most) {
            most = s.potential;
            depth = dx / 2 - f.y[0];
        }
    }
    ck_assert_double_eq_tol(most, start, 1e-4 * start);
    ck_assert_double_eq_tol(most, 1000 * dx * dx * pow(c0 / dx * depth, 2) / 2, 1e-12 * start);
    sph2d_sim_destroy(sim);
}
END_TEST

/** Liquid that starts against a wall, with a tenth of the speed of sound: the impact makes no energy. */
START_TEST(liquid_that_starts_against_a_wall_makes_no_energy)
{
    plain_liquid(0.05);
    scene.boundary.top = SPH2D_SIDE_OPEN;
    block = test_block(0, 0, 1, 0.3);
    block.velocity.y = -1;
    sph2d_sim *sim = test_create(&scene, NULL);
    double lowest = INFINITY, rise = 0;
    while (sph2d_sim_time(sim) < 0.04) { /* when sound is at the surface */
        sph2d_summary s = sph2d_sim_summary(sim);
        lowest = fmin(lowest, energy_of(&s));
        rise = fmax(rise, energy_of(&s) - lowest);
        test_steps(sim, 1);
    }
    ck_assert_double_le(rise, 0.001 * sph2d_sim_summary(sim).energy_start);
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- samples ----------------------------------------------------------------------------------------------------- */

/** Steps until dissipation is looked at again. */
static int steps_to_sample(sph2d_sim *sim)
{
    double last = sim->record.booked_time;
    int steps = 0;
    for (; sim->record.booked_time == last && steps < 100; ++steps)
        test_steps(sim, 1);
    return steps;
}

/** Thick liquid that is struck loses its energy within a few steps: its friction is looked at more often until then. */
START_TEST(samples_follow_what_friction_does)
{
    plain_liquid(0.05);
    close_periods();
    scene.fluid.dynamic_viscosity = 100;
    scene.method.name = SPH2D_METHOD_MULLER; /* which books by samples */
    sph2d_sim *sim = test_create(&scene, NULL);
    test_steps(sim, 160);
    ck_assert_int_eq(steps_to_sample(sim), 40);
    test_steps(sim, 39);
    for (size_t i = 0; i < sim->system.fluid.count; ++i)
        sim->system.fluid.vx[i] = sim->system.fluid.y[i] < 0.5 ? 0.1 : -0.1;
    ck_assert_int_eq(steps_to_sample(sim), 1);
    ck_assert_int_lt(steps_to_sample(sim), 16);
    test_steps(sim, 1000);
    steps_to_sample(sim);
    ck_assert_int_eq(steps_to_sample(sim), 40);
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- the guard --------------------------------------------------------------------------------------------------- */

/** Energy that somebody puts in unseen stops a run by any method, while a wall moves too; a key lets it pass. */
START_TEST(energy_from_nothing_stops_every_method)
{
    static const sph2d_method methods[] = {SPH2D_METHOD_MULLER, SPH2D_METHOD_WCSPH, SPH2D_METHOD_PCISPH,
                                           SPH2D_METHOD_CONSTRAINT};
    scene = test_scene(0.05, 0, 0, 1, 1);
    scene.method = sph2d_scene_default().method;
    scene.method.name = methods[_i % 4];
    scene.gravity = (sph2d_vec2){0, -10};
    scene.run.max_energy_rise = _i < 4 ? 0 : 1e6;
    sph2d_obstacle disc = sph2d_obstacle_default();
    disc.shape.kind = SPH2D_SHAPE_CIRCLE;
    disc.shape.circle = (sph2d_circle){{0.7, 0.5}, 0.1};
    disc.motion.amplitude = (sph2d_vec2){0.01, 0};
    disc.motion.frequency = 1;
    scene.obstacles = &disc;
    scene.obstacle_count = 1;
    block = test_block(0, 0, 0.5, 0.5);
    scene.blocks = &block;
    scene.block_count = 1;
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d_report report = {0};
    test_steps(sim, 40);
    ck_assert_double_lt(sph2d_sim_summary(sim).energy_rise, 0.1 * sph2d_sim_summary(sim).energy_scale);
    /* v^2/2 is 6.4 g h; 1.6, where a step goes so far that what comes from nowhere is beyond neighbours */
    for (size_t i = 0; i < sim->system.fluid.count; ++i)
        sim->system.fluid.vx[i] += scene.method.name == SPH2D_METHOD_CONSTRAINT ? 4 : 8;
    sim->momentum_kept = 0; /* is not that of the last step */
    sph2d_status status = SPH2D_OK;
    for (int n = 0; n < 40 && status == SPH2D_OK; ++n)
        status = sph2d_sim_step(sim, &report);
    if (_i < 4) {
        ck_assert_int_eq(status, SPH2D_GUARD);
        ck_assert_msg(test_report_has(&report, SPH2D_CODE_ENERGY, NULL), "%s", test_report_text(&report));
        ck_assert_ptr_nonnull(strstr(test_report_text(&report), "spacings from"));
        ck_assert_ptr_nonnull(strstr(test_report_text(&report), "nearest to blocks[0]"));
    } else {
        ck_assert(!test_report_has(&report, SPH2D_CODE_ENERGY, NULL));
    }
    sph2d_report_clear(&report);
    sph2d_sim_destroy(sim);
}
END_TEST

Suite *suite_ledger(void)
{
    Suite *suite = suite_create("ledger");
    TCase *cases = tcase_create("ledger");
    tcase_add_test(cases, what_has_left_counts_in_the_scale);
    tcase_add_loop_test(cases, viscosity_takes_what_vortices_lose, 0, 2);
    tcase_add_loop_test(cases, a_wall_at_rest_takes_what_it_stops, 0, 2);
    tcase_add_loop_test(cases, forces_of_walls_are_the_whole_change_of_momentum, 0, 2);
    tcase_add_test(cases, heat_of_friction_is_the_same_in_every_frame);
    tcase_add_loop_test(cases, forces_bring_what_falls_gain, 0, 3);
    tcase_add_test(cases, drains_take_elastic_energy_along);
    tcase_add_test(cases, springs_hold_what_they_stop);
    tcase_add_test(cases, liquid_that_starts_against_a_wall_makes_no_energy);
    tcase_add_test(cases, samples_follow_what_friction_does);
    tcase_add_loop_test(cases, energy_from_nothing_stops_every_method, 0, 8);
    suite_add_tcase(suite, cases);
    TCase *slow = test_long(suite);
    tcase_add_test(slow, what_sound_loses_is_known);
    tcase_add_loop_test(slow, moving_walls_bring_what_liquid_gains, 0, 3);
    return suite;
}
