/* SPDX-License-Identifier: MIT */
/** @file test_gauge.c
 *  Pressure gauges with a face and a rise time: means and answers that are known exactly, and a state that goes on. */
#include <math.h>

#include "hand_made.h"
#include "probes/probes.h"

static const double DX = 0.01, FACE = 0.09, RISE = 0.004;

/** A square of liquid 0.5 wide in an open domain, with one gauge. */
static sph2d_sim *square(sph2d_vec2 at, double size, sph2d_vec2 along, double rise_time)
{
    sph2d_scene scene = test_open_scene(DX, -1, -1, 1, 1);
    sph2d_probe probe = sph2d_probe_default();
    probe.name = "gauge";
    probe.kind = SPH2D_PROBE_PRESSURE;
    probe.at = at;
    probe.size = size;
    probe.along = along;
    probe.rise_time = rise_time;
    probe.rate.every = 1;
    scene.probes = &probe;
    scene.probe_count = 1;
    sph2d_sim *sim = hand_made(scene, 2500, 1);
    add_lattice(sim, (sph2d_box){{0, 0}, {0.5, 0.5}}, 0, 1);
    sort_particles(sim);
    return sim;
}

static void press(sph2d_sim *sim, double (*field)(double x, double y))
{
    sph2d__store *f = &sim->system.fluid;
    for (size_t i = 0; i < f->count; ++i)
        f->pressure[i] = field(f->x[i], f->y[i]);
}

static double shown(const sph2d_sim *sim)
{
    double values[SPH2D_PROBE_MAX_COLUMNS];
    ck_assert_uint_eq(sph2d_sim_probe(sim, 0, values), 3);
    return values[0];
}

static double plane(double x, double y)
{
    return 3 - 2 * x + 5 * y;
}
static double bowl(double x, double y)
{
    return 3 * x * x - 5 * x * y + 2 * y * y;
}
static double one(double x, double y)
{
    (void)x, (void)y;
    return 1;
}

START_TEST(a_face_shows_the_mean_over_a_disc)
{
    const sph2d_vec2 at = {0.25, 0.2}, upright = {0, 1}, slanted = {3, 4};
    sph2d_sim *sim = square(at, FACE, slanted, 0);
    press(sim, plane);
    ck_assert_double_eq_tol(shown(sim), plane(at.x, at.y), 1e-13);
    press(sim, bowl); /* the mean of s^2 over a disc is D^2/16; over a line it would be D^2/12 */
    double second = 3 * 0.36 - 5 * 0.48 + 2 * 0.64;
    ck_assert_double_eq_tol(shown(sim), bowl(at.x, at.y) + second * FACE * FACE / 16, 1e-13);
    sph2d_sim_destroy(sim);
    sim = square(at, FACE, upright, 0);
    press(sim, bowl);
    ck_assert_double_eq_tol(shown(sim), bowl(at.x, at.y) + 2 * FACE * FACE / 16, 1e-13);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(air_has_no_pressure)
{
    sph2d_sim *sim = square((sph2d_vec2){0.25, 0.5}, 0.4, (sph2d_vec2){0, 1}, 0); /* half of the face is wet */
    press(sim, one);
    ck_assert_double_eq_tol(shown(sim), 0.5, 0.06); /* values reach as far as the support */
    sph2d_sim_destroy(sim);
    sim = square((sph2d_vec2){-0.5, 0.5}, FACE, (sph2d_vec2){0, 1}, 0);
    press(sim, one);
    ck_assert(shown(sim) == 0);
    sph2d_sim_destroy(sim);
}
END_TEST

/** Time at which a gauge that followed a jump for `dt` at a time shows `level`. */
static double time_of(double level, double dt)
{
    sph2d_sim *sim = square((sph2d_vec2){0.25, 0.25}, 0, (sph2d_vec2){0, 1}, RISE);
    press(sim, one);
    sim->gauges[0] = 1; /* the jump is over as the clock starts */
    double before = 0, time = 0;
    while (shown(sim) < level) {
        before = shown(sim);
        sph2d__sim_read_gauges(sim, dt);
        time += dt;
    }
    double after = shown(sim);
    sph2d_sim_destroy(sim);
    return time - dt * log((1 - level) / (1 - after)) / log((1 - before) / (1 - after)); /* an exponential between */
}

START_TEST(a_jump_takes_the_rise_time)
{
    static const double steps[] = {1e-3, 1e-4, 3e-5};
    double t10 = time_of(0.1, steps[_i]), t90 = time_of(0.9, steps[_i]);
    ck_assert_double_eq_tol(t90 - t10, RISE, 1e-9);
    ck_assert_double_eq_tol(t10, RISE * log(1 / 0.9) / log(9), 1e-9);
}
END_TEST

START_TEST(a_ramp_is_followed_exactly_by_any_steps)
{
    sph2d_sim *sim = square((sph2d_vec2){0.25, 0.25}, 0, (sph2d_vec2){0, 1}, RISE);
    sph2d__store *f = &sim->system.fluid;
    const double tau = RISE / log(9), slope = 7e5;
    uint64_t seed = 3;
    double time = 0;
    for (int k = 0; k < 40; ++k) {
        double dt = test_random(&seed, 1e-7, 1e-3);
        time += dt;
        for (size_t i = 0; i < f->count; ++i)
            f->pressure[i] = slope * time;
        sph2d__sim_read_gauges(sim, dt);
        double exact = slope * (time + tau * expm1(-time / tau));
        ck_assert_double_eq_tol(shown(sim), exact, 1e-9 * slope * time);
    }
    sph2d_sim_destroy(sim);
}
END_TEST

/** A column that falls in a tank, with a slow gauge beside a fast one. */
static sph2d_sim *fall(int threads, const sph2d_state *state)
{
    sph2d_scene scene = test_scene(0.05, 0, 0, 2, 2);
    scene.method = sph2d_scene_default().method;
    scene.gravity.y = -9.81;
    sph2d_block block = test_block(0, 0, 0.5, 1);
    scene.blocks = &block;
    scene.block_count = 1;
    sph2d_probe probes[2] = {sph2d_probe_default(), sph2d_probe_default()};
    for (int k = 0; k < 2; ++k) {
        probes[k].name = k ? "slow" : "fast";
        probes[k].kind = SPH2D_PROBE_PRESSURE;
        probes[k].at = (sph2d_vec2){0, 0.3};
        probes[k].size = 0.2;
        probes[k].rise_time = k ? 0.05 : 0;
        probes[k].rate.every = 0.01;
    }
    scene.probes = probes;
    scene.probe_count = 2;
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = threads;
    sph2d_sim *sim = NULL;
    if (!state)
        return test_create(&scene, &options);
    ck_assert(sph2d_sim_restore(&scene, &options, state, &sim, NULL) == SPH2D_OK);
    return sim;
}

static void read_both(const sph2d_sim *sim, double out[2])
{
    double values[SPH2D_PROBE_MAX_COLUMNS];
    for (size_t k = 0; k < 2; ++k) {
        sph2d_sim_probe(sim, k, values);
        out[k] = values[0];
    }
}

START_TEST(what_a_gauge_shows_goes_on_after_a_resume_and_on_any_threads)
{
    sph2d_sim *whole = fall(1, NULL);
    test_steps(whole, 60);
    test_state state = test_state_copy(whole);
    sph2d_sim *rest = fall(3, &state.state);
    double a[2], b[2];
    read_both(whole, a);
    ck_assert(a[0] != a[1] && a[1] > 0);
    for (int k = 0; k < 20; ++k) {
        test_steps(whole, 3);
        test_steps(rest, 3);
        read_both(whole, a);
        read_both(rest, b);
        ck_assert(a[0] == b[0] && a[1] == b[1]);
    }
    test_state_free(&state);
    sph2d_sim_destroy(rest);
    sph2d_sim_destroy(whole);
}
END_TEST

START_TEST(what_is_no_gauge_is_refused)
{
    sph2d_scene scene = test_scene(0.1, 0, 0, 1, 1);
    sph2d_block block = test_block(0, 0, 1, 0.5);
    scene.blocks = &block;
    scene.block_count = 1;
    sph2d_probe probe = sph2d_probe_default();
    probe.name = "gauge";
    probe.kind = SPH2D_PROBE_PRESSURE;
    probe.at = (sph2d_vec2){0, 0.3};
    probe.rate.every = 0.1;
    scene.probes = &probe;
    scene.probe_count = 1;
    struct {
        sph2d_probe_kind kind;
        double size, rise_time;
        sph2d_vec2 along;
        sph2d_code code;
        const char *path;
    } cases[] = {
        {SPH2D_PROBE_SPEED, 0.1, 0, {0, 1}, SPH2D_CODE_CONFLICT, "probes[0].size"},
        {SPH2D_PROBE_ENERGY, 0, 0.1, {0, 1}, SPH2D_CODE_CONFLICT, "probes[0].rise_time"},
        {SPH2D_PROBE_PRESSURE, 0.1, 0, {0, 0}, SPH2D_CODE_OUT_OF_RANGE, "probes[0].along"},
        {SPH2D_PROBE_PRESSURE, 0.1, 0, {1, 0}, SPH2D_CODE_OUT_OF_RANGE, "probes[0].size"},
        {SPH2D_PROBE_PRESSURE, 0.7, 0, {0, 1}, SPH2D_CODE_OUT_OF_RANGE, "probes[0].size"},
        {SPH2D_PROBE_PRESSURE, -0.1, 0, {0, 1}, SPH2D_CODE_OUT_OF_RANGE, "probes[0].size"},
        {SPH2D_PROBE_PRESSURE, 0.6, 0.1, {0, 1}, SPH2D_CODE_GENERAL, NULL},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; ++k) {
        sph2d_report report = {0};
        probe.kind = cases[k].kind;
        probe.size = cases[k].size;
        probe.rise_time = cases[k].rise_time;
        probe.along = cases[k].along;
        sph2d_status status = sph2d_scene_check(&scene, &report);
        ck_assert_msg((status == SPH2D_OK) == !cases[k].path, "%zu: %s", k, test_report_text(&report));
        if (cases[k].path)
            ck_assert_msg(test_report_has(&report, cases[k].code, cases[k].path), "%s", test_report_text(&report));
        sph2d_report_clear(&report);
    }
}
END_TEST

/** The rise time that a probe of a scene with this gravity gets where none is given. */
static double rise_time_of(double gravity, double sound_speed, double given)
{
    sph2d_scene scene = test_scene(0.1, 0, 0, 2, 2);
    sph2d_block block = test_block(0, 0, 1, 1.5);
    scene.blocks = &block;
    scene.block_count = 1;
    scene.gravity.y = -gravity;
    scene.method.name = SPH2D_METHOD_WCSPH;
    scene.method.sound_speed = sound_speed;
    sph2d_probe probes[2] = {sph2d_probe_default(), sph2d_probe_default()};
    probes[0].name = "gauge";
    probes[0].at = (sph2d_vec2){0, 0};
    probes[0].kind = SPH2D_PROBE_PRESSURE;
    probes[1].name = "energy";
    probes[0].rate.every = probes[1].rate.every = 0.1;
    probes[0].rise_time = given;
    scene.probes = probes;
    scene.probe_count = 2;
    sph2d_sim *sim = NULL;
    ck_assert_int_eq(sph2d_sim_create(&scene, NULL, &sim, NULL), SPH2D_OK);
    const double rise_time = sph2d_sim_scene(sim)->probes[0].rise_time;
    sph2d_sim_destroy(sim);
    return rise_time;
}

/** The slowest sound in 1.5 m of liquid has a wave of four times that; what does not fall has no such height. */
START_TEST(a_gauge_is_slower_than_the_sound_of_the_liquid)
{
    ck_assert_double_eq_tol(rise_time_of(9.81, 0, NAN), 4 * 1.5 / sqrt(2 * 9.81 * 1.5 / 0.01), 1e-12);
    ck_assert_double_eq_tol(rise_time_of(9.81, 100, NAN), 4 * 1.5 / 100, 1e-12);
    ck_assert_double_eq(rise_time_of(0, 100, NAN), 0);
    ck_assert_double_eq(rise_time_of(9.81, 0, 0), 0);
    ck_assert_double_eq(rise_time_of(9.81, 0, 0.25), 0.25);
}
END_TEST

Suite *suite_gauge(void)
{
    Suite *suite = suite_create("gauge");
    TCase *tests = tcase_create("gauge");
    tcase_add_test(tests, a_face_shows_the_mean_over_a_disc);
    tcase_add_test(tests, air_has_no_pressure);
    tcase_add_loop_test(tests, a_jump_takes_the_rise_time, 0, 3);
    tcase_add_test(tests, a_ramp_is_followed_exactly_by_any_steps);
    tcase_add_test(tests, what_a_gauge_shows_goes_on_after_a_resume_and_on_any_threads);
    tcase_add_test(tests, what_is_no_gauge_is_refused);
    tcase_add_test(tests, a_gauge_is_slower_than_the_sound_of_the_liquid);
    suite_add_tcase(suite, tests);
    return suite;
}
