/* SPDX-License-Identifier: MIT */
/** @file test_elevation.c
 *  Where the free surface is found: flat, rough and sloping, at walls, above gaps, beyond an open top, nowhere. */
#include <math.h>

#include "hand_made.h"

static const double DX = 0.01;

/** Elevation at x of liquid that `fill` lays into a tank from (0, 0) to (0.6, 0.4). */
static double elevation(double x, double ratio, sph2d_boundary boundary, void (*fill)(sph2d_sim *))
{
    sph2d_scene scene = test_scene(DX, 0, 0, 0.6, 0.4);
    scene.boundary = boundary;
    scene.method.support_ratio = ratio;
    sph2d_probe probe = sph2d_probe_default();
    probe.name = "gauge";
    probe.kind = SPH2D_PROBE_ELEVATION;
    probe.at.x = x;
    probe.rate.every = 1;
    scene.probes = &probe;
    scene.probe_count = 1;
    sph2d_sim *sim = hand_made(scene, 4000, 1);
    fill(sim);
    sort_particles(sim);
    double values[SPH2D_PROBE_MAX_COLUMNS];
    ck_assert_uint_eq(sph2d_sim_probe(sim, 0, values), 1);
    sph2d_sim_destroy(sim);
    return values[0];
}

static const sph2d_boundary tank = {SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_OPEN};
static const sph2d_boundary open_tank = {SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN};
static const sph2d_boundary ring = {SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL};

static void fill_pool(sph2d_sim *sim)
{
    add_lattice(sim, (sph2d_box){{0, 0}, {0.6, 0.2}}, 0, 1);
}
static void fill_rough(sph2d_sim *sim)
{
    add_lattice(sim, (sph2d_box){{0, 0}, {0.6, 0.2}}, 0.2, 1);
}
static void fill_film(sph2d_sim *sim)
{
    add_lattice(sim, (sph2d_box){{0, 0}, {0.6, DX}}, 0, 1);
}
static void fill_all(sph2d_sim *sim)
{
    add_lattice(sim, (sph2d_box){{0, 0}, {0.6, 0.4}}, 0, 1);
}
static void fill_slope(sph2d_sim *sim)
{
    for (int column = 0; column < 60; ++column)
        for (int row = 0; row < 40; ++row)
            if ((row + 0.5) * DX < 0.1 + 0.25 * (column + 0.5) * DX)
                add_particle(sim, (column + 0.5) * DX, (row + 0.5) * DX);
}
/** A pool, a slab above it, spray and a drop above that. */
static void fill_overhang(sph2d_sim *sim)
{
    add_lattice(sim, (sph2d_box){{0, 0}, {0.6, 0.1}}, 0, 1);
    add_lattice(sim, (sph2d_box){{0.2, 0.15}, {0.4, 0.2}}, 0, 1);
    for (int k = 0; k < 10; ++k)
        add_particle(sim, 0.3, 0.23 + 0.03 * k);
    add_lattice(sim, (sph2d_box){{0.48, 0.5}, {0.52, 0.54}}, 0, 1);
}

START_TEST(a_flat_surface_is_where_it_is)
{
    /* From wall to wall, to a fiftieth of the spacing. Rough liquid has a rough surface. */
    static const double ratios[] = {2.0, 2.6, 3.0, 4.0};
    double ratio = ratios[_i];
    for (int k = 0; k <= 120; ++k) {
        double x = 0.005 * k;
        ck_assert_double_eq_tol(elevation(x, ratio, tank, fill_pool), 0.2, 0.02 * DX);
        ck_assert_double_eq_tol(elevation(x, ratio, ring, fill_pool), 0.2, 0.02 * DX);
        ck_assert_double_eq_tol(elevation(x, ratio, tank, fill_film), DX, 0.1 * DX);
        ck_assert_double_eq_tol(elevation(x, ratio, tank, fill_rough), 0.2, 0.35 * DX);
        ck_assert(elevation(x, ratio, ring, fill_all) == 0.4);
    }
}
END_TEST

START_TEST(a_sloping_surface_is_where_it_is)
{
    for (int k = 0; k <= 60; ++k) {
        double x = 0.03 + 0.009 * k;
        ck_assert_double_eq_tol(elevation(x, 2.6, tank, fill_slope), 0.1 + 0.25 * x, 0.3 * DX);
    }
}
END_TEST

START_TEST(the_highest_surface_counts)
{
    ck_assert_double_eq_tol(elevation(0.1, 2.6, tank, fill_overhang), 0.1, 0.1 * DX);
    ck_assert_double_eq_tol(elevation(0.3, 2.6, tank, fill_overhang), 0.2, 0.1 * DX);  /* single particles do not */
    ck_assert_double_eq_tol(elevation(0.5, 2.6, tank, fill_overhang), 0.54, 0.3 * DX); /* beyond the open top */
    ck_assert_double_eq_tol(elevation(0.1, 2.6, open_tank, fill_overhang), 0.1, 0.1 * DX);
}
END_TEST

static void fill_corner(sph2d_sim *sim)
{
    add_lattice(sim, (sph2d_box){{0, 0}, {0.1, 0.1}}, 0, 1);
}

START_TEST(without_liquid_there_is_no_surface)
{
    ck_assert(isnan(elevation(0.3, 2.6, tank, fill_corner)));
    ck_assert(isnan(elevation(0.3, 2.6, open_tank, fill_corner)));
    ck_assert(isnan(elevation(0.59, 2.6, tank, fill_corner)));
    ck_assert_double_eq_tol(elevation(0.05, 2.6, tank, fill_corner), 0.1, 0.1 * DX);
    ck_assert_double_eq_tol(elevation(0, 2.6, tank, fill_corner), 0.1, 0.1 * DX);
}
END_TEST

/* ---- at rest in tanks that are obstacles ------------------------------------------------------------------------- */

enum { PLACES = 9 };
static const double REST_DX = 0.015, LEVEL = 0.3, STEP = 0.15;

/** A tank whose right wall rises at an angle from the foot at x = 0.6, or with a step in it. */
typedef struct slope {
    double angle;    /**< to the floor outside, 0 for the step */
    double bound;    /**< of the surface beside the wall over that in the middle, in spacings */
    double pressure; /**< bound of its error, in rho g times the depth */
} slope;
/* 1.5 times what is measured. The beach's tip goes back by half a spacing; an acute corner has 0.52 rho g H too much. */
static const slope slopes[] = {{90, 0.11, 0.05}, {60, 0.58, 0.06}, {45, 0.57, 0.1}, {120, 0.32, 0.8}, {0, 0.15, 0.21}};
enum { SLOPES = sizeof slopes / sizeof *slopes };

/** Where the wall is at a height. */
static double wall_at(double angle, double y)
{
    return angle > 0 ? 0.6 + y / tan(angle * TEST_PI / 180) : y < STEP ? 0.6 : 0.8;
}

/** Liquid that has come to rest in the tank, with elevation probes at places. */
static sph2d_sim *rested(double angle, const double places[PLACES], int threads)
{
    sph2d_vec2 wall[] = {
        {0, 0.45}, {0, 0}, {0.6, 0}, {0.6, STEP}, {wall_at(angle, STEP), STEP}, {wall_at(angle, 0.45), 0.45}};
    sph2d_vec2 liquid[] = {
        {0, LEVEL}, {0, 0}, {0.6, 0}, {0.6, STEP}, {wall_at(angle, STEP), STEP}, {wall_at(angle, LEVEL), LEVEL}};
    size_t count = 6;
    if (angle > 0) {
        wall[3] = wall[5];
        liquid[3] = liquid[5];
        count = 4;
    }
    sph2d_scene scene = test_open_scene(REST_DX, -0.2, -0.2, 1.2, 0.6);
    scene.method = sph2d_scene_default().method;
    scene.gravity.y = -9.81;
    sph2d_obstacle obstacle = sph2d_obstacle_default();
    obstacle.shape = (sph2d_shape){.kind = SPH2D_SHAPE_POLYLINE, .points = {wall, count}};
    sph2d_block block = sph2d_block_default();
    block.shape = (sph2d_shape){.kind = SPH2D_SHAPE_POLYGON, .points = {liquid, count}};
    block.start.flow = (sph2d_flow){.kind = SPH2D_FLOW_STILL, .center = {0, LEVEL}};
    static const char *const names[PLACES] = {"a", "b", "c", "d", "e", "f", "g", "h", "i"};
    sph2d_probe probes[PLACES];
    for (int k = 0; k < PLACES; ++k)
        probes[k] = (sph2d_probe){.name = names[k], .kind = SPH2D_PROBE_ELEVATION, .at.x = places[k], .rate.every = 1};
    scene.obstacles = &obstacle;
    scene.obstacle_count = 1;
    scene.blocks = &block;
    scene.block_count = 1;
    scene.probes = probes;
    scene.probe_count = PLACES;
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = threads;
    sph2d_sim *sim = test_create(&scene, &options);
    while (sph2d_sim_time(sim) < 2)
        test_steps(sim, 1);
    return sim;
}

START_TEST(still_liquid_is_as_high_beside_walls_as_elsewhere)
{
    /* 0.32 dx low half a spacing from a wall where the wall is not counted; 0.15 high where all of it is. */
    const slope *s = &slopes[_i];
    double wall = wall_at(s->angle, LEVEL), half = REST_DX / 2, values[SPH2D_PROBE_MAX_COLUMNS];
    const double places[PLACES] = {0.3,
                                   half,
                                   wall - half,
                                   2 * half,
                                   wall - 2 * half,
                                   3 * half,
                                   wall - 3 * half,
                                   0,
                                   s->angle > 0 ? wall - 4 * half : 0.595};
    sph2d_sim *sim = rested(s->angle, places, 1), *other = rested(s->angle, places, 3);
    sph2d_sim_probe(sim, 0, values);
    double middle = values[0];
    ck_assert_double_eq_tol(middle, LEVEL, 0.25 * REST_DX);
    for (size_t k = 1; k < PLACES; ++k) {
        double again[SPH2D_PROBE_MAX_COLUMNS];
        sph2d_sim_probe(sim, k, values);
        sph2d_sim_probe(other, k, again);
        ck_assert(values[0] == again[0] || (isnan(values[0]) && isnan(again[0])));
        bool tip = s->angle > 0 && s->angle <= 45 && k == 2; /* there may be none */
        ck_assert_msg(fabs(values[0] - middle) <= s->bound * REST_DX || (tip && isnan(values[0])), "at %g: %.3f dx",
                      places[k], (values[0] - middle) / REST_DX);
    }
    sph2d_sim_destroy(other);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(still_liquid_presses_on_walls_with_its_weight)
{
    /* On the walls and off them, from the foot to below the surface, on the edge of the step. */
    const slope *s = &slopes[_i];
    const double places[PLACES] = {0};
    sph2d_sim *sim = rested(s->angle, places, 1);
    for (int k = 0; k <= 13; ++k)
        for (int off = 0; off <= 4; ++off) {
            double y = 0.02 * k, d = 0.25 * off * REST_DX, x[3] = {wall_at(s->angle, y) - d, d, 0.3};
            for (int i = 0; i < 3; ++i) {
                sph2d_sample sample;
                ck_assert(sph2d_sim_sample(sim, (sph2d_vec2){x[i], y}, &sample));
                double error = sample.pressure / (1000 * 9.81) - (LEVEL - y);
                ck_assert_msg(fabs(error) <= s->pressure * LEVEL, "at (%g, %g): %.4f", x[i], y, error / LEVEL);
            }
        }
    sph2d_sim_destroy(sim);
}
END_TEST

Suite *suite_elevation(void)
{
    Suite *suite = suite_create("elevation");
    TCase *tests = tcase_create("elevation");
    tcase_add_test(tests, a_sloping_surface_is_where_it_is);
    tcase_add_test(tests, the_highest_surface_counts);
    tcase_add_test(tests, without_liquid_there_is_no_surface);
    suite_add_tcase(suite, tests);
    TCase *slow = test_long(suite);
    tcase_add_loop_test(slow, a_flat_surface_is_where_it_is, 0, 4);
    tcase_add_loop_test(slow, still_liquid_is_as_high_beside_walls_as_elsewhere, 0, SLOPES);
    tcase_add_loop_test(slow, still_liquid_presses_on_walls_with_its_weight, 0, SLOPES);
    return suite;
}
