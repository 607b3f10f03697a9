/* SPDX-License-Identifier: MIT */
/** @file test_store.c
 *  The particle store: room, adding, removing, reordering (particles/store.h). */
#include <stdlib.h>

#include "common.h"
#include "particles/store.h"

static sph2d__memory memory;
static sph2d__store store;

/* Arrays of every kind: one is not there at all, some do not go along into a new order. */
static const sph2d__set ALL = ~(sph2d__set)0 >> (8 * sizeof(sph2d__set) - SPH2D__STORE_COUNT);
static const sph2d__set CARRIED =
    SPH2D__STORE_BASIC | SPH2D__BIT(ax) | SPH2D__BIT(density) | SPH2D__BIT(older_density_rate);

static void start(void)
{
    memory = sph2d__memory_from((sph2d_allocator){0});
    store = (sph2d__store){.has = ALL & ~SPH2D__BIT(shift_x), .carried = CARRIED};
}

static void finish(void)
{
    sph2d__store_free(&store, &memory);
    ck_assert_uint_eq(memory.bytes, 0);
}

/** A particle whose every value tells its id: array a of particle i holds 100 i + a. */
static void fill(size_t count)
{
    ck_assert(sph2d__store_reserve(&store, &memory, count));
    for (size_t i = 0; i < count; ++i) {
        ck_assert_uint_eq(sph2d__store_add(&store, 1000 + i, 0, 0), i);
        int a = 0;
#define SET(name)                                                                                                      \
    if (store.name)                                                                                                    \
        store.name[i] = (double)(100 * i) + a;                                                                         \
    ++a;
        SPH2D__STORE_REALS(SET)
#undef SET
    }
}

/** Particle k must be the one that `fill` made as number i; values that are not carried are left out when sorted. */
static bool holds(size_t k, size_t i, bool sorted)
{
    bool same = store.id[k] == 1000 + i;
    int a = 0;
#define SAME(name)                                                                                                     \
    same =                                                                                                             \
        same && (!store.name || (sorted && !(CARRIED & SPH2D__BIT(name))) || store.name[k] == (double)(100 * i) + a);  \
    ++a;
    SPH2D__STORE_REALS(SAME)
#undef SAME
    return same;
}

START_TEST(only_the_arrays_of_the_set_are_there)
{
    fill(5);
    ck_assert_ptr_null(store.shift_x);
    ck_assert_ptr_nonnull(store.shift_y);
    size_t length = store.capacity + SPH2D__PADDING;
    ck_assert_uint_eq(memory.bytes, length * sph2d__store_bytes(&store));
    const sph2d__store basic = {.has = SPH2D__STORE_BASIC}, colored = {.has = SPH2D__STORE_BASIC, .colored = true};
    ck_assert_uint_eq(sph2d__store_bytes(&basic), (4 + 1) * sizeof(double) + sizeof(uint64_t));
    ck_assert_uint_eq(sph2d__store_bytes(&colored), (4 + 1) * sizeof(double) + 2 * sizeof(uint64_t));
}
END_TEST

START_TEST(a_new_particle_is_at_rest_and_empty)
{
    ck_assert(sph2d__store_reserve(&store, &memory, 3));
    ck_assert_uint_ge(store.capacity, 3);
    ck_assert_uint_eq(store.count, 0);
    size_t i = sph2d__store_add(&store, 42, 1.5, -2.5);
    ck_assert_uint_eq(i, 0);
    ck_assert_uint_eq(store.count, 1);
    ck_assert_uint_eq(store.id[0], 42);
    ck_assert(store.x[0] == 1.5 && store.y[0] == -2.5);
    ck_assert(store.vx[0] == 0 && store.vy[0] == 0 && store.ax[0] == 0 && store.ay[0] == 0);
    ck_assert(store.density[0] == 0 && store.pressure[0] == 0);
}
END_TEST

START_TEST(reserving_keeps_what_is_there)
{
    fill(5);
    for (size_t capacity = 6; capacity < 3000; capacity += 331) {
        ck_assert(sph2d__store_reserve(&store, &memory, capacity));
        ck_assert_uint_ge(store.capacity, capacity);
        ck_assert_uint_eq(store.count, 5);
        for (size_t i = 0; i < 5; ++i)
            ck_assert(holds(i, i, false));
    }
    size_t bytes = memory.bytes;
    ck_assert(sph2d__store_reserve(&store, &memory, 4)); /* never shrinks */
    ck_assert_uint_eq(memory.bytes, bytes);
}
END_TEST

START_TEST(lanes_may_read_behind_the_last)
{
    /* The padding exists and is zero: blocks of lanes run over the end (the sanitizers watch this read). */
    fill(7);
    ck_assert(sph2d__store_reserve(&store, &memory, store.capacity));
    double sum = 0;
    for (size_t i = store.capacity; i < store.capacity + SPH2D__PADDING; ++i)
        sum += store.x[i] + store.vx[i] + store.pressure[i] + store.volume[i];
    ck_assert(sum == 0);
}
END_TEST

START_TEST(removing_keeps_the_order_of_the_rest)
{
    enum { COUNT = 200 };
    fill(COUNT);
    unsigned char flags[COUNT] = {0};
    uint64_t random = 5;
    for (size_t i = 0; i < COUNT; ++i)
        flags[i] = i == 0 || i == COUNT - 1 || test_random(&random, 0, 1) < 0.4;
    sph2d__store_remove(&store, flags);
    size_t k = 0;
    bool same = true;
    for (size_t i = 0; i < COUNT; ++i)
        if (!flags[i]) {
            same = same && k < store.count && holds(k, i, false);
            ++k;
        }
    ck_assert(same);
    ck_assert_uint_eq(store.count, k);
}
END_TEST

START_TEST(removing_none_or_all)
{
    fill(9);
    unsigned char none[9] = {0}, all[9] = {1, 1, 1, 1, 1, 1, 1, 1, 1};
    sph2d__store_remove(&store, none);
    ck_assert_uint_eq(store.count, 9);
    ck_assert(holds(8, 8, false));
    sph2d__store_remove(&store, all);
    ck_assert_uint_eq(store.count, 0);
    sph2d__store_remove(&store, none); /* of an empty store */
    ck_assert_uint_eq(store.count, 0);
    ck_assert_uint_eq(sph2d__store_add(&store, 1, 0, 0), 0);
}
END_TEST

START_TEST(reordering_carries_every_value)
{
    enum { COUNT = 3000 }; /* enough for a second thread */
    fill(COUNT);
    uint32_t *order = malloc(COUNT * sizeof *order);
    ck_assert_ptr_nonnull(order);
    for (uint32_t i = 0; i < COUNT; ++i)
        order[i] = i;
    uint64_t random = 3;
    for (uint32_t i = COUNT - 1; i > 0; --i) {
        uint32_t j = (uint32_t)test_random(&random, 0, i + 1.0), was = order[i];
        order[i] = order[j];
        order[j] = was;
    }
#pragma omp parallel num_threads(2)
#pragma omp master
    sph2d__store_reorder(&store, order);
    bool same = store.count == COUNT;
    for (size_t k = 0; k < COUNT; ++k)
        same = same && holds(k, order[k], true);
    free(order);
    ck_assert(same);
}
END_TEST

START_TEST(too_much_is_refused_and_changes_nothing)
{
    fill(4);
    size_t bytes = memory.bytes, capacity = store.capacity;
    ck_assert(!sph2d__store_reserve(&store, &memory, SIZE_MAX / 4));
    ck_assert_uint_eq(memory.bytes, bytes);
    ck_assert_uint_eq(store.capacity, capacity);
    for (size_t i = 0; i < 4; ++i)
        ck_assert(holds(i, i, false));
}
END_TEST

Suite *suite_store(void)
{
    Suite *suite = suite_create("store");
    TCase *tests = tcase_create("store");
    tcase_add_checked_fixture(tests, start, finish);
    tcase_add_test(tests, only_the_arrays_of_the_set_are_there);
    tcase_add_test(tests, a_new_particle_is_at_rest_and_empty);
    tcase_add_test(tests, reserving_keeps_what_is_there);
    tcase_add_test(tests, lanes_may_read_behind_the_last);
    tcase_add_test(tests, removing_keeps_the_order_of_the_rest);
    tcase_add_test(tests, removing_none_or_all);
    tcase_add_test(tests, reordering_carries_every_value);
    tcase_add_test(tests, too_much_is_refused_and_changes_nothing);
    suite_add_tcase(suite, tests);
    return suite;
}
