/* SPDX-License-Identifier: MIT */
/** @file test_projection.c
 *  Method `pcisph`: density, its rate and the transpose, the prototype factor. The equations are those of projection.h. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common.h"
#include "kernels/kernel.h"
#include "methods/projection/projection.h"
#include "sim/simulation.h"
#include "sim/stages.h"
#include "simd/lanes.h"

static sph2d_scene scene;
static sph2d_block block;
static sph2d_sim *sim;

static const double DX = 0.02, RHO0 = 1000;

static void finish(void)
{
    sph2d_sim_destroy(sim);
    sim = NULL;
}

/** A box of `side` by `side` spacings, full of liquid. */
static void full_box(sph2d_method method, int side)
{
    scene = test_scene(DX, 0, 0, side * DX, side * DX);
    scene.method = sph2d_scene_default().method;
    scene.method.name = method;
    block = test_block(0, 0, side * DX, side * DX);
    scene.blocks = &block;
    scene.block_count = 1;
}

static void make_periodic(void)
{
    scene.boundary =
        (sph2d_boundary){SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC};
}

/** A column in a tank, on the ground. */
static void column(sph2d_method method, double width, double height)
{
    full_box(method, 50);
    scene.boundary.top = SPH2D_SIDE_OPEN;
    scene.gravity.y = -9.81;
    scene.fluid.dynamic_viscosity = 0.5;
    block = test_block(0, 0, width, height);
}

static void start(int threads)
{
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = threads;
    sim = test_create(&scene, &options);
}

/* ---- sums -------------------------------------------------------------------------------------------------------- */

/* sum |grad W|^2 dx^6 over a filled square lattice, and c times -sum dx^2 x W_x, from the kernels' formulas at the
 * lattice's distances. */
static const struct lattice {
    sph2d_kernel kernel;
    double ratio, sum, moment;
} lattices[] = {
    {SPH2D_KERNEL_WENDLAND_C2, 2.0, 0.52402, 0.940852981},  {SPH2D_KERNEL_WENDLAND_C2, 2.4, 0.35427, 0.946852152},
    {SPH2D_KERNEL_WENDLAND_C2, 2.6, 0.27764, 0.963827174},  {SPH2D_KERNEL_WENDLAND_C2, 3.0, 0.16906, 0.992296541},
    {SPH2D_KERNEL_WENDLAND_C2, 4.0, 0.05684, 0.997995899},  {SPH2D_KERNEL_WENDLAND_C4, 2.4, 0.49497, 0.964992901},
    {SPH2D_KERNEL_WENDLAND_C4, 2.75, 0.36845, 0.979322432}, {SPH2D_KERNEL_WENDLAND_C4, 3.0, 0.28459, 0.987634181},
    {SPH2D_KERNEL_WENDLAND_C4, 4.0, 0.09937, 0.998271706},
};
enum { LATTICES = sizeof lattices / sizeof *lattices };

START_TEST(filled_lattice_has_rest_density_and_the_prototype_factor)
{
    full_box(SPH2D_METHOD_PCISPH, 16);
    make_periodic();
    scene.method.sound_speed = 10;
    scene.method.kernel = lattices[_i].kernel;
    scene.method.support_ratio = lattices[_i].ratio;
    start(1);
    const sph2d__store *f = &sim->system.fluid;
    double c = sim->system.calibration, factor = sph2d__projection_prototype(&sim->system);
    ck_assert_double_eq_tol(factor * DX * DX / (c * c), lattices[_i].sum, 6e-6);
    for (size_t i = 0; i < f->count; ++i)
        ck_assert_double_eq_tol(f->density[i], RHO0, 1e-9);
    ck_assert_double_eq_tol(sim->system.moment, lattices[_i].moment, 1e-9);
}
END_TEST

/** The default support of every kernel is wide enough that a lattice that is strained, to 0.7 and 1/0.7 spacings, tells
 *  the density that it has: sums of the kernels' formulas at the lattice's distances. */
START_TEST(strained_lattices_have_rest_density)
{
    static const double reported[SPH2D_KERNEL_COUNT] = {
        [SPH2D_KERNEL_WENDLAND_C2] = 1.017506, [SPH2D_KERNEL_WENDLAND_C4] = 1.022448};
    full_box(SPH2D_METHOD_PCISPH, 16);
    make_periodic();
    scene.method.sound_speed = 10;
    scene.method.kernel = (sph2d_kernel)_i;
    start(1);
    const double across = 0.7 * DX, along = DX / 0.7, support = sim->system.support, ratio = DX / support;
    double sum = 0;
    for (int i = -9; i <= 9; ++i)
        for (int j = -9; j <= 9; ++j)
            sum += sph2d__kernel_value_at(scene.method.kernel, hypot(i * across, j * along) / support);
    double density = sim->system.calibration * sph2d__kernel_constant(scene.method.kernel) * ratio * ratio * sum;
    ck_assert_msg(reported[scene.method.kernel] > 0, "the density of kernel %d is missing above", _i);
    ck_assert_double_eq_tol(density, reported[scene.method.kernel], 1e-6);
}
END_TEST

static void predict_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    (void)with;
    (void)sum;
    sph2d__projection_predict(s, slab);
}

/* Inside a lattice D' of a field with an even slope is the moment times the slope: that is what makes it a gradient. */
START_TEST(the_moment_turns_multipliers_into_pressure)
{
    full_box(SPH2D_METHOD_PCISPH, 16);
    scene.method.sound_speed = 10;
    scene.method.kernel = lattices[_i].kernel;
    scene.method.support_ratio = lattices[_i].ratio;
    start(1);
    sph2d__store *f = &sim->system.fluid;
    for (size_t i = 0; i < f->count; ++i)
        f->multiplier[i] = 3 + 2 * f->x[i] - 5 * f->y[i];
    memset(f->ax, 0, f->count * sizeof *f->ax);
    memset(f->ay, 0, f->count * sizeof *f->ay);
    sim->system.step = 1;
    sph2d__projection_end(&sim->system);
    int inside = 0;
    for (size_t i = 0; i < f->count; ++i)
        if (fabs(f->x[i] - 8 * DX) < 3 * DX && fabs(f->y[i] - 8 * DX) < 3 * DX) {
            ck_assert_double_eq_tol(-f->ax[i], 2 * lattices[_i].moment, 1e-5);
            ck_assert_double_eq_tol(-f->ay[i], -5 * lattices[_i].moment, 1e-5);
            ++inside;
        }
    ck_assert_int_eq(inside, 36);
}
END_TEST

START_TEST(layered_walls_fill_like_liquid)
{
    full_box(SPH2D_METHOD_PCISPH, 16);
    scene.method.sound_speed = 10;
    start(1);
    const sph2d__store *f = &sim->system.fluid;
    const sph2d__store *w = &sim->system.walls;
    for (size_t i = 0; i < f->count; ++i)
        ck_assert_double_eq_tol(f->density[i], RHO0, 1e-9);
    for (size_t b = 0; b < w->count; ++b) /* near corners liquid is on one side only */
        if (w->x[b] > 3 * DX && w->x[b] < 13 * DX && w->filled[b] > 0)
            ck_assert_double_eq_tol(w->density[b], RHO0, 1e-9);
}
END_TEST

/** Disordered liquid with walls and a moving obstacle around it, and something in every array. */
static sph2d__system *disordered(void)
{
    static sph2d_obstacle obstacle;
    column(SPH2D_METHOD_PCISPH, 0.6, 0.4);
    block.perturb.amplitude = 0.3;
    obstacle = sph2d_obstacle_default();
    obstacle.shape.kind = SPH2D_SHAPE_CIRCLE;
    obstacle.shape.circle = (sph2d_circle){{0.3, 0.2}, 0.08};
    scene.obstacles = &obstacle;
    scene.obstacle_count = 1;
    start(1);
    return &sim->system;
}

/** Moves everything on by its velocity times `way`, and copies what density would be then. */
static void predict(sph2d__system *s, double way, double *fluid, double *walls)
{
    sph2d__store *f = &s->fluid;
    s->step = way;
    for (size_t i = 0; i < f->count; ++i) {
        f->next_x[i] = f->x[i] + way * f->vx[i];
        f->next_y[i] = f->y[i] + way * f->vy[i];
    }
    f->next_x[f->count] = f->next_y[f->count] = 1e30; /* with which shorter lists end */
    sph2d__over_rows(s, predict_slab, NULL);
    memcpy(fluid, f->residual, f->count * sizeof *fluid);
    memcpy(walls, s->walls.residual, s->walls.count * sizeof *walls);
}

/* Forces are the transpose of the rate of what is kept: y . D v = v . D' y for any multipliers and velocities, the rate by
 * differences. Without a motion what is kept is the density. */
START_TEST(forces_are_the_transpose_of_the_rate)
{
    sph2d__system *s = disordered();
    sph2d__store *f = &s->fluid, *w = &s->walls;
    uint64_t random = 3;
    const double small = 1e-6;
    double by_rows = 0, by_columns = 0, *fluid[2], *walls[2];
    for (int k = 0; k < 2; ++k) {
        fluid[k] = malloc((f->count + SPH2D__PADDING) * sizeof(double));
        walls[k] = malloc((w->count + SPH2D__PADDING) * sizeof(double));
    }
    for (size_t i = 0; i < f->count; ++i) {
        f->multiplier[i] = test_random(&random, 0, 1);
        f->vx[i] = test_random(&random, -1, 1);
        f->vy[i] = test_random(&random, -1, 1);
        f->ax[i] = f->ay[i] = 0;
    }
    for (size_t b = 0; b < w->count; ++b) { /* a multiplier where there is no row means nothing */
        w->multiplier[b] = w->filled[b] > 0 ? test_random(&random, 0, 1) : 0;
        w->vx[b] = w->vy[b] = 0;
    }
    predict(s, 0, fluid[0], walls[0]);
    for (size_t i = 0; i < f->count; ++i)
        ck_assert_double_eq_tol(fluid[0][i], f->density[i] / RHO0 - 1, 1e-12);
    for (size_t b = 0; b < w->count; ++b)
        ck_assert_double_eq_tol(walls[0][b], w->mass[b] / s->mass * (w->density[b] / RHO0 - 1), 1e-12);
    predict(s, small, fluid[0], walls[0]);
    predict(s, -small, fluid[1], walls[1]);
    s->step = 1;
    sph2d__projection_end(s);
    for (size_t i = 0; i < f->count; ++i) {
        by_rows += f->multiplier[i] * (fluid[0][i] - fluid[1][i]) / (2 * small);
        by_columns -= f->vx[i] * f->ax[i] + f->vy[i] * f->ay[i];
    }
    for (size_t b = 0; b < w->count; ++b)
        by_rows += w->multiplier[b] * (walls[0][b] - walls[1][b]) / (2 * small);
    ck_assert_double_gt(fabs(by_rows), 1);
    ck_assert_double_eq_tol(by_columns / by_rows, 1, 1e-5); /* gradients are floats */
    for (int k = 0; k < 2; ++k) {
        free(fluid[k]);
        free(walls[k]);
    }
}
END_TEST

/** Sets the velocities of the boundary particles of the only body to those of its points at a motion, of others to 0. */
static void move_rigidly(sph2d__store *w, const sph2d__rigid *r, sph2d__twist v)
{
    for (size_t b = 0; b < w->count; ++b) {
        const bool own = w->id[b] >= r->first_id && w->id[b] < r->end_id;
        w->vx[b] = own ? v.x - v.turn * (w->y[b] - r->center.y) : 0;
        w->vy[b] = own ? v.y + v.turn * (w->x[b] - r->center.x) : 0;
    }
}

/* The motion of a body is V + dt a - (m/M, m/M, m/I) (D' y)_body/dt (body_rows.h), with (D' y)_body the transpose of the
 * rate by the body's motion, by differences: u . (D' y)_body = y . D u for the three motions u = V + Omega x r. */
START_TEST(bodies_are_moved_by_the_transpose_of_the_rate)
{
    static const double small = 1e-6;
    sph2d_body body = sph2d_body_default();
    column(SPH2D_METHOD_PCISPH, 0.6, 0.4);
    block.perturb.amplitude = 0.3;
    body.shape = (sph2d_shape){.kind = SPH2D_SHAPE_BOX, .box = {{0.2, 0.14}, {0.42, 0.26}}};
    body.density = 600;
    body.velocity = (sph2d_vec2){0.3, -0.2};
    body.rate = 1.5;
    scene.bodies = &body;
    scene.body_count = 1;
    start(1);
    sph2d__system *s = &sim->system;
    sph2d__store *f = &s->fluid, *w = &s->walls;
    sph2d__rigid *r = &sim->bodies.items[0];
    uint64_t random = 5;
    double *fluid[2], *walls[2], rate[3] = {0, 0, 0};
    for (int k = 0; k < 2; ++k) {
        fluid[k] = malloc((f->count + SPH2D__PADDING) * sizeof(double));
        walls[k] = malloc((w->count + SPH2D__PADDING) * sizeof(double));
    }
    for (size_t i = 0; i < f->count; ++i) {
        f->multiplier[i] = test_random(&random, 0, 1) * (f->x[i] + 2 * f->y[i]);
        f->vx[i] = f->vy[i] = f->ax[i] = f->ay[i] = 0;
    }
    for (size_t b = 0; b < w->count; ++b)
        w->multiplier[b] = w->filled[b] > 0 ? test_random(&random, 0, 1) * (w->x[b] + 2 * w->y[b]) : 0;
    for (int motion = 0; motion < 3; ++motion) {
        move_rigidly(w, r, (sph2d__twist){motion == 0, motion == 1, motion == 2});
        predict(s, small, fluid[0], walls[0]);
        predict(s, -small, fluid[1], walls[1]);
        for (size_t i = 0; i < f->count; ++i)
            rate[motion] += f->multiplier[i] * (fluid[0][i] - fluid[1][i]) / (2 * small);
        for (size_t b = 0; b < w->count; ++b)
            rate[motion] += w->multiplier[b] * (walls[0][b] - walls[1][b]) / (2 * small);
    }
    s->step = 0.5;
    r->other = (sph2d__twist){2 * r->mass, -3 * r->mass, 4 * r->inertia};
    sph2d__projection_end(s);
    const sph2d__twist change = {s->mass / r->mass * rate[0] / 0.5, s->mass / r->mass * rate[1] / 0.5,
                                 s->mass / r->inertia * rate[2] / 0.5};
    const sph2d__twist expected = {0.3 + 0.5 * 2 - change.x, -0.2 - 0.5 * 3 - change.y, 1.5 + 0.5 * 4 - change.turn};
    const double scale = fabs(change.x) + fabs(change.y), turn = fabs(change.turn);
    ck_assert_double_gt(fabs(change.x), 0.1);
    ck_assert_double_gt(fabs(change.y), 0.1);
    ck_assert_double_gt(0.1 * turn, 0.1);
    for (size_t b = 0; b < w->count; ++b)
        if (w->id[b] >= r->first_id && w->id[b] < r->end_id) { /* gradients are floats */
            const double x = w->x[b] - r->center.x, y = w->y[b] - r->center.y;
            ck_assert_double_eq_tol(w->vx[b], expected.x - expected.turn * y, 1e-5 * (scale + turn));
            ck_assert_double_eq_tol(w->vy[b], expected.y + expected.turn * x, 1e-5 * (scale + turn));
        }
    for (int k = 0; k < 2; ++k) {
        free(fluid[k]);
        free(walls[k]);
    }
}
END_TEST

Suite *suite_projection(void)
{
    Suite *suite = suite_create("projection");
    TCase *cases = tcase_create("projection");
    tcase_add_checked_fixture(cases, NULL, finish);
    tcase_add_loop_test(cases, filled_lattice_has_rest_density_and_the_prototype_factor, 0, LATTICES);
    tcase_add_loop_test(cases, strained_lattices_have_rest_density, 0, SPH2D_KERNEL_COUNT);
    tcase_add_loop_test(cases, the_moment_turns_multipliers_into_pressure, 0, LATTICES);
    tcase_add_test(cases, layered_walls_fill_like_liquid);
    tcase_add_test(cases, forces_are_the_transpose_of_the_rate);
    tcase_add_test(cases, bodies_are_moved_by_the_transpose_of_the_rate);
    suite_add_tcase(suite, cases);
    return suite;
}
