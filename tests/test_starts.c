/* SPDX-License-Identifier: MIT */
/** @file test_starts.c
 *  Liquid that starts with the values of a table or with the liquid of a snapshot: which fields are exact, of which order
 *  others are, how much liquid there is and where, and what is refused. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common.h"
#include "scene/cubic.h"

static sph2d_report report;
static sph2d_scene scene;
static sph2d_block block;

/** A block over (0.1, 0.1) to (0.9, 0.5), with gravity none and c0 = 10 m/s. */
static void set_up(void)
{
    sph2d_report_clear(&report);
    scene = test_scene(0.02, 0, 0, 1, 1);
    scene.method = sph2d_scene_default().method;
    scene.method.stiffness = 100;
    block = test_block(0.1, 0.1, 0.9, 0.5);
    scene.blocks = &block;
    scene.block_count = 1;
}

/** Expects that no simulation can be made, with a message that contains these words at a key. */
static void expect_refused(sph2d_code code, const char *key, const char *words)
{
    sph2d_sim *sim = NULL;
    sph2d_report_clear(&report);
    ck_assert_int_eq(sph2d_sim_create(&scene, NULL, &sim, &report), SPH2D_SCENE);
    ck_assert_ptr_null(sim);
    ck_assert_msg(test_report_has(&report, code, key) && strstr(test_report_text(&report), words), "%s",
                  test_report_text(&report));
}

/* ---- cubics ------------------------------------------------------------------------------------------------------ */

static double power(double x, int n)
{
    return n > 0 ? x * power(x, n - 1) : 1;
}

static double interpolate(const double *nodes, size_t count, double at, double (*f)(double))
{
    sph2d__cubic c = sph2d__cubic_at(nodes, 1, count, at);
    double sum = 0;
    ck_assert_uint_le(c.first + c.count, count);
    for (size_t k = 0; k < c.count; ++k)
        sum += c.weight[k] * f(nodes[c.first + k]);
    return sum;
}

static double linear(double x)
{
    return 2 - 3 * x;
}

static double quadratic(double x)
{
    return 1 + x - 4 * x * x;
}

static double cubic(double x)
{
    return 1 - 2 * x + 3 * x * x - 4 * power(x, 3);
}

static double wave(double x)
{
    return sin(5 * x + 0.3);
}

START_TEST(cubics_between_uneven_nodes_are_exact)
{
    static const double nodes[] = {-0.3, 0.05, 0.1, 0.4, 0.55, 0.95, 1.3, 1.35};
    for (size_t count = 1; count <= 8; ++count)
        for (double at = nodes[0]; at <= nodes[count - 1]; at += 0.01) {
            double (*exact)(double) = count < 3 ? linear : count < 4 ? quadratic : cubic;
            ck_assert_double_eq_tol(interpolate(nodes, count, at, exact), exact(at), 1e-13);
        }
    ck_assert_double_eq(interpolate(nodes, 8, -9, cubic), cubic(-0.3)); /* the ends go on */
    ck_assert_double_eq(interpolate(nodes, 8, 9, cubic), cubic(1.35));
}
END_TEST

/** Largest error of the wave with so many uneven intervals. */
static double error_of_wave(size_t intervals)
{
    double nodes[200], largest = 0;
    for (size_t k = 0; k <= intervals; ++k) {
        double z = (double)k / (double)intervals;
        nodes[k] = z + 0.1 * sin(3 * z);
    }
    for (double at = nodes[0]; at < nodes[intervals]; at += 1e-3)
        largest = fmax(largest, fabs(interpolate(nodes, intervals + 1, at, wave) - wave(at)));
    return largest;
}

START_TEST(other_functions_have_errors_of_the_fourth_order)
{
    double order = log2(error_of_wave(40) / error_of_wave(80));
    ck_assert_msg(order > 3.7 && order < 4.8, "order %g", order);
}
END_TEST

START_TEST(slopes_are_continuous)
{
    static const double nodes[] = {0, 0.1, 0.25, 0.3, 0.5, 0.8, 1};
    for (size_t k = 1; k < 6; ++k) {
        double e = 1e-6, here = interpolate(nodes, 7, nodes[k], wave);
        double left = (here - interpolate(nodes, 7, nodes[k] - e, wave)) / e;
        double right = (interpolate(nodes, 7, nodes[k] + e, wave) - here) / e;
        ck_assert_double_eq_tol(left, right, 1e-3);
    }
}
END_TEST

/* ---- tables ------------------------------------------------------------------------------------------------------ */

enum { NX = 6, NY = 5 };
static double grid_x[NX] = {0, 0.1, 0.3, 0.4, 0.7, 1}, grid_y[NY] = {0, 0.2, 0.25, 0.5, 0.6};
static double grid_vx[NX * NY], grid_vy[NX * NY], grid_pressure[NX * NY];

static double vx_at(double x, double y)
{
    return 1 + x * y * y - power(x, 3) + 2 * power(y, 3);
}

static double vy_at(double x, double y)
{
    return power(x, 3) * power(y, 3) - y;
}

static double pressure_at(double x, double y)
{
    return 100 * (1 + x - y * y);
}

static void fill_grid(void)
{
    for (size_t k = 0; k < NX * NY; ++k) {
        double x = grid_x[k % NX], y = grid_y[k / NX];
        grid_vx[k] = vx_at(x, y);
        grid_vy[k] = vy_at(x, y);
        grid_pressure[k] = pressure_at(x, y);
    }
    block.start.table = (sph2d_grid){
        .x = grid_x, .y = grid_y, .nx = NX, .ny = NY, .vx = grid_vx, .vy = grid_vy, .pressure = grid_pressure};
}

START_TEST(a_block_starts_with_the_cubics_of_its_table)
{
    fill_grid();
    block.velocity = (sph2d_vec2){0.5, 0}; /* to which the table's is added */
    sph2d_sim *sim = test_create(&scene, NULL);
    ck_assert_ptr_ne(sph2d_sim_scene(sim)->blocks[0].start.table.vx, grid_vx); /* a copy */
    sph2d_view f = sph2d_sim_fluid(sim);
    ck_assert_uint_eq(f.count, 40 * 20);
    for (size_t i = 0; i < f.count; ++i) {
        ck_assert_double_eq_tol(f.vx[i], 0.5 + vx_at(f.x[i], f.y[i]), 1e-13);
        ck_assert_double_eq_tol(f.vy[i], vy_at(f.x[i], f.y[i]), 1e-13);
        ck_assert_double_eq_tol(f.pressure[i], pressure_at(f.x[i], f.y[i]), 1e-8); /* rounding of c0^2 rho */
    }
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(without_a_pressure_liquid_keeps_its_own)
{
    fill_grid();
    block.start.table.pressure = NULL;
    block.start.table.vy = NULL;
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d_view f = sph2d_sim_fluid(sim);
    for (size_t i = 0; i < f.count; ++i) {
        ck_assert_double_eq_tol(f.vx[i], vx_at(f.x[i], f.y[i]), 1e-13);
        ck_assert_double_eq(f.vy[i], 0);
        ck_assert_double_eq(f.pressure[i], 0);
    }
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(liquid_outside_the_table_is_refused)
{
    grid_y[NY - 1] = 0.501; /* just enough */
    fill_grid();
    sph2d_sim_destroy(test_create(&scene, NULL));
    block.shape.box.max.y = 0.56;
    expect_refused(SPH2D_CODE_OUTSIDE, "blocks[0].start.table",
                   "liquid at (0.11, 0.51) lies outside the table, which reaches from (0, 0) to (1, 0.501)");
    grid_y[NY - 1] = 0.6;
}
END_TEST

START_TEST(the_sound_speed_is_for_the_fastest_of_the_table)
{
    fill_grid();
    scene.method.stiffness = 0;
    block.start.table.pressure = NULL;
    sph2d_sim *sim = test_create(&scene, NULL);
    double c0 = sph2d_sim_plan(sim)->sound_speed, fastest = 0;
    for (size_t k = 0; k < NX * NY; ++k)
        fastest = fmax(fastest, hypot(grid_vx[k], grid_vy[k]));
    ck_assert_double_eq_tol(c0, 10 * fastest, 1e-9 * c0); /* c0^2 = 2 (U^2/2)/0.01 */
    sph2d_sim_destroy(sim);
    block.start.top_speed = 3;
    sim = test_create(&scene, NULL);
    ck_assert_double_eq_tol(sph2d_sim_plan(sim)->sound_speed, 30, 1e-9);
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- values of snapshots ----------------------------------------------------------------------------------------- */

enum { MOST = 20000 };
static sph2d_cloud_point points[MOST];

/** Particles of a snapshot where a lattice of a spacing has `inside`, displaced at random by a part of it. */
static sph2d_cloud cloud_of(double spacing, double disorder, bool (*inside)(double x, double y))
{
    sph2d_cloud cloud = {.items = points, .spacing = spacing};
    uint64_t state = 1;
    for (double y = spacing / 2; y < 1; y += spacing)
        for (double x = spacing / 2; x < 1; x += spacing) {
            sph2d_cloud_point *p = &points[cloud.count];
            if (!inside(x, y))
                continue;
            ck_assert_uint_lt(cloud.count, MOST);
            *p = (sph2d_cloud_point){.x = x + disorder * spacing * test_random(&state, -1, 1),
                                     .y = y + disorder * spacing * test_random(&state, -1, 1)};
            p->vx = 1 + 2 * p->x - 3 * p->y;
            p->vy = -2 + p->x * p->x + p->x * p->y;
            p->pressure = 50 - 20 * p->x + 30 * p->y;
            ++cloud.count;
        }
    return cloud;
}

static bool in_pool(double x, double y)
{
    (void)x;
    return y < 0.6;
}

static bool in_disc(double x, double y)
{
    return hypot(x - 0.5, y - 0.5) < 0.3;
}

static bool in_row(double x, double y)
{
    (void)x;
    return fabs(y - 0.31) < 1e-9;
}

START_TEST(quadratic_fields_of_disordered_particles_are_exact)
{
    static const double spacings[] = {0.04, 0.02, 0.012};
    block.start.snapshot = cloud_of(spacings[_i], 0.3, in_pool);
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d_view f = sph2d_sim_fluid(sim);
    for (size_t i = 0; i < f.count; ++i) {
        ck_assert_double_eq_tol(f.vx[i], 1 + 2 * f.x[i] - 3 * f.y[i], 1e-12);
        ck_assert_double_eq_tol(f.vy[i], -2 + f.x[i] * f.x[i] + f.x[i] * f.y[i], 1e-12);
        ck_assert_double_eq_tol(f.pressure[i], 50 - 20 * f.x[i] + 30 * f.y[i], 1e-8);
    }
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(beside_a_single_row_values_are_means_and_beyond_its_reach_there_are_none)
{
    block.start.snapshot = cloud_of(0.02, 0, in_row);
    block.velocity = (sph2d_vec2){7, 0};
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d_view f = sph2d_sim_fluid(sim);
    size_t beside = 0, beyond = 0;
    for (size_t i = 0; i < f.count; ++i) {
        double distance = fabs(f.y[i] - 0.31);
        if (distance > 0.0501) {
            ck_assert_double_eq(f.vx[i], 7);
            ck_assert_double_eq(f.pressure[i], 0);
            ++beyond;
        } else if (distance < 0.0499 && f.x[i] > 0.12 && f.x[i] < 0.88) { /* means are symmetric but near the ends */
            ck_assert_double_eq_tol(f.vx[i], 7 + 1 + 2 * f.x[i] - 3 * 0.31, 1e-9);
            ++beside;
        }
    }
    ck_assert_uint_eq(beside, 5 * 38);
    ck_assert_uint_gt(beyond, 10 * 40);
    sph2d_sim_destroy(sim);
}
END_TEST

static bool everywhere(double x, double y)
{
    (void)x;
    (void)y;
    return true;
}

START_TEST(particles_beyond_a_periodic_side_count)
{
    scene.boundary =
        (sph2d_boundary){SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC};
    block.shape.box = scene.domain;
    block.start.snapshot = cloud_of(0.04, 0.2, everywhere);
    double largest = 0, k = 2 * TEST_PI;
    for (size_t i = 0; i < block.start.snapshot.count; ++i) {
        points[i].vx = sin(k * points[i].x + 1) * cos(k * points[i].y + 1);
        points[i].x += 3; /* as many widths away as one likes */
    }
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d_view f = sph2d_sim_fluid(sim);
    for (size_t i = 0; i < f.count; ++i)
        largest = fmax(largest, fabs(f.vx[i] - sin(k * f.x[i] + 1) * cos(k * f.y[i] + 1)));
    ck_assert_msg(largest < 0.02, "error %g", largest);
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- liquid of snapshots ----------------------------------------------------------------------------------------- */

static void start_from(double spacing, bool (*inside)(double x, double y))
{
    scene.block_count = 0;
    scene.start.snapshot = cloud_of(spacing, 0.1, inside);
}

START_TEST(the_liquid_of_a_snapshot_keeps_its_volume_and_place)
{
    static const double spacings[] = {0.04, 0.025, 0.02, 0.0125, 0.01};
    double spacing = spacings[_i], dx = scene.spacing;
    bool round = _i % 2 == 0;
    start_from(spacing, round ? in_disc : in_pool);
    double volume = (double)scene.start.snapshot.count * spacing * spacing, outside = 0;
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d_view f = sph2d_sim_fluid(sim);
    ck_assert_double_eq_tol((double)f.count * dx * dx, volume, 0.5001 * dx * dx);
    ck_assert_double_eq_tol(sph2d_sim_plan(sim)->area_asked, volume, 1e-12);
    for (size_t i = 0; i < f.count; ++i) {
        double beyond = round ? hypot(f.x[i] - 0.5, f.y[i] - 0.5) - 0.3 : f.y[i] - 0.6;
        outside = fmax(outside, beyond);
        ck_assert_double_eq_tol(f.vx[i], 1 + 2 * f.x[i] - 3 * f.y[i], 1e-12);
    }
    ck_assert_msg(outside < spacing / 2, "%g spacings outside", outside / spacing);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(a_particle_that_is_alone_stays)
{
    start_from(0.04, in_disc);
    scene.spacing = 0.02;
    points[scene.start.snapshot.count] = (sph2d_cloud_point){.x = 0.1, .y = 0.1, .vx = 3};
    ++scene.start.snapshot.count;
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d_view f = sph2d_sim_fluid(sim);
    size_t alone = 0;
    for (size_t i = 0; i < f.count; ++i)
        if (f.x[i] < 0.15 && f.y[i] < 0.15) {
            ck_assert_double_eq_tol(f.vx[i], 3, 1e-12);
            ++alone;
        }
    ck_assert_uint_ge(alone, 2); /* of the four that have its mass */
    ck_assert_uint_le(alone, 5);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(blocks_and_obstacles_leave_no_room_for_a_snapshot)
{
    start_from(0.04, in_pool);
    scene.block_count = 1;
    block = test_block(0.1, 0.1, 0.5, 0.5);
    sph2d_obstacle post = sph2d_obstacle_default();
    post.shape.kind = SPH2D_SHAPE_BOX;
    post.shape.box = (sph2d_box){{0.7, 0}, {0.8, 0.8}};
    scene.obstacles = &post;
    scene.obstacle_count = 1;
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d_view f = sph2d_sim_fluid(sim);
    size_t in_block = 0;
    double area = (double)f.count * scene.spacing * scene.spacing;
    for (size_t i = 0; i < f.count; ++i) {
        in_block += f.x[i] > 0.1 && f.x[i] < 0.5 && f.y[i] > 0.1 && f.y[i] < 0.5;
        ck_assert(!(f.x[i] > 0.7 && f.x[i] < 0.8));
    }
    ck_assert_uint_eq(in_block, 20 * 20);
    ck_assert_double_eq_tol(area, 0.6 - 0.06, 0.02); /* rows of the snapshot end where they end: at 0.6, 0.8 */
    sph2d_sim_destroy(sim);
}
END_TEST

static bool in_vee(double x, double y)
{
    return y < 0.5 && y > 0.12 + fabs(x - 0.5);
}

/** Beside walls that lie across the lattice the liquid is packed: none is behind them, and none is lost. */
START_TEST(beside_slopes_the_liquid_of_a_snapshot_is_packed)
{
    static const sph2d_vec2 corners[3] = {{0, 0.6}, {0.5, 0.1}, {1, 0.6}};
    sph2d_obstacle vee = sph2d_obstacle_default(), post = sph2d_obstacle_default();
    sph2d_obstacle both[2];
    vee.shape.kind = SPH2D_SHAPE_POLYLINE;
    vee.shape.points = (sph2d_points){corners, 3};
    vee.liquid = SPH2D_LIQUID_LEFT;
    post.shape.kind = SPH2D_SHAPE_CIRCLE;
    post.shape.circle = (sph2d_circle){{0.5, 0.9}, 0.05};
    both[0] = vee;
    both[1] = post;
    start_from(0.025, in_vee);
    double volume = (double)scene.start.snapshot.count * 0.025 * 0.025, y = 0, fine_y = 0;
    for (size_t k = 0; k < scene.start.snapshot.count; ++k)
        y += points[k].y / (double)scene.start.snapshot.count;
    scene.obstacles = both;
    scene.obstacle_count = 2;
    scene.spacing = 0.0125;
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d_view f = sph2d_sim_fluid(sim), w = sph2d_sim_walls(sim);
    for (size_t i = 0; i < f.count; ++i) {
        fine_y += f.y[i] / (double)f.count;
        ck_assert_msg(f.y[i] > 0.1 + fabs(f.x[i] - 0.5), "(%g, %g)", f.x[i], f.y[i]);
        for (size_t k = 0; k < w.count; ++k)
            ck_assert_double_gt(hypot(f.x[i] - w.x[k], f.y[i] - w.y[k]), 0.6 * scene.spacing);
    }
    ck_assert_double_eq_tol((double)f.count * scene.spacing * scene.spacing, volume, 0.01 * volume);
    ck_assert_double_eq_tol(fine_y, y, 0.1 * 0.025);
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- single particles -------------------------------------------------------------------------------------------- */

START_TEST(particles_without_a_density_start_at_the_pressure_of_the_scene)
{
    static const sph2d_particle given[] = {
        {.x = 0.1, .y = 0.2}, {.x = 0.12, .y = 0.2, .vx = 1}, {.x = 0.14, .y = 0.2, .density = 1007}};
    scene.block_count = 0;
    scene.particles = (sph2d_particles){.items = given, .count = 3};
    scene.gravity = (sph2d_vec2){0, -10};
    sph2d_sim *sim = test_create(&scene, NULL);
    ck_assert_double_eq(sph2d_sim_fluid(sim).pressure[test_find(sph2d_sim_fluid(sim), 0)], 0);
    sph2d_sim_destroy(sim);
    scene.start.flow = (sph2d_flow){.kind = SPH2D_FLOW_STILL, .center = {0, 0.5}};
    sim = test_create(&scene, NULL);
    sph2d_view f = sph2d_sim_fluid(sim);
    size_t a = test_find(f, 0), b = test_find(f, 1), c = test_find(f, 2);
    ck_assert_double_eq_tol(f.pressure[a], 1000 * 10 * 0.3, 1e-8);
    ck_assert_double_eq_tol(f.pressure[b], 1000 * 10 * 0.3, 1e-8);
    ck_assert_double_eq(f.density[c], 1007);
    ck_assert_double_eq(f.y[a], 0.2); /* in its place */
    ck_assert_double_eq(f.vx[b], 1);
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- refused ----------------------------------------------------------------------------------------------------- */

/** Water 200 spacings deep sinks half a spacing by its weight, but not into a bar: there is as much of it as where it
 *  starts without a pressure. By `body` the bar is one. */
START_TEST(deep_still_water_surrounds_a_solid)
{
    size_t particles[2];
    sph2d_obstacle bar = sph2d_obstacle_default();
    sph2d_body body = sph2d_body_default();
    set_up();
    scene.spacing = 0.02;
    scene.domain.max = (sph2d_vec2){0.6, 4.2};
    scene.gravity.y = -9.81;
    scene.method = sph2d_scene_default().method;
    bar.shape.kind = SPH2D_SHAPE_CIRCLE;
    bar.shape.circle = (sph2d_circle){{0.3, 3}, 0.14};
    body.shape = bar.shape;
    body.density = 1000;
    scene.obstacles = &bar;
    scene.bodies = &body;
    scene.obstacle_count = _i == 0;
    scene.body_count = _i == 1;
    block = test_block(0, 0, 0.6, 4);
    for (int still = 0; still < 2; ++still) {
        block.start.flow.kind = still ? SPH2D_FLOW_STILL : SPH2D_FLOW_NONE;
        block.start.flow.center[1] = 4;
        sph2d_sim *sim = test_create(&scene, NULL);
        sph2d_view f = sph2d_sim_fluid(sim);
        particles[still] = f.count;
        for (size_t i = 0; still && i < f.count; ++i)
            ck_assert_double_eq_tol(f.pressure[i], 1000 * 9.81 * (4 - f.y[i]), 0.02 * 1000 * 9.81 * 4);
        test_steps(sim, 3);
        sph2d_sim_destroy(sim);
    }
    ck_assert_uint_eq(particles[0], particles[1]);
}
END_TEST

START_TEST(a_start_is_of_one_thing)
{
    fill_grid();
    block.start.flow = (sph2d_flow){.kind = SPH2D_FLOW_TAYLOR_GREEN, .speed = 1, .length = 1};
    expect_refused(SPH2D_CODE_CONFLICT, "blocks[0].start", "more than one thing");
    block.start = (sph2d_start){.flow = {.speed = 1}};
    expect_refused(SPH2D_CODE_MISSING_KEY, "blocks[0].start.flow", "belong to a known flow");
    block.start = (sph2d_start){.top_speed = 1};
    expect_refused(SPH2D_CODE_CONFLICT, "blocks[0].start.top_speed", "belongs to a table or a snapshot");
    block.start = (sph2d_start){.table = {.file = "wind.csv"}};
    ck_assert_int_eq(sph2d_scene_check(&scene, NULL), SPH2D_OK); /* to be resumed */
    expect_refused(SPH2D_CODE_MISSING_KEY, "blocks[0].start.table", "was not read");
    block.start = (sph2d_start){.snapshot = {.file = "old.h5"}};
    expect_refused(SPH2D_CODE_MISSING_KEY, "blocks[0].start.snapshot", "was not read");
    block.start = (sph2d_start){.flow = {0}};
    scene.start.flow.kind = SPH2D_FLOW_STILL;
    expect_refused(SPH2D_CODE_CONFLICT, "start", "that of `particles`, of which there are none");
    scene.start.flow.kind = SPH2D_FLOW_NONE;
    start_from(0.04, in_pool);
    scene.method.stiffness = 0;
    expect_refused(SPH2D_CODE_MISSING_KEY, "start.snapshot", "does not determine the sound speed");
}
END_TEST

START_TEST(broken_values_are_refused)
{
    fill_grid();
    block.start.table.nx = 1;
    expect_refused(SPH2D_CODE_OUT_OF_RANGE, "blocks[0].start.table", "two x and two y");
    fill_grid();
    block.start.table.y = NULL;
    expect_refused(SPH2D_CODE_CONFLICT, "blocks[0].start.table", "NULL list");
    fill_grid();
    block.start.table.x = grid_vx; /* does not increase */
    expect_refused(SPH2D_CODE_OUT_OF_RANGE, "blocks[0].start.table", "do not increase");
    fill_grid();
    grid_vy[7] = NAN;
    expect_refused(SPH2D_CODE_OUT_OF_RANGE, "blocks[0].start.table", "not finite");
    block.start.table = (sph2d_grid){.file = NULL};
    start_from(0.04, in_pool);
    points[3].pressure = INFINITY;
    expect_refused(SPH2D_CODE_OUT_OF_RANGE, "start.snapshot", "not finite");
    points[3].pressure = 0;
    scene.start.snapshot.spacing = 0;
    expect_refused(SPH2D_CODE_OUT_OF_RANGE, "start.snapshot", "spacing that is not above 0");
    scene.start.snapshot.items = NULL;
    expect_refused(SPH2D_CODE_CONFLICT, "start.snapshot", "NULL list");
}
END_TEST

Suite *suite_starts(void)
{
    Suite *suite = suite_create("starts");
    TCase *starts = tcase_create("starts");
    tcase_add_checked_fixture(starts, set_up, NULL);
    tcase_add_test(starts, cubics_between_uneven_nodes_are_exact);
    tcase_add_test(starts, other_functions_have_errors_of_the_fourth_order);
    tcase_add_test(starts, slopes_are_continuous);
    tcase_add_test(starts, a_block_starts_with_the_cubics_of_its_table);
    tcase_add_test(starts, without_a_pressure_liquid_keeps_its_own);
    tcase_add_test(starts, liquid_outside_the_table_is_refused);
    tcase_add_test(starts, the_sound_speed_is_for_the_fastest_of_the_table);
    tcase_add_loop_test(starts, quadratic_fields_of_disordered_particles_are_exact, 0, 3);
    tcase_add_test(starts, beside_a_single_row_values_are_means_and_beyond_its_reach_there_are_none);
    tcase_add_test(starts, particles_beyond_a_periodic_side_count);
    tcase_add_loop_test(starts, the_liquid_of_a_snapshot_keeps_its_volume_and_place, 0, 5);
    tcase_add_test(starts, a_particle_that_is_alone_stays);
    tcase_add_test(starts, particles_without_a_density_start_at_the_pressure_of_the_scene);
    tcase_add_test(starts, a_start_is_of_one_thing);
    tcase_add_test(starts, broken_values_are_refused);
    suite_add_tcase(suite, starts);
    TCase *slow = test_long(suite);
    tcase_add_checked_fixture(slow, set_up, NULL);
    tcase_add_test(slow, blocks_and_obstacles_leave_no_room_for_a_snapshot);
    tcase_add_test(slow, beside_slopes_the_liquid_of_a_snapshot_is_packed);
    tcase_add_loop_test(slow, deep_still_water_surrounds_a_solid, 0, 2);
    return suite;
}
