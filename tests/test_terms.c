/* SPDX-License-Identifier: MIT */
/** @file test_terms.c
 *  Terms of method `wcsph` that a scene may choose: diffusion towards a liquid at rest; the copies of the pair loops in
 *  every instruction set. */
#include <math.h>
#include <string.h>

#include "common.h"
#include "methods/wcsph/wcsph.h"
#include "sim/simulation.h"

#define DX 0.02
#define C0 20.0
#define RHO0 1000.0

enum { SIDE = 14 };

static sph2d_scene scene;
static sph2d_block block;

static void start(void)
{
    scene = test_open_scene(DX, 0, 0, SIDE * DX, 1);
    scene.boundary = (sph2d_boundary){SPH2D_SIDE_WALL, SPH2D_SIDE_OPEN, SPH2D_SIDE_WALL, SPH2D_SIDE_OPEN};
    block = test_block(0, 0, SIDE * DX, SIDE * DX);
    block.perturb.amplitude = 0.3;
    scene.blocks = &block;
    scene.block_count = 1;
    scene.gravity = (sph2d_vec2){2, -9};
    scene.method = sph2d_scene_default().method;
    scene.method.name = SPH2D_METHOD_WCSPH;
    scene.method.sound_speed = C0;
}

static void take_fourtakas(void)
{
    scene.method.diffusion_form = SPH2D_DIFFUSION_FOURTAKAS;
    scene.method.density_diffusion = 0.17;
    scene.method.shifting = 0;
    scene.method.tensile_control = SPH2D_SWITCH_OFF;
}

static sph2d_sim *make(sph2d_isa isa)
{
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = 1;
    options.isa = isa;
    return test_create(&scene, &options);
}

/** Velocities up to 1 m/s and densities within 3 % of the rest density. */
static void stir(sph2d__store *f)
{
    uint64_t seed = 3;
    for (size_t i = 0; i < f->count; ++i) {
        f->vx[i] = test_random(&seed, -1, 1);
        f->vy[i] = test_random(&seed, -1, 1);
        f->density[i] = RHO0 * test_random(&seed, 0.97, 1.03);
    }
}

/* Fourtakas et al. 2019, with the hydrostatic difference of the linear equation of state: rho0 g . r / c0^2. */
START_TEST(density_is_smoothed_as_fourtakas_says)
{
    take_fourtakas();
    scene.boundary.left = scene.boundary.bottom = SPH2D_SIDE_OPEN;
    scene.central_force = (sph2d_central_force){.center = {0.1, 0.2}, .rate = _i ? 3 : 0};
    sph2d_sim *sim = make(SPH2D_ISA_AUTO);
    sph2d__system *s = &sim->system;
    sph2d__store *f = &s->fluid;
    stir(f);
    memset(f->vx, 0, f->count * sizeof *f->vx);
    memset(f->vy, 0, f->count * sizeof *f->vy);
    sph2d__wcsph.density_rate(s);
    double h = s->support / 2;
    for (size_t i = 0; i < f->count; ++i) {
        double rate = 0, size = 0;
        for (size_t j = 0; j < f->count; ++j) {
            double dx = f->x[i] - f->x[j], dy = f->y[i] - f->y[j], r = hypot(dx, dy), t = fmax(1 - r / s->support, 0);
            double mx = (f->x[i] + f->x[j]) / 2 - 0.1, my = (f->y[i] + f->y[j]) / 2 - 0.2, rate2 = _i ? 9 : 0;
            double work = (2 - rate2 * mx) * dx + (-9 - rate2 * my) * dy; /* from j to i */
            double psi = 2 * (f->density[i] - f->density[j] - RHO0 * work / (C0 * C0));
            double slope = -7 / (TEST_PI * pow(s->support, 4)) * 20 * pow(t, 3);
            double term = 0.17 * h * C0 * s->mass / f->density[j] * psi * slope;
            rate += term;
            size += fabs(term);
        }
        ck_assert_double_eq_tol(f->density_rate[i], rate, 1e-10 * size);
    }
    sph2d_sim_destroy(sim);
}
END_TEST

/* Not along a periodic direction: there is no rest along gravity that has no end. */
START_TEST(no_density_rests_along_a_period)
{
    take_fourtakas();
    sph2d_side other = SPH2D_SIDE_OPEN, along = SPH2D_SIDE_PERIODIC;
    scene.boundary = _i ? (sph2d_boundary){other, other, along, along} : (sph2d_boundary){along, along, other, other};
    scene.gravity = (sph2d_vec2){_i ? 0 : 5, _i ? 5 : 0};
    block.perturb.amplitude = 0;
    sph2d_sim *sim = make(SPH2D_ISA_AUTO);
    sph2d__store *f = &sim->system.fluid;
    for (size_t i = 0; i < f->count; ++i)
        f->density[i] = RHO0;
    sph2d__wcsph.density_rate(&sim->system);
    for (size_t i = 0; i < f->count; ++i)
        ck_assert_double_eq_tol(f->density_rate[i], 0, 1e-9);
    sph2d_sim_destroy(sim);
}
END_TEST

/* A tank at rest in gravity stays so: 4 columns high, a second long. */
START_TEST(a_tank_at_rest_stays_at_rest)
{
    take_fourtakas();
    scene.method.density_diffusion = 0.1;
    scene.method.artificial_viscosity = 0.02;
    scene.method.sound_speed = 0;
    scene.boundary.right = SPH2D_SIDE_WALL;
    scene.gravity = (sph2d_vec2){0, -9.81};
    block.perturb.amplitude = 0;
    block.start.flow = sph2d_flow_default();
    block.start.flow.kind = SPH2D_FLOW_STILL;
    block.start.flow.center[1] = SIDE * DX;
    sph2d_sim *sim = make(SPH2D_ISA_AUTO);
    while (sph2d_sim_summary(sim).time < 1)
        test_steps(sim, 50);
    sph2d_summary sum = sph2d_sim_summary(sim);
    double unit = sqrt(9.81 * SIDE * DX);
    ck_assert_msg(sum.speed_max < 0.02 * unit, "largest speed %g sqrt(g H)", sum.speed_max / unit);
    double top = 0;
    for (size_t i = 0; i < sim->system.fluid.count; ++i)
        top = fmax(top, sim->system.fluid.y[i]);
    ck_assert_double_eq_tol(top, (SIDE - 0.5) * DX, 0.5 * DX);
    sph2d_sim_destroy(sim);
}
END_TEST

static void same(const double *a, const double *b, size_t count, const char *what, const char *isa)
{
    for (size_t i = 0; i < count; ++i)
        ck_assert_msg(a[i] == b[i], "%s of particle %zu in %s: %.17g, not %.17g", what, i, isa, a[i], b[i]);
}

/** Forces and rates in one instruction set as in the baseline. */
static void compare_sets(void)
{
    for (int isa = SPH2D_ISA_BASELINE + 1; isa <= SPH2D_ISA_AVX512; ++isa) {
        if (!sph2d_isa_available((sph2d_isa)isa))
            continue;
        sph2d_sim *plain = make(SPH2D_ISA_BASELINE), *other = make((sph2d_isa)isa);
        const char *name = sph2d_isa_name((sph2d_isa)isa);
        sph2d_sim *both[2] = {plain, other};
        for (int k = 0; k < 2; ++k) {
            stir(&both[k]->system.fluid);
            both[k]->method->evaluate(&both[k]->system);
            if (both[k]->method->density_rate)
                both[k]->method->density_rate(&both[k]->system);
        }
        const sph2d__store *a = &other->system.fluid, *b = &plain->system.fluid;
        same(a->ax, b->ax, a->count, "ax", name);
        same(a->ay, b->ay, a->count, "ay", name);
        if (plain->method->density_rate)
            same(a->density_rate, b->density_rate, a->count, "rate", name);
        same(other->system.walls.pressure, plain->system.walls.pressure, other->system.walls.count, "pressure", name);
        sph2d_sim_destroy(other);
        sph2d_sim_destroy(plain);
    }
}

/* Each lane sums in the order of memory, however many there are. */
START_TEST(instruction_sets_sum_to_the_same_bits)
{
    if (_i & 1)
        take_fourtakas();
    scene.method.artificial_viscosity = 0.05;
    scene.fluid.dynamic_viscosity = 2;
    scene.wall_slip = _i & 2 ? SPH2D_SLIP_NONE : SPH2D_SLIP_FREE;
    compare_sets();
}
END_TEST

/* More candidates than are sifted at a time, and some around the end of a period. */
START_TEST(a_crowd_sums_to_the_same_bits)
{
    enum { ACROSS = 5 * SIDE };
    static sph2d_particle crowd[ACROSS * ACROSS];
    uint64_t seed = 7;
    for (size_t k = 0; k < ACROSS * ACROSS; ++k)
        crowd[k] = (sph2d_particle){
            .x = ((double)(k % ACROSS) + 0.5 + test_random(&seed, -0.1, 0.1)) * DX / 5,
            .y = ((double)(k / ACROSS) + 0.5 + test_random(&seed, -0.1, 0.1)) * DX / 5,
            .density = RHO0,
        };
    scene.boundary.left = scene.boundary.right = SPH2D_SIDE_PERIODIC;
    if (_i == 0) {
        scene.block_count = 0;
        scene.particles = (sph2d_particles){.items = crowd, .count = ACROSS * ACROSS};
        scene.method.artificial_viscosity = 0.05;
    } else {
        block.spacing = DX / 5;
        block.perturb.amplitude = 0.1;
        scene.method = sph2d_scene_default().method;
        scene.method.name = SPH2D_METHOD_MULLER;
        scene.fluid.dynamic_viscosity = 2;
    }
    compare_sets();
}
END_TEST

Suite *suite_terms(void)
{
    Suite *suite = suite_create("terms");
    TCase *tests = tcase_create("chosen");
    tcase_add_checked_fixture(tests, start, NULL);
    tcase_add_loop_test(tests, density_is_smoothed_as_fourtakas_says, 0, 2);
    tcase_add_loop_test(tests, no_density_rests_along_a_period, 0, 2);
    tcase_add_test(tests, a_tank_at_rest_stays_at_rest);
    tcase_add_loop_test(tests, instruction_sets_sum_to_the_same_bits, 0, 4);
    tcase_add_loop_test(tests, a_crowd_sums_to_the_same_bits, 0, 2);
    suite_add_tcase(suite, tests);
    return suite;
}
