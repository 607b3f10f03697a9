/* SPDX-License-Identifier: MIT */
/** @file test_packing.c
 *  All the liquid that was asked for: the area of blocks at walls of any slope, arcs and corners; lattices that fit
 *  stay. */
#include <math.h>

#include "packed.h"

/** Area asked for, and number of particles, against a known area. */
static void check_area(double area)
{
    sph2d_sim *sim = test_create(&packed.scene, NULL);
    const sph2d_plan *plan = sph2d_sim_plan(sim);
    double count = (double)sph2d_sim_fluid(sim).count;
    ck_assert_double_eq_tol(plan->area_asked, area, 3e-4 * area);
    ck_assert_double_eq_tol(plan->area_placed, count * DX * DX, 1e-12);
    ck_assert_double_eq_tol(count * DX * DX, area, fmax(0.002 * area, 0.51 * DX * DX));
    ck_assert_uint_eq(plan->places_left_free, 0);
    sph2d_sim_destroy(sim);
}

/* ---- area -------------------------------------------------------------------------------------------------------- */

START_TEST(wedges_are_filled)
{
    static const double degrees[] = {10, 20, 45, 90, 117, 160};
    check_area(packed_set_wedge(degrees[_i]));
}
END_TEST

START_TEST(discs_of_any_radius_are_filled)
{
    static const double radii[] = {2.1, 5, 10, 10.4, 17.77, 25};
    double r = radii[_i / 2] * DX;
    packed.block = sph2d_block_default();
    packed.block.shape.kind = SPH2D_SHAPE_CIRCLE;
    packed.block.shape.circle = (sph2d_circle){{0.5, 0.5}, r};
    bool whole = _i == 5 || _i == 11; /* rings are whole spacings wide */
    packed.block.arrangement = whole ? SPH2D_ARRANGEMENT_RINGS : SPH2D_ARRANGEMENT_LATTICE;
    check_area(TEST_PI * r * r);
    sph2d_sim *sim = test_create(&packed.scene, NULL);
    sph2d_view f = sph2d_sim_fluid(sim);
    double x = 0, y = 0;
    for (size_t i = 0; i < f.count; ++i) {
        x += (f.x[i] - 0.5) / (double)f.count;
        y += (f.y[i] - 0.5) / (double)f.count;
    }
    ck_assert_double_le(hypot(x, y), _i < 2 || _i % 2 ? 0.01 * DX : 1e-12); /* the first and rings have no symmetry */
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(boxes_of_any_width_are_filled)
{
    /* Whole spacings; a little stretched; packed; thin. */
    static const double width[] = {0.4, 0.403, 0.1233, 0.0166, 1.0 / 3}, height[] = {0.2, 0.3, 0.0777, 0.5, 1.0 / 3};
    packed.block = test_block(0.1, 0.1, 0.1 + width[_i], 0.1 + height[_i]);
    check_area(width[_i] * height[_i]);
}
END_TEST

START_TEST(liquid_around_a_solid_fills_the_rest)
{
    double area = 0.6 * 0.4;
    packed.scene.obstacle_count = 1;
    if (_i == 0) {
        packed.obstacle.shape.kind = SPH2D_SHAPE_CIRCLE;
        packed.obstacle.shape.circle = (sph2d_circle){{0.3, 0.2}, 0.093};
        area -= TEST_PI * 0.093 * 0.093;
    } else if (_i == 1) { /* half of it out of the liquid */
        packed.obstacle.shape.kind = SPH2D_SHAPE_CIRCLE;
        packed.obstacle.shape.circle = (sph2d_circle){{0.3, 0.4}, 0.1};
        area -= TEST_PI * 0.01 / 2;
    } else if (_i == 2) { /* a ramp in the corner */
        packed.line[0] = (sph2d_vec2){0.3, 0};
        packed.line[1] = (sph2d_vec2){0.6, 0};
        packed.line[2] = (sph2d_vec2){0.6, 0.17};
        packed.obstacle.shape.kind = SPH2D_SHAPE_POLYGON;
        packed.obstacle.shape.points = (sph2d_points){packed.line, 3};
        area -= 0.3 * 0.17 / 2;
    } else { /* sides that no row meets */
        packed.obstacle.shape.kind = SPH2D_SHAPE_BOX;
        packed.obstacle.shape.box = (sph2d_box){{0.2033, 0.1011}, {0.3377, 0.2777}};
        area -= (0.3377 - 0.2033) * (0.2777 - 0.1011);
    }
    check_area(area);
}
END_TEST

START_TEST(a_polygon_with_an_arc_is_filled)
{
    /* Three quarters of a disc of 0.3 m, in 54 sides, and its corner in the middle. */
    size_t n = 0;
    packed.corners[n++] = (sph2d_vec2){0.5, 0.5};
    for (int k = 0; k <= 54; ++k) {
        double angle = 1.5 * TEST_PI * k / 54;
        packed.corners[n++] = (sph2d_vec2){0.5 + 0.3 * cos(angle), 0.5 + 0.3 * sin(angle)};
    }
    packed_set_polygon(n);
    check_area(54 * 0.5 * 0.09 * sin(1.5 * TEST_PI / 54));
}
END_TEST

START_TEST(a_tank_that_is_turned_is_filled_by_its_own_lattice)
{
    packed_set_turned_tank(30);
    check_area(0.18);
    sph2d_sim *sim = test_create(&packed.scene, NULL);
    sph2d_view f = sph2d_sim_fluid(sim);
    double c = cos(TEST_PI / 6), s = sin(TEST_PI / 6);
    for (size_t i = 0; i < f.count; ++i) {
        double x = f.x[i] - 0.3, y = f.y[i] - 0.1, column = (c * x + s * y) / DX, row = (c * y - s * x) / DX;
        ck_assert_double_eq_tol(column, floor(column) + 0.5, 0.02);
        ck_assert_double_eq_tol(row, floor(row) + 0.5, 0.02);
    }
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(a_polygon_is_packed_from_the_sides_that_fit_its_rows)
{
    /* A tank with a step, whose longest side is the surface, 53.37 spacings long: its columns begin at the other two
     * upright sides, so that the lattice stays but for those beside the third. */
    static const sph2d_vec2 tank[6] = {{0, 0.4}, {0, 0}, {0.4, 0}, {0.4, 0.1}, {0.5337, 0.1}, {0.5337, 0.4}};
    static const sph2d_vec2 liquid[6] = {{0.5337, 0.25}, {0, 0.25}, {0, 0}, {0.4, 0}, {0.4, 0.1}, {0.5337, 0.1}};
    static sph2d_vec2 wall[6];
    for (int k = 0; k < 6; ++k) {
        wall[k] = tank[k];
        packed.corners[k] = liquid[k];
    }
    packed_set_polygon(6);
    packed.obstacle.shape.kind = SPH2D_SHAPE_POLYLINE;
    packed.obstacle.shape.points = (sph2d_points){wall, 6};
    packed.scene.obstacle_count = 1;
    check_area(0.4 * 0.25 + 0.1337 * 0.15);
    sph2d_sim *sim = test_create(&packed.scene, NULL);
    sph2d_view f = sph2d_sim_fluid(sim);
    size_t on = 0;
    for (size_t i = 0; i < f.count; ++i) {
        double column = f.x[i] / DX, row = f.y[i] / DX;
        on += fabs(column - floor(column) - 0.5) < 0.02 && fabs(row - floor(row) - 0.5) < 0.02;
    }
    ck_assert_uint_gt(on, f.count * 8 / 10); /* 12 columns of 53 move */
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- lattices that stay ------------------------------------------------------------------------------------------ */

START_TEST(a_lattice_that_fits_stays_bit_for_bit)
{
    /* Beside walls and a solid that its rows fit, and around one in the air that takes nothing. */
    packed.scene.boundary = (sph2d_boundary){SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_OPEN};
    packed.scene.domain = (sph2d_box){{0, 0}, {0.6, 0.8}};
    packed.scene.obstacle_count = 1;
    packed.obstacle.shape.kind = _i ? SPH2D_SHAPE_CIRCLE : SPH2D_SHAPE_BOX;
    packed.obstacle.shape.circle = (sph2d_circle){{0.3, 0.65}, 0.1234};
    packed.obstacle.shape.box = (sph2d_box){{0.2, 0.1}, {0.3, 0.25}};
    sph2d_sim *sim = test_create(&packed.scene, NULL);
    sph2d_view f = sph2d_sim_fluid(sim);
    ck_assert_uint_eq(f.count, _i ? 2400 : 2400 - 150);
    double first_x = (0 + 0.6) / 2 - (60 - 1) / 2.0 * DX, first_y = (0 + 0.4) / 2 - (40 - 1) / 2.0 * DX;
    for (size_t i = 0; i < f.count; ++i) {
        double column = floor(f.x[i] / DX), row = floor(f.y[i] / DX);
        ck_assert(f.x[i] == first_x + column * DX && f.y[i] == first_y + row * DX);
    }
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(far_from_a_wall_that_takes_places_the_lattice_stays)
{
    packed.scene.obstacle_count = 1;
    packed.obstacle.shape.kind = SPH2D_SHAPE_CIRCLE;
    packed.obstacle.shape.circle = (sph2d_circle){{0.1, 0.1}, 0.05};
    sph2d_sim *sim = test_create(&packed.scene, NULL);
    sph2d_view f = sph2d_sim_fluid(sim);
    size_t off = 0, far = 0;
    for (size_t i = 0; i < f.count; ++i) {
        double column = f.x[i] / DX - 0.5, row = f.y[i] / DX - 0.5;
        bool on = fabs(column - floor(column + 0.5)) < 1e-9 && fabs(row - floor(row + 0.5)) < 1e-9;
        off += !on;
        far += !on && hypot(f.x[i] - 0.1, f.y[i] - 0.1) > 0.05 + 20 * DX; /* 12 cells to either side, and diagonally */
    }
    ck_assert_uint_gt(off, 100);
    ck_assert_uint_eq(far, 0);
    sph2d_sim_destroy(sim);
}
END_TEST

static sph2d_vec2 place_of(sph2d_view f, uint64_t id)
{
    size_t i = test_find(f, id);
    return (sph2d_vec2){f.x[i], f.y[i]};
}

START_TEST(a_box_that_nearly_fits_is_stretched)
{
    packed.block =
        test_block(0.1, 0.1, 0.503, 0.402); /* 40.3 by 30.2: 40 by 30 is 1.4 % short, 41 by 30 1.1 % too much */
    sph2d_sim *sim = test_create(&packed.scene, NULL);
    ck_assert_uint_eq(sph2d_sim_fluid(sim).count, 1217); /* so it is packed */
    sph2d_sim_destroy(sim);
    packed.block = test_block(0.1, 0.1, 1.1505, 0.4); /* 105.05 by 30 */
    sim = test_create(&packed.scene, NULL);
    sph2d_view f = sph2d_sim_fluid(sim);
    ck_assert_uint_eq(f.count, 105 * 30);
    ck_assert_double_eq_tol(place_of(f, 1).x - place_of(f, 0).x, DX, 1e-12); /* near enough as it is */
    sph2d_sim_destroy(sim);
    packed.block = test_block(0.1, 0.1, 0.503, 0.2986); /* 40.3 by 19.86: 40 by 20 */
    sim = test_create(&packed.scene, NULL);
    f = sph2d_sim_fluid(sim);
    ck_assert_uint_eq(f.count, 800);
    ck_assert_double_eq_tol(place_of(f, 1).x - place_of(f, 0).x, 0.403 / 40, 1e-12);
    ck_assert_double_eq_tol(place_of(f, 40).y - place_of(f, 0).y, 0.1986 / 20, 1e-12);
    sph2d_sim_destroy(sim);
    packed.block =
        test_block(0.1, 0.1, 0.3038, 0.6966); /* 20.38 by 59.66, 1215.9: 20 by 60 is short, 1.9 % and 0.6 % off */
    sim = test_create(&packed.scene, NULL);
    ck_assert_uint_eq(sph2d_sim_fluid(sim).count, 1216);
    sph2d_sim_destroy(sim);
    packed.block = test_block(0.1, 0.1, 0.308, 0.5032); /* 20.8 by 40.32, 838.7: 21 by 40 is 840, 0.16 % more */
    sim = test_create(&packed.scene, NULL);
    f = sph2d_sim_fluid(sim);
    ck_assert_uint_eq(f.count, 840);
    ck_assert_double_eq_tol(place_of(f, 1).x - place_of(f, 0).x, 0.208 / 21, 1e-12);
    ck_assert_double_eq_tol(place_of(f, 21).y - place_of(f, 0).y, 0.4032 / 40, 1e-12);
    ck_assert_double_eq_tol(place_of(f, 0).x, 0.1 + 0.208 / 42, 1e-12);
    sph2d_sim_destroy(sim);
}
END_TEST

Suite *suite_packing(void)
{
    Suite *suite = suite_create("packing");
    TCase *tests = tcase_create("packing");
    tcase_add_checked_fixture(tests, packed_start, NULL);
    tcase_add_loop_test(tests, discs_of_any_radius_are_filled, 0, 12);
    tcase_add_loop_test(tests, boxes_of_any_width_are_filled, 0, 5);
    tcase_add_loop_test(tests, liquid_around_a_solid_fills_the_rest, 0, 4);
    tcase_add_test(tests, a_polygon_with_an_arc_is_filled);
    tcase_add_test(tests, a_tank_that_is_turned_is_filled_by_its_own_lattice);
    tcase_add_test(tests, a_polygon_is_packed_from_the_sides_that_fit_its_rows);
    tcase_add_loop_test(tests, a_lattice_that_fits_stays_bit_for_bit, 0, 2);
    tcase_add_test(tests, far_from_a_wall_that_takes_places_the_lattice_stays);
    tcase_add_test(tests, a_box_that_nearly_fits_is_stretched);
    suite_add_tcase(suite, tests);
    TCase *slow = test_long(suite);
    tcase_add_checked_fixture(slow, packed_start, NULL);
    tcase_add_loop_test(slow, wedges_are_filled, 0, 6);
    return suite;
}
