/* SPDX-License-Identifier: MIT */
/** @file test_friction.c
 *  Friction of smooth walls: the law of the wall, how much wall there is, and what liquid that slides along it does. */
#include <math.h>
#include <string.h>

#include "common.h"
#include "methods/terms/friction.h"
#include "sim/simulation.h"

static const double RHO = 1000, C0 = 40, SHORT = 1e-7;

static sph2d_scene scene;
static sph2d_block block;

/** Liquid in a room that is periodic in x, above a smooth wall at y = 0. */
static void channel(double dx, double width, double depth, double viscosity)
{
    scene = test_scene(dx, 0, 0, width, depth);
    scene.boundary = (sph2d_boundary){SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_WALL, SPH2D_SIDE_OPEN};
    scene.method = sph2d_scene_default().method;
    scene.method.name = SPH2D_METHOD_WCSPH;
    scene.method.sound_speed = C0;
    scene.fluid.density = RHO;
    scene.fluid.dynamic_viscosity = viscosity;
    scene.wall_slip = SPH2D_SLIP_SMOOTH;
    block = test_block(0, 0, width, depth);
    scene.blocks = &block;
    scene.block_count = 1;
}

/* ---- the law ----------------------------------------------------------------------------------------------------- */

/** u/c by the two layers, as their authors wrote it. */
static double speed_at(double c, double y, double slip, double nu)
{
    double s = c * y / nu, f = s < 11.2659 ? s : log(9 * s) / 0.41;
    return c * (c * slip / nu + f);
}

START_TEST(stress_follows_the_law_of_the_wall)
{
    static const double slips[] = {0, 1e-3, 0.3};
    for (int k = 0; k < 3; ++k)
        for (double c = 1e-6; c < 10; c *= 1.7) {
            double y = 0.004, rho = 870, mu = 0.0013, u = speed_at(c, y, slips[k], mu / rho);
            double stress = sph2d__friction_stress(u, y, slips[k], rho, mu);
            ck_assert_double_eq_tol(stress / (rho * c * c), 1, 1e-4);
            if (c * y * rho / mu < 11)
                ck_assert_double_eq_tol(stress / (mu * u / (y + slips[k])), 1, 1e-12);
        }
    double c = 11.6 * 0.0013 / (870 * 0.004); /* the logarithm starts where it equals s, no later */
    ck_assert_double_eq_tol(
        sph2d__friction_stress(speed_at(c, 0.004, 0, 0.0013 / 870), 0.004, 0, 870, 0.0013) / (870 * c * c), 1, 1e-4);
    ck_assert(sph2d__friction_stress(0, 0.004, 0, 870, 0.0013) == 0);
    /* Water at 1 m/s, 1 cm from a smooth wall: c = 0.04887 m/s. */
    ck_assert_double_eq_tol(sph2d__friction_stress(1, 0.01, 0, 1000, 0.001), 2.3886, 1e-4);
}
END_TEST

/* ---- how much wall ----------------------------------------------------------------------------------------------- */

static double skin_of(sph2d_obstacle *obstacle)
{
    scene = test_open_scene(0.05, 0, 0, 3, 3);
    scene.method.name = SPH2D_METHOD_WCSPH;
    scene.wall_slip = SPH2D_SLIP_SMOOTH;
    block = test_block(0, 0, 0.2, 0.2);
    scene.blocks = &block;
    scene.block_count = 1;
    scene.obstacles = obstacle;
    scene.obstacle_count = obstacle ? 1 : 0;
    if (!obstacle)
        scene.boundary = (sph2d_boundary){SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL};
    sph2d_sim *sim = test_create(&scene, NULL);
    const sph2d__store *w = &sim->system.walls;
    double sum = 0;
    for (size_t b = 0; b < w->count; ++b)
        sum += w->skin[b];
    sph2d_sim_destroy(sim);
    return sum;
}

START_TEST(boundary_particles_stand_for_the_whole_surface)
{
    sph2d_obstacle o = sph2d_obstacle_default();
    o.shape.kind = SPH2D_SHAPE_CIRCLE;
    o.shape.circle = (sph2d_circle){{1.5, 1.5}, 0.5};
    ck_assert_double_eq_tol(skin_of(&o), TEST_PI, 2e-3);
    o.shape.kind = SPH2D_SHAPE_BOX;
    o.shape.box = (sph2d_box){{1, 1}, {1.8, 1.4}};
    ck_assert_double_eq_tol(skin_of(&o), 2.4, 1e-12);
    o.shape.box = (sph2d_box){{1, 1}, {1.8, 1.13}}; /* so thin that its layers meet */
    ck_assert_double_eq_tol(skin_of(&o), 1.86, 1e-12);
    static const sph2d_vec2 bend[3] = {{0.5, 2}, {1.5, 1}, {2.5, 1}};
    o.shape.kind = SPH2D_SHAPE_POLYLINE;
    o.shape.points = (sph2d_points){bend, 3};
    o.liquid = SPH2D_LIQUID_LEFT;
    ck_assert_double_eq_tol(skin_of(&o), 1 + sqrt(2), 1e-12);
    ck_assert_double_eq_tol(skin_of(NULL), 12, 1e-12);
}
END_TEST

/** Force along the wall on all liquid, in a short step. */
static double force_on_all(sph2d_sim *sim)
{
    double before = sph2d_sim_summary(sim).momentum[0];
    test_steps(sim, 1);
    return (sph2d_sim_summary(sim).momentum[0] - before) / sim->record.last_step;
}

/** A row that ends wets the wall below it, no more, and not the other side of a plate: with one row every distance is
 *  half a spacing. */
START_TEST(a_row_wets_what_is_below_it)
{
    const double dx = 0.01, u = 2, mu = 0.1, floor = _i ? 0.1 : 0;
    channel(dx, 0.4, 0.2, mu);
    sph2d_obstacle plate = sph2d_obstacle_default();
    plate.shape.kind = SPH2D_SHAPE_BOX;
    plate.shape.box = (sph2d_box){{0.03, floor - 2 * dx}, {0.37, floor}};
    scene.obstacles = &plate;
    scene.obstacle_count = _i ? 1 : 0;
    block = test_block(0.1, floor, 0.25, floor + dx);
    block.velocity.x = u;
    scene.method.time_step = SHORT;
    sph2d_sim *sim = test_create(&scene, NULL);
    ck_assert_uint_eq(sim->system.fluid.count, 15);
    double stress = sph2d__friction_stress(u, dx / 2, 0, RHO, mu);
    /* Those of the plate are half a spacing beside the row. */
    ck_assert_double_eq_tol(force_on_all(sim) / (-0.15 * stress), 1, _i ? 1e-3 : 1e-5);
    sph2d_sim_destroy(sim);
}
END_TEST

/** Nearer than a quarter of a spacing nothing counts as. */
START_TEST(what_touches_a_wall_is_a_quarter_of_a_spacing_off)
{
    const double dx = 0.01, u = 2, mu = 0.1;
    channel(dx, 0.4, 0.2, mu);
    block = test_block(0.1, 0, 0.25, dx);
    block.velocity.x = u;
    scene.method.time_step = SHORT;
    sph2d_sim *sim = test_create(&scene, NULL);
    const sph2d__system *s = &sim->system;
    for (size_t i = 0; i < s->fluid.count; ++i)
        s->fluid.y[i] = 0.1 * dx;
    double most = -0.15 * sph2d__friction_stress(u, 0.25 * dx, 0, RHO, mu), force = force_on_all(sim);
    ck_assert_double_le(fabs(force / most - 1), 0.1); /* weights are largest there, and count as one row at most */
    double sum = 0;
    for (size_t b = 0; b < s->walls.count; ++b)
        for (size_t i = 0; i < s->fluid.count; ++i) {
            double x = s->fluid.x[i] - s->walls.x[b], y = s->fluid.y[i] - s->walls.y[b];
            sum += sph2d__friction_of(s, b, x, y).x;
        }
    ck_assert_double_eq_tol(sum, force, 1e-4 * fabs(force));
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- liquid that slides ------------------------------------------------------------------------------------------ */

/** Mean distance from the wall of what a boundary particle finds in front, by wendland_c2 with H = 3 dx. */
static double mean_distance(double dx)
{
    double sum = 0, distance = 0;
    for (int j = 1; j <= 3; ++j)
        for (int i = -3; i <= 3; ++i) {
            double q = fmin(hypot(i, j) / 3, 1), weight = pow(1 - q, 4) * (1 + 4 * q);
            sum += weight;
            distance += weight * (j - 0.5) * dx;
        }
    return distance / sum;
}

static const struct {
    double dx, speed, viscosity, slip;
} slugs[] = {
    {0.02, 1, 1e-3, 0}, {0.01, 1, 1e-3, 0}, {0.02, -3, 1e-3, 0},    {0.01, -3, 1e-3, 0},
    {0.02, 1, 2, 0.5},  {0.01, 1, 2, 0.5},  {0.02, -3, 0.05, 2e-3}, {0.01, -3, 0.05, 2e-3},
};

/** A slab of liquid slides over a wall: dU/dt = -tau/(rho depth), and its energy never rises. */
START_TEST(a_slug_slows_by_stress_over_depth)
{
    const double depth = 0.2, dx = slugs[_i].dx, u = slugs[_i].speed, mu = slugs[_i].viscosity, slip = slugs[_i].slip;
    channel(dx, 0.4, depth, mu);
    scene.slip_length = slip;
    block.velocity.x = u;
    sph2d_sim *sim = test_create(&scene, NULL);
    const sph2d__system *s = &sim->system;
    double stress = sph2d__friction_stress(fabs(u), mean_distance(dx), slip, RHO, mu);
    double slowing = stress / (RHO * depth), energy = INFINITY, sum = 0;
    for (int k = 0; k < 40; ++k) {
        test_steps(sim, 1);
        sph2d_summary now = sph2d_sim_summary(sim);
        ck_assert_double_le(now.kinetic + now.elastic, energy);
        energy = now.kinetic + now.elastic;
    }
    for (size_t i = 0; i < s->fluid.count; ++i)
        sum += s->fluid.vx[i] / (double)s->fluid.count;
    double lost = (u - sum) / copysign(slowing * sph2d_sim_time(sim), u);
    ck_assert_msg(fabs(lost - 1) < 0.02, "it slows %g times as fast as it should", lost);
    sph2d_sim_destroy(sim);
}
END_TEST

/** Between two walls with a slip length: u = g/(2 nu) (y (D - y) + L D). */
START_TEST(poiseuille_slips_by_the_slip_length)
{
    static const double slips[] = {0.1, 0.5};
    const double depth = 1, nu = 1, slip = slips[_i], dx = 0.05, g = 8 * nu / (1 + 4 * slip);
    channel(dx, 0.6, depth, RHO * nu);
    scene.boundary.top = SPH2D_SIDE_WALL;
    scene.gravity = (sph2d_vec2){g, 0};
    scene.method.sound_speed = 20;
    scene.slip_length = slip;
    sph2d_sim *sim = test_create(&scene, NULL);
    const sph2d__store *f = &sim->system.fluid;
    while (sph2d_sim_time(sim) < (_i ? 1.6 : 1))
        test_steps(sim, 20);
    for (size_t i = 0; i < f->count; ++i) {
        double y = f->y[i], u = g / (2 * nu) * (y * (depth - y) + slip * depth);
        ck_assert_msg(fabs(f->vx[i] - u) < 0.02, "u(%g) = %g, not %g", y, f->vx[i], u);
    }
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- balance ----------------------------------------------------------------------------------------------------- */

/** Liquid that strikes a disc and runs round it: what the walls tell is what the liquid gets, and energy adds up. */
START_TEST(walls_tell_the_force_that_liquid_gets)
{
    channel(0.05, 1.5, 1.5, 0.5);
    sph2d_obstacle disc = sph2d_obstacle_default();
    disc.shape.kind = SPH2D_SHAPE_CIRCLE;
    disc.shape.circle = (sph2d_circle){{0.6, 0.5}, 0.2};
    scene.obstacles = &disc;
    scene.obstacle_count = 1;
    scene.gravity = (sph2d_vec2){0, 0};
    block = test_block(0.3, 0.0, 1.2, 1.1);
    block.velocity = (sph2d_vec2){0.7, -0.9};
    sph2d_sim *sim = test_create(&scene, NULL);
    while (sph2d_sim_time(sim) < 0.2)
        test_steps(sim, 1);
    const sph2d_summary s = sph2d_sim_summary(sim);
    ck_assert_double_gt(s.energy_viscous, 0.5);
    ck_assert_double_le(s.momentum_error_max, 1e-8 * s.momentum_moved);
    ck_assert_double_le(fabs(s.energy_error), 1e-7 * s.energy_start);
    sph2d_sim_destroy(sim);
}
END_TEST

/** Liquid at rest feels nothing, and none without viscosity, however fast. */
START_TEST(liquid_at_rest_feels_nothing)
{
    channel(0.05, 1, 0.5, _i ? 0 : 10);
    block.velocity.x = _i ? 5 : 0;
    sph2d_sim *sim = test_create(&scene, NULL);
    ck_assert_double_le(fabs(force_on_all(sim)), 1e-9);
    ck_assert(sph2d__has_friction(&sim->system) == !_i);
    sph2d_sim_destroy(sim);
}
END_TEST

/** A tongue of liquid that runs over a floor and up a slope, on one thread or three: the same in every bit. */
START_TEST(threads_do_not_matter)
{
    channel(0.01, 1.2, 0.6, 0.01);
    static const sph2d_vec2 slope[2] = {{0.8, 0.02}, {1.1, 0.3}};
    sph2d_obstacle ramp = sph2d_obstacle_default();
    ramp.shape.kind = SPH2D_SHAPE_LINE;
    ramp.shape.points = (sph2d_points){slope, 2};
    scene.obstacles = &ramp;
    scene.obstacle_count = 1;
    block = test_block(0.05, 0, 0.75, 0.4);
    block.velocity.x = 3;
    sph2d_sim *sims[2];
    for (int k = 0; k < 2; ++k) {
        sph2d_sim_options options = sph2d_sim_options_default();
        options.threads = k ? 3 : 1;
        sims[k] = test_create(&scene, &options);
        test_steps(sims[k], 60);
    }
    sph2d_view a = sph2d_sim_fluid(sims[0]), b = sph2d_sim_fluid(sims[1]);
    ck_assert_uint_eq(a.count, b.count);
    ck_assert(memcmp(a.vx, b.vx, a.count * sizeof *a.vx) == 0 && memcmp(a.y, b.y, a.count * sizeof *a.y) == 0);
    sph2d_sim_destroy(sims[0]);
    sph2d_sim_destroy(sims[1]);
}
END_TEST

Suite *suite_friction(void);
Suite *suite_friction(void)
{
    Suite *suite = suite_create("friction");
    TCase *law = tcase_create("law"), *flows = tcase_create("flows");
    tcase_add_test(law, stress_follows_the_law_of_the_wall);
    tcase_add_test(law, boundary_particles_stand_for_the_whole_surface);
    tcase_add_loop_test(law, a_row_wets_what_is_below_it, 0, 2);
    tcase_add_test(law, what_touches_a_wall_is_a_quarter_of_a_spacing_off);
    tcase_add_loop_test(flows, a_slug_slows_by_stress_over_depth, 0, (int)(sizeof slugs / sizeof slugs[0]));
    tcase_add_loop_test(flows, poiseuille_slips_by_the_slip_length, 0, 2);
    tcase_add_test(flows, walls_tell_the_force_that_liquid_gets);
    tcase_add_loop_test(flows, liquid_at_rest_feels_nothing, 0, 2);
    suite_add_tcase(suite, law);
    suite_add_tcase(suite, flows);
    TCase *slow = test_long(suite);
    tcase_add_test(slow, threads_do_not_matter);
    return suite;
}
