/* SPDX-License-Identifier: MIT */
/** @file test_shared.c
 *  Memory that others hold: it lives until its last user releases it, and no longer (for which the sanitizers look). */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "common.h"
#include "sph2d/field.h"
#include "sph2d/shared.h"

enum { SIZE = 1000, OTHERS = 200 };

/** Takes what was freed for something else. */
static void reuse(sph2d_allocator allocator, size_t size)
{
    void *others[OTHERS];
    for (size_t k = 0; k < OTHERS; ++k) {
        others[k] = allocator.resize(allocator.user, NULL, 0, size);
        ck_assert_ptr_nonnull(others[k]);
        memset(others[k], 0xa5, size);
    }
    for (size_t k = 0; k < OTHERS; ++k)
        allocator.resize(allocator.user, others[k], size, 0);
}

static bool is_all(const unsigned char *block, size_t size, unsigned char value)
{
    for (size_t i = 0; i < size; ++i)
        if (block[i] != value)
            return false;
    return true;
}

START_TEST(a_block_is_resized)
{
    sph2d_allocator a = sph2d_shared_allocator();
    unsigned char *block = a.resize(a.user, NULL, 0, SIZE);
    ck_assert_ptr_nonnull(block);
    ck_assert_uint_eq((uintptr_t)block % 64, 0);
    memset(block, 7, SIZE);
    block = a.resize(a.user, block, SIZE, 3 * SIZE);
    ck_assert(is_all(block, SIZE, 7));
    ck_assert_ptr_null(a.resize(a.user, block, 3 * SIZE, SIZE_MAX - 100)); /* no such memory: the block stays */
    ck_assert_ptr_null(a.resize(a.user, block, 3 * SIZE, SIZE_MAX / 2));
    ck_assert(is_all(block, SIZE, 7));
    block = a.resize(a.user, block, 3 * SIZE, 1);
    ck_assert_uint_eq((uintptr_t)block % 64, 0);
    ck_assert_uint_eq(block[0], 7);
    ck_assert_ptr_null(a.resize(a.user, block, 1, 0));
}
END_TEST

START_TEST(a_held_block_outlives_its_owner)
{
    sph2d_allocator a = sph2d_shared_allocator();
    unsigned char *block = a.resize(a.user, NULL, 0, SIZE);
    memset(block, 7, SIZE);
    sph2d_shared_hold(block);
    sph2d_shared_hold(block);
    unsigned char *larger = a.resize(a.user, block, SIZE, 2 * SIZE);
    ck_assert_ptr_ne(larger, block);
    ck_assert_ptr_null(a.resize(a.user, larger, 2 * SIZE, 0));
    reuse(a, SIZE);
    ck_assert(is_all(block, SIZE, 7));
    sph2d_shared_release(block);
    reuse(a, SIZE);
    ck_assert(is_all(block, SIZE, 7));
    sph2d_shared_release(block);
    sph2d_shared_hold(NULL);
    sph2d_shared_release(NULL);
}
END_TEST

/* ---- of a simulation --------------------------------------------------------------------------------------------- */

enum { ARRAYS = 64 };

/** The arrays of a simulation that are held, and what is in them. */
typedef struct held {
    const double *blocks[ARRAYS];
    size_t arrays, count;
    double *copy;
} held;

static void hold(held *h, const void *block)
{
    ck_assert_uint_lt(h->arrays, ARRAYS);
    if (!block)
        return;
    h->blocks[h->arrays++] = block;
    sph2d_shared_hold(block);
}

static held hold_fluid(const sph2d_sim *sim)
{
    sph2d_view v = sph2d_sim_fluid(sim);
    held h = {.count = v.count};
    const void *arrays[] = {v.x, v.y, v.vx, v.vy, v.ax, v.ay, v.density, v.pressure, v.id};
    for (size_t k = 0; k < sizeof arrays / sizeof arrays[0]; ++k)
        hold(&h, arrays[k]);
    for (size_t k = 0; k < sph2d_field_count(SPH2D_GROUP_FLUID); ++k) {
        sph2d_array field = sph2d_field(sim, SPH2D_GROUP_FLUID, k);
        for (unsigned c = 0; c < field.components && field.stride == 1; ++c)
            hold(&h, field.data[c]);
    }
    return h;
}

static void remember(held *h)
{
    h->copy = calloc(h->arrays * h->count, sizeof(double));
    for (size_t k = 0; k < h->arrays; ++k)
        memcpy(h->copy + k * h->count, h->blocks[k], h->count * sizeof(double));
}

static void release_unchanged(held *h)
{
    for (size_t k = 0; k < h->arrays; ++k) {
        ck_assert(memcmp(h->copy + k * h->count, h->blocks[k], h->count * sizeof(double)) == 0);
        sph2d_shared_release(h->blocks[k]);
    }
    free(h->copy);
}

/** An empty tank with a jet, so that its memory grows. */
static sph2d_sim *make_jet(void)
{
    sph2d_scene scene = sph2d_scene_default();
    scene.domain = (sph2d_box){{0, 0}, {1, 1}};
    scene.spacing = 0.05;
    scene.fluid.dynamic_viscosity = 1;
    sph2d_source source = sph2d_source_default();
    source.at = (sph2d_vec2){0.5, 0.9};
    source.speed = 3;
    source.width = 0.3;
    scene.sources = &source;
    scene.source_count = 1;
    sph2d_sim_options options = sph2d_sim_options_default();
    options.allocator = sph2d_shared_allocator();
    sph2d_sim *sim = NULL;
    ck_assert_int_eq(sph2d_sim_create(&scene, &options, &sim, NULL), SPH2D_OK);
    return sim;
}

START_TEST(views_outlive_steps_and_the_simulation)
{
    sph2d_sim *sim = make_jet();
    while (sph2d_sim_fluid(sim).count < 10)
        ck_assert_int_eq(sph2d_sim_step(sim, NULL), SPH2D_OK);
    held before = hold_fluid(sim);
    for (size_t memory = sph2d_sim_memory(sim); sph2d_sim_memory(sim) < memory + 10000;)
        ck_assert_int_eq(sph2d_sim_step(sim, NULL), SPH2D_OK);
    remember(&before); /* freed by the simulation as it grew: nothing changes it any more */
    held after = hold_fluid(sim);
    for (size_t k = 0; k < after.arrays; ++k)
        for (size_t j = 0; j < before.arrays; ++j)
            ck_assert_ptr_ne(after.blocks[k], before.blocks[j]);
    for (int k = 0; k < 20; ++k)
        ck_assert_int_eq(sph2d_sim_step(sim, NULL), SPH2D_OK);
    remember(&after);
    sph2d_sim_destroy(sim);
    sph2d_sim *other = make_jet();
    for (int k = 0; k < 100; ++k)
        ck_assert_int_eq(sph2d_sim_step(other, NULL), SPH2D_OK);
    sph2d_sim_destroy(other);
    release_unchanged(&before);
    release_unchanged(&after);
}
END_TEST

Suite *suite_shared(void)
{
    Suite *suite = suite_create("shared");
    TCase *tests = tcase_create("shared");
    tcase_add_test(tests, a_block_is_resized);
    tcase_add_test(tests, a_held_block_outlives_its_owner);
    tcase_add_test(tests, views_outlive_steps_and_the_simulation);
    suite_add_tcase(suite, tests);
    return suite;
}
