/* SPDX-License-Identifier: MIT */
/** @file test_background.c
 *  Transparent backgrounds: over any colour the picture is the one that would have been drawn on it, texts stand
 *  on nothing with a light halo, and files have the pixels. */
#include <png.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "sph2d/render.h"
#include "splash.h"

enum { WIDTH = 640, HEIGHT = 360, PIXELS = WIDTH * HEIGHT };

static sph2d_renderer *make(sph2d_style style, sph2d_look look, sph2d_background background)
{
    sph2d_render_options options = sph2d_render_options_default();
    options.width = WIDTH;
    options.height = HEIGHT;
    options.style = style;
    options.look = look;
    options.background = background;
    sph2d_renderer *renderer = NULL;
    ck_assert_int_eq(sph2d_renderer_create(&options, &renderer, NULL), SPH2D_OK);
    return renderer;
}

/** The largest difference of a picture over the background of another, and the other. */
static int difference(const unsigned char *over, const unsigned char *opaque, const unsigned char *background)
{
    int largest = 0;
    for (int k = 0; k < 4 * PIXELS; ++k) {
        if (k % 4 == 3)
            continue;
        const int alpha = over[k - k % 4 + 3];
        const int seen = (over[k] * alpha + background[k] * (255 - alpha) + 127) / 255;
        largest = abs(seen - opaque[k]) > largest ? abs(seen - opaque[k]) : largest;
    }
    return largest;
}

START_TEST(it_looks_as_drawn_on_what_is_behind)
{
    splash *s = make_splash(0.0);
    s->picture.values = NULL;
    s->picture.value_label = NULL;
    for (int k = 0; k <= SPH2D_LOOK_INK + 1; ++k) {
        const sph2d_style style = k > SPH2D_LOOK_INK ? SPH2D_STYLE_POINTS : SPH2D_STYLE_METABALLS;
        const sph2d_look look = k > SPH2D_LOOK_INK ? SPH2D_LOOK_WATER : (sph2d_look)k;
        sph2d_renderer *plain = make(style, look, SPH2D_BACKGROUND_OPAQUE);
        sph2d_renderer *clear = make(style, look, SPH2D_BACKGROUND_TRANSPARENT);
        sph2d_picture nothing = s->picture;
        nothing.count = nothing.outline_count = 0;
        static unsigned char empty[4 * PIXELS];
        memcpy(empty, draw(plain, &nothing), sizeof empty);
        const unsigned char *over = draw(clear, &s->picture), *opaque = draw(plain, &s->picture);
        ck_assert_int_le(difference(over, opaque, empty), 3);
        int counts[3] = {0}; /* clear, in between, opaque */
        for (int i = 0; i < PIXELS; ++i) {
            ck_assert_uint_eq(opaque[4 * i + 3], 255);
            ++counts[over[4 * i + 3] == 0 ? 0 : over[4 * i + 3] < 255 ? 1 : 2];
        }
        ck_assert_msg(counts[0] > PIXELS / 2 && counts[1] > 100 && counts[2] > 100, "%d: %d %d %d", k, counts[0],
                      counts[1], counts[2]);
        over = draw(clear, &nothing); /* and nothing is left of the last one */
        for (int i = 0; i < PIXELS; ++i)
            ck_assert_uint_eq(over[4 * i + 3], 0);
        sph2d_renderer_destroy(plain);
        sph2d_renderer_destroy(clear);
    }
    free(s);
}
END_TEST

/** Beside dark letters and numbers is light, further off nothing; notes have a box on the picture. */
START_TEST(texts_have_halos)
{
    splash *s = make_splash(0.0);
    s->picture.caption = "a caption";
    s->picture.notes = "a note";
    sph2d_renderer *clear = make(SPH2D_STYLE_METABALLS, SPH2D_LOOK_WATER, SPH2D_BACKGROUND_TRANSPARENT);
    const unsigned char *pixels = draw(clear, &s->picture);
    int dark = 0, lost = 0, nothing = 0, strip = 0;
    for (int y = HEIGHT - 17; y < HEIGHT - 1; ++y)
        for (int x = 1; x < WIDTH - 1; ++x, ++strip) {
            const unsigned char *at = pixels + 4 * (y * WIDTH + x);
            nothing += at[3] == 0;
            if (at[3] < 255 || at[0] > 80)
                continue;
            ++dark;
            for (int k = -1; k <= 1; ++k) /* all around it is opaque */
                lost += at[4 * k + 3] < 255 || at[4 * k * WIDTH + 3] < 255;
        }
    ck_assert_int_gt(dark, 50);
    ck_assert_int_eq(lost, 0);
    ck_assert_int_gt(nothing, strip / 2);
    ck_assert_uint_eq(pixels[4 * (4 * WIDTH + WIDTH - 3) + 3], 0); /* right of the bar's numbers */
    ck_assert_uint_eq(pixels[4 * (12 * WIDTH + 12) + 3], 255);     /* notes */
    sph2d_renderer_destroy(clear);
    free(s);
}
END_TEST

START_TEST(files_have_alpha)
{
    char path[] = "/tmp/sph2d-background-XXXXXX";
    const int made = mkstemp(path);
    ck_assert_int_ge(made, 0);
    close(made);
    splash *s = make_splash(0.0);
    sph2d_renderer *clear = make(SPH2D_STYLE_METABALLS, SPH2D_LOOK_GLASS, SPH2D_BACKGROUND_TRANSPARENT);
    const unsigned char *pixels = draw(clear, &s->picture);
    ck_assert_int_eq(sph2d_renderer_write_png(clear, path, NULL), SPH2D_OK);
    png_image image = {.version = PNG_IMAGE_VERSION};
    ck_assert_int_ne(png_image_begin_read_from_file(&image, path), 0);
    ck_assert_uint_eq(image.format, PNG_FORMAT_RGBA);
    static unsigned char back[4 * PIXELS];
    ck_assert_int_ne(png_image_finish_read(&image, NULL, back, 0, NULL), 0);
    ck_assert_mem_eq(back, pixels, sizeof back);
    unlink(path);
    sph2d_renderer_destroy(clear);
    free(s);
}
END_TEST

Suite *suite_background(void)
{
    Suite *suite = suite_create("background");
    TCase *cases = tcase_create("background");
    tcase_add_test(cases, texts_have_halos);
    tcase_add_test(cases, files_have_alpha);
    suite_add_tcase(suite, cases);
    TCase *slow = test_long(suite);
    tcase_add_test(slow, it_looks_as_drawn_on_what_is_behind);
    return suite;
}
