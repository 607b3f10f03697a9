/* SPDX-License-Identifier: MIT */
/** @file test_layers.c
 *  Generalised walls: where their layers lie and which area each particle stands for; walls that move. */
#include <math.h>
#include <string.h>

#include "base/pi.h"
#include "common.h"
#include "scene/shape.h"
#include "sim/simulation.h"

static const double DX = 0.01;
enum { LAYERS = 3 }; /* H = 3 dx */

static sph2d_obstacle obstacle;
static sph2d_block block;
static sph2d_scene scene;

static void start(void)
{
    scene = test_open_scene(DX, 0, 0, 1, 1);
    scene.method = sph2d_scene_default().method;
    scene.method.name = SPH2D_METHOD_WCSPH;
    scene.method.sound_speed = 10;
    block = test_particle(DX, 0.9, 0.9, 0, 0);
    scene.blocks = &block;
    scene.block_count = 1;
    obstacle = sph2d_obstacle_default();
    scene.obstacles = &obstacle;
    scene.obstacle_count = 1;
}

static double area_of(const sph2d_sim *sim)
{
    const sph2d__store *w = &sim->system.walls;
    double area = 0;
    for (size_t i = 0; i < w->count; ++i)
        area += w->mass[i] / scene.fluid.density;
    return area;
}

/** Smallest distance between two boundary particles. */
static double closest(const sph2d_sim *sim)
{
    const sph2d__store *w = &sim->system.walls;
    double least = INFINITY;
    for (size_t i = 0; i < w->count; ++i)
        for (size_t j = 0; j < i; ++j)
            least = fmin(least, hypot(w->x[i] - w->x[j], w->y[i] - w->y[j]));
    return least;
}

START_TEST(sides_continue_the_lattice_outside)
{
    scene.obstacle_count = 0;
    scene.boundary = (sph2d_boundary){SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL};
    sph2d_sim *sim = test_create(&scene, NULL);
    const sph2d__store *w = &sim->system.walls;
    ck_assert_uint_eq(w->count, (100 + 2 * LAYERS) * (100 + 2 * LAYERS) - 100 * 100);
    for (size_t i = 0; i < w->count; ++i) {
        double column = w->x[i] / DX - 0.5, row = w->y[i] / DX - 0.5;
        ck_assert_double_eq_tol(column, floor(column + 0.5), 1e-9);
        ck_assert_double_eq_tol(row, floor(row + 0.5), 1e-9);
        ck_assert(w->x[i] < 0 || w->x[i] > 1 || w->y[i] < 0 || w->y[i] > 1);
        ck_assert_double_eq_tol(w->mass[i], scene.fluid.density * DX * DX, 1e-12);
    }
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(walls_beside_open_sides_go_on_and_beside_periodic_ones_close_the_period)
{
    scene.obstacle_count = 0;
    scene.boundary = (sph2d_boundary){SPH2D_SIDE_WALL, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN};
    sph2d_sim *sim = test_create(&scene, NULL);
    ck_assert_uint_eq(sim->system.walls.count, LAYERS * 300);
    sph2d_sim_destroy(sim);
    scene.boundary = (sph2d_boundary){SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL};
    sim = test_create(&scene, NULL);
    ck_assert_uint_eq(sim->system.walls.count, 2 * LAYERS * 100);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(a_solid_box_has_layers_inside)
{
    obstacle.shape.kind = SPH2D_SHAPE_BOX;
    obstacle.shape.box = (sph2d_box){{0.2, 0.2}, {0.5, 0.4}};
    sph2d_sim *sim = test_create(&scene, NULL);
    const sph2d__store *w = &sim->system.walls;
    for (size_t i = 0; i < w->count; ++i) {
        double depth = fmin(fmin(w->x[i] - 0.2, 0.5 - w->x[i]), fmin(w->y[i] - 0.2, 0.4 - w->y[i])) / DX - 0.5;
        ck_assert_double_eq_tol(depth, floor(depth + 0.5), 1e-9);
        ck_assert_double_lt(depth, LAYERS - 0.5);
        ck_assert_double_gt(depth, -0.5);
    }
    double inner = (0.3 - 2 * LAYERS * DX) * (0.2 - 2 * LAYERS * DX);
    ck_assert_double_eq_tol(area_of(sim), 0.3 * 0.2 - inner, 1e-9);
    ck_assert_double_gt(closest(sim), 0.65 * DX);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(a_thin_solid_is_filled_once)
{
    obstacle.shape.kind = SPH2D_SHAPE_BOX;
    obstacle.shape.box = (sph2d_box){{0.2, 0.2}, {0.24, 0.6}};
    sph2d_sim *sim = test_create(&scene, NULL);
    ck_assert_double_eq_tol(area_of(sim), 0.04 * 0.4, 1e-9);
    ck_assert_double_gt(closest(sim), 0.65 * DX);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(a_solid_thinner_than_its_layers_is_filled_once_whatever_its_thickness)
{
    static const double thickness[] = {0.4, 1, 1.5, 2, 2.9, 3, 3.1, 4.4, 5, 5.7}; /* spacings */
    double t = thickness[_i] * DX;
    obstacle.shape.kind = SPH2D_SHAPE_BOX;
    obstacle.shape.box = (sph2d_box){{0.2, 0.2}, {0.2 + t, 0.6}};
    sph2d_sim *sim = test_create(&scene, NULL);
    const sph2d__store *w = &sim->system.walls;
    double moment = 0;
    for (size_t i = 0; i < w->count; ++i) {
        moment += w->mass[i] / scene.fluid.density * (w->x[i] - 0.2 - t / 2);
        ck_assert(w->x[i] > 0.2 && w->x[i] < 0.2 + t);
    }
    ck_assert_double_eq_tol(area_of(sim), t * 0.4, 1.001 * DX * DX); /* mitres round off the ends of the plate */
    ck_assert_double_eq_tol(moment, 0, 1e-12);
    sph2d_sim_destroy(sim);
}
END_TEST

/** A wedge with its tip at (0.2, 0.3): the layers of its two long sides meet on its midline, as far as the tip. */
START_TEST(a_sharp_corner_is_filled_once_up_to_its_tip)
{
    static const double angles[] = {4, 14, 30, 45, 60, 75, 86}; /* degrees; with the length thin enough to be filled */
    double angle = angles[_i] * SPH2D__PI / 180, length = 4.9 * DX / (2 * sin(angle / 2));
    sph2d_vec2 corners[] = {{0.2, 0.3},
                            {0.2 + length * cos(angle / 2), 0.3 - length * sin(angle / 2)},
                            {0.2 + length * cos(angle / 2), 0.3 + length * sin(angle / 2)}};
    obstacle.shape.kind = SPH2D_SHAPE_POLYGON;
    obstacle.shape.points = (sph2d_points){corners, 3};
    sph2d_sim *sim = test_create(&scene, NULL);
    const sph2d__store *w = &sim->system.walls;
    double whole = length * length * sin(angle) / 2, along = 0, skin = 0;
    for (size_t i = 0; i < w->count; ++i) {
        ck_assert(sph2d__shape_contains(&obstacle.shape, (sph2d_vec2){w->x[i], w->y[i]}));
        along += w->mass[i] / scene.fluid.density * (w->x[i] - 0.2);
        skin += w->skin ? w->skin[i] : 0;
    }
    ck_assert_msg(fabs(area_of(sim) / whole - 1) < 0.02, "%g of %g", area_of(sim), whole);
    along /= whole * length * cos(angle / 2) * 2 / 3;
    ck_assert_msg(fabs(along - 1) < 0.02, "its centroid is at %g of its distance from the tip", along);
    ck_assert_double_eq_tol(skin, w->skin ? 2 * length * (1 + sin(angle / 2)) : 0, 1e-3 * length);
    sph2d_sim_destroy(sim);
}
END_TEST

/** A trough of one polygon, with walls of 10 spacings: its inner faces have layers like its outer ones. */
START_TEST(a_trough_has_layers_on_all_its_faces)
{
    static const sph2d_vec2 corners[] = {{0.2, 0.2}, {0.8, 0.2}, {0.8, 0.7}, {0.7, 0.7},
                                         {0.7, 0.3}, {0.3, 0.3}, {0.3, 0.7}, {0.2, 0.7}};
    obstacle.shape.kind = SPH2D_SHAPE_POLYGON;
    obstacle.shape.points = (sph2d_points){corners, 8};
    sph2d_sim *sim = test_create(&scene, NULL);
    double whole = 0.6 * 0.5 - 0.4 * 0.4, inside = 0.54 * 0.44 - 0.46 * 0.4; /* deeper than the layers */
    ck_assert_msg(fabs(area_of(sim) / (whole - inside) - 1) < 0.01, "%g of %g", area_of(sim), whole - inside);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(a_circle_has_rings_of_its_area)
{
    obstacle.shape.kind = SPH2D_SHAPE_CIRCLE;
    obstacle.shape.circle = (sph2d_circle){{0.5, 0.5}, 0.1};
    sph2d_sim *sim = test_create(&scene, NULL);
    const sph2d__store *w = &sim->system.walls;
    for (size_t i = 0; i < w->count; ++i) {
        double depth = (0.1 - hypot(w->x[i] - 0.5, w->y[i] - 0.5)) / DX - 0.5;
        ck_assert_double_eq_tol(depth, floor(depth + 0.5), 0.03); /* a polygon lies a little inside its circle */
    }
    double hole = 0.1 - LAYERS * DX;
    ck_assert_double_eq_tol(area_of(sim), TEST_PI * (0.1 * 0.1 - hole * hole), 2e-4);
    sph2d_sim_destroy(sim);
}
END_TEST

/** A vessel that opens by 45 degrees on both sides, with the liquid on the left of the way. */
static sph2d_vec2 vessel[3] = {{0.2, 0.6}, {0.5, 0.3}, {0.8, 0.6}};

START_TEST(a_polyline_has_mitred_layers_on_its_right)
{
    obstacle.shape.kind = SPH2D_SHAPE_POLYLINE;
    obstacle.shape.points = (sph2d_points){vessel, 3};
    sph2d_sim *sim = test_create(&scene, NULL);
    const sph2d__store *w = &sim->system.walls;
    double length = 2 * 0.3 * sqrt(2), thick = LAYERS * DX;
    for (size_t i = 0; i < w->count; ++i) {
        double below = fabs(w->x[i] - 0.5) + 0.3 - w->y[i]; /* vertical distance below the wall */
        double depth = below / sqrt(2) / DX - 0.5;
        ck_assert_double_eq_tol(depth, floor(depth + 0.5), 1e-9);
        ck_assert_double_gt(depth, -0.5);
    }
    ck_assert_double_eq_tol(area_of(sim), length * thick + thick * thick, 1e-9); /* the corner's square comes on top */
    ck_assert_double_gt(closest(sim), 0.55 * DX);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(a_swinging_wall_is_where_its_law_says)
{
    obstacle.shape.kind = SPH2D_SHAPE_BOX;
    obstacle.shape.box = (sph2d_box){{0.2, 0.2}, {0.5, 0.4}};
    obstacle.motion = (sph2d_motion){.amplitude = {0.05, -0.02}, .frequency = 1.5, .phase = 0.7};
    scene.method.time_step = 1e-3;
    sph2d_sim *still = test_create(&scene, NULL), *sim = test_create(&scene, NULL);
    test_steps(sim, 137);
    double t = sph2d_sim_time(sim), omega = 2 * TEST_PI * 1.5;
    double way = sin(omega * t + 0.7) - sin(0.7), speed = omega * cos(omega * t + 0.7);
    double push = -omega * omega * sin(omega * t + 0.7);
    const sph2d__store *w = &sim->system.walls, *before = &still->system.walls;
    for (size_t i = 0; i < w->count; ++i) {
        size_t k = 0;
        while (before->id[k] != w->id[i])
            ++k;
        ck_assert_double_eq_tol(w->x[i], before->start_x[k] + 0.05 * way, 1e-12);
        ck_assert_double_eq_tol(w->y[i], before->start_y[k] - 0.02 * way, 1e-12);
        ck_assert_double_eq_tol(w->vx[i], 0.05 * speed, 1e-12);
        ck_assert_double_eq_tol(w->vy[i], -0.02 * speed, 1e-12);
        ck_assert_double_eq_tol(w->ax[i], 0.05 * push, 1e-9);
    }
    sph2d_sim_destroy(sim);
    sph2d_sim_destroy(still);
}
END_TEST

/** Layers turn as a rigid body: distances stay, normals point to the surface as before, and a smooth turn has velocities
 *  at right angles to the arm. */
START_TEST(layers_turn_with_their_wall)
{
    obstacle.shape.kind = SPH2D_SHAPE_BOX;
    obstacle.shape.box = (sph2d_box){{0.2, 0.2}, {0.5, 0.4}};
    obstacle.motion = sph2d_motion_default();
    obstacle.motion.rate = 3;
    scene.method.time_step = 1e-3;
    sph2d_sim *still = test_create(&scene, NULL), *sim = test_create(&scene, NULL);
    test_steps(sim, 137);
    double angle = 3 * sph2d_sim_time(sim), c = cos(angle), s = sin(angle);
    const sph2d__store *w = &sim->system.walls, *before = &still->system.walls;
    for (size_t i = 0; i < w->count; ++i) {
        size_t k = 0;
        while (before->id[k] != w->id[i])
            ++k;
        double x = before->start_x[k] - 0.35, y = before->start_y[k] - 0.3;
        ck_assert_double_eq_tol(w->x[i], 0.35 + c * x - s * y, 1e-12);
        ck_assert_double_eq_tol(w->y[i], 0.3 + s * x + c * y, 1e-12);
        ck_assert_double_eq_tol(w->vx[i], -3 * (w->y[i] - 0.3), 1e-12);
        ck_assert_double_eq_tol(w->vy[i], 3 * (w->x[i] - 0.35), 1e-12);
        ck_assert_double_eq_tol(w->ax[i], -9 * (w->x[i] - 0.35), 1e-12);
        ck_assert_double_eq_tol(w->normal_x[i], c * before->normal_x[k] - s * before->normal_y[k], 1e-12);
        ck_assert_double_eq_tol(w->normal_y[i], s * before->normal_x[k] + c * before->normal_y[k], 1e-12);
    }
    sph2d_sim_destroy(sim);
    sph2d_sim_destroy(still);
}
END_TEST

START_TEST(a_piston_pushes_a_lone_particle_and_is_never_passed)
{
    static sph2d_pose_point way[2] = {{0.1, 0, 0, 0}, {0.2, 0.4, 0, 0}}; /* 4 m/s */
    obstacle.shape.kind = SPH2D_SHAPE_BOX;
    obstacle.shape.box = (sph2d_box){{0.2, 0.2}, {0.3, 0.8}};
    obstacle.motion.path = (sph2d_pose_path){way, 2};
    block = test_particle(DX, 0.45, 0.5, -2, 0.1);
    sph2d_sim *sim = test_create(&scene, NULL);
    while (sph2d_sim_time(sim) < 0.19) {
        test_steps(sim, 1);
        double t = sph2d_sim_time(sim), face = 0.3 + (t < 0.1 ? 0 : 4 * (t - 0.1));
        ck_assert_double_gt(sph2d_sim_fluid(sim).x[0], face);
    }
    ck_assert_double_gt(sph2d_sim_fluid(sim).vx[0], 3.9);
    ck_assert_double_lt(sph2d_sim_fluid(sim).vx[0], 12);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(a_run_with_moving_walls_goes_on_from_its_state_bit_by_bit)
{
    obstacle.shape.kind = SPH2D_SHAPE_BOX;
    obstacle.shape.box = (sph2d_box){{0.2, 0.0}, {0.3, 0.3}};
    obstacle.motion = (sph2d_motion){.amplitude = {0.03, 0}, .angle = 0.1, .frequency = 4, .center = {0.25, 0.15}};
    scene.boundary = (sph2d_boundary){SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_OPEN};
    scene.gravity.y = -9.81;
    block = test_block(0.35, 0, 0.6, 0.2);
    sph2d_sim *sim = test_create(&scene, NULL), *back = NULL;
    test_steps(sim, 40);
    test_state state = test_state_copy(sim);
    ck_assert_int_eq(sph2d_sim_restore(&scene, NULL, &state.state, &back, NULL), SPH2D_OK);
    test_steps(sim, 40);
    test_steps(back, 40);
    sph2d_view a = sph2d_sim_fluid(sim), b = sph2d_sim_fluid(back);
    ck_assert_uint_eq(a.count, b.count);
    ck_assert_mem_eq(a.x, b.x, a.count * sizeof *a.x);
    ck_assert_mem_eq(a.vy, b.vy, a.count * sizeof *a.vy);
    ck_assert_mem_eq(a.density, b.density, a.count * sizeof *a.density);
    test_state_free(&state);
    sph2d_sim_destroy(sim);
    sph2d_sim_destroy(back);
}
END_TEST

Suite *suite_layers(void)
{
    Suite *suite = suite_create("layers");
    TCase *tests = tcase_create("layers");
    tcase_add_checked_fixture(tests, start, NULL);
    tcase_add_test(tests, sides_continue_the_lattice_outside);
    tcase_add_test(tests, walls_beside_open_sides_go_on_and_beside_periodic_ones_close_the_period);
    tcase_add_test(tests, a_solid_box_has_layers_inside);
    tcase_add_test(tests, a_thin_solid_is_filled_once);
    tcase_add_loop_test(tests, a_solid_thinner_than_its_layers_is_filled_once_whatever_its_thickness, 0, 10);
    tcase_add_loop_test(tests, a_sharp_corner_is_filled_once_up_to_its_tip, 0, 7);
    tcase_add_test(tests, a_trough_has_layers_on_all_its_faces);
    tcase_add_test(tests, a_circle_has_rings_of_its_area);
    tcase_add_test(tests, a_polyline_has_mitred_layers_on_its_right);
    tcase_add_test(tests, a_swinging_wall_is_where_its_law_says);
    tcase_add_test(tests, layers_turn_with_their_wall);
    tcase_add_test(tests, a_piston_pushes_a_lone_particle_and_is_never_passed);
    tcase_add_test(tests, a_run_with_moving_walls_goes_on_from_its_state_bit_by_bit);
    suite_add_tcase(suite, tests);
    return suite;
}
