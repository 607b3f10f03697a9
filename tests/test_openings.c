/* SPDX-License-Identifier: MIT */
/** @file test_openings.c
 *  Openings: streams stay streams, what flows in and out is counted and its energy known, sound leaves, a tank drains
 *  as Torricelli says, the same bits for threads and resumed runs. */
#include <math.h>
#include <string.h>

#include "common.h"

static const double DX = 0.025;

/** A channel, and what its scene points to. */
typedef struct channel {
    sph2d_scene scene;
    sph2d_block blocks[3];
    sph2d_opening openings[2];
    sph2d_probe probes[2];
    sph2d_sim *sim;
} channel;

static channel c;

/** A channel of water, without gravity, that flows from left to right at 1 m/s. */
static void lay_channel(double width, double height, bool walls)
{
    c = (channel){.scene = sph2d_scene_default()};
    c.scene.domain = (sph2d_box){{0, 0}, {width, height}};
    c.scene.boundary.bottom = c.scene.boundary.top = walls ? SPH2D_SIDE_WALL : SPH2D_SIDE_PERIODIC;
    c.scene.gravity = (sph2d_vec2){0, 0};
    c.scene.spacing = DX;
    c.blocks[0] = test_block(0, 0, width, height);
    c.blocks[0].velocity.x = 1;
    c.scene.blocks = c.blocks;
    c.scene.block_count = 1;
    c.openings[0] = c.openings[1] = sph2d_opening_default();
    c.openings[0].name = "in";
    c.openings[0].side = SPH2D_SIDE_NAME_LEFT;
    c.openings[0].velocity = 1;
    c.openings[1].name = "out";
    c.openings[1].side = SPH2D_SIDE_NAME_RIGHT;
    c.openings[1].pressure = 0;
    c.scene.openings = c.openings;
    c.scene.opening_count = 2;
    for (int k = 0; k < 2; ++k) {
        c.probes[k] = sph2d_probe_default();
        c.probes[k].kind = SPH2D_PROBE_OPENING;
        c.probes[k].name = c.probes[k].on = c.openings[k].name;
        c.probes[k].rate.every = 1;
    }
    c.scene.probes = c.probes;
    c.scene.probe_count = 2;
}

static void start(void)
{
    c.sim = test_create(&c.scene, NULL);
}

static void run_until(double time)
{
    while (sph2d_sim_time(c.sim) < time)
        test_steps(c.sim, 1);
}

static void finish(void)
{
    sph2d_sim_destroy(c.sim);
}

/** What a probe of an opening reads. */
typedef struct reading {
    double velocity, flow_rate, let_in, pressure, wet;
} reading;

static reading read_opening(size_t index)
{
    double v[SPH2D_PROBE_MAX_COLUMNS];
    ck_assert_uint_eq(sph2d_sim_probe(c.sim, index, v), 5);
    return (reading){v[0], v[1], v[2], v[3], v[4]};
}

/** All particles are those of the start, and those that came less those that left. */
static void check_count(uint64_t at_start)
{
    sph2d_summary s = sph2d_sim_summary(c.sim);
    ck_assert_uint_eq(s.particles, at_start + s.let_in - s.let_out);
}

/* ---- streams ----------------------------------------------------------------------------------------------------- */

START_TEST(a_stream_stays_a_lattice)
{
    lay_channel(0.5, 0.25, false);
    start();
    uint64_t particles = sph2d_sim_summary(c.sim).particles;
    /* 20 columns, 10 of a reservoir at each end, whatever the support needs, and 3 of a duct */
    ck_assert_uint_ge(particles, 10 * (20 + 2 * 7 + 3));
    run_until(3);
    sph2d_view f = sph2d_sim_fluid(c.sim);
    for (size_t i = 0; i < f.count; ++i) {
        ck_assert_double_le(fabs(f.vx[i] - 1), 1e-9);
        ck_assert_double_le(fabs(f.vy[i]), 1e-9);
        ck_assert_double_le(fabs(f.pressure[i]), 1e-6 * 1000);
        double row = f.y[i] / DX - 0.5;
        ck_assert_double_le(fabs(row - round(row)), 1e-9);
    }
    check_count(particles);
    ck_assert_double_le(fabs((double)f.count - (double)particles), 10); /* a column more or less */
    /* 3 m^2/s times 0.25 m, to the particles of a column */
    reading in = read_opening(0), out = read_opening(1);
    ck_assert_double_le(fabs(in.let_in - 0.75), 0.25 * DX);
    ck_assert_double_le(fabs(out.let_in + 0.75), 0.25 * DX);
    ck_assert_double_le(fabs(in.velocity - 1), 1e-9);
    ck_assert_double_le(fabs(out.velocity + 1), 1e-9);
    ck_assert_double_le(fabs(in.flow_rate - 0.25), 1e-9);
    ck_assert_double_eq(in.wet, 0.25);
    sph2d_summary s = sph2d_sim_summary(c.sim);
    ck_assert_double_le(fabs(s.energy_error), 1e-4 * s.energy_scale);
    finish();
}
END_TEST

START_TEST(disorder_leaves_with_the_stream)
{
    lay_channel(1, 0.5, false);
    c.blocks[0].perturb.amplitude = 0.2;
    start();
    uint64_t particles = sph2d_sim_summary(c.sim).particles;
    run_until(4);
    sph2d_view f = sph2d_sim_fluid(c.sim);
    double square = 0, inside = 0;
    for (size_t i = 0; i < f.count; ++i)
        if (f.x[i] > 0 && f.x[i] < 1) {
            square += f.pressure[i] * f.pressure[i];
            ++inside;
        }
    ck_assert_double_le(sqrt(square / inside), 0.01 * 1000); /* of rho U^2 */
    ck_assert_double_le(fabs(inside - 800), 20);             /* a column */
    check_count(particles);
    finish();
}
END_TEST

START_TEST(a_stream_starts_from_rest)
{
    /* By a flow rate, over a ramp: half of it in the middle of the ramp. */
    lay_channel(1, 0.5, false);
    c.blocks[0].velocity.x = 0;
    c.openings[0].velocity = NAN;
    c.openings[0].flow_rate = 0.5;
    c.openings[0].ramp = 1;
    start();
    run_until(0.5);
    ck_assert_double_le(fabs(read_opening(0).velocity - 0.5), 0.2);
    run_until(3);
    ck_assert_double_le(fabs(read_opening(0).velocity - 1), 0.01);
    ck_assert_double_le(fabs(read_opening(1).velocity + 1), 0.01);
    finish();
}
END_TEST

/** Developed flow between plates: u = 6 U y (1 - y), dp/dx = -12 mu U. */
START_TEST(flow_between_plates_keeps_its_parabola)
{
    const double mu = 50;
    lay_channel(1, 0.5, true);
    c.scene.wall_slip = SPH2D_SLIP_NONE;
    c.scene.fluid.dynamic_viscosity = mu;
    c.blocks[0].velocity.x = 0;
    c.openings[0].profile = SPH2D_OPENING_PROFILE_PARABOLA;
    c.openings[0].ramp = 0.2;
    start();
    run_until(2);
    sph2d_view f = sph2d_sim_fluid(c.sim);
    double worst = 0, x[2] = {0, 0}, p[2] = {0, 0}, n[2] = {0, 0};
    for (size_t i = 0; i < f.count; ++i) {
        double z = f.y[i] / 0.5;
        if (f.x[i] > 0 && f.x[i] < 1)
            worst = fmax(worst, fabs(f.vx[i] - 6 * z * (1 - z)));
        int near = f.x[i] > 0.2 && f.x[i] < 0.3 ? 0 : f.x[i] > 0.7 && f.x[i] < 0.8 ? 1 : -1;
        if (near >= 0) {
            x[near] += f.x[i];
            p[near] += f.pressure[i];
            ++n[near];
        }
    }
    ck_assert_double_le(worst, 0.02);
    double slope = (p[1] / n[1] - p[0] / n[0]) / (x[1] / n[1] - x[0] / n[0]), exact = -12 * mu / (0.5 * 0.5);
    ck_assert_double_le(fabs(slope / exact - 1), 0.04);
    /* at the side the pressure is the given one, to what falls over a spacing or two */
    ck_assert_double_le(fabs(read_opening(1).pressure), -2 * DX * exact);
    sph2d_summary s = sph2d_sim_summary(c.sim);
    ck_assert_double_gt(s.energy_viscous, 1000);
    ck_assert_double_le(fabs(s.energy_error), 0.01 * s.energy_viscous);
    finish();
}
END_TEST

/** Largest difference of the velocity of particles in the reservoir of the first opening from f(y), and their number. */
static double worst_in_reservoir(double (*f)(double y, double time), size_t *count)
{
    sph2d_view v = sph2d_sim_fluid(c.sim);
    double worst = 0;
    *count = 0;
    for (size_t i = 0; i < v.count; ++i)
        if (v.x[i] < 0) {
            worst = fmax(worst, fabs(v.vx[i] - f(v.y[i], sph2d_sim_time(c.sim))));
            ++*count;
        }
    return worst;
}

static double power_law(double y, double time)
{
    double wall = fmin(y, 0.5 - y) / 0.25;
    (void)time;
    return 8.0 / 7 * pow(wall, 1.0 / 7);
}

START_TEST(a_turbulent_profile_is_the_power_law)
{
    size_t count;
    lay_channel(1, 0.5, true);
    c.openings[0].profile = SPH2D_OPENING_PROFILE_TURBULENT;
    start();
    ck_assert_double_le(worst_in_reservoir(power_law, &count), 1e-12);
    ck_assert_uint_gt(count, 100);
    ck_assert_double_le(fabs(sph2d_sim_plan(c.sim)->sound_speed / 10 - 8.0 / 7), 1e-9);
    double mean = 0;
    sph2d_view v = sph2d_sim_fluid(c.sim);
    for (size_t i = 0; i < v.count; ++i)
        mean += v.x[i] < 0 ? v.vx[i] / (double)count : 0;
    ck_assert_double_le(fabs(mean - 1), 0.01); /* the mean of 20 lanes is not that of the law */
    finish();
}
END_TEST

/** Of the points below: cubic in y, linear between t = 0 and 1. */
static double given(double y, double time)
{
    double growth = fmin(time, 1);
    return (1 + growth) * (1 + y) - 2 * growth * y * y * y;
}

static void lay_profile(sph2d_path_point points[12])
{
    static const double places[6] = {0, 0.1, 0.15, 0.3, 0.4, 0.5};
    lay_channel(1, 0.5, true);
    for (size_t k = 0; k < 12; ++k) {
        double t = k < 6 ? 0 : 1, y = places[k % 6];
        points[k] = (sph2d_path_point){t, y, given(y, t)};
    }
    c.openings[0].velocity = NAN;
    c.openings[0].history.profile = (sph2d_path){points, 12};
}

START_TEST(a_velocity_over_place_and_time_is_the_cubic_of_its_points)
{
    sph2d_path_point points[12];
    size_t count;
    lay_profile(points);
    c.blocks[0].velocity.x = 1.25;
    start();
    ck_assert_double_le(worst_in_reservoir(given, &count), 1e-12);
    ck_assert_uint_gt(count, 100);
    test_steps(c.sim, 200); /* sound, that leaves, adds to it */
    ck_assert_double_gt(sph2d_sim_time(c.sim), 0.1);
    ck_assert_double_le(worst_in_reservoir(given, &count), 0.25);
    run_until(1.5);
    /* the mean over the width: 2 * 1.25 - 2 * 0.5^3/4 */
    ck_assert_double_le(fabs(read_opening(0).velocity - 2.4375), 0.05);
    finish();
}
END_TEST

START_TEST(points_that_make_no_profile_are_refused)
{
    static const char *const words[] = {"does not go on",      "does not go on",      "does not go on",
                                        "does not go on",      "from 0 to 0.5",       "leave out",
                                        "more than one thing", "uniform profile only"};
    sph2d_path_point points[12];
    sph2d_report report = {0};
    lay_profile(points);
    switch (_i) {
    case 0: /* a place twice */
        points[3].x = points[2].x;
        break;
    case 1: /* another place at the second time */
        points[8].x += 0.01;
        break;
    case 2: /* a place less at the last time */
        c.openings[0].history.profile.count = 11;
        break;
    case 3: /* back in time */
        for (size_t k = 6; k < 12; ++k)
            points[k].t = -1;
        break;
    case 4: /* not as wide as the opening */
        points[5].x = points[11].x = 0.49;
        break;
    case 5:
        c.openings[0].profile = SPH2D_OPENING_PROFILE_PARABOLA;
        break;
    case 6:
        c.openings[0].velocity = 1;
        break;
    default:
        c.openings[0].free_surface = SPH2D_SWITCH_ON;
        c.scene.gravity.y = -9.81;
    }
    ck_assert_int_eq(sph2d_scene_check(&c.scene, &report), SPH2D_SCENE);
    ck_assert_msg(strstr(test_report_text(&report), words[_i]), "%s", test_report_text(&report));
    sph2d_report_clear(&report);
}
END_TEST

/* ---- sound ------------------------------------------------------------------------------------------------------- */

/** Energy of sound: elastic, and kinetic, in liquid that should be at rest. */
static double energy_of_sound(void)
{
    sph2d_summary s = sph2d_sim_summary(c.sim);
    return s.elastic + s.kinetic;
}

START_TEST(sound_leaves)
{
    /* A pulse in the middle goes to both sides: of openings with a velocity, or with a pressure, _i of 2; without
     * openings a closed tube keeps it. */
    lay_channel(2, 0.25, false);
    c.scene.method.sound_speed = 10;
    c.scene.method.density_diffusion = 0;
    c.scene.method.shifting = 0;
    c.scene.method.tensile_control = SPH2D_SWITCH_OFF;
    c.scene.fluid.dynamic_viscosity = 0;
    for (int k = 0; k < 3; ++k) {
        c.blocks[k] = test_block(0.8 * k - (k > 1 ? 0.4 : 0), 0, k == 1 ? 1.2 : 0.8 + 0.6 * k, 0.25);
        c.blocks[k].velocity.x = 0;
    }
    c.blocks[2] = test_block(1.2, 0, 2, 0.25);
    c.blocks[1].spacing = 0.999 * DX;
    c.scene.block_count = 3;
    for (int k = 0; k < 2; ++k) {
        c.openings[k].velocity = _i == 0 ? 0 : NAN;
        c.openings[k].pressure = _i == 1 ? 0 : NAN;
    }
    if (_i == 2)
        c.scene.opening_count = c.scene.probe_count = 0;
    start();
    double before = energy_of_sound();
    run_until(0.3); /* three times the way from the middle to the side */
    if (_i == 2)
        ck_assert_double_ge(energy_of_sound(), 0.95 * before);
    else
        ck_assert_double_le(energy_of_sound(), 0.6 * before);
    finish();
}
END_TEST

/* ---- gravity ----------------------------------------------------------------------------------------------------- */

static void lay_tank(double level)
{
    lay_channel(1, 1, true);
    c.scene.boundary.top = SPH2D_SIDE_OPEN;
    c.scene.gravity.y = -9.81;
    c.blocks[0] = test_block(0, 0, 1, level);
    c.openings[0] = c.openings[1];
    c.probes[0].on = "out";
    c.scene.opening_count = c.scene.probe_count = 1;
}

START_TEST(a_tank_with_its_own_pressure_at_a_side_stays_at_rest)
{
    lay_tank(0.5);
    c.openings[0].from = 0.1;
    c.openings[0].to = 0.3;
    c.openings[0].pressure = 1000 * 9.81 * (0.5 - 0.2);
    start();
    run_until(2);
    sph2d_view f = sph2d_sim_fluid(c.sim);
    double inside = 0;
    for (size_t i = 0; i < f.count; ++i)
        inside += f.x[i] < 1;
    ck_assert_double_le(fabs(inside - 800), 20);               /* half a row */
    ck_assert_double_le(fabs(read_opening(0).velocity), 0.14); /* that of a head of 1 mm, 1/25 of a spacing */
    finish();
}
END_TEST

START_TEST(a_tank_drains_as_through_a_short_tube)
{
    /* Torricelli: v = sqrt(2 g h/(1 - (a/A)^2)); through a short tube 0.8 of that, in the mean over a fall of level. */
    lay_tank(0.6);
    c.openings[0].side = SPH2D_SIDE_NAME_BOTTOM;
    c.openings[0].from = 0.4;
    c.openings[0].to = 0.6;
    start();
    double past = 0, wanted = 0, time = 0, rate = 0;
    while (sph2d_sim_time(c.sim) < 0.6) {
        test_steps(c.sim, 1);
        double dt = sph2d_sim_time(c.sim) - time, level = 0.6 + read_opening(0).let_in;
        time += dt;
        past += time > 0.3 ? dt : 0;
        wanted += time > 0.3 ? dt * sqrt(2 * 9.81 * level / 0.96) : 0;
        rate += time > 0.3 ? -dt * read_opening(0).velocity : 0;
    }
    ck_assert_double_gt(past, 0.29);
    ck_assert_double_ge(rate / wanted, 0.7);
    ck_assert_double_le(rate / wanted, 0.9);
    sph2d_summary s = sph2d_sim_summary(c.sim);
    ck_assert_double_le(fabs(s.energy_error), 0.03 * s.energy_scale);
    finish();
}
END_TEST

START_TEST(a_jet_fills_an_empty_tank)
{
    lay_tank(0.5);
    c.scene.block_count = 0;
    c.openings[0].from = 0.6;
    c.openings[0].to = 0.7;
    c.openings[0].pressure = NAN;
    c.openings[0].velocity = 1;
    start();
    uint64_t at_start = sph2d_sim_summary(c.sim).particles;
    run_until(1);
    check_count(at_start);
    ck_assert_double_le(fabs(read_opening(0).let_in - 0.1), 0.1 * DX);
    sph2d_summary s = sph2d_sim_summary(c.sim);
    ck_assert_double_le(s.energy_rise, 0.001 * s.energy_scale);
    ck_assert_double_le(s.compression_p99, 0.01);
    finish();
}
END_TEST

START_TEST(no_void_stays_behind_a_cylinder)
{
    /* Pressure in the wake is below that of the outlet, 0. */
    lay_channel(4, 2, false);
    c.scene.spacing = 0.1;
    c.scene.fluid.dynamic_viscosity = 10;
    sph2d_obstacle cylinder = sph2d_obstacle_default();
    cylinder.outline.kind = SPH2D_OUTLINE_CIRCLE;
    cylinder.outline.circle = (sph2d_disc){{1, 1}, 0.3};
    c.scene.obstacles = &cylinder;
    c.scene.obstacle_count = 1;
    start();
    run_until(8);
    sph2d_view f = sph2d_sim_fluid(c.sim);
    double lowest = 0, inside = 0;
    for (size_t i = 0; i < f.count; ++i) {
        lowest = fmin(lowest, f.pressure[i]);
        inside += f.x[i] > 0 && f.x[i] < 4;
    }
    ck_assert_double_le(lowest, -100);
    double area = 4 * 2 - TEST_PI * 0.3 * 0.3;
    ck_assert_double_le(fabs(inside * 0.01 / area - 1), 0.05); /* two columns */
    finish();
}
END_TEST

START_TEST(no_void_stays_behind_a_corner)
{
    /* A river that turns round a corner: of blocks that fill the domain with a solid, water of nearly no viscosity. */
    static const sph2d_vec2 solid[] = {{0, 0}, {1.2, 0}, {1.2, 1}, {1, 1.2}, {0, 1.2}};
    static const sph2d_vec2 liquid[] = {{0, 1.2}, {1, 1.2}, {1.2, 1}, {1.2, 0}, {2, 0}, {2, 2}, {0, 2}};
    lay_channel(2, 2, true);
    c.scene.spacing = 0.05;
    sph2d_obstacle bank = sph2d_obstacle_default();
    bank.outline.kind = SPH2D_OUTLINE_POLYGON;
    bank.outline.polygon = (sph2d_points){solid, 5};
    c.scene.obstacles = &bank;
    c.scene.obstacle_count = 1;
    c.blocks[0] = sph2d_block_default();
    c.blocks[0].shape.kind = SPH2D_SHAPE_POLYGON;
    c.blocks[0].shape.polygon = (sph2d_points){liquid, 7};
    c.openings[0].from = 1.2;
    c.openings[0].ramp = 0.5;
    c.openings[1].side = SPH2D_SIDE_NAME_BOTTOM;
    c.openings[1].from = 1.2;
    start();
    double at_start = 0, now = 0;
    for (int end = 0; end < 2; ++end) {
        run_until(3.0 * end);
        sph2d_view f = sph2d_sim_fluid(c.sim);
        for (size_t i = 0; i < f.count; ++i)
            *(end ? &now : &at_start) += f.x[i] > 0 && f.y[i] > 0;
    }
    ck_assert_double_le(fabs(now / at_start - 1), 0.02);
    ck_assert_double_ge(read_opening(1).wet, 0.79);
    sph2d_summary s = sph2d_sim_summary(c.sim);
    ck_assert_double_le(fabs(s.energy_error), 0.03 * s.energy_scale);
    finish();
}
END_TEST

/* Liquid at rest under a pressure presses on a box on the floor by that pressure, and by nothing that keeps particles
 * together; but for the edges, where pairs have 4 % less, of that, too. */
START_TEST(a_box_on_the_floor_feels_the_pressure)
{
    const double pressure = 400;
    lay_channel(1, 0.5, true);
    c.blocks[0].velocity.x = 0;
    sph2d_obstacle box = sph2d_obstacle_default();
    box.name = "box";
    box.outline.kind = SPH2D_OUTLINE_BOX;
    box.outline.box = (sph2d_box){{0.4, 0}, {0.6, 0.2}};
    c.scene.obstacles = &box;
    c.scene.obstacle_count = 1;
    c.openings[0].velocity = NAN;
    c.openings[0].pressure = c.openings[1].pressure = pressure;
    c.scene.wall_slip = SPH2D_SLIP_NONE;
    c.scene.method.operators = _i ? SPH2D_OPERATORS_FITTED : SPH2D_OPERATORS_SYMMETRIC;
    c.probes[0].kind = SPH2D_PROBE_FORCE;
    c.probes[0].on = "box";
    start();
    run_until(3);
    double v[SPH2D_PROBE_MAX_COLUMNS];
    sph2d_sample above;
    ck_assert(sph2d_sim_sample(c.sim, (sph2d_vec2){0.5, 0.2}, &above));
    ck_assert_double_le(fabs(above.pressure - pressure), 0.2 * pressure); /* sound still comes and goes */
    ck_assert_uint_eq(sph2d_sim_probe(c.sim, 0, v), 12);
    ck_assert_double_le(fabs(v[0]), 0.01 * pressure * 0.2);
    ck_assert_double_le(fabs(v[1] / (above.pressure * 0.2) + 1), _i ? 0.01 : 0.1);
    finish();
}
END_TEST

/* ---- bits -------------------------------------------------------------------------------------------------------- */

static void lay_busy_channel(void)
{
    lay_channel(0.6, 0.3, true);
    c.blocks[0].perturb.amplitude = 0.2;
    c.openings[0].from = 0.1;
    c.openings[0].ramp = 0.1;
    c.openings[1].to = 0.2;
}

static void compare(sph2d_sim *a, sph2d_sim *b)
{
    sph2d_view p = sph2d_sim_fluid(a), q = sph2d_sim_fluid(b);
    ck_assert_uint_eq(p.count, q.count);
    for (size_t i = 0; i < p.count; ++i) {
        ck_assert_uint_eq(p.id[i], q.id[i]);
        ck_assert(p.x[i] == q.x[i] && p.y[i] == q.y[i] && p.vx[i] == q.vx[i] && p.density[i] == q.density[i]);
    }
}

START_TEST(threads_give_the_same_bits)
{
    lay_busy_channel();
    start();
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = 3;
    sph2d_sim *other = test_create(&c.scene, &options);
    test_steps(c.sim, 300);
    test_steps(other, 300);
    compare(c.sim, other);
    sph2d_sim_destroy(other);
    finish();
}
END_TEST

START_TEST(a_resumed_run_has_the_same_bits)
{
    lay_busy_channel();
    start();
    test_steps(c.sim, 150);
    test_state state = test_state_copy(c.sim);
    sph2d_sim *other = NULL;
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = 1;
    ck_assert_int_eq(sph2d_sim_restore(&c.scene, &options, &state.state, &other, NULL), SPH2D_OK);
    test_state_free(&state);
    test_steps(c.sim, 150);
    test_steps(other, 150);
    compare(c.sim, other);
    double a[SPH2D_PROBE_MAX_COLUMNS], b[SPH2D_PROBE_MAX_COLUMNS];
    ck_assert_uint_eq(sph2d_sim_probe(c.sim, 1, a), 5);
    ck_assert_uint_eq(sph2d_sim_probe(other, 1, b), 5);
    ck_assert(memcmp(a, b, 5 * sizeof *a) == 0);
    ck_assert(sph2d_sim_summary(c.sim).energy_fed == sph2d_sim_summary(other).energy_fed);
    sph2d_sim_destroy(other);
    finish();
}
END_TEST

/* ---- what is refused --------------------------------------------------------------------------------------------- */

static void nothing_given(void)
{
    c.openings[0].velocity = NAN;
}
static void two_given(void)
{
    c.openings[1].flow_rate = -1;
}
static void ramp_of_pressure(void)
{
    c.openings[1].ramp = 1;
}
static void outside(void)
{
    c.openings[0].to = 2;
}
static void narrow(void)
{
    c.openings[0].from = 0.1;
    c.openings[0].to = 0.1 + 2 * DX;
}
static void open_side(void)
{
    c.scene.boundary.left = SPH2D_SIDE_OPEN;
}
static void same_side(void)
{
    c.openings[1].side = SPH2D_SIDE_NAME_LEFT;
}
static void corner(void)
{
    c.openings[1].side = SPH2D_SIDE_NAME_BOTTOM;
}
static void unbalanced(void)
{
    c.openings[1].pressure = NAN;
    c.openings[1].velocity = -0.5;
}
static void other_method(void)
{
    c.scene.method.name = SPH2D_METHOD_PCISPH;
}
static void moving_tank(void)
{
    c.scene.motion.amplitude.x = 0.1;
    c.scene.motion.frequency = 1;
}
static void belt(void)
{
    c.scene.wall_speeds.left = 1;
}
static void force_on_side(void)
{
    c.probes[0].kind = SPH2D_PROBE_FORCE;
    c.probes[0].on = "left";
}
static void unknown_opening(void)
{
    c.probes[0].on = "door";
}
static void same_name(void)
{
    c.openings[1].name = "in";
}

static const struct fault {
    const char *path;
    sph2d_code code;
    void (*break_it)(void);
} all_faults[] = {
    {"openings[0]", SPH2D_CODE_MISSING_KEY, nothing_given},
    {"openings[1]", SPH2D_CODE_CONFLICT, two_given},
    {"openings[1].ramp", SPH2D_CODE_CONFLICT, ramp_of_pressure},
    {"openings[0].to", SPH2D_CODE_OUTSIDE, outside},
    {"openings[0].to", SPH2D_CODE_OUT_OF_RANGE, narrow},
    {"openings[0].side", SPH2D_CODE_CONFLICT, open_side},
    {"openings[1]", SPH2D_CODE_OVERLAP, same_side},
    {"openings[1]", SPH2D_CODE_OVERLAP, corner},
    {"openings", SPH2D_CODE_CONFLICT, unbalanced},
    {"openings", SPH2D_CODE_UNSUPPORTED, other_method},
    {"motion", SPH2D_CODE_UNSUPPORTED, moving_tank},
    {"openings[0].side", SPH2D_CODE_CONFLICT, belt},
    {"probes[0].on", SPH2D_CODE_UNSUPPORTED, force_on_side},
    {"probes[0].on", SPH2D_CODE_CONFLICT, unknown_opening},
    {"openings[1].name", SPH2D_CODE_CONFLICT, same_name},
};
enum { FAULTS = sizeof all_faults / sizeof *all_faults };

START_TEST(bad_openings_are_refused)
{
    lay_channel(0.5, 0.25, true);
    all_faults[_i].break_it();
    sph2d_report report = {0};
    ck_assert_int_eq(sph2d_scene_check(&c.scene, &report), SPH2D_SCENE);
    ck_assert_msg(test_report_has(&report, all_faults[_i].code, all_faults[_i].path), "%s", test_report_text(&report));
    sph2d_report_clear(&report);
}
END_TEST

START_TEST(a_solid_before_an_opening_is_refused)
{
    lay_channel(0.5, 0.25, true);
    sph2d_obstacle box = sph2d_obstacle_default();
    box.outline.kind = SPH2D_OUTLINE_BOX;
    box.outline.box = (sph2d_box){{0, 0}, {0.1, 0.1}};
    c.scene.obstacles = &box;
    c.scene.obstacle_count = 1;
    sph2d_report report = {0};
    ck_assert_int_eq(sph2d_scene_check(&c.scene, &report), SPH2D_SCENE);
    ck_assert_msg(test_report_has(&report, SPH2D_CODE_OVERLAP, "openings[0]"), "%s", test_report_text(&report));
    c.openings[0].from = 0.1;
    ck_assert_int_eq(sph2d_scene_check(&c.scene, NULL), SPH2D_OK);
    sph2d_report_clear(&report);
}
END_TEST

/* An inflow over a whole side is told where liquid stands lower; not one that ends there, has a surface, lets out, or lies
 * above dry ground. */
START_TEST(an_inflow_above_the_level_is_told)
{
    static const struct {
        double depth, velocity, to;
        sph2d_switch surface;
        bool told;
    } cases[] = {{0.1, 1, NAN, SPH2D_SWITCH_OFF, true},   {0.1, 1, 0.1, SPH2D_SWITCH_OFF, false},
                 {0.1, 1, NAN, SPH2D_SWITCH_ON, false},   {0.1, -1, NAN, SPH2D_SWITCH_OFF, false},
                 {0.25, 1, NAN, SPH2D_SWITCH_OFF, false}, {0, 1, NAN, SPH2D_SWITCH_OFF, false}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; ++k) {
        lay_channel(0.5, 0.25, true);
        c.scene.gravity.y = -9.81;
        c.scene.boundary.top = SPH2D_SIDE_OPEN;
        c.blocks[0] = cases[k].depth > 0 ? test_block(0, 0, 0.5, cases[k].depth) : test_block(0.25, 0, 0.5, 0.1);
        c.openings[0].velocity = cases[k].velocity;
        c.openings[0].to = cases[k].to;
        c.openings[0].free_surface = cases[k].surface;
        sph2d_report report = {0};
        ck_assert_msg(sph2d_scene_check(&c.scene, &report) == SPH2D_OK, "%zu: %s", k, test_report_text(&report));
        bool told = report.count == 1 && report.items[0].severity == SPH2D_WARNING &&
                    strcmp(report.items[0].path, "openings[0]") == 0;
        ck_assert_msg(told == cases[k].told, "%zu: %s", k, test_report_text(&report));
        sph2d_report_clear(&report);
    }
}
END_TEST

Suite *suite_openings(void)
{
    Suite *suite = suite_create("openings");
    TCase *test = tcase_create("openings");
    tcase_set_timeout(test, 120);
    tcase_add_test(test, an_inflow_above_the_level_is_told);
    tcase_add_test(test, a_stream_stays_a_lattice);
    tcase_add_test(test, disorder_leaves_with_the_stream);
    tcase_add_test(test, a_stream_starts_from_rest);
    tcase_add_test(test, flow_between_plates_keeps_its_parabola);
    tcase_add_test(test, a_turbulent_profile_is_the_power_law);
    tcase_add_test(test, a_velocity_over_place_and_time_is_the_cubic_of_its_points);
    tcase_add_loop_test(test, points_that_make_no_profile_are_refused, 0, 8);
    tcase_add_loop_test(test, sound_leaves, 0, 3);
    tcase_add_test(test, a_tank_with_its_own_pressure_at_a_side_stays_at_rest);
    tcase_add_test(test, a_tank_drains_as_through_a_short_tube);
    tcase_add_test(test, a_jet_fills_an_empty_tank);
    tcase_add_test(test, no_void_stays_behind_a_cylinder);
    tcase_add_test(test, no_void_stays_behind_a_corner);
    tcase_add_loop_test(test, a_box_on_the_floor_feels_the_pressure, 0, 2);
    tcase_add_test(test, threads_give_the_same_bits);
    tcase_add_test(test, a_resumed_run_has_the_same_bits);
    tcase_add_loop_test(test, bad_openings_are_refused, 0, FAULTS);
    tcase_add_test(test, a_solid_before_an_opening_is_refused);
    suite_add_tcase(suite, test);
    return suite;
}
