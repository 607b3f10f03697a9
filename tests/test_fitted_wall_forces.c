/* SPDX-License-Identifier: MIT */
/** @file test_fitted_wall_forces.c
 *  Forces on walls with fitted operators, of flows that fits represent: exact. */
#include <math.h>

#include "channel.h"
#include "methods/common/state_equation.h"
#include "methods/fitted/fitted.h"
#include "sim/simulation.h"

/** Water at rest, particles perturbed, between plates without slip, periodic along them. */
static void lay_square(void)
{
    channel_lay(0.5, 0.5, true);
    channel.scene.opening_count = channel.scene.probe_count = 0;
    channel.scene.boundary.left = channel.scene.boundary.right = SPH2D_SIDE_PERIODIC;
    channel.scene.method.operators = SPH2D_OPERATORS_FITTED;
    channel.scene.wall_slip = SPH2D_SLIP_NONE;
    channel.scene.fluid.dynamic_viscosity = 0.001;
    channel.blocks[0].velocity.x = 0;
    channel.blocks[0].perturb.amplitude = 0.2;
}

/** At a distance d from the wall below, or on the left (upright): the velocity along it is a d + b d^2, and away from it
 *  e d, and the pressure rises along it. There fits are exact: force on the liquid by the wall's stress. */
START_TEST(stress_on_walls_is_that_of_the_flow)
{
    const bool upright = _i;
    const double a = 3, b = -4, e = 2, mu = 7, slope = 2;
    lay_square();
    channel.scene.boundary =
        upright ? (sph2d_boundary){SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC}
                : (sph2d_boundary){SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL};
    channel.scene.fluid.dynamic_viscosity = mu;
    channel.scene.method.sound_speed = 10;
    channel_start();
    sph2d__store *f = &channel.sim->system.fluid;
    for (size_t i = 0; i < f->count; ++i) {
        double d = upright ? f->x[i] : f->y[i];
        *(upright ? &f->vy[i] : &f->vx[i]) = a * d + b * d * d;
        *(upright ? &f->vx[i] : &f->vy[i]) = e * d;
        f->density[i] = 1000 + slope * (upright ? f->y[i] : f->x[i]);
    }
    const sph2d__store *w = &channel.sim->system.walls;
    size_t checked = 0;
    for (size_t k = 0; k < w->count; ++k) {
        double along = upright ? w->y[k] : w->x[k], across = upright ? w->x[k] : w->y[k];
        if (!(w->skin[k] > 0) || across > 0 || along < 0.1 || along > 0.4) /* density jumps at the ends of the period */
            continue;
        sph2d__wall_force force = sph2d__fitted_surface_force(&channel.sim->system, k);
        double pressure = sph2d__pressure_of(&channel.sim->system, 1000 + slope * along);
        ck_assert_double_eq_tol(upright ? force.pressure.y : force.pressure.x, 0, 1e-9);
        ck_assert_double_eq_tol(upright ? force.pressure.x : force.pressure.y, pressure * CHANNEL_DX,
                                1e-7 * pressure * CHANNEL_DX);
        ck_assert_double_eq_tol(upright ? force.friction.y : force.friction.x, -mu * a * CHANNEL_DX, 1e-9);
        ck_assert_double_eq_tol(upright ? force.friction.x : force.friction.y, -mu * 2 * e * CHANNEL_DX, 1e-9);
        ++checked;
    }
    ck_assert_uint_ge(checked, 11);
    channel_finish();
}
END_TEST

/** Friction acts on the surface, half a spacing before the boundary particles: shear with slope a before a wall pulls it by F
 *  along it, and turns it about a point at a distance c by c F. An even pressure does not turn it about any point, as arms
 *  are the shortest across the period. */
START_TEST(friction_turns_by_its_distance_from_the_surface)
{
    const bool upright = _i;
    const double a = 3, mu = 7, distance = 0.1;
    lay_square();
    channel.scene.boundary =
        upright ? (sph2d_boundary){SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC}
                : (sph2d_boundary){SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL};
    channel.scene.fluid.dynamic_viscosity = mu;
    channel.scene.method.sound_speed = 10;
    channel.probes[0].kind = SPH2D_PROBE_FORCE;
    channel.probes[0].on = upright ? "left" : "bottom";
    channel.probes[0].at = upright ? (sph2d_vec2){distance, 0.2} : (sph2d_vec2){0.2, distance};
    channel.scene.probe_count = 1;
    channel_start();
    const sph2d__system *s = &channel.sim->system;
    sph2d__store *f = &channel.sim->system.fluid;
    for (size_t i = 0; i < f->count; ++i) {
        f->vx[i] = upright ? 0 : a * f->y[i];
        f->vy[i] = upright ? a * f->x[i] : 0;
        f->density[i] = 1002;
    }
    sph2d__loads_find(channel.sim, 1);
    const sph2d__pull friction = channel.sim->loads.states[0].friction, press = channel.sim->loads.states[0].pressure;
    const double along = upright ? friction.y : friction.x, across = upright ? press.x : press.y;
    const double pressure = sph2d__pressure_of(s, 1002);
    ck_assert_double_eq_tol(along, mu * a * 0.5, 1e-9);
    ck_assert_double_eq_tol(friction.torque, (upright ? -distance : distance) * along, 1e-9);
    ck_assert_double_gt(pressure, 100);
    ck_assert_double_eq_tol(across, -pressure * 0.5, 1e-7 * pressure);
    ck_assert_double_eq_tol(press.torque, 0, 1e-7 * pressure);
    channel_finish();
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
    lay_square();
    channel.scene.gravity.y = g;
    channel.scene.method.sound_speed = c0;
    channel_start();
    const sph2d__system *s = &channel.sim->system;
    sph2d__store *f = &channel.sim->system.fluid;
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
        ck_assert_double_eq_tol(sph2d__fitted_surface_force(s, k).pressure.y, pressure * CHANNEL_DX, 1e-6);
        ++checked;
    }
    ck_assert_uint_ge(checked, 11);
    channel_finish();
}
END_TEST

START_TEST(forces_on_a_flow_balance_its_weight)
{
    /* Between plates, driven along them: in the end the walls hold what drives it, rho g times the area. */
    lay_square();
    channel.scene.fluid.dynamic_viscosity = 100;
    channel.scene.gravity.x = 1;
    for (int k = 0; k < 2; ++k) {
        channel.probes[k].kind = SPH2D_PROBE_FORCE;
        channel.probes[k].on = k == 0 ? NULL : "bottom";
        channel.probes[k].at = (sph2d_vec2){0.25, 0.25};
    }
    channel.scene.probe_count = 2;
    channel_start();
    channel_run_until(3); /* 12 h^2/(pi^2 nu) */
    double v[SPH2D_PROBE_MAX_COLUMNS];
    ck_assert_uint_eq(sph2d_sim_probe(channel.sim, 0, v), 12);
    ck_assert_double_eq_tol(v[0], 1000 * 0.25, 0.002 * 250);
    ck_assert_double_eq_tol(v[5], v[0], 0.01); /* by friction */
    ck_assert_uint_eq(sph2d_sim_probe(channel.sim, 1, v), 12);
    ck_assert_double_eq_tol(v[2], 0.25 * v[5], 0.01 * 0.25 * v[5]); /* which acts on the surface */
    channel_finish();
}
END_TEST

Suite *suite_fitted_wall_forces(void)
{
    Suite *suite = suite_create("fitted_wall_forces");
    TCase *tests = tcase_create("fitted_wall_forces");
    tcase_add_loop_test(tests, friction_turns_by_its_distance_from_the_surface, 0, 2);
    tcase_add_loop_test(tests, stress_on_walls_is_that_of_the_flow, 0, 2);
    tcase_add_test(tests, pressure_on_walls_is_that_of_least_squares);
    suite_add_tcase(suite, tests);
    TCase *slow = test_long(suite);
    tcase_add_test(slow, forces_on_a_flow_balance_its_weight);
    return suite;
}
