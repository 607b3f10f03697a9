/* SPDX-License-Identifier: MIT */
/** @file test_packing.c
 *  All the liquid that was asked for: the area of blocks at walls of any slope, arcs and corners; lattices that fit
 *  stay; packed places are in equilibrium, deterministic, apart from each other and from walls, and start quietly. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common.h"
#include "sim/simulation.h"

static const double DX = 0.01;

static sph2d_vec2 corners[72], line[4];
static sph2d_block block;
static sph2d_obstacle obstacle;
static sph2d_scene scene;

static void start(void)
{
    scene = sph2d_scene_default();
    scene.domain = (sph2d_box){{-0.2, -0.2}, {1.2, 1.2}};
    scene.boundary = (sph2d_boundary){SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN};
    scene.spacing = DX;
    scene.method.name = SPH2D_METHOD_WCSPH;
    block = test_block(0, 0, 0.6, 0.4);
    scene.blocks = &block;
    scene.block_count = 1;
    obstacle = sph2d_obstacle_default();
    scene.obstacles = &obstacle;
    scene.obstacle_count = 0;
}

static void set_polygon(size_t count)
{
    block = sph2d_block_default();
    block.shape.kind = SPH2D_SHAPE_POLYGON;
    block.shape.polygon = (sph2d_points){corners, count};
}

static void set_line(size_t count)
{
    obstacle.outline.kind = SPH2D_OUTLINE_POLYLINE;
    obstacle.outline.polyline = (sph2d_points){line, count};
    scene.obstacle_count = 1;
}

/** Area asked for, and number of particles, against a known area. */
static void check_area(double area)
{
    sph2d_sim *sim = test_create(&scene, NULL);
    const sph2d_plan *plan = sph2d_sim_plan(sim);
    double count = (double)sph2d_sim_fluid(sim).count;
    ck_assert_double_eq_tol(plan->area_asked, area, 3e-4 * area);
    ck_assert_double_eq_tol(plan->area_placed, count * DX * DX, 1e-12);
    ck_assert_double_eq_tol(count * DX * DX, area, fmax(0.002 * area, 0.51 * DX * DX));
    ck_assert_uint_eq(plan->places_left_free, 0);
    sph2d_sim_destroy(sim);
}

/** A wedge whose walls are `degrees` apart, 0.5 m deep or 1 m wide. Returns its area. */
static double set_wedge(double degrees)
{
    double half = tan(degrees / 2 * TEST_PI / 180), depth = fmin(0.5, 0.5 / half), rim = 1.2 * depth;
    line[0] = (sph2d_vec2){0.5 - rim * half, rim};
    line[1] = (sph2d_vec2){0.5, 0};
    line[2] = (sph2d_vec2){0.5 + rim * half, rim};
    set_line(3);
    corners[0] = line[1];
    corners[1] = (sph2d_vec2){0.5 + depth * half, depth};
    corners[2] = (sph2d_vec2){0.5 - depth * half, depth};
    set_polygon(3);
    return depth * depth * half;
}

/** A tank 0.6 m by 0.4 m that is turned about (0.3, 0.1), with liquid 0.3 m deep. */
static void set_turned_tank(double degrees)
{
    static const sph2d_vec2 tank[4] = {{0, 0.4}, {0, 0}, {0.6, 0}, {0.6, 0.4}};
    static const sph2d_vec2 liquid[4] = {{0, 0}, {0.6, 0}, {0.6, 0.3}, {0, 0.3}};
    double c = cos(degrees * TEST_PI / 180), s = sin(degrees * TEST_PI / 180);
    for (int k = 0; k < 4; ++k) {
        line[k] = (sph2d_vec2){0.3 + c * tank[k].x - s * tank[k].y, 0.1 + s * tank[k].x + c * tank[k].y};
        corners[k] = (sph2d_vec2){0.3 + c * liquid[k].x - s * liquid[k].y, 0.1 + s * liquid[k].x + c * liquid[k].y};
    }
    set_line(4);
    set_polygon(4);
    scene.gravity = (sph2d_vec2){9.81 * s, -9.81 * c};
}

/* ---- area -------------------------------------------------------------------------------------------------------- */

START_TEST(wedges_are_filled)
{
    static const double degrees[] = {10, 20, 45, 90, 117, 160};
    check_area(set_wedge(degrees[_i]));
}
END_TEST

START_TEST(discs_of_any_radius_are_filled)
{
    static const double radii[] = {2.1, 5, 10, 10.4, 17.77, 25};
    double r = radii[_i / 2] * DX;
    block = sph2d_block_default();
    block.shape.kind = SPH2D_SHAPE_DISC;
    block.shape.disc = (sph2d_disc){{0.5, 0.5}, r};
    bool whole = _i == 5 || _i == 11; /* rings are whole spacings wide */
    block.arrangement = whole ? SPH2D_ARRANGEMENT_RINGS : SPH2D_ARRANGEMENT_LATTICE;
    check_area(TEST_PI * r * r);
    sph2d_sim *sim = test_create(&scene, NULL);
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
    block = test_block(0.1, 0.1, 0.1 + width[_i], 0.1 + height[_i]);
    check_area(width[_i] * height[_i]);
}
END_TEST

START_TEST(liquid_around_a_solid_fills_the_rest)
{
    double area = 0.6 * 0.4;
    scene.obstacle_count = 1;
    if (_i == 0) {
        obstacle.outline.kind = SPH2D_OUTLINE_CIRCLE;
        obstacle.outline.circle = (sph2d_disc){{0.3, 0.2}, 0.093};
        area -= TEST_PI * 0.093 * 0.093;
    } else if (_i == 1) { /* half of it out of the liquid */
        obstacle.outline.kind = SPH2D_OUTLINE_CIRCLE;
        obstacle.outline.circle = (sph2d_disc){{0.3, 0.4}, 0.1};
        area -= TEST_PI * 0.01 / 2;
    } else if (_i == 2) { /* a ramp in the corner */
        line[0] = (sph2d_vec2){0.3, 0};
        line[1] = (sph2d_vec2){0.6, 0};
        line[2] = (sph2d_vec2){0.6, 0.17};
        obstacle.outline.kind = SPH2D_OUTLINE_POLYGON;
        obstacle.outline.polygon = (sph2d_points){line, 3};
        area -= 0.3 * 0.17 / 2;
    } else { /* sides that no row meets */
        obstacle.outline.kind = SPH2D_OUTLINE_BOX;
        obstacle.outline.box = (sph2d_box){{0.2033, 0.1011}, {0.3377, 0.2777}};
        area -= (0.3377 - 0.2033) * (0.2777 - 0.1011);
    }
    check_area(area);
}
END_TEST

START_TEST(a_polygon_with_an_arc_is_filled)
{
    /* Three quarters of a disc of 0.3 m, in 54 sides, and its corner in the middle. */
    size_t n = 0;
    corners[n++] = (sph2d_vec2){0.5, 0.5};
    for (int k = 0; k <= 54; ++k) {
        double angle = 1.5 * TEST_PI * k / 54;
        corners[n++] = (sph2d_vec2){0.5 + 0.3 * cos(angle), 0.5 + 0.3 * sin(angle)};
    }
    set_polygon(n);
    check_area(54 * 0.5 * 0.09 * sin(1.5 * TEST_PI / 54));
}
END_TEST

START_TEST(a_tank_that_is_turned_is_filled_by_its_own_lattice)
{
    set_turned_tank(30);
    check_area(0.18);
    sph2d_sim *sim = test_create(&scene, NULL);
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
        corners[k] = liquid[k];
    }
    set_polygon(6);
    obstacle.outline.kind = SPH2D_OUTLINE_POLYLINE;
    obstacle.outline.polyline = (sph2d_points){wall, 6};
    scene.obstacle_count = 1;
    check_area(0.4 * 0.25 + 0.1337 * 0.15);
    sph2d_sim *sim = test_create(&scene, NULL);
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
    scene.boundary = (sph2d_boundary){SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_OPEN};
    scene.domain = (sph2d_box){{0, 0}, {0.6, 0.8}};
    scene.obstacle_count = 1;
    obstacle.outline.kind = _i ? SPH2D_OUTLINE_CIRCLE : SPH2D_OUTLINE_BOX;
    obstacle.outline.circle = (sph2d_disc){{0.3, 0.65}, 0.1234};
    obstacle.outline.box = (sph2d_box){{0.2, 0.1}, {0.3, 0.25}};
    sph2d_sim *sim = test_create(&scene, NULL);
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
    scene.obstacle_count = 1;
    obstacle.outline.kind = SPH2D_OUTLINE_CIRCLE;
    obstacle.outline.circle = (sph2d_disc){{0.1, 0.1}, 0.05};
    sph2d_sim *sim = test_create(&scene, NULL);
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
    block = test_block(0.1, 0.1, 0.503, 0.402); /* 40.3 by 30.2: 40 by 30 is 1.4 % short, 41 by 30 1.1 % too much */
    sph2d_sim *sim = test_create(&scene, NULL);
    ck_assert_uint_eq(sph2d_sim_fluid(sim).count, 1217); /* so it is packed */
    sph2d_sim_destroy(sim);
    block = test_block(0.1, 0.1, 1.1505, 0.4); /* 105.05 by 30 */
    sim = test_create(&scene, NULL);
    sph2d_view f = sph2d_sim_fluid(sim);
    ck_assert_uint_eq(f.count, 105 * 30);
    ck_assert_double_eq_tol(place_of(f, 1).x - place_of(f, 0).x, DX, 1e-12); /* near enough as it is */
    sph2d_sim_destroy(sim);
    block = test_block(0.1, 0.1, 0.503, 0.2986); /* 40.3 by 19.86: 40 by 20 */
    sim = test_create(&scene, NULL);
    f = sph2d_sim_fluid(sim);
    ck_assert_uint_eq(f.count, 800);
    ck_assert_double_eq_tol(place_of(f, 1).x - place_of(f, 0).x, 0.403 / 40, 1e-12);
    ck_assert_double_eq_tol(place_of(f, 40).y - place_of(f, 0).y, 0.1986 / 20, 1e-12);
    sph2d_sim_destroy(sim);
    block = test_block(0.1, 0.1, 0.3038, 0.6966); /* 20.38 by 59.66, 1215.9: 20 by 60 is short, 1.9 % and 0.6 % off */
    sim = test_create(&scene, NULL);
    ck_assert_uint_eq(sph2d_sim_fluid(sim).count, 1216);
    sph2d_sim_destroy(sim);
    block = test_block(0.1, 0.1, 0.308, 0.5032); /* 20.8 by 40.32, 838.7: 21 by 40 is 840, 0.16 % more */
    sim = test_create(&scene, NULL);
    f = sph2d_sim_fluid(sim);
    ck_assert_uint_eq(f.count, 840);
    ck_assert_double_eq_tol(place_of(f, 1).x - place_of(f, 0).x, 0.208 / 21, 1e-12);
    ck_assert_double_eq_tol(place_of(f, 21).y - place_of(f, 0).y, 0.4032 / 40, 1e-12);
    ck_assert_double_eq_tol(place_of(f, 0).x, 0.1 + 0.208 / 42, 1e-12);
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- equilibrium ------------------------------------------------------------------------------------------------- */

/** Wendland's C2 kernel: 140/pi (1 - q)^3 (x_j - x_i)/H^4 is the gradient of W_ij, to particle j. */
static void add_gradient(double x, double y, double support, double area, double *gx, double *gy)
{
    double q = hypot(x, y) / support;
    if (q >= 1)
        return;
    double slope = -140 / TEST_PI * (1 - q) * (1 - q) * (1 - q) / (support * support * support * support);
    *gx += area * slope * x;
    *gy += area * slope * y;
}

START_TEST(equal_pressure_pushes_no_packed_particle)
{
    /* Deep in a wedge, where nothing but liquid and layers is in reach, over all pairs. */
    set_wedge(_i ? 10 : 50);
    sph2d_sim *sim = test_create(&scene, NULL);
    const sph2d__store *w = &sim->system.walls;
    sph2d_view f = sph2d_sim_fluid(sim);
    double h = sim->system.support, worst = 0, nearest = 1, to_wall = 1;
    size_t looked_at = 0;
    for (size_t i = 0; i < f.count; ++i) {
        double gx = 0, gy = 0;
        for (size_t j = 0; j < f.count; ++j) {
            add_gradient(f.x[i] - f.x[j], f.y[i] - f.y[j], h, DX * DX, &gx, &gy);
            if (j != i)
                nearest = fmin(nearest, hypot(f.x[i] - f.x[j], f.y[i] - f.y[j]) / DX);
        }
        for (size_t b = 0; b < w->count; ++b) {
            add_gradient(f.x[i] - w->x[b], f.y[i] - w->y[b], h, w->mass[b] / 1000, &gx, &gy);
            to_wall = fmin(to_wall, hypot(f.x[i] - w->x[b], f.y[i] - w->y[b]) / DX);
        }
        if (f.y[i] > 0.5 - 2 * h || f.y[i] < 0.1)
            continue;
        worst = fmax(worst, hypot(gx, gy) * DX);
        ++looked_at;
    }
    ck_assert_uint_gt(looked_at, 100);
    ck_assert_double_lt(worst, 5e-3); /* 0.17 before anything moves; the most where the lattice begins that stays */
    ck_assert_double_gt(nearest, 0.8);
    ck_assert_double_gt(to_wall, 0.7);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(no_kernel_packs_particles_in_pairs)
{
    /* A lattice as dense has 1; by the cubic spline itself places came within 2e-7. */
    scene.method.kernel = (sph2d_kernel)_i;
    scene.method.support_ratio = 4;
    block = test_block(0.1, 0.1, 0.2893, 0.3451);
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d_view f = sph2d_sim_fluid(sim);
    double nearest = 1;
    for (size_t i = 0; i < f.count; ++i)
        for (size_t j = 0; j < i; ++j)
            nearest = fmin(nearest, hypot(f.x[i] - f.x[j], f.y[i] - f.y[j]) / DX);
    ck_assert_double_gt(nearest, 0.75);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(packed_liquid_is_as_dense_inside_as_it_was_asked_for)
{
    /* By counting, in boxes that are packed all over: up to 0.26 % denser against quarters of cells at H/dx = 3, and up to
     * 0.38 % packed by less than that. */
    static const double width[] = {0.1893, 0.1917, 0.1943}, ratio[] = {3, 2.4, 2};
    block = test_block(0.1, 0.1, 0.1 + width[_i % 3], 0.3451);
    scene.method.support_ratio = ratio[_i / 3];
    sph2d_sim *sim = test_create(&scene, NULL);
    ck_assert_double_eq_tol(sph2d_sim_densities(sim).counted, 1, _i < 3 ? 0.0012 : 0.0016);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(a_gap_between_liquid_and_a_wall_is_nobodys)
{
    /* A disc that comes within a quarter of a spacing of both walls of a wedge, boxes 0.3 and 0.9 spacings from a side
     * of the domain: their liquid does not go into the gap, which left up to 1.1 % too little inside. */
    if (_i == 0) {
        set_wedge(60);
        block = sph2d_block_default();
        block.shape.kind = SPH2D_SHAPE_DISC;
        block.shape.disc = (sph2d_disc){{0.5, 2 * (0.1105 + 0.0025)}, 0.1105};
    } else {
        double gap = _i == 1 ? 0.003 : 0.009;
        scene.boundary.left = SPH2D_SIDE_WALL;
        scene.domain = (sph2d_box){{0, 0}, {0.6, 0.8}};
        block = test_block(gap, 0.1, gap + 0.1893, 0.3451);
    }
    scene.method.support_ratio = 3;
    sph2d_sim *sim = test_create(&scene, NULL);
    ck_assert_double_eq_tol(sph2d_sim_densities(sim).counted, 1, 0.0015);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(packed_places_stay_out_of_springs)
{
    scene.method.name = SPH2D_METHOD_MULLER;
    scene.walls = SPH2D_WALL_SPRING;
    scene.boundary.bottom = SPH2D_SIDE_WALL;
    scene.domain = (sph2d_box){{0, 0}, {1.2, 1.2}};
    block = test_block(0.0099, 0, 0.1533, 0.2885); /* 14.34 by 28.85: the first row was 0.41 spacings from the side */
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d_view f = sph2d_sim_fluid(sim);
    for (size_t i = 0; i < f.count; ++i)
        ck_assert_double_ge(f.y[i], 0.45 * DX);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(packed_places_are_the_same_for_any_threads)
{
    set_wedge(33);
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = 3;
    sph2d_sim *one = test_create(&scene, NULL), *three = test_create(&scene, &options);
    sph2d_view a = sph2d_sim_fluid(one), b = sph2d_sim_fluid(three);
    ck_assert_uint_eq(a.count, b.count);
    ck_assert_mem_eq(a.x, b.x, a.count * sizeof *a.x);
    ck_assert_mem_eq(a.y, b.y, a.count * sizeof *a.y);
    sph2d_sim_destroy(one);
    sph2d_sim_destroy(three);
}
END_TEST

START_TEST(packed_liquid_at_rest_starts_quietly)
{
    /* Released at rest in a tank that is turned, it moves no faster than in a straight one; in wedges the particles in
     * the two corners of the surface find their places. Places cut out of a lattice made 0.18 of the wedge of 10
     * degrees. */
    static const double bounds[] = {0.015, 0.02, 0.008, 0.008};
    double depth = _i < 2 ? 0.5 : 0.3;
    if (_i < 2)
        set_wedge(_i ? 30 : 10);
    else
        set_turned_tank(_i == 2 ? 0 : 30);
    double g = 9.81, largest = 0;
    scene.method.kernel = SPH2D_KERNEL_WENDLAND_C4;
    scene.method.support_ratio = 4;
    scene.method.max_compression = 0.02;
    scene.method.artificial_viscosity = 0.1;
    block.start.kind = SPH2D_FLOW_STILL;
    block.start.center[0] = corners[2].x;
    block.start.center[1] = corners[2].y;
    sph2d_sim *sim = test_create(&scene, NULL);
    while (sph2d_sim_time(sim) < 0.15) {
        test_steps(sim, 1);
        largest = fmax(largest, sph2d_sim_summary(sim).speed_max);
    }
    ck_assert_double_lt(largest / sqrt(g * depth), bounds[_i]);
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- memory ------------------------------------------------------------------------------------------------------ */

static size_t calls, fail_at, held;

static void *resize(void *user, void *memory, size_t old_size, size_t new_size)
{
    (void)user;
    if (new_size > old_size && ++calls == fail_at)
        return NULL;
    held += new_size - old_size;
    return test_resize(memory, old_size, new_size);
}

START_TEST(a_packing_without_memory_is_no_harm)
{
    set_wedge(60);
    scene.spacing = 0.04;
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = 1;
    options.allocator.resize = resize;
    sph2d_status status = SPH2D_NOMEM;
    for (fail_at = 1; status != SPH2D_OK && fail_at < 500; ++fail_at) {
        sph2d_sim *sim = NULL;
        calls = held = 0;
        status = sph2d_sim_create(&scene, &options, &sim, NULL);
        ck_assert(status == SPH2D_OK || status == SPH2D_NOMEM);
        sph2d_sim_destroy(sim);
        ck_assert_uint_eq(held, 0);
    }
    ck_assert_int_eq(status, SPH2D_OK);
    ck_assert_uint_gt(fail_at, 30);
}
END_TEST

Suite *suite_packing(void)
{
    Suite *suite = suite_create("packing");
    TCase *tests = tcase_create("packing");
    tcase_set_timeout(tests, 60);
    tcase_add_checked_fixture(tests, start, NULL);
    tcase_add_loop_test(tests, wedges_are_filled, 0, 6);
    tcase_add_loop_test(tests, discs_of_any_radius_are_filled, 0, 12);
    tcase_add_loop_test(tests, boxes_of_any_width_are_filled, 0, 5);
    tcase_add_loop_test(tests, liquid_around_a_solid_fills_the_rest, 0, 4);
    tcase_add_test(tests, a_polygon_with_an_arc_is_filled);
    tcase_add_test(tests, a_tank_that_is_turned_is_filled_by_its_own_lattice);
    tcase_add_test(tests, a_polygon_is_packed_from_the_sides_that_fit_its_rows);
    tcase_add_loop_test(tests, a_lattice_that_fits_stays_bit_for_bit, 0, 2);
    tcase_add_test(tests, far_from_a_wall_that_takes_places_the_lattice_stays);
    tcase_add_test(tests, a_box_that_nearly_fits_is_stretched);
    tcase_add_loop_test(tests, equal_pressure_pushes_no_packed_particle, 0, 2);
    tcase_add_loop_test(tests, no_kernel_packs_particles_in_pairs, SPH2D_KERNEL_WENDLAND_C2, SPH2D_KERNEL_QUINTIC + 1);
    tcase_add_loop_test(tests, packed_liquid_is_as_dense_inside_as_it_was_asked_for, 0, 9);
    tcase_add_loop_test(tests, a_gap_between_liquid_and_a_wall_is_nobodys, 0, 3);
    tcase_add_test(tests, packed_places_stay_out_of_springs);
    tcase_add_test(tests, packed_places_are_the_same_for_any_threads);
    tcase_add_loop_test(tests, packed_liquid_at_rest_starts_quietly, 0, 4);
    tcase_add_test(tests, a_packing_without_memory_is_no_harm);
    suite_add_tcase(suite, tests);
    return suite;
}
