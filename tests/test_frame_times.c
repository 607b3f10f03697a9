/* SPDX-License-Identifier: MIT */
/** @file test_frame_times.c
 *  What a renderer tells of the time that its last picture took. */
#include <time.h>
#include <unistd.h>

#include "common.h"
#include "sph2d/render.h"

static double now(void)
{
    struct timespec time;
    ck_assert_int_eq(clock_gettime(CLOCK_MONOTONIC, &time), 0);
    return (double)time.tv_sec + 1.0e-9 * (double)time.tv_nsec;
}

static void check_times(sph2d_frame_times times, bool drawn, bool written, double limit)
{
    ck_assert(drawn ? times.draw > 0.0 : times.draw == 0.0);
    ck_assert(drawn ? times.read > 0.0 : times.read == 0.0);
    ck_assert(written ? times.encode > 0.0 : times.encode == 0.0);
    ck_assert_double_le(times.draw + times.read + times.encode, limit);
}

START_TEST(times_are_those_of_the_last_picture)
{
    static const char path[] = "/tmp/sph2d-frame-times.png";
    static const double x[] = {0.5}, y[] = {0.5};
    const sph2d_picture picture = {.view = {{0.0, 0.0}, {1.0, 1.0}}, .radius = 0.2, .count = 1, .x = x, .y = y};
    const sph2d_render_options options = sph2d_render_options_default();
    sph2d_renderer *renderer = NULL;
    ck_assert_int_eq(sph2d_renderer_create(&options, &renderer, NULL), SPH2D_OK);
    check_times(sph2d_renderer_times(renderer), false, false, 0.0);
    check_times(sph2d_renderer_times(NULL), false, false, 0.0);
    for (int i = 0; i < 2; ++i) {
        const double begun = now();
        ck_assert_int_eq(sph2d_renderer_draw(renderer, &picture, NULL), SPH2D_OK);
        check_times(sph2d_renderer_times(renderer), true, false, now() - begun); /* not that of the file before */
        ck_assert_int_eq(sph2d_renderer_write_png(renderer, path, NULL), SPH2D_OK);
        check_times(sph2d_renderer_times(renderer), true, true, now() - begun);
    }
    unlink(path);
    sph2d_renderer_destroy(renderer);
}
END_TEST

/* Drawing is not told as reading, although OpenGL may put it off until then. */
START_TEST(drawing_is_done_before_reading)
{
    enum { COUNT = 100 }; /* each covers the image, one over the other */
    static const double middle[COUNT];
    const sph2d_picture picture = {
        .view = {{-0.1, -0.1}, {0.1, 0.1}}, .radius = 1.0, .count = COUNT, .x = middle, .y = middle};
    sph2d_render_options options = sph2d_render_options_default();
    options.width = options.height = 256;
    options.style = SPH2D_STYLE_POINTS;
    sph2d_renderer *renderer = NULL;
    ck_assert_int_eq(sph2d_renderer_create(&options, &renderer, NULL), SPH2D_OK);
    for (int i = 0; i < 2; ++i) /* the first time shaders are compiled */
        ck_assert_int_eq(sph2d_renderer_draw(renderer, &picture, NULL), SPH2D_OK);
    const sph2d_frame_times times = sph2d_renderer_times(renderer);
    ck_assert_double_gt(times.draw, times.read);
    sph2d_renderer_destroy(renderer);
}
END_TEST

Suite *suite_frame_times(void)
{
    Suite *suite = suite_create("frame_times");
    TCase *times = tcase_create("times");
    tcase_add_test(times, times_are_those_of_the_last_picture);
    tcase_add_test(times, drawing_is_done_before_reading);
    suite_add_tcase(suite, times);
    return suite;
}
