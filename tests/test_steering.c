/* SPDX-License-Identifier: MIT */
/** @file test_steering.c
 *  Pulls and pushes: acceleration * (1 - r/radius) towards a point inside `radius`, along a path in time, through the
 *  scene and through the library; gravity that changes while a run goes on. */
#include <math.h>

#include "common.h"

static const double DX = 0.01, STEP = 1e-3;

/** Particles alone at rest, far from each other, without gravity; what acts on them is steering alone. */
static const sph2d_vec2 PLACES[] = {{0, 0}, {0.3, 0.1}, {-0.2, 0.45}, {0.05, -0.6}, {0.9, 0.9}};
enum { PARTICLES = sizeof PLACES / sizeof PLACES[0] };

static sph2d_sim *with_interactions(const sph2d_interaction *interactions, size_t count)
{
    sph2d_scene scene = test_open_scene(DX, -2, -2, 2, 2);
    sph2d_block blocks[PARTICLES];
    for (int i = 0; i < PARTICLES; ++i)
        blocks[i] = test_particle(DX, PLACES[i].x, PLACES[i].y, 0, 0);
    scene.blocks = blocks;
    scene.block_count = PARTICLES;
    scene.interactions = interactions;
    scene.interaction_count = count;
    scene.method.time_step = STEP;
    return test_create(&scene, NULL);
}

static sph2d_interaction pull(const sph2d_path_point *points, size_t count, double radius, double acceleration)
{
    sph2d_interaction interaction = sph2d_interaction_default();
    interaction.path = (sph2d_path){points, count};
    interaction.radius = radius;
    interaction.acceleration = acceleration;
    return interaction;
}

/** Adds the documented acceleration of one point at `at`. */
static void add_pull(sph2d_vec2 at, double radius, double acceleration, double x, double y, sph2d_vec2 *a)
{
    double r = hypot(at.x - x, at.y - y);
    if (r == 0 || r >= radius)
        return;
    a->x += acceleration * (1 - r / radius) * (at.x - x) / r;
    a->y += acceleration * (1 - r / radius) * (at.y - y) / r;
}

/** Largest difference between the accelerations in the view and those of so many points. */
static double difference(const sph2d_sim *sim, const sph2d_vec2 *at, const double *radius, const double *acceleration,
                         int count)
{
    sph2d_view f = sph2d_sim_fluid(sim);
    ck_assert_uint_eq(f.count, PARTICLES);
    double worst = 0;
    for (size_t i = 0; i < f.count; ++i) {
        sph2d_vec2 a = {0, 0};
        for (int k = 0; k < count; ++k)
            add_pull(at[k], radius[k], acceleration[k], f.x[i], f.y[i], &a);
        worst = fmax(worst, hypot(f.ax[i] - a.x, f.ay[i] - a.y));
    }
    return worst;
}

START_TEST(a_single_point_pulls_for_ever)
{
    const sph2d_path_point point = {0.05, 0.1, 0.2}; /* its time does not matter */
    const sph2d_vec2 at = {0.1, 0.2};
    const double radius = 0.7, acceleration = _i ? -8 : 8;
    sph2d_interaction interaction = pull(&point, 1, radius, acceleration);
    sph2d_sim *sim = with_interactions(&interaction, 1);
    for (int n = 0; n < 100; ++n) {
        ck_assert_double_le(difference(sim, &at, &radius, &acceleration, 1), 1e-12);
        test_steps(sim, 1);
    }
    /* It has moved them the right way, and left alone the one beyond its reach. */
    sph2d_view f = sph2d_sim_fluid(sim);
    size_t first = test_find(f, 0), far = test_find(f, PARTICLES - 1);
    double was = hypot(at.x, at.y), is = hypot(f.x[first] - at.x, f.y[first] - at.y);
    ck_assert(_i ? is > was + 0.01 : is < was - 0.01);
    ck_assert(f.vx[far] == 0 && f.vy[far] == 0);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(a_path_leads_the_point_through_time)
{
    /* Nothing before 0.02 s and after 0.08 s; straight lines with a kink at 0.04 s in between. */
    static const sph2d_path_point path[] = {{0.02, -0.2, 0}, {0.04, 0.2, 0.3}, {0.08, 0.2, -0.5}};
    const double radius = 1.1, acceleration = 5;
    sph2d_interaction interaction = pull(path, 3, radius, acceleration);
    sph2d_sim *sim = with_interactions(&interaction, 1);
    double worst = 0;
    int active = 0;
    for (int n = 0; n < 110; ++n) {
        double t = sph2d_sim_time(sim), nearest = fmin(fabs(t - 0.02), fabs(t - 0.08));
        sph2d_vec2 at =
            t < 0.04 ? (sph2d_vec2){-0.2 + 20 * (t - 0.02), 15 * (t - 0.02)} : (sph2d_vec2){0.2, 0.3 - 20 * (t - 0.04)};
        bool on = t > 0.02 && t < 0.08;
        active += on;
        if (nearest > 1e-9) /* at the ends themselves rounding of the clock decides */
            worst = fmax(worst, difference(sim, &at, &radius, &acceleration, on));
        test_steps(sim, 1);
    }
    ck_assert_int_ge(active, 58);
    ck_assert_double_le(worst, 1e-11);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(several_points_and_the_pointer_add_up)
{
    static const sph2d_path_point one = {0, 0.5, 0}, two = {0, -0.4, -0.1};
    sph2d_interaction interactions[2] = {pull(&one, 1, 0.8, 3), pull(&two, 1, 1.5, -2)};
    sph2d_vec2 at[3] = {{0.5, 0}, {-0.4, -0.1}, {0.1, 0.6}};
    double radius[3] = {0.8, 1.5, 0.9}, acceleration[3] = {3, -2, 4};
    sph2d_sim *sim = with_interactions(interactions, 2);
    ck_assert_double_le(difference(sim, at, radius, acceleration, 2), 1e-12);
    ck_assert_int_eq(sph2d_sim_set_pointer(sim, at[2], radius[2], acceleration[2]), SPH2D_OK);
    for (int n = 0; n < 20; ++n) {
        test_steps(sim, 1);
        ck_assert_double_le(difference(sim, at, radius, acceleration, 3), 1e-12);
    }
    /* It moves, changes and ends. */
    at[2] = (sph2d_vec2){-0.1, -0.3};
    acceleration[2] = -7;
    radius[2] = 0.4;
    ck_assert_int_eq(sph2d_sim_set_pointer(sim, at[2], radius[2], acceleration[2]), SPH2D_OK);
    test_steps(sim, 1);
    ck_assert_double_le(difference(sim, at, radius, acceleration, 3), 1e-12);
    ck_assert_int_eq(sph2d_sim_set_pointer(sim, at[2], radius[2], 0), SPH2D_OK);
    test_steps(sim, 1);
    ck_assert_double_le(difference(sim, at, radius, acceleration, 2), 1e-12);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(a_particle_at_the_point_stays_finite)
{
    const sph2d_path_point point = {0, PLACES[0].x, PLACES[0].y};
    sph2d_interaction interaction = pull(&point, 1, 0.2, 1e3);
    sph2d_sim *sim = with_interactions(&interaction, 1);
    sph2d_view f = sph2d_sim_fluid(sim);
    size_t first = test_find(f, 0);
    ck_assert(isfinite(f.ax[first]) && isfinite(f.ay[first]));
    ck_assert_double_le(hypot(f.ax[first], f.ay[first]), 1e3 * (1 + 1e-12));
    test_steps(sim, 100);
    f = sph2d_sim_fluid(sim);
    ck_assert_double_le(hypot(f.x[test_find(f, 0)], f.y[test_find(f, 0)]), 0.01); /* held there */
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(wrong_steering_is_refused_and_changes_nothing)
{
    sph2d_sim *sim = with_interactions(NULL, 0);
    const sph2d_vec2 at = {0.1, 0.1};
    double radius = 0.5, acceleration = 2;
    ck_assert_int_eq(sph2d_sim_set_pointer(sim, at, radius, acceleration), SPH2D_OK);
    ck_assert_int_eq(sph2d_sim_set_gravity(sim, (sph2d_vec2){0, 0}), SPH2D_OK);
    ck_assert_int_eq(sph2d_sim_set_pointer(sim, (sph2d_vec2){NAN, 0}, 1, 1), SPH2D_INVALID);
    ck_assert_int_eq(sph2d_sim_set_pointer(sim, (sph2d_vec2){0, INFINITY}, 1, 1), SPH2D_INVALID);
    ck_assert_int_eq(sph2d_sim_set_pointer(sim, at, NAN, 1), SPH2D_INVALID);
    ck_assert_int_eq(sph2d_sim_set_pointer(sim, at, INFINITY, 1), SPH2D_INVALID);
    ck_assert_int_eq(sph2d_sim_set_pointer(sim, at, 0, 1), SPH2D_INVALID);
    ck_assert_int_eq(sph2d_sim_set_pointer(sim, at, -1, 1), SPH2D_INVALID);
    ck_assert_int_eq(sph2d_sim_set_pointer(sim, at, -1, 0), SPH2D_INVALID);
    ck_assert_int_eq(sph2d_sim_set_pointer(sim, at, 1, NAN), SPH2D_INVALID);
    ck_assert_int_eq(sph2d_sim_set_pointer(sim, at, 1, -INFINITY), SPH2D_INVALID);
    ck_assert_int_eq(sph2d_sim_set_gravity(sim, (sph2d_vec2){NAN, 0}), SPH2D_INVALID);
    ck_assert_int_eq(sph2d_sim_set_gravity(sim, (sph2d_vec2){0, INFINITY}), SPH2D_INVALID);
    test_steps(sim, 1);
    ck_assert_double_le(difference(sim, &at, &radius, &acceleration, 1), 1e-12);
    ck_assert_int_eq(sph2d_sim_set_pointer(sim, at, 0, 0), SPH2D_OK); /* ended: no reach is needed */
    test_steps(sim, 1);
    ck_assert_double_le(difference(sim, &at, &radius, &acceleration, 0), 0);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(gravity_changes_from_the_next_step_on)
{
    sph2d_sim *sim = with_interactions(NULL, 0);
    sph2d_view f = sph2d_sim_fluid(sim);
    ck_assert(f.ax[0] == 0 && f.ay[0] == 0);
    ck_assert_int_eq(sph2d_sim_set_gravity(sim, (sph2d_vec2){1.5, -3}), SPH2D_OK);
    test_steps(sim, 1);
    f = sph2d_sim_fluid(sim);
    ck_assert(f.ax[0] == 1.5 && f.ay[0] == -3);
    test_steps(sim, 100);
    f = sph2d_sim_fluid(sim);
    double t = 100.5 * STEP; /* the first step felt half of it */
    ck_assert_double_eq_tol(f.vx[0], 1.5 * t, 1e-12);
    ck_assert_double_eq_tol(f.vy[0], -3 * t, 1e-12);
    ck_assert_int_eq(sph2d_sim_set_gravity(sim, (sph2d_vec2){0, 0}), SPH2D_OK);
    test_steps(sim, 1);
    f = sph2d_sim_fluid(sim);
    ck_assert(f.ax[0] == 0 && f.ay[0] == 0);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(new_gravity_feeds_energy)
{
    /* Free flight: kinetic and potential energy are those of the start and what was fed, whenever gravity changes. */
    static const sph2d_vec2 gravity[4] = {{2, -10}, {0, 0}, {-5, 3}, {1, 1}};
    sph2d_sim *sim = with_interactions(NULL, 0);
    double worst = 0, most = 0;
    for (int k = 0; k < 4; ++k) {
        ck_assert_int_eq(sph2d_sim_set_gravity(sim, gravity[k]), SPH2D_OK);
        sph2d_summary s = sph2d_sim_summary(sim);
        double mass = 1000 * DX * DX, potential = 0;
        sph2d_view f = sph2d_sim_fluid(sim);
        for (size_t i = 0; i < f.count; ++i)
            potential -= mass * (gravity[k].x * (f.x[i] + 2) + gravity[k].y * (f.y[i] + 2));
        worst = fmax(worst, fabs(s.potential - potential));
        test_steps(sim, 1); /* which kicks half with the old gravity, half with the new */
        s = sph2d_sim_summary(sim);
        double before = s.kinetic + s.potential - s.energy_start - s.energy_fed;
        test_steps(sim, 50);
        s = sph2d_sim_summary(sim);
        worst = fmax(worst, fabs(s.kinetic + s.potential - s.energy_start - s.energy_fed - before));
        most = fmax(most, fabs(s.energy_fed));
    }
    ck_assert_double_gt(most, 1);
    ck_assert_double_le(worst, 1e-11 * most);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(potential_energy_follows_gravity)
{
    /* 0 at the domain's corner min: m (-g . (x - min)). */
    sph2d_sim *sim = with_interactions(NULL, 0);
    sph2d_sim_set_gravity(sim, (sph2d_vec2){2, -10});
    test_steps(sim, 1);
    sph2d_view f = sph2d_sim_fluid(sim);
    double potential = 0, kinetic = 0, mass = 1000 * DX * DX;
    for (size_t i = 0; i < f.count; ++i) {
        potential += mass * (10 * (f.y[i] + 2) - 2 * (f.x[i] + 2));
        kinetic += mass * (f.vx[i] * f.vx[i] + f.vy[i] * f.vy[i]) / 2;
    }
    sph2d_summary sum = sph2d_sim_summary(sim);
    ck_assert_double_eq_tol(sum.potential / potential, 1, 1e-12);
    ck_assert_double_eq_tol(sum.kinetic / kinetic, 1, 1e-12);
    ck_assert_double_eq_tol(sum.momentum[1] / (-10 * STEP / 2 * PARTICLES * mass), 1, 1e-12);
    sph2d_sim_destroy(sim);
}
END_TEST

Suite *suite_steering(void)
{
    Suite *suite = suite_create("steering");
    TCase *tests = tcase_create("steering");
    tcase_add_loop_test(tests, a_single_point_pulls_for_ever, 0, 2);
    tcase_add_test(tests, a_path_leads_the_point_through_time);
    tcase_add_test(tests, several_points_and_the_pointer_add_up);
    tcase_add_test(tests, a_particle_at_the_point_stays_finite);
    tcase_add_test(tests, wrong_steering_is_refused_and_changes_nothing);
    tcase_add_test(tests, gravity_changes_from_the_next_step_on);
    tcase_add_test(tests, new_gravity_feeds_energy);
    tcase_add_test(tests, potential_energy_follows_gravity);
    suite_add_tcase(suite, tests);
    return suite;
}
