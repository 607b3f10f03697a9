/* SPDX-License-Identifier: MIT */
/** @file test_broken.c
 *  A simulation whose step ran out of memory can still be asked for everything, and does not answer with what it does
 *  not know. */
#include <math.h>
#include <stdio.h>

#include "common.h"

/* Allocations that are granted from now on. */
static size_t granted;

static void *resize(void *user, void *block, size_t old_size, size_t new_size)
{
    (void)user;
    if (new_size > old_size && granted-- == 0) {
        granted = 0;
        return NULL;
    }
    return test_resize(block, old_size, new_size);
}

static const double DX = 0.1;
static const sph2d_method methods[] = {SPH2D_METHOD_MULLER, SPH2D_METHOD_WCSPH, SPH2D_METHOD_PCISPH,
                                       SPH2D_METHOD_CONSTRAINT};
enum { METHODS = sizeof methods / sizeof *methods, PROBES = SPH2D_PROBE_LEVEL + 1 };

static sph2d_block block;
static sph2d_source source;
static sph2d_obstacle obstacle;
static sph2d_probe probes[PROBES];
static sph2d_scene scene;

/** Liquid that a source spreads over more and more cells, under surface tension, with a wall that moves. */
static void start(void)
{
    scene = test_scene(DX, 0, 0, 2, 2);
    scene.gravity.y = -9.81;
    scene.fluid.dynamic_viscosity = 20;
    scene.fluid.surface_tension = 0.07;
    block = test_block(0, 0, 0.4, 0.6);
    source = sph2d_source_default();
    source.at = (sph2d_vec2){1.6, 1.6};
    source.width = 4 * DX;
    source.speed = 6;
    obstacle = sph2d_obstacle_default();
    obstacle.shape.kind = SPH2D_SHAPE_BOX;
    obstacle.shape.box = (sph2d_box){{1, 0}, {1.3, 0.3}};
    obstacle.motion.amplitude = (sph2d_vec2){0.2, 0.1};
    obstacle.motion.frequency = 0.5;
    for (int k = 0; k < PROBES; ++k) {
        static char names[PROBES][4];
        snprintf(names[k], sizeof names[k], "p%d", k % 100);
        probes[k] = sph2d_probe_default();
        probes[k].name = names[k];
        probes[k].rate.every = 0.1;
        probes[k].kind = (sph2d_probe_kind)k;
        probes[k].at = (sph2d_vec2){0.2, 0.2};
    }
    scene.blocks = &block;
    scene.block_count = 1;
    scene.sources = &source;
    scene.source_count = 1;
    scene.obstacles = &obstacle;
    scene.obstacle_count = 1;
}

/** Asks for everything that does not return a status. */
static void read_all(sph2d_sim *sim)
{
    sph2d_view fluid = sph2d_sim_fluid(sim), walls = sph2d_sim_walls(sim);
    double sum = 0;
    for (size_t i = 0; i < fluid.count; ++i)
        sum += fluid.x[i] + fluid.vy[i] + fluid.ax[i] + fluid.density[i] + fluid.pressure[i];
    for (size_t i = 0; i < walls.count; ++i)
        sum += walls.x[i] + walls.pressure[i];
    ck_assert(isfinite(sum));
    for (size_t k = 0; k < sph2d_field_count(SPH2D_GROUP_FLUID); ++k)
        ck_assert_uint_eq(sph2d_field(sim, SPH2D_GROUP_FLUID, k).count, fluid.count);
    sph2d_sample sample;
    for (double x = 0; x < 2; x += 0.1)
        ck_assert(!sph2d_sim_sample(sim, (sph2d_vec2){x, 0.1}, &sample) && isnan(sample.pressure));
    sph2d_summary summary = sph2d_sim_summary(sim);
    ck_assert(isnan(summary.neighbours) && isnan(summary.potential) && isfinite(summary.kinetic));
    ck_assert_uint_eq(summary.particles, fluid.count);
    double values[SPH2D_PROBE_MAX_COLUMNS];
    for (size_t k = 0; k < scene.probe_count; ++k)
        ck_assert_uint_eq(sph2d_sim_probe(sim, k, values), 0);
    sph2d_sim_densities(sim);
    ck_assert_uint_eq(sph2d_sim_state(sim).array_count, 0);
    ck_assert_int_eq(sph2d_sim_set_gravity(sim, (sph2d_vec2){0, 1}), SPH2D_OK);
    ck_assert_int_eq(sph2d_sim_step(sim, NULL), SPH2D_NOMEM);
}

START_TEST(everything_can_be_read_when_a_step_has_failed)
{
    enum { STEPS = 25 };
    scene.method.name = methods[_i];
    if (methods[_i] == SPH2D_METHOD_CONSTRAINT)
        scene.method.sound_speed = 0; /* for this fall: the source pours at 0.8 of the scene's */
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = 1;
    options.allocator.resize = resize;
    sph2d_report report = {0};
    bool failed = true;
    for (size_t k = 0, broken = 0; failed; ++k) {
        granted = SIZE_MAX;
        sph2d_sim *sim = NULL;
        ck_assert_msg(sph2d_sim_create(&scene, &options, &sim, &report) == SPH2D_OK, "%s", test_report_text(&report));
        granted = k;
        sph2d_status status = SPH2D_OK;
        for (int n = 0; n < STEPS && status == SPH2D_OK; ++n)
            status = sph2d_sim_step(sim, &report);
        failed = status == SPH2D_NOMEM;
        granted = SIZE_MAX;
        if (failed) {
            ++broken;
            read_all(sim);
        } else {
            ck_assert_msg(status == SPH2D_OK, "%s", test_report_text(&report));
            ck_assert_uint_gt(broken, 10);
        }
        sph2d_sim_destroy(sim);
        sph2d_report_clear(&report);
    }
}
END_TEST

/** A probe without the memory that it needs for a while has no values; it has them when there is memory again. */
START_TEST(a_probe_without_memory_has_no_values)
{
    scene.probes = probes;
    scene.probe_count = PROBES;
    probes[SPH2D_PROBE_ERROR].kind = SPH2D_PROBE_ENERGY; /* there is no flow to compare with */
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = 1;
    options.allocator.resize = resize;
    granted = SIZE_MAX;
    sph2d_sim *sim = test_create(&scene, &options);
    test_steps(sim, 3);
    double values[SPH2D_PROBE_MAX_COLUMNS];
    for (size_t k = 0; k < PROBES; ++k) {
        bool needs = k == SPH2D_PROBE_QUALITY || k == SPH2D_PROBE_VOLUME || k == SPH2D_PROBE_LEVEL;
        granted = SIZE_MAX;
        size_t count = sph2d_sim_probe(sim, k, values), needed = SIZE_MAX - granted;
        ck_assert_uint_gt(count, 0);
        ck_assert((needed > 0) == needs);
        for (size_t n = 0; n < needed; ++n) {
            granted = n;
            ck_assert_uint_eq(sph2d_sim_probe(sim, k, values), 0);
        }
        granted = SIZE_MAX;
        ck_assert_uint_eq(sph2d_sim_probe(sim, k, values), count);
    }
    ck_assert_int_eq(sph2d_sim_densities(sim).status, SPH2D_OK);
    granted = 0;
    ck_assert_int_eq(sph2d_sim_densities(sim).status, SPH2D_NOMEM);
    granted = SIZE_MAX;
    sph2d_sim_destroy(sim);
}
END_TEST

Suite *suite_broken(void)
{
    Suite *suite = suite_create("broken");
    TCase *tests = tcase_create("broken");
    tcase_add_checked_fixture(tests, start, NULL);
    tcase_add_test(tests, a_probe_without_memory_has_no_values);
    suite_add_tcase(suite, tests);
    TCase *slow = test_long(suite);
    tcase_add_checked_fixture(slow, start, NULL);
    tcase_add_loop_test(slow, everything_can_be_read_when_a_step_has_failed, 0, METHODS);
    return suite;
}
