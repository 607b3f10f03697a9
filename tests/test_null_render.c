/* SPDX-License-Identifier: MIT */
/** @file test_null_render.c
 *  What the functions of sph2d/render.h answer to NULL, as test_null.c has it for all others. */
#include <string.h>

#include "common.h"
#include "sph2d/render.h"

static sph2d_report report;

static void check_refused(sph2d_status status, const char *what)
{
    ck_assert_int_eq(status, SPH2D_INVALID);
    ck_assert_uint_eq(report.errors, 1);
    ck_assert_msg(strstr(report.items[0].message, what), "%s", report.items[0].message);
    sph2d_report_clear(&report);
}

START_TEST(renderers)
{
    sph2d_renderer *renderer = (sph2d_renderer *)(void *)&report; /* not NULL */
    sph2d_render_options options = sph2d_render_options_default();
    sph2d_picture picture = {.view = {{0, 0}, {1, 1}}, .radius = 0.1};
    check_refused(sph2d_renderer_create(NULL, &renderer, &report), "options");
    ck_assert_ptr_null(renderer);
    check_refused(sph2d_renderer_create(&options, NULL, &report), "renderer");
    check_refused(sph2d_renderer_draw(NULL, &picture, &report), "renderer");
    check_refused(sph2d_renderer_draw_to(NULL, 0, 0, 0, &picture, &report), "renderer");
    check_refused(sph2d_renderer_write_png(NULL, "x.png", &report), "picture");
    ck_assert(!sph2d_renderer_locate(NULL, 0, 0, &(sph2d_vec2){0, 0}));
    sph2d_renderer_destroy(NULL);
    ck_assert_ptr_null(sph2d_renderer_pixels(NULL));
    ck_assert_ptr_null(sph2d_renderer_gl(NULL));
    ck_assert_ptr_null(sph2d_renderer_gl_version(NULL));
    ck_assert(sph2d_renderer_times(NULL).draw == 0);
    ck_assert_int_eq(sph2d_renderer_create(&options, &renderer, &report), SPH2D_OK);
    check_refused(sph2d_renderer_draw(renderer, NULL, &report), "picture");
    check_refused(sph2d_renderer_write_png(renderer, NULL, &report), "path");
    static const unsigned char pixel[4];
    check_refused(sph2d_png_write(NULL, pixel, 1, 1, SPH2D_BACKGROUND_OPAQUE, &report), "path");
    check_refused(sph2d_png_write("x.png", NULL, 1, 1, SPH2D_BACKGROUND_OPAQUE, &report), "pixels");
    check_refused(sph2d_png_write("x.png", pixel, 0, 1, SPH2D_BACKGROUND_OPAQUE, &report), "0 x 1");
    check_refused(sph2d_png_write("x.png", pixel, 1, 16385, SPH2D_BACKGROUND_OPAQUE, &report), "1 x 16385");
    sph2d_renderer_destroy(renderer);
}
END_TEST

Suite *suite_null_render(void)
{
    Suite *suite = suite_create("null_render");
    TCase *tests = tcase_create("null_render");
    tcase_add_test(tests, renderers);
    suite_add_tcase(suite, tests);
    return suite;
}
