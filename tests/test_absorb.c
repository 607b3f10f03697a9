/* SPDX-License-Identifier: MIT */
/** @file test_absorb.c
 *  Absorbing ends: velocities decay by the law, the energy is booked, currents go on through openings. */
#include <math.h>

#include "common.h"

static const double DX = 0.01, LENGTH = 0.6, RATE = 4, SPEED = 1;

/** A single particle that flies towards the right side, which is open, with an absorbing end before it. */
static sph2d_sim *flying(sph2d_scene *scene, const sph2d_absorber *absorber, const sph2d_particle *particle)
{
    *scene = test_open_scene(DX, 0, -1, 1, 1);
    scene->particles.items = particle;
    scene->particles.count = 1;
    scene->absorbers = absorber;
    scene->absorber_count = 1;
    return test_create(scene, NULL);
}

/* By dx/dt = v, dv/dt = -rate s^2 v a particle loses rate length s^3/3 of its velocity on its way, whatever that is. */
START_TEST(a_particle_slows_down_by_the_law)
{
    sph2d_absorber absorber = sph2d_absorber_default();
    absorber.side = SPH2D_SIDE_NAME_RIGHT;
    absorber.length = LENGTH;
    absorber.rate = RATE;
    const sph2d_particle particle = {.x = 0.2, .y = 0, .vx = SPEED, .vy = 0.1, .density = 1000};
    sph2d_scene scene;
    sph2d_sim *sim = flying(&scene, &absorber, &particle);
    double largest = 0, place = 0;
    while (sph2d_sim_time(sim) < 1) {
        test_steps(sim, 1);
        sph2d_view f = sph2d_sim_fluid(sim);
        double s = fmin(fmax((f.x[0] - (1 - LENGTH)) / LENGTH, 0), 1);
        largest = fmax(largest, fabs(f.vx[0] - (SPEED - RATE * LENGTH * s * s * s / 3)));
        ck_assert_double_eq_tol(f.vy[0] / f.vx[0], 0.1, 1e-12); /* both components alike */
        place = s;
    }
    ck_assert_double_gt(place, 0.6);
    ck_assert_double_le(largest, 2e-3);
    sph2d_summary sum = sph2d_sim_summary(sim);
    double m = sph2d_sim_plan(sim)->particle_mass, before = m * SPEED * SPEED * 1.01 / 2;
    ck_assert_double_eq_tol(sum.energy_forces, sum.kinetic - before, 1e-12 * before);
    ck_assert_double_le(fabs(sum.energy_error), 1e-12 * before);
    sph2d_sim_destroy(sim);
}
END_TEST

/** The velocity that is left after a step, over that before, half way into the layer of each side. */
static double left_after_step(sph2d_side_name side, double rate, double gravity, double *dt)
{
    sph2d_absorber absorber = sph2d_absorber_default();
    absorber.side = side;
    absorber.length = 0.5;
    absorber.rate = rate;
    static const sph2d_vec2 places[] = {{0.25, 0}, {0.75, 0}, {0.5, -0.75}, {0.5, 0.75}};
    const sph2d_particle particle = {.x = places[side].x, .y = places[side].y, .vx = 1e-3, .vy = 0, .density = 1000};
    sph2d_scene scene = test_open_scene(DX, 0, -1, 1, 1);
    scene.gravity = (sph2d_vec2){0, -gravity};
    scene.particles.items = &particle;
    scene.particles.count = 1;
    scene.absorbers = &absorber;
    scene.absorber_count = 1;
    scene.method.time_step = 1e-3;
    sph2d_sim *sim = test_create(&scene, NULL);
    test_steps(sim, 1);
    *dt = sph2d_sim_time(sim);
    double vx = sph2d_sim_fluid(sim).vx[0];
    sph2d_sim_destroy(sim);
    return vx / 1e-3;
}

START_TEST(each_side_and_the_default_rate)
{
    double dt;
    for (int side = 0; side < 4; ++side) {
        double left = left_after_step((sph2d_side_name)side, 8, 0, &dt);
        ck_assert_double_eq_tol(left, exp(-8 * 0.25 * dt), 1e-6);
    }
    double left = left_after_step(SPH2D_SIDE_NAME_RIGHT, 0, 9.81, &dt);
    ck_assert_double_eq_tol(left, exp(-3 * sqrt(9.81 / 0.5) * 0.25 * dt), 1e-6);
}
END_TEST

/* A stream goes on through an opening, and only what goes along the side dies out. */
START_TEST(a_current_passes)
{
    sph2d_scene scene = test_open_scene(0.02, 0, 0, 1, 0.2);
    scene.method.name = SPH2D_METHOD_WCSPH;
    scene.walls = SPH2D_WALL_DEFAULT;
    scene.gravity = (sph2d_vec2){0, 0};
    scene.method.sound_speed = 20;
    scene.method.stiffness = 0;
    scene.boundary = (sph2d_boundary){SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC};
    sph2d_block block = sph2d_block_default();
    block.shape = (sph2d_shape){.kind = SPH2D_SHAPE_BOX, .box = {{0, 0}, {1, 0.2}}};
    block.velocity = (sph2d_vec2){1, 0.05};
    sph2d_opening openings[2] = {sph2d_opening_default(), sph2d_opening_default()};
    openings[0].side = SPH2D_SIDE_NAME_LEFT;
    openings[0].velocity = 1;
    openings[1].side = SPH2D_SIDE_NAME_RIGHT;
    openings[1].pressure = 0;
    sph2d_absorber absorber = sph2d_absorber_default();
    absorber.side = SPH2D_SIDE_NAME_RIGHT;
    absorber.length = 0.5;
    absorber.rate = _i == 0 ? 20 : 0; /* the default is 6 sqrt(g/length) here, which is 20, too */
    scene.gravity.x = _i == 0 ? 0 : -0.5 * 20 * 20 / 36;
    scene.blocks = &block;
    scene.block_count = 1;
    scene.openings = openings;
    scene.opening_count = 2;
    scene.absorbers = &absorber;
    scene.absorber_count = 1;
    sph2d_sim *sim = test_create(&scene, NULL);
    double start = 0, end = 0, inward = 0, bound = 0.05 * exp(-20 * 0.5 * (0.512 - 0.008) / 3);
    while (sph2d_sim_time(sim) < 0.3)
        test_steps(sim, 1);
    sph2d_view f = sph2d_sim_fluid(sim);
    for (size_t i = 0; i < f.count; ++i) {
        if (f.x[i] < 0 || f.x[i] > 1)
            continue;
        start = f.x[i] > 0.35 && f.x[i] < 0.45 ? fmax(start, fabs(f.vy[i])) : start;
        end = f.x[i] > 0.9 ? fmax(end, fabs(f.vy[i])) : end;
        inward = fmax(inward, fabs(f.vx[i] - 1));
    }
    ck_assert_double_gt(start, 0.04);
    /* what is at 0.9 came from 0.6, with s from 0.2 to 0.8; what is nearer to the opening is slower */
    ck_assert_double_lt(end, 1.2 * bound);
    ck_assert_double_gt(end, 0.6 * bound); /* shear brakes it, too */
    ck_assert_double_lt(inward, 0.05);
    sph2d_sim_destroy(sim);
}
END_TEST

Suite *suite_absorb(void)
{
    Suite *suite = suite_create("absorb");
    TCase *test = tcase_create("absorb");
    tcase_add_test(test, a_particle_slows_down_by_the_law);
    tcase_add_test(test, each_side_and_the_default_rate);
    tcase_add_loop_test(test, a_current_passes, 0, 2);
    suite_add_tcase(suite, test);
    return suite;
}
