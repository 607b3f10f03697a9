/* SPDX-License-Identifier: MIT */
/** @file test_muller_energy.c
 *  Method `muller`: walls press as the energy of the liquid asks, and pressure carries the weight above it. */
#include <math.h>

#include "common.h"
#include "methods/common/state_equation.h"
#include "sim/simulation.h"

static const double DX = 0.01;

/** Energy of two particles on each other at height y, where they press on walls alone. */
static double energy_at(sph2d_sim *sim, double y)
{
    sph2d__store *f = &sim->system.fluid;
    double energy = 0;
    f->count = 2;
    for (size_t i = 0; i < 2; ++i) {
        f->x[i] = 0.004;
        f->y[i] = y;
        f->vx[i] = f->vy[i] = 0;
    }
    ck_assert(sph2d__cells_build(&sim->system.fluid_cells, f, sim->system.support, sim->system.memory));
    sim->method->evaluate(&sim->system);
    for (size_t i = 0; i < 2; ++i)
        energy += sph2d__elastic_of(&sim->system, f->density[i]) / 2;
    return energy;
}

START_TEST(walls_give_back_what_pressing_takes)
{
    /* Beyond the reach of springs: the slope of the energy, for a side and for heavy boundary particles. */
    static sph2d_vec2 floor[2] = {{-0.3, 0}, {0.3, 0}};
    static sph2d_obstacle obstacle;
    sph2d_block block = test_block(-0.1, 0.1, 0.1, 0.2);
    sph2d_scene scene = test_open_scene(DX, -0.5, _i ? -0.5 : 0, 0.5, 0.5);
    obstacle = sph2d_obstacle_default();
    obstacle.shape.kind = SPH2D_SHAPE_LINE;
    obstacle.shape.points = (sph2d_points){floor, 2};
    scene.obstacles = _i ? &obstacle : NULL;
    scene.obstacle_count = _i ? 1 : 0;
    scene.boundary.bottom = _i ? SPH2D_SIDE_OPEN : SPH2D_SIDE_WALL;
    scene.blocks = &block;
    scene.block_count = 1;
    scene.method.support_ratio = 1.2;
    sph2d_sim *sim = test_create(&scene, NULL);
    for (double y = 0.55 * DX; y < (_i ? 1.15 : 0.63) * DX; y += 0.03 * DX) {
        double step = 1e-5 * DX, above = energy_at(sim, y + step), below = energy_at(sim, y - step);
        double slope = (above - below) / (2 * step);
        energy_at(sim, y);
        ck_assert_double_lt(slope, 0);
        ck_assert_double_eq_tol(sim->system.fluid.ay[0] / -slope, 1, 1e-5);
    }
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(a_tank_at_rest_carries_its_weight)
{
    /* 1 m of liquid that may give way by 10 %, released: a twentieth at the bottom, a fortieth on the whole. */
    const double g = 9.81, depth = 1, dx = 0.05;
    sph2d_scene scene = test_scene(dx, 0, 0, 1, 1.3);
    sph2d_block block = test_block(0, 0, 1, depth);
    scene.gravity = (sph2d_vec2){0, -g};
    scene.blocks = &block;
    scene.block_count = 1;
    scene.method.sound_speed = 0;
    scene.fluid.dynamic_viscosity = 300; /* so that it comes to rest soon */
    sph2d_sim *sim = test_create(&scene, NULL);
    while (sph2d_sim_time(sim) < 8)
        test_steps(sim, 10);
    sph2d_view f = sph2d_sim_fluid(sim);
    double bottom = 0, height = 0, low = 0;
    for (size_t i = 0; i < f.count; ++i) {
        height += 2 * f.y[i] / (double)f.count;
        if (f.y[i] < 3 * dx) {
            bottom += f.pressure[i];
            low += 1;
        }
    }
    ck_assert_double_eq_tol(bottom / low / (1000 * g * (depth - 1.5 * dx)), 1, 0.05);
    /* The centre of mass at rest is a third of the bottom's compression lower; the free surface takes half a row. */
    ck_assert_double_le(height, 1 - 0.05 * 2 / 3 + 0.002);
    ck_assert_double_ge(height, 1 - 0.05 * 2 / 3 - dx / 2);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(a_pressed_drop_gives_back_what_it_holds)
{
    /* 1.3 times too dense at the start, in short steps and with next to no viscosity: 7 % more without G. What is left
     * is the surface's, whose particles have fewer neighbours. */
    sph2d_scene scene = test_open_scene(DX, -1, -1, 1, 1);
    sph2d_block block = test_block(-0.2, -0.2, 0.2, 0.2);
    block.spacing = DX / sqrt(1.3);
    scene.blocks = &block;
    scene.block_count = 1;
    scene.method.artificial_viscosity = 1e-30;
    scene.method.cfl = 0.05;
    sph2d_sim *sim = test_create(&scene, NULL);
    double start = sph2d_sim_summary(sim).elastic;
    while (sph2d_sim_summary(sim).elastic > 1e-3 * start)
        test_steps(sim, 1);
    ck_assert_double_eq_tol(sph2d_sim_summary(sim).kinetic / start, 1, 0.01);
    sph2d_sim_destroy(sim);
}
END_TEST

Suite *suite_muller_energy(void)
{
    Suite *suite = suite_create("muller_energy");
    TCase *tests = tcase_create("energy and pressure");
    tcase_add_loop_test(tests, walls_give_back_what_pressing_takes, 0, 2);
    tcase_add_test(tests, a_tank_at_rest_carries_its_weight);
    tcase_add_test(tests, a_pressed_drop_gives_back_what_it_holds);
    suite_add_tcase(suite, tests);
    return suite;
}
