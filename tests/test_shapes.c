/* SPDX-License-Identifier: MIT */
/** @file test_shapes.c
 *  Walls as shapes: exact areas of pixels, thickness and mitres, what a scene's outlines are, and pictures with captions,
 *  notes and colours. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "render/legend.h"
#include "render/walls.h"
#include "sph2d/field.h"
#include "sph2d/render.h"
#include "splash.h"

/* ---- areas ------------------------------------------------------------------------------------------------------- */

enum { WIDTH = 60, HEIGHT = 40 };

static double area_of(const sph2d__cover *cover)
{
    double sum = 0;
    for (int k = 0; k < cover->width * cover->height; ++k)
        sum += cover->pixels[k] / 255.0;
    return sum;
}

static void add_polygon(sph2d__cover *cover, const double (*corners)[2], size_t count)
{
    for (size_t k = 0; k < count; ++k)
        sph2d__cover_edge(cover, corners[k], corners[(k + 1) % count]);
    sph2d__cover_fill(cover);
}

/** Polygons in both directions, slanted, within one pixel, and partly outside the image cover their area. */
START_TEST(polygons_cover_their_area)
{
    static const struct {
        double corners[4][2], area;
    } cases[] = {
        {{{10, 10}, {30, 10}, {30, 25}, {10, 25}}, 300},
        {{{10, 25}, {30, 25}, {30, 10}, {10, 10}}, 300},
        {{{10.25, 10.5}, {12.5, 10.5}, {12.5, 10.75}, {10.25, 10.75}}, 0.5625},
        {{{20, 3}, {41, 17.5}, {22, 33}, {5, 18}}, 540.5},
        {{{0.2, 0.3}, {0.7, 0.4}, {0.6, 0.9}, {0.3, 0.8}}, 0.2},
        {{{-30, 10}, {30, 10}, {30, 20}, {-30, 20}}, 300},
        {{{40, -50}, {90, -50}, {90, 20}, {40, 20}}, 400},
        {{{-1e6, -1e6}, {1e6, -1e6}, {1e6, 1e6}, {-1e6, 1e6}}, WIDTH * HEIGHT},
        {{{70, 10}, {90, 10}, {90, 30}, {70, 30}}, 0},
    };
    sph2d__cover cover;
    ck_assert(sph2d__cover_create(&cover, WIDTH, HEIGHT));
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; ++k) {
        sph2d__cover_clear(&cover, WIDTH, HEIGHT);
        add_polygon(&cover, cases[k].corners, 4);
        ck_assert_msg(fabs(area_of(&cover) - cases[k].area) < 0.003 * cases[k].area + 0.01, "case %zu: %g of %g", k,
                      area_of(&cover), cases[k].area);
    }
    sph2d__cover_destroy(&cover);
}
END_TEST

/** Two polygons with a common slanted edge leave no seam. */
START_TEST(polygons_side_by_side_leave_no_seam)
{
    static const double left[4][2] = {{0, 0}, {20.3, 0}, {33.1, 40}, {0, 40}};
    static const double right[4][2] = {{20.3, 0}, {60, 0}, {60, 40}, {33.1, 40}};
    sph2d__cover cover;
    ck_assert(sph2d__cover_create(&cover, WIDTH, HEIGHT));
    add_polygon(&cover, left, 4);
    add_polygon(&cover, right, 4);
    for (int k = 0; k < WIDTH * HEIGHT; ++k)
        ck_assert_int_ge(cover.pixels[k], 253);
    sph2d__cover_destroy(&cover);
}
END_TEST

/** The area that an outline covers in an image of one pixel per metre. */
static double covered(const double *x, const double *y, size_t count, uint64_t liquid, double thickness)
{
    const uint64_t id[8] = {0}, sides[8] = {liquid, liquid, liquid, liquid, liquid, liquid, liquid, liquid};
    const sph2d_picture picture = {.outline_count = count,
                                   .outline_x = x,
                                   .outline_y = y,
                                   .outline_id = id,
                                   .outline_liquid = sides,
                                   .wall_thickness = thickness};
    sph2d__view view;
    ck_assert(sph2d__view_fit(&view, (sph2d_box){{0, 0}, {WIDTH, HEIGHT}}, WIDTH, HEIGHT, 0, 0));
    sph2d__cover cover;
    ck_assert(sph2d__cover_create(&cover, WIDTH, HEIGHT));
    sph2d__walls_cover(&cover, &view, &picture, thickness);
    const double area = area_of(&cover);
    sph2d__cover_destroy(&cover);
    return area;
}

/** Bands have their thickness on the side of the wall, and mitred corners. */
START_TEST(bands_are_thick_on_the_side_of_the_wall)
{
    const double x[] = {10, 40}, y[] = {20, 20}; /* to the right: the wall is below */
    ck_assert_double_eq_tol(covered(x, y, 2, SPH2D_OUTLINE_LIQUID_LEFT, 4), 120, 0.5);
    ck_assert_double_eq_tol(covered(x, y, 2, SPH2D_OUTLINE_LIQUID_BOTH, 4), 120, 0.5);
    const double low[] = {1, 1}; /* a wall below is outside the image but for one row */
    ck_assert_double_eq_tol(covered(x, low, 2, SPH2D_OUTLINE_LIQUID_LEFT, 4), 30, 0.5);
    const double tank_x[] = {10, 10, 50, 50}, tank_y[] = {35, 10, 10, 35}; /* liquid inside: corners outside */
    ck_assert_double_eq_tol(covered(tank_x, tank_y, 4, SPH2D_OUTLINE_LIQUID_LEFT, 3), 3 * (25 + 40 + 25) + 2 * 9, 0.5);
    const double ring_x[] = {10, 50, 50, 10, 10}, ring_y[] = {10, 10, 30, 30, 10};
    ck_assert_double_eq_tol(covered(ring_x, ring_y, 5, SPH2D_OUTLINE_LIQUID_LEFT, 3), 46 * 26 - 40 * 20, 0.5);
    ck_assert_double_eq_tol(covered(ring_x, ring_y, 4, SPH2D_OUTLINE_LIQUID_OUTSIDE, 3), 800, 0.5);
    const double bad[] = {10, NAN};
    ck_assert_double_eq(covered(x, bad, 2, SPH2D_OUTLINE_LIQUID_LEFT, 4), 0);
}
END_TEST

/* ---- pictures ---------------------------------------------------------------------------------------------------- */

/** Pixels that differ between two images, within a box. */
static size_t differences(const unsigned char *a, const unsigned char *b, unsigned width, sph2d__pixel_box box)
{
    size_t count = 0;
    for (int y = box.y; y < box.y + box.height; ++y)
        for (int x = box.x; x < box.x + box.width; ++x)
            count += memcmp(a + 4 * ((size_t)y * width + (size_t)x), b + 4 * ((size_t)y * width + (size_t)x), 4) != 0;
    return count;
}

/** A caption takes a strip and nothing else is drawn there; its bar is as long as it says. */
START_TEST(a_caption_has_a_strip_of_its_own)
{
    enum { W = 640, H = 360 };
    splash *s = make_splash(0.0);
    s->picture.view = (sph2d_box){{0, 0}, {2, 1}};
    s->picture.values = NULL;
    s->picture.value_label = NULL;
    s->picture.caption = "";
    unsigned char *empty = draw_alone(NULL, W, H, SPH2D_STYLE_METABALLS, &s->picture);
    s->picture.caption = "splash   t = 0.25 s";
    unsigned char *named = draw_alone(NULL, W, H, SPH2D_STYLE_METABALLS, &s->picture);
    const int strip = sph2d__caption_height(W, H);
    ck_assert_int_gt(strip, 10);
    ck_assert_uint_eq(differences(empty, named, W, (sph2d__pixel_box){0, 0, W, H - strip}), 0);
    ck_assert_uint_gt(differences(empty, named, W, (sph2d__pixel_box){0, H - strip, W / 2, strip}), 100);
    ck_assert_uint_eq(differences(empty, named, W, (sph2d__pixel_box){W / 2, H - strip, W / 2, strip}), 0);
    int longest = 0; /* row of dark pixels: the bar */
    for (int y = H - strip; y < H; ++y)
        for (int x = 0, length = 0; x < W; ++x) {
            length = empty[4 * (y * W + x)] < 100 ? length + 1 : 0;
            longest = length > longest ? length : longest;
        }
    const double scale = fmin(W / 2.0, H - strip); /* 20, 50 cm or 1 m; a sixth of the width */
    ck_assert_double_eq_tol(longest, 0.2 * scale, 2.0);
    free(empty);
    free(named);
    free(s);
}
END_TEST

/** Notes stay in their box, also where they are too long for the image. */
START_TEST(notes_stay_in_their_box)
{
    static const char *const texts[] = {"one", "two lines\nof notes",
                                        "a line that is far longer than the image is wide, "
                                        "so that it must be cut off somewhere"};
    splash *s = make_splash(0.0);
    unsigned char *plain = draw_alone(NULL, 320, 180, SPH2D_STYLE_POINTS, &s->picture);
    for (int k = 0; k < 3; ++k) {
        s->picture.notes = texts[k];
        unsigned char *noted = draw_alone(NULL, 320, 180, SPH2D_STYLE_POINTS, &s->picture);
        const sph2d__pixel_box box = sph2d__notes_box(320, 180, texts[k]), all = {0, 0, 320, 180};
        ck_assert_int_le(box.x + box.width, 320);
        ck_assert_uint_gt(differences(plain, noted, 320, box), 100);
        if (k < 2)
            ck_assert_uint_eq(differences(plain, noted, 320, all), differences(plain, noted, 320, box));
        free(noted);
    }
    free(plain);
    free(s);
}
END_TEST

/** Metaballs take the colours of their particles: purple on the left, yellow on the right, grey for unknown values. */
START_TEST(metaballs_have_colors)
{
    enum { N = 40, COUNT = N * N };
    static double x[COUNT], y[COUNT], values[COUNT];
    for (int i = 0; i < COUNT; ++i) {
        x[i] = 0.1 + (i % N + 0.5) * 0.02;
        y[i] = 0.1 + (i / N + 0.5) * 0.02; /* NOLINT: whole rows */
        values[i] = i / N < N / 2 ? (i % N < N / 2 ? 0.0 : 1.0) : NAN;
    }
    const sph2d_picture picture = {
        .view = {{0, 0}, {1, 1}}, .radius = 0.04, .count = COUNT, .x = x, .y = y, .values = values, .value_max = 1};
    unsigned char *pixels = draw_alone(NULL, 100, 100, SPH2D_STYLE_METABALLS, &picture);
    const unsigned char *left = pixels + 4 * (70 * 100 + 25), *right = pixels + 4 * (70 * 100 + 75),
                        *above = pixels + 4 * (30 * 100 + 50);
    ck_assert_int_lt(left[1], 40);
    ck_assert_int_gt(left[2], 50);
    ck_assert_int_gt(right[0], 200);
    ck_assert_int_gt(right[1], 180);
    ck_assert_int_lt(right[2], 90);
    ck_assert(abs(above[0] - above[1]) < 3 && abs(above[1] - above[2]) < 3 && above[0] > 100 && above[0] < 190);
    free(pixels);
}
END_TEST

/** A pixel is found where its place was drawn, beside a colour bar and above a caption, too. */
START_TEST(pixels_have_places)
{
    splash *s = make_splash(3.0);
    sph2d_renderer *renderer = make_renderer(NULL, 640, 360, SPH2D_STYLE_POINTS);
    sph2d_vec2 at;
    ck_assert(!sph2d_renderer_locate(renderer, 1, 1, &at));
    s->picture.caption = "below";
    s->picture.outline_count = 0;
    s->picture.count = 1;
    s->x[0] = 3.3;
    s->y[0] = 3.6;
    s->values[0] = 1;
    s->picture.value_max = 1;
    const unsigned char *pixels = draw(renderer, &s->picture);
    double x = 0, y = 0, count = 0; /* the middle of the yellow dot; the bar is on the right */
    for (int row = 0; row < 360; ++row)
        for (int column = 0; column < 400; ++column) {
            const unsigned char *p = pixels + 4 * (row * 640 + column);
            const bool yellow = p[0] > 200 && p[2] < 100;
            x += yellow * (column + 0.5);
            y += yellow * (row + 0.5);
            count += yellow;
        }
    ck_assert_double_gt(count, 10);
    ck_assert(sph2d_renderer_locate(renderer, x / count, y / count, &at));
    ck_assert_double_eq_tol(at.x, 3.3, 0.002);
    ck_assert_double_eq_tol(at.y, 3.6, 0.002);
    ck_assert(!sph2d_renderer_locate(renderer, 1, 1, NULL));
    sph2d_renderer_destroy(renderer);
    free(s);
}
END_TEST

/** A renderer with a context of its own draws into no framebuffer of the caller. */
START_TEST(own_contexts_draw_into_memory_alone)
{
    splash *s = make_splash(0.0);
    sph2d_renderer *renderer = make_renderer(NULL, 64, 48, SPH2D_STYLE_POINTS);
    sph2d_report report = {0};
    ck_assert_int_eq(sph2d_renderer_draw_to(renderer, 0, 0, 0, &s->picture, &report), SPH2D_INVALID);
    ck_assert_ptr_nonnull(strstr(test_report_text(&report), "get_proc_address"));
    ck_assert_int_eq(sph2d_renderer_draw_to(NULL, 0, 0, 0, &s->picture, NULL), SPH2D_INVALID);
    sph2d_report_clear(&report);
    sph2d_renderer_destroy(renderer);
    free(s);
}
END_TEST

Suite *suite_shapes(void)
{
    Suite *suite = suite_create("shapes");
    TCase *cases = tcase_create("shapes");
    tcase_add_test(cases, polygons_cover_their_area);
    tcase_add_test(cases, polygons_side_by_side_leave_no_seam);
    tcase_add_test(cases, bands_are_thick_on_the_side_of_the_wall);
    tcase_add_test(cases, a_caption_has_a_strip_of_its_own);
    tcase_add_test(cases, notes_stay_in_their_box);
    tcase_add_test(cases, metaballs_have_colors);
    tcase_add_test(cases, pixels_have_places);
    tcase_add_test(cases, own_contexts_draw_into_memory_alone);
    suite_add_tcase(suite, cases);
    return suite;
}
