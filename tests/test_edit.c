/* SPDX-License-Identifier: MIT */
/** @file test_edit.c
 *  Liquid that a program adds and removes while it runs: only where there is room, with its energy, by every method, and
 *  the run goes on. */
#include <math.h>

#include "common.h"

static sph2d_scene scene;
static sph2d_block block;
static sph2d_obstacle disc;

static const sph2d_method methods[] = {SPH2D_METHOD_MULLER, SPH2D_METHOD_WCSPH, SPH2D_METHOD_PCISPH,
                                       SPH2D_METHOD_CONSTRAINT};
enum { METHODS = sizeof methods / sizeof methods[0] };

/** A tank of 2 m by 1 m with water 0.3 m deep and a disc that swings above. */
static sph2d_sim *tank(sph2d_method method)
{
    scene = test_scene(0.04, 0, 0, 2, 1);
    scene.method = sph2d_scene_default().method;
    scene.method.name = method;
    scene.gravity = (sph2d_vec2){0, -9.81};
    block = test_block(0, 0, 2, 0.32);
    scene.blocks = &block;
    scene.block_count = 1;
    disc = sph2d_obstacle_default();
    disc.shape = (sph2d_shape){.kind = SPH2D_SHAPE_CIRCLE, .circle = {{1.4, 0.7}, 0.2}};
    disc.motion.amplitude = (sph2d_vec2){0.05, 0};
    disc.motion.frequency = 1;
    scene.obstacles = &disc;
    scene.obstacle_count = 1;
    return test_create(&scene, NULL);
}

static double energy_of(const sph2d_sim *sim)
{
    const sph2d_summary s = sph2d_sim_summary(sim);
    return s.kinetic + s.potential + s.elastic;
}

/** A lattice of drops that fall. */
static size_t make_drops(sph2d_particle *drops)
{
    size_t count = 0;
    for (int j = 0; j < 5; ++j)
        for (int i = 0; i < 5; ++i)
            drops[count++] = (sph2d_particle){.x = 0.5 + 0.04 * i, .y = 0.6 + 0.04 * j, .vx = 0.1, .vy = -1};
    return count;
}

/** What is added has its energy and falls on; ids are new. */
START_TEST(liquid_is_added_with_its_energy)
{
    sph2d_sim *sim = tank(methods[_i]);
    test_steps(sim, 20);
    sph2d_particle drops[25];
    const size_t count = make_drops(drops), before = sph2d_sim_fluid(sim).count;
    const double energy = energy_of(sim), fed = sph2d_sim_summary(sim).energy_fed;
    size_t added = 0;
    ck_assert_int_eq(sph2d_sim_add_particles(sim, drops, count, &added), SPH2D_OK);
    ck_assert_uint_eq(added, 25);
    const sph2d_view fluid = sph2d_sim_fluid(sim);
    ck_assert_uint_eq(fluid.count, before + 25);
    double expected = 0;
    for (size_t k = 0; k < count; ++k)
        expected += 1.6 * ((0.01 + 1) / 2 + 9.81 * drops[k].y); /* mass 1000 dx^2 */
    ck_assert_double_eq_tol(energy_of(sim) - energy, expected, 1e-9 * expected);
    ck_assert_double_eq_tol(sph2d_sim_summary(sim).energy_fed - fed, expected, 1e-9 * expected);
    uint64_t largest = 0;
    for (size_t i = 0; i < fluid.count; ++i)
        largest = fluid.id[i] > largest ? fluid.id[i] : largest;
    size_t news = 0;
    for (size_t i = 0; i < fluid.count; ++i)
        news += fluid.id[i] + 25 > largest && fluid.y[i] > 0.5;
    ck_assert_uint_eq(news, 25);
    test_steps(sim, 400);
    const sph2d_summary after = sph2d_sim_summary(sim);
    ck_assert_double_lt(fabs(after.energy_error), 0.05 * after.energy_scale);
    sph2d_sim_destroy(sim);
}
END_TEST

/** There is no room in the water, in walls, in the disc where it is now, outside, nor twice at one place. */
START_TEST(liquid_is_added_only_where_there_is_room)
{
    sph2d_sim *sim = tank(SPH2D_METHOD_WCSPH);
    while (sph2d_sim_time(sim) < 0.25) /* the disc is at 1.45 */
        test_steps(sim, 1);
    const sph2d_particle full[] = {{.x = 1, .y = 0.15},    {.x = 0.005, .y = 0.6}, {.x = 1.45, .y = 0.7},
                                   {.x = 1.64, .y = 0.7},  {.x = -0.5, .y = 0.5},  {.x = 1, .y = 1.5},
                                   {.x = 1.45, .y = 0.52}, {.x = 1e300, .y = 0}};
    size_t added = 7;
    ck_assert_int_eq(sph2d_sim_add_particles(sim, full, sizeof full / sizeof full[0], &added), SPH2D_OK);
    ck_assert_uint_eq(added, 0);
    const sph2d_particle twice[] = {{.x = 0.5, .y = 0.8}, {.x = 0.51, .y = 0.8}, {.x = 0.5, .y = 0.84}};
    ck_assert_int_eq(sph2d_sim_add_particles(sim, twice, 3, &added), SPH2D_OK);
    ck_assert_uint_eq(added, 2);
    const sph2d_particle left = {.x = 1.2, .y = 0.7}; /* where the disc was at the start */
    ck_assert_int_eq(sph2d_sim_add_particles(sim, &left, 1, &added), SPH2D_OK);
    ck_assert_uint_eq(added, 1);
    const sph2d_particle bad[] = {{.x = 0.7, .y = 0.8}, {.x = 0.8, .y = NAN}};
    const size_t count = sph2d_sim_fluid(sim).count;
    ck_assert_int_eq(sph2d_sim_add_particles(sim, bad, 2, &added), SPH2D_INVALID);
    ck_assert_uint_eq(sph2d_sim_fluid(sim).count, count);
    ck_assert_int_eq(sph2d_sim_add_particles(sim, NULL, 0, NULL), SPH2D_OK);
    sph2d_sim_destroy(sim);
}
END_TEST

/** What is removed takes its energy along, and the run goes on; samples and states see it at once. */
START_TEST(liquid_is_removed_with_its_energy)
{
    sph2d_sim *sim = tank(methods[_i]);
    test_steps(sim, 20);
    const sph2d_shape shape = {.kind = SPH2D_SHAPE_CIRCLE, .circle = {{0.6, 0.16}, 0.1}};
    const size_t before = sph2d_sim_fluid(sim).count;
    size_t removed = 0;
    ck_assert_int_eq(sph2d_sim_remove_particles(sim, &shape, &removed), SPH2D_OK);
    ck_assert_uint_gt(removed, 10);
    ck_assert_uint_eq(sph2d_sim_fluid(sim).count, before - removed);
    ck_assert_uint_eq(sph2d_sim_summary(sim).drained, removed);
    ck_assert_double_lt(sph2d_sim_summary(sim).energy_fed, 0);
    sph2d_sample sample;
    if (sph2d_sim_sample(sim, (sph2d_vec2){0.6, 0.16}, &sample))
        ck_assert_double_lt(sample.neighbours, 20);
    test_steps(sim, 300); /* the hole closes: an impact */
    const sph2d_view fluid = sph2d_sim_fluid(sim);
    for (size_t i = 0; i < fluid.count; ++i)
        ck_assert(fluid.x[i] > 0 && fluid.x[i] < 2 && fluid.y[i] > 0);
    ck_assert_int_eq(sph2d_sim_remove_particles(sim, &shape, NULL), SPH2D_OK);
    const sph2d_shape none = {.kind = SPH2D_SHAPE_BOX, .box = {{5, 5}, {6, 6}}};
    ck_assert_int_eq(sph2d_sim_remove_particles(sim, &none, &removed), SPH2D_OK);
    ck_assert_uint_eq(removed, 0);
    const sph2d_shape bad[] = {{.kind = SPH2D_SHAPE_NONE},
                               {.kind = SPH2D_SHAPE_BOX, .box = {{1, 0}, {0, 1}}},
                               {.kind = SPH2D_SHAPE_BOX, .box = {{0, 0}, {1, NAN}}},
                               {.kind = SPH2D_SHAPE_CIRCLE, .circle = {{0, 0}, -1}},
                               {.kind = SPH2D_SHAPE_CIRCLE, .circle = {{0, INFINITY}, 1}},
                               {.kind = SPH2D_SHAPE_POLYGON, .points = {NULL, 3}},
                               {.kind = SPH2D_SHAPE_POLYGON, .points = {&(sph2d_vec2){0, 0}, 1}}};
    for (size_t k = 0; k < sizeof bad / sizeof bad[0]; ++k)
        ck_assert_int_eq(sph2d_sim_remove_particles(sim, &bad[k], NULL), SPH2D_INVALID);
    const sph2d_shape all = {.kind = SPH2D_SHAPE_BOX, .box = {{-1, -1}, {3, 3}}};
    ck_assert_int_eq(sph2d_sim_remove_particles(sim, &all, NULL), SPH2D_OK);
    ck_assert_uint_eq(sph2d_sim_fluid(sim).count, 0);
    test_steps(sim, 10);
    sph2d_sim_destroy(sim);
}
END_TEST

/** A run that was edited goes on from its state with the same bits. */
START_TEST(an_edited_run_is_resumed)
{
    sph2d_sim *sim = tank(methods[_i]), *again = NULL;
    test_steps(sim, 20);
    sph2d_particle drops[25];
    const size_t count = make_drops(drops);
    const sph2d_shape shape = {.kind = SPH2D_SHAPE_CIRCLE, .circle = {{0.6, 0.16}, 0.1}};
    ck_assert_int_eq(sph2d_sim_add_particles(sim, drops, count, NULL), SPH2D_OK);
    ck_assert_int_eq(sph2d_sim_remove_particles(sim, &shape, NULL), SPH2D_OK);
    const sph2d_state state = sph2d_sim_state(sim);
    sph2d_report report = {0};
    ck_assert_msg(sph2d_sim_restore(&scene, NULL, &state, &again, &report) == SPH2D_OK, "%s",
                  test_report_text(&report));
    test_steps(sim, 50);
    test_steps(again, 50);
    const sph2d_view a = sph2d_sim_fluid(sim), b = sph2d_sim_fluid(again);
    ck_assert_uint_eq(a.count, b.count);
    ck_assert_mem_eq(a.x, b.x, a.count * sizeof *a.x);
    ck_assert_mem_eq(a.vy, b.vy, a.count * sizeof *a.vy);
    sph2d_sim_destroy(again);
    sph2d_sim_destroy(sim);
}
END_TEST

/** Drops with surface tension bring the energy of their surface along. */
START_TEST(added_drops_have_surfaces)
{
    scene = test_scene(0.01, 0, 0, 1, 1);
    scene.method = sph2d_scene_default().method;
    scene.gravity = (sph2d_vec2){0, 0};
    scene.fluid.surface_tension = 10;
    block = test_block(0.2, 0.2, 0.4, 0.4);
    scene.blocks = &block;
    scene.block_count = 1;
    sph2d_sim *sim = test_create(&scene, NULL);
    static sph2d_particle square[400];
    for (int k = 0; k < 400; ++k)
        square[k] = (sph2d_particle){.x = 0.6 + 0.01 * (k % 20), .y = 0.6 + 0.01 * (k / 20)}; /* NOLINT */
    const double before = sph2d_sim_summary(sim).potential;
    ck_assert_int_eq(sph2d_sim_add_particles(sim, square, 400, NULL), SPH2D_OK);
    ck_assert_double_eq_tol(sph2d_sim_summary(sim).energy_fed, before, 1e-6 * before); /* the same square again */
    ck_assert_double_eq_tol(sph2d_sim_summary(sim).potential, 2 * before, 1e-6 * before);
    sph2d_sim_destroy(sim);
}
END_TEST

Suite *suite_edit(void)
{
    Suite *suite = suite_create("edit");
    TCase *cases = tcase_create("edit");
    tcase_add_test(cases, liquid_is_added_only_where_there_is_room);
    tcase_add_loop_test(cases, an_edited_run_is_resumed, 0, METHODS);
    tcase_add_test(cases, added_drops_have_surfaces);
    suite_add_tcase(suite, cases);
    TCase *slow = test_long(suite);
    tcase_add_loop_test(slow, liquid_is_added_with_its_energy, 0, METHODS);
    tcase_add_loop_test(slow, liquid_is_removed_with_its_energy, 0, METHODS);
    return suite;
}
