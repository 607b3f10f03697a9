/* SPDX-License-Identifier: MIT */
/** @file test_fitted_openings.c
 *  Openings with fitted operators: disorder and sound leave, flow between plates keeps its parabola, particles and energy
 *  are accounted for, the same bits for threads and resumed runs; and forces on walls, of flows that fits represent. */
#include <math.h>
#include <string.h>

#include "common.h"
#include "methods/common/state_equation.h"
#include "methods/fitted/fitted.h"
#include "sim/simulation.h"

static const double DX = 0.025;

static struct {
    sph2d_scene scene;
    sph2d_block block;
    sph2d_opening openings[2];
    sph2d_probe probe;
    sph2d_sim *sim;
} c;

/** A channel from an opening with 1 m/s to one with a pressure of 0, full of water that flows as fast, or rests. */
static void lay_channel(double width, double height, bool walls, double speed)
{
    c.scene = test_scene(DX, 0, 0, width, height);
    c.scene.method = sph2d_scene_default().method;
    c.scene.method.operators = SPH2D_OPERATORS_FITTED;
    c.scene.wall_slip = SPH2D_SLIP_NONE;
    c.scene.fluid.dynamic_viscosity = 0.001;
    c.scene.boundary.bottom = c.scene.boundary.top = walls ? SPH2D_SIDE_WALL : SPH2D_SIDE_PERIODIC;
    c.block = test_block(0, 0, width, height);
    c.block.velocity.x = speed;
    c.block.perturb.amplitude = 0.2;
    c.scene.blocks = &c.block;
    c.scene.block_count = 1;
    c.openings[0] = c.openings[1] = sph2d_opening_default();
    c.openings[0].side = SPH2D_SIDE_NAME_LEFT;
    c.openings[0].velocity = 1;
    c.openings[1].side = SPH2D_SIDE_NAME_RIGHT;
    c.openings[1].pressure = 0;
    c.openings[1].name = "out";
    c.scene.openings = c.openings;
    c.scene.opening_count = 2;
    c.probe = sph2d_probe_default();
    c.probe.kind = SPH2D_PROBE_OPENING;
    c.probe.name = c.probe.on = "out";
    c.probe.rate.every = 1;
    c.scene.probes = &c.probe;
    c.scene.probe_count = 1;
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
    c.sim = NULL;
}

/* ---- streams ----------------------------------------------------------------------------------------------------- */

START_TEST(disorder_leaves_with_the_stream)
{
    lay_channel(1, 0.5, false, 1);
    start();
    uint64_t at_start = sph2d_sim_summary(c.sim).particles;
    run_until(3);
    sph2d_view f = sph2d_sim_fluid(c.sim);
    for (size_t i = 0; i < f.count; ++i) {
        ck_assert_double_le(fabs(f.vx[i] - 1), 1e-3);
        ck_assert_double_le(fabs(f.vy[i]), 1e-3);
        ck_assert_double_le(fabs(f.pressure[i]), 0.01 * 1000);
    }
    sph2d_summary s = sph2d_sim_summary(c.sim);
    ck_assert_uint_eq(s.particles, at_start + s.let_in - s.let_out);
    ck_assert_uint_ge(s.let_in, 3 * 40 * 20 - 20);
    ck_assert_uint_le(s.let_in, 3 * 40 * 20 + 20);
    ck_assert_double_le(fabs(s.energy_error), 1e-3 * s.energy_scale);
    double v[SPH2D_PROBE_MAX_COLUMNS];
    ck_assert_uint_eq(sph2d_sim_probe(c.sim, 0, v), 5);
    ck_assert_double_le(fabs(v[0] + 1), 1e-3);
    ck_assert_double_le(fabs(v[2] + 3 * 0.5), 0.5 * DX); /* m^2 that left, to a column */
    finish();
}
END_TEST

/** Developed flow between plates: u = 6 U y (1 - y), dp/dx = -12 mu U. */
START_TEST(flow_between_plates_keeps_its_parabola)
{
    const double mu = 50;
    lay_channel(1, 0.5, true, 0);
    c.scene.fluid.dynamic_viscosity = mu;
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
    double v[SPH2D_PROBE_MAX_COLUMNS];
    ck_assert_uint_eq(sph2d_sim_probe(c.sim, 0, v), 5);
    ck_assert_double_le(fabs(v[3]), -0.5 * DX * exact); /* at the side that which is given, to half a spacing */
    sph2d_summary s = sph2d_sim_summary(c.sim);
    ck_assert_double_gt(s.energy_viscous, 1000);
    ck_assert_double_le(fabs(s.energy_error), 0.03 * s.energy_viscous);
    finish();
}
END_TEST

START_TEST(particles_in_reservoirs_move_as_prescribed)
{
    lay_channel(1, 0.5, true, 1);
    c.openings[0].profile = SPH2D_OPENING_PROFILE_PARABOLA;
    start();
    test_steps(c.sim, 20);
    const sph2d__store *f = &c.sim->system.fluid;
    enum { MOST = 2000 };
    static double x[MOST], vx[MOST];
    size_t checked = 0;
    memset(vx, 0, sizeof vx);
    for (size_t i = 0; i < f->count; ++i)
        if (f->x[i] < -DX && f->id[i] < MOST) {
            x[f->id[i]] = f->x[i];
            vx[f->id[i]] = f->vx[i];
        }
    double before = sph2d_sim_time(c.sim);
    test_steps(c.sim, 1);
    double dt = sph2d_sim_time(c.sim) - before;
    for (size_t i = 0; i < f->count; ++i)
        if (f->id[i] < MOST && vx[f->id[i]] > 0) {
            ck_assert_double_eq_tol(f->x[i], x[f->id[i]] + dt * vx[f->id[i]], 1e-12);
            ++checked;
        }
    ck_assert_uint_ge(checked, 40);
    finish();
}
END_TEST

START_TEST(sound_leaves)
{
    lay_channel(2, 0.3, false, 0);
    c.scene.method.sound_speed = 10;
    c.block.perturb.amplitude = 0;
    c.openings[0].velocity = _i == 0 ? 0 : NAN;
    c.openings[0].pressure = _i == 1 ? 0 : NAN;
    if (_i == 2) /* a closed tube keeps it */
        c.scene.opening_count = c.scene.probe_count = 0;
    start();
    sph2d__store *f = &c.sim->system.fluid;
    double before = 0, after = 0, most = 0;
    for (size_t i = 0; i < f->count; ++i) {
        double z = (f->x[i] - 1) / 0.2;
        f->density[i] = 1000 + 2 * exp(-z * z);
        before += pow(f->density[i] - 1000, 2);
    }
    run_until(0.4); /* three quarters of the way from the middle to the side and beyond it */
    for (size_t i = 0; i < f->count; ++i) {
        most += f->density[i] / (double)f->count;
        after += pow(f->density[i] - 1000, 2) + 1e4 * f->vx[i] * f->vx[i];
    }
    if (_i == 2)
        ck_assert_double_ge(after, 0.8 * before);
    else
        ck_assert_double_le(after, 0.3 * before);
    ck_assert_double_le(fabs(most - 1000), 0.5);
    finish();
}
END_TEST

/* ---- the same bits ----------------------------------------------------------------------------------------------- */

static void compare(sph2d_sim *a, sph2d_sim *b)
{
    sph2d_view p = sph2d_sim_fluid(a), q = sph2d_sim_fluid(b);
    ck_assert_uint_eq(p.count, q.count);
    for (size_t i = 0; i < p.count; ++i) {
        ck_assert_uint_eq(p.id[i], q.id[i]);
        ck_assert(p.x[i] == q.x[i] && p.y[i] == q.y[i] && p.vx[i] == q.vx[i] && p.density[i] == q.density[i]);
    }
    ck_assert(sph2d_sim_summary(a).energy_fed == sph2d_sim_summary(b).energy_fed);
}

START_TEST(threads_and_resumed_runs_give_the_same_bits)
{
    lay_channel(0.6, 0.3, true, 1);
    c.scene.fluid.dynamic_viscosity = 10;
    c.openings[0].from = 0.1;
    c.openings[0].ramp = 0.1;
    c.openings[1].to = 0.2;
    c.scene.method.precision = _i ? SPH2D_PRECISION_MIXED : c.scene.method.precision;
    start();
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = 3;
    sph2d_sim *other = test_create(&c.scene, &options), *resumed = NULL;
    test_steps(c.sim, 150);
    test_steps(other, 150);
    test_state state = test_state_copy(c.sim);
    options.threads = 1;
    ck_assert_int_eq(sph2d_sim_restore(&c.scene, &options, &state.state, &resumed, NULL), SPH2D_OK);
    test_state_free(&state);
    test_steps(c.sim, 150);
    test_steps(other, 150);
    test_steps(resumed, 150);
    ck_assert_uint_gt(sph2d_sim_summary(c.sim).let_in, 0);
    compare(c.sim, other);
    compare(c.sim, resumed);
    sph2d_sim_destroy(other);
    sph2d_sim_destroy(resumed);
    finish();
}
END_TEST

/* ---- forces on walls --------------------------------------------------------------------------------------------- */

/** At a distance d from the wall below, or on the left (upright): the velocity along it is a d + b d^2, and away from it
 *  e d, and the pressure rises along it. There fits are exact: force on the liquid by the wall's stress. */
START_TEST(stress_on_walls_is_that_of_the_flow)
{
    const bool upright = _i;
    const double a = 3, b = -4, e = 2, mu = 7, slope = 2;
    lay_channel(0.5, 0.5, true, 0);
    c.scene.opening_count = c.scene.probe_count = 0;
    c.scene.boundary =
        upright ? (sph2d_boundary){SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC}
                : (sph2d_boundary){SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL};
    c.scene.fluid.dynamic_viscosity = mu;
    c.scene.method.sound_speed = 10;
    start();
    sph2d__store *f = &c.sim->system.fluid;
    for (size_t i = 0; i < f->count; ++i) {
        double d = upright ? f->x[i] : f->y[i];
        *(upright ? &f->vy[i] : &f->vx[i]) = a * d + b * d * d;
        *(upright ? &f->vx[i] : &f->vy[i]) = e * d;
        f->density[i] = 1000 + slope * (upright ? f->y[i] : f->x[i]);
    }
    const sph2d__store *w = &c.sim->system.walls;
    size_t checked = 0;
    for (size_t k = 0; k < w->count; ++k) {
        double along = upright ? w->y[k] : w->x[k], across = upright ? w->x[k] : w->y[k];
        if (!(w->skin[k] > 0) || across > 0 || along < 0.1 || along > 0.4) /* density jumps at the ends of the period */
            continue;
        sph2d__wall_force force = sph2d__fitted_surface_force(&c.sim->system, k);
        double pressure = sph2d__pressure_of(&c.sim->system, 1000 + slope * along);
        ck_assert_double_eq_tol(upright ? force.pressure.y : force.pressure.x, 0, 1e-9);
        ck_assert_double_eq_tol(upright ? force.pressure.x : force.pressure.y, pressure * DX, 1e-7 * pressure * DX);
        ck_assert_double_eq_tol(upright ? force.friction.y : force.friction.x, -mu * a * DX, 1e-9);
        ck_assert_double_eq_tol(upright ? force.friction.x : force.friction.y, -mu * 2 * e * DX, 1e-9);
        ++checked;
    }
    ck_assert_uint_ge(checked, 11);
    finish();
}
END_TEST

enum { TERMS = 6 };

/** Adds an equation with a weight to those of a least-squares fit, whose last column is the right side. */
static void add_row(double fit[TERMS][TERMS + 1], double weight, const double terms[TERMS], double value)
{
    for (int a = 0; a < TERMS; ++a) {
        for (int b = 0; b < TERMS; ++b)
            fit[a][b] += weight * terms[a] * terms[b];
        fit[a][TERMS] += weight * terms[a] * value;
    }
}

/** The constant term of the fit, by Gauss' elimination from the last term on. */
static double constant_of(double fit[TERMS][TERMS + 1])
{
    for (int n = TERMS - 1; n > 0; --n)
        for (int m = 0; m < n; ++m) {
            double part = fit[m][n] / fit[n][n];
            for (int k = 0; k <= TERMS; ++k)
                fit[m][k] -= part * fit[n][k];
        }
    return fit[0][TERMS] / fit[0][0];
}

/** Random densities above a floor that knows their slope, rho g/c0^2, with a tenth of the weight. */
START_TEST(pressure_on_walls_is_that_of_least_squares)
{
    const double g = -3, c0 = 10;
    lay_channel(0.5, 0.5, true, 0);
    c.scene.opening_count = c.scene.probe_count = 0;
    c.scene.boundary.left = c.scene.boundary.right = SPH2D_SIDE_PERIODIC;
    c.scene.gravity.y = g;
    c.scene.method.sound_speed = c0;
    start();
    const sph2d__system *s = &c.sim->system;
    sph2d__store *f = &c.sim->system.fluid;
    const sph2d__store *w = &s->walls;
    uint64_t seed = 7;
    for (size_t i = 0; i < f->count; ++i)
        f->density[i] = 1000 * test_random(&seed, 0.99, 1.01);
    size_t checked = 0;
    for (size_t k = 0; k < w->count; ++k) {
        if (!(w->skin[k] > 0) || w->y[k] > 0 || w->x[k] < 0.1 || w->x[k] > 0.4)
            continue;
        double fit[TERMS][TERMS + 1] = {{0}}, h = s->support;
        for (size_t i = 0; i < f->count; ++i) {
            double x = (f->x[i] - w->x[k]) / h, y = f->y[i] / h, terms[TERMS] = {1, x, y, x * x, x * y, y * y};
            add_row(fit, pow(fmax(1 - hypot(x, y), 0), 3), terms, f->density[i] - 1000);
        }
        for (size_t b = 0; b < w->count; ++b) {
            double x = (w->x[b] - w->x[k]) / h, terms[TERMS] = {0, 0, 1, 0, x, 0};
            if (w->skin[b] > 0 && w->y[b] < 0)
                add_row(fit, 0.1 * pow(fmax(1 - fabs(x), 0), 3), terms, 1000 * g / (c0 * c0) * h);
        }
        double pressure = sph2d__pressure_of(s, 1000 + constant_of(fit));
        ck_assert_double_eq_tol(sph2d__fitted_surface_force(s, k).pressure.y, pressure * DX, 1e-6);
        ++checked;
    }
    ck_assert_uint_ge(checked, 11);
    finish();
}
END_TEST

START_TEST(forces_on_a_flow_balance_its_weight)
{
    /* Between plates, driven along them: in the end the walls hold what drives it, rho g times the area. */
    lay_channel(0.5, 0.5, true, 0);
    c.scene.opening_count = 0;
    c.scene.boundary.left = c.scene.boundary.right = SPH2D_SIDE_PERIODIC;
    c.scene.fluid.dynamic_viscosity = 100;
    c.scene.gravity.x = 1;
    c.probe.kind = SPH2D_PROBE_FORCE;
    c.probe.on = NULL;
    start();
    run_until(3); /* 12 h^2/(pi^2 nu) */
    double v[SPH2D_PROBE_MAX_COLUMNS];
    ck_assert_uint_eq(sph2d_sim_probe(c.sim, 0, v), 12);
    ck_assert_double_eq_tol(v[0], 1000 * 0.25, 0.002 * 250);
    ck_assert_double_eq_tol(v[5], v[0], 0.01); /* by friction */
    finish();
}
END_TEST

/* ---- what is refused --------------------------------------------------------------------------------------------- */

START_TEST(what_has_a_surface_is_refused)
{
    static const char *const paths[] = {"openings[1]", "openings[0]", "blocks"};
    sph2d_report report = {0};
    lay_channel(1, 0.5, true, 0);
    ck_assert_int_eq(sph2d_scene_check(&c.scene, &report), SPH2D_OK);
    c.scene.gravity.y = -9.81;
    if (_i == 0) {
        c.openings[1].pressure = NAN;
        c.openings[1].level = 0.3;
    } else if (_i == 1) {
        c.openings[0].free_surface = SPH2D_SWITCH_ON;
    } else {
        c.block.shape.box.max.y = 0.3;
    }
    ck_assert_int_eq(sph2d_scene_check(&c.scene, &report), SPH2D_SCENE);
    ck_assert_msg(test_report_has(&report, SPH2D_CODE_UNSUPPORTED, paths[_i]), "%s", test_report_text(&report));
    sph2d_report_clear(&report);
}
END_TEST

Suite *suite_fitted_openings(void)
{
    Suite *suite = suite_create("fitted_openings");
    TCase *tests = tcase_create("fitted_openings");
    tcase_add_test(tests, disorder_leaves_with_the_stream);
    tcase_add_test(tests, flow_between_plates_keeps_its_parabola);
    tcase_add_test(tests, particles_in_reservoirs_move_as_prescribed);
    tcase_add_loop_test(tests, sound_leaves, 0, 3);
    tcase_add_loop_test(tests, threads_and_resumed_runs_give_the_same_bits, 0, 2);
    tcase_add_loop_test(tests, stress_on_walls_is_that_of_the_flow, 0, 2);
    tcase_add_test(tests, pressure_on_walls_is_that_of_least_squares);
    tcase_add_test(tests, forces_on_a_flow_balance_its_weight);
    tcase_add_loop_test(tests, what_has_a_surface_is_refused, 0, 3);
    suite_add_tcase(suite, tests);
    return suite;
}
