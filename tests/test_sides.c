/* SPDX-License-Identifier: MIT */
/** @file test_sides.c
 *  On which side of an open wall the liquid is, walls with liquid on both sides, polygons as solids, and the fault of
 *  liquid in the layers of a wall. */
#include <math.h>
#include <string.h>

#include "common.h"
#include "scene/shape.h"
#include "sim/simulation.h"

static const double DX = 0.02;
enum { LAYERS = 3 }; /* H = 3 dx */

static sph2d_vec2 points[4];
static sph2d_block blocks[2];
static sph2d_obstacle obstacles[2];
static sph2d_scene scene;
static sph2d_report report;

/** A box of 1 m with a line that stands on its floor at x = 0.2, drawn upwards: its left is x < 0.2. */
static void start(void)
{
    scene = sph2d_scene_default();
    scene.domain = (sph2d_box){{0, 0}, {1, 1}};
    scene.spacing = DX;
    scene.method.name = SPH2D_METHOD_WCSPH;
    points[0] = (sph2d_vec2){0.2, 0};
    points[1] = (sph2d_vec2){0.2, 0.5};
    obstacles[0] = obstacles[1] = sph2d_obstacle_default();
    obstacles[0].shape.kind = SPH2D_SHAPE_LINE;
    obstacles[0].shape.points = (sph2d_points){points, 2};
    blocks[0] = test_block(0.2, 0, 0.6, 0.4);
    scene.obstacles = obstacles;
    scene.obstacle_count = 1;
    scene.blocks = blocks;
    scene.block_count = 1;
    sph2d_report_clear(&report);
}

/** Boundary particles of obstacle 0 on the left of x = 0.2 less those on its right. */
static int layers_on_the_left(const sph2d_sim *sim)
{
    const sph2d__store *w = &sim->system.walls;
    int count = 0;
    for (size_t i = 0; i < w->count; ++i)
        if (w->id[i] < sim->wall_ids[SPH2D__WALL_OBSTACLE].end)
            count += w->x[i] < 0.2 ? 1 : -1;
    return count;
}

static bool is_refused(sph2d_code code, const char *path)
{
    sph2d_plan plan;
    sph2d_report_clear(&report);
    return sph2d_scene_plan(&scene, &plan, &report) == SPH2D_SCENE && test_report_has(&report, code, path);
}

/* ---- found, or named --------------------------------------------------------------------------------------------- */

START_TEST(layers_are_where_the_liquid_is_not)
{
    if (_i % 2) { /* drawn downwards */
        points[0] = (sph2d_vec2){0.2, 0.5};
        points[1] = (sph2d_vec2){0.2, 0};
    }
    bool liquid_left = _i / 2 % 2;
    if (liquid_left)
        blocks[0] = test_block(0, 0, 0.2, 0.4);
    if (_i / 4) /* not beside the line, but nearest to it there; more lies far off on the other side */
        blocks[0] = liquid_left ? test_block(0, 0.2, 0.1, 0.4) : test_block(0.3, 0, 0.6, 0.4);
    sph2d_sim *sim = test_create(&scene, NULL);
    ck_assert_int_eq(layers_on_the_left(sim), (liquid_left ? -1 : 1) * LAYERS * 25);
    ck_assert_int_eq(sph2d_sim_scene(sim)->obstacles[0].liquid,
                     liquid_left == (_i % 2 == 0) ? SPH2D_LIQUID_LEFT : SPH2D_LIQUID_RIGHT);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(a_source_tells_the_side_too)
{
    sph2d_source source = sph2d_source_default();
    source.speed = 1;
    source.at = (sph2d_vec2){_i ? 0.1 : 0.9, 0.9};
    scene.sources = &source;
    scene.source_count = 1;
    scene.block_count = 0;
    sph2d_sim *sim = test_create(&scene, NULL);
    ck_assert_int_eq(layers_on_the_left(sim), (_i ? -1 : 1) * LAYERS * 25);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(of_two_blocks_the_nearer_tells_the_side)
{
    points[0].x = points[1].x = 0.6; /* neither block is beside the line, and the right one is twice as far from it */
    blocks[_i] = test_block(0.4, 0, 0.5, 0.4);
    blocks[1 - _i] = test_block(0.8, 0, 0.96, 0.4);
    scene.block_count = 2;
    sph2d_sim *sim = test_create(&scene, NULL);
    ck_assert_int_eq(sph2d_sim_scene(sim)->obstacles[0].liquid, SPH2D_LIQUID_LEFT);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(sources_on_both_sides_are_both_seen)
{
    sph2d_source sources[2] = {sph2d_source_default(), sph2d_source_default()};
    sources[0].at = (sph2d_vec2){0.15, 0.4};
    sources[1].at = (sph2d_vec2){0.22, 0.4};
    sources[0].speed = sources[1].speed = 1;
    scene.sources = sources;
    scene.source_count = 2;
    scene.block_count = 0;
    ck_assert(is_refused(SPH2D_CODE_CONFLICT, "obstacles[0].line"));
}
END_TEST

START_TEST(the_side_of_a_corner_is_that_of_both_its_pieces)
{
    /* A vessel of 20 degrees; the liquid is in it, or around it: near its tip places are nearest to the corner. */
    sph2d_vec2 vessel[3] = {{0.4, 0.9}, {0.5, 0.33}, {0.6, 0.9}};
    obstacles[0].shape.kind = SPH2D_SHAPE_POLYLINE;
    obstacles[0].shape.points = (sph2d_points){vessel, 3};
    blocks[0] = _i ? test_block(0, 0, 1, 0.2) : test_block(0.46, 0.7, 0.54, 0.8);
    sph2d_sim *sim = test_create(&scene, NULL);
    ck_assert_int_eq(sph2d_sim_scene(sim)->obstacles[0].liquid, _i ? SPH2D_LIQUID_RIGHT : SPH2D_LIQUID_LEFT);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(a_wall_drawn_the_wrong_way_round_holds_its_liquid)
{
    static const sph2d_method methods[] = {SPH2D_METHOD_WCSPH, SPH2D_METHOD_PCISPH, SPH2D_METHOD_CONSTRAINT};
    scene.method.name = methods[_i];
    sph2d_sim *sim = test_create(&scene, NULL);
    double start_energy = sph2d_sim_summary(sim).energy_start;
    while (sph2d_sim_time(sim) < 0.3)
        test_steps(sim, 1);
    sph2d_summary now = sph2d_sim_summary(sim);
    ck_assert_uint_eq(now.particles, 400);
    ck_assert_double_lt(now.kinetic + now.potential, start_energy);
    sph2d_view f = sph2d_sim_fluid(sim);
    for (size_t i = 0; i < f.count; ++i)
        ck_assert(f.x[i] > 0.2 || f.y[i] > 0.5);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(lines_of_one_particle_have_no_side)
{
    scene.method = sph2d_scene_default().method;
    scene.method.name = SPH2D_METHOD_MULLER;
    blocks[0] = test_block(0.1, 0, 0.6, 0.4);
    sph2d_plan plan;
    ck_assert_int_eq(sph2d_scene_plan(&scene, &plan, &report), SPH2D_OK);
}
END_TEST

/* ---- both sides -------------------------------------------------------------------------------------------------- */

START_TEST(liquid_on_both_sides_must_be_said)
{
    blocks[0] = test_block(0, 0, 0.6, 0.4);
    ck_assert_msg(is_refused(SPH2D_CODE_CONFLICT, "obstacles[0].line"), "%s", test_report_text(&report));
    ck_assert_ptr_nonnull(strstr(report.items[0].hint, "`liquid: both`"));
    blocks[0] = test_block(0.2, 0, 0.6, 0.4); /* as far off as the layers are thick there is room */
    blocks[1] = test_block(0, 0, 0.2 - LAYERS * DX, 0.4);
    scene.block_count = 2;
    sph2d_plan plan;
    sph2d_report_clear(&report);
    ck_assert_msg(sph2d_scene_plan(&scene, &plan, &report) == SPH2D_OK, "%s", test_report_text(&report));
    blocks[1] = test_block(0, 0, 0.2 - (LAYERS - 1) * DX, 0.4);
    ck_assert_msg(is_refused(SPH2D_CODE_CONFLICT, "obstacles[0].line"), "%s", test_report_text(&report));
}
END_TEST

START_TEST(a_wall_between_two_liquids_is_a_solid_and_keeps_them_apart)
{
    blocks[0] = test_block(0, 0, 0.5, 0.4);
    points[0].x = points[1].x = 0.25;
    obstacles[0].liquid = SPH2D_LIQUID_BOTH;
    sph2d_sim *sim = test_create(&scene, NULL);
    const sph2d__store *w = &sim->system.walls;
    double half = LAYERS * DX / 2, area = 0;
    for (size_t i = 0; i < w->count; ++i)
        if (w->id[i] < sim->wall_ids[SPH2D__WALL_OBSTACLE].end) {
            ck_assert_double_lt(fabs(w->x[i] - 0.25), half);
            area += w->mass[i] / scene.fluid.density;
        }
    ck_assert_double_eq_tol(area, 2 * half * 0.5, 1.001 * DX * DX); /* filled once */
    size_t left = 0, right = 0;
    sph2d_view f = sph2d_sim_fluid(sim);
    for (size_t i = 0; i < f.count; ++i) {
        ck_assert_double_gt(fabs(f.x[i] - 0.25), half + 0.4 * DX);
        left += f.x[i] < 0.25;
        right += f.x[i] > 0.25;
    }
    ck_assert_double_eq_tol((double)left * DX * DX, (0.25 - half) * 0.4, 2 * DX * DX);
    ck_assert_double_eq_tol((double)right * DX * DX, (0.25 - half) * 0.4, 2 * DX * DX);
    while (sph2d_sim_time(sim) < 0.1)
        test_steps(sim, 1);
    f = sph2d_sim_fluid(sim);
    for (size_t i = 0; i < f.count; ++i)
        left -= f.x[i] < 0.25 && f.y[i] < 0.5;
    ck_assert_uint_eq(left, 0);
    sph2d_sim_destroy(sim);
}
END_TEST

/** Particles of the packing between its arms are moved off its layers, not left where rounding finds them too near. */
START_TEST(a_line_of_several_pieces_makes_its_room_as_one_does)
{
    sph2d_vec2 zigzag[4];
    const size_t count = _i % 2 ? 3 : 4;
    blocks[0] = test_block(0, 0, 1, 0.5);
    obstacles[0].shape.kind = SPH2D_SHAPE_POLYLINE;
    obstacles[0].shape.points = (sph2d_points){zigzag, count};
    obstacles[0].liquid = SPH2D_LIQUID_BOTH;
    for (size_t k = 0; k < count; ++k)
        zigzag[k] = (sph2d_vec2){0.2 + 0.15 * (double)k, k % 2 ? 0.15 : 0.25 + 0.002 * _i};
    sph2d_plan plan;
    ck_assert_msg(sph2d_scene_plan(&scene, &plan, &report) == SPH2D_OK, "%s", test_report_text(&report));
    ck_assert_double_eq_tol(plan.area_placed, plan.area_asked, 0.002 * plan.area_asked);
}
END_TEST

START_TEST(a_line_that_turns_back_is_no_solid)
{
    sph2d_vec2 hairpin[3] = {{0.3, 0.9}, {0.5, 0.6}, {0.7, 0.9}};
    obstacles[0].shape.kind = SPH2D_SHAPE_POLYLINE;
    obstacles[0].shape.points = (sph2d_points){hairpin, 3};
    obstacles[0].liquid = SPH2D_LIQUID_BOTH;
    sph2d_plan plan;
    ck_assert_msg(sph2d_scene_plan(&scene, &plan, &report) == SPH2D_OK, "%s", test_report_text(&report));
    hairpin[2].x = 0.45;
    ck_assert_msg(is_refused(SPH2D_CODE_CONFLICT, "obstacles[0].polyline"), "%s", test_report_text(&report));
    ck_assert_ptr_nonnull(strstr(report.items[0].hint, "polygon"));
}
END_TEST

START_TEST(nothing_gets_between_the_layers_from_behind)
{
    /* A particle is thrown at the back of the wall. */
    blocks[0] = test_block(0.2, 0, 0.6, 0.1);
    blocks[1] = test_particle(DX, 0.05, 0.3, 20, 0);
    scene.block_count = 2;
    scene.method.sound_speed = 40;
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d_view f = sph2d_sim_fluid(sim);
    uint64_t id = f.id[f.count - 1];
    while (sph2d_sim_time(sim) < 0.05) {
        test_steps(sim, 1);
        f = sph2d_sim_fluid(sim);
        ck_assert_double_lt(f.x[test_find(f, id)], 0.2 - LAYERS * DX);
    }
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- liquid in the layers ---------------------------------------------------------------------------------------- */

START_TEST(liquid_in_the_layers_is_refused_with_their_place)
{
    obstacles[0].liquid = SPH2D_LIQUID_LEFT; /* it lies on the right */
    ck_assert_msg(is_refused(SPH2D_CODE_OVERLAP, "obstacles[0].line"), "%s", test_report_text(&report));
    ck_assert_ptr_nonnull(strstr(report.items[0].hint, "`liquid: right`"));
    obstacles[0].liquid = SPH2D_LIQUID_RIGHT;
    sph2d_plan plan;
    sph2d_report_clear(&report);
    ck_assert_int_eq(sph2d_scene_plan(&scene, &plan, &report), SPH2D_OK);
}
END_TEST

START_TEST(a_shape_that_is_refused_has_its_word)
{
    obstacles[0].shape =
        (sph2d_shape){.kind = SPH2D_SHAPE_ARC, .arc = {.center = {0.3, 0.45}, .radius = 0.15, .from = 3.5, .to = 5.9}};
    obstacles[0].liquid = SPH2D_LIQUID_LEFT;
    ck_assert_msg(is_refused(SPH2D_CODE_OVERLAP, "obstacles[0].arc"), "%s", test_report_text(&report));
}
END_TEST

START_TEST(a_particle_within_a_tenth_of_a_spacing_of_a_wall_is_refused)
{
    sph2d_particle one = {0.2 + (_i ? 0.12 : 0.08) * DX, 0.45, 0, 0, 1000, 0}; /* 0.5 more to the first layer */
    scene.method.sound_speed = 40;
    scene.particles = (sph2d_particles){NULL, &one, 1};
    sph2d_plan plan;
    if (_i)
        ck_assert_msg(sph2d_scene_plan(&scene, &plan, &report) == SPH2D_OK, "%s", test_report_text(&report));
    else
        ck_assert_msg(is_refused(SPH2D_CODE_OVERLAP, "obstacles[0].line"), "%s", test_report_text(&report));
}
END_TEST

/* ---- polygons ---------------------------------------------------------------------------------------------------- */

START_TEST(a_polygon_is_a_solid_whichever_way_round)
{
    /* A hexagon, and the same with a notch. */
    sph2d_vec2 corners[7] = {{0.7, 0.5}, {0.6, 0.67}, {0.4, 0.67}, {0.3, 0.5}, {0.4, 0.33}, {0.6, 0.33}, {0.52, 0.5}};
    size_t count = _i / 2 ? 7 : 6;
    for (size_t k = 0; _i % 2 && k < count / 2; ++k) {
        sph2d_vec2 other = corners[k];
        corners[k] = corners[count - 1 - k];
        corners[count - 1 - k] = other;
    }
    obstacles[0].shape.kind = SPH2D_SHAPE_POLYGON;
    obstacles[0].shape.points = (sph2d_points){corners, count};
    blocks[0] = test_block(0, 0, 1, 0.8);
    sph2d_sim *sim = test_create(&scene, NULL);
    const sph2d__store *w = &sim->system.walls;
    sph2d_view f = sph2d_sim_fluid(sim);
    sph2d_shape shape = {.kind = SPH2D_SHAPE_POLYGON, .points = {corners, count}};
    for (size_t i = 0; i < w->count; ++i)
        if (w->id[i] < sim->wall_ids[SPH2D__WALL_OBSTACLE].end)
            ck_assert(sph2d__shape_contains(&shape, (sph2d_vec2){w->x[i], w->y[i]}));
    for (size_t i = 0; i < f.count; ++i)
        ck_assert(!sph2d__shape_contains(&shape, (sph2d_vec2){f.x[i], f.y[i]}));
    ck_assert_double_eq_tol((double)f.count * DX * DX, 0.8 - sph2d__shape_area(&shape), 0.02);
    ck_assert_uint_gt(sim->wall_ids[SPH2D__WALL_OBSTACLE].end, 100);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(a_polygon_must_be_one)
{
    sph2d_vec2 corners[4] = {{0.5, 0.5}, {0.7, 0.7}, {0.7, 0.5}, {0.5, 0.7}};
    obstacles[0].shape.kind = SPH2D_SHAPE_POLYGON;
    obstacles[0].shape.points = (sph2d_points){corners, 4};
    ck_assert(is_refused(SPH2D_CODE_OUT_OF_RANGE, "obstacles[0].polygon"));
    obstacles[0].shape.points.count = 2;
    ck_assert(is_refused(SPH2D_CODE_OUT_OF_RANGE, "obstacles[0].polygon"));
    obstacles[0].shape.points.count = 3;
    corners[1].y = 1.7;
    ck_assert(is_refused(SPH2D_CODE_OUTSIDE, "obstacles[0].polygon"));
}
END_TEST

Suite *suite_sides(void)
{
    Suite *suite = suite_create("sides");
    TCase *tests = tcase_create("sides");
    tcase_add_checked_fixture(tests, start, NULL);
    tcase_add_loop_test(tests, layers_are_where_the_liquid_is_not, 0, 8);
    tcase_add_loop_test(tests, a_source_tells_the_side_too, 0, 2);
    tcase_add_loop_test(tests, of_two_blocks_the_nearer_tells_the_side, 0, 2);
    tcase_add_test(tests, sources_on_both_sides_are_both_seen);
    tcase_add_loop_test(tests, the_side_of_a_corner_is_that_of_both_its_pieces, 0, 2);
    tcase_add_loop_test(tests, a_wall_drawn_the_wrong_way_round_holds_its_liquid, 0, 3);
    tcase_add_test(tests, lines_of_one_particle_have_no_side);
    tcase_add_test(tests, liquid_on_both_sides_must_be_said);
    tcase_add_test(tests, a_wall_between_two_liquids_is_a_solid_and_keeps_them_apart);
    tcase_add_test(tests, a_line_that_turns_back_is_no_solid);
    tcase_add_test(tests, nothing_gets_between_the_layers_from_behind);
    tcase_add_test(tests, liquid_in_the_layers_is_refused_with_their_place);
    tcase_add_test(tests, a_shape_that_is_refused_has_its_word);
    tcase_add_loop_test(tests, a_particle_within_a_tenth_of_a_spacing_of_a_wall_is_refused, 0, 2);
    tcase_add_test(tests, a_polygon_must_be_one);
    suite_add_tcase(suite, tests);
    TCase *slow = test_long(suite);
    tcase_add_checked_fixture(slow, start, NULL);
    tcase_add_loop_test(slow, a_line_of_several_pieces_makes_its_room_as_one_does, 0, 24);
    tcase_add_loop_test(slow, a_polygon_is_a_solid_whichever_way_round, 0, 4);
    return suite;
}
