/* SPDX-License-Identifier: MIT */
/** @file test_memory.c
 *  Memory from a host's allocator that fails at its k-th call, for every k: each failure is SPH2D_NOMEM, nothing leaks,
 *  sizes are told right, and a step does not allocate once it is warm. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "common.h"

/* ---- an allocator that counts and fails -------------------------------------------------------------------------- */

enum { BLOCKS = 4096 };

typedef struct counter {
    size_t calls, fail_at;      /**< calls that ask for more, and the one that fails; 0 for none */
    size_t bytes, frees, wrong; /**< held now; blocks given back; sizes or blocks that were told wrong */
    void *blocks[BLOCKS];
    size_t sizes[BLOCKS];
} counter;

static counter count;

static size_t slot_of(const void *block)
{
    size_t i = 0;
    while (i < BLOCKS && count.blocks[i] != block)
        ++i;
    return i;
}

static void *resize(void *user, void *block, size_t old_size, size_t new_size)
{
    size_t slot = slot_of(block); /* NULL finds a free slot */
    if (user != &count || slot == BLOCKS || (block ? count.sizes[slot] != old_size : old_size != 0)) {
        ++count.wrong;
        return NULL;
    }
    if (new_size > old_size && ++count.calls == count.fail_at)
        return NULL;
    void *fresh = test_resize(block, old_size, new_size);
    if (new_size > 0 && !fresh)
        return NULL;
    if (new_size > 0) /* what is new is not zero by chance */
        memset((char *)fresh + (old_size < new_size ? old_size : new_size), 0xa5,
               old_size < new_size ? new_size - old_size : 0);
    count.bytes += new_size - old_size;
    count.frees += new_size == 0;
    count.blocks[slot] = fresh;
    count.sizes[slot] = new_size;
    return fresh;
}

static sph2d_sim_options counted(size_t fail_at)
{
    ck_assert_uint_eq(count.bytes, 0);
    count = (counter){.fail_at = fail_at};
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = 1;
    options.allocator = (sph2d_allocator){resize, &count};
    return options;
}

/* ---- a scene that needs all kinds of memory ---------------------------------------------------------------------- */

static const double DX = 0.02;
static sph2d_block block;
static sph2d_source source;
static sph2d_drain drain;
static sph2d_vec2 points[3] = {{0.5, 0.1}, {0.7, 0.25}, {0.9, 0.2}}, corners[3] = {{0, 0}, {0.1, 0}, {0, 0.1}};
static sph2d_obstacle obstacle;
static sph2d_path_point path[2] = {{0, 0.2, 0.3}, {1, 0.6, 0.4}};
static sph2d_interaction pull;
static sph2d_probe probe;
static double impacts[2] = {0.1, 0.2};
static sph2d_scene scene;

static void start(void)
{
    scene = test_scene(DX, 0, 0, 1, 0.8);
    scene.boundary.right = SPH2D_SIDE_OPEN;
    scene.walls = SPH2D_WALL_HEAVY;
    scene.gravity.y = -9.81;
    block = test_block(0.1, 0.1, 0.3, 0.3);
    source = sph2d_source_default();
    source.at = (sph2d_vec2){0.7, 0.6};
    source.width = 20 * DX;
    source.speed = 20; /* rows at a rate that outgrows the store within a few steps */
    drain = sph2d_drain_default();
    drain.shape.kind = SPH2D_SHAPE_POLYGON;
    drain.shape.points = (sph2d_points){corners, 3};
    obstacle = sph2d_obstacle_default();
    obstacle.shape.kind = SPH2D_SHAPE_POLYLINE;
    obstacle.shape.points = (sph2d_points){points, 3};
    pull = sph2d_interaction_default();
    pull.path = (sph2d_path){path, 2};
    pull.radius = 0.3;
    pull.acceleration = 5;
    probe = sph2d_probe_default();
    probe.name = "energy";
    probe.rate.every = 0.1;
    scene.blocks = &block;
    scene.block_count = 1;
    scene.sources = &source;
    scene.source_count = 1;
    scene.drains = &drain;
    scene.drain_count = 1;
    scene.obstacles = &obstacle;
    scene.obstacle_count = 1;
    scene.interactions = &pull;
    scene.interaction_count = 1;
    scene.probes = &probe;
    scene.probe_count = 1;
    scene.run.impacts.items = impacts;
    scene.run.impacts.count = 2;
    scene.run.frames.color = "speed";
}

enum { STEPS = 12 };

/** Makes, steps and asks for the state, with a failure at call `fail_at`. True when nothing failed. */
static bool live(size_t fail_at, const sph2d_state *from)
{
    sph2d_sim_options options = counted(fail_at);
    sph2d_report report = {0};
    sph2d_sim *sim = NULL;
    sph2d_status status = from ? sph2d_sim_restore(&scene, &options, from, &sim, &report)
                               : sph2d_sim_create(&scene, &options, &sim, &report);
    bool failed = fail_at > 0 && count.calls >= fail_at;
    ck_assert_msg(status == (failed ? SPH2D_NOMEM : SPH2D_OK), "call %zu: status %d", fail_at, status);
    if (failed) {
        ck_assert_ptr_null(sim);
        ck_assert_uint_ge(report.errors, 1);
    }
    for (int n = 0; n < STEPS && status == SPH2D_OK; ++n) {
        status = sph2d_sim_step(sim, &report);
        bool fails_here = !failed && fail_at > 0 && count.calls >= fail_at;
        failed = failed || fails_here;
        ck_assert_msg(status == (fails_here ? SPH2D_NOMEM : SPH2D_OK), "call %zu, step %d: status %d", fail_at, n,
                      status);
    }
    if (sim) {
        ck_assert_uint_eq(sph2d_sim_memory(sim), count.bytes);
        bool before = failed;
        size_t arrays = sph2d_sim_state(sim).array_count;
        failed = failed || (fail_at > 0 && count.calls >= fail_at);
        ck_assert_msg((arrays > 0) == !failed, "call %zu: %zu arrays", fail_at, arrays);
        /* There is memory again, but half a step is no state. */
        ck_assert((sph2d_sim_state(sim).array_count > 0) == !before);
        /* After a step without memory there is no way on; a state without memory is no matter. */
        for (int n = 0; failed && n < 3; ++n)
            ck_assert_int_eq(sph2d_sim_step(sim, NULL), status);
        sph2d_sim_destroy(sim);
    }
    ck_assert_msg(count.bytes == 0 && count.wrong == 0, "call %zu: %zu bytes left, %zu wrong", fail_at, count.bytes,
                  count.wrong);
    return !failed;
}

START_TEST(every_allocation_may_fail)
{
    ck_assert(live(0, NULL));
    size_t all = count.calls, k = 1;
    ck_assert_uint_gt(count.frees, 0);
    while (!live(k, NULL))
        ++k;
    ck_assert_uint_gt(k, 30);
    ck_assert_uint_eq(k, all + 1);
}
END_TEST

START_TEST(every_allocation_of_a_restore_may_fail)
{
    sph2d_sim *sim = test_create(&scene, NULL);
    test_steps(sim, 5);
    test_state state = test_state_copy(sim);
    sph2d_sim_destroy(sim);
    size_t k = 1;
    while (!live(k, &state.state))
        ++k;
    ck_assert_uint_gt(k, 30);
    test_state_free(&state);
}
END_TEST

START_TEST(a_plan_gives_everything_back)
{
    sph2d_plan plan;
    ck_assert_int_eq(sph2d_scene_plan(&scene, &plan, NULL), SPH2D_OK); /* the sanitizers watch */
    sph2d_sim_options options = counted(0);
    sph2d_sim *sim = test_create(&scene, &options);
    ck_assert(plan.memory == (double)count.bytes);
    sph2d_sim_destroy(sim);
    ck_assert_uint_eq(count.bytes, 0);
}
END_TEST

START_TEST(a_refused_scene_gives_everything_back)
{
    /* Refused when most of it has been made: all places of the liquid are taken. */
    obstacle.shape.kind = SPH2D_SHAPE_BOX;
    obstacle.shape.box = (sph2d_box){{0.05, 0.05}, {0.35, 0.35}};
    scene.source_count = 0;
    sph2d_sim_options options = counted(0);
    sph2d_sim *sim = NULL;
    ck_assert_int_eq(sph2d_sim_create(&scene, &options, &sim, NULL), SPH2D_SCENE);
    ck_assert_uint_gt(count.calls, 3);
    ck_assert_uint_eq(count.bytes + count.wrong, 0);
}
END_TEST

START_TEST(a_warm_step_does_not_allocate)
{
    /* Without sources. The liquid stays in the same box, as a closed tank keeps it. */
    scene.source_count = 0;
    scene.interaction_count = 0;
    scene.boundary.right = SPH2D_SIDE_WALL;
    scene.domain = (sph2d_box){{0, 0}, {0.4, 0.4}};
    scene.obstacle_count = 0;
    drain.start = 10;
    block = test_block(0, 0, 0.4, 0.3);
    sph2d_sim_options options = counted(0);
    sph2d_sim *sim = test_create(&scene, &options);
    test_steps(sim, 20);
    sph2d_sim_state(sim);
    size_t calls = count.calls, frees = count.frees, bytes = count.bytes;
    for (int n = 0; n < 100; ++n) {
        test_steps(sim, 1);
        sph2d_sim_state(sim);
        sph2d_sim_summary(sim);
    }
    ck_assert_uint_eq(count.calls, calls);
    ck_assert_uint_eq(count.frees, frees);
    ck_assert_uint_eq(count.bytes, bytes);
    ck_assert_uint_eq(sph2d_sim_memory(sim), bytes);
    sph2d_sim_destroy(sim);
    ck_assert_uint_eq(count.bytes, 0);
}
END_TEST

/* ---- counted memory itself --------------------------------------------------------------------------------------- */

START_TEST(memory_is_zeroed_counted_and_aligned)
{
    count = (counter){0};
    sph2d__memory memory = sph2d__memory_from((sph2d_allocator){resize, &count});
    void *items = sph2d__alloc(&memory, 7, 8);
    ck_assert_ptr_nonnull(items);
    ck_assert_uint_eq((uintptr_t)items % 64, 0);
    ck_assert_uint_eq(memory.bytes, 56);
    for (size_t i = 0; i < 7; ++i)
        ck_assert(((uint64_t *)items)[i] == 0);
    ((uint64_t *)items)[6] = 5;
    ck_assert(sph2d__resize(&memory, &items, 7, 1000, 8));
    ck_assert_uint_eq(memory.bytes, 8000);
    ck_assert(((uint64_t *)items)[6] == 5 && ((uint64_t *)items)[7] == 0 && ((uint64_t *)items)[999] == 0);
    ck_assert(!sph2d__resize(&memory, &items, 1000, SIZE_MAX / 4, 8)); /* the product overflows */
    ck_assert(((uint64_t *)items)[6] == 5 && memory.bytes == 8000);
    sph2d__release(&memory, &items, 1000, 8);
    ck_assert(items == NULL && memory.bytes == 0 && count.bytes == 0);
    ck_assert_ptr_null(sph2d__alloc(&memory, 0, 8));
    ck_assert_ptr_null(sph2d__alloc(&memory, SIZE_MAX, SIZE_MAX));
}
END_TEST

START_TEST(an_arena_gives_all_back_at_once)
{
    count = (counter){0};
    sph2d__memory memory = sph2d__memory_from((sph2d_allocator){resize, &count});
    sph2d__arena arena = {0};
    for (size_t n = 1; n < 20; ++n) {
        unsigned char *bytes = sph2d__arena_alloc(&arena, &memory, n, 3);
        ck_assert_ptr_nonnull(bytes);
        for (size_t i = 0; i < 3 * n; ++i)
            ck_assert(bytes[i] == 0);
        memset(bytes, 0xff, 3 * n);
    }
    ck_assert_ptr_null(sph2d__arena_alloc(&arena, &memory, SIZE_MAX, 2));
    sph2d__arena_free(&arena, &memory);
    ck_assert_uint_eq(count.bytes, 0);
    ck_assert_uint_eq(memory.bytes + count.wrong, 0);
}
END_TEST

Suite *suite_memory(void)
{
    Suite *suite = suite_create("memory");
    TCase *tests = tcase_create("memory");
    tcase_add_checked_fixture(tests, start, NULL);
    tcase_add_test(tests, every_allocation_may_fail);
    tcase_add_test(tests, every_allocation_of_a_restore_may_fail);
    tcase_add_test(tests, a_plan_gives_everything_back);
    tcase_add_test(tests, a_refused_scene_gives_everything_back);
    tcase_add_test(tests, a_warm_step_does_not_allocate);
    tcase_add_test(tests, memory_is_zeroed_counted_and_aligned);
    tcase_add_test(tests, an_arena_gives_all_back_at_once);
    suite_add_tcase(suite, tests);
    return suite;
}
