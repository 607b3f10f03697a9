/* SPDX-License-Identifier: MIT */
/** @file test_sample.c
 *  Values at a point: exact for polynomials that the fits hold, of third order for others, and sane wherever neighbours
 *  are few, on one side, or none. */
#include <math.h>
#include <string.h>

#include "hand_made.h"

static const double DX = 0.01;

typedef double field(double x, double y);

/** vx, vy, pressure and density of every particle. */
static void set_fields(sph2d_sim *sim, field *const fields[4])
{
    sph2d__store *f = &sim->system.fluid;
    double *values[4] = {f->vx, f->vy, f->pressure, f->density};
    for (size_t i = 0; i < f->count; ++i)
        for (int k = 0; k < 4; ++k)
            values[k][i] = fields[k](f->x[i], f->y[i]);
}

/** Largest difference of a sample from the fields. */
static double error_at(const sph2d_sim *sim, field *const fields[4], double x, double y)
{
    sph2d_sample s;
    ck_assert(sph2d_sim_sample(sim, (sph2d_vec2){x, y}, &s));
    double values[4] = {s.velocity[0], s.velocity[1], s.pressure, s.density}, error = 0;
    for (int k = 0; k < 4; ++k) {
        ck_assert(isfinite(values[k]));
        error = fmax(error, fabs(values[k] - fields[k](x, y)));
    }
    return error;
}

/** A square of liquid from (0, 0) to (1/2, 1/2) in an open domain, at H/dx = ratio. */
static sph2d_sim *square(double spacing, double ratio, double jitter)
{
    sph2d_scene scene = test_open_scene(spacing, -1, -1, 1, 1);
    scene.method.support_ratio = ratio;
    size_t side = (size_t)round(0.5 / spacing);
    sph2d_sim *sim = hand_made(scene, side * side, 1);
    add_lattice(sim, (sph2d_box){{0, 0}, {0.5, 0.5}}, jitter, 7);
    sort_particles(sim);
    return sim;
}

/* ---- polynomials ------------------------------------------------------------------------------------------------- */

static double ten(double x, double y)
{
    (void)x, (void)y;
    return 10.1;
}
static double plane(double x, double y)
{
    return 3 - 2 * x + 5 * y;
}
static double steep(double x, double y)
{
    (void)y;
    return 2 + 7 * x;
}
static double bowl(double x, double y)
{
    return 1 + x - 4 * y + 3 * x * x - 5 * x * y + 2 * y * y;
}
static double saddle(double x, double y)
{
    return x * x - y * y;
}

static field *const uniform[4] = {ten, ten, ten, ten}, *const linear[4] = {plane, ten, steep, plane},
                    *const quadratic[4] = {bowl, plane, saddle, bowl};

/* Loop index: ratio, jitter. */
static const double ratios[] = {2.0, 2.5, 2.6, 3.0, 4.0}, jitters[] = {0, 0.1, 0.25};
enum { RATIOS = 5, CASES = 3 * RATIOS };

START_TEST(quadratic_fields_are_exact_inside)
{
    sph2d_sim *sim = square(DX, ratios[_i % RATIOS], jitters[_i / RATIOS]);
    double h = sim->system.support, error = 0;
    uint64_t seed = 3;
    set_fields(sim, quadratic);
    for (int k = 0; k < 1000; ++k) {
        double x = test_random(&seed, h, 0.5 - h), y = test_random(&seed, h, 0.5 - h);
        error = fmax(error, error_at(sim, quadratic, x, y));
    }
    sph2d__store *f = &sim->system.fluid; /* and on particles */
    for (size_t i = 0; i < f->count; ++i)
        if (fabs(f->x[i] - 0.25) < 0.25 - h && fabs(f->y[i] - 0.25) < 0.25 - h)
            error = fmax(error, error_at(sim, quadratic, f->x[i], f->y[i]));
    ck_assert_double_le(error, 1e-13);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(linear_fields_are_exact_at_walls)
{
    /* On the sides and corners of the liquid, where walls would be: half of the neighbours are missing, or more. */
    sph2d_sim *sim = square(DX, ratios[_i % RATIOS], jitters[_i / RATIOS] / 2.5);
    double error = 0;
    set_fields(sim, linear);
    for (int k = 0; k <= 500; ++k) {
        double s = 0.001 * k;
        error = fmax(error, fmax(error_at(sim, linear, s, 0), error_at(sim, linear, s, 0.5)));
        error = fmax(error, fmax(error_at(sim, linear, 0, s), error_at(sim, linear, 0.5, s)));
    }
    ck_assert_double_le(error, 1e-12);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(quadratic_fields_are_exact_at_walls_with_neighbours_enough)
{
    sph2d_sim *sim = square(DX, 4, jitters[_i]);
    double error = 0;
    set_fields(sim, quadratic);
    for (int k = 50; k <= 450; ++k)
        error = fmax(error, fmax(error_at(sim, quadratic, 0.001 * k, 0), error_at(sim, quadratic, 0, 0.001 * k)));
    ck_assert_double_le(error, 1e-13);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(uniform_fields_are_exact_everywhere)
{
    sph2d_sim *sim = square(DX, ratios[_i % RATIOS], jitters[_i / RATIOS]);
    set_fields(sim, uniform);
    double h = sim->system.support;
    uint64_t seed = 5;
    for (int k = 0; k < 3000; ++k) {
        sph2d_vec2 at = {test_random(&seed, -h, 0.5 + h), test_random(&seed, -h, 0.5 + h)};
        sph2d_sample s;
        if (sph2d_sim_sample(sim, at, &s))
            ck_assert(s.velocity[0] == 10.1 && s.velocity[1] == 10.1 && s.pressure == 10.1 && s.density == 10.1);
    }
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- order ------------------------------------------------------------------------------------------------------- */

static double wave(double x, double y)
{
    return sin(9 * x + 1) * cos(7 * y);
}
static double swirl(double x, double y)
{
    return cos(8 * x * y) + sin(6 * y);
}

static field *const smooth[4] = {wave, swirl, wave, swirl};

/** Root mean squares over points with all neighbours, and along a side. */
static void errors_of(double spacing, double *inside, double *side)
{
    sph2d_sim *sim = square(spacing, 2.6, 0.2);
    set_fields(sim, smooth);
    uint64_t seed = 11;
    *inside = *side = 0;
    for (int k = 0; k < 1000; ++k) {
        double x = test_random(&seed, 0.15, 0.35), y = test_random(&seed, 0.15, 0.35);
        *inside += pow(error_at(sim, smooth, x, y), 2) / 1000;
        *side += pow(error_at(sim, smooth, x, 0), 2) / 1000;
    }
    *inside = sqrt(*inside);
    *side = sqrt(*side);
    sph2d_sim_destroy(sim);
}

START_TEST(errors_fall_with_the_third_power_of_the_spacing)
{
    double inside[3], side[3];
    for (int k = 0; k < 3; ++k)
        errors_of(0.02 / (1 << k), &inside[k], &side[k]);
    ck_assert_double_le(inside[2], 5e-6);
    for (int k = 0; k < 2; ++k) {
        ck_assert_double_ge(log2(inside[k] / inside[k + 1]), 2.7);
        ck_assert_double_ge(log2(side[k] / side[k + 1]), 1.9); /* a linear fit: second order */
    }
}
END_TEST

/* ---- few neighbours ---------------------------------------------------------------------------------------------- */

static sph2d_sim *empty(double ratio, size_t room)
{
    sph2d_scene scene = test_open_scene(DX, -1, -1, 1, 1);
    scene.method.support_ratio = ratio;
    return hand_made(scene, room, 1);
}

START_TEST(no_neighbour_gives_no_value)
{
    static const sph2d_vec2 nowhere[] = {{0, 0}, {-1, -1}, {1e300, 0}, {INFINITY, 0}, {0, NAN}, {0.5, 0.52}};
    sph2d_sim *sim = empty(2, 10);
    for (int k = 0; k < 12; ++k) {
        if (k == 6) {
            add_particle(sim, 0.5, 0.5); /* exactly H from the last place */
            sort_particles(sim);
        }
        sph2d_sample s;
        ck_assert(!sph2d_sim_sample(sim, nowhere[k % 6], &s));
        ck_assert(isnan(s.velocity[0]) && isnan(s.velocity[1]) && isnan(s.pressure) && isnan(s.density));
        ck_assert(s.neighbours == 0);
    }
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(one_neighbour_gives_its_value)
{
    sph2d_sim *sim = empty(2, 1);
    add_particle(sim, 0.3, -0.2);
    sort_particles(sim);
    set_fields(sim, quadratic);
    sph2d_sample s;
    for (int k = 0; k < 20; ++k) {
        ck_assert(sph2d_sim_sample(sim, (sph2d_vec2){0.3 + 0.000999 * k, -0.2}, &s));
        ck_assert(s.velocity[0] == bowl(0.3, -0.2) && s.pressure == saddle(0.3, -0.2) && s.neighbours == 1);
    }
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(neighbours_on_a_line_are_averaged)
{
    /* At H/4, H/2 and 3H/4 with Wendland's weights; a line tells nothing about what is beside it. */
    static const double q[3] = {0.25, 0.5, 0.75};
    sph2d_sim *sim = empty(2, 3);
    double h = sim->system.support, angle = 0.7 * _i, sum = 0, weight = 0;
    for (int k = 0; k < 3; ++k) {
        double x = h * q[k] * cos(angle), y = h * q[k] * sin(angle), w = pow(1 - q[k], 4) * (4 * q[k] + 1);
        add_particle(sim, x, y);
        sum += w * bowl(x, y);
        weight += w;
    }
    sort_particles(sim);
    set_fields(sim, quadratic);
    sph2d_sample s;
    ck_assert(sph2d_sim_sample(sim, (sph2d_vec2){0, 0}, &s));
    ck_assert_double_eq_tol(s.velocity[0], sum / weight, 1e-14);
    ck_assert(s.neighbours == 3);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(a_triangle_carries_a_plane)
{
    sph2d_sim *sim = empty(2, 3);
    add_particle(sim, 0, 0);
    add_particle(sim, DX, 0.1 * DX);
    add_particle(sim, 0.2 * DX, DX);
    sort_particles(sim);
    set_fields(sim, linear);
    ck_assert_double_le(error_at(sim, linear, 0.4 * DX, 0.3 * DX), 1e-15);
    ck_assert_double_le(error_at(sim, linear, 0, 0), 1e-15);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(values_stay_near_those_of_the_neighbours)
{
    /* Any number of particles at random, on one place too, with values at random: no fit may run away. */
    uint64_t seed = 100 + (uint64_t)_i;
    sph2d_sim *sim = empty(2.6, 30);
    sph2d__store *f = &sim->system.fluid;
    for (int trial = 0; trial < 500; ++trial) {
        remove_all(sim);
        size_t count = 1 + (size_t)test_random(&seed, 0, 29);
        double h = sim->system.support, flat = trial % 3 == 0 ? 1e-4 : 1, low = INFINITY, high = -INFINITY;
        for (size_t i = 0; i < count; ++i)
            add_particle(sim, test_random(&seed, -h, h), flat * test_random(&seed, -h, trial % 2 ? h : 0));
        if (trial % 5 == 0 && count > 1) {
            f->x[1] = f->x[0];
            f->y[1] = f->y[0];
        }
        sort_particles(sim);
        for (size_t i = 0; i < count; ++i) {
            f->pressure[i] = test_random(&seed, -1, 1);
            low = hypot(f->x[i], f->y[i]) < h ? fmin(low, f->pressure[i]) : low;
            high = hypot(f->x[i], f->y[i]) < h ? fmax(high, f->pressure[i]) : high;
        }
        sph2d_sample s;
        if (!sph2d_sim_sample(sim, (sph2d_vec2){0, 0}, &s))
            continue;
        ck_assert_double_ge(s.pressure, low - (high - low) - 1e-12);
        ck_assert_double_le(s.pressure, high + (high - low) + 1e-12);
    }
    sph2d_sim_destroy(sim);
}
END_TEST

static double still(double x, double y)
{
    (void)x;
    return 9810 * (0.5 - y);
}

START_TEST(pressure_beyond_a_surface_is_bounded)
{
    /* Still water up to y = 0.5: on the surface its pressure, above it no more than a spread off, then nothing. */
    static field *const water[4] = {ten, ten, still, ten};
    sph2d_sim *sim = square(DX, 2.6, 0.05);
    set_fields(sim, water);
    sph2d_sample s;
    for (int k = 0; k <= 40; ++k) {
        sph2d_vec2 at = {0.25, 0.5 + 0.001 * k};
        if (!sph2d_sim_sample(sim, at, &s)) {
            ck_assert_int_ge(k, 20);
            continue;
        }
        ck_assert_int_lt(k, 22);
        ck_assert_double_le(fabs(s.pressure), 9810 * 2 * 0.026);
        if (k <= 5)
            ck_assert_double_eq_tol(s.pressure, still(at.x, at.y), 1e-9);
    }
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(neighbours_are_counted)
{
    sph2d_sim *sim = square(DX, 2.6, 0.3);
    sph2d__store *f = &sim->system.fluid;
    uint64_t seed = 21;
    for (int k = 0; k < 200; ++k) {
        sph2d_vec2 at = {test_random(&seed, -0.03, 0.53), test_random(&seed, -0.03, 0.53)};
        double near = 0;
        for (size_t i = 0; i < f->count; ++i)
            near += hypot(f->x[i] - at.x, f->y[i] - at.y) < sim->system.support;
        sph2d_sample s;
        ck_assert(sph2d_sim_sample(sim, at, &s) == (near > 0));
        ck_assert(s.neighbours == near);
    }
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- periodic ---------------------------------------------------------------------------------------------------- */

/** A full periodic box with (x0, y0) at its lower left. */
static sph2d_sim *periodic(double x0, double y0)
{
    sph2d_scene scene = test_scene(DX, x0, y0, x0 + 0.3, y0 + 0.2);
    scene.boundary =
        (sph2d_boundary){SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC};
    scene.method.support_ratio = 2.6;
    sph2d_sim *sim = hand_made(scene, 600, 1);
    add_lattice(sim, scene.domain, 0.2, 9);
    for (size_t i = 0; i < 600; ++i) {
        sph2d__store *f = &sim->system.fluid;
        f->x[i] = sph2d__period_wrap(f->x[i], x0, 0.3);
        f->y[i] = sph2d__period_wrap(f->y[i], y0, 0.2);
    }
    sort_particles(sim);
    return sim;
}

START_TEST(a_periodic_side_is_no_end)
{
    /* A polynomial of the shortest way to the point, there and one period further. */
    sph2d_sim *sim = periodic(-0.1, 5);
    sph2d__store *f = &sim->system.fluid;
    uint64_t seed = 31;
    for (int k = 0; k < 400; ++k) {
        sph2d_vec2 at = {test_random(&seed, -0.1, 0.2), k % 2 ? 5.2 - 1e-4 : 5.001};
        for (size_t i = 0; i < f->count; ++i)
            f->vx[i] = f->pressure[i] =
                bowl(sph2d__period_nearest(f->x[i] - at.x, 0.3), sph2d__period_nearest(f->y[i] - at.y, 0.2));
        sph2d_sample here, there;
        ck_assert(sph2d_sim_sample(sim, at, &here));
        ck_assert_double_eq_tol(here.pressure, bowl(0, 0), 1e-13);
        ck_assert_double_eq_tol(here.velocity[0], bowl(0, 0), 1e-13);
        ck_assert_double_ge(here.neighbours, 15);
        ck_assert(sph2d_sim_sample(sim, (sph2d_vec2){at.x + 0.6, at.y - 0.2}, &there));
        ck_assert_double_eq_tol(there.pressure, here.pressure, 1e-12);
        ck_assert(there.neighbours == here.neighbours);
    }
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(a_run_can_be_sampled_between_its_steps)
{
    /* Liquid that flies, with the cells of a step; what is read changes nothing. */
    sph2d_scene scene = test_open_scene(DX, -1, -1, 1, 1);
    sph2d_block block = test_block(-0.2, -0.2, 0.2, 0.2);
    block.velocity = (sph2d_vec2){1, -2};
    scene.blocks = &block;
    scene.block_count = 1;
    sph2d_sim *watched = test_create(&scene, NULL), *alone = test_create(&scene, NULL);
    for (int k = 0; k < 20; ++k) {
        double t = sph2d_sim_time(watched);
        sph2d_sample s;
        ck_assert(sph2d_sim_sample(watched, (sph2d_vec2){t, -2 * t}, &s));
        ck_assert_double_eq_tol(s.velocity[0], 1, 1e-9);
        ck_assert_double_eq_tol(s.density, 1000, 1e-6);
        test_steps(watched, 1);
        test_steps(alone, 1);
    }
    sph2d_view a = sph2d_sim_fluid(watched), b = sph2d_sim_fluid(alone);
    ck_assert_int_eq(memcmp(a.x, b.x, a.count * sizeof *a.x), 0);
    ck_assert_int_eq(memcmp(a.vy, b.vy, a.count * sizeof *a.vy), 0);
    sph2d_sim_destroy(watched);
    sph2d_sim_destroy(alone);
}
END_TEST

Suite *suite_sample(void)
{
    Suite *suite = suite_create("sample");
    TCase *tests = tcase_create("sample");
    tcase_add_loop_test(tests, quadratic_fields_are_exact_inside, 0, CASES);
    tcase_add_loop_test(tests, linear_fields_are_exact_at_walls, 0, CASES);
    tcase_add_loop_test(tests, quadratic_fields_are_exact_at_walls_with_neighbours_enough, 0, 3);
    tcase_add_loop_test(tests, uniform_fields_are_exact_everywhere, 0, CASES);
    tcase_add_test(tests, errors_fall_with_the_third_power_of_the_spacing);
    tcase_add_test(tests, no_neighbour_gives_no_value);
    tcase_add_test(tests, one_neighbour_gives_its_value);
    tcase_add_loop_test(tests, neighbours_on_a_line_are_averaged, 0, 9);
    tcase_add_test(tests, a_triangle_carries_a_plane);
    tcase_add_loop_test(tests, values_stay_near_those_of_the_neighbours, 0, 8);
    tcase_add_test(tests, pressure_beyond_a_surface_is_bounded);
    tcase_add_test(tests, neighbours_are_counted);
    tcase_add_test(tests, a_periodic_side_is_no_end);
    tcase_add_test(tests, a_run_can_be_sampled_between_its_steps);
    suite_add_tcase(suite, tests);
    return suite;
}
