/* SPDX-License-Identifier: MIT */
/** @file test_mixed.c
 *  Precision `mixed` of method `wcsph`: what is summed in floats is what is summed in doubles, wherever a scene lies;
 *  places in tiles; the same bits for any number of threads. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common.h"
#include "sim/simulation.h"

static const double DX = 0.01;

static sph2d_scene scene;
static sph2d_block block;
static sph2d_obstacle obstacle;
static sph2d_sim *sims[2];
static sph2d_isa wanted = SPH2D_ISA_AUTO;

static void finish(void)
{
    wanted = SPH2D_ISA_AUTO;
    for (int k = 0; k < 2; ++k) {
        sph2d_sim_destroy(sims[k]);
        sims[k] = NULL;
    }
}

/** Disturbed liquid with every term, its lower left corner at (x, y): a tank with an obstacle that moves, or a periodic
 *  strip that is as wide as four tiles. */
static void disturbed(double x, double y, bool strip)
{
    double width = strip ? 600 * DX : 60 * DX, height = strip ? 26 * DX : 40 * DX;
    scene = test_scene(DX, x, y, x + width, y + 1.5 * height);
    scene.method = sph2d_scene_default().method;
    scene.method.name = SPH2D_METHOD_WCSPH;
    scene.method.artificial_viscosity = 0.05;
    scene.gravity.y = -9.81;
    scene.fluid.dynamic_viscosity = 0.5;
    scene.wall_slip = SPH2D_SLIP_NONE;
    if (strip)
        scene.boundary = (sph2d_boundary){SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL};
    block = test_block(x, y, x + width, y + height);
    block.perturb.amplitude = 0.2;
    block.velocity = (sph2d_vec2){0.3, -0.2};
    scene.blocks = &block;
    scene.block_count = 1;
    obstacle = sph2d_obstacle_default();
    obstacle.outline.kind = SPH2D_OUTLINE_CIRCLE;
    obstacle.outline.circle = (sph2d_disc){{x + 30 * DX, y + 15 * DX}, 8 * DX};
    scene.obstacles = &obstacle;
    scene.obstacle_count = 1;
}

static void start(int threads)
{
    for (int k = 0; k < 2; ++k) {
        sph2d_sim_options options = sph2d_sim_options_default();
        options.threads = threads;
        options.isa = wanted;
        scene.method.precision = k == 0 ? SPH2D_PRECISION_DOUBLE : SPH2D_PRECISION_MIXED;
        sims[k] = test_create(&scene, &options);
    }
}

/** Largest difference of two arrays over the largest size of the first. */
static double difference(const double *a, const double *b, size_t count)
{
    double most = 0, size = 0;
    for (size_t i = 0; i < count; ++i) {
        most = fmax(most, fabs(a[i] - b[i]));
        size = fmax(size, fabs(a[i]));
    }
    ck_assert_double_gt(size, 0);
    return most / size;
}

/** The same for fitted operators, without a surface: the tank is full, at a density that is not the one at rest. */
static void disturbed_fitted(double x, double y, bool strip)
{
    disturbed(x, y, strip);
    scene.domain.max.y = y + (strip ? 26 * DX : 40 * DX);
    scene.method.operators = SPH2D_OPERATORS_FITTED;
    scene.method.artificial_viscosity = 0;
    scene.method.support_ratio = 2.5;
    scene.method.sound_speed = 30;
    scene.boundary.top = SPH2D_SIDE_WALL;
}

static const struct place {
    double x, y;
    bool strip;
} places[] = {{0, 0, false}, {-12345.6, 6543.21, false}, {0, 0, true}, {98765.4, -3210.1, true}};
enum { PLACES = sizeof places / sizeof *places, ISAS = SPH2D_ISA_AVX512 - SPH2D_ISA_BASELINE + 1 };

START_TEST(sums_in_floats_are_those_in_doubles)
{
    disturbed(places[_i].x, places[_i].y, places[_i].strip);
    start(1);
    for (int k = 0; k < 2; ++k) {
        sph2d__store *f = &sims[k]->system.fluid;
        for (size_t i = 0; i < f->count; ++i) {
            f->density[i] *= 1 + 0.01 * sin(70 * (f->x[i] - places[_i].x)) * cos(50 * (f->y[i] - places[_i].y));
            f->vx[i] += 0.1 * sin(40 * (f->x[i] - places[_i].x)) * cos(60 * (f->y[i] - places[_i].y));
        }
        sims[k]->method->evaluate(&sims[k]->system);
        sims[k]->method->density_rate(&sims[k]->system);
    }
    const sph2d__store *a = &sims[0]->system.fluid, *b = &sims[1]->system.fluid;
    const sph2d__store *v = &sims[0]->system.walls, *w = &sims[1]->system.walls;
    ck_assert_uint_eq(a->count, b->count);
    ck_assert_mem_eq(a->id, b->id, a->count * sizeof *a->id);
    ck_assert_double_le(difference(a->ax, b->ax, a->count), 3e-5);
    ck_assert_double_le(difference(a->ay, b->ay, a->count), 3e-5);
    ck_assert_double_le(difference(a->density_grad_x, b->density_grad_x, a->count),
                        2e-4);                                                 /* an inverse of what is summed */
    ck_assert_double_le(difference(a->grad_c_x, b->grad_c_x, a->count), 1e-3); /* less what is across a surface */
    ck_assert_double_le(difference(a->min_eigenvalue, b->min_eigenvalue, a->count), 1e-5);
    ck_assert_double_le(difference(a->density_rate, b->density_rate, a->count), 1e-5);
    ck_assert_double_le(difference(v->pressure, w->pressure, v->count), 5e-5);
    ck_assert_double_le(difference(v->wall_rate, w->wall_rate, v->count),
                        5e-4); /* sums that nearly cancel, over sums */
    ck_assert_double_le(difference(a->stretch, b->stretch, a->count), 1e-4);
    ck_assert_double_le(difference(a->shear, b->shear, a->count), 1e-4);
    ck_assert_double_le(difference(a->packing, b->packing, a->count), 1e-5);
    ck_assert_double_le(difference(a->filling, b->filling, a->count), 1e-4);
    ck_assert_int_ne(memcmp(a->ax, b->ax, a->count * sizeof *a->ax), 0); /* they are floats */
}
END_TEST

START_TEST(fits_in_floats_are_those_in_doubles)
{
    const struct place *at = &places[_i / ISAS];
    const double x = at->x, y = at->y;
    wanted = (sph2d_isa)(SPH2D_ISA_BASELINE + _i % ISAS);
    if (!sph2d_isa_available(wanted))
        return;
    disturbed_fitted(x, y, at->strip);
    start(1);
    for (int k = 0; k < 2; ++k) {
        sph2d__store *f = &sims[k]->system.fluid;
        for (size_t i = 0; i < f->count; ++i) {
            f->density[i] *= 1 + 0.01 * sin(70 * (f->x[i] - x)) * cos(50 * (f->y[i] - y));
            f->vx[i] = sin(40 * (f->x[i] - x)) * cos(60 * (f->y[i] - y));
        }
        sims[k]->system.speed = sims[k]->system.shift_gain = 1;
        sims[k]->method->evaluate(&sims[k]->system);
    }
    const sph2d__store *a = &sims[0]->system.fluid, *b = &sims[1]->system.fluid;
    ck_assert_uint_eq(a->count, b->count);
    ck_assert_double_le(difference(a->ax, b->ax, a->count), 1e-4);
    ck_assert_double_le(difference(a->ay, b->ay, a->count), 1e-4);
    ck_assert_double_le(difference(a->shift_x, b->shift_x, a->count), 2e-3); /* steep where two are close */
    ck_assert_double_le(difference(a->density_rate, b->density_rate, a->count), 1e-5);
    ck_assert_int_ne(memcmp(a->ax, b->ax, a->count * sizeof *a->ax), 0);
}
END_TEST

static void (*const scenes[])(double x, double y, bool strip) = {disturbed, disturbed_fitted};
enum { SCENES = sizeof scenes / sizeof *scenes };

START_TEST(threads_change_no_bit)
{
    scenes[_i](0, 0, true);
    start(1);
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = 3;
    sph2d_sim_destroy(sims[0]);
    sims[0] = test_create(&scene, &options);
    test_steps(sims[0], 10);
    test_steps(sims[1], 10);
    const sph2d__store *a = &sims[0]->system.fluid, *b = &sims[1]->system.fluid;
    ck_assert_mem_eq(a->x, b->x, a->count * sizeof *a->x);
    ck_assert_mem_eq(a->vy, b->vy, a->count * sizeof *a->vy);
    ck_assert_mem_eq(a->density, b->density, a->count * sizeof *a->density);
}
END_TEST

START_TEST(a_state_goes_on_as_if_nothing_was)
{
    scenes[_i](0, 0, false);
    start(1);
    test_steps(sims[1], 15);
    test_state state = test_state_copy(sims[1]);
    sph2d_sim *other = NULL;
    ck_assert_int_eq(sph2d_sim_restore(&scene, NULL, &state.state, &other, NULL), SPH2D_OK);
    test_steps(sims[1], 15);
    test_steps(other, 15);
    const sph2d__store *a = &sims[1]->system.fluid, *b = &other->system.fluid;
    ck_assert_mem_eq(a->x, b->x, a->count * sizeof *a->x);
    ck_assert_mem_eq(a->vy, b->vy, a->count * sizeof *a->vy);
    sph2d_sim_destroy(other);
    test_state_free(&state);
}
END_TEST

Suite *suite_mixed(void)
{
    Suite *suite = suite_create("mixed");
    TCase *cases = tcase_create("mixed");
    tcase_add_checked_fixture(cases, NULL, finish);
    tcase_add_loop_test(cases, sums_in_floats_are_those_in_doubles, 0, PLACES);
    tcase_add_loop_test(cases, fits_in_floats_are_those_in_doubles, 0, PLACES * ISAS);
    tcase_add_loop_test(cases, threads_change_no_bit, 0, SCENES);
    tcase_add_loop_test(cases, a_state_goes_on_as_if_nothing_was, 0, SCENES);
    suite_add_tcase(suite, cases);
    return suite;
}
