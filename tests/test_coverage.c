/* SPDX-License-Identifier: MIT */
/** @file test_coverage.c
 *  How much liquid covers, how high it would stand and how dense it lies, where all of that is known. */
#include <math.h>

#include "hand_made.h"
#include "probes/coverage.h"

static const double DX = 0.01;

/** A tank from (0, 0) to (0.6, 0.4), open at the top, with gravity. */
static sph2d_scene tank(void)
{
    sph2d_scene scene = test_scene(DX, 0, 0, 0.6, 0.4);
    scene.boundary = (sph2d_boundary){SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_OPEN};
    scene.gravity = (sph2d_vec2){0, -10};
    return scene;
}

static double volume_of(const sph2d_sim *sim)
{
    sph2d__coverage c;
    ck_assert(sph2d__coverage_make(&c, sim));
    double area = sph2d__coverage_area(&c);
    sph2d__coverage_free(&c);
    return area;
}

static double level_of(const sph2d_sim *sim)
{
    sph2d__coverage c;
    ck_assert(sph2d__coverage_make(&c, sim));
    double level = sph2d__coverage_level(&c, sph2d__coverage_area(&c));
    sph2d__coverage_free(&c);
    return level;
}

START_TEST(a_flat_tank_has_its_volume_and_level)
{
    sph2d_scene scene = tank();
    if (_i == 1)
        scene.boundary.left = scene.boundary.right = SPH2D_SIDE_PERIODIC;
    sph2d_sim *sim = hand_made(scene, 4000, 1);
    add_lattice(sim, (sph2d_box){{0, 0}, {0.6, 0.2}}, 0, 1);
    sort_particles(sim);
    ck_assert_double_eq_tol(volume_of(sim), 0.12, 0.001 * 0.12);
    ck_assert_double_eq_tol(level_of(sim), 0.2, 0.001 * 0.2);
    sph2d_sim_destroy(sim);
}
END_TEST

/** A surface that slopes, a wave on it, particles that lie in disorder: the volume and the level stay. */
START_TEST(volume_does_not_move_where_liquid_sloshes)
{
    sph2d_sim *sim = hand_made(tank(), 4000, 1);
    if (_i == 2)
        add_lattice(sim, (sph2d_box){{0, 0}, {0.6, 0.2}}, 0.2, 3);
    for (int column = 0; column < 60 && _i < 2; ++column) {
        double x = (column + 0.5) * DX, top = _i == 0 ? 0.1 + x / 3 : 0.2 + 0.05 * cos(TEST_PI * x / 0.3);
        int rows = (int)(top / DX + 0.5);
        for (int row = 0; row < rows; ++row) /* a lattice stretched by up to half a row */
            add_particle(sim, x, (row + 0.5) * top / rows);
    }
    sort_particles(sim);
    ck_assert_double_eq_tol(volume_of(sim), 0.12, 0.0025 * 0.12);
    ck_assert_double_eq_tol(level_of(sim), 0.2, 0.0025 * 0.2);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(a_disc_and_a_particle_have_their_areas)
{
    sph2d_scene scene = test_open_scene(DX, -0.5, -0.5, 0.5, 0.5);
    sph2d_sim *sim = hand_made(scene, 4000, 1);
    for (int k = 0; k < 25; ++k) { /* rings of 2 pi (k + 1/2) particles one spacing apart */
        int n = (int)(2 * TEST_PI * (k + 0.5) + 0.5);
        for (int i = 0; i < n; ++i) {
            double angle = 2 * TEST_PI * i / n + k;
            add_particle(sim, (k + 0.5) * DX * cos(angle), (k + 0.5) * DX * sin(angle));
        }
    }
    sort_particles(sim);
    double disc = TEST_PI * 0.0625;
    ck_assert_double_eq_tol(volume_of(sim), disc, 0.005 * disc);
    ck_assert(isnan(level_of(sim))); /* nothing falls */
    double before = volume_of(sim);
    add_particle(sim, 0.4, 0.4);
    add_particle(sim, 1.2, 0); /* beyond the open side, on its way */
    sort_particles(sim);
    ck_assert_double_eq_tol(volume_of(sim), before + 2 * DX * DX, 1e-6 * before);
    sph2d_sim_destroy(sim);
}
END_TEST

/** An obstacle takes room; a wall across parts the tank, and the liquid stays on its side until it is above it. */
START_TEST(obstacles_raise_the_level)
{
    sph2d_scene scene = tank();
    sph2d_obstacle obstacle = sph2d_obstacle_default();
    static const sph2d_vec2 wall[2] = {{0.2, 0}, {0.2, 0.3}};
    if (_i == 0) {
        obstacle.shape.kind = SPH2D_SHAPE_CIRCLE;
        obstacle.shape.circle = (sph2d_circle){{0.3, 0.1}, 0.06};
    } else {
        obstacle.shape.kind = SPH2D_SHAPE_LINE;
        obstacle.shape.points.items = wall;
        obstacle.shape.points.count = 2;
    }
    scene.obstacles = &obstacle;
    scene.obstacle_count = 1;
    sph2d_sim *sim = hand_made(scene, 4000, 1);
    for (int column = 0; column < (_i == 0 ? 60 : 20); ++column)
        for (int row = 0; row < 20; ++row) {
            double x = (column + 0.5) * DX, y = (row + 0.5) * DX;
            if (_i == 1 || hypot(x - 0.3, y - 0.1) > 0.06)
                add_particle(sim, x, y);
        }
    sort_particles(sim);
    double exact = _i == 0 ? 0.12 - TEST_PI * 0.0036 : 0.04;
    ck_assert_double_eq_tol(volume_of(sim), exact, 0.005 * exact); /* a lattice is no circle */
    ck_assert_double_eq_tol(level_of(sim), 0.2, 0.005 * 0.2);
    sph2d_sim_destroy(sim);
}
END_TEST

/** Liquid that lies looser or denser than it says is found out, inside and away from walls. */
START_TEST(density_is_counted)
{
    sph2d_sim *sim = hand_made(tank(), 4000, 1);
    const double factors[] = {1, 0.98, 1.05};
    double pitch = DX / sqrt(factors[_i]);
    for (int i = 0; (i + 0.5) * pitch < 0.6; ++i)
        for (int j = 0; (j + 0.5) * pitch < 0.3; ++j)
            add_particle(sim, (i + 0.5) * pitch, (j + 0.5) * pitch);
    sort_particles(sim);
    sph2d_densities inside = sph2d_sim_densities(sim);
    ck_assert_double_eq_tol(inside.counted, factors[_i], 0.002);
    ck_assert_double_eq_tol(inside.reported, 1, 1e-12);
    ck_assert_double_eq_tol(inside.covered * factors[_i], 1, 0.02); /* to half a spacing of its surface */
    remove_all(sim);
    add_lattice(sim, (sph2d_box){{0, 0}, {0.6, 0.05}}, 0, 1); /* nothing is inside */
    sort_particles(sim);
    ck_assert(isnan(sph2d_sim_densities(sim).counted));
    ck_assert_double_eq_tol(sph2d_sim_densities(sim).covered, 1, 0.02);
    sph2d_sim_destroy(sim);
}
END_TEST

Suite *suite_coverage(void)
{
    Suite *suite = suite_create("coverage");
    TCase *cases = tcase_create("coverage");
    tcase_add_loop_test(cases, a_flat_tank_has_its_volume_and_level, 0, 2);
    tcase_add_loop_test(cases, volume_does_not_move_where_liquid_sloshes, 0, 3);
    tcase_add_test(cases, a_disc_and_a_particle_have_their_areas);
    tcase_add_loop_test(cases, obstacles_raise_the_level, 0, 2);
    tcase_add_loop_test(cases, density_is_counted, 0, 3);
    suite_add_tcase(suite, cases);
    return suite;
}
