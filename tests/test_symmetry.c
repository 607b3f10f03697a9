/* SPDX-License-Identifier: MIT */
/** @file test_symmetry.c
 *  What must not matter to a run of method `wcsph`: a moving frame, a mirror, the order of particles, where a period
 *  begins. */
#include <math.h>

#include "cloud.h"
#include "sim/simulation.h"

/** Largest distance between particles of one number, with `b` mapped to sign (x, y) + (by, 0). */
static double apart(const sph2d_sim *a, const sph2d_sim *b, double sign_x, double by)
{
    sph2d_view f = sph2d_sim_fluid(a), g = sph2d_sim_fluid(b);
    double worst = 0;
    ck_assert_uint_eq(f.count, g.count);
    for (size_t i = 0; i < f.count; ++i) {
        size_t j = test_find(g, f.id[i]);
        worst = fmax(worst, hypot(f.x[i] - sign_x * g.x[j] - by, f.y[i] - g.y[j]));
    }
    return worst;
}

START_TEST(a_moving_frame_changes_nothing)
{
    cloud_start();
    cloud.scene.method.time_step = 0.002;
    cloud.scene.fluid.dynamic_viscosity = 2;
    sph2d_sim *still = test_create(&cloud.scene, NULL);
    cloud.blocks[0].velocity = (sph2d_vec2){3, 0};
    sph2d_sim *moving = test_create(&cloud.scene, NULL);
    cloud_stir(still, 0.3);
    cloud_stir(moving, 0.3);
    test_steps(still, 100);
    test_steps(moving, 100);
    ck_assert_double_lt(apart(moving, still, 1, 3 * 0.2), 1e-8);
    sph2d_sim_destroy(still);
    sph2d_sim_destroy(moving);
}
END_TEST

/** Mirrors a simulation at x = 0 with all that its particles carry. */
static void mirror(sph2d_sim *sim)
{
    sph2d__store *f = &sim->system.fluid;
    for (size_t i = 0; i < f->count; ++i) {
        f->x[i] = -f->x[i];
        f->vx[i] = -f->vx[i];
        f->ax[i] = -f->ax[i];
    }
}

START_TEST(a_mirrored_run_is_the_mirror_of_the_run)
{
    cloud_start();
    cloud.scene.fluid.dynamic_viscosity = 2;
    sph2d_sim *one = test_create(&cloud.scene, NULL), *other = test_create(&cloud.scene, NULL);
    cloud_stir(one, 0.3);
    cloud_stir(other, 0.3);
    mirror(other);
    test_steps(one, 20);
    test_steps(other, 20);
    ck_assert_double_lt(apart(one, other, -1, 0), 1e-12);
    sph2d_sim_destroy(one);
    sph2d_sim_destroy(other);
}
END_TEST

/** Two halves in either order. */
static sph2d_sim *halves(int first)
{
    cloud_start();
    cloud.blocks[first] = test_block(0, 0, 0.5, 1);
    cloud.blocks[1 - first] = test_block(0.5, 0, 1, 1);
    cloud.scene.block_count = 2;
    sph2d_sim *sim = test_create(&cloud.scene, NULL);
    sph2d__store *f = &sim->system.fluid;
    for (size_t i = 0; i < f->count; ++i) {
        f->vx[i] = 0.3 * sin(7 * f->x[i]) * cos(5 * f->y[i]);
        f->vy[i] = 0.2 * sin(3 * f->x[i] + 4 * f->y[i]);
    }
    return sim;
}

START_TEST(the_order_of_the_particles_changes_nothing)
{
    sph2d_sim *one = halves(0), *other = halves(1);
    test_steps(one, 100);
    test_steps(other, 100);
    sph2d_view f = sph2d_sim_fluid(one), g = sph2d_sim_fluid(other);
    double worst = 0;
    for (size_t i = 0; i < f.count; ++i) {
        size_t j = test_find(g, (f.id[i] + 200) % 400);
        worst = fmax(worst, hypot(f.x[i] - g.x[j], f.y[i] - g.y[j]));
    }
    ck_assert_double_lt(worst, 1e-12);
    sph2d_sim_destroy(one);
    sph2d_sim_destroy(other);
}
END_TEST

/* Where a period begins does not matter: the same particles in a room that begins elsewhere, for both methods. */
START_TEST(the_origin_of_a_period_changes_nothing)
{
    sph2d_sim *sims[2];
    for (int k = 0; k < 2; ++k) {
        cloud.scene = test_scene(0.05, 0.33 * k, 0.71 * k, 1 + 0.33 * k, 1 + 0.71 * k);
        cloud.scene.boundary =
            (sph2d_boundary){SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC};
        if (_i)
            cloud_plain(10);
        cloud.scene.fluid.dynamic_viscosity = 2;
        cloud.blocks[0] = test_block(0.33 * k, 0.71 * k, 1 + 0.33 * k, 1 + 0.71 * k);
        cloud.blocks[0].perturb.amplitude = 0.2;
        sph2d_obstacle obstacle = sph2d_obstacle_default(); /* across two sides of one room */
        obstacle.shape.kind = SPH2D_SHAPE_CIRCLE;
        obstacle.shape.circle = (sph2d_circle){{k ? 1.3 : 0.3, 0.8}, 0.12};
        cloud.scene.obstacles = &obstacle;
        cloud.scene.obstacle_count = 1;
        cloud.scene.blocks = cloud.blocks;
        cloud.scene.block_count = 1;
        sims[k] = test_create(&cloud.scene, NULL);
    }
    sph2d__store *f = &sims[0]->system.fluid, *g = &sims[1]->system.fluid;
    ck_assert_uint_ge(g->capacity, f->count); /* the lattices lie differently around the obstacle */
    g->count = f->count;
    for (size_t i = 0; i < f->count; ++i) {
        g->x[i] = sph2d__period_wrap(f->x[i], 0.33, 1);
        g->y[i] = sph2d__period_wrap(f->y[i], 0.71, 1);
        g->vx[i] = f->vx[i];
        g->vy[i] = f->vy[i];
        g->ax[i] = f->ax[i];
        g->ay[i] = f->ay[i];
        g->density[i] = f->density[i];
        if (f->log_density)
            g->log_density[i] = f->log_density[i];
        g->id[i] = f->id[i];
    }
    sims[1]->record.next_step = sims[0]->record.next_step;
    test_steps(sims[0], 20);
    test_steps(sims[1], 20);
    sph2d_view a = sph2d_sim_fluid(sims[0]), b = sph2d_sim_fluid(sims[1]);
    for (size_t i = 0; i < a.count; ++i) {
        size_t j = test_find(b, a.id[i]);
        ck_assert_double_eq_tol(sph2d__period_nearest(a.x[i] - b.x[j], 1), 0, 1e-10);
        ck_assert_double_eq_tol(sph2d__period_nearest(a.y[i] - b.y[j], 1), 0, 1e-10);
    }
    sph2d_sim_destroy(sims[0]);
    sph2d_sim_destroy(sims[1]);
}
END_TEST

Suite *suite_symmetry(void)
{
    Suite *suite = suite_create("symmetry");
    TCase *tests = tcase_create("symmetry");
    tcase_add_test(tests, a_moving_frame_changes_nothing);
    tcase_add_test(tests, a_mirrored_run_is_the_mirror_of_the_run);
    tcase_add_test(tests, the_order_of_the_particles_changes_nothing);
    tcase_add_loop_test(tests, the_origin_of_a_period_changes_nothing, 0, 2);
    suite_add_tcase(suite, tests);
    return suite;
}
