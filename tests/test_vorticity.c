/* SPDX-License-Identifier: MIT */
/** @file test_vorticity.c
 *  Vorticity at particles: exact for linear velocities, with free surfaces, the order of its error in a Taylor-Green vortex,
 *  what stray particles and values that are not finite do, and nonsense. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common.h"
#include "scene/derive.h"
#include "sph2d/field.h"

enum { MOST = 128 * 128 };
static double x[MOST], y[MOST], vx[MOST], vy[MOST], out[MOST];

/** A disc of liquid in disorder; the number of its particles. */
static size_t lay_disc(double spacing)
{
    size_t count = 0;
    for (int row = 0; row < 60; ++row)
        for (int column = 0; column < 60; ++column) {
            const double at = (column - 29.5) * spacing, up = (row - 29.5) * spacing;
            if (hypot(at, up) > 28 * spacing)
                continue;
            x[count] = 3 + at + 0.2 * spacing * sin(7.0 * row + 3.0 * column);
            y[count] = -2 + up + 0.2 * spacing * cos(5.0 * row - 11.0 * column);
            ++count;
        }
    return count;
}

/** A rotation, a shear, and one with strain and divergence: exact for each particle, also at the surface. */
START_TEST(linear_velocities_are_exact)
{
    static const struct {
        double vx_x, vx_y, vy_x, vy_y;
    } flows[] = {{0, -1.5, 1.5, 0}, {0, 4, 0, 0}, {0, 0, -7, 0}, {2, 3, 5, -1}, {1, 2, 2, -1}};
    for (int k = 0; k < 5; ++k)
        for (int scale = 0; scale < 2; ++scale) {
            const double spacing = scale ? 1e-6 : 0.01;
            const size_t count = lay_disc(spacing);
            for (size_t i = 0; i < count; ++i) {
                vx[i] = 0.3 + flows[k].vx_x * (x[i] - 3) + flows[k].vx_y * (y[i] + 2);
                vy[i] = 8 + flows[k].vy_x * (x[i] - 3) + flows[k].vy_y * (y[i] + 2);
            }
            ck_assert_int_eq(sph2d_vorticity(count, x, y, vx, vy, spacing, out, NULL), SPH2D_OK);
            for (size_t i = 0; i < count; ++i)
                ck_assert_double_eq_tol(out[i], flows[k].vy_x - flows[k].vx_y, scale ? 1e-7 : 1e-11);
        }
}
END_TEST

/** The root of the mean square of the error over the largest vorticity, in a period of u = sin kx cos ky, v = -cos kx sin
 *  ky on a lattice or in disorder, with surfaces all around: of all particles, and of those that see none. */
static void find_errors(int across, double disorder, double errors[2])
{
    const double k = 2 * 3.14159265358979324, spacing = 1.0 / across, seen = 3.5 * spacing;
    const size_t count = (size_t)across * (size_t)across;
    for (size_t i = 0; i < count; ++i) {
        const double column = (double)(i % (size_t)across), row = (double)(i / (size_t)across);
        x[i] = (column + 0.5 + disorder * sin(12.9 * (double)i)) * spacing;
        y[i] = (row + 0.5 + disorder * cos(78.2 * (double)i)) * spacing;
        vx[i] = sin(k * x[i]) * cos(k * y[i]);
        vy[i] = -cos(k * x[i]) * sin(k * y[i]);
    }
    ck_assert_int_eq(sph2d_vorticity(count, x, y, vx, vy, spacing, out, NULL), SPH2D_OK);
    double squares[2] = {0}, numbers[2] = {0};
    for (size_t i = 0; i < count; ++i) {
        const double square = pow(out[i] / (2 * k) - sin(k * x[i]) * sin(k * y[i]), 2);
        const bool inside = fmin(fmin(x[i], 1 - x[i]), fmin(y[i], 1 - y[i])) > seen;
        for (int part = 0; part <= inside; ++part) {
            squares[part] += square;
            ++numbers[part];
        }
    }
    for (int part = 0; part < 2; ++part)
        errors[part] = sqrt(squares[part] / numbers[part]);
}

/** Of first order at surfaces, so that the mean with them is of order 1.5, and of second order where particles are all
 *  around, also in disorder. */
START_TEST(errors_fall_with_the_spacing)
{
    static const double bounds[2] = {0.04, 0.025}, orders[2] = {1.4, 1.85};
    for (int disordered = 0; disordered < 2; ++disordered) {
        double errors[3][2];
        for (int k = 0; k < 3; ++k)
            find_errors(32 << k, 0.2 * disordered, errors[k]);
        for (int part = 0; part < 2; ++part) {
            ck_assert_double_lt(errors[0][part], bounds[part]);
            for (int k = 1; k < 3; ++k)
                ck_assert_double_gt(log2(errors[k - 1][part] / errors[k][part]), orders[part]);
        }
    }
}
END_TEST

/** Order and strays do not matter: the same bits for the same particles. */
START_TEST(the_order_of_particles_does_not_matter)
{
    static double reversed[5][MOST];
    const size_t count = lay_disc(0.01);
    for (size_t i = 0; i < count; ++i) {
        vx[i] = sin(30 * y[i]);
        vy[i] = cos(20 * x[i]);
    }
    ck_assert_int_eq(sph2d_vorticity(count, x, y, vx, vy, 0.01, out, NULL), SPH2D_OK);
    for (size_t i = 0; i < count; ++i) {
        reversed[0][i] = x[count - 1 - i];
        reversed[1][i] = y[count - 1 - i];
        reversed[2][i] = vx[count - 1 - i];
        reversed[3][i] = vy[count - 1 - i];
    }
    ck_assert_int_eq(
        sph2d_vorticity(count, reversed[0], reversed[1], reversed[2], reversed[3], 0.01, reversed[4], NULL), SPH2D_OK);
    for (size_t i = 0; i < count; ++i)
        ck_assert(out[i] == reversed[4][count - 1 - i]);
}
END_TEST

/** Where it does not exist: particles alone, in pairs, on a line, not finite; others do not feel those. */
START_TEST(what_has_no_vorticity_is_nan)
{
    const size_t count = lay_disc(0.01);
    for (size_t i = 0; i < count; ++i) {
        vx[i] = -2 * y[i];
        vy[i] = 2 * x[i];
    }
    const double odd[] = {NAN, INFINITY, -INFINITY};
    for (int k = 0; k < 3; ++k) {
        x[200 + k] = odd[k];
        y[300 + k] = odd[k];
        vx[400 + k] = odd[k];
        vy[500 + k] = odd[k];
    }
    x[600] = 1e300; /* alone, far away */
    y[601] = -DBL_MAX;
    x[602] = y[602] = 50;
    for (size_t i = 603; i < 610; ++i) { /* a line */
        x[i] = 60 + 0.01 * (double)i;
        y[i] = 60 + 0.005 * (double)i;
    }
    ck_assert_int_eq(sph2d_vorticity(count, x, y, vx, vy, 0.01, out, NULL), SPH2D_OK);
    for (size_t i = 0; i < count; ++i) {
        const bool none = (i >= 200 && i < 203) || (i >= 300 && i < 303) || (i >= 400 && i < 403) ||
                          (i >= 500 && i < 503) || (i >= 600 && i < 610);
        ck_assert_msg(none ? isnan(out[i]) : fabs(out[i] - 4) < 1e-10, "particle %zu: %g", i, out[i]);
    }
    for (size_t i = 0; i < count; ++i)
        x[i] = y[i] = 1; /* all at one place */
    ck_assert_int_eq(sph2d_vorticity(count, x, y, vx, vy, 0.01, out, NULL), SPH2D_OK);
    for (size_t i = 0; i < count; ++i)
        ck_assert(isnan(out[i]));
    vx[0] = DBL_MAX; /* differences beyond the largest number */
    vx[1] = -DBL_MAX;
    x[0] = 1.01;
    y[1] = 1.01;
    ck_assert_int_eq(sph2d_vorticity(2, x, y, vx, vy, 0.01, out, NULL), SPH2D_OK);
    ck_assert(isnan(out[0]) && isnan(out[1]));
}
END_TEST

/** A scene's colour bar reaches ten times the speed of a fall over the smaller side of the domain, to either side. */
START_TEST(scenes_have_a_range_for_it)
{
    sph2d_block block = {.shape = {.kind = SPH2D_SHAPE_BOX, .box = {{0, 0}, {1, 0.5}}}};
    sph2d_scene scene = sph2d_scene_default();
    scene.domain = (sph2d_box){{0, 0}, {4, 2}};
    scene.gravity = (sph2d_vec2){0, -9};
    scene.spacing = 0.05;
    scene.blocks = &block;
    scene.block_count = 1;
    scene.run.frames.color = "vorticity";
    scene.run.frames.streamlines = SPH2D_SWITCH_ON;
    sph2d_frames frames = test_world(&scene)->scene.run.frames;
    ck_assert_double_eq_tol(frames.color_range.y, 10 * sqrt(2 * 9 * 0.5) / 2, 1e-12);
    ck_assert(frames.color_range.x == -frames.color_range.y);
    ck_assert_double_eq_tol(frames.arrow_speed, sqrt(2 * 9 * 0.5), 1e-12);
    scene.run.frames.color_range = (sph2d_vec2){-1, 3};
    frames = test_world(&scene)->scene.run.frames;
    ck_assert(frames.color_range.x == -1 && frames.color_range.y == 3);
    scene.gravity = (sph2d_vec2){0, 0}; /* that of each frame */
    scene.run.frames.color_range = (sph2d_vec2){0, 0};
    frames = test_world(&scene)->scene.run.frames;
    ck_assert(frames.color_range.x == 0 && frames.color_range.y == 0);
}
END_TEST

START_TEST(nonsense_is_refused)
{
    const double bad[] = {0, -1, NAN, INFINITY, -INFINITY};
    for (int k = 0; k < 5; ++k) {
        sph2d_report report = {0};
        ck_assert_int_eq(sph2d_vorticity(1, x, y, vx, vy, bad[k], out, &report), SPH2D_INVALID);
        ck_assert_msg(strstr(report.items[0].message, "spacing"), "%s", report.items[0].message);
        sph2d_report_clear(&report);
    }
    ck_assert_int_eq(sph2d_vorticity(0, NULL, NULL, NULL, NULL, 1, NULL, NULL), SPH2D_OK);
    const size_t count = lay_disc(0.01);
    const double odd[] = {DBL_MIN, 1e-320, DBL_MAX / 8, 1e10};
    for (int k = 0; k < 4; ++k)
        ck_assert_int_eq(sph2d_vorticity(count < 100 ? count : 100, x, y, vx, vy, odd[k], out, NULL), SPH2D_OK);
}
END_TEST

Suite *suite_vorticity(void)
{
    Suite *suite = suite_create("vorticity");
    TCase *cases = tcase_create("vorticity");
    tcase_add_test(cases, linear_velocities_are_exact);
    tcase_add_test(cases, errors_fall_with_the_spacing);
    tcase_add_test(cases, the_order_of_particles_does_not_matter);
    tcase_add_test(cases, what_has_no_vorticity_is_nan);
    tcase_add_test(cases, scenes_have_a_range_for_it);
    tcase_add_test(cases, nonsense_is_refused);
    suite_add_tcase(suite, cases);
    return suite;
}
