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

Suite *suite_elevation(void)
{
    Suite *suite = suite_create("elevation");
    TCase *tests = tcase_create("elevation");
    tcase_add_loop_test(tests, a_flat_surface_is_where_it_is, 0, 4);
    tcase_add_test(tests, a_sloping_surface_is_where_it_is);
    tcase_add_test(tests, the_highest_surface_counts);
    tcase_add_test(tests, without_liquid_there_is_no_surface);
    suite_add_tcase(suite, tests);
    return suite;
}
