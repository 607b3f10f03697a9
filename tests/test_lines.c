/* SPDX-License-Identifier: MIT */
/** @file test_lines.c
 *  Arrows and isolines: linear fields are exact, lines are where the field has its levels, arrows point along the velocity
 *  and are as long as the caption's, colours of values of either sign, and nonsense is refused or harmless. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "render/legend.h"
#include "render/sampled.h"
#include "sph2d/render.h"
#include "splash.h"

/* A tank of 1.28 m x 0.72 m, all of it liquid at 500 pixels a metre. */
enum { ACROSS = 128, UP = 72, COUNT = ACROSS * UP, WIDTH = 640, HEIGHT = 360 };
static double x[COUNT], y[COUNT], vx[COUNT], vy[COUNT], values[COUNT];
static sph2d_picture picture;

static void fill(void)
{
    for (int i = 0; i < COUNT; ++i) {
        x[i] = (i % ACROSS + 0.5) * 0.01 + 0.002 * sin(7.0 * i);
        y[i] = (i / ACROSS + 0.5) * 0.01 + 0.002 * cos(11.0 * i); /* NOLINT: whole rows */
        vx[i] = 1.5;
        vy[i] = 0.0;
        values[i] = 3.0 * x[i] - 2.0 * y[i] + 1.0;
    }
    picture = (sph2d_picture){
        .view = {{0, 0}, {1.28, 0.72}}, .radius = 0.02, .spacing = 0.01, .count = COUNT, .x = x, .y = y};
}

START_TEST(linear_fields_are_exact)
{
    sph2d__sampled sampled = {0};
    const sph2d__samples samples = {COUNT, x, y, values, vx, 0.01};
    const double steps[] = {0.01, 0.037, 0.004};
    for (int k = 0; k < 3; ++k) {
        ck_assert(sph2d__sampled_take(&sampled, picture.view, steps[k], &samples));
        ck_assert_int_eq(sampled.columns, (int)floor(1.28 / steps[k] + 1e-9) + 1);
        int nodes = 0;
        for (int row = 0; row < sampled.rows; ++row)
            for (int column = 0; column < sampled.columns; ++column) {
                double at[2];
                if (!sph2d__sampled_at(&sampled, column, row, 0.3, at))
                    continue;
                const sph2d_vec2 place = sph2d__sampled_place(&sampled, column, row);
                ck_assert_double_eq_tol(at[0], 3.0 * place.x - 2.0 * place.y + 1.0, 1e-10);
                ck_assert_double_eq_tol(at[1], 1.5, 1e-10);
                ++nodes;
            }
        ck_assert_int_gt(nodes, sampled.rows * sampled.columns * 9 / 10); /* up to walls, but for corners */
    }
    double none[2];
    ck_assert(sph2d__sampled_take(&sampled, (sph2d_box){{1.5, 0}, {2, 1}}, 0.1, &samples)); /* no liquid there */
    for (int column = 0; column < sampled.columns; ++column)
        ck_assert(!sph2d__sampled_at(&sampled, column, 0, 0.0, none));
    sph2d__sampled_free(&sampled);
}
END_TEST

static bool is_dark(const unsigned char *pixels, int column, int row)
{
    const unsigned char *p = pixels + (size_t)4 * ((size_t)row * WIDTH + (size_t)column);
    return p[0] < 120 && p[1] < 120 && p[2] < 120;
}

static sph2d_renderer *make_flat(void)
{
    sph2d_render_options options = sph2d_render_options_default();
    options.width = WIDTH;
    options.height = HEIGHT;
    options.look = SPH2D_LOOK_FLAT;
    sph2d_renderer *renderer = NULL;
    ck_assert_int_eq(sph2d_renderer_create(&options, &renderer, NULL), SPH2D_OK);
    return renderer;
}

/** Levels of 3 x - 2 y + 1 half a unit apart cross the row at y = 0.36 where x = (k/2 - 1 + 0.72)/3. */
START_TEST(isolines_are_at_their_levels)
{
    sph2d_renderer *renderer = make_flat();
    picture.level_values = values;
    picture.level_step = 0.5;
    const unsigned char *pixels = draw(renderer, &picture);
    int found = 0;
    for (int column = 0; column < WIDTH; ++column)
        if (is_dark(pixels, column, 180)) {
            const double level = 3.0 * (column + 0.5) / 500.0 - 2.0 * 0.359 + 1.0;
            ck_assert_msg(fabs(level - 0.5 * round(level / 0.5)) < 0.013, "a line at level %g", level);
            found += !is_dark(pixels, column - 1, 180);
        }
    ck_assert_int_eq(found, 8); /* levels 0.5 to 4, of 0.28 to 4.12 */
    sph2d_renderer_destroy(renderer);
}
END_TEST

/** Without a step it is a round one, for about ten lines; a step too small for pixels becomes larger. */
START_TEST(isolines_have_a_sensible_number)
{
    sph2d_renderer *renderer = make_flat();
    picture.level_values = values;
    const double steps[] = {0.0, 1e-9, DBL_MIN, 1e300};
    const int least[] = {5, 30, 30, 0}, most[] = {15, 320, 320, 0};
    for (int k = 0; k < 4; ++k) {
        picture.level_step = steps[k];
        const unsigned char *pixels = draw(renderer, &picture);
        int found = 0;
        for (int column = 1; column < WIDTH; ++column)
            found += is_dark(pixels, column, 180) && !is_dark(pixels, column - 1, 180);
        ck_assert_msg(found >= least[k] && found <= most[k], "step %g: %d lines", steps[k], found);
    }
    sph2d_renderer_destroy(renderer);
}
END_TEST

/** The box of the dark pixels in a part of the image. */
typedef struct extent {
    int left, right, top, bottom, count;
} extent;

static extent dark_in(const unsigned char *pixels, int left, int top, int right, int bottom)
{
    extent e = {WIDTH, -1, HEIGHT, -1, 0};
    for (int row = top; row < bottom; ++row)
        for (int column = left; column < right; ++column)
            if (is_dark(pixels, column, row)) {
                e.left = column < e.left ? column : e.left;
                e.right = column > e.right ? column : e.right;
                e.top = row < e.top ? row : e.top;
                e.bottom = row > e.bottom ? row : e.bottom;
                ++e.count;
            }
    return e;
}

/** At 1.5 m/s an arrow is half as long as one of 3 m/s, which is two squares of 0.16 m: 80 pixels; the caption's is one of
 *  a round speed on the same scale. */
START_TEST(arrows_are_as_long_as_their_speed)
{
    sph2d_renderer *renderer = make_flat();
    picture.view = (sph2d_box){{0.001, 0.001}, {1.281, 0.721}}; /* arrows are in the middle of pixels */
    picture.vx = vx;
    picture.vy = vy;
    picture.arrow_spacing = 0.16;
    picture.arrow_speed = 3.0;
    const unsigned char *pixels = draw(renderer, &picture);
    const extent right = dark_in(pixels, 280, 100, 360, 140); /* its middle is at (0.64, 0.48) */
    ck_assert_int_gt(right.count, 80);
    ck_assert_int_le(abs(right.left - 280), 1);
    ck_assert_int_le(abs(right.right - 359), 1);
    ck_assert(right.bottom - right.top > 15 && right.bottom - right.top < 32);
    for (int i = 0; i < COUNT; ++i) {
        vx[i] = 0.0;
        vy[i] = -0.75;
    }
    pixels = draw(renderer, &picture);
    const extent down = dark_in(pixels, 300, 90, 340, 150);
    ck_assert_int_le(abs(down.bottom - down.top - 40), 3);
    ck_assert_int_lt(down.right - down.left, 20);
    int upper = 0, lower = 0; /* the head is below */
    for (int row = down.top; row <= down.bottom; ++row)
        for (int column = 300; column < 340; ++column)
            *(row < 120 ? &upper : &lower) += is_dark(pixels, column, row);
    ck_assert_int_gt(lower, upper + 10);

    picture.caption = "";
    const int strip = sph2d__caption_height(WIDTH, HEIGHT);
    pixels = draw(renderer, &picture);
    const extent with = dark_in(pixels, 0, HEIGHT - strip, WIDTH, HEIGHT);
    picture.vx = picture.vy = NULL;
    pixels = draw(renderer, &picture);
    const extent without = dark_in(pixels, 0, HEIGHT - strip, WIDTH, HEIGHT);
    ck_assert_int_gt(without.left - with.left, 40);
    sph2d_renderer_destroy(renderer);
}
END_TEST

START_TEST(liquid_at_rest_has_no_arrows)
{
    sph2d_renderer *renderer = make_flat();
    static unsigned char plain[4 * WIDTH * HEIGHT];
    memcpy(plain, draw(renderer, &picture), sizeof plain);
    memset(vx, 0, sizeof vx);
    picture.vx = vx;
    picture.vy = vy;
    ck_assert_mem_eq(draw(renderer, &picture), plain, sizeof plain);
    picture.arrow_speed = 1.0;
    ck_assert_mem_eq(draw(renderer, &picture), plain, sizeof plain);
    for (int i = 0; i < COUNT; ++i)
        values[i] = 7.0;
    picture.level_values = values; /* the same everywhere */
    ck_assert_mem_eq(draw(renderer, &picture), plain, sizeof plain);
    sph2d_renderer_destroy(renderer);
}
END_TEST

/** Values of either sign: blue, grey and red, 0 in the middle of a range that is symmetric. */
START_TEST(diverging_colours_have_grey_at_zero)
{
    sph2d_renderer *renderer = make_flat();
    picture.values = values;
    picture.diverging = true;
    for (int i = 0; i < COUNT; ++i)
        values[i] = x[i] < 0.4 ? -1.0 : x[i] < 0.8 ? 0.0 : 4.0;
    const unsigned char *pixels = draw(renderer, &picture) + (size_t)4 * WIDTH * (HEIGHT / 2);
    const unsigned char *left = pixels + (size_t)4 * 60, *middle = pixels + (size_t)4 * 250,
                        *right = pixels + (size_t)4 * 400;
    ck_assert(left[2] > left[0] + 20 && left[2] < left[0] + 100); /* a quarter of the way to blue */
    ck_assert(abs(middle[0] - middle[1]) < 6 && abs(middle[1] - middle[2]) < 6 && middle[0] > 190);
    ck_assert(right[0] > 160 && right[2] < 80);
    for (int i = 0; i < COUNT; ++i)
        values[i] = 0.0;
    draw(renderer, &picture);
    sph2d_renderer_destroy(renderer);
}
END_TEST

START_TEST(nonsense_is_refused_or_left_out)
{
    sph2d_renderer *renderer = make_flat();
    picture.vx = vx;
    picture.vy = vy;
    picture.level_values = values;
    sph2d_picture bad[8];
    for (int k = 0; k < 8; ++k)
        bad[k] = picture;
    bad[0].vy = NULL;
    bad[1].vx = NULL;
    bad[2].spacing = 0.0;
    bad[3].spacing = NAN;
    bad[4].arrow_spacing = -1.0;
    bad[5].arrow_speed = INFINITY;
    bad[6].level_step = NAN;
    bad[7].level_step = -1.0;
    for (int k = 0; k < 8; ++k) {
        sph2d_report report = {0};
        ck_assert_int_eq(sph2d_renderer_draw(renderer, &bad[k], &report), SPH2D_INVALID);
        ck_assert_uint_eq(report.errors, 1);
        sph2d_report_clear(&report);
    }
    const double odd[] = {NAN, INFINITY, -INFINITY, DBL_MAX, -DBL_MAX, DBL_MIN};
    for (int k = 0; k < 6; ++k) {
        x[100] = vx[2000] = vy[3000] = values[4000] = odd[k];
        picture.arrow_spacing = k == 0 ? DBL_MIN : k == 1 ? DBL_MAX : 0.0;
        picture.arrow_speed = k == 2 ? DBL_MIN : k == 3 ? DBL_MAX : 0.0;
        picture.caption = "odd";
        draw(renderer, &picture);
    }
    picture.count = 0;
    draw(renderer, &picture);
    sph2d_renderer_destroy(renderer);
}
END_TEST

Suite *suite_lines(void)
{
    Suite *suite = suite_create("lines");
    TCase *cases = tcase_create("lines");
    tcase_add_checked_fixture(cases, fill, NULL);
    tcase_add_test(cases, linear_fields_are_exact);
    tcase_add_test(cases, isolines_are_at_their_levels);
    tcase_add_test(cases, isolines_have_a_sensible_number);
    tcase_add_test(cases, arrows_are_as_long_as_their_speed);
    tcase_add_test(cases, liquid_at_rest_has_no_arrows);
    tcase_add_test(cases, diverging_colours_have_grey_at_zero);
    tcase_add_test(cases, nonsense_is_refused_or_left_out);
    suite_add_tcase(suite, cases);
    return suite;
}
