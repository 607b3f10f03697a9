/* SPDX-License-Identifier: MIT */
/** @file test_lumps.c
 *  The depth of metaballs: few heavy balls in place of many. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common.h"
#include "render/lumps.h"
#include "sph2d/render.h"

/* Weight, centre and what lies near a particle stay what they were. */
START_TEST(sharing_keeps_weight_and_centre)
{
    enum { COLUMNS = 7, ROWS = 5 };
    const double texel = 9.0;
    sph2d__lumps lumps;
    ck_assert_int_eq(sph2d__lumps_create(&lumps, 10, 10, NULL), SPH2D_OK);
    uint64_t seed = 3;
    for (int i = 0; i < 200; ++i) {
        sph2d__lumps_reset(&lumps, COLUMNS, ROWS, texel);
        const float pixel[2] = {(float)test_random(&seed, 4.6, 58.4), (float)test_random(&seed, 4.6, 40.4)};
        ck_assert(sph2d__lumps_add(&lumps, pixel));
        double weight = 0.0, x = 0.0, y = 0.0;
        for (int k = 0; k < COLUMNS * ROWS; ++k) {
            const double node_x = (k % COLUMNS + 0.5) * texel, node_y = (k / COLUMNS + 0.5) * texel;
            ck_assert_float_ge(lumps.weights[k], 0.0F);
            if (lumps.weights[k] > 0.0F)
                ck_assert_double_lt(fmax(fabs(node_x - pixel[0]), fabs(node_y - pixel[1])), texel + 1.0e-4);
            weight += lumps.weights[k];
            x += lumps.weights[k] * node_x;
            y += lumps.weights[k] * node_y;
        }
        ck_assert_double_eq_tol(weight, 1.0, 1.0e-5);
        ck_assert_double_eq_tol(x, pixel[0], 1.0e-3);
        ck_assert_double_eq_tol(y, pixel[1], 1.0e-3);
    }
    sph2d__lumps_destroy(&lumps);
}
END_TEST

START_TEST(beside_the_grid_nothing_is_taken)
{
    static const float beside[][2] = {{4.4F, 20.0F}, {20.0F, 4.4F}, {58.6F, 20.0F}, {20.0F, 40.6F}, {-90.0F, 1.0e9F}};
    sph2d__lumps lumps;
    ck_assert_int_eq(sph2d__lumps_create(&lumps, 7, 5, NULL), SPH2D_OK);
    sph2d__lumps_reset(&lumps, 7, 5, 9.0);
    for (size_t i = 0; i < sizeof beside / sizeof *beside; ++i)
        ck_assert(!sph2d__lumps_add(&lumps, beside[i]));
    for (int k = 0; k < 7 * 5; ++k)
        ck_assert_float_eq(lumps.weights[k], 0.0F);
    sph2d__lumps_destroy(&lumps);
}
END_TEST

enum { WIDTH = 240, HEIGHT = 180, SIDE = 24, RADIUS = 10 };

/** A block of water in the middle of an image, moved to the right by so many pixels; as many pixels are a metre. */
static void draw_block(sph2d_renderer *renderer, int moved)
{
    double x[SIDE * SIDE], y[SIDE * SIDE];
    for (int i = 0; i < SIDE * SIDE; ++i) {
        x[i] = 0.5 * WIDTH + moved + (i % SIDE - 0.5 * SIDE) * 0.5 * RADIUS;
        y[i] = 0.5 * HEIGHT + (i / SIDE - 0.5 * SIDE) * 0.5 * RADIUS;
    }
    const sph2d_picture picture = {
        .view = {{0.0, 0.0}, {WIDTH, HEIGHT}}, .radius = RADIUS, .count = SIDE * SIDE, .x = x, .y = y};
    sph2d_report report = {0};
    ck_assert_msg(sph2d_renderer_draw(renderer, &picture, &report) == SPH2D_OK, "%s", test_report_text(&report));
}

/* Light follows the depth, and must not jump where particles pass from node to node, 15 pixels apart. */
START_TEST(moved_water_looks_the_same)
{
    sph2d_render_options options = sph2d_render_options_default();
    options.width = WIDTH;
    options.height = HEIGHT;
    sph2d_renderer *renderer = NULL;
    ck_assert_int_eq(sph2d_renderer_create(&options, &renderer, NULL), SPH2D_OK);
    draw_block(renderer, 0);
    static unsigned char still[WIDTH * HEIGHT * 4];
    memcpy(still, sph2d_renderer_pixels(renderer), sizeof still);
    for (int moved = 3; moved < 15; moved += 4) {
        draw_block(renderer, moved);
        const unsigned char *pixels = sph2d_renderer_pixels(renderer);
        int largest = 0;
        for (int y = 0; y < HEIGHT; ++y)
            for (int k = 0; k < (WIDTH - moved) * 4; ++k)
                largest = (int)fmax(largest, abs(still[y * WIDTH * 4 + k] - pixels[(y * WIDTH + moved) * 4 + k]));
        ck_assert_int_le(largest, 4);
    }
    sph2d_renderer_destroy(renderer);
}
END_TEST

Suite *suite_lumps(void)
{
    Suite *suite = suite_create("lumps");
    TCase *sharing = tcase_create("sharing");
    tcase_add_test(sharing, sharing_keeps_weight_and_centre);
    tcase_add_test(sharing, beside_the_grid_nothing_is_taken);
    tcase_add_test(sharing, moved_water_looks_the_same);
    suite_add_tcase(suite, sharing);
    return suite;
}
