/* SPDX-License-Identifier: MIT */
/** @file test_fitted_openings.c
 *  Openings with fitted operators, beside what test_openings.c holds for both: how disorder and sound leave, and how
 *  particles in reservoirs move. */
#include <math.h>
#include <string.h>

#include "channel.h"
#include "sim/simulation.h"

/** A channel of water with no slip at its walls, whose particles are perturbed and move at a speed. */
static void lay_fitted(double width, double height, bool walls, double speed)
{
    channel_lay(width, height, walls);
    channel.scene.method.operators = SPH2D_OPERATORS_FITTED;
    channel.scene.wall_slip = SPH2D_SLIP_NONE;
    channel.scene.fluid.dynamic_viscosity = 0.001;
    channel.blocks[0].velocity.x = speed;
    channel.blocks[0].perturb.amplitude = 0.2;
}

START_TEST(disorder_leaves_with_the_stream)
{
    lay_fitted(1, 0.5, false, 1);
    channel_start();
    uint64_t at_start = sph2d_sim_summary(channel.sim).particles;
    channel_run_until(3);
    sph2d_view f = sph2d_sim_fluid(channel.sim);
    for (size_t i = 0; i < f.count; ++i) {
        ck_assert_double_le(fabs(f.vx[i] - 1), 1e-3);
        ck_assert_double_le(fabs(f.vy[i]), 1e-3);
        ck_assert_double_le(fabs(f.pressure[i]), 0.01 * 1000);
    }
    sph2d_summary s = sph2d_sim_summary(channel.sim);
    ck_assert_uint_eq(s.particles, at_start + s.let_in - s.let_out);
    ck_assert_uint_ge(s.let_in, 3 * 40 * 20 - 20);
    ck_assert_uint_le(s.let_in, 3 * 40 * 20 + 20);
    ck_assert_double_le(fabs(s.energy_error), 1e-3 * s.energy_scale);
    channel_reading out = channel_read(1);
    ck_assert_double_le(fabs(out.velocity + 1), 1e-3);
    ck_assert_double_le(fabs(out.let_in + 3 * 0.5), 0.5 * CHANNEL_DX); /* m^2 that left, to a column */
    channel_finish();
}
END_TEST

START_TEST(particles_in_reservoirs_move_as_prescribed)
{
    lay_fitted(1, 0.5, true, 1);
    channel.openings[0].profile = SPH2D_OPENING_PROFILE_PARABOLA;
    channel_start();
    test_steps(channel.sim, 20);
    const sph2d__store *f = &channel.sim->system.fluid;
    enum { MOST = 2000 };
    static double x[MOST], vx[MOST];
    size_t checked = 0;
    memset(vx, 0, sizeof vx);
    for (size_t i = 0; i < f->count; ++i)
        if (f->x[i] < -CHANNEL_DX && f->id[i] < MOST) {
            x[f->id[i]] = f->x[i];
            vx[f->id[i]] = f->vx[i];
        }
    double before = sph2d_sim_time(channel.sim);
    test_steps(channel.sim, 1);
    double dt = sph2d_sim_time(channel.sim) - before;
    for (size_t i = 0; i < f->count; ++i)
        if (f->id[i] < MOST && vx[f->id[i]] > 0) {
            ck_assert_double_eq_tol(f->x[i], x[f->id[i]] + dt * vx[f->id[i]], 1e-12);
            ++checked;
        }
    ck_assert_uint_ge(checked, 40);
    channel_finish();
}
END_TEST

START_TEST(sound_leaves)
{
    lay_fitted(2, 0.3, false, 0);
    channel.scene.method.sound_speed = 10;
    channel.blocks[0].perturb.amplitude = 0;
    channel.openings[0].velocity = _i == 0 ? 0 : NAN;
    channel.openings[0].pressure = _i == 1 ? 0 : NAN;
    if (_i == 2) /* a closed tube keeps it */
        channel.scene.opening_count = channel.scene.probe_count = 0;
    channel_start();
    sph2d__store *f = &channel.sim->system.fluid;
    double before = 0, after = 0, most = 0;
    for (size_t i = 0; i < f->count; ++i) {
        double z = (f->x[i] - 1) / 0.2;
        f->density[i] = 1000 + 2 * exp(-z * z);
        before += pow(f->density[i] - 1000, 2);
    }
    channel_run_until(0.4); /* three quarters of the way from the middle to the side and beyond it */
    for (size_t i = 0; i < f->count; ++i) {
        most += f->density[i] / (double)f->count;
        after += pow(f->density[i] - 1000, 2) + 1e4 * f->vx[i] * f->vx[i];
    }
    if (_i == 2)
        ck_assert_double_ge(after, 0.8 * before);
    else
        ck_assert_double_le(after, 0.3 * before);
    ck_assert_double_le(fabs(most - 1000), 0.5);
    channel_finish();
}
END_TEST

Suite *suite_fitted_openings(void)
{
    Suite *suite = suite_create("fitted_openings");
    TCase *tests = tcase_create("fitted_openings");
    tcase_add_test(tests, disorder_leaves_with_the_stream);
    tcase_add_test(tests, particles_in_reservoirs_move_as_prescribed);
    tcase_add_loop_test(tests, sound_leaves, 0, 3);
    suite_add_tcase(suite, tests);
    return suite;
}
