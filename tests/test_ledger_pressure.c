/* SPDX-License-Identifier: MIT */
/** @file test_ledger_pressure.c
 *  Energy adds up where pressures keep the density, methods `pcisph` and `constraint`: what they take and hold, and
 *  that they make none. */
#include <math.h>
#include <string.h>

#include "common.h"
#include "sim/simulation.h"

static sph2d_scene scene;
static sph2d_block block;

static double energy_of(const sph2d_summary *s)
{
    return s->kinetic + s->potential + s->elastic;
}

static const sph2d_method projected[] = {SPH2D_METHOD_PCISPH, SPH2D_METHOD_CONSTRAINT};

/** Liquid without viscosity and gravity in an open room, by the methods of pressure solvers. */
static void projected_liquid(sph2d_method method, double dx)
{
    scene = test_open_scene(dx, 0, 0, 1, 1);
    scene.method = sph2d_scene_default().method;
    scene.method.name = method;
    scene.method.sound_speed = 20;
    scene.fluid.dynamic_viscosity = 0;
    scene.blocks = &block;
    scene.block_count = 1;
}

/** A particle that a central force of rate w holds: half a drift, a kick and half a drift keep
 *  w^2 r^2 + v^2 (1 - (w dt)^2/4), with places and velocities of one moment. */
START_TEST(a_swing_keeps_what_its_steps_keep)
{
    const double w = 5, dt = 0.02, dx = 0.05;
    projected_liquid(projected[_i], dx);
    scene.method.time_step = dt;
    scene.central_force.center = (sph2d_vec2){0.5, 0.5};
    scene.central_force.rate = w;
    block = test_particle(dx, 0.8, 0.5, 0, 0.4);
    sph2d_sim *sim = test_create(&scene, NULL);
    const double kept = w * w * 0.09 + 0.16 * (1 - w * w * dt * dt / 4);
    for (int n = 0; n < 200; ++n) {
        test_steps(sim, 1);
        sph2d_view f = sph2d_sim_fluid(sim);
        double x = f.x[0] - 0.5, y = f.y[0] - 0.5, v2 = f.vx[0] * f.vx[0] + f.vy[0] * f.vy[0];
        ck_assert_double_eq_tol(w * w * (x * x + y * y) + v2 * (1 - w * w * dt * dt / 4), kept, 1e-12 * kept);
    }
    sph2d_sim_destroy(sim);
}
END_TEST

/** A square drop rounds itself by its tension: no step of it makes energy, though its ripples are not resolved. */
START_TEST(a_drop_that_rounds_itself_makes_no_energy)
{
    const double dx = 0.05;
    projected_liquid(projected[_i], dx);
    scene.fluid.surface_tension = 50;
    block = test_block(0.3, 0.3, 0.7, 0.7);
    sph2d_sim *sim = test_create(&scene, NULL);
    double lowest = INFINITY, rise = 0, fastest = 0;
    for (int n = 0; n < 300; ++n) {
        test_steps(sim, 1);
        sph2d_summary s = sph2d_sim_summary(sim);
        lowest = fmin(lowest, energy_of(&s));
        rise = fmax(rise, energy_of(&s) - lowest);
        fastest = fmax(fastest, s.kinetic / s.energy_scale);
    }
    ck_assert_double_gt(fastest, 0.01);
    ck_assert_double_le(rise, 0.001 * sph2d_sim_summary(sim).energy_scale);
    sph2d_sim_destroy(sim);
}
END_TEST

/** Blocks that meet, a column that collapses, a box that shakes its liquid: what pressures took, by their work, is what
 *  was lost, less what moving walls brought. Artificial viscosity takes its share. */
START_TEST(pressures_take_what_impacts_lose)
{
    enum { MEET, COLLAPSE, SHAKE };
    const int what = _i / 2;
    static sph2d_block blocks[2];
    static const sph2d_vec2 corners[4] = {{0.2, 1}, {0.2, 0.2}, {0.8, 0.2}, {0.8, 1}};
    projected_liquid(projected[_i % 2], 0.025);
    blocks[0] = test_block(0.25, 0.4, 0.45, 0.6);
    blocks[1] = test_block(0.55, 0.4, 0.75, 0.6);
    blocks[0].velocity.x = what == MEET ? 1 : 0;
    blocks[1].velocity.x = what == MEET ? -1 : 0;
    scene.blocks = blocks;
    scene.block_count = 2;
    if (what != MEET) {
        scene.gravity.y = -10;
        scene.method.sound_speed = 0;
    }
    if (what == COLLAPSE)
        scene.boundary = (sph2d_boundary){SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL};
    sph2d_obstacle box = sph2d_obstacle_default();
    if (what == SHAKE) {
        box.shape.kind = SPH2D_SHAPE_POLYLINE;
        box.shape.points.items = corners;
        box.shape.points.count = 4;
        box.motion.amplitude = (sph2d_vec2){0.05, 0};
        box.motion.frequency = 2;
        scene.obstacles = &box;
        scene.obstacle_count = 1;
        blocks[0] = test_block(0.2, 0.2, 0.8, 0.4);
        scene.block_count = 1;
    }
    sph2d_sim *sim = test_create(&scene, NULL);
    test_steps(sim, 400); /* a multiple of 40: powers are looked at in the last */
    sph2d_summary s = sph2d_sim_summary(sim);
    double lost = s.energy_start + s.energy_fed + s.energy_walls - energy_of(&s) - s.energy_stopped;
    ck_assert_double_gt(s.energy_pressed, 0.1 * s.energy_scale);
    ck_assert_double_le(fabs(s.energy_pressed + s.energy_viscous + s.energy_diffused - lost), 0.01 * lost);
    ck_assert_double_le(fabs(s.energy_error), 0.01 * s.energy_scale);
    ck_assert_double_le(s.energy_rise, 0.002 * s.energy_scale);
    if (what == SHAKE)
        ck_assert_double_gt(s.energy_walls, 0.1 * s.energy_scale);
    sph2d_sim_destroy(sim);
}
END_TEST

/** Work that pressures do is no loss with another sign: it stays in the error. */
START_TEST(what_pressures_give_is_not_booked)
{
    projected_liquid(projected[_i], 0.05);
    block = test_block(0.3, 0.3, 0.7, 0.7);
    sph2d_sim *sim = test_create(&scene, NULL);
    test_steps(sim, 39);
    double before = sim->record.energy_pressed;
    sim->record.work_pressed += 7;
    test_steps(sim, 1);
    ck_assert(sim->record.energy_pressed == before && sim->record.work_pressed == 0);
    sim->record.work_pressed -= 7;
    test_steps(sim, 40);
    ck_assert_double_eq_tol(sim->record.energy_pressed - before, 7, 1e-3);
    sph2d_sim_destroy(sim);
}
END_TEST

/** Of a compression of 5 % a constraint stores m c0^2 e^2/2 where pressure holds e of it; pcisph has what a start holds
 *  beyond max_compression, and it only falls. */
START_TEST(pressure_holds_elastic_energy)
{
    const double c2 = 400, held[] = {0.02, 0.05, 0.3};
    projected_liquid(projected[_i], 0.05);
    scene.method.max_compression = 0.01;
    block = test_block(0.3, 0.3, 0.7, 0.7);
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d__store *f = &sim->system.fluid;
    const double mass = 1000 * 0.16, unknown = _i == 0 ? 0.01 : 0;
    double least = INFINITY;
    sim->record.energy_elastic = INFINITY;
    for (int k = 3; k-- > 0;) {
        sim->record.steps = 1;
        for (size_t i = 0; i < f->count; ++i) {
            f->density[i] = 1050;
            f->acting_pressure[i] = 1000 * c2 * held[k];
        }
        double e = fmin(held[k], 0.05) - unknown, want = mass * c2 * e * e / 2;
        ck_assert_double_eq_tol(sph2d_sim_summary(sim).elastic, want, 1e-9 * want);
        least = fmin(least, want);
    }
    sim->record.steps = 0; /* nobody has a pressure yet */
    memset(f->pressure, 0, f->count * sizeof *f->pressure);
    double start = mass * c2 * pow(0.05 - unknown, 2) / 2;
    ck_assert_double_eq_tol(sph2d_sim_summary(sim).elastic, start, 1e-9 * start);
    sim->record.energy_elastic = least;
    ck_assert_double_eq_tol(sph2d_sim_summary(sim).elastic, _i == 0 ? least : start, 1e-9 * start);
    sph2d_sim_destroy(sim);
}
END_TEST

Suite *suite_ledger_pressure(void)
{
    Suite *suite = suite_create("ledger_pressure");
    TCase *cases = tcase_create("ledger_pressure");
    tcase_add_loop_test(cases, a_swing_keeps_what_its_steps_keep, 0, 2);
    tcase_add_loop_test(cases, a_drop_that_rounds_itself_makes_no_energy, 0, 2);
    tcase_add_loop_test(cases, what_pressures_give_is_not_booked, 0, 1);
    tcase_add_loop_test(cases, pressure_holds_elastic_energy, 0, 1);
    suite_add_tcase(suite, cases);
    TCase *slow = test_long(suite);
    tcase_add_loop_test(slow, pressures_take_what_impacts_lose, 0, 6);
    return suite;
}
