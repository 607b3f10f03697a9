/* SPDX-License-Identifier: MIT */
/** @file test_walls.c
 *  Spring walls, and one particle dropped on each form of wall.
 *
 *  A spring pushes with a = max(k d - 2 zeta sqrt(k) v_out, 0) where d = dx/2 - distance > 0, k = (c0/dx)^2, so with
 *  w = sqrt(k) = c0/dx a particle of normal speed v goes v/w deep, feels w v at most, and leaves with
 *
 *      v exp(-zeta (pi - 2 asin zeta)/sqrt(1 - zeta^2)),
 *
 *  the solution of d" + 2 zeta w d' + w^2 d = 0 from d = 0 up to the moment at which the push would turn into a pull.
 */
#include <math.h>
#include <string.h>

#include "common.h"
#include "forces/springs.h"

static const double DX = 0.01, W = 1000; /* spacing; sound speed of test_scene(), 10 m/s, over spacing */

START_TEST(the_push_is_as_documented)
{
    sph2d__springs w = {.range = 0.5, .stiffness = 30, .damping = 2};
    ck_assert_double_eq_tol(sph2d__spring_force(&w, 0.4, 0), 3, 1e-14);
    ck_assert_double_eq_tol(sph2d__spring_force(&w, 0.1, 0), 12, 1e-14);
    ck_assert_double_eq_tol(sph2d__spring_force(&w, -0.5, 0), 30, 1e-14); /* beyond the wall it goes on growing */
    ck_assert_double_eq_tol(sph2d__spring_force(&w, 0.4, -2), 7, 1e-14);  /* coming in: damping adds */
    ck_assert_double_eq_tol(sph2d__spring_force(&w, 0.4, 1), 1, 1e-14);   /* going out: it takes away */
    ck_assert(sph2d__spring_force(&w, 0.4, 2) == 0);                      /* but never pulls */
    ck_assert(sph2d__spring_force(&w, 0.5, -9) == 0);
    ck_assert(sph2d__spring_force(&w, 0.7, -9) == 0);
}
END_TEST

/** A particle in a tank of 40 by 40 spacings, closed but for one open side where `open` is set. */
static sph2d_sim *one_particle(sph2d_vec2 at, sph2d_vec2 v, double damping, double step, bool open)
{
    sph2d_scene scene = test_scene(DX, 0, 0, 40 * DX, 40 * DX);
    if (open)
        scene.boundary = (sph2d_boundary){SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN};
    scene.wall_damping = damping;
    scene.method.time_step = step;
    sph2d_block block = test_particle(DX / 8, at.x, at.y, v.x, v.y); /* small enough to lie close to a side */
    block.spacing = DX / 8;
    scene.blocks = &block;
    scene.block_count = 1;
    sph2d_sim *sim = test_create(&scene, NULL);
    ck_assert_uint_eq(sph2d_sim_fluid(sim).count, 1);
    return sim;
}

START_TEST(each_side_pushes_inwards)
{
    /* Distances in spacings from left or right, and from bottom or top; 20 is the middle. */
    static const double places[][2] = {{0.3, 20}, {39.7, 20}, {20, 0.2}, {20, 39.8}, {0.45, 39.55}, {0.6, 39.4}};
    const double *p = places[_i];
    sph2d_sim *sim = one_particle((sph2d_vec2){p[0] * DX, p[1] * DX}, (sph2d_vec2){0, 0}, 0.1, 1e-5, false);
    double expected[2];
    for (int k = 0; k < 2; ++k)
        expected[k] = W * W * DX * (fmax(0.5 - p[k], 0) - fmax(0.5 - (40 - p[k]), 0));
    sph2d_view f = sph2d_sim_fluid(sim);
    ck_assert_double_eq_tol(f.ax[0], expected[0], 1e-8);
    ck_assert_double_eq_tol(f.ay[0], expected[1], 1e-8);
    sph2d_sim_destroy(sim);
    sim = one_particle((sph2d_vec2){p[0] * DX, p[1] * DX}, (sph2d_vec2){0, 0}, 0.1, 1e-5, true);
    f = sph2d_sim_fluid(sim);
    ck_assert(f.ax[0] == 0 && f.ay[0] == 0); /* an open side has no spring */
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(only_the_normal_velocity_is_damped)
{
    /* At 0.3 spacings from each side, with 0.5 m/s into it and 2 m/s along it. */
    static const struct {
        double x, y;   /**< place, in spacings */
        double nx, ny; /**< the side's normal, inwards */
    } sides[] = {{0.3, 20, 1, 0}, {39.7, 20, -1, 0}, {20, 0.3, 0, 1}, {20, 39.7, 0, -1}};
    for (size_t k = 0; k < 4; ++k) {
        double nx = sides[k].nx, ny = sides[k].ny, push = W * W * 0.2 * DX + 2 * 0.25 * W * 0.5;
        sph2d_vec2 v = {-0.5 * nx + 2 * ny, -0.5 * ny + 2 * nx};
        sph2d_sim *sim = one_particle((sph2d_vec2){sides[k].x * DX, sides[k].y * DX}, v, 0.25, 1e-5, false);
        sph2d_view f = sph2d_sim_fluid(sim);
        ck_assert_double_eq_tol(f.ax[0], push * nx, 1e-8);
        ck_assert_double_eq_tol(f.ay[0], push * ny, 1e-8);
        sph2d_sim_destroy(sim);
    }
}
END_TEST

/** What a throw at a wall leaves. */
typedef struct bounce {
    double depth, max_pressure; /**< largest penetration of the spring's range, largest acceleration */
    sph2d_vec2 v;               /**< afterwards */
} bounce;

/** Throws a particle down at the bottom and follows it until it is out of the spring again. */
static bounce throw_down(sph2d_vec2 v, double damping, double step)
{
    sph2d_sim *sim = one_particle((sph2d_vec2){0.2, 0.6 * DX}, v, damping, step, false);
    bounce b = {0};
    sph2d_view f = sph2d_sim_fluid(sim);
    for (int n = 0; n < 100000 && !(f.y[0] > 0.55 * DX && f.vy[0] > 0); ++n) {
        test_steps(sim, 1);
        f = sph2d_sim_fluid(sim);
        b.depth = fmax(b.depth, 0.5 * DX - f.y[0]);
        b.max_pressure = fmax(b.max_pressure, hypot(f.ax[0], f.ay[0]));
    }
    b.v = (sph2d_vec2){f.vx[0], f.vy[0]};
    ck_assert_uint_eq(sph2d_sim_summary(sim).backstop_hits, 0);
    sph2d_sim_destroy(sim);
    return b;
}

START_TEST(a_faster_particle_goes_deeper_and_bounces_harder)
{
    for (double v = 0.25; v <= 2; v *= 2) { /* not so deep that the side makes a single particle dense */
        bounce b = throw_down((sph2d_vec2){0, -v}, 0, 5e-6);
        ck_assert_double_eq_tol(b.depth / (v / W), 1, 1e-4);
        ck_assert_double_eq_tol(b.max_pressure / (v * W), 1, 1e-4);
        ck_assert_double_eq_tol(b.v.y / v, 1, 1e-4);
    }
}
END_TEST

START_TEST(the_angle_out_is_the_angle_in)
{
    for (int degrees = 15; degrees <= 75; degrees += 15) {
        double angle = degrees * TEST_PI / 180;
        bounce b = throw_down((sph2d_vec2){2 * cos(angle), -2 * sin(angle)}, 0, 5e-6);
        ck_assert_double_eq_tol(b.v.x, 2 * cos(angle), 1e-13);
        ck_assert_double_eq_tol(atan2(b.v.y, b.v.x), angle, 1e-4);
    }
}
END_TEST

START_TEST(damping_takes_energy_as_the_oscillator_does)
{
    static const double dampings[] = {0.05, 0.1, 0.3, 0.6, 0.9};
    for (size_t k = 0; k < sizeof dampings / sizeof dampings[0]; ++k) {
        double zeta = dampings[k];
        double expected = exp(-zeta * (TEST_PI - 2 * asin(zeta)) / sqrt(1 - zeta * zeta));
        bounce b = throw_down((sph2d_vec2){1, -2}, zeta, 2e-6);
        ck_assert_double_eq_tol(b.v.y / 2, expected, 2e-3);
        ck_assert_double_eq_tol(b.v.x, 1, 1e-13);
    }
}
END_TEST

/* ---- two forms side by side -------------------------------------------------------------------------------------- */

/** The masses of all boundary particles, in their order. */
static const double *wall_masses(const sph2d_sim *sim)
{
    for (size_t i = 0; i < sph2d_field_count(SPH2D_GROUP_WALL); ++i) {
        sph2d_array field = sph2d_field(sim, SPH2D_GROUP_WALL, i);
        if (strcmp(field.name, "Masses") == 0)
            return field.data[0];
    }
    ck_abort_msg("no masses");
    return NULL;
}

START_TEST(reflecting_particles_neither_weigh_nor_press)
{
    /* A heavy line has the same masses with a reflecting one beside it, and liquid near both feels the heavy one alone.
     */
    sph2d_vec2 ends[2] = {{-0.1, 0}, {0.1, 0}}, beside[2] = {{-0.1, 0.4 * DX}, {0.1, 0.4 * DX}};
    sph2d_obstacle obstacles[2] = {sph2d_obstacle_default(), sph2d_obstacle_default()};
    obstacles[0].shape.kind = obstacles[1].shape.kind = SPH2D_SHAPE_LINE;
    obstacles[0].shape.points = (sph2d_points){ends, 2};
    obstacles[1].shape.points = (sph2d_points){beside, 2};
    obstacles[1].form = SPH2D_WALL_REFLECT;
    sph2d_scene scene = test_open_scene(DX, -1, -1, 1, 1);
    sph2d_block block = test_particle(DX, 0.003, -0.8 * DX, 0, 0);
    scene.method.support_ratio = 1.2; /* so that one particle is nearly at rest density by itself */
    scene.blocks = &block;
    scene.block_count = 1;
    scene.obstacles = obstacles;
    double push[2], weight[2] = {0, 0};
    for (size_t k = 0; k < 2; ++k) {
        scene.obstacle_count = k + 1;
        sph2d_sim *sim = test_create(&scene, NULL);
        push[k] = sph2d_sim_fluid(sim).ay[0];
        sph2d_view w = sph2d_sim_walls(sim);
        const double *masses = wall_masses(sim);
        for (size_t b = 0; b < w.count; ++b) {
            weight[k] += masses[b];
            ck_assert((w.y[b] > 0) == (masses[b] == 0));
            ck_assert(masses[b] > 0 || w.density[b] == scene.fluid.density);
        }
        sph2d_sim_destroy(sim);
    }
    ck_assert_double_lt(push[0], -10);
    ck_assert_double_eq_tol(push[1] / push[0], 1, 1e-12);
    ck_assert_double_eq_tol(weight[1] / weight[0], 1, 1e-12);
}
END_TEST

/* ---- drops ------------------------------------------------------------------------------------------------------- */

/** Forms of wall to fall on: three as sides of the domain, two as an obstacle. */
enum { SPRING_SIDE, HEAVY_SIDE, REFLECT_SIDE, HEAVY_LINE, REFLECT_LINE, FORMS };
enum { PLACES = 3, DROPS = FORMS * PLACES };

static const double LEVEL = 0.1; /**< of the line */

/** A particle at rest `height` above the wall: over a boundary particle, between two, or neither. */
static sph2d_sim *drop(int index, double height, double viscosity)
{
    static const double offsets[PLACES] = {0, 0.5, 0.23};
    int form = index / PLACES;
    double floor = form < HEAVY_LINE ? 0 : LEVEL;
    sph2d_scene scene = sph2d_scene_default();
    scene.method.name = SPH2D_METHOD_MULLER;
    scene.spacing = DX;
    scene.domain = (sph2d_box){{0, 0}, {40 * DX, 60 * DX}};
    scene.fluid.dynamic_viscosity = viscosity;
    scene.walls = form == HEAVY_SIDE ? SPH2D_WALL_HEAVY : form == REFLECT_SIDE ? SPH2D_WALL_REFLECT : SPH2D_WALL_SPRING;
    sph2d_vec2 line[2] = {{0, LEVEL}, {40 * DX, LEVEL}};
    sph2d_obstacle obstacle = sph2d_obstacle_default();
    obstacle.shape.kind = SPH2D_SHAPE_LINE;
    obstacle.shape.points = (sph2d_points){line, 2};
    obstacle.form = form == REFLECT_LINE ? SPH2D_WALL_REFLECT : SPH2D_WALL_HEAVY;
    scene.obstacles = &obstacle;
    scene.obstacle_count = form >= HEAVY_LINE;
    sph2d_block block = test_particle(DX, (20 + offsets[index % PLACES]) * DX, floor + height, 0, 0);
    scene.blocks = &block;
    scene.block_count = 1;
    return test_create(&scene, NULL);
}

/** Energy per mass above the wall, and height above it. */
static double energy(sph2d_sim *sim, int index, double *height)
{
    sph2d_view f = sph2d_sim_fluid(sim);
    ck_assert_uint_eq(f.count, 1);
    *height = f.y[0] - (index / PLACES < HEAVY_LINE ? 0 : LEVEL);
    return 9.81 * *height + (f.vx[0] * f.vx[0] + f.vy[0] * f.vy[0]) / 2;
}

/** Lets it bounce for `time`; tells the most energy over that of the start and the lowest height. */
static void let_bounce(sph2d_sim *sim, int index, double time, double *most, double *lowest)
{
    double start = energy(sim, index, lowest), height = 0;
    *most = 1;
    while (sph2d_sim_time(sim) < time) {
        test_steps(sim, 1);
        *most = fmax(*most, energy(sim, index, &height) / start);
        *lowest = fmin(*lowest, height);
    }
}

START_TEST(a_dropped_particle_never_rises_above_its_start)
{
    /* Water, adaptive steps, many bounces from heights that meet the wall at any phase of a step. */
    double worst = 1, worst_height = 0, low = 1;
    for (double height = 0.05; height < 0.25; height += 0.0371) {
        double most, lowest;
        sph2d_sim *sim = drop(_i, height, 1e-3);
        let_bounce(sim, _i, 2, &most, &lowest);
        worst_height = most > worst ? height : worst_height;
        worst = fmax(worst, most);
        low = fmin(low, lowest);
        sph2d_sim_destroy(sim);
    }
    ck_assert_double_gt(low, 0);
    ck_assert_msg(worst <= 1 + 1e-9, "from %g m it reaches %.6f of the energy of its start", worst_height, worst);
}
END_TEST

START_TEST(a_dropped_particle_comes_to_rest)
{
    /* Heavy walls take energy by viscosity alone. A reflecting wall acts once a step, so that a particle at rest on it
     * goes on falling for a step and being thrown back: speeds of a step's gravity remain. */
    int form = _i / PLACES;
    const double height = 0.1, speed = sqrt(9.81 * height);
    double most, lowest, end, rest = form == REFLECT_SIDE || form == REFLECT_LINE ? 0.05 * speed : 1e-6 * speed;
    sph2d_sim *sim = drop(_i, height, 5);
    let_bounce(sim, _i, 8, &most, &lowest);
    ck_assert_double_le(most, 1 + 1e-9);
    ck_assert_double_gt(lowest, 0);
    for (int n = 0; n < 200; ++n) {
        test_steps(sim, 1);
        ck_assert_double_le(sph2d_sim_summary(sim).speed_max, rest);
    }
    energy(sim, _i, &end);
    ck_assert_double_gt(end, 0);
    ck_assert_double_lt(end, 1.6 * DX); /* heavy ones keep it near one spacing, springs within half a one */
    if (form == SPRING_SIDE) {          /* where k d = g */
        double c0 = sph2d_sim_plan(sim)->sound_speed;
        ck_assert_double_eq_tol((0.5 * DX - end) * c0 * c0 / (DX * DX * 9.81), 1, 1e-6);
    }
    sph2d_sim_destroy(sim);
}
END_TEST

Suite *suite_walls(void)
{
    Suite *suite = suite_create("walls");
    TCase *forms = tcase_create("forms");
    tcase_add_test(forms, the_push_is_as_documented);
    tcase_add_loop_test(forms, each_side_pushes_inwards, 0, 6);
    tcase_add_test(forms, only_the_normal_velocity_is_damped);
    tcase_add_test(forms, a_faster_particle_goes_deeper_and_bounces_harder);
    tcase_add_test(forms, the_angle_out_is_the_angle_in);
    tcase_add_test(forms, damping_takes_energy_as_the_oscillator_does);
    tcase_add_test(forms, reflecting_particles_neither_weigh_nor_press);
    suite_add_tcase(suite, forms);
    TCase *drops = tcase_create("drops");
    tcase_add_loop_test(drops, a_dropped_particle_never_rises_above_its_start, 0, DROPS);
    tcase_add_loop_test(drops, a_dropped_particle_comes_to_rest, 0, DROPS);
    tcase_set_tags(drops, "long");
    suite_add_tcase(suite, drops);
    return suite;
}
