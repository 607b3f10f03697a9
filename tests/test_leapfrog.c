/* SPDX-License-Identifier: MIT */
/** @file test_leapfrog.c
 *  The time step, kick-drift-kick: exact in free flight, the same as the staggered leapfrog
 *
 *      u(t + dt/2) = u(t - dt/2) + dt a(t),  x(t + dt) = x(t) + dt u(t + dt/2),  u(-dt/2) = u(0) - dt/2 a(0),
 *      u(t) = (u(t - dt/2) + u(t + dt/2))/2
 *
 *  for forces of position alone and a fixed step, reversible then, and of second order also with viscosity. */
#include <math.h>
#include <string.h>

#include "common.h"

static const double DX = 0.01;

/* ---- free flight ------------------------------------------------------------------------------------------------- */

/** One particle in a large empty space. */
static sph2d_sim *flight(double step)
{
    sph2d_scene scene = test_open_scene(DX, -200, -200, 200, 200);
    scene.gravity = (sph2d_vec2){0.7, -9.81};
    scene.fluid.dynamic_viscosity = 1e-3;
    scene.method.time_step = step;
    sph2d_block block = test_particle(DX, 1, 2, 3, 4);
    scene.blocks = &block;
    scene.block_count = 1;
    return test_create(&scene, NULL);
}

START_TEST(free_flight_is_exact)
{
    /* x = x0 + v0 t + g t^2/2 to 1e-12 of the way after 10^4 steps, since the force is constant. */
    enum { STEPS = 10000 };
    const double step = 1e-4, t = STEPS * step;
    sph2d_sim *sim = flight(step);
    sph2d_view f = sph2d_sim_fluid(sim);
    ck_assert_uint_eq(f.count, 1);
    double x0 = f.x[0], y0 = f.y[0];
    test_steps(sim, STEPS);
    f = sph2d_sim_fluid(sim);
    double way = 3 * t + 9.81 * t * t;
    ck_assert_double_eq_tol(f.x[0], x0 + 3 * t + 0.7 * t * t / 2, 1e-12 * way);
    ck_assert_double_eq_tol(f.y[0], y0 + 4 * t - 9.81 * t * t / 2, 1e-12 * way);
    ck_assert_double_eq_tol(f.vx[0], 3 + 0.7 * t, 1e-12 * way);
    ck_assert_double_eq_tol(f.vy[0], 4 - 9.81 * t, 1e-12 * way);
    ck_assert(f.ax[0] == 0.7 && f.ay[0] == -9.81);
    ck_assert_double_eq_tol(sph2d_sim_time(sim), t, 1e-12);
    ck_assert_uint_eq(sph2d_sim_steps(sim), STEPS);
    ck_assert(f.pressure[0] == 0);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(free_flight_is_exact_with_steps_that_change)
{
    /* Force-limited adaptive steps; the clock is the sum of the steps. */
    sph2d_sim *sim = flight(0);
    sph2d_view f = sph2d_sim_fluid(sim);
    double x0 = f.x[0], y0 = f.y[0];
    while (sph2d_sim_time(sim) < 3)
        test_steps(sim, 1);
    double t = sph2d_sim_time(sim);
    sph2d_summary sum = sph2d_sim_summary(sim);
    ck_assert_double_gt(sum.time_step_max, 1.01 * sum.time_step_min);
    f = sph2d_sim_fluid(sim);
    ck_assert_double_eq_tol(f.x[0], x0 + 3 * t + 0.7 * t * t / 2, 1e-10);
    ck_assert_double_eq_tol(f.y[0], y0 + 4 * t - 9.81 * t * t / 2, 1e-10);
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- the staggered leapfrog -------------------------------------------------------------------------------------- */

static const sph2d_vec2 CENTRE = {0.02, -0.01};
static const double REACH = 0.7, PULL = 40;

/** One particle circling a point that pulls. */
static sph2d_sim *orbit(double step)
{
    static sph2d_path_point point;
    static sph2d_interaction pull;
    static sph2d_block block;
    sph2d_scene scene = test_open_scene(0.1, -5, -5, 5, 5); /* a large support, for large steps */
    point = (sph2d_path_point){0, CENTRE.x, CENTRE.y};
    pull = sph2d_interaction_default();
    pull.path.items = &point;
    pull.path.count = 1;
    pull.radius = REACH;
    pull.acceleration = PULL;
    block = test_particle(0.1, 0.3, 0, 0, 2);
    scene.interactions = &pull;
    scene.interaction_count = 1;
    scene.blocks = &block;
    scene.block_count = 1;
    scene.gravity.y = -1;
    scene.method.time_step = step;
    return test_create(&scene, NULL);
}

/** PULL (1 - r/REACH) towards CENTRE, and gravity. */
static sph2d_vec2 pull_at(double x, double y)
{
    double dx = CENTRE.x - x, dy = CENTRE.y - y, r = hypot(dx, dy), size = r < REACH ? PULL * (1 - r / REACH) / r : 0;
    return (sph2d_vec2){size * dx, size * dy - 1};
}

START_TEST(one_particle_follows_the_staggered_leapfrog)
{
    const double step = 0.01;
    sph2d_sim *sim = orbit(step);
    sph2d_view f = sph2d_sim_fluid(sim);
    sph2d_vec2 x = {f.x[0], f.y[0]}, a = pull_at(x.x, x.y);
    sph2d_vec2 before, u = {0 - step / 2 * a.x, 2 - step / 2 * a.y};
    double apart = 0, travelled = 0;
    for (int n = 0; n < 300; ++n) {
        a = pull_at(x.x, x.y);
        before = u;
        u = (sph2d_vec2){u.x + step * a.x, u.y + step * a.y};
        /* u(t) at the present time, before the drift */
        f = sph2d_sim_fluid(sim);
        apart = fmax(apart, hypot(f.vx[0] - (before.x + u.x) / 2, f.vy[0] - (before.y + u.y) / 2));
        x = (sph2d_vec2){x.x + step * u.x, x.y + step * u.y};
        travelled += step * hypot(u.x, u.y);
        test_steps(sim, 1);
        f = sph2d_sim_fluid(sim);
        apart = fmax(apart, hypot(f.x[0] - x.x, f.y[0] - x.y));
    }
    ck_assert_double_gt(travelled, 4); /* several rounds */
    ck_assert_double_le(apart, 1e-11);
    sph2d_sim_destroy(sim);
}
END_TEST

/** A drop of liquid falling into the corner of a tank with undamped springs: all forces are of position alone. */
static sph2d_sim *conservative_tank(double step, sph2d_scene *out)
{
    static sph2d_block block;
    sph2d_scene scene = test_scene(DX, 0, 0, 0.4, 0.4);
    block = test_block(0.02, 0.01, 0.18, 0.13);
    block.velocity = (sph2d_vec2){-0.5, -0.3};
    scene.blocks = &block;
    scene.block_count = 1;
    scene.gravity.y = -9.81;
    scene.wall_damping = 0;
    scene.method.artificial_viscosity = 1e-30;
    scene.method.time_step = step;
    *out = scene;
    return test_create(&scene, NULL);
}

enum { DROP = 16 * 12 };

START_TEST(liquid_follows_the_staggered_leapfrog)
{
    /* The reference takes a(t) of pressure, springs and gravity from the view, and does the stepping itself. */
    const double step = 2e-4;
    static double x[DROP], y[DROP], ux[DROP], uy[DROP];
    sph2d_scene scene;
    sph2d_sim *sim = conservative_tank(step, &scene);
    sph2d_view f = sph2d_sim_fluid(sim);
    ck_assert_uint_eq(f.count, DROP);
    for (size_t i = 0; i < DROP; ++i) {
        size_t id = (size_t)f.id[i];
        x[id] = f.x[i];
        y[id] = f.y[i];
        ux[id] = f.vx[i] - step / 2 * f.ax[i];
        uy[id] = f.vy[i] - step / 2 * f.ay[i];
    }
    double apart = 0, max_pressure = 0;
    for (int n = 0; n < 300; ++n) {
        f = sph2d_sim_fluid(sim);
        for (size_t i = 0; i < DROP; ++i) {
            size_t id = (size_t)f.id[i];
            double wx = ux[id] + step * f.ax[i], wy = uy[id] + step * f.ay[i];
            apart = fmax(apart, hypot(f.vx[i] - (ux[id] + wx) / 2, f.vy[i] - (uy[id] + wy) / 2));
            apart = fmax(apart, hypot(f.x[i] - x[id], f.y[i] - y[id]));
            max_pressure = fmax(max_pressure, hypot(f.ax[i], f.ay[i]));
            x[id] += step * wx;
            y[id] += step * wy;
            ux[id] = wx;
            uy[id] = wy;
        }
        test_steps(sim, 1);
    }
    ck_assert_double_gt(max_pressure, 300); /* they have hit the walls */
    ck_assert_uint_eq(sph2d_sim_summary(sim).backstop_hits, 0);
    ck_assert_double_le(apart, 1e-11);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(time_runs_backwards)
{
    enum { STEPS = 400 };
    static double x[DROP], y[DROP];
    sph2d_scene scene;
    sph2d_sim *sim = conservative_tank(2e-4, &scene), *back = NULL;
    sph2d_view f = sph2d_sim_fluid(sim);
    for (size_t i = 0; i < DROP; ++i) {
        x[f.id[i]] = f.x[i];
        y[f.id[i]] = f.y[i];
    }
    test_steps(sim, STEPS);
    ck_assert_uint_eq(sph2d_sim_summary(sim).backstop_hits, 0);
    test_state state = test_state_copy(sim);
    for (unsigned c = 0; c < 2; ++c) {
        double *v = test_state_reals(&state, SPH2D_GROUP_FLUID, "Velocities", c);
        for (size_t i = 0; i < DROP; ++i)
            v[i] = -v[i];
    }
    ck_assert_int_eq(sph2d_sim_restore(&scene, NULL, &state.state, &back, NULL), SPH2D_OK);
    double moved = 0, apart = 0;
    for (int pass = 0; pass < 2; ++pass) {
        f = sph2d_sim_fluid(back);
        double *worst = pass == 0 ? &moved : &apart;
        for (size_t i = 0; i < DROP; ++i)
            *worst = fmax(*worst, hypot(f.x[i] - x[f.id[i]], f.y[i] - y[f.id[i]]));
        if (pass == 0)
            test_steps(back, STEPS);
    }
    ck_assert_double_gt(moved, 2 * DX);
    ck_assert_double_le(apart, 1e-6 * DX);
    test_state_free(&state);
    sph2d_sim_destroy(back);
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- order ------------------------------------------------------------------------------------------------------- */

/** Four particles within each other's support, too few for pressure, drag each other while a point far away pulls. */
static sph2d_sim *dragging(double step)
{
    static sph2d_block blocks[4];
    static sph2d_path_point point = {0, 0.3, 0.2};
    static sph2d_interaction pull;
    sph2d_scene scene = test_open_scene(DX, -1, -1, 1, 1);
    scene.method.support_ratio = 5;
    scene.method.time_step = step;
    scene.fluid.dynamic_viscosity = 3;
    scene.method.artificial_viscosity = 1e-30;
    scene.gravity.y = -9.81;
    static const sph2d_vec2 v[4] = {{0.05, 0.02}, {-0.04, 0.03}, {0.01, -0.06}, {0, 0.05}};
    for (int k = 0; k < 4; ++k)
        blocks[k] = test_particle(DX, k % 2 * DX, k / 2 * DX, v[k].x, v[k].y);
    pull = sph2d_interaction_default();
    pull.path.items = &point;
    pull.path.count = 1;
    pull.radius = 5;
    pull.acceleration = 3;
    scene.interactions = &pull;
    scene.interaction_count = 1;
    scene.blocks = blocks;
    scene.block_count = 4;
    return test_create(&scene, NULL);
}

enum { BODIES = 4 };

/** Places and velocities, by id, after `steps` steps over the time `t`. */
static void end_of(sph2d_sim *(*make)(double), double t, int steps, double out[4 * BODIES])
{
    sph2d_sim *sim = make(t / steps);
    test_steps(sim, steps);
    sph2d_view f = sph2d_sim_fluid(sim);
    memset(out, 0, 4 * BODIES * sizeof *out);
    for (size_t i = 0; i < f.count; ++i) {
        double *body = out + 4 * f.id[i];
        body[0] = f.x[i];
        body[1] = f.y[i];
        body[2] = f.vx[i];
        body[3] = f.vy[i];
    }
    sph2d_sim_destroy(sim);
}

/** Largest error of places (part 0) or velocities (part 1) with so many steps, against 32 times as many. */
static double order(sph2d_sim *(*make)(double), double t, int steps, int part)
{
    double exact[4 * BODIES], coarse[4 * BODIES], fine[4 * BODIES], e1 = 0, e2 = 0;
    end_of(make, t, 64 * steps, exact);
    end_of(make, t, steps, coarse);
    end_of(make, t, 2 * steps, fine);
    for (int k = 0; k < 4 * BODIES; ++k)
        if ((k % 4) / 2 == part) {
            e1 = fmax(e1, fabs(coarse[k] - exact[k]));
            e2 = fmax(e2, fabs(fine[k] - exact[k]));
        }
    ck_assert_double_gt(e1, 1e-9); /* above round-off */
    return log2(e1 / e2);
}

START_TEST(second_order_for_forces_of_position)
{
    double observed = order(orbit, 0.8, 80, _i);
    ck_assert_double_ge(observed, 1.9);
    ck_assert_double_le(observed, 2.1);
}
END_TEST

START_TEST(second_order_with_viscosity)
{
    /* 1 with the velocity of half a step, or of the step before, in the drag. */
    double observed = order(dragging, 0.2, 50, _i);
    ck_assert_double_ge(observed, 1.9);
    ck_assert_double_le(observed, 2.1);
}
END_TEST

START_TEST(viscosity_drags)
{
    /* The test above is only as good as its force: it must have taken most of the relative motion. */
    double before[4 * BODIES], after[4 * BODIES];
    end_of(dragging, 1e-9, 1, before);
    end_of(dragging, 0.2, 200, after);
    double was = hypot(before[2] - before[6], before[3] - before[7]);
    double is = hypot(after[2] - after[6], after[3] - after[7]);
    ck_assert_double_eq_tol(was, hypot(0.09, 0.01), 1e-6);
    ck_assert_double_lt(is, 0.5 * was);
    ck_assert_double_gt(is, 1e-3 * was);
}
END_TEST

Suite *suite_leapfrog(void)
{
    Suite *suite = suite_create("leapfrog");
    TCase *tests = tcase_create("leapfrog");
    tcase_add_test(tests, free_flight_is_exact);
    tcase_add_test(tests, free_flight_is_exact_with_steps_that_change);
    tcase_add_test(tests, one_particle_follows_the_staggered_leapfrog);
    tcase_add_test(tests, liquid_follows_the_staggered_leapfrog);
    tcase_add_test(tests, time_runs_backwards);
    tcase_add_loop_test(tests, second_order_for_forces_of_position, 0, 2);
    tcase_add_test(tests, viscosity_drags);
    suite_add_tcase(suite, tests);
    TCase *slow = test_long(suite);
    tcase_add_loop_test(slow, second_order_with_viscosity, 0, 2);
    return suite;
}
