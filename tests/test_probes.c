/* SPDX-License-Identifier: MIT */
/** @file test_probes.c
 *  Each kind of probe on particles placed by hand, whose answer is known. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "hand_made.h"
#include "sph2d/key.h"

static const double DX = 0.01;
#define ONE_MORE(...) +1
/* The last kinds are of a body, an opening and a particle: test_bodies.c, test_openings.c, test_tracers.c. */
enum { ALL_KINDS = 0 SPH2D_PROBE_MAP(ONE_MORE), KINDS = ALL_KINDS - 3 };
_Static_assert(KINDS == (int)SPH2D_PROBE_BODY && SPH2D_PROBE_BODY + 2 == (int)SPH2D_PROBE_TRACER, "the last kinds");

/** A scene with one probe of each kind at a point. */
static sph2d_scene with_probes(sph2d_scene scene, sph2d_vec2 at)
{
    static sph2d_probe probes[KINDS];
    static char names[KINDS][4];
    for (int k = 0; k < KINDS; ++k) {
        probes[k] = sph2d_probe_default();
        snprintf(names[k], sizeof names[k], "p%d", k);
        probes[k].name = names[k];
        probes[k].kind = (sph2d_probe_kind)k;
        probes[k].at = at;
        probes[k].rate.every = 1;
    }
    scene.probes = probes;
    scene.probe_count = KINDS;
    return scene;
}

/** Four open sides, (-1, -1) to (1, 1), H/dx = 2.6, c0 = 10 m/s. */
static sph2d_scene open_scene(void)
{
    sph2d_scene scene = test_open_scene(DX, -1, -1, 1, 1);
    scene.method.support_ratio = 2.6;
    return scene;
}

static sph2d_sim *in_the_open(size_t room)
{
    return hand_made(with_probes(open_scene(), (sph2d_vec2){0.01, 0.02}), room, 1);
}

static size_t columns_in(const char *header)
{
    size_t count = 1;
    for (const char *p = header; *p; ++p)
        count += *p == ',';
    return count;
}

/** Values of a kind; their number is that of its columns. Static storage. */
static const double *evaluate(const sph2d_sim *sim, sph2d_probe_kind kind)
{
    static double values[SPH2D_PROBE_MAX_COLUMNS];
    ck_assert_uint_eq(sph2d_sim_probe(sim, kind, values), columns_in(sph2d_probe_columns(kind)));
    return values;
}

/* ---- all kinds --------------------------------------------------------------------------------------------------- */

START_TEST(every_kind_has_a_word_and_columns)
{
    const sph2d_keys *scene = sph2d_scene_keys(), *probe = NULL;
    for (size_t i = 0; i < scene->count; ++i)
        if (strcmp(scene->items[i].name, "probes") == 0)
            probe = scene->items[i].keys;
    ck_assert_ptr_nonnull(probe);
    ck_assert_str_eq(probe->items[1].name, "kind");
    size_t words = 0;
    while (probe->items[1].words[words])
        ++words;
    ck_assert_uint_eq(words, ALL_KINDS);
    for (int k = 0; k < ALL_KINDS; ++k) {
        const char *columns = sph2d_probe_columns((sph2d_probe_kind)k);
        ck_assert_uint_gt(strlen(columns), 5);
        ck_assert_uint_le(columns_in(columns), SPH2D_PROBE_MAX_COLUMNS);
    }
    ck_assert_str_eq(sph2d_probe_columns((sph2d_probe_kind)ALL_KINDS), "");
    ck_assert_str_eq(sph2d_probe_columns((sph2d_probe_kind)-1), "");
}
END_TEST

START_TEST(without_liquid_nothing_has_a_value)
{
    static const char *const words[KINDS] = {"0000000n", "nnn0",   "nn0", "n", "nnnn",         "nnnnnnn", "nnnnnnnn",
                                             "000nn",    "nnnnnn", "00",  "n", "000000000000", "00"};
    sph2d_sim *sim = in_the_open(1);
    for (int k = 0; k < KINDS; ++k) {
        const double *values = evaluate(sim, (sph2d_probe_kind)k);
        ck_assert_msg(words[k], "what kind %d has without liquid is missing above", k);
        for (size_t c = 0; words[k][c]; ++c)
            ck_assert(words[k][c] == 'n' ? isnan(values[c]) : values[c] == 0);
    }
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(probes_change_nothing_and_no_thread_changes_them)
{
    sph2d_scene scene = with_probes(open_scene(), (sph2d_vec2){0.4, 0.4});
    sph2d_block block = test_block(0, 0, 0.8, 0.64); /* enough particles for four threads */
    block.perturb.amplitude = 0.3;
    block.velocity = (sph2d_vec2){0.1, -0.3};
    scene.blocks = &block;
    scene.block_count = 1;
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = 1 + _i;
    sph2d_sim *alone = test_create(&scene, NULL), *watched = test_create(&scene, &options);
    for (int n = 0; n < 10; ++n) {
        for (size_t k = 0; k < KINDS; ++k) {
            double a[SPH2D_PROBE_MAX_COLUMNS] = {0}, b[SPH2D_PROBE_MAX_COLUMNS] = {0};
            size_t count = sph2d_sim_probe(watched, k, a);
            if (n == 0 || n == 9) {
                ck_assert_uint_eq(sph2d_sim_probe(alone, k, b), count);
                ck_assert_int_eq(memcmp(a, b, sizeof a), 0);
            }
        }
        test_steps(alone, 1);
        test_steps(watched, 1);
    }
    sph2d_view a = sph2d_sim_fluid(alone), b = sph2d_sim_fluid(watched);
    ck_assert_uint_eq(a.count, 80 * 64);
    ck_assert_int_eq(memcmp(a.id, b.id, a.count * sizeof *a.id), 0);
    ck_assert_int_eq(memcmp(a.x, b.x, a.count * sizeof *a.x), 0);
    ck_assert_int_eq(memcmp(a.vy, b.vy, a.count * sizeof *a.vy), 0);
    ck_assert_int_eq(memcmp(a.density, b.density, a.count * sizeof *a.density), 0);
    sph2d_sim_destroy(alone);
    sph2d_sim_destroy(watched);
}
END_TEST

/* ---- at a point -------------------------------------------------------------------------------------------------- */

START_TEST(speed_and_pressure_are_those_at_the_point)
{
    /* Fields that grow with the square of the distance: an average would tell more than is there. */
    sph2d_sim *sim = in_the_open(400);
    add_lattice(sim, (sph2d_box){{-0.1, -0.1}, {0.1, 0.1}}, 0.2, 3);
    sort_particles(sim);
    sph2d__store *f = &sim->system.fluid;
    for (size_t i = 0; i < f->count; ++i) {
        double r2 = pow(f->x[i] - 0.01, 2) + pow(f->y[i] - 0.02, 2);
        f->vx[i] = 3 + 500 * r2;
        f->vy[i] = -4 - 800 * r2;
        f->pressure[i] = 70 + 1e5 * r2;
        f->density[i] = 1001 - 1e4 * r2;
    }
    const double *v = evaluate(sim, SPH2D_PROBE_SPEED);
    ck_assert_double_eq_tol(v[0], 3, 1e-12);
    ck_assert_double_eq_tol(v[1], -4, 1e-12);
    ck_assert_double_eq_tol(v[2], 5, 1e-12);
    double neighbours = v[3];
    ck_assert_double_ge(neighbours, 15);
    v = evaluate(sim, SPH2D_PROBE_PRESSURE);
    ck_assert_double_eq_tol(v[0], 70, 1e-10);
    ck_assert_double_eq_tol(v[1], 1001, 1e-10);
    ck_assert(v[2] == neighbours);
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- of all liquid ----------------------------------------------------------------------------------------------- */

START_TEST(extent_is_that_of_the_places)
{
    sph2d_sim *sim = in_the_open(5);
    static const double x[5] = {0.3, -0.7, 0.9, 0.1, 0}, y[5] = {-1.3, 0.2, 0.25, 0.7, 0};
    for (int i = 0; i < 5; ++i)
        add_particle(sim, x[i], y[i]);
    sort_particles(sim);
    const double *v = evaluate(sim, SPH2D_PROBE_EXTENT);
    double half = sim->world.scene.spacing / 2;
    ck_assert(v[0] == -0.7 - half && v[1] == 0.9 + half && v[2] == -1.3 - half && v[3] == 0.7 + half);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(axes_are_those_of_a_cross)
{
    /* Particles at +-p along one direction and +-q across: <x^2> = p^2/2, so that a = sqrt(2) p. */
    sph2d_sim *sim = in_the_open(4);
    double p = 0.3, q = 0.1, angle = -1.5 + 0.3 * _i, cx = 0.2, cy = -0.4, c = cos(angle), s = sin(angle);
    for (int k = -1; k <= 1; k += 2) {
        add_particle(sim, cx + k * p * c, cy + k * p * s);
        add_particle(sim, cx - k * q * s, cy + k * q * c);
    }
    sort_particles(sim);
    const double *v = evaluate(sim, SPH2D_PROBE_AXES);
    ck_assert_double_eq_tol(v[0], cx, 1e-15);
    ck_assert_double_eq_tol(v[1], cy, 1e-15);
    ck_assert_double_eq_tol(v[2], sqrt(2) * p, 1e-14);
    ck_assert_double_eq_tol(v[3], sqrt(2) * q, 1e-14);
    ck_assert_double_eq_tol(v[4], angle, 1e-14);
    ck_assert_double_eq_tol(v[5], sqrt(2) * hypot(p * c, q * s), 1e-14);
    ck_assert_double_eq_tol(v[6], sqrt(2) * hypot(p * s, q * c), 1e-14);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(axes_are_those_of_a_filled_ellipse)
{
    sph2d_sim *sim = in_the_open(8000);
    double a = 0.5, b = 0.3, angle = 0.6;
    for (int i = -60; i <= 60; ++i)
        for (int j = -60; j <= 60; ++j) {
            double x = i * DX, y = j * DX, u = x * cos(angle) + y * sin(angle), w = y * cos(angle) - x * sin(angle);
            if (u * u / (a * a) + w * w / (b * b) < 1)
                add_particle(sim, x, y);
        }
    sort_particles(sim);
    const double *v = evaluate(sim, SPH2D_PROBE_AXES);
    ck_assert_double_eq_tol(v[2], a, 2e-3 * a);
    ck_assert_double_eq_tol(v[3], b, 2e-3 * b);
    ck_assert_double_eq_tol(v[4], angle, 2e-3);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(momentum_is_that_of_a_turning_body)
{
    /* Velocities v0 + w x (r - m), m the domain's middle: angular momentum M (c - m) x v0 + w I. */
    sph2d_scene scene = test_open_scene(DX, 3, -7, 5, -6);
    sph2d_sim *sim = hand_made(with_probes(scene, (sph2d_vec2){4, -6.5}), 300, 1);
    add_lattice(sim, (sph2d_box){{3.1, -6.7}, {3.3, -6.55}}, 0.3, 4);
    sort_particles(sim);
    sph2d__store *f = &sim->system.fluid;
    double mass = 1000 * DX * DX, n = (double)f->count, w = 3, v0x = 2, v0y = -5, cx = 0, cy = 0, inertia = 0;
    for (size_t i = 0; i < f->count; ++i) {
        double x = f->x[i] - 4, y = f->y[i] + 6.5;
        f->vx[i] = v0x - w * y;
        f->vy[i] = v0y + w * x;
        cx += x / n;
        cy += y / n;
        inertia += mass * (x * x + y * y);
    }
    const double *v = evaluate(sim, SPH2D_PROBE_MOMENTUM);
    ck_assert_double_eq_tol(v[0], n * mass * (v0x - w * cy), 1e-10);
    ck_assert_double_eq_tol(v[1], n * mass * (v0y + w * cx), 1e-10);
    ck_assert_double_eq_tol(v[2], n * mass * (cx * v0y - cy * v0x) + w * inertia, 1e-10);
    ck_assert_double_eq_tol(v[3], 4 + cx, 1e-14);
    ck_assert_double_eq_tol(v[4], -6.5 + cy, 1e-14);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(energy_is_that_of_two_particles)
{
    sph2d_sim *sim = in_the_open(2);
    add_particle(sim, 0.5, 0);
    add_particle(sim, -0.5, 0.25);
    sort_particles(sim);
    sim->system.forces.gravity.y = -10;
    for (size_t i = 0; i < 2; ++i) {
        sim->system.fluid.vx[i] = 3;
        sim->system.fluid.vy[i] = sim->system.fluid.x[i] > 0 ? 4 : 0;
    }
    const double *v = evaluate(sim, SPH2D_PROBE_ENERGY);
    double mass = 1000 * DX * DX;
    ck_assert_double_eq_tol(v[0], mass * 17, 1e-12);
    ck_assert_double_eq_tol(v[1], mass * 10 * 2.25, 1e-12); /* above the domain's lower left corner */
    ck_assert_double_eq_tol(v[2], mass * 6, 1e-12);
    ck_assert_double_eq_tol(v[3], mass * 4, 1e-12);
    ck_assert(v[4] == 2 && v[5] == 5);
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- quality ----------------------------------------------------------------------------------------------------- */

START_TEST(a_lattice_is_of_the_best_quality)
{
    sph2d_sim *sim = in_the_open(400);
    add_lattice(sim, (sph2d_box){{-0.1, -0.1}, {0.1, 0.1}}, 0, 1);
    sort_particles(sim);
    const double *v = evaluate(sim, SPH2D_PROBE_QUALITY);
    ck_assert_double_eq_tol(v[0], 1, 1e-12);
    ck_assert_double_eq_tol(v[1], 1, 1e-12);
    ck_assert(v[2] == 0 && v[3] == 0 && v[4] == 0 && v[5] == 0);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(pairs_are_found)
{
    /* Particles on the right side of a lattice get a second one, at a fraction of the spacing. */
    sph2d_sim *sim = in_the_open(410);
    int pairs = 1 + _i;
    add_lattice(sim, (sph2d_box){{-0.1, -0.1}, {0.1, 0.1}}, 0, 1);
    for (int k = 0; k < pairs; ++k)
        add_particle(sim, 0.095 + (k == 0 ? 0.2 : 0.4) * DX, -0.095 + 0.03 * k);
    sort_particles(sim);
    const double *v = evaluate(sim, SPH2D_PROBE_QUALITY);
    ck_assert_double_eq_tol(v[0], 0.2, 1e-12);
    ck_assert_double_eq_tol(v[1], pairs < 3 ? 1 : 0.4, 1e-12); /* 4 of 400 are below the percentile: two pairs */
    ck_assert_double_eq_tol(v[2], 2.0 * pairs / (400 + pairs), 1e-15);
    sph2d_sim_destroy(sim);
}
END_TEST

/** Neighbours across periodic sides are neighbours: two rows, each beside one side, are pairs of each other. */
START_TEST(pairs_are_found_across_periodic_sides)
{
    enum { ROW = 8 };
    const double gap = 0.3;
    sph2d_scene scene = with_probes(test_scene(DX, 0, 0, ROW * DX, 30 * DX), (sph2d_vec2){0.01, 0.02});
    scene.boundary.bottom = scene.boundary.top = SPH2D_SIDE_PERIODIC;
    const sph2d_block rows[2] = {test_block(0, 0, ROW * DX, DX), test_block(0, 29 * DX, ROW * DX, 30 * DX)};
    scene.blocks = rows;
    scene.block_count = 2;
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d__store *f = &sim->system.fluid;
    ck_assert_uint_eq(f->count, 2 * ROW);
    for (size_t i = 0; i < f->count; ++i)
        f->y[i] = f->y[i] < 15 * DX ? gap / 2 * DX : (30 - gap / 2) * DX;
    sort_particles(sim);
    const double *v = evaluate(sim, SPH2D_PROBE_QUALITY);
    ck_assert_double_eq_tol(v[0], gap, 1e-12);
    ck_assert_double_eq_tol(v[1], gap, 1e-12);
    ck_assert_double_eq(v[2], 1);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(the_first_percentile_is_that_of_sorted_distances)
{
    sph2d_sim *sim = in_the_open(900);
    uint64_t seed = 77;
    for (int k = 0; k < 900; ++k)
        add_particle(sim, test_random(&seed, 0, 0.3), test_random(&seed, 0, 0.3));
    sort_particles(sim);
    sph2d__store *f = &sim->system.fluid;
    double h = sim->system.support;
    static double least[900];
    for (size_t i = 0; i < 900; ++i) {
        least[i] = h;
        for (size_t j = 0; j < 900; ++j)
            if (j != i)
                least[i] = fmin(least[i], hypot(f->x[i] - f->x[j], f->y[i] - f->y[j]));
    }
    const double *v = evaluate(sim, SPH2D_PROBE_QUALITY);
    size_t below = 0, not_above = 0, paired = 0;
    double smallest = h;
    for (size_t i = 0; i < 900; ++i) {
        below += least[i] < v[1] * DX - h / 2048;
        not_above += least[i] < v[1] * DX + h / 2048;
        paired += least[i] < DX / 2;
        smallest = fmin(smallest, least[i]);
    }
    ck_assert_uint_le(below, 9);
    ck_assert_uint_gt(not_above, 9);
    ck_assert_double_eq_tol(v[0], smallest / DX, 1e-12);
    ck_assert_double_eq_tol(v[2], (double)paired / 900, 1e-15);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(a_lone_particle_has_no_neighbour)
{
    sph2d_sim *sim = in_the_open(2);
    add_particle(sim, 0.3, 0.3);
    sort_particles(sim);
    const double *v = evaluate(sim, SPH2D_PROBE_QUALITY);
    ck_assert_double_eq_tol(v[0], 2.6, 1e-12); /* H/dx at most */
    ck_assert_double_eq_tol(v[1], 2.6, 1e-12);
    ck_assert(v[2] == 0);
    add_particle(sim, 0.3, 0.3); /* another on its place */
    sort_particles(sim);
    v = evaluate(sim, SPH2D_PROBE_QUALITY);
    ck_assert(v[0] == 0 && v[1] == 0 && v[2] == 1);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(neighbours_across_a_periodic_side_count)
{
    sph2d_scene scene = test_scene(DX, 0, 0, 0.3, 0.3);
    scene.boundary.left = scene.boundary.right = SPH2D_SIDE_PERIODIC;
    sph2d_sim *sim = hand_made(with_probes(scene, (sph2d_vec2){0, 0}), 2, 1);
    add_particle(sim, 0.1 * DX, 0.1);
    add_particle(sim, 0.3 - 0.2 * DX, 0.1);
    sort_particles(sim);
    const double *v = evaluate(sim, SPH2D_PROBE_QUALITY);
    ck_assert_double_eq_tol(v[0], 0.3, 1e-12);
    ck_assert(v[2] == 1);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(density_errors_and_speeds_are_measured)
{
    sph2d_sim *sim = in_the_open(4);
    static const double density[4] = {1030, 1000, 950, 1000}, speed[4] = {0, 1.5, -2.5, 0.1};
    for (int i = 0; i < 4; ++i)
        add_particle(sim, 0.02 * i, 0);
    sort_particles(sim);
    for (size_t i = 0; i < 4; ++i) {
        sim->system.fluid.density[i] = density[i];
        sim->system.fluid.vy[i] = speed[i];
    }
    const double *v = evaluate(sim, SPH2D_PROBE_QUALITY);
    ck_assert_double_eq_tol(v[3], sqrt((0.03 * 0.03 + 0.05 * 0.05) / 4), 1e-12);
    ck_assert_double_eq_tol(v[4], 0.05, 1e-12);
    ck_assert_double_eq_tol(v[5], 0.25, 1e-12);
    sph2d_sim_destroy(sim);
}
END_TEST

Suite *suite_probes(void)
{
    Suite *suite = suite_create("probes");
    TCase *tests = tcase_create("probes");
    tcase_add_test(tests, every_kind_has_a_word_and_columns);
    tcase_add_test(tests, without_liquid_nothing_has_a_value);
    tcase_add_test(tests, speed_and_pressure_are_those_at_the_point);
    tcase_add_test(tests, extent_is_that_of_the_places);
    tcase_add_loop_test(tests, axes_are_those_of_a_cross, 0, 11);
    tcase_add_test(tests, axes_are_those_of_a_filled_ellipse);
    tcase_add_test(tests, momentum_is_that_of_a_turning_body);
    tcase_add_test(tests, energy_is_that_of_two_particles);
    tcase_add_test(tests, a_lattice_is_of_the_best_quality);
    tcase_add_test(tests, pairs_are_found_across_periodic_sides);
    tcase_add_loop_test(tests, pairs_are_found, 0, 6);
    tcase_add_test(tests, the_first_percentile_is_that_of_sorted_distances);
    tcase_add_test(tests, a_lone_particle_has_no_neighbour);
    tcase_add_test(tests, neighbours_across_a_periodic_side_count);
    tcase_add_test(tests, density_errors_and_speeds_are_measured);
    suite_add_tcase(suite, tests);
    TCase *slow = test_long(suite);
    tcase_add_loop_test(slow, probes_change_nothing_and_no_thread_changes_them, 0, 4);
    return suite;
}
