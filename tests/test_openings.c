/* SPDX-License-Identifier: MIT */
/** @file test_openings.c
 *  Openings: streams stay streams, what flows in and out is counted and its energy known, sound leaves, the same bits
 *  for threads and resumed runs; with both operators. */
#include <math.h>
#include <string.h>

#include "channel.h"
#include "methods/common/state_equation.h"
#include "sim/openings_parts.h"
#include "sim/simulation.h"

/* ---- streams ----------------------------------------------------------------------------------------------------- */

START_TEST(a_stream_stays_a_lattice)
{
    channel_lay(0.5, 0.25, false);
    channel_start();
    uint64_t particles = sph2d_sim_summary(channel.sim).particles;
    /* 20 columns, 10 of a reservoir at each end, whatever the support needs, and 3 of a duct */
    ck_assert_uint_ge(particles, 10 * (20 + 2 * 7 + 3));
    channel_run_until(3);
    sph2d_view f = sph2d_sim_fluid(channel.sim);
    for (size_t i = 0; i < f.count; ++i) {
        ck_assert_double_le(fabs(f.vx[i] - 1), 1e-9);
        ck_assert_double_le(fabs(f.vy[i]), 1e-9);
        ck_assert_double_le(fabs(f.pressure[i]), 1e-6 * 1000);
        double row = f.y[i] / CHANNEL_DX - 0.5;
        ck_assert_double_le(fabs(row - round(row)), 1e-9);
    }
    channel_check_count(particles);
    ck_assert_double_le(fabs((double)f.count - (double)particles), 10); /* a column more or less */
    /* 3 m^2/s times 0.25 m, to the particles of a column */
    channel_reading in = channel_read(0), out = channel_read(1);
    ck_assert_double_le(fabs(in.let_in - 0.75), 0.25 * CHANNEL_DX);
    ck_assert_double_le(fabs(out.let_in + 0.75), 0.25 * CHANNEL_DX);
    ck_assert_double_le(fabs(in.velocity - 1), 1e-9);
    ck_assert_double_le(fabs(out.velocity + 1), 1e-9);
    ck_assert_double_le(fabs(in.flow_rate - 0.25), 1e-9);
    ck_assert_double_eq(in.wet, 0.25);
    sph2d_summary s = sph2d_sim_summary(channel.sim);
    ck_assert_double_le(fabs(s.energy_error), 1e-4 * s.energy_scale);
    channel_finish();
}
END_TEST

START_TEST(disorder_leaves_with_the_stream)
{
    channel_lay(1, 0.5, false);
    channel.blocks[0].perturb.amplitude = 0.2;
    channel_start();
    uint64_t particles = sph2d_sim_summary(channel.sim).particles;
    channel_run_until(4);
    sph2d_view f = sph2d_sim_fluid(channel.sim);
    double square = 0, inside = 0;
    for (size_t i = 0; i < f.count; ++i)
        if (f.x[i] > 0 && f.x[i] < 1) {
            square += f.pressure[i] * f.pressure[i];
            ++inside;
        }
    ck_assert_double_le(sqrt(square / inside), 0.01 * 1000); /* of rho U^2 */
    ck_assert_double_le(fabs(inside - 800), 20);             /* a column */
    channel_check_count(particles);
    channel_finish();
}
END_TEST

START_TEST(a_stream_starts_from_rest)
{
    /* By a flow rate, over a ramp: half of it in the middle of the ramp. */
    channel_lay(1, 0.5, false);
    channel.blocks[0].velocity.x = 0;
    channel.openings[0].velocity = NAN;
    channel.openings[0].flow_rate = 0.5;
    channel.openings[0].ramp = 1;
    channel_start();
    channel_run_until(0.5);
    ck_assert_double_le(fabs(channel_read(0).velocity - 0.5), 0.2);
    channel_run_until(3);
    ck_assert_double_le(fabs(channel_read(0).velocity - 1), 0.01);
    ck_assert_double_le(fabs(channel_read(1).velocity + 1), 0.01);
    channel_finish();
}
END_TEST

START_TEST(flow_between_plates_keeps_its_parabola)
{
    const double mu = 50, slope = 12 * mu / (0.5 * 0.5);
    const bool fitted = _i;
    channel_lay(1, 0.5, true);
    channel.scene.method.operators = fitted ? SPH2D_OPERATORS_FITTED : SPH2D_OPERATORS_VARIATIONAL;
    channel.scene.wall_slip = SPH2D_SLIP_NONE;
    channel.scene.fluid.dynamic_viscosity = mu;
    channel.blocks[0].velocity.x = 0;
    channel.blocks[0].perturb.amplitude = fitted ? 0.2 : 0;
    channel.openings[0].profile = SPH2D_OPENING_PROFILE_PARABOLA;
    channel.openings[0].ramp = 0.2;
    channel_start();
    channel_run_until(2);
    channel_error error = channel_parabola_error();
    ck_assert_double_le(error.velocity, 0.02);
    ck_assert_double_le(fabs(error.slope), 0.04);
    /* at the side the pressure is the given one, to what falls over a spacing or two */
    ck_assert_double_le(fabs(channel_read(1).pressure), (fitted ? 0.5 : 2) * CHANNEL_DX * slope);
    sph2d_summary s = sph2d_sim_summary(channel.sim);
    ck_assert_double_gt(s.energy_viscous, 1000);
    ck_assert_double_le(fabs(s.energy_error), (fitted ? 0.03 : 0.01) * s.energy_viscous);
    channel_finish();
}
END_TEST

/** Largest difference of the velocity of particles in the reservoir of the first opening from f(y), and their number. */
static double worst_in_reservoir(double (*f)(double y, double time), size_t *count)
{
    sph2d_view v = sph2d_sim_fluid(channel.sim);
    double worst = 0;
    *count = 0;
    for (size_t i = 0; i < v.count; ++i)
        if (v.x[i] < 0) {
            worst = fmax(worst, fabs(v.vx[i] - f(v.y[i], sph2d_sim_time(channel.sim))));
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
    channel_lay(1, 0.5, true);
    channel.openings[0].profile = SPH2D_OPENING_PROFILE_TURBULENT;
    channel_start();
    ck_assert_double_le(worst_in_reservoir(power_law, &count), 1e-12);
    ck_assert_uint_gt(count, 100);
    ck_assert_double_le(fabs(sph2d_sim_plan(channel.sim)->sound_speed / 10 - 8.0 / 7), 1e-9);
    double mean = 0;
    sph2d_view v = sph2d_sim_fluid(channel.sim);
    for (size_t i = 0; i < v.count; ++i)
        mean += v.x[i] < 0 ? v.vx[i] / (double)count : 0;
    ck_assert_double_le(fabs(mean - 1), 0.01); /* the mean of 20 lanes is not that of the law */
    channel_finish();
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
    channel_lay(1, 0.5, true);
    for (size_t k = 0; k < 12; ++k) {
        double t = k < 6 ? 0 : 1, y = places[k % 6];
        points[k] = (sph2d_path_point){t, y, given(y, t)};
    }
    channel.openings[0].velocity = NAN;
    channel.openings[0].history.profile = (sph2d_path){points, 12};
}

START_TEST(a_velocity_over_place_and_time_is_the_cubic_of_its_points)
{
    sph2d_path_point points[12];
    size_t count;
    lay_profile(points);
    channel.blocks[0].velocity.x = 1.25;
    channel_start();
    ck_assert_double_le(worst_in_reservoir(given, &count), 1e-12);
    ck_assert_uint_gt(count, 100);
    test_steps(channel.sim, 200); /* sound, that leaves, adds to it */
    ck_assert_double_gt(sph2d_sim_time(channel.sim), 0.1);
    ck_assert_double_le(worst_in_reservoir(given, &count), 0.25);
    channel_run_until(1.5);
    /* the mean over the width: 2 * 1.25 - 2 * 0.5^3/4 */
    ck_assert_double_le(fabs(channel_read(0).velocity - 2.4375), 0.05);
    channel_finish();
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
        channel.openings[0].history.profile.count = 11;
        break;
    case 3: /* back in time */
        for (size_t k = 6; k < 12; ++k)
            points[k].t = -1;
        break;
    case 4: /* not as wide as the opening */
        points[5].x = points[11].x = 0.49;
        break;
    case 5:
        channel.openings[0].profile = SPH2D_OPENING_PROFILE_PARABOLA;
        break;
    case 6:
        channel.openings[0].velocity = 1;
        break;
    default:
        channel.openings[0].free_surface = SPH2D_SWITCH_ON;
        channel.scene.gravity.y = -9.81;
    }
    ck_assert_int_eq(sph2d_scene_check(&channel.scene, &report), SPH2D_SCENE);
    ck_assert_msg(strstr(test_report_text(&report), words[_i]), "%s", test_report_text(&report));
    sph2d_report_clear(&report);
}
END_TEST

/* ---- sound ------------------------------------------------------------------------------------------------------- */

/** Energy of sound: elastic, and kinetic, in liquid that should be at rest. */
static double energy_of_sound(void)
{
    sph2d_summary s = sph2d_sim_summary(channel.sim);
    return s.elastic + s.kinetic;
}

/** Lanes with values that are linear along the line, of liquid that flows out. */
static sph2d__opening *linear_lanes(size_t index)
{
    sph2d__opening *o = &channel.sim->openings.items[index];
    for (size_t k = 0; k < o->lane_count; ++k)
        o->lanes[k] = (sph2d__lane){
            .wet = true, .pressure = 10 + 4 * (double)k, .inward = -1 - 0.1 * (double)k, .sideward = 2 + 3 * (double)k};
    o->now.velocity = 0.13;
    o->now.pressure = 70;
    *o->means = (sph2d__opening_means){.velocity = 0.1, .pressure = 20, .slope = 50, .age = 1};
    return o;
}

/* What a reservoir's particles get (openings.h): with a velocity u = U - (p' - <p'>)/(rho0 c0) and p' of the liquid
 * before it, with a pressure p = P - rho0 c0 (u - <u>) and its velocity, each with the slope <dp'/dn> along the normal.
 * Along the line values are linear between lanes; the sideward velocity of what flows out fades within the support. */
START_TEST(a_reservoir_has_what_is_prescribed)
{
    channel_lay(0.5, 0.25, true);
    channel_start();
    const sph2d__system *s = &channel.sim->system;
    const double impedance = s->rest_density * s->sound_speed;
    for (size_t index = 0; index < 2; ++index) {
        sph2d__opening *o = linear_lanes(index);
        for (int n = 0; n < 20; ++n) {
            const double lane = 0.3 + 0.4 * n, beyond = 0.007 * n;
            const sph2d__spot spot = {(lane + 0.5) * o->lane_width, beyond};
            const sph2d_vec2 at = sph2d__place_of(o, spot);
            const sph2d__prescribed p = sph2d__prescribed_at(channel.sim, o, spot, at.x, at.y);
            const bool velocity = index == 0;
            const double pressure = (velocity ? 10 + 4 * lane : -impedance * (0.13 - 0.1)) - 50 * (beyond + o->duct);
            const double fade = fmax(1 - beyond / s->support, 0);
            ck_assert_double_lt(lane, (double)o->lane_count - 1);
            ck_assert_double_eq_tol(p.inward, velocity ? 1 - (70 - 20) / impedance : -1 - 0.1 * lane, 1e-12);
            ck_assert_double_eq_tol(p.sideward, velocity ? 0 : fade * (2 + 3 * lane), 1e-11);
            ck_assert_double_eq_tol(sph2d__pressure_of(s, p.density), pressure, 1e-6 * impedance);
        }
        for (size_t k = 0; k < o->lane_count; ++k) /* what flows in has no sideward velocity */
            o->lanes[k].inward = 1;
        ck_assert(sph2d__prescribed_at(channel.sim, o, (sph2d__spot){2 * o->lane_width, 0}, 0, 0).sideward == 0);
    }
    channel_finish();
}
END_TEST

/* What is measured before a line is exact for linear fields over liquid at rest, of pressure rho0 g.x: p' and its slope, the
 * velocities along the normal and along the line, in the middle of each lane and in the mean. */
START_TEST(linear_fields_are_measured_as_they_are)
{
    const sph2d_vec2 g = {0.7, -5};
    channel_lay(0.5, 0.25, true);
    channel.scene.gravity = g;
    channel_start();
    const sph2d__system *s = &channel.sim->system;
    sph2d__store *f = &channel.sim->system.fluid;
    for (size_t index = 0; index < 2; ++index) {
        sph2d__opening *o = &channel.sim->openings.items[index];
        const double side = index == 0 ? 0 : 0.5, inward = index == 0 ? 1 : -1, middle = 0.125;
        for (size_t i = 0; i < f->count; ++i) {
            const double distance = inward * (f->x[i] - side) + o->duct, y = f->y[i] - middle;
            const double rest = s->rest_density * (g.x * (f->x[i] - side) + g.y * y);
            f->density[i] = sph2d__density_of(s, 30 + 200 * distance + 80 * y + rest);
            f->vx[i] = inward * (1 + 2 * y);
            f->vy[i] = 0.5 - y;
        }
        o->means->slope = 200;
        sph2d__openings_measure(channel.sim);
        for (size_t k = 0; k < o->lane_count; ++k) {
            const sph2d_vec2 at = sph2d__place_of(o, (sph2d__spot){((double)k + 0.5) * o->lane_width, 0});
            const double y = at.y - middle;
            ck_assert(o->lanes[k].wet);
            ck_assert_double_eq_tol(o->lanes[k].slope, 200, 1e-5);
            ck_assert_double_eq_tol(o->lanes[k].pressure, 30 + 80 * y, 1e-5);
            ck_assert_double_eq_tol(o->lanes[k].inward, 1 + 2 * y, 1e-12);
            ck_assert_double_eq_tol(o->lanes[k].sideward * o->mouth.along.y, 0.5 - y, 1e-12);
        }
        ck_assert_double_eq_tol(o->now.slope, 200, 1e-5);
        ck_assert_double_eq_tol(o->now.pressure, 30, 1e-5);
        ck_assert_double_eq_tol(o->now.velocity, 1, 1e-12);
    }
    channel_finish();
}
END_TEST

START_TEST(sound_leaves)
{
    /* A pulse in the middle goes to both sides: of openings with a velocity, or with a pressure, _i of 2; without
     * openings a closed tube keeps it. */
    channel_lay(2, 0.25, false);
    channel.scene.method.sound_speed = 10;
    channel.scene.fluid.dynamic_viscosity = 0;
    for (int k = 0; k < 3; ++k) {
        channel.blocks[k] = test_block(0.8 * k - (k > 1 ? 0.4 : 0), 0, k == 1 ? 1.2 : 0.8 + 0.6 * k, 0.25);
        channel.blocks[k].velocity.x = 0;
    }
    channel.blocks[2] = test_block(1.2, 0, 2, 0.25);
    channel.blocks[1].spacing = 0.999 * CHANNEL_DX;
    channel.scene.block_count = 3;
    for (int k = 0; k < 2; ++k) {
        channel.openings[k].velocity = _i == 0 ? 0 : NAN;
        channel.openings[k].pressure = _i == 1 ? 0 : NAN;
    }
    if (_i == 2)
        channel.scene.opening_count = channel.scene.probe_count = 0;
    channel_start();
    double before = energy_of_sound();
    channel_run_until(0.3); /* three times the way from the middle to the side */
    if (_i == 2)            /* 0.56: the damping of sound takes the rest, of a pulse with steep ends */
        ck_assert_double_ge(energy_of_sound(), 0.5 * before);
    else /* 0.07 and 0.26 */
        ck_assert_double_le(energy_of_sound(), 0.4 * before);
    channel_finish();
}
END_TEST

/* ---- bits -------------------------------------------------------------------------------------------------------- */

/* By both operators. */
START_TEST(threads_and_resumed_runs_give_the_same_bits)
{
    channel_lay(0.6, 0.3, true);
    channel.scene.fluid.dynamic_viscosity = 10;
    channel.scene.wall_slip = SPH2D_SLIP_NONE;
    channel.scene.method.operators = _i == 0 ? SPH2D_OPERATORS_VARIATIONAL : SPH2D_OPERATORS_FITTED;
    channel.blocks[0].perturb.amplitude = 0.2;
    channel.openings[0].from = 0.1;
    channel.openings[0].ramp = 0.1;
    channel.openings[1].to = 0.2;
    channel_start();
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = 3;
    sph2d_sim *other = test_create(&channel.scene, &options), *resumed = NULL;
    test_steps(channel.sim, 150);
    test_steps(other, 150);
    test_state state = test_state_copy(channel.sim);
    options.threads = 1;
    ck_assert_int_eq(sph2d_sim_restore(&channel.scene, &options, &state.state, &resumed, NULL), SPH2D_OK);
    test_state_free(&state);
    test_steps(channel.sim, 150);
    test_steps(other, 150);
    test_steps(resumed, 150);
    ck_assert_uint_gt(sph2d_sim_summary(channel.sim).let_in, 0);
    channel_compare(channel.sim, other);
    channel_compare(channel.sim, resumed);
    double a[SPH2D_PROBE_MAX_COLUMNS], b[SPH2D_PROBE_MAX_COLUMNS];
    ck_assert_uint_eq(sph2d_sim_probe(channel.sim, 1, a), 5);
    ck_assert_uint_eq(sph2d_sim_probe(resumed, 1, b), 5);
    ck_assert(memcmp(a, b, 5 * sizeof *a) == 0);
    sph2d_sim_destroy(other);
    sph2d_sim_destroy(resumed);
    channel_finish();
}
END_TEST

Suite *suite_openings(void)
{
    Suite *suite = suite_create("openings");
    TCase *test = tcase_create("openings");
    tcase_add_test(test, a_turbulent_profile_is_the_power_law);
    tcase_add_loop_test(test, points_that_make_no_profile_are_refused, 0, 8);
    tcase_add_test(test, a_reservoir_has_what_is_prescribed);
    tcase_add_test(test, linear_fields_are_measured_as_they_are);
    tcase_add_loop_test(test, sound_leaves, 0, 3);
    tcase_add_loop_test(test, threads_and_resumed_runs_give_the_same_bits, 0, 2);
    suite_add_tcase(suite, test);
    TCase *slow = test_long(suite);
    tcase_add_test(slow, a_stream_stays_a_lattice);
    tcase_add_test(slow, disorder_leaves_with_the_stream);
    tcase_add_test(slow, a_stream_starts_from_rest);
    tcase_add_loop_test(slow, flow_between_plates_keeps_its_parabola, 0, 2);
    tcase_add_test(slow, a_velocity_over_place_and_time_is_the_cubic_of_its_points);
    return suite;
}
