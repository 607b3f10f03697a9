/* SPDX-License-Identifier: MIT */
/** @file test_wcsph.c
 *  One evaluation of method `wcsph` with symmetric operators against sums over all pairs, for random clouds with random
 *  velocities and densities: the rates of density below, the forces of all_pairs.h, and how long a step may be.
 *
 *      drho_i = sum m_j v_ij . grad W + delta h c0 sum V_j psi_ij . grad W + w . grad rho_i        h = H/2 */
#include <math.h>

#include "all_pairs.h"
#include "methods/common/state_equation.h"
#include "methods/terms/shift.h"
#include "methods/wcsph/wcsph.h"

/* ---- density ----------------------------------------------------------------------------------------------------- */

/** Density gradient of particle i, exact for linear density: M^-1 sum V_j (rho_j - rho_i) grad W. */
static sph2d_vec2 density_slope(const sph2d__system *s, size_t i)
{
    double xx = 0, xy = 0, yy = 0, bx = 0, by = 0;
    for (size_t j = 0; j < s->fluid.count; ++j) {
        other o = other_of(s, i, &s->fluid, j);
        double v = o.mass / o.density * o.slope, d = o.density - s->fluid.density[i];
        xx -= v * o.dx * o.dx;
        xy -= v * o.dx * o.dy;
        yy -= v * o.dy * o.dy;
        bx += v * d * o.dx;
        by += v * d * o.dy;
    }
    double det = xx * yy - xy * xy;
    return (sph2d_vec2){(yy * bx - xy * by) / det, (xx * by - xy * bx) / det};
}

START_TEST(density_follows_the_divergence)
{
    scene.method.kernel = (sph2d_kernel)_i;
    sph2d__system *s = make(SPH2D_ISA_AUTO);
    sph2d__wcsph.density_rate(s);
    for (size_t i = 0; i < s->fluid.count; ++i) {
        double rate = 0, size = 0;
        for (size_t j = 0; j < s->fluid.count; ++j) {
            other o = other_of(s, i, &s->fluid, j);
            rate += o.mass * (o.vx * o.dx + o.vy * o.dy) * o.slope;
            size += o.mass * fabs((o.vx * o.dx + o.vy * o.dy) * o.slope);
        }
        close_to(s->fluid.density_rate[i], rate, size, "rate", i);
    }
}
END_TEST

START_TEST(density_is_smoothed_as_antuono_says)
{
    scene.method.density_diffusion = 0.17;
    sph2d__system *s = make(SPH2D_ISA_AUTO);
    for (size_t i = 0; i < s->fluid.count; ++i)
        s->fluid.vx[i] = s->fluid.vy[i] = 0;
    sph2d__wcsph.evaluate(s);
    sph2d__wcsph.density_rate(s);
    double h = s->support / 2;
    for (size_t i = 0; i < s->fluid.count; ++i) {
        sph2d_vec2 mine = density_slope(s, i);
        close_to(s->fluid.density_grad_x[i], mine.x, 1e6, "slope x", i);
        close_to(s->fluid.density_grad_y[i], mine.y, 1e6, "slope y", i);
        double rate = 0, size = 0;
        for (size_t j = 0; j < s->fluid.count; ++j) {
            other o = other_of(s, i, &s->fluid, j);
            if (o.r == 0 || o.slope == 0)
                continue;
            double mean_x = (s->fluid.density_grad_x[i] + s->fluid.density_grad_x[j]) / 2;
            double mean_y = (s->fluid.density_grad_y[i] + s->fluid.density_grad_y[j]) / 2;
            double psi = 2 * (s->fluid.density[i] - o.density - mean_x * o.dx - mean_y * o.dy);
            double term = 0.17 * h * C0 * o.mass / o.density * psi * o.slope; /* r/r^2 . r slope */
            rate += term;
            size += fabs(term);
        }
        close_to(s->fluid.density_rate[i], rate, size, "rate", i);
    }
}
END_TEST

START_TEST(linear_density_is_not_smoothed)
{
    scene.method.density_diffusion = 0.1;
    sph2d__system *s = make(SPH2D_ISA_AUTO);
    sph2d__store *f = &s->fluid;
    for (size_t i = 0; i < f->count; ++i) {
        f->vx[i] = f->vy[i] = 0;
        f->density[i] = RHO0 + 30 * f->x[i] - 50 * f->y[i];
    }
    sph2d__wcsph.evaluate(s);
    sph2d__wcsph.density_rate(s);
    for (size_t i = 0; i < f->count; ++i) {
        close_to(f->density_grad_x[i], 30, 1, "slope x", i);
        close_to(f->density_grad_y[i], -50, 1, "slope y", i);
        ck_assert_double_eq_tol(f->density_rate[i], 0, 1e-7); /* of some 1e4 without the slopes */
    }
}
END_TEST

START_TEST(a_dense_spot_spreads)
{
    scene.method.density_diffusion = 0.1;
    sph2d__system *s = make(SPH2D_ISA_AUTO);
    sph2d__store *f = &s->fluid;
    size_t middle = 0;
    double nearest = INFINITY, total = 0;
    for (size_t i = 0; i < f->count; ++i) {
        f->vx[i] = f->vy[i] = 0;
        double r = hypot(f->x[i] - SIDE * DX / 2, f->y[i] - SIDE * DX / 2);
        f->density[i] = RHO0 * (1 + 0.01 * exp(-r * r / (2 * DX * 2 * DX)));
        if (r < nearest) {
            nearest = r;
            middle = i;
        }
    }
    sph2d__wcsph.evaluate(s);
    sph2d__wcsph.density_rate(s);
    ck_assert_double_lt(f->density_rate[middle], 0);
    for (size_t i = 0; i < f->count; ++i)
        total += f->density_rate[i] / f->density[i]; /* V_i V_j terms cancel in pairs */
    ck_assert_double_eq_tol(total, 0, 1e-9 * fabs(f->density_rate[middle]));
}
END_TEST

/* ---- force ------------------------------------------------------------------------------------------------------- */

/** The forces of the scene by each instruction set that is there. */
static void check_every_instruction_set(void)
{
    for (int isa = SPH2D_ISA_BASELINE; isa <= SPH2D_ISA_AVX512; ++isa) {
        if (!sph2d_isa_available((sph2d_isa)isa))
            continue;
        sph2d__system *s = make((sph2d_isa)isa);
        sph2d__wcsph.evaluate(s);
        check_forces(s);
        finish();
    }
}

START_TEST(forces_are_those_of_all_pairs)
{
    scene.fluid.dynamic_viscosity = _i & 1 ? 3 : 0;
    scene.method.viscosity_form = _i & 2 ? SPH2D_VISCOSITY_MONAGHAN : SPH2D_VISCOSITY_MORRIS;
    scene.method.artificial_viscosity = _i & 4 ? 0.07 : 0;
    scene.method.state_equation = _i & 8 ? SPH2D_STATE_TAIT : SPH2D_STATE_LINEAR;
    scene.method.kernel = _i & 4 ? SPH2D_KERNEL_WENDLAND_C4 : SPH2D_KERNEL_WENDLAND_C2;
    scene.method.density_diffusion = _i & 16 ? 0.1 : 0; /* other copies of the loops */
    check_every_instruction_set();
}
END_TEST

START_TEST(forces_are_those_of_the_kernel)
{
    scene.fluid.dynamic_viscosity = 3;
    scene.method.kernel = (sph2d_kernel)_i;
    check_every_instruction_set();
}
END_TEST

START_TEST(eddies_damp_as_smagorinsky_says)
{
    scene.method.turbulence = SPH2D_TURBULENCE_SMAGORINSKY;
    scene.fluid.dynamic_viscosity = _i & 1 ? 3 : 0;
    scene.method.viscosity_form = _i & 2 ? SPH2D_VISCOSITY_MONAGHAN : SPH2D_VISCOSITY_MORRIS;
    check_every_instruction_set();
}
END_TEST

/* Velocities that are linear, whatever the lattice: the second evaluation knows the gradients that the first rate
 * found. */
START_TEST(eddies_leave_smooth_strain_alone)
{
    scene.method.turbulence = SPH2D_TURBULENCE_SMAGORINSKY;
    sph2d__system *s = make(SPH2D_ISA_AUTO);
    sph2d__store *f = &s->fluid;
    double with[2] = {0, 0}, without[2] = {0, 0};
    for (int rough = 0; rough <= 1; ++rough) {
        for (size_t i = 0; i < f->count; ++i) {
            f->vx[i] = 2 * f->x[i] - 5 * f->y[i] + (rough && i % 2 ? 0.1 : 0);
            f->vy[i] = 3 * f->x[i] - 2 * f->y[i];
            f->stretch[i] = 2;
            f->shear[i] = -1;
        }
        s->method.turbulence = SPH2D_TURBULENCE_SMAGORINSKY;
        sph2d__wcsph.evaluate(s);
        for (size_t i = 0; i < f->count; ++i)
            with[rough] += f->ax[i] * f->vx[i] + f->ay[i] * f->vy[i];
        s->method.turbulence = SPH2D_TURBULENCE_NONE;
        sph2d__wcsph.evaluate(s);
        for (size_t i = 0; i < f->count; ++i)
            without[rough] += f->ax[i] * f->vx[i] + f->ay[i] * f->vy[i];
    }
    ck_assert_double_eq_tol(with[0], without[0], 1e-9 * fabs(without[0]));
    ck_assert_double_lt(with[1], without[1] - 1e-6 * fabs(without[1]));
}
END_TEST

/* What is strained within less than ten steps is strained by an accident, and no step stands the viscosity of it. */
START_TEST(strain_is_no_more_than_a_step_stands)
{
    scene.method.turbulence = SPH2D_TURBULENCE_SMAGORINSKY;
    sph2d__system *s = make(SPH2D_ISA_AUTO);
    const sph2d__store *f = &s->fluid;
    sph2d__wcsph.density_rate(s);
    double most = 0;
    for (size_t i = 0; i < f->count; ++i)
        most = fmax(most, sph2d__strain_rate(f, i));
    ck_assert_double_gt(most, 1);
    s->step = 0.067 * acos(-1) / 7 / 0.27 / (most / 2); /* 0.27 is 3 (2 C)^2 */
    sph2d__wcsph.density_rate(s);
    size_t held = 0;
    for (size_t i = 0; i < f->count; ++i) {
        double strain = sph2d__strain_rate(f, i), largest = most / 2;
        ck_assert_double_le(strain, largest * (1 + 1e-12));
        held += strain > largest * (1 - 1e-12);
    }
    ck_assert(held > 0 && held < f->count);
}
END_TEST

START_TEST(pressure_follows_the_equation_of_state)
{
    scene.method.state_equation = _i ? SPH2D_STATE_TAIT : SPH2D_STATE_LINEAR;
    sph2d__system *s = make(SPH2D_ISA_AUTO);
    sph2d__wcsph.evaluate(s);
    for (size_t i = 0; i < s->fluid.count; ++i) {
        double x = s->fluid.density[i] / RHO0, b = RHO0 * C0 * C0 / 7;
        double p = _i ? b * (pow(x, 7) - 1) : C0 * C0 * RHO0 * (x - 1);
        close_to(s->fluid.pressure[i], p, b, "pressure", i);
        close_to(sph2d__density_of(s, p), s->fluid.density[i], RHO0, "density", i);
    }
    for (double rho = 0.95 * RHO0; rho < 1.06 * RHO0; rho += 11) { /* p/rho^2, also beyond what liquid bears */
        s->tension = 0.02 * RHO0 * C0 * C0;
        double drho = 0.01, e = sph2d__elastic_of(s, rho + drho) - sph2d__elastic_of(s, rho - drho);
        ck_assert_double_eq_tol(e / (2 * drho), sph2d__pressure_of(s, rho) / (rho * rho), 1e-8);
    }
    ck_assert_double_eq_tol(sph2d__elastic_of(s, RHO0), 0, 1e-15);
    ck_assert(sph2d__pressure_of(s, 0.9 * RHO0) == -0.02 * RHO0 * C0 * C0);
    double step = 1e-4, low = sph2d__pressure_of(s, 1010 - step), high = sph2d__pressure_of(s, 1010 + step);
    double rise = (high - low) / (2 * step);
    ck_assert_double_eq_tol(sph2d__sound_speed2_at(s, 1010), rise, 1e-5 * rise);
    ck_assert_double_eq_tol(sph2d__sound_speed2_at(s, RHO0), C0 * C0, 1e-9);
}
END_TEST

/* u = (a y^2, 0): a_x = nu 2 a in both forms. */
START_TEST(viscosity_is_that_of_the_liquid)
{
    scene.fluid.dynamic_viscosity = 5;
    scene.method.viscosity_form = _i ? SPH2D_VISCOSITY_MONAGHAN : SPH2D_VISCOSITY_MORRIS;
    scene.method.support_ratio = 4;
    block.perturb.amplitude = 0;
    sph2d__system *s = make(SPH2D_ISA_AUTO);
    sph2d__store *f = &s->fluid;
    double middle = SIDE * DX / 2, a = 40;
    for (size_t i = 0; i < f->count; ++i) {
        f->density[i] = RHO0;
        f->vx[i] = a * (f->y[i] - middle) * (f->y[i] - middle);
        f->vy[i] = 0;
    }
    sph2d__wcsph.evaluate(s);
    for (size_t i = 0; i < f->count; ++i)
        if (fabs(f->x[i] - middle) < 1.1 * DX && fabs(f->y[i] - middle) < 1.1 * DX)
            ck_assert_double_eq_tol(f->ax[i], 5.0 / RHO0 * 2 * a, 0.01 * 5.0 / RHO0 * 2 * a);
}
END_TEST

/* ---- steps ------------------------------------------------------------------------------------------------------- */

START_TEST(steps_are_as_long_as_is_stable)
{
    scene.method.cfl = 0.25;
    scene.method.artificial_viscosity = _i & 8 ? 1 : 0;
    scene.fluid.dynamic_viscosity = _i & 1 ? 400 : 0;
    scene.method.viscosity_form = _i & 2 ? SPH2D_VISCOSITY_MONAGHAN : SPH2D_VISCOSITY_MORRIS;
    scene.method.state_equation = _i & 4 ? SPH2D_STATE_TAIT : SPH2D_STATE_LINEAR;
    scene.method.kernel = _i & 16 ? SPH2D_KERNEL_WENDLAND_C6 : SPH2D_KERNEL_WENDLAND_C2;
    sph2d__system *s = make(SPH2D_ISA_AUTO);
    s->max_density = 1.1 * RHO0;
    double h = s->support, sound = C0 * (_i & 4 ? pow(1.1, 3) : 1);
    double acoustic = 0.25 * h / (sound + 2), force = 0.25 * sqrt(h / 1e5);
    double pi = acos(-1), peak = _i & 16 ? 78 / (7 * pi) : 7 / pi; /* W(0) H^2 */
    double nu = (_i & 1 ? 0.4 * (_i & 2 ? 2 : 1) : 0) + (_i & 8 ? 3 * C0 * h / 16 : 0);
    double viscous = nu > 0 ? 0.067 / peak * h * h / nu : INFINITY;
    if (s->viscous_rate > 0) /* of these disordered particles: test_viscous_step.c */
        viscous = fmin(viscous, 1 / s->viscous_rate);
    sph2d__limit limit;
    double dt = sph2d__wcsph.stable_step(s, 2, 0, &limit);
    ck_assert_double_eq_tol(dt, fmin(acoustic, viscous), 1e-15);
    ck_assert_int_eq(limit, viscous < acoustic ? SPH2D__LIMIT_VISCOUS : SPH2D__LIMIT_ACOUSTIC);
    dt = sph2d__wcsph.stable_step(s, 2, 1e5, &limit);
    ck_assert_double_eq_tol(dt, fmin(fmin(acoustic, viscous), force), 1e-15);
}
END_TEST

Suite *suite_wcsph(void)
{
    Suite *suite = suite_create("wcsph");
    TCase *tests = tcase_create("operators");
    tcase_add_checked_fixture(tests, start, finish);
    tcase_add_loop_test(tests, density_follows_the_divergence, 0, SPH2D_KERNEL_COUNT);
    tcase_add_test(tests, density_is_smoothed_as_antuono_says);
    tcase_add_test(tests, linear_density_is_not_smoothed);
    tcase_add_test(tests, a_dense_spot_spreads);
    tcase_add_loop_test(tests, forces_are_those_of_all_pairs, 0, 32);
    tcase_add_loop_test(tests, forces_are_those_of_the_kernel, 0, SPH2D_KERNEL_COUNT);
    tcase_add_loop_test(tests, eddies_damp_as_smagorinsky_says, 0, 4);
    tcase_add_test(tests, eddies_leave_smooth_strain_alone);
    tcase_add_test(tests, strain_is_no_more_than_a_step_stands);
    tcase_add_loop_test(tests, pressure_follows_the_equation_of_state, 0, 2);
    tcase_add_loop_test(tests, viscosity_is_that_of_the_liquid, 0, 2);
    tcase_add_loop_test(tests, steps_are_as_long_as_is_stable, 0, 32);
    suite_add_tcase(suite, tests);
    return suite;
}
