/* SPDX-License-Identifier: MIT */
/** @file test_outputs.c
 *  What a run tells: outputs fall due at n times their interval, probes give what their columns say, the summary sums.
 */
#include <math.h>
#include <stdlib.h>

#include "common.h"

static const double DX = 0.01;

/** A still pool with two probes of energy and two of speed. */
static sph2d_sim *pool(sph2d_vec2 velocity, double step, sph2d_rate snapshots, sph2d_rate frames)
{
    sph2d_scene scene = test_open_scene(DX, -5, -5, 5, 5);
    sph2d_block block = test_block(0, 0, 0.2, 0.2);
    block.velocity = velocity;
    sph2d_probe probes[4] = {sph2d_probe_default(), sph2d_probe_default(), sph2d_probe_default(),
                             sph2d_probe_default()};
    static const char *const names[4] = {"a", "b", "c", "d"};
    for (int i = 0; i < 4; ++i) {
        probes[i].name = names[i];
        probes[i].rate.every = 0.07 * (i + 1);
        probes[i].kind = i < 2 ? SPH2D_PROBE_ENERGY : SPH2D_PROBE_SPEED;
    }
    probes[2].at = (sph2d_vec2){0.1, 0.1};
    probes[3].at = (sph2d_vec2){-1, 3};
    scene.blocks = &block;
    scene.block_count = 1;
    scene.probes = probes;
    scene.probe_count = 4;
    scene.method.time_step = step;
    scene.method.support_ratio = 2.6; /* no two places of the lattice are this far apart */
    scene.run.snapshots.rate = snapshots;
    scene.run.frames.rate = frames;
    return test_create(&scene, NULL);
}

START_TEST(rates_tell_interval_and_due_times)
{
    ck_assert(sph2d_rate_interval((sph2d_rate){0, 0}) == 0);
    ck_assert(sph2d_rate_interval((sph2d_rate){4, 0}) == 0.25);
    ck_assert(sph2d_rate_interval((sph2d_rate){0, 0.3}) == 0.3);
    ck_assert(sph2d_rate_due((sph2d_rate){0, 0.3}, 0) == 0);
    ck_assert(sph2d_rate_due((sph2d_rate){60, 0}, 60000000) == 1000000); /* no rounding adds up */
    ck_assert(sph2d_rate_due((sph2d_rate){3, 0}, 9) == 3);
    ck_assert(sph2d_rate_due((sph2d_rate){0, 0.1}, 10) == 1);
}
END_TEST

START_TEST(outputs_fall_due_on_time)
{
    /* Every tenth step, from the first moment on, though the clock's own sum of steps is often a rounding short. */
    sph2d_sim *sim = pool((sph2d_vec2){0, 0}, 0.0007, (sph2d_rate){0, 0}, (sph2d_rate){0, 0.007});
    uint64_t taken = 0;
    size_t wrong = 0, short_of_it = 0;
    for (int n = 0; n <= 1000; ++n) {
        bool due = sph2d_sim_output_due(sim, SPH2D_OUTPUT_FRAME);
        wrong += due != (n % 10 == 0);
        wrong += sph2d_sim_output_due(sim, SPH2D_OUTPUT_SNAPSHOT); /* never asked for */
        if (due) {
            short_of_it += sph2d_sim_time(sim) < (double)taken * 0.007;
            ck_assert_uint_eq(sph2d_sim_output_count(sim, SPH2D_OUTPUT_FRAME), taken++);
            sph2d_sim_output_done(sim, SPH2D_OUTPUT_FRAME);
            wrong += sph2d_sim_output_due(sim, SPH2D_OUTPUT_FRAME);
        }
        test_steps(sim, 1);
    }
    ck_assert_uint_eq(wrong, 0);
    ck_assert_uint_eq(taken, 101);
    ck_assert_uint_gt(short_of_it, 20);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(each_output_has_its_own_clock)
{
    sph2d_sim *sim = pool((sph2d_vec2){0, 0}, 0.001, (sph2d_rate){0, 0.05}, (sph2d_rate){8, 0});
    static const double intervals[6] = {0.05, 0.125, 0.07, 0.14, 0.21, 0.28};
    for (int n = 0; n < 1000; ++n) {
        for (size_t output = 0; output < 6; ++output)
            if (sph2d_sim_output_due(sim, output))
                sph2d_sim_output_done(sim, output);
        test_steps(sim, 1);
    }
    for (size_t output = 0; output < 6; ++output) /* at t = 0 ... 0.999 s */
        ck_assert_uint_eq(sph2d_sim_output_count(sim, output), (uint64_t)floor(0.999 / intervals[output]) + 1);
    ck_assert(!sph2d_sim_output_due(sim, 6));
    ck_assert_uint_eq(sph2d_sim_output_count(sim, 6), 0);
    sph2d_sim_output_done(sim, 6);
    ck_assert_uint_eq(sph2d_sim_output_count(sim, 6), 0);
    sph2d_sim_destroy(sim);
}
END_TEST

static size_t columns_in(const char *header)
{
    size_t count = 1;
    for (const char *p = header; *p; ++p)
        count += *p == ',';
    return count;
}

START_TEST(probes_give_their_columns)
{
    sph2d_sim *sim = pool((sph2d_vec2){0.3, -0.4}, 1e-4, (sph2d_rate){0, 0}, (sph2d_rate){0, 0});
    sph2d_sim_set_gravity(sim, (sph2d_vec2){0, -2});
    test_steps(sim, 20);
    double values[SPH2D_PROBE_MAX_COLUMNS];
    sph2d_summary sum = sph2d_sim_summary(sim);
    ck_assert_uint_eq(sph2d_sim_probe(sim, 0, values), columns_in(sph2d_probe_columns(SPH2D_PROBE_ENERGY)));
    ck_assert(values[0] == sum.kinetic && values[1] == sum.potential && values[2] == sum.momentum[0]);
    ck_assert(values[3] == sum.momentum[1] && values[4] == 400 && values[5] == sum.speed_max);
    double mass = 400 * 1000 * DX * DX, t = 19.5 * 1e-4; /* gravity came with the second half of the first step */
    ck_assert_double_eq_tol(values[2] / (mass * 0.3), 1, 1e-9);
    ck_assert_double_eq_tol(values[3] / (mass * (-0.4 - 2 * t)), 1, 1e-9);
    ck_assert_double_eq_tol(values[1] / (mass * 2 * 5.1), 1, 1e-3);
    /* The kernel average of a uniform velocity is that velocity; beside the liquid there is none. */
    ck_assert_uint_eq(sph2d_sim_probe(sim, 2, values), columns_in(sph2d_probe_columns(SPH2D_PROBE_SPEED)));
    ck_assert_double_eq_tol(values[0], 0.3, 1e-6);
    ck_assert_double_eq_tol(values[1], -0.4 - 2 * t, 1e-6);
    ck_assert_double_eq_tol(values[2], hypot(values[0], values[1]), 1e-15);
    sph2d_view f = sph2d_sim_fluid(sim);
    double near = 0;
    for (size_t i = 0; i < f.count; ++i)
        near += hypot(f.x[i] - 0.1, f.y[i] - 0.1) < 2.6 * DX;
    ck_assert(values[3] == near && near > 15);
    ck_assert_uint_eq(sph2d_sim_probe(sim, 3, values), 4);
    ck_assert(isnan(values[0]) && isnan(values[1]) && isnan(values[2]) && values[3] == 0);
    ck_assert_uint_eq(sph2d_sim_probe(sim, 4, values), 0);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(a_speed_probe_weighs_with_a_kernel)
{
    /* Two particles at 0.5 and 1.5 spacings from the place, each with its own velocity, H = 2 dx: Wendland weights. */
    sph2d_scene scene = test_open_scene(DX, -1, -1, 1, 1);
    sph2d_block blocks[2] = {test_particle(DX, 0.5 * DX, 0, 1, 0), test_particle(DX, -1.5 * DX, 0, 0, 3)};
    sph2d_probe probe = sph2d_probe_default();
    probe.name = "p";
    probe.kind = SPH2D_PROBE_SPEED;
    probe.at = (sph2d_vec2){0, 0};
    probe.rate.every = 1;
    scene.blocks = blocks;
    scene.block_count = 2;
    scene.probes = &probe;
    scene.probe_count = 1;
    sph2d_sim *sim = test_create(&scene, NULL);
    double values[SPH2D_PROBE_MAX_COLUMNS], a = pow(0.75, 4) * 2, b = pow(0.25, 4) * 4;
    sph2d_sim_probe(sim, 0, values);
    ck_assert_double_eq_tol(values[0], a / (a + b), 1e-12);
    ck_assert_double_eq_tol(values[1], 3 * b / (a + b), 1e-12);
    ck_assert(values[3] == 2);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(the_summary_counts_steps)
{
    sph2d_sim *sim = pool((sph2d_vec2){1, 0}, 0.002, (sph2d_rate){0, 0}, (sph2d_rate){0, 0});
    sph2d_summary first = sph2d_sim_summary(sim);
    ck_assert_double_eq_tol(first.energy_start, 400 * 1000 * DX * DX / 2, 1e-9);
    ck_assert_uint_eq(first.steps + first.particle_steps + first.fed, 0);
    test_steps(sim, 50);
    sph2d_summary s = sph2d_sim_summary(sim);
    ck_assert_uint_eq(s.steps, 50);
    ck_assert_uint_eq(s.particle_steps, 50 * 400);
    ck_assert_uint_eq(s.particles, 400);
    ck_assert_double_eq_tol(s.time, 0.1, 1e-14);
    ck_assert(s.time_step_min == 0.002 && s.time_step_max == 0.002);
    ck_assert_uint_eq(s.limited_by[3], 50);
    ck_assert_uint_eq(s.limited_by[0] + s.limited_by[1] + s.limited_by[2], 0);
    ck_assert_double_eq_tol(s.speed_max, 1, 1e-6);
    double pairs = 0; /* on a lattice of 20 x 20 */
    for (int i = -3; i <= 3; ++i)
        for (int j = -3; j <= 3; ++j)
            pairs += i * i + j * j > 0 && i * i + j * j < 2.6 * 2.6 ? (20 - abs(i)) * (20 - abs(j)) : 0;
    ck_assert_double_eq_tol(first.neighbours, pairs / 400, 1e-12);
    ck_assert_double_le(s.compression_max, 1e-9);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(compression_is_of_density_over_rest)
{
    /* A block at half the spacing is at four times rest density in its middle; the summary's largest is that of the
     * view. */
    sph2d_scene scene = test_open_scene(DX, -5, -5, 5, 5);
    sph2d_block block = test_block(0, 0, 0.1, 0.1);
    block.spacing = DX / 2;
    scene.blocks = &block;
    scene.block_count = 1;
    scene.method.time_step = 1e-6;
    sph2d_sim *sim = test_create(&scene, NULL);
    test_steps(sim, 20);
    sph2d_view f = sph2d_sim_fluid(sim);
    double mean = 0, most = 0;
    for (size_t i = 0; i < f.count; ++i) {
        double c = fmax(f.density[i] / 1000 - 1, 0);
        mean += c / (double)f.count;
        most = fmax(most, c);
    }
    sph2d_summary s = sph2d_sim_summary(sim);
    ck_assert_double_eq_tol(s.compression_max, most, 1e-4);
    ck_assert_double_eq_tol(s.compression_mean, mean, 1e-3); /* nothing has moved */
    ck_assert_double_le(s.compression_p99, s.compression_max);
    ck_assert_double_gt(s.compression_p99, 0.97 * s.compression_max); /* the middle is a plateau */
    sph2d_sim_destroy(sim);
}
END_TEST

static int falling(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x < y) - (x > y);
}

START_TEST(one_in_a_hundred_is_compressed_more)
{
    /* A compressed block on its way apart, after the ten steps to the first sample: 4 of 400 are above the percentile.
     */
    sph2d_scene scene = test_open_scene(DX, -5, -5, 5, 5);
    sph2d_block block = test_block(0, 0, 0.1, 0.1);
    block.spacing = DX / 2;
    scene.blocks = &block;
    scene.block_count = 1;
    scene.method.time_step = 4e-4;
    sph2d_sim *sim = test_create(&scene, NULL);
    test_steps(sim, 10);
    sph2d_view f = sph2d_sim_fluid(sim);
    static double c[400];
    ck_assert_uint_eq(f.count, 400);
    for (size_t i = 0; i < 400; ++i)
        c[i] = f.density[i] / 1000 - 1;
    qsort(c, 400, sizeof *c, falling);
    ck_assert_double_gt(c[4], 1.1 * c[40]); /* far from the tenth part */
    double p99 = sph2d_sim_summary(sim).compression_p99, bin = c[0] / 1000;
    ck_assert_double_le(p99, c[3] + bin);
    ck_assert_double_ge(p99, c[5] - bin);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(the_mean_compression_leaves_out_impacts)
{
    /* A compressed block bursts at t = 0, which the scene may call an impact: then the first 0.05 s do not count. */
    static const double impacts[1] = {0};
    sph2d_scene scene = test_scene(DX, 0, 0, 0.3, 0.3);
    sph2d_block block = test_block(0.1, 0.1, 0.2, 0.2);
    block.spacing = 0.5 * DX;
    scene.blocks = &block;
    scene.block_count = 1;
    scene.fluid.dynamic_viscosity = 1;
    scene.method.time_step = 2e-5; /* so small that every tenth step tells it all */
    scene.run.max_energy_rise = 1; /* a law that is that much compressed is not that of its force */
    scene.run.impacts.items = impacts;
    scene.run.impacts.count = (size_t)_i;
    sph2d_sim *sim = test_create(&scene, NULL);
    double sum = 0, time = 0, early = 0;
    while (sph2d_sim_time(sim) < 0.15) {
        double step = sph2d_sim_time_step(sim), mean = 0;
        test_steps(sim, 1);
        sph2d_view f = sph2d_sim_fluid(sim);
        for (size_t i = 0; i < f.count; ++i)
            mean += fmax(f.density[i] / 1000 - 1, 0) / (double)f.count;
        bool counts = _i == 0 || sph2d_sim_time(sim) >= 0.05;
        sum += counts ? step * mean : 0;
        time += counts ? step : 0;
        early += sph2d_sim_time(sim) < 0.05 ? step * mean : 0;
    }
    ck_assert_double_gt(early / 0.05, 1.5 * sum / time * _i); /* it makes a difference */
    ck_assert_double_eq_tol(sph2d_sim_summary(sim).compression_mean / (sum / time), 1, 0.05);
    sph2d_sim_destroy(sim);
}
END_TEST

/* Which phases a method has, and how often each begins in a step. */
static const struct phases {
    sph2d_method method;
    uint64_t calls[SPH2D_PHASE_COUNT];
} phases[] = {
    {SPH2D_METHOD_MULLER, {[SPH2D_PHASE_DENSITY] = 1, [SPH2D_PHASE_FORCES] = 1, [SPH2D_PHASE_SORT] = 1}},
    {SPH2D_METHOD_WCSPH, {[SPH2D_PHASE_SEARCH] = 1, [SPH2D_PHASE_FORCES] = 1, [SPH2D_PHASE_SORT] = 2}},
    {SPH2D_METHOD_PCISPH, {[SPH2D_PHASE_SEARCH] = 1, [SPH2D_PHASE_SOLVE] = 1, [SPH2D_PHASE_SORT] = 2}},
    {SPH2D_METHOD_CONSTRAINT,
     {[SPH2D_PHASE_SEARCH] = 1, [SPH2D_PHASE_FORCES] = 1, [SPH2D_PHASE_SOLVE] = 1, [SPH2D_PHASE_SORT] = 2}},
};
enum { METHODS = sizeof phases / sizeof *phases };

START_TEST(a_profile_tells_where_time_went)
{
    enum { STEPS = 5 };
    sph2d_scene scene = test_open_scene(DX, -5, -5, 5, 5);
    sph2d_block block = test_block(0, 0, 0.2, 0.2);
    sph2d_sim_options options = sph2d_sim_options_default();
    scene.method = sph2d_scene_default().method;
    scene.method.name = phases[_i].method;
    scene.method.sound_speed = 10;
    scene.blocks = &block;
    scene.block_count = 1;
    options.profile = true;
    sph2d_sim *sim = test_create(&scene, &options), *other = test_create(&scene, NULL);
    test_steps(sim, STEPS);
    test_steps(other, STEPS);
    sph2d_profile p = sph2d_sim_profile(sim), none = sph2d_sim_profile(other);
    for (int k = 0; k < SPH2D_PHASE_COUNT; ++k) {
        if (k != SPH2D_PHASE_MOVE && k != SPH2D_PHASE_BOOKKEEPING)
            ck_assert_msg(p.calls[k] == STEPS * phases[_i].calls[k], "%s began %d times",
                          sph2d_phase_name((sph2d_phase)k), (int)p.calls[k]);
        ck_assert((p.calls[k] > 0) == (p.wall[k] > 0));
        ck_assert_double_ge(p.cpu[k], 0);
        ck_assert(none.calls[k] == 0 && none.wall[k] == 0);
    }
    ck_assert_uint_ge(p.calls[SPH2D_PHASE_MOVE], STEPS);
    ck_assert_str_eq(sph2d_phase_name(SPH2D_PHASE_SOLVE), "solve");
    ck_assert_str_eq(sph2d_phase_name(SPH2D_PHASE_COUNT), "unknown");
    sph2d_sim_destroy(sim);
    sph2d_sim_destroy(other);
}
END_TEST

Suite *suite_outputs(void)
{
    Suite *suite = suite_create("outputs");
    TCase *tests = tcase_create("outputs");
    tcase_add_test(tests, rates_tell_interval_and_due_times);
    tcase_add_test(tests, probes_give_their_columns);
    tcase_add_test(tests, a_speed_probe_weighs_with_a_kernel);
    tcase_add_test(tests, the_summary_counts_steps);
    tcase_add_test(tests, compression_is_of_density_over_rest);
    tcase_add_test(tests, one_in_a_hundred_is_compressed_more);
    tcase_add_loop_test(tests, a_profile_tells_where_time_went, 0, METHODS);
    suite_add_tcase(suite, tests);
    TCase *slow = test_long(suite);
    tcase_add_test(slow, outputs_fall_due_on_time);
    tcase_add_test(slow, each_output_has_its_own_clock);
    tcase_add_loop_test(slow, the_mean_compression_leaves_out_impacts, 0, 2);
    return suite;
}
