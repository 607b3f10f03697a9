/* SPDX-License-Identifier: MIT */
/** @file test_placing.c
 *  Where a scene's particles are placed, and the faults that only placing shows: overlapping blocks, no room, too many.
 */
#include <math.h>
#include <string.h>
#include <unistd.h>

#include "common.h"

static const double DX = 0.01;

static sph2d_block blocks[2];
static sph2d_scene scene;
static sph2d_plan plan;
static sph2d_report report;

static void start(void)
{
    blocks[0] = test_block(0.2, 0.1, 0.3, 0.2); /* 100 particles */
    scene = sph2d_scene_default();
    scene.method.name = SPH2D_METHOD_MULLER;
    scene.domain = (sph2d_box){{0, -0.1}, {1, 0.9}};
    scene.spacing = DX;
    scene.blocks = blocks;
    scene.block_count = 1;
    sph2d_report_clear(&report);
}

START_TEST(a_box_is_filled_from_half_a_spacing_inside)
{
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d_view f = sph2d_sim_fluid(sim);
    double worst = 0;
    for (size_t i = 0; i < f.count; ++i) {
        double column = (f.x[i] - 0.2) / DX - 0.5, row = (f.y[i] - 0.1) / DX - 0.5;
        worst = fmax(worst, fmax(fabs(column - (double)(f.id[i] % 10)), fabs(row - (double)(f.id[i] / 10))));
    }
    ck_assert_uint_eq(f.count, 100);
    ck_assert_double_le(worst, 1e-9);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(a_disc_and_a_polygon_hold_their_area)
{
    static const sph2d_vec2 corners[3] = {{0.1, 0.1}, {0.7, 0.1}, {0.1, 0.5}};
    double area = 0.6 * 0.4 / 2, x = 0, y = 0, radius = 14 * DX; /* 616 places, 615.75 wanted: no packing */
    blocks[0] = sph2d_block_default();
    blocks[0].shape.kind = _i ? SPH2D_SHAPE_POLYGON : SPH2D_SHAPE_CIRCLE;
    blocks[0].shape.points = (sph2d_points){corners, 3};
    blocks[0].shape.circle = (sph2d_circle){{0.4, 0.3}, radius};
    if (!_i)
        area = TEST_PI * radius * radius;
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d_view f = sph2d_sim_fluid(sim);
    size_t outside = 0;
    for (size_t i = 0; i < f.count; ++i) {
        x += f.x[i] / (double)f.count;
        y += f.y[i] / (double)f.count;
        outside += _i ? f.x[i] < 0.1 || f.y[i] < 0.1 || (f.x[i] - 0.1) / 0.6 + (f.y[i] - 0.1) / 0.4 > 1 + 1e-12
                      : hypot(f.x[i] - 0.4, f.y[i] - 0.3) > radius;
    }
    ck_assert_uint_eq(outside, 0);
    ck_assert_double_eq_tol((double)f.count * DX * DX / area, 1, 0.002);
    ck_assert_double_eq_tol(x, _i ? 0.3 : 0.4, _i ? 0.005 : 1e-12); /* a disc is symmetric about its centre */
    ck_assert_double_eq_tol(y, _i ? 0.1 + 0.4 / 3 : 0.3, _i ? 0.005 : 1e-12);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(a_finer_block_starts_compressed)
{
    blocks[0].spacing = DX / 2;
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d_view f = sph2d_sim_fluid(sim);
    ck_assert_uint_eq(f.count, 400);
    double highest = 0;
    for (size_t i = 0; i < f.count; ++i)
        highest = fmax(highest, f.density[i]);
    ck_assert_double_eq_tol(highest / 4000, 1, 0.03); /* the same mass on a quarter of the area */
    sph2d_sim_destroy(sim);
    scene.method = sph2d_scene_default().method;
    scene.method.name = SPH2D_METHOD_WCSPH;
    scene.method.sound_speed = 20;
    blocks[0].spacing = 0.97 * DX;
    sim = test_create(&scene, NULL);
    f = sph2d_sim_fluid(sim);
    for (size_t i = 0; i < f.count; ++i)
        ck_assert_double_eq_tol(f.density[i], 1000 / (0.97 * 0.97), 1e-9);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(obstacles_keep_their_places_free)
{
    sph2d_vec2 ends[2] = {{0.15, 0.15}, {0.345, 0.15}};
    sph2d_obstacle obstacles[2] = {sph2d_obstacle_default(), sph2d_obstacle_default()};
    obstacles[0].shape.kind = SPH2D_SHAPE_LINE;
    obstacles[0].shape.points = (sph2d_points){ends, 2};
    obstacles[1].shape.kind = SPH2D_SHAPE_CIRCLE;
    obstacles[1].shape.circle = (sph2d_circle){{0.3, 0.2}, 0.03};
    scene.obstacles = obstacles;
    scene.obstacle_count = 2;
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d_view f = sph2d_sim_fluid(sim), w = sph2d_sim_walls(sim);
    const sph2d_plan *p = sph2d_sim_plan(sim);
    ck_assert_uint_eq(p->fluid_particles + p->places_left_free, 100);
    ck_assert_uint_ge(p->places_left_free,
                      20 + 7); /* the rows 0.005 above and below the line, a quarter of the circle */
    ck_assert_uint_eq(p->wall_particles, w.count);
    ck_assert_uint_eq(w.count, 21 + 19); /* 19.5 spacings: 20 pieces; 18.8 spacings round the circle */
    double nearest = 1;
    for (size_t i = 0; i < f.count; ++i) {
        ck_assert(hypot(f.x[i] - 0.3, f.y[i] - 0.2) > 0.03);
        for (size_t b = 0; b < w.count; ++b)
            nearest = fmin(nearest, hypot(f.x[i] - w.x[b], f.y[i] - w.y[b]));
    }
    ck_assert_double_gt(nearest, 0.5 * DX);
    sph2d_sim_destroy(sim);
}
END_TEST

/** A solid that is drawn into a block takes its area from it, and the plan says how much of which. */
START_TEST(what_solids_take_is_told)
{
    static sph2d_obstacle solid;
    solid = sph2d_obstacle_default();
    solid.shape.kind = SPH2D_SHAPE_BOX;
    solid.shape.box = (sph2d_box){{0.5, 0.3}, {0.7, 0.6}};
    blocks[1] = test_block(0.4, 0.1, 0.7, 0.5); /* 0.12 m^2, 0.04 of them in the solid */
    scene.block_count = 2;
    ck_assert_int_eq(sph2d_scene_plan(&scene, &plan, &report), SPH2D_OK);
    ck_assert_double_eq(plan.area_left_out, 0);
    scene.obstacles = &solid;
    scene.obstacle_count = 1;
    ck_assert_int_eq(sph2d_scene_plan(&scene, &plan, &report), SPH2D_OK);
    ck_assert_double_eq_tol(plan.area_left_out, 0.04, 4e-5);
    ck_assert_double_eq_tol(plan.most_left_out, 1.0 / 3, 1e-3);
    ck_assert_uint_eq(plan.most_left_out_block, 1);
    ck_assert_double_eq_tol(plan.area_asked, 0.09, 4e-5);
}
END_TEST

START_TEST(sides_of_boundary_particles_are_a_spacing_away)
{
    /* They stand half a spacing outside the domain, and a block at the side starts half a spacing inside. */
    scene.walls = _i ? SPH2D_WALL_REFLECT : SPH2D_WALL_HEAVY;
    scene.boundary.right = SPH2D_SIDE_OPEN;
    blocks[0] = test_block(0, -0.1, 0.1, 0.1);
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d_view f = sph2d_sim_fluid(sim), w = sph2d_sim_walls(sim);
    ck_assert_uint_eq(f.count, 200);
    ck_assert_uint_eq(w.count, 201 + 201); /* left and bottom, each going on for as far beside the open sides */
    double out = 0, in = 1;
    for (size_t b = 0; b < w.count; ++b)
        out = fmax(out, fabs(fmin(w.x[b], w.y[b] + 0.1) + 0.5 * DX));
    for (size_t i = 0; i < f.count; ++i)
        in = fmin(in, fmin(f.x[i], f.y[i] + 0.1));
    ck_assert_double_le(out, 1e-12);
    ck_assert_double_eq_tol(in, 0.5 * DX, 1e-12);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(single_particles_are_placed_as_they_are)
{
    static const sph2d_particle items[2] = {{0.7, 0.5, 1, -2, 1003, 0}, {0.71, 0.5, 3, 4, 999, 0}};
    scene.particles = (sph2d_particles){NULL, items, 2};
    ck_assert_int_eq(sph2d_scene_check(&scene, &report), SPH2D_SCENE); /* no sound speed */
    ck_assert(test_report_has(&report, SPH2D_CODE_MISSING_KEY, "particles"));
    scene.method.name = SPH2D_METHOD_WCSPH;
    scene.method.sound_speed = 20;
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d_view f = sph2d_sim_fluid(sim);
    ck_assert_uint_eq(f.count, 102);
    for (size_t k = 0; k < 2; ++k) {
        size_t i = test_find(f, 100 + k);
        ck_assert(f.x[i] == items[k].x && f.y[i] == items[k].y && f.vx[i] == items[k].vx && f.vy[i] == items[k].vy);
        ck_assert_double_eq(f.density[i], items[k].density);
    }
    sph2d_sim_destroy(sim);
    scene.particles.items = NULL;
    ck_assert_int_eq(sph2d_scene_check(&scene, &report), SPH2D_SCENE);
    ck_assert(test_report_has(&report, SPH2D_CODE_CONFLICT, "particles"));
}
END_TEST

START_TEST(no_particle_found_room)
{
    sph2d_obstacle obstacle = sph2d_obstacle_default();
    obstacle.shape.kind = SPH2D_SHAPE_CIRCLE;
    obstacle.shape.circle = (sph2d_circle){{0.25, 0.15}, 0.09};
    scene.obstacles = &obstacle;
    scene.obstacle_count = 1;
    ck_assert_int_eq(sph2d_scene_plan(&scene, &plan, &report), SPH2D_SCENE);
    ck_assert(test_report_has(&report, SPH2D_CODE_NO_PARTICLES, "blocks"));
}
END_TEST

START_TEST(blocks_may_touch_but_not_overlap)
{
    scene.block_count = 2;
    blocks[1] = test_block(0.3, 0.1, 0.4, 0.2); /* edge to edge */
    sph2d_status status = sph2d_scene_plan(&scene, &plan, &report);
    ck_assert_msg(status == SPH2D_OK, "%s", test_report_text(&report));
    ck_assert_uint_eq(plan.fluid_particles, 200);
    blocks[1] = test_block(0.25, 0.15, 0.35, 0.25);
    ck_assert_int_eq(sph2d_scene_plan(&scene, &plan, &report), SPH2D_SCENE);
    ck_assert(test_report_has(&report, SPH2D_CODE_OVERLAP, "blocks[1]"));
    ck_assert_ptr_nonnull(strstr(test_report_text(&report), "blocks[0]"));
    sph2d_report_clear(&report);
    blocks[1] = sph2d_block_default();
    blocks[1].shape.kind = SPH2D_SHAPE_CIRCLE;
    blocks[1].shape.circle = (sph2d_circle){{0.33, 0.15}, 0.0501};
    ck_assert_int_eq(sph2d_scene_plan(&scene, &plan, &report), SPH2D_SCENE);
    ck_assert(test_report_has(&report, SPH2D_CODE_OVERLAP, "blocks[1]"));
    sph2d_report_clear(&report);
    blocks[1] = test_block(0.24, 0.14, 0.26, 0.16); /* a finer one inside, off the coarse one's places */
    blocks[1].spacing = DX / 4;
    ck_assert_int_eq(sph2d_scene_plan(&scene, &plan, &report), SPH2D_SCENE);
    ck_assert(test_report_has(&report, SPH2D_CODE_OVERLAP, "blocks[1]"));
}
END_TEST

START_TEST(blocks_may_not_interlock)
{
    /* Two lattices shifted by half a cell: twice the density, though no two places are closer than 0.7 of a spacing. */
    scene.block_count = 2;
    blocks[1] = test_block(0.205, 0.105, 0.305, 0.205);
    ck_assert_int_eq(sph2d_scene_plan(&scene, &plan, &report), SPH2D_SCENE);
    ck_assert(test_report_has(&report, SPH2D_CODE_OVERLAP, "blocks[1]"));
}
END_TEST

/* ---- too much ---------------------------------------------------------------------------------------------------- */

/** Memory from the C library up to a gigabyte, so that a wrong answer does not take the machine down. */
static void *resize_up_to_a_gigabyte(void *user, void *block, size_t old_size, size_t new_size)
{
    (void)user;
    return new_size > 1000000000u ? NULL : test_resize(block, old_size, new_size);
}

/** Tries to make the scene; *memory_named tells whether the message says how much it would take. */
static bool too_many(const char *path, bool *memory_named)
{
    sph2d_sim_options options = sph2d_sim_options_default();
    options.allocator.resize = resize_up_to_a_gigabyte;
    sph2d_sim *sim = NULL;
    sph2d_status status = sph2d_sim_create(&scene, &options, &sim, &report);
    sph2d_sim_destroy(sim);
    *memory_named = strstr(test_report_text(&report), "GB") != NULL;
    return status == SPH2D_SCENE && test_report_has(&report, SPH2D_CODE_TOO_MANY, path);
}

START_TEST(a_million_millions_are_refused_with_their_memory)
{
    bool memory_named;
    scene.domain = (sph2d_box){{0, 0}, {1e4, 1e4}};
    blocks[0] = test_block(0, 0, 1e4, 1e4); /* 10^12 at 0.01 m */
    ck_assert_msg(too_many("spacing", &memory_named), "%s", test_report_text(&report));
    ck_assert(memory_named);
    ck_assert_ptr_nonnull(strstr(test_report_text(&report), "1e+12 particles"));
    /* Numbers that no index holds are refused the same way. */
    scene.domain = (sph2d_box){{0, 0}, {1e7, 1e7}};
    blocks[0] = test_block(0, 0, 1e7, 1e7);
    sph2d_report_clear(&report);
    ck_assert_msg(too_many("spacing", &memory_named), "%s", test_report_text(&report));
    ck_assert(memory_named);
}
END_TEST

START_TEST(too_many_boundary_particles_are_refused)
{
    /* 9e8 for each time that a line goes there and back: 9e11, and (where that is too many for this machine) 9e8 of 100
     * bytes or more. */
    enum { TURNS = 1001 };
    static sph2d_vec2 turns[TURNS];
    double most = (double)sysconf(_SC_PHYS_PAGES) * (double)sysconf(_SC_PAGESIZE);
    if (_i == 1 && most > 9e8 * 100)
        return;
    for (int k = 0; k < TURNS; ++k)
        turns[k] = (sph2d_vec2){k % 2 ? 9e6 : 0, 0.0008 * k};
    bool memory_named;
    sph2d_obstacle obstacle = sph2d_obstacle_default();
    obstacle.shape.kind = SPH2D_SHAPE_POLYLINE;
    obstacle.shape.points = (sph2d_points){turns, _i == 0 ? TURNS : 2};
    scene.domain = (sph2d_box){{0, 0}, {9e6, 1}};
    scene.obstacles = &obstacle;
    scene.obstacle_count = 1;
    ck_assert_msg(too_many(NULL, &memory_named), "%s", test_report_text(&report));
}
END_TEST

/* An obstacle on a periodic side takes as many places as one inside. */
START_TEST(obstacles_take_places_across_periodic_sides)
{
    size_t counts[2];
    for (int k = 0; k < 2; ++k) {
        sph2d_scene room = test_scene(0.05, 0, 0, 1, 1);
        room.boundary =
            (sph2d_boundary){SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC};
        room.method = sph2d_scene_default().method;
        room.method.name = SPH2D_METHOD_MULLER;
        room.method.name = SPH2D_METHOD_WCSPH;
        room.method.sound_speed = 10;
        sph2d_obstacle obstacle = sph2d_obstacle_default();
        obstacle.shape.kind = SPH2D_SHAPE_CIRCLE;
        obstacle.shape.circle = (sph2d_circle){{k ? 0 : 0.5, 0.5}, 0.13};
        sph2d_block block = test_block(0, 0, 1, 1);
        room.obstacles = &obstacle;
        room.obstacle_count = 1;
        room.blocks = &block;
        room.block_count = 1;
        sph2d_sim *sim = test_create(&room, NULL);
        counts[k] = sph2d_sim_fluid(sim).count;
        sph2d_sim_destroy(sim);
    }
    ck_assert_uint_lt(counts[0], 400);
    ck_assert_uint_eq(counts[0], counts[1]);
}
END_TEST

Suite *suite_placing(void)
{
    Suite *suite = suite_create("placing");
    TCase *tests = tcase_create("placing");
    tcase_add_checked_fixture(tests, start, NULL);
    tcase_add_test(tests, a_box_is_filled_from_half_a_spacing_inside);
    tcase_add_loop_test(tests, a_disc_and_a_polygon_hold_their_area, 0, 2);
    tcase_add_test(tests, a_finer_block_starts_compressed);
    tcase_add_test(tests, obstacles_keep_their_places_free);
    tcase_add_test(tests, what_solids_take_is_told);
    tcase_add_loop_test(tests, sides_of_boundary_particles_are_a_spacing_away, 0, 2);
    tcase_add_test(tests, no_particle_found_room);
    tcase_add_test(tests, single_particles_are_placed_as_they_are);
    tcase_add_test(tests, blocks_may_touch_but_not_overlap);
    tcase_add_test(tests, blocks_may_not_interlock);
    tcase_add_test(tests, a_million_millions_are_refused_with_their_memory);
    tcase_add_loop_test(tests, too_many_boundary_particles_are_refused, 0, 2);
    tcase_add_test(tests, obstacles_take_places_across_periodic_sides);
    suite_add_tcase(suite, tests);
    return suite;
}
