/* SPDX-License-Identifier: MIT */
/** @file test_viscous_step.c
 *  The step of viscous liquid whose particles have gathered, as where a thread of honey breaks: viscosity.h. */
#include <math.h>

#include "common.h"
#include "methods/common/system.h"
#include "sim/simulation.h"

#define DX 0.02
#define RHO0 1000.0

enum { ROWS = 4, LENGTH = 36, COUNT = ROWS * LENGTH };

static sph2d_scene scene;
static sph2d_particle thread[COUNT];
static sph2d_sim *sim;

static void finish(void)
{
    sph2d_sim_destroy(sim);
    sim = NULL;
}

/** A thread `height` above a rough floor with `distance` spacings from row to row but rest density, in random motion.
 *  Far from a surface density would relax to its sum. */
static void start(double distance, double height, double viscosity)
{
    uint64_t seed = 5;
    for (size_t k = 0; k < COUNT; ++k)
        thread[k] = (sph2d_particle){
            .x = ((double)(k % LENGTH) + test_random(&seed, 0.3, 0.7)) * distance * DX,
            .y = ((double)(k / LENGTH) + test_random(&seed, 0.3, 0.7)) * distance * DX + height,
            .vx = test_random(&seed, -0.01, 0.01),
            .vy = test_random(&seed, -0.01, 0.01),
            .density = RHO0,
        };
    scene = test_scene(DX, -LENGTH * DX, 0, 2 * LENGTH * DX, LENGTH * DX);
    scene.method = sph2d_scene_default().method;
    scene.method.name = SPH2D_METHOD_WCSPH;
    scene.method.sound_speed = 10;
    scene.method.turbulence = SPH2D_TURBULENCE_NONE;
    scene.method.shifting = 0;
    scene.fluid.dynamic_viscosity = viscosity;
    scene.wall_slip = SPH2D_SLIP_NONE;
    scene.run.max_energy_rise = 1e6; /* rates of density raise the pressure of random motion */
    scene.particles = (sph2d_particles){.items = thread, .count = COUNT};
    sim = test_create(&scene, NULL);
}

/** |v| of all particles. */
static double size_of(const double *x, const double *y)
{
    double sum = 0;
    for (size_t i = 0; i < COUNT; ++i)
        sum += x[i] * x[i] + y[i] * y[i];
    return sqrt(sum);
}

/* Power iteration by the forces themselves: without pressure and gravity they are minus the viscous matrix times the
 * velocities. */
START_TEST(no_motion_is_damped_faster_than_the_rate)
{
    const double distances[] = {1, 0.7, 0.4};
    start(distances[_i], 0, 200);
    sph2d__store *f = &sim->system.fluid;
    double rate = 0;
    for (int k = 0; k < 60; ++k) {
        ck_assert(sim->method->evaluate(&sim->system));
        double speed = size_of(f->vx, f->vy), change = size_of(f->ax, f->ay);
        rate = change / speed;
        for (size_t i = 0; i < COUNT; ++i) {
            f->vx[i] = -f->ax[i] / change;
            f->vy[i] = -f->ay[i] / change;
        }
    }
    ck_assert_double_le(rate, sim->system.viscous_rate);
    ck_assert_double_ge(rate, 0.5 * sim->system.viscous_rate);
    ck_assert_double_le(sim->record.next_step * sim->system.viscous_rate, 1 + 1e-12);
}
END_TEST

START_TEST(gathered_particles_come_to_rest)
{
    start(0.7, LENGTH / 2 * DX, 2000);
    double before = sph2d_sim_summary(sim).speed_max;
    for (int k = 0; k < 10; ++k) {
        test_steps(sim, 10);
        ck_assert_double_le(sph2d_sim_summary(sim).speed_max, before);
    }
    ck_assert_double_le(sph2d_sim_summary(sim).speed_max, 0.3 * before);
}
END_TEST

/* There sound limits the step, and nothing is summed for it. */
START_TEST(water_has_no_rate)
{
    start(0.5, LENGTH / 2 * DX, 0.001);
    ck_assert(!sim->system.viscosity_limits);
    ck_assert(sim->method->evaluate(&sim->system));
    ck_assert_double_eq(sim->system.viscous_rate, 0);
}
END_TEST

Suite *suite_viscous_step(void)
{
    Suite *suite = suite_create("viscous_step");
    TCase *tests = tcase_create("viscous_step");
    tcase_add_checked_fixture(tests, NULL, finish);
    tcase_add_loop_test(tests, no_motion_is_damped_faster_than_the_rate, 0, 3);
    tcase_add_test(tests, gathered_particles_come_to_rest);
    tcase_add_test(tests, water_has_no_rate);
    suite_add_tcase(suite, tests);
    return suite;
}
