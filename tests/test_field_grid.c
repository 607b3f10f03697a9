/* SPDX-License-Identifier: MIT */
/** @file test_field_grid.c
 *  Sums of balls' fields, and the tiles in which they are full, or too little to be drawn. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common.h"
#include "render/field_grid.h"
#include "render/tiles.h"
#include "sph2d/render.h"

/** The field of a ball at the middle of a square, by its formula. */
static double field_of(const float at[2], double radius, int column, int row)
{
    const double x = (column + 0.5 - at[0]) / radius, y = (row + 0.5 - at[1]) / radius, square = x * x + y * y;
    return square < 0.5 ? square * square - square + 0.25 : 0.0;
}

enum { COLUMNS = 37, ROWS = 23, BALLS = 60 };

/** Balls inside the grid, across its edges and beside it, small, large and larger than it, of two colours. */
static void add_balls(sph2d__field_grid *grid, double sums[4][ROWS * COLUMNS])
{
    uint64_t seed = 11;
    memset(sums, 0, 4 * sizeof *sums);
    for (int i = 0; i < BALLS; ++i) {
        const float at[2] = {(float)test_random(&seed, -30, COLUMNS + 30), (float)test_random(&seed, -30, ROWS + 30)};
        const double radius = i % 10 == 0 ? 90.0 : test_random(&seed, 0.4, 12.0);
        const float weight = i % 3 == 0 ? 2.5F : 1.0F, color[3] = {(float)(i % 2) * 200.0F, 10.0F, 30.0F};
        sph2d__field_grid_add(grid, at, radius, weight, color);
        for (int k = 0; k < ROWS * COLUMNS; ++k) {
            const double field = weight * field_of(at, radius, k % COLUMNS, k / COLUMNS);
            sums[0][k] += field;
            for (int c = 0; c < 3; ++c)
                sums[c + 1][k] += field * color[c];
        }
    }
}

static void check_sums(const sph2d__field_grid *grid, double sums[4][ROWS * COLUMNS])
{
    for (int k = 0; k < ROWS * COLUMNS; ++k)
        for (int plane = 0; plane < grid->planes; ++plane) {
            const float *row = sph2d__field_grid_row(grid, k / COLUMNS) + (size_t)plane * grid->stride;
            ck_assert_double_eq_tol(row[k % COLUMNS], sums[plane][k], plane ? 2.0e-3 : 2.0e-5);
        }
}

/** With and without colours; and again after sums of another size. */
START_TEST(sums_are_those_of_the_formula)
{
    static double sums[4][ROWS * COLUMNS];
    for (int planes = 1; planes <= 4; planes += 3) {
        sph2d__field_grid grid;
        ck_assert(sph2d__field_grid_create(&grid, COLUMNS + 5, ROWS + 1, planes));
        sph2d__field_grid_add(&grid, (float[2]){20, 10}, 50.0, 1.0F, (float[3]){1, 2, 3});
        for (int again = 0; again < 2; ++again) {
            sph2d__field_grid_reset(&grid, COLUMNS, ROWS);
            add_balls(&grid, sums);
            check_sums(&grid, sums);
        }
        sph2d__field_grid_destroy(&grid);
    }
}
END_TEST

/** Far away and huge they add nothing, or the same everywhere, and overflow nowhere. */
START_TEST(extreme_balls_stay_within_the_grid)
{
    sph2d__field_grid grid;
    ck_assert(sph2d__field_grid_create(&grid, COLUMNS, ROWS, 1));
    static const float far[][2] = {{1e30F, 4}, {-1e30F, 4}, {4, 1e30F}, {4, -1e30F}, {-3.1F, 4}, {COLUMNS + 3.1F, 4}};
    for (size_t i = 0; i < sizeof far / sizeof *far; ++i)
        sph2d__field_grid_add(&grid, far[i], 4.0, 1.0F, NULL);
    ck_assert(grid.top >= grid.bottom);
    sph2d__field_grid_add(&grid, (float[2]){5, 5}, 1e30, 1.0F, NULL);
    for (int k = 0; k < ROWS * COLUMNS; ++k)
        ck_assert_float_eq(sph2d__field_grid_row(&grid, k / COLUMNS)[k % COLUMNS], 0.25F);
    sph2d__field_grid_destroy(&grid);
}
END_TEST

START_TEST(limits_are_those_of_the_box)
{
    static double sums[4][ROWS * COLUMNS];
    uint64_t seed = 5;
    sph2d__field_grid grid;
    ck_assert(sph2d__field_grid_create(&grid, COLUMNS, ROWS, 1));
    add_balls(&grid, sums);
    for (int i = 0; i < 500; ++i) {
        const int left = (int)test_random(&seed, -9, COLUMNS), top = (int)test_random(&seed, -9, ROWS);
        const int right = left + (int)test_random(&seed, 10, 50), bottom = top + (int)test_random(&seed, 10, 50);
        const sph2d__field_limits found = sph2d__field_grid_limits(&grid, left, top, right, bottom);
        float low = HUGE_VALF, high = 0.0F;
        for (int k = 0; k < ROWS * COLUMNS; ++k) {
            const int column = k % COLUMNS, row = k / COLUMNS;
            if (column < left || column >= right || row < top || row >= bottom)
                continue;
            low = fminf(low, sph2d__field_grid_row(&grid, row)[column]);
            high = fmaxf(high, sph2d__field_grid_row(&grid, row)[column]);
        }
        ck_assert_float_eq(found.low, low);
        ck_assert_float_eq(found.high, high);
    }
    sph2d__field_grid_destroy(&grid);
}
END_TEST

/* ---- tiles ------------------------------------------------------------------------------------------------------- */

enum { WIDTH = 203, HEIGHT = 157, SIDE = 40 };

/** A lattice of balls in the middle of an image, with a hole. */
static void add_lattice(sph2d__field_grid *grid, double radius)
{
    for (int i = 0; i < SIDE * SIDE; ++i) {
        const float at[2] = {(float)(11.3 + i % SIDE * 0.5 * radius), (float)(9.1 + i / SIDE * 0.5 * radius)};
        if (hypot(at[0] - 90.0, at[1] - 60.0) > 3.0 * radius)
            sph2d__field_grid_add(grid, at, radius, 1.0F, NULL);
    }
}

/** The kind of a tile tells about each pixel in it what the shader relies on. */
START_TEST(kinds_hold_for_every_pixel)
{
    const sph2d__tile_rule rule = {.lowest = 0.07F, .full = 0.36F, .range = 0.28F, .around = 3.4};
    int count[3] = {0};
    sph2d__field_grid grid;
    sph2d__tiles tiles;
    ck_assert(sph2d__field_grid_create(&grid, WIDTH, HEIGHT, 1));
    ck_assert_int_eq(sph2d__tiles_create(&tiles, WIDTH, HEIGHT, NULL), SPH2D_OK);
    add_lattice(&grid, 6.0);
    sph2d__tiles_find(&tiles, &grid, &rule);
    for (int tile = 0; tile < tiles.columns * tiles.rows; ++tile)
        ++count[tiles.kinds[tile]];
    ck_assert(count[SPH2D__TILE_EMPTY] > 20 && count[SPH2D__TILE_TOUCHED] > 10 && count[SPH2D__TILE_INSIDE] > 10);
    for (int k = 0; k < WIDTH * HEIGHT; ++k) {
        const int column = k % WIDTH, row = k / WIDTH;
        const unsigned char kind = tiles.kinds[row / SPH2D__TILE * tiles.columns + column / SPH2D__TILE];
        if (kind == SPH2D__TILE_EMPTY)
            ck_assert_float_lt(sph2d__field_grid_row(&grid, row)[column], rule.lowest);
        for (int around = 0; around < 81 && kind == SPH2D__TILE_INSIDE; ++around) {
            const int x = column + around % 9 - 4, y = row + around / 9 - 4;
            if (x >= 0 && y >= 0 && x < WIDTH && y < HEIGHT)
                ck_assert_float_ge(sph2d__field_grid_row(&grid, y)[x], rule.full);
        }
    }
    sph2d__tiles_destroy(&tiles);
    sph2d__field_grid_destroy(&grid);
}
END_TEST

/** A block of liquid in an image, and one drop elsewhere; coloured or not. */
static void draw_block(sph2d_renderer *renderer, double x, double y, bool colored)
{
    static double at[2][SIDE * SIDE], values[SIDE * SIDE];
    for (int i = 0; i < SIDE * SIDE; ++i) {
        at[0][i] = x + i % SIDE * 3.0;
        at[1][i] = y + i / SIDE * 3.0; /* NOLINT: whole rows */
        values[i] = i % SIDE;
    }
    at[0][7] = 250.0 - x;
    at[1][7] = y;
    const sph2d_picture picture = {.view = {{0.0, 0.0}, {256, 192}},
                                   .radius = 6.0,
                                   .count = SIDE * SIDE,
                                   .x = at[0],
                                   .y = at[1],
                                   .values = colored ? values : NULL};
    sph2d_report report = {0};
    ck_assert_msg(sph2d_renderer_draw(renderer, &picture, &report) == SPH2D_OK, "%s", test_report_text(&report));
}

/** What earlier pictures left in textures and grids is not seen. */
START_TEST(pictures_do_not_depend_on_those_before)
{
    sph2d_render_options options = sph2d_render_options_default();
    options.width = 256;
    options.height = 192;
    sph2d_renderer *used = NULL;
    ck_assert_int_eq(sph2d_renderer_create(&options, &used, NULL), SPH2D_OK);
    uint64_t seed = 8;
    for (int i = 0; i < 24; ++i) {
        const double x = test_random(&seed, -60, 200), y = test_random(&seed, -100, 170);
        const bool colored = i % 5 == 2 || i % 5 == 3;
        sph2d_renderer *fresh = NULL;
        ck_assert_int_eq(sph2d_renderer_create(&options, &fresh, NULL), SPH2D_OK);
        draw_block(used, x, y, colored);
        draw_block(fresh, x, y, colored);
        ck_assert_mem_eq(sph2d_renderer_pixels(used), sph2d_renderer_pixels(fresh), (size_t)256 * 192 * 4);
        sph2d_renderer_destroy(fresh);
    }
    sph2d_renderer_destroy(used);
}
END_TEST

Suite *suite_field_grid(void)
{
    Suite *suite = suite_create("field_grid");
    TCase *sums = tcase_create("sums");
    tcase_add_test(sums, sums_are_those_of_the_formula);
    tcase_add_test(sums, extreme_balls_stay_within_the_grid);
    tcase_add_test(sums, limits_are_those_of_the_box);
    suite_add_tcase(suite, sums);
    TCase *tiles = tcase_create("tiles");
    tcase_add_test(tiles, kinds_hold_for_every_pixel);
    tcase_add_test(tiles, pictures_do_not_depend_on_those_before);
    suite_add_tcase(suite, tiles);
    return suite;
}
