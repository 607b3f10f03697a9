/* SPDX-License-Identifier: MIT */
/** @file test_plan.c
 *  What a scene will be: derived numbers, first step, sizes, numbers of outputs; options.
 *
 *      H = support_ratio dx, mass = density dx^2, head = g h + U^2/2 + pull, c0^2 = 2 head / max_compression or
 *  stiffness, dt <= cfl H/(c0 + U) */
#include <math.h>
#include <string.h>

#include "common.h"

static const double DX = 0.01, G = 9.81;

static sph2d_block blocks[1];
static sph2d_scene scene;
static sph2d_plan plan;
static sph2d_report report;

static void start(void)
{
    blocks[0] = test_block(0.2, 0.1, 0.3, 0.2); /* 100 particles, up to 0.3 above the bottom */
    scene = sph2d_scene_default();
    scene.method.name = SPH2D_METHOD_MULLER;
    scene.domain = (sph2d_box){{0, -0.1}, {1, 0.9}};
    scene.spacing = DX;
    scene.blocks = blocks;
    scene.block_count = 1;
    sph2d_report_clear(&report);
    memset(&plan, 0, sizeof plan);
}

static void make_plan(void)
{
    sph2d_status status = sph2d_scene_plan(&scene, &plan, &report);
    ck_assert_msg(status == SPH2D_OK, "%s", test_report_text(&report));
}

/** The plan's head and sound speed are those of a height, a speed and a pull. */
static void check_speed(double height, double speed, double pull)
{
    double g = hypot(scene.gravity.x, scene.gravity.y), head = g * height + speed * speed / 2 + pull;
    double wanted = scene.method.max_compression > 0 ? scene.method.max_compression : 0.1; /* the default of muller */
    double c0 = sqrt(2 * head / wanted);
    make_plan();
    ck_assert_double_eq_tol(plan.head / head, 1, 1e-12);
    ck_assert_double_eq_tol(plan.sound_speed / c0, 1, 1e-12);
    ck_assert_double_eq_tol(plan.impact_compression / (sqrt(2 * head) / c0), 1, 1e-12);
    ck_assert_ptr_nonnull(strstr(plan.sound_speed_formula, "max_compression"));
}

START_TEST(the_sound_speed_comes_from_height_speed_and_pull)
{
    check_speed(0.3, 0, 0); /* the block's upper edge above the bottom */
    scene.method.max_compression = 0.01;
    check_speed(0.3, 0, 0);
    blocks[0].velocity = (sph2d_vec2){3, -4};
    check_speed(0.3, 5, 0);
    sph2d_source source = sph2d_source_default();
    source.at = (sph2d_vec2){0.5, 0.6};
    source.speed = 7;
    scene.sources = &source;
    scene.source_count = 1;
    check_speed(0.7, 7, 0);
    sph2d_path_point point = {0, 0.5, 0.5};
    sph2d_interaction push = sph2d_interaction_default();
    push.path = (sph2d_path){&point, 1};
    push.radius = 0.4;
    push.acceleration = -30;
    scene.interactions = &push;
    scene.interaction_count = 1;
    check_speed(0.7, 7, 30 * 0.4 / 2);
    scene = sph2d_scene_default(); /* the lists above end here */
    scene.method.name = SPH2D_METHOD_MULLER;
}
END_TEST

/* A flow that turns about its centre is fastest at the block's edge, wherever its length ends. */
START_TEST(the_speed_of_a_flow_is_that_at_the_edge_of_its_block)
{
    blocks[0].shape = (sph2d_shape){.kind = SPH2D_SHAPE_CIRCLE, .circle = {{0.5, 0.3}, 0.2}};
    blocks[0].start.flow = (sph2d_flow){.kind = SPH2D_FLOW_ROTATION, .speed = 1.5, .length = 0.1, .center = {0.5, 0.3}};
    scene.gravity = (sph2d_vec2){0, 0};
    check_speed(0, 3, 0);
    blocks[0].start.flow.length = 0.2;
    check_speed(0, 1.5, 0);
}
END_TEST

START_TEST(surface_tension_presses_on_drops)
{
    blocks[0].shape = (sph2d_shape){.kind = SPH2D_SHAPE_CIRCLE, .circle = {{0.5, 0.3}, 0.2}};
    scene.gravity = (sph2d_vec2){0, 0};
    scene.fluid.surface_tension = 80;
    make_plan();
    double head = 80 / (scene.fluid.density * 0.2), c0 = sqrt(8 * 80 / (scene.fluid.density * DX));
    ck_assert_double_eq_tol(plan.capillary_head, head, 1e-12);
    ck_assert_double_eq_tol(plan.sound_speed, c0, 1e-12);
    ck_assert_double_eq_tol(plan.impact_compression, sqrt(2 * head) / c0, 1e-12);
    ck_assert_uint_eq(report.count, 0); /* 1/8 dx/R = 0.6 %, less than the 10 % of muller */
    scene.method.max_compression = 0.005;
    make_plan();
    ck_assert_uint_eq(report.count, 1);
    ck_assert_str_eq(report.items[0].path, "fluid.surface_tension");
    blocks[0].shape = (sph2d_shape){.kind = SPH2D_SHAPE_BOX, .box = {{0, -0.1}, {1, 0.2}}};
    make_plan();
    ck_assert_double_eq(plan.capillary_head, 0); /* flat from side to side */
}
END_TEST

START_TEST(height_is_against_gravity)
{
    scene.gravity = (sph2d_vec2){G, 0}; /* the lowest side is the right one */
    check_speed(0.8, 0, 0);
    scene.gravity = (sph2d_vec2){0, 2 * G};
    check_speed(0.8, 0, 0);
    scene.gravity = (sph2d_vec2){-3, -4}; /* the lowest place is the corner min; the block's highest corner counts */
    check_speed(0.6 * 0.3 + 0.8 * 0.3, 0, 0);
}
END_TEST

START_TEST(a_named_stiffness_is_taken)
{
    scene.method.stiffness = 49;
    make_plan();
    /* At H/dx = 2 the pairs of a lattice at 1 and sqrt(2) spacings carry so much of p, and summed density grows as
     * density does. */
    double carried = 30 / (TEST_PI * 32) * (1 + sqrt(2) * pow(2 - sqrt(2), 2));
    ck_assert_double_eq_tol(plan.sound_speed, 7 * sqrt(carried), 1e-12);
    ck_assert_double_eq_tol(plan.head, G * 0.3, 1e-12);
    ck_assert_double_eq_tol(plan.impact_compression, sqrt(2 * G * 0.3) / plan.sound_speed, 1e-12);
    ck_assert_ptr_nonnull(strstr(plan.sound_speed_formula, "49"));
}
END_TEST

START_TEST(particles_and_sizes)
{
    scene.method.support_ratio = 2.6;
    scene.fluid.density = 800;
    make_plan();
    ck_assert_uint_eq(plan.fluid_particles, 100);
    ck_assert_uint_eq(plan.wall_particles, 0);
    ck_assert_uint_eq(plan.places_left_free, 0);
    ck_assert_double_eq_tol(plan.particle_mass, 800 * DX * DX, 1e-15);
    ck_assert_double_eq_tol(plan.support_radius, 2.6 * DX, 1e-15);
    ck_assert_double_gt(plan.memory, 100 * 9 * 8);
    ck_assert_double_lt(plan.memory, 1e6);
    sph2d_sim *sim = test_create(&scene, NULL);
    ck_assert(plan.memory == (double)sph2d_sim_memory(sim));
    ck_assert_uint_eq(sph2d_sim_plan(sim)->fluid_particles, 100);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(the_first_step_and_what_limits_it)
{
    make_plan();
    ck_assert_str_eq(plan.time_step_limit, "acoustic");
    ck_assert_double_eq_tol(plan.time_step, 0.4 * plan.support_radius / plan.sound_speed, 1e-15);
    scene.method.cfl = 0.1;
    blocks[0].velocity.x = 2;
    make_plan();
    ck_assert_double_eq_tol(plan.time_step, 0.1 * plan.support_radius / (plan.sound_speed + 2), 1e-15);
    ck_assert_double_eq_tol(plan.steps, scene.run.until / plan.time_step, 1);
    scene.fluid.dynamic_viscosity = 100; /* nu dt/H^2 < 0.145 for this operator on a lattice */
    make_plan();
    double viscous = plan.time_step, h2 = plan.support_radius * plan.support_radius;
    ck_assert_str_eq(plan.time_step_limit, "viscous");
    ck_assert_double_lt(100 / 1000.0 * viscous / h2, 0.145 / 1.5);
    ck_assert_double_gt(100 / 1000.0 * viscous / h2, 0.02);
    scene.fluid.dynamic_viscosity = 200;
    make_plan();
    ck_assert_double_eq_tol(plan.time_step / viscous, 0.5, 1e-12);
    scene.method.time_step = 1e-3;
    make_plan();
    ck_assert_str_eq(plan.time_step_limit, "fixed");
    ck_assert(plan.time_step == 1e-3 && plan.steps == 1000);
}
END_TEST

START_TEST(acceleration_limits_the_step)
{
    scene.gravity.y = -1e5;
    scene.method.stiffness = 1;
    make_plan();
    ck_assert_str_eq(plan.time_step_limit, "force");
    ck_assert_double_eq_tol(plan.time_step, 0.25 * sqrt(plan.support_radius / 1e5), 1e-9);
}
END_TEST

START_TEST(outputs_are_counted)
{
    static const struct {
        sph2d_rate rate;
        double until, count;
    } rows[] = {{{10, 0}, 1, 11},   {{60, 0}, 1, 61}, {{0, 0.3}, 1, 4}, {{0, 0.1}, 0.3, 4},
                {{10, 0}, 0.35, 4}, {{0, 0}, 1, 0},   {{10, 0}, 0, 1},  {{3, 0}, 1, 4}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; ++i) {
        scene.run.until = rows[i].until;
        scene.run.snapshots.rate = scene.run.frames.rate = rows[i].rate;
        make_plan();
        ck_assert_msg(plan.snapshots == rows[i].count && plan.frames == rows[i].count, "row %zu: %g", i, plan.frames);
        ck_assert((plan.disk > 0) == (rows[i].count > 0));
    }
}
END_TEST

/* ---- options ----------------------------------------------------------------------------------------------------- */

START_TEST(wrong_options_are_refused)
{
    for (int k = 0; k < 5; ++k) {
        sph2d_sim_options options = sph2d_sim_options_default();
        options.struct_size = k == 0 ? 0 : options.struct_size;
        options.threads = k == 1 ? -1 : k == 2 ? 1025 : 0;
        options.isa = k == 3 ? (sph2d_isa)4 : k == 4 ? (sph2d_isa)-1 : SPH2D_ISA_AUTO;
        sph2d_sim *sim = (sph2d_sim *)&scene;
        sph2d_report_clear(&report);
        ck_assert_int_eq(sph2d_sim_create(&scene, &options, &sim, &report), SPH2D_INVALID);
        ck_assert_ptr_null(sim);
        ck_assert_uint_eq(report.errors, 1);
    }
    sph2d_sim_destroy(NULL);
}
END_TEST

START_TEST(instruction_sets_have_names)
{
    ck_assert_str_eq(sph2d_isa_name(SPH2D_ISA_AUTO), "auto");
    ck_assert_str_eq(sph2d_isa_name(SPH2D_ISA_BASELINE), "baseline");
    ck_assert_str_eq(sph2d_isa_name(SPH2D_ISA_AVX2), "avx2");
    ck_assert_str_eq(sph2d_isa_name(SPH2D_ISA_AVX512), "avx512");
    ck_assert(sph2d_isa_available(SPH2D_ISA_BASELINE));
    sph2d_sim *sim = test_create(&scene, NULL);
    ck_assert_int_ne(sph2d_sim_isa(sim), SPH2D_ISA_AUTO);
    ck_assert(sph2d_isa_available(sph2d_sim_isa(sim)));
    ck_assert_int_ge(sph2d_sim_threads(sim), 1);
    sph2d_sim_destroy(sim);
}
END_TEST

Suite *suite_plan(void)
{
    Suite *suite = suite_create("plan");
    TCase *tests = tcase_create("plan");
    tcase_add_checked_fixture(tests, start, NULL);
    tcase_add_test(tests, the_sound_speed_comes_from_height_speed_and_pull);
    tcase_add_test(tests, the_speed_of_a_flow_is_that_at_the_edge_of_its_block);
    tcase_add_test(tests, surface_tension_presses_on_drops);
    tcase_add_test(tests, height_is_against_gravity);
    tcase_add_test(tests, a_named_stiffness_is_taken);
    tcase_add_test(tests, particles_and_sizes);
    tcase_add_test(tests, the_first_step_and_what_limits_it);
    tcase_add_test(tests, acceleration_limits_the_step);
    tcase_add_test(tests, outputs_are_counted);
    tcase_add_test(tests, wrong_options_are_refused);
    tcase_add_test(tests, instruction_sets_have_names);
    suite_add_tcase(suite, tests);
    return suite;
}
