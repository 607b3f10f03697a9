/* SPDX-License-Identifier: MIT */
/** @file test_periodic.c
 *  Periodic directions: wrapping, nearest images, and neighbours against a search of all pairs. */
#include <math.h>
#include <string.h>

#include "common.h"
#include "particles/cells.h"

enum { MOST = 400 };

static sph2d__memory memory;
static sph2d__store store;
static sph2d__cells cells;

START_TEST(coordinates_come_back_into_the_period)
{
    static const struct {
        double x, wrapped;
    } rows[] = {{0.25, 0.25}, {-1, -1}, {2, -1}, {2.5, -0.5}, {-1.25, 1.75}, {302.5, -0.5}, {-300, 0}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; ++i)
        ck_assert(sph2d__period_wrap(rows[i].x, -1, 3) == rows[i].wrapped);
    double hair = sph2d__period_wrap(-1e-300, 0, 0.1); /* rounds to the upper end, which is the lower one */
    ck_assert(hair == 0);
    ck_assert(sph2d__period_wrap(nextafter(1, 0), 0, 1) == nextafter(1, 0));
    ck_assert(sph2d__period_wrap(17, 0, 0) == 17);
    ck_assert(sph2d__period_wrap(4, 0.3, 3.7) >= 0.3); /* 4 - 3.7 rounds to less */
}
END_TEST

START_TEST(the_nearest_image_is_within_half_a_period)
{
    ck_assert(sph2d__period_nearest(0.4, 1) == 0.4);
    ck_assert_double_eq_tol(sph2d__period_nearest(0.6, 1), -0.4, 1e-15);
    ck_assert_double_eq_tol(sph2d__period_nearest(-0.6, 1), 0.4, 1e-15);
    ck_assert_double_eq_tol(sph2d__period_nearest(7.75, 1), -0.25, 1e-15);
    ck_assert(sph2d__period_nearest(0.6, 0) == 0.6);
}
END_TEST

/* ---- neighbours -------------------------------------------------------------------------------------------------- */

typedef struct room {
    double low_x, low_y, length_x, length_y; /* length 0: not periodic */
    double support;
    bool lattice;
} room;

/* The last two have the least room that is allowed, three supports, and cells that end on the lattice's lines. */
static const room rooms[] = {
    {0, 0, 1, 0, 0.11, false},   {0, 0, 0, 1, 0.11, false}, {-3, 7, 1, 2, 0.23, false},   {1e6, -1e6, 1, 1, 0.2, false},
    {-0.5, 0, 1, 1, 0.25, true}, {0, 0, 1, 0, 0.1, true},   {0, 0, 0.3, 0.3, 0.1, false}, {0, 0, 0.3, 0.9, 0.1, true},
};
enum { ROOMS = sizeof rooms / sizeof rooms[0] };

static void fill(const room *r)
{
    double wide = r->length_x > 0 ? r->length_x : 1, high = r->length_y > 0 ? r->length_y : 1;
    uint64_t seed = 7;
    for (size_t i = 0; i < MOST; ++i) {
        double x = (double)(i % 20) / 20 * wide, y = (double)(i / 20) / 20 * high; /* the lower sides are occupied */
        if (!r->lattice) {
            x = test_random(&seed, 0, wide);
            y = test_random(&seed, 0, high);
        }
        x = sph2d__period_wrap(r->low_x + x, r->low_x, r->length_x);
        y = sph2d__period_wrap(r->low_y + y, r->low_y, r->length_y);
        sph2d__store_add(&store, i, x, y);
    }
}

static double distance2(double dx, double dy)
{
    return dx * dx + dy * dy;
}

/** How often each particle is found within the support of particle i, and whether the way to it is the shortest. */
static void look_around(const room *r, size_t i, int found[MOST])
{
    uint32_t cell = sph2d__cells_find(&cells, store.x[i], store.y[i]);
    ck_assert(cell != UINT32_MAX);
    sph2d__ranges ranges;
    sph2d__cells_ranges(&cells, cell, &ranges);
    SPH2D__FOR_NEIGHBOURS (&ranges, n, j) {
        double dx = store.x[i] + ranges.x[n] - store.x[j], dy = store.y[i] + ranges.y[n] - store.y[j];
        double near_x = sph2d__period_nearest(store.x[i] - store.x[j], r->length_x);
        double near_y = sph2d__period_nearest(store.y[i] - store.y[j], r->length_y);
        if (distance2(dx, dy) < r->support * r->support) {
            ++found[j];
            ck_assert_double_eq_tol(dx, near_x, 1e-9);
            ck_assert_double_eq_tol(dy, near_y, 1e-9);
        }
    }
}

START_TEST(neighbours_are_those_of_the_nearest_images)
{
    const room *r = &rooms[_i % ROOMS];
    memory = sph2d__memory_from((sph2d_allocator){0});
    store = (sph2d__store){.has = SPH2D__STORE_BASIC, .carried = SPH2D__STORE_BASIC};
    cells = (sph2d__cells){.period = {r->low_x, r->low_y, r->length_x, r->length_y}, .columns = _i < ROOMS ? 1 : 4};
    ck_assert(sph2d__store_reserve(&store, &memory, MOST));
    fill(r);
    ck_assert(sph2d__cells_build(&cells, &store, r->support, &memory));
    int pairs = 0;
    for (size_t i = 0; i < MOST; ++i) {
        int found[MOST] = {0};
        look_around(r, i, found);
        for (size_t j = 0; j < MOST; ++j) {
            double dx = sph2d__period_nearest(store.x[i] - store.x[j], r->length_x);
            double dy = sph2d__period_nearest(store.y[i] - store.y[j], r->length_y);
            double r2 = distance2(dx, dy), h2 = r->support * r->support;
            if (fabs(r2 - h2) < 1e-9 * h2)
                continue; /* rounding decides */
            ck_assert_msg(found[j] == (r2 < h2), "room %d: %zu sees %zu %d times at %g", _i, i, j, found[j], sqrt(r2));
            pairs += found[j];
        }
    }
    ck_assert_int_gt(pairs, 5 * MOST);
    sph2d__cells_free(&cells, &memory);
    sph2d__store_free(&store, &memory);
    ck_assert_uint_eq(memory.bytes, 0);
}
END_TEST

Suite *suite_periodic(void)
{
    Suite *suite = suite_create("periodic");
    TCase *tests = tcase_create("periodic");
    tcase_add_test(tests, coordinates_come_back_into_the_period);
    tcase_add_test(tests, the_nearest_image_is_within_half_a_period);
    suite_add_tcase(suite, tests);
    TCase *slow = test_long(suite);
    tcase_add_loop_test(slow, neighbours_are_those_of_the_nearest_images, 0, 2 * ROOMS);
    return suite;
}
