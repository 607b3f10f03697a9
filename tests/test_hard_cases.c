/* SPDX-License-Identifier: MIT */
/** @file test_hard_cases.c
 *  Methods `pcisph` and `constraint` where pressure solvers go wrong: liquid at rest for a long time, in corners, in
 *  films, in tall columns, drops, jets on thin walls, liquid that starts inside a wall, a source into a full box,
 * limits that cannot be kept, compliance and damping at their ends. U = sqrt(g H) with the depth H; times are in
 * sqrt(H/g). */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common.h"

static const sph2d_method both[] = {SPH2D_METHOD_PCISPH, SPH2D_METHOD_CONSTRAINT};
static const double DX = 0.02, G = 9.81;

enum { MOST = 2000 };

static sph2d_scene scene;
static sph2d_block blocks[3];
static sph2d_obstacle obstacle;
static sph2d_particle particles[MOST];
static sph2d_sim *sim;
static sph2d_report report;

static void finish(void)
{
    sph2d_sim_destroy(sim);
    sim = NULL;
}

/** A tank open at the top, with gravity, of water as thick as `viscosity` says, without liquid. */
static void tank(sph2d_method method, double dx, double width, double height, double viscosity)
{
    scene = test_scene(dx, 0, 0, width, height);
    scene.method = sph2d_scene_default().method;
    scene.method.name = method;
    scene.boundary.top = SPH2D_SIDE_OPEN;
    scene.gravity.y = -G;
    scene.fluid.dynamic_viscosity = viscosity;
    scene.blocks = blocks;
}

static void add_block(double x0, double y0, double x1, double y1)
{
    blocks[scene.block_count++] = test_block(x0, y0, x1, y1);
}

static void start(void)
{
    sim = test_create(&scene, NULL);
}

/** Height of the middle of all liquid. */
static double middle(void)
{
    sph2d_view f = sph2d_sim_fluid(sim);
    double sum = 0;
    for (size_t i = 0; i < f.count; ++i)
        sum += f.y[i];
    return sum / (double)f.count;
}

static double fastest(void)
{
    sph2d_view f = sph2d_sim_fluid(sim);
    double most = 0;
    for (size_t i = 0; i < f.count; ++i)
        most = fmax(most, hypot(f.vx[i], f.vy[i]));
    return most;
}

/** What a run of some time had. */
typedef struct span {
    double fastest; /**< largest speed of all steps */
    double middle;  /**< mean over the steps of middle() */
} span;

static span run_until(double time)
{
    span s = {0};
    int steps = 0;
    for (; sph2d_sim_time(sim) < time; ++steps) {
        test_steps(sim, 1);
        s.fastest = fmax(s.fastest, fastest());
        s.middle += middle();
    }
    s.middle /= steps > 0 ? steps : 1;
    return s;
}

static bool all_finite(void)
{
    sph2d_view f = sph2d_sim_fluid(sim);
    bool finite = true;
    for (size_t i = 0; i < f.count; ++i)
        finite = finite && isfinite(f.x[i] + f.y[i] + f.vx[i] + f.vy[i] + f.density[i] + f.pressure[i]);
    return finite;
}

/* ---- rest -------------------------------------------------------------------------------------------------------- */

/** Viscosity with U H/nu = 100, for a settled state within some 20 sqrt(H/g). */
static double settling(double depth)
{
    return 1000 * sqrt(G * depth) * depth / 100;
}

START_TEST(a_tank_comes_to_rest_and_keeps_its_level)
{
    const double H = 0.3, U = sqrt(G * H), T = sqrt(H / G);
    tank(both[_i], DX, H, 0.45, settling(H));
    if (both[_i] == SPH2D_METHOD_CONSTRAINT)
        scene.method.tolerance = 1e-5;
    add_block(0, 0, H, H);
    start();
    run_until(20 * T);
    span early = run_until(30 * T), late = run_until(80 * T);
    span last = run_until(90 * T);
    ck_assert_double_le(fmax(early.fastest, late.fastest), 0.02 * U);
    ck_assert_double_le(last.fastest, 0.006 * U);
    ck_assert_double_le(2 * fabs(last.middle - H / 2), 0.5 * DX);
    ck_assert_double_le(2 * fabs(last.middle - early.middle) / 6, 1e-4 * H); /* for 10 sqrt(H/g) of 60 */
    sph2d_summary s = sph2d_sim_summary(sim);
    ck_assert_uint_eq(s.particles, 15 * 15);
    ck_assert_uint_eq(s.unconverged, 0);
    ck_assert_double_le(s.compression_p99, 0.01);
}
END_TEST

START_TEST(a_settled_tank_keeps_its_volume_for_a_minute)
{
    const double H = 0.16;
    tank(both[_i], DX, H, 0.3, settling(H));
    add_block(0, 0, H, H);
    start();
    run_until(10);
    span early = run_until(14);
    run_until(70);
    span late = run_until(74);
    ck_assert_double_eq_tol(late.middle / early.middle, 1, 1e-3);
    ck_assert_uint_eq(sph2d_sim_fluid(sim).count, 64);
}
END_TEST

/** Liquid of depth H in a V of `degrees` between its walls. */
static void wedge(sph2d_method method, double dx, double H, double degrees)
{
    static sph2d_vec2 walls[3], corners[3];
    double slope = tan(degrees / 2 * TEST_PI / 180), far = 1.25 * H * slope, margin = 10 * dx;
    tank(method, dx, 1, 1, settling(H));
    scene.domain = (sph2d_box){{-far - margin, -margin}, {far + margin, 1.5 * H}};
    scene.boundary = (sph2d_boundary){SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN};
    walls[0] = (sph2d_vec2){-far, 1.25 * H};
    walls[1] = (sph2d_vec2){0, 0};
    walls[2] = (sph2d_vec2){far, 1.25 * H};
    corners[0] = (sph2d_vec2){0, 0};
    corners[1] = (sph2d_vec2){H * slope, H};
    corners[2] = (sph2d_vec2){-H * slope, H};
    obstacle = sph2d_obstacle_default();
    obstacle.outline.kind = SPH2D_OUTLINE_POLYLINE;
    obstacle.outline.polyline = (sph2d_points){walls, 3};
    scene.obstacles = &obstacle;
    scene.obstacle_count = 1;
    blocks[0] = sph2d_block_default();
    blocks[0].shape.kind = SPH2D_SHAPE_POLYGON;
    blocks[0].shape.polygon = (sph2d_points){corners, 3};
    scene.block_count = 1;
}

/** Takes steps up to a time; no particle may ever be outside the V. Tells the largest speed. */
static double run_inside(double degrees, double time)
{
    double slope = tan(degrees / 2 * TEST_PI / 180), most = 0;
    while (sph2d_sim_time(sim) < time) {
        test_steps(sim, 1);
        sph2d_view f = sph2d_sim_fluid(sim);
        for (size_t i = 0; i < f.count; ++i)
            ck_assert_msg(fabs(f.x[i]) <= slope * f.y[i] + 1e-12, "(%g, %g) at %g s", f.x[i], f.y[i],
                          sph2d_sim_time(sim));
        most = fmax(most, fastest());
    }
    return most;
}

START_TEST(liquid_in_a_corner_comes_to_rest)
{
    static const double degrees[] = {90, 45};
    const double H = _i / 2 == 0 ? 0.3 : 0.4, U = sqrt(G * H), T = sqrt(H / G);
    wedge(both[_i % 2], DX, H, degrees[_i / 2]);
    if (both[_i % 2] == SPH2D_METHOD_CONSTRAINT)
        scene.method.tolerance = 1e-5;
    start();
    size_t count = sph2d_sim_fluid(sim).count;
    ck_assert_uint_gt(count, 120);
    run_inside(degrees[_i / 2], 20 * T);
    double before = middle(), speed = run_inside(degrees[_i / 2], 40 * T);
    ck_assert_uint_eq(sph2d_sim_fluid(sim).count, count);
    ck_assert_double_le(speed, 0.01 * U);
    ck_assert_double_le(fabs(middle() - before), 2e-4 * H);
}
END_TEST

START_TEST(liquid_in_a_sharp_corner_comes_to_rest)
{
    const double H = 0.6, U = sqrt(G * H), T = sqrt(H / G);
    wedge(SPH2D_METHOD_CONSTRAINT, 0.0125, H, 10);
    scene.method.tolerance = 1e-6;
    start();
    size_t count = sph2d_sim_fluid(sim).count;
    ck_assert_uint_gt(count, 120);
    run_inside(10, 15 * T);
    double before = middle(), speed = run_inside(10, 20 * T);
    ck_assert_uint_eq(sph2d_sim_fluid(sim).count, count);
    ck_assert_double_le(speed, 0.01 * U);
    ck_assert_double_le(fabs(middle() - before), 2e-4 * H);
}
END_TEST

/* ---- a tube of two legs ------------------------------------------------------------------------------------------ */

/** Level of the left leg less that of the right one. */
static double level_difference(double width, double divider)
{
    sph2d_view f = sph2d_sim_fluid(sim);
    double left = 0, right = 0;
    for (size_t i = 0; i < f.count; ++i) {
        left += f.x[i] < width;
        right += f.x[i] > width + divider;
    }
    return (left - right) * DX * DX / width;
}

START_TEST(two_legs_swing_and_end_level)
{
    /* Potential flow around a sharp corner between two channels of width a is as inert as 0.559 a of straight channel,
     * as the corner square of a resistor counts 0.559 squares: 1 - (2/pi) ln 2. */
    const double a = 0.24, divider = 0.16, depth = 0.8; /* width of the legs, of what is between; mean depth */
    const double corner = a * (1 - 2 / TEST_PI * log(2)), length = 2 * (depth - a) + divider + 2 * corner;
    const double period = 2 * TEST_PI * sqrt(length / 2 / G);
    tank(both[_i], DX, 2 * a + divider, 1.2, 1e-3);
    obstacle = sph2d_obstacle_default();
    obstacle.outline.kind = SPH2D_OUTLINE_BOX;
    obstacle.outline.box = (sph2d_box){{a, a}, {a + divider, 1.2}};
    scene.obstacles = &obstacle;
    scene.obstacle_count = 1;
    add_block(0, 0, 2 * a + divider, a);
    add_block(0, a, a, depth + 0.08);
    add_block(a + divider, a, 2 * a + divider, depth - 0.08);
    start();
    double crossings[3], before = level_difference(a, divider), time = 0, end = 0;
    int count = 0, steps = 0;
    ck_assert_double_eq_tol(before, 0.16, 1e-9);
    while (sph2d_sim_time(sim) < 2.5 * period) {
        test_steps(sim, 1);
        double now = level_difference(a, divider), t = sph2d_sim_time(sim);
        bool late = count == 0 || t > crossings[count - 1] + 0.25 * period; /* not the same one again */
        if (count < 3 && before * now <= 0 && before != now && late)
            crossings[count++] = time + (t - time) * before / (before - now);
        before = now;
        time = t;
        if (t > 2 * period) {
            end += now;
            ++steps;
        }
    }
    ck_assert_int_eq(count, 3);
    ck_assert_double_eq_tol((crossings[2] - crossings[0]) / period, 1, 0.05);
    ck_assert_double_le(fabs(end / steps), DX);
}
END_TEST

/* ---- films ------------------------------------------------------------------------------------------------------- */

START_TEST(a_thin_film_stays_on_the_floor)
{
    int rows = 1 + _i / 2;
    double H = rows * DX, U = sqrt(G * H);
    tank(both[_i % 2], DX, 20 * DX, 0.2, 2.5);
    if (both[_i % 2] == SPH2D_METHOD_CONSTRAINT)
        scene.method.tolerance = 1e-5;
    add_block(0, 0, 20 * DX, H);
    start();
    run_until(10); /* some particles find their places late */
    double speed = 0;
    for (int n = 0; n < 500; ++n) {
        test_steps(sim, 1);
        speed = fmax(speed, fastest());
        sph2d_view f = sph2d_sim_fluid(sim);
        for (size_t i = 0; i < f.count; ++i) {
            ck_assert_double_gt(f.y[i], 0);
            ck_assert_double_lt(f.y[i], (rows - 0.4) * DX); /* a row sinks to between 0.15 and 0.5 of a spacing */
        }
    }
    ck_assert_uint_eq(sph2d_sim_fluid(sim).count, (size_t)rows * 20);
    ck_assert_double_le(speed, 0.02 * U);
}
END_TEST

START_TEST(single_particles_come_to_rest_on_the_floor)
{
    const double U = sqrt(G * DX);
    tank(both[_i], DX, 0.6, 0.2, 1e-3);
    scene.method.sound_speed = 10;
    for (int i = 0; i < 10; ++i)
        particles[i] = (sph2d_particle){0.04 + i * (i < 5 ? 2 : 3) * DX, DX / 2, 0, 0, 1000};
    scene.particles = (sph2d_particles){NULL, particles, 10};
    start();
    run_until(3);
    ck_assert_double_le(run_until(4).fastest, 0.01 * U);
    sph2d_view f = sph2d_sim_fluid(sim);
    ck_assert_uint_eq(f.count, 10);
    for (size_t i = 0; i < f.count; ++i) {
        ck_assert_double_gt(f.y[i], 0);
        ck_assert_double_lt(f.y[i], 0.5 * DX);
    }
}
END_TEST

/* ---- what falls -------------------------------------------------------------------------------------------------- */

START_TEST(a_drop_falls_freely_and_splashes_no_faster_than_it_came)
{
    const double bottom = 0.5, pool = 0.2; /* of the drop; depth */
    tank(both[_i], DX, 1, 0.8, 1e-3);
    add_block(0, 0, 1, pool);
    blocks[1] = sph2d_block_default();
    blocks[1].shape.kind = SPH2D_SHAPE_DISC;
    blocks[1].shape.disc = (sph2d_disc){{0.5, bottom + 0.1}, 0.1};
    blocks[2] = test_particle(DX, 0.15, 0.55, -0.5, 1);
    scene.block_count = 3;
    start();
    sph2d_view f = sph2d_sim_fluid(sim);
    double y[MOST], sum = 0, speed = 0, meets = 0.9 * sqrt(2 * (bottom - pool - 2.4 * DX) / G);
    double impact = sqrt(2 * G * (bottom + 0.1 - pool)); /* of its middle */
    size_t count = f.count, flying = 0;
    ck_assert_uint_lt(count, MOST);
    for (size_t i = 0; i < count; ++i)
        y[f.id[i]] = f.y[i];
    while (sph2d_sim_time(sim) < meets) { /* symplectic Euler of free fall, to round-off */
        double dt = -sph2d_sim_time(sim);
        test_steps(sim, 1);
        double t = sph2d_sim_time(sim);
        dt += t;
        sum -= G * t * dt;
        f = sph2d_sim_fluid(sim);
        flying = 0;
        for (size_t i = 0; i < count; ++i) {
            double start_y = y[f.id[i]];
            if (start_y < pool)
                continue;
            bool alone = f.x[i] < 0.3;
            ++flying;
            ck_assert_double_eq_tol(f.vx[i], alone ? -0.5 : 0, 1e-12);
            ck_assert_double_eq_tol(f.vy[i], (alone ? 1 : 0) - G * t, 1e-12);
            ck_assert_double_eq_tol(f.y[i], start_y + (alone ? t : 0) + sum, 1e-12);
        }
    }
    ck_assert_uint_gt(flying, 70);
    speed = run_until(0.8).fastest;
    ck_assert_double_gt(speed, 0.9 * impact);
    ck_assert_double_le(speed, 1.5 * impact);
    ck_assert_uint_eq(sph2d_sim_fluid(sim).count, count);
}
END_TEST

/* ---- jets -------------------------------------------------------------------------------------------------------- */

static double turn(sph2d_vec2 a, sph2d_vec2 b, sph2d_vec2 c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/** Targets of jets: a line, a corner that points down, a knife edge. */
enum { LINE, CORNER, KNIFE, TARGETS };
enum { FORMS = 3 };

START_TEST(no_jet_passes_a_thin_wall)
{
    static const sph2d_vec2 points[TARGETS][3] = {
        [LINE] = {{0, 0.3}, {1, 0.3}}, [CORNER] = {{0, 0.6}, {0.5, 0.15}, {1, 0.6}}, [KNIFE] = {{0.5, 0}, {0.5, 0.4}}};
    static const size_t counts[TARGETS] = {2, 3, 2};
    static const sph2d_wall_form forms[FORMS] = {SPH2D_WALL_HEAVY, SPH2D_WALL_REFLECT, SPH2D_WALL_GENERALISED};
    static sph2d_vec2 last[MOST];
    int target = _i / 2 % TARGETS;
    const double speed = 10 * sqrt(G * 0.3);
    tank(both[_i % 2], DX, 1, 1, 1e-3);
    obstacle = sph2d_obstacle_default();
    obstacle.outline.kind = SPH2D_OUTLINE_POLYLINE;
    obstacle.outline.polyline = (sph2d_points){points[target], counts[target]};
    obstacle.form = forms[_i / 2 / TARGETS];
    scene.obstacles = &obstacle;
    scene.obstacle_count = 1;
    add_block(0.45, 0.46, 0.55, 0.96);
    blocks[0].velocity = (sph2d_vec2){0.1 * speed, -speed};
    start();
    sph2d_view f = sph2d_sim_fluid(sim);
    size_t count = f.count;
    for (size_t i = 0; i < count; ++i)
        last[f.id[i]] = (sph2d_vec2){f.x[i], f.y[i]};
    double most = 0;
    while (sph2d_sim_time(sim) < 0.04) {
        test_steps(sim, 1);
        most = fmax(most, fastest());
        f = sph2d_sim_fluid(sim);
        for (size_t i = 0; i < f.count; ++i) {
            sph2d_vec2 q = {f.x[i], f.y[i]}, *p = &last[f.id[i]];
            ck_assert(q.x > 0 && q.x < 1 && q.y > 0);
            for (size_t k = 0; k + 1 < counts[target]; ++k) {
                sph2d_vec2 a = points[target][k], b = points[target][k + 1];
                ck_assert_msg(turn(a, b, *p) * turn(a, b, q) >= 0 || turn(*p, q, a) * turn(*p, q, b) >= 0,
                              "from (%g, %g) to (%g, %g)", p->x, p->y, q.x, q.y);
            }
            *p = q;
        }
    }
    ck_assert_double_gt(most, speed);
    ck_assert_double_le(most, 3 * speed);
}
END_TEST

/* ---- too much liquid --------------------------------------------------------------------------------------------- */

START_TEST(liquid_inside_the_floor_is_let_out_gently)
{
    /* A lattice half a spacing too low: its first row is on the floor. The sound speed is that of 1 % for method
     * constraint; pcisph, which corrects within one step what it can, needs a soft liquid. */
    const double H = 0.3;
    tank(both[_i], DX, H, 0.6, 1e-3);
    scene.method.sound_speed = both[_i] == SPH2D_METHOD_PCISPH ? sqrt(20 * G * H) : sqrt(200 * G * H);
    for (int i = 0; i < 225; ++i)
        particles[i] = (sph2d_particle){(i % 15 + 0.5) * DX, (i / 15 + 1e-4) * DX, 0, 0, 1000};
    scene.particles = (sph2d_particles){NULL, particles, 225};
    start();
    ck_assert_double_gt(sph2d_sim_summary(sim).compression_max, 0.25);
    ck_assert_double_lt(run_until(1).fastest, sqrt(2 * G * H));
    sph2d_summary s = sph2d_sim_summary(sim);
    ck_assert_uint_eq(s.particles, 225);
    ck_assert_double_lt(s.kinetic, 0.01 * 225 * 0.4 * G * H / 2);
}
END_TEST

START_TEST(a_source_into_a_full_box_finds_no_room)
{
    const double H = 0.3;
    tank(both[_i], DX, H, H, 1e-3);
    scene.boundary.top = SPH2D_SIDE_WALL;
    add_block(0, 0, H, H);
    sph2d_source source = sph2d_source_default();
    source.at = (sph2d_vec2){H / 2, 0.7 * H};
    source.width = 0.08;
    source.speed = 1;
    scene.sources = &source;
    scene.source_count = 1;
    start();
    span s = run_until(2);
    sph2d_summary sum = sph2d_sim_summary(sim);
    ck_assert_double_lt(s.fastest, 2 * sqrt(G * H));
    ck_assert_double_lt(sum.compression_max, 0.1);
    ck_assert_uint_eq(sum.particles, 225 + sum.fed);
    ck_assert_uint_le(sum.fed, 4); /* where two particles happen to be far apart */
    ck_assert_uint_gt(sum.blocked, 300);
    ck_assert(all_finite());
}
END_TEST

/* ---- a hundred times as high as wide ----------------------------------------------------------------------------- */

/* The pressure of a step is found for the particles that are there then: a tank that starts empty, is fed and drained.
 */
START_TEST(what_comes_and_goes_is_pressed_like_the_rest)
{
    tank(both[_i], DX, 1, 1, 1e-3);
    sph2d_source source = sph2d_source_default();
    source.at = (sph2d_vec2){0.5, 0.8};
    source.width = 0.2;
    source.speed = 3;
    scene.sources = &source;
    scene.source_count = 1;
    sph2d_drain drain = sph2d_drain_default();
    drain.shape.kind = SPH2D_SHAPE_BOX;
    drain.shape.box = (sph2d_box){{0, 0}, {0.2, 0.1}};
    scene.drains = &drain;
    scene.drain_count = 1;
    scene.method.sound_speed = 60;
    start();
    double fastest = 0;
    while (sph2d_sim_time(sim) < 0.6) {
        test_steps(sim, 1);
        fastest = fmax(fastest, sph2d_sim_summary(sim).speed_max);
    }
    sph2d_summary sum = sph2d_sim_summary(sim);
    ck_assert_uint_gt(sum.fed, 700);
    ck_assert_uint_gt(sum.drained, 50);
    ck_assert_uint_eq(sum.particles + sum.drained, sum.fed);
    ck_assert_double_lt(fastest, 2.5 * sqrt(3 * 3 + 2 * G * 0.8));
    ck_assert_double_lt(sum.compression_p99, 0.03);
    finish();
}
END_TEST

START_TEST(a_tall_column_keeps_its_compression)
{
    const double H = 8;
    tank(both[_i], DX, H / 100, 8.4, 1e-3);
    add_block(0, 0, H / 100, H);
    start();
    span s = run_until(0.4);
    sph2d_summary sum = sph2d_sim_summary(sim);
    ck_assert_double_le(sum.compression_p99, 0.01);
    ck_assert_double_le(sum.compression_max, 0.08);
    ck_assert_double_lt(s.fastest, 0.6 * sqrt(G * H));
    ck_assert_double_eq_tol(2 * middle() / H, 1, 0.03);
    ck_assert_uint_gt(sum.iterations, sum.steps);
    ck_assert_uint_eq(sum.unconverged, 0);
}
END_TEST

START_TEST(a_tall_column_stops_where_too_few_iterations_are_allowed)
{
    const double H = 8;
    tank(both[_i], DX, H / 100, 8.4, 1e-3);
    add_block(0, 0, H / 100, H);
    scene.method.max_iterations = 2;
    start();
    sph2d_status status = SPH2D_OK;
    sph2d_report_clear(&report);
    while (status == SPH2D_OK && sph2d_sim_time(sim) < 1)
        status = sph2d_sim_step(sim, &report);
    sph2d_summary s = sph2d_sim_summary(sim);
    ck_assert_int_eq(status, SPH2D_GUARD);
    ck_assert(test_report_has(&report, SPH2D_CODE_NOT_CONVERGED, "method.max_iterations"));
    ck_assert_uint_ge(s.unconverged, 100);
    ck_assert_uint_le(s.iterations, 2 * s.steps);
    ck_assert(all_finite());
    ck_assert_double_lt(s.compression_max, 0.1);
}
END_TEST

/* ---- limits ------------------------------------------------------------------------------------------------------ */

static void dam(sph2d_method method)
{
    tank(method, DX, 1, 1, 1e-3);
    add_block(0, 0, 0.3, 0.6);
}

START_TEST(limits_that_cannot_be_kept_are_counted)
{
    dam(both[_i]);
    scene.method.max_iterations = 20;
    if (both[_i] == SPH2D_METHOD_PCISPH)
        scene.method.max_compression = 1e-6;
    else
        scene.method.tolerance = 1e-10;
    start();
    test_steps(sim, 99);
    sph2d_summary s = sph2d_sim_summary(sim);
    ck_assert_uint_ge(s.unconverged, 95);
    ck_assert_uint_le(s.iterations, 20 * s.steps);
    ck_assert(all_finite());
    ck_assert_double_lt(s.compression_max, 0.03);
    ck_assert_double_eq_tol((s.kinetic + s.potential) / s.energy_start, 1, 0.05);
}
END_TEST

START_TEST(a_solver_that_has_time_keeps_a_narrow_tolerance)
{
    dam(SPH2D_METHOD_CONSTRAINT);
    scene.method.tolerance = 1e-10;
    start();
    run_until(0.4);
    sph2d_summary s = sph2d_sim_summary(sim);
    ck_assert_uint_eq(s.unconverged, 0);
    ck_assert_uint_gt(s.iterations, 10 * s.steps);
    ck_assert_uint_lt(s.iterations, 100 * s.steps);
}
END_TEST

START_TEST(any_damping_stays_finite)
{
    static const double damping[] = {0, 1, 2, 100};
    dam(SPH2D_METHOD_CONSTRAINT);
    scene.method.damping = damping[_i];
    start();
    span s = run_until(0.5);
    sph2d_summary sum = sph2d_sim_summary(sim);
    ck_assert(all_finite());
    ck_assert_uint_eq(sum.particles, 450);
    ck_assert_uint_eq(sum.unconverged, 0);
    ck_assert_double_lt(s.fastest, 3.5 * sqrt(G * 0.6));
    ck_assert_double_lt(sum.compression_p99, 0.02);
    ck_assert_double_lt((sum.kinetic + sum.potential) / sum.energy_start, 1.01);
}
END_TEST

START_TEST(a_soft_liquid_collapses_without_harm)
{
    dam(both[_i]);
    scene.method.sound_speed = 0.1;
    start();
    span s = run_until(0.5);
    sph2d_summary sum = sph2d_sim_summary(sim);
    ck_assert(all_finite());
    ck_assert_uint_eq(sum.particles, 450);
    ck_assert_double_gt(sum.compression_max, 5);
    ck_assert_double_le(s.fastest, 1.05 * sqrt(2 * G * 0.6)); /* it falls, and nothing throws it */
}
END_TEST

START_TEST(a_stiff_lattice_settles_without_overshoot_from_two_steps_of_damping_on)
{
    /* Let go at rest density, a column sinks by its compliance. Softer ones swing as sound does. */
    static const double damping[] = {1, 2, 5};
    tank(SPH2D_METHOD_CONSTRAINT, DX, 0.2, 0.5, 100);
    scene.boundary.left = scene.boundary.right = SPH2D_SIDE_PERIODIC;
    scene.method.sound_speed = 1000;
    scene.method.damping = damping[_i];
    scene.method.tolerance = 1e-8;
    add_block(0, 0, 0.2, 0.4);
    start();
    double before = middle(), lowest = before;
    while (sph2d_sim_time(sim) < 0.3) {
        test_steps(sim, 1);
        lowest = fmin(lowest, middle());
    }
    double sunk = before - middle(), overshoot = (middle() - lowest) / sunk;
    ck_assert_double_gt(sunk, 2e-6);
    ck_assert_double_lt(sunk, 5e-6);
    ck_assert_msg(damping[_i] < 2 ? overshoot > 0.02 : overshoot < 0.01, "%g of the way", overshoot);
}
END_TEST

/* ---- compliance -------------------------------------------------------------------------------------------------- */

/** mu = -sum V x dW/dx over a filled lattice, over the sum of V W: what a uniform strain does to the density. */
static double first_moment(double ratio)
{
    double slope = 0, value = 0;
    for (int i = -3; i <= 3; ++i)
        for (int j = -3; j <= 3; ++j) {
            double r = hypot(i, j), q = r / ratio;
            if (q >= 1)
                continue;
            value += pow(1 - q, 4) * (1 + 4 * q);
            slope += r > 0 ? i * i / (r * ratio) * 20 * q * pow(1 - q, 3) : 0;
        }
    return slope / value;
}

/** Mean height of the highest row of a lattice that has settled, 10 by 20 particles one spacing of 0.05 m apart. */
static double top_of_settled_lattice(double sound_speed)
{
    tank(SPH2D_METHOD_CONSTRAINT, 0.05, 0.5, 1.2, 200);
    scene.boundary.left = scene.boundary.right = SPH2D_SIDE_PERIODIC;
    scene.method.sound_speed = sound_speed;
    scene.method.tolerance = 1e-8;
    add_block(0, 0, 0.5, 1);
    start();
    while (sph2d_sim_time(sim) < 8)
        test_steps(sim, 1);
    sph2d_view f = sph2d_sim_fluid(sim);
    double top = 0;
    int row = 0;
    for (size_t i = 0; i < f.count; ++i)
        if (f.y[i] > 0.94) {
            top += f.y[i];
            ++row;
        }
    ck_assert_int_eq(row, 10); /* the lattice is whole */
    finish();
    return top / row;
}

/* Force balance makes p = rho g depth/mu, SPOOK rho/rho0 - 1 = p/(rho0 c0^2), and a strain changes density by mu times
 * as much: a depth H is less by g H^2/(2 c0^2 mu^2). */
START_TEST(depth_changes_with_compliance_as_the_lattice_tells)
{
    const double mu = first_moment(2.4), soft = 20, stiff = 28;
    double expected = G / (2 * mu * mu) * (1 / (soft * soft) - 1 / (stiff * stiff));
    ck_assert_double_eq_tol(mu, 0.94685, 1e-5);
    double change = top_of_settled_lattice(stiff) - top_of_settled_lattice(soft);
    ck_assert_double_eq_tol(change / expected, 1, 0.04);
}
END_TEST

Suite *suite_hard_cases(void)
{
    Suite *suite = suite_create("hard_cases");
    TCase *cases = tcase_create("hard cases");
    tcase_add_checked_fixture(cases, NULL, finish);
    tcase_set_timeout(cases, 60);
    tcase_add_loop_test(cases, a_tank_comes_to_rest_and_keeps_its_level, 0, 2);
    tcase_add_loop_test(cases, a_settled_tank_keeps_its_volume_for_a_minute, 0, 2);
    tcase_add_loop_test(cases, liquid_in_a_corner_comes_to_rest, 0, 4);
    tcase_add_test(cases, liquid_in_a_sharp_corner_comes_to_rest);
    tcase_add_loop_test(cases, two_legs_swing_and_end_level, 0, 2);
    tcase_add_loop_test(cases, a_thin_film_stays_on_the_floor, 0, 6);
    tcase_add_loop_test(cases, single_particles_come_to_rest_on_the_floor, 0, 2);
    tcase_add_loop_test(cases, a_drop_falls_freely_and_splashes_no_faster_than_it_came, 0, 2);
    tcase_add_loop_test(cases, no_jet_passes_a_thin_wall, 0, 2 * TARGETS * FORMS);
    tcase_add_loop_test(cases, liquid_inside_the_floor_is_let_out_gently, 0, 2);
    tcase_add_loop_test(cases, a_source_into_a_full_box_finds_no_room, 0, 2);
    tcase_add_loop_test(cases, what_comes_and_goes_is_pressed_like_the_rest, 0, 2);
    tcase_add_loop_test(cases, a_tall_column_keeps_its_compression, 0, 2);
    tcase_add_loop_test(cases, a_tall_column_stops_where_too_few_iterations_are_allowed, 0, 2);
    tcase_add_loop_test(cases, limits_that_cannot_be_kept_are_counted, 0, 2);
    tcase_add_test(cases, a_solver_that_has_time_keeps_a_narrow_tolerance);
    tcase_add_loop_test(cases, any_damping_stays_finite, 0, 4);
    tcase_add_loop_test(cases, a_soft_liquid_collapses_without_harm, 0, 2);
    tcase_add_loop_test(cases, a_stiff_lattice_settles_without_overshoot_from_two_steps_of_damping_on, 0, 3);
    tcase_add_test(cases, depth_changes_with_compliance_as_the_lattice_tells);
    suite_add_tcase(suite, cases);
    return suite;
}
