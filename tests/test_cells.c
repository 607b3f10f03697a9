/* SPDX-License-Identifier: MIT */
/** @file test_cells.c
 *  Cells against an all-pairs search: every pair within the support must be found, and found once, in ordinary and in
 *  degenerate layouts; the order is a stable permutation; memory stays in proportion to the particles. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common.h"
#include "particles/cells.h"

enum { MOST = 500 };
static const double H = 0.01;

static sph2d__memory memory;
static sph2d__store store;
static sph2d__cells cells;

static void start(uint32_t columns)
{
    memory = sph2d__memory_from((sph2d_allocator){0});
    store = (sph2d__store){.has = SPH2D__STORE_BASIC, .carried = SPH2D__STORE_BASIC};
    cells = (sph2d__cells){.columns = columns};
    ck_assert(sph2d__store_reserve(&store, &memory, MOST));
}

static void start_square(void)
{
    start(1);
}

static void start_narrow(void)
{
    start(4);
}

static void finish(void)
{
    sph2d__cells_free(&cells, &memory);
    sph2d__store_free(&store, &memory);
    ck_assert_uint_eq(memory.bytes, 0);
}

static void add(double x, double y)
{
    sph2d__store_add(&store, store.count, x, y);
}

static void add_random(size_t count, uint64_t seed, double x0, double y0, double x1, double y1)
{
    for (size_t i = 0; i < count; ++i) {
        double x = test_random(&seed, x0, x1);
        add(x, test_random(&seed, y0, y1));
    }
}

static void add_lattice(size_t n, double x0, double y0, double step)
{
    for (size_t i = 0; i < n * n; ++i)
        add(x0 + step * (double)(i % n), y0 + step * (double)(i / n));
}

/* ---- layouts ----------------------------------------------------------------------------------------------------- */

static void lay_random(void)
{
    add_random(500, 1, -5 * H, 3 * H, 7 * H, 14 * H);
}

static void lay_dense(void)
{
    add_random(400, 2, 0, 0, 2 * H, 2 * H);
}

static void lay_on_cell_edges(void)
{
    add_lattice(12, 0, 0, H); /* at multiples of the support from the lowest particle, where edges would be */
    for (int i = 0; i < 60; ++i)
        add(nextafter(H * (i % 12), i % 2 ? 1 : -1), H * (i / 12));
}

static void lay_on_wider_cell_edges(void)
{
    add_lattice(11, -3.3 * H, 0, H * (1 + 1e-6)); /* and where the edges are if a cell is a little wider */
    add_lattice(9, 0.1 * H, 0.1 * H, nextafter(H * (1 + 1e-6), 0));
}

static void lay_in_corner(void)
{
    add(0, 0);
    add(20 * H, 20 * H);
    add_random(100, 3, 19.9 * H, 19.9 * H, 20 * H, 20 * H);
    add_random(100, 4, 0, 0, 0.01 * H, 0.01 * H);
}

static void lay_all_in_one_cell(void)
{
    add_random(300, 5, 0.2 * H, 0.2 * H, 0.7 * H, 0.7 * H);
}

static void lay_one(void)
{
    add(0.3, -0.7);
}

static void lay_none(void)
{
}

static void lay_coincident(void)
{
    for (int i = 0; i < 60; ++i)
        add(1.25, -3.5);
    add_random(20, 6, 1.25 - 2 * H, -3.5 - 2 * H, 1.25 + 2 * H, -3.5 + 2 * H);
    add(1.25 + 1e-300, -3.5);
}

static void lay_domain_of_one_cell(void)
{
    add(0, 0);
    add(H, 0);
    add(0, H);
    add(H, H);
    add_random(100, 7, 0, 0, H, H);
}

static void lay_narrow_strip(void)
{
    add_random(400, 8, 0, 0, 300 * H, 0.001 * H);
}

static void lay_long_strip(void)
{
    add_random(300, 9, 0, 0, 1e-3 * H, 1e6 * H); /* far more cells than particles */
    add_random(100, 10, 0, 5e5 * H, 1e-3 * H, 5e5 * H + 20 * H);
}

static void lay_far_from_origin(void)
{
    add_random(400, 11, 1e6 * H, -1e6 * H, 1e6 * H + 8 * H, -1e6 * H + 8 * H);
}

static void lay_two_far_groups(void)
{
    add_random(200, 12, 0, 0, 5 * H, 5 * H);
    add_random(200, 13, 1e9 * H, 1e9 * H, 1e9 * H + 5 * H, 1e9 * H + 5 * H);
}

static void lay_one_very_far(void)
{
    add_random(200, 14, 0, 0, 5 * H, 5 * H);
    add(1e12, 0);
    add(0, -1e12);
}

static void lay_one_beyond_all_measure(void)
{
    add_random(200, 15, 0, 0, 5 * H, 5 * H);
    add(1e200, -1e200); /* finite all the same */
}

static void lay_column(void)
{
    for (int i = 0; i < 200; ++i)
        add(0.123, 0.37 * H * i);
}

static void lay_row(void)
{
    for (int i = 0; i < 200; ++i)
        add(-0.37 * H * i, 0.456);
}

static void lay_aligned_lattice(void)
{
    add_lattice(20, -4 * H, -4 * H, H / 2);
}

static void lay_support_apart(void)
{
    for (int i = 0; i < 40; ++i) { /* distances of H (1 +- 1e-15) and H */
        double d = i % 3 == 0 ? H : i % 3 == 1 ? H * (1 + 1e-15) : H * (1 - 1e-15);
        add(5 * H * i, 0);
        add(5 * H * i + (i % 2 ? d : 0), i % 2 ? 0 : d);
    }
}

static void (*const layouts[])(void) = {
    lay_random,         lay_dense,        lay_on_cell_edges,      lay_on_wider_cell_edges,
    lay_in_corner,      lay_one,          lay_all_in_one_cell,    lay_none,
    lay_coincident,     lay_narrow_strip, lay_domain_of_one_cell, lay_long_strip,
    lay_two_far_groups, lay_one_very_far, lay_far_from_origin,    lay_one_beyond_all_measure,
    lay_column,         lay_row,          lay_aligned_lattice,    lay_support_apart,
};
enum { LAYOUTS = sizeof layouts / sizeof layouts[0] };

/* ---- what must hold ---------------------------------------------------------------------------------------------- */

static bool near(double x, double y, size_t j)
{
    return hypot(x - store.x[j], y - store.y[j]) <= H;
}

/** Particles within H of a place that the ranges give not exactly once, and particles that they give twice. */
static size_t mistakes_at(double x, double y)
{
    static unsigned char seen[MOST];
    memset(seen, 0, sizeof seen);
    size_t mistakes = 0;
    uint32_t cell = sph2d__cells_find(&cells, x, y);
    if (cell != UINT32_MAX) {
        sph2d__ranges ranges;
        sph2d__cells_ranges(&cells, cell, &ranges);
        SPH2D__FOR_NEIGHBOURS (&ranges, r, j) {
            if (j < store.count)
                ++seen[j];
            else
                ++mistakes;
        }
    }
    for (size_t j = 0; j < store.count; ++j)
        mistakes += seen[j] > 1 || (seen[j] == 0 && near(x, y, j));
    return mistakes;
}

static void build(void)
{
    ck_assert(sph2d__cells_build(&cells, &store, H, &memory));
}

START_TEST(every_pair_is_found_once)
{
    layouts[_i]();
    build();
    size_t mistakes = 0;
    for (size_t i = 0; i < store.count; ++i)
        mistakes += mistakes_at(store.x[i], store.y[i]);
    ck_assert_msg(mistakes == 0, "layout %d: %zu pairs", _i, mistakes);
}
END_TEST

START_TEST(every_place_finds_its_neighbours)
{
    layouts[_i]();
    build();
    size_t mistakes = 0;
    uint64_t random = 77;
    for (size_t i = 0; i < store.count; ++i)
        for (int k = 0; k < 4; ++k) {
            double x = store.x[i] + test_random(&random, -1.5, 1.5) * H;
            mistakes += mistakes_at(x, store.y[i] + test_random(&random, -1.5, 1.5) * H);
        }
    mistakes += mistakes_at(0, 0) + mistakes_at(1e30, 0) + mistakes_at(-1e30, 1e30);
    ck_assert_msg(mistakes == 0, "layout %d: %zu places", _i, mistakes);
    ck_assert_uint_eq(sph2d__cells_find(&cells, NAN, 0), UINT32_MAX);
}
END_TEST

START_TEST(the_order_is_a_stable_permutation)
{
    layouts[_i]();
    static double x[MOST], y[MOST];
    size_t count = store.count;
    for (size_t i = 0; i < count; ++i) {
        x[i] = store.x[i];
        y[i] = store.y[i];
    }
    build();
    ck_assert_uint_eq(store.count, count);
    unsigned char met[MOST] = {0};
    bool same = true, permutation = true, stable = true;
    for (size_t k = 0; k < count; ++k) {
        uint32_t i = cells.order[k];
        permutation = permutation && i < count && !met[i]++;
        same = same && store.id[k] == i && store.x[k] == x[i] && store.y[k] == y[i];
    }
    /* Within one cell the order stays what it was; start[] cuts the particles into cells without a rest. */
    size_t all = (size_t)cells.nx * cells.ny;
    for (size_t c = 0; c < all; ++c)
        for (uint32_t k = cells.start[c]; k + 1 < cells.start[c + 1]; ++k)
            stable = stable && store.id[k] < store.id[k + 1];
    ck_assert(permutation && same && stable);
    ck_assert_uint_eq(cells.start[0], 0);
    ck_assert_uint_eq(cells.start[all], count);
    build(); /* sorted already: nothing moves */
    for (size_t k = 0; k < count; ++k)
        stable = stable && cells.order[k] == k;
    ck_assert(stable);
}
END_TEST

START_TEST(memory_is_in_proportion)
{
    layouts[_i]();
    size_t before = memory.bytes;
    build();
    size_t taken = memory.bytes - before;
    ck_assert_msg(taken <= 200 * MOST + 65536, "layout %d takes %zu bytes", _i, taken);
}
END_TEST

START_TEST(cells_are_no_narrower_than_the_support)
{
    layouts[_i]();
    build();
    ck_assert_double_le(fmax(cells.inverse_x / cells.columns, cells.inverse_y) * H, 1);
}
END_TEST

START_TEST(a_big_sparse_cloud_takes_memory_for_its_particles)
{
    enum { COUNT = 20000 };
    ck_assert(sph2d__store_reserve(&store, &memory, COUNT));
    size_t before = memory.bytes;
    add_random(COUNT / 2, 20, 0, 0, 100 * H, 100 * H);
    add_random(COUNT / 2, 21, 1e9 * H, 1e8 * H, 1e9 * H + 100 * H, 1e8 * H + 100 * H);
    build();
    ck_assert_uint_le(memory.bytes - before, 200 * COUNT + 65536);
    /* Rebuilding gives the same memory, not more. */
    size_t after = memory.bytes;
    for (int i = 0; i < 5; ++i)
        build();
    ck_assert_uint_eq(memory.bytes, after);
}
END_TEST

START_TEST(threads_do_not_change_the_order)
{
    enum { COUNT = 6000 };
    static uint64_t ids[COUNT];
    ck_assert(sph2d__store_reserve(&store, &memory, COUNT));
    add_random(COUNT, 30, -20 * H, 0, 20 * H, 30 * H);
    build();
    memcpy(ids, store.id, sizeof ids);
    for (int threads = 2; threads <= 5; threads += 3) {
        store.count = 0;
        add_random(COUNT, 30, -20 * H, 0, 20 * H, 30 * H);
        bool built = false;
#pragma omp parallel num_threads(threads)
#pragma omp master
        built = sph2d__cells_build(&cells, &store, H, &memory);
        ck_assert(built);
        ck_assert_mem_eq(ids, store.id, sizeof ids);
    }
}
END_TEST

static void add_tests(Suite *suite, const char *name, void (*begin)(void))
{
    TCase *tests = tcase_create(name);
    tcase_add_checked_fixture(tests, begin, finish);
    tcase_add_loop_test(tests, every_pair_is_found_once, 0, LAYOUTS);
    tcase_add_loop_test(tests, every_place_finds_its_neighbours, 0, LAYOUTS);
    tcase_add_loop_test(tests, the_order_is_a_stable_permutation, 0, LAYOUTS);
    tcase_add_loop_test(tests, memory_is_in_proportion, 0, LAYOUTS);
    tcase_add_loop_test(tests, cells_are_no_narrower_than_the_support, 0, LAYOUTS);
    tcase_add_test(tests, a_big_sparse_cloud_takes_memory_for_its_particles);
    tcase_add_test(tests, threads_do_not_change_the_order);
    suite_add_tcase(suite, tests);
}

Suite *suite_cells(void)
{
    Suite *suite = suite_create("cells");
    add_tests(suite, "square", start_square);
    add_tests(suite, "narrow", start_narrow);
    return suite;
}
