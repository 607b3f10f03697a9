/* SPDX-License-Identifier: MIT */
/** @file test_looks.c
 *  Looks of metaballs: what each of them is, where their edges are, and that their shaders are those of browsers, too. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "shaders.h"
#include "sph2d/render.h"
#include "splash.h"

enum { WIDTH = 640, HEIGHT = 360, BYTES = WIDTH * HEIGHT * 4 };

static unsigned char *draw_look(const char *gl, sph2d_look look, const sph2d_picture *picture)
{
    sph2d_render_options options = sph2d_render_options_default();
    options.width = WIDTH;
    options.height = HEIGHT;
    options.look = look;
    options.gl = gl;
    sph2d_renderer *renderer = NULL;
    sph2d_report report = {0};
    unsigned char *copy = NULL;
    if (sph2d_renderer_create(&options, &renderer, &report) == SPH2D_OK) {
        copy = malloc(BYTES);
        ck_assert_ptr_nonnull(copy);
        memcpy(copy, draw(renderer, picture), BYTES);
    }
    ck_assert_msg(copy || gl, "%s", test_report_text(&report)); /* a way that is named may be missing */
    sph2d_report_clear(&report);
    sph2d_renderer_destroy(renderer);
    return copy;
}

/** A pool of 1 m x 0.3 m in a tank of 1.28 m x 0.72 m, with one drop above. */
typedef struct pool {
    double x[100 * 30 + 1], y[100 * 30 + 1], wall_x[4], wall_y[4];
    uint64_t outline[4], liquid[4];
    sph2d_picture picture;
} pool;

static pool *make_pool(void)
{
    pool *p = calloc(1, sizeof *p);
    ck_assert_ptr_nonnull(p);
    enum { COUNT = 100 * 30 };
    for (int i = 0; i < COUNT; ++i) {
        p->x[i] = (i % 100 + 0.5) * 0.01;
        p->y[i] = (i / 100 + 0.5) * 0.01; /* NOLINT: whole rows */
    }
    p->x[COUNT] = 0.8;
    p->y[COUNT] = 0.5;
    const double corners[4][2] = {{0, 0.7}, {0, 0}, {1.2, 0}, {1.2, 0.7}};
    for (int i = 0; i < 4; ++i) {
        p->wall_x[i] = corners[i][0];
        p->wall_y[i] = corners[i][1];
        p->liquid[i] = SPH2D_OUTLINE_LIQUID_LEFT;
    }
    p->picture = (sph2d_picture){.view = {{-0.02, -0.02}, {1.26, 0.70}},
                                 .radius = 0.02,
                                 .count = COUNT + 1,
                                 .x = p->x,
                                 .y = p->y,
                                 .outline_count = 4,
                                 .outline_x = p->wall_x,
                                 .outline_y = p->wall_y,
                                 .outline_id = p->outline,
                                 .outline_liquid = p->liquid,
                                 .wall_thickness = 0.02};
    return p;
}

/** The pixel at a place of the pool's picture, which has 500 pixels a metre. */
static const unsigned char *at(const unsigned char *pixels, double x, double y)
{
    const int column = (int)floor((x + 0.02) * 500), row = (int)floor((0.70 - y) * 500);
    return pixels + 4 * (row * WIDTH + column);
}

/* ---- what they are ----------------------------------------------------------------------------------------------- */

START_TEST(looks_differ_and_are_the_same_each_time)
{
    splash *s = make_splash(0.0);
    s->picture.values = NULL;
    unsigned char *drawn[SPH2D_LOOK_INK + 1];
    for (sph2d_look look = SPH2D_LOOK_WATER; look <= SPH2D_LOOK_INK; ++look) {
        drawn[look] = draw_look(NULL, look, &s->picture);
        for (sph2d_look other = SPH2D_LOOK_WATER; other < look; ++other)
            ck_assert_mem_ne(drawn[look], drawn[other], BYTES);
        for (int w = 0; w < WAYS; ++w) {
            unsigned char *again = draw_look(ways[w], look, &s->picture);
            if (again)
                ck_assert_mem_eq(again, drawn[look], BYTES);
            free(again);
        }
    }
    for (sph2d_look look = SPH2D_LOOK_WATER; look <= SPH2D_LOOK_INK; ++look)
        free(drawn[look]);
    free(s);
}
END_TEST

/** One colour, darker in a thin line at the free surface and not at walls; and the drop is as dark. */
START_TEST(flat_is_one_color_with_an_edge)
{
    pool *p = make_pool();
    unsigned char *pixels = draw_look(NULL, SPH2D_LOOK_FLAT, &p->picture);
    const unsigned char *inside = at(pixels, 0.5, 0.15);
    ck_assert(inside[2] > inside[1] && inside[1] > inside[0]); /* blue */
    for (int k = 0; k < 100; ++k) {
        ck_assert_mem_eq(at(pixels, 0.01 + 0.0095 * k, 0.2), inside, 4);
        ck_assert_mem_eq(at(pixels, 0.003, 0.01 + 0.0025 * k), inside, 4); /* beside the wall */
        ck_assert_mem_eq(at(pixels, 0.01 + 0.0095 * k, 0.004), inside, 4); /* above the floor */
    }
    int darkest = 255;
    for (int k = 0; k < 10; ++k) {
        const int green = at(pixels, 0.5, 0.29 + 0.002 * k)[1];
        darkest = green < darkest ? green : darkest;
    }
    ck_assert_int_lt(darkest, 9 * inside[1] / 10);
    ck_assert_int_gt(darkest, inside[1] / 2);
    ck_assert_int_lt(at(pixels, 0.8, 0.5)[0], 150);
    free(pixels);
    free(p);
}
END_TEST

/** Liquid of one colour has its hue in every look, and of several that of what is near; where two meet it is between. */
START_TEST(liquid_has_its_colors)
{
    const sph2d_look look = (sph2d_look)_i;
    pool *p = make_pool();
    static uint64_t colors[100 * 30 + 1];
    for (int i = 0; i < 100 * 30; ++i)
        colors[i] = i % 100 < 50 ? 0xc02020 : 0x20c020;
    colors[100 * 30] = 0x2020c0;
    p->picture.colors = colors;
    unsigned char *several = draw_look(NULL, look, &p->picture);
    const unsigned char *left = at(several, 0.25, 0.15), *right = at(several, 0.75, 0.15),
                        *both = at(several, 0.5, 0.15);
    const unsigned char *drop = at(several, 0.8, 0.5);
    ck_assert(left[0] > 2 * left[1] && left[0] > 2 * left[2]);
    ck_assert(right[1] > 2 * right[0] && right[1] > 2 * right[2]);
    ck_assert(drop[2] > drop[0] && drop[2] > drop[1]);
    ck_assert(both[0] < left[0] - 20 && both[0] > right[0] + 20 && both[1] > left[1] + 20 && both[1] < right[1] - 20);
    p->picture.colors = NULL;
    p->picture.tinted = true;
    p->picture.tint = 0xc02020;
    unsigned char *one = draw_look(NULL, look, &p->picture);
    for (int k = 0; k < 4; ++k) /* as where all particles around have it; blending rounds */
        ck_assert_int_le(abs(at(one, 0.25, 0.15)[k] - left[k]), 2);
    ck_assert_mem_eq(at(one, 1.1, 0.5), at(several, 1.1, 0.5), 4);
    static double values[100 * 30 + 1];
    p->picture.values = values; /* which are what colours stand for then */
    unsigned char *valued = draw_look(NULL, look, &p->picture);
    p->picture.tinted = false;
    unsigned char *plain = draw_look(NULL, look, &p->picture);
    ck_assert_mem_eq(valued, plain, BYTES);
    free(several);
    free(one);
    free(valued);
    free(plain);
    free(p);
}
END_TEST

/** More of the background comes through where there is less liquid. */
START_TEST(glass_is_translucent)
{
    pool *p = make_pool();
    unsigned char *pixels = draw_look(NULL, SPH2D_LOOK_GLASS, &p->picture);
    const unsigned char *inside = at(pixels, 0.5, 0.15), *drop = at(pixels, 0.8, 0.5), *empty = at(pixels, 1.1, 0.5);
    ck_assert_int_gt(drop[0], inside[0] + 20);
    ck_assert_int_gt(empty[0], drop[0] + 20);
    for (int k = 0; k < 100; ++k) /* it does not shine at the wall and the floor */
        ck_assert(abs(at(pixels, 0.004, 0.01 + 0.001 * k)[1] - inside[1]) < 12 &&
                  abs(at(pixels, 0.2 + 0.006 * k, 0.004)[1] - inside[1]) < 12);
    free(pixels);
    free(p);
}
END_TEST

/** White paper, inside the view and beside it; a dark line at the surface, none at walls; lines below, and none deep. */
START_TEST(ink_is_a_line_on_paper)
{
    pool *p = make_pool();
    p->picture.caption = "ink";
    unsigned char *pixels = draw_look(NULL, SPH2D_LOOK_INK, &p->picture);
    ck_assert_mem_eq(pixels + BYTES - 4, "\xff\xff\xff\xff", 4);
    p->picture.caption = NULL;
    free(pixels);
    pixels = draw_look(NULL, SPH2D_LOOK_INK, &p->picture);
    ck_assert_mem_eq(at(pixels, 1.1, 0.5), "\xff\xff\xff\xff", 4);
    int dark = 0, lines = 0, before = 255;
    for (int row = (int)((0.70 - 0.32) * 500); row < (int)((0.70 - 0.02) * 500); ++row) {
        const int red = pixels[4 * (row * WIDTH + 260)];
        dark += red < 100;
        lines += before >= 200 && red < 200;
        before = red;
    }
    ck_assert(dark >= 1 && dark <= 4);
    ck_assert_int_ge(lines, 3);
    for (int k = 0; k < 100; ++k) {
        ck_assert_int_gt(at(pixels, 0.003, 0.01 + 0.001 * k)[0], 200);
        ck_assert_int_gt(at(pixels, 0.1 + 0.008 * k, 0.01)[0], 200);
    }
    int darkest = 255; /* a drop is a small ring */
    for (int k = 0; k < 6; ++k)
        darkest = at(pixels, 0.8 + 0.002 * k, 0.5)[0] < darkest ? at(pixels, 0.8 + 0.002 * k, 0.5)[0] : darkest;
    ck_assert_int_lt(darkest, 120);
    free(pixels);
    free(p);
}
END_TEST

/** Colours of values are those of the colour bar in each look: purple below, yellow above. */
START_TEST(values_color_every_look)
{
    pool *p = make_pool();
    static double values[100 * 30 + 1];
    for (size_t i = 0; i < p->picture.count; ++i)
        values[i] = p->x[i] > 0.5;
    p->picture.values = values;
    for (sph2d_look look = SPH2D_LOOK_WATER; look <= SPH2D_LOOK_INK; ++look) {
        unsigned char *pixels = draw_look(NULL, look, &p->picture); /* a colour bar moves the view */
        int purple = 0, yellow = 0;
        for (int k = 0; k < WIDTH * HEIGHT; ++k) {
            const unsigned char *c = pixels + (size_t)4 * (size_t)k;
            purple += k % WIDTH < 300 && c[2] > c[1] + 40 && c[0] > c[1] + 10;
            yellow += k % WIDTH < 500 && k % WIDTH > 250 && c[0] > c[2] + 80 && c[1] > c[2] + 60;
        }
        ck_assert_msg(purple > 5000 && yellow > 5000, "look %d: %d purple, %d yellow", (int)look, purple, yellow);
        free(pixels);
    }
    free(p);
}
END_TEST

/* ---- browsers ---------------------------------------------------------------------------------------------------- */

/** Writes the shaders with the first line of OpenGL ES 3.0, that of WebGL 2. */
static void write_for_es(const char *folder)
{
    char path[160];
    for (size_t i = 0; i < sph2d__shader_source_count; ++i) {
        const char *text = sph2d__shader_sources[i].text;
        snprintf(path, sizeof path, "%s/%s", folder, sph2d__shader_sources[i].name);
        FILE *file = fopen(path, "w");
        ck_assert_ptr_nonnull(file);
        fprintf(file, "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n%s",
                strchr(text, '\n') + 1);
        ck_assert_int_eq(fclose(file), 0);
    }
}

static void remove_shaders(const char *folder)
{
    char path[160];
    for (size_t i = 0; i < sph2d__shader_source_count; ++i) {
        snprintf(path, sizeof path, "%s/%s", folder, sph2d__shader_sources[i].name);
        unlink(path);
    }
    rmdir(folder);
}

/** A desktop's OpenGL compiles them by the stricter rules of OpenGL ES, with the same pixels. */
START_TEST(shaders_compile_for_browsers)
{
    char folder[] = "/tmp/sph2d-looks-XXXXXX";
    ck_assert_ptr_nonnull(mkdtemp(folder));
    write_for_es(folder);
    splash *s = make_splash(0.0);
    for (sph2d_look look = SPH2D_LOOK_WATER; look <= SPH2D_LOOK_INK; ++look) {
        sph2d_render_options options = sph2d_render_options_default();
        options.width = WIDTH;
        options.height = HEIGHT;
        options.look = look;
        options.shader_dir = folder;
        sph2d_renderer *renderer = NULL;
        sph2d_report report = {0};
        ck_assert_msg(sph2d_renderer_create(&options, &renderer, &report) == SPH2D_OK, "look %d: %s", (int)look,
                      test_report_text(&report));
        unsigned char *plain = draw_look(NULL, look, &s->picture);
        ck_assert_mem_eq(draw(renderer, &s->picture), plain, BYTES);
        free(plain);
        sph2d_renderer_destroy(renderer);
    }
    free(s);
    remove_shaders(folder);
}
END_TEST

Suite *suite_looks(void)
{
    Suite *suite = suite_create("looks");
    TCase *cases = tcase_create("looks");
    tcase_add_test(cases, looks_differ_and_are_the_same_each_time);
    tcase_add_test(cases, flat_is_one_color_with_an_edge);
    tcase_add_test(cases, glass_is_translucent);
    tcase_add_test(cases, ink_is_a_line_on_paper);
    tcase_add_test(cases, values_color_every_look);
    tcase_add_loop_test(cases, liquid_has_its_colors, SPH2D_LOOK_WATER, SPH2D_LOOK_INK + 1);
    tcase_add_test(cases, shaders_compile_for_browsers);
    suite_add_tcase(suite, cases);
    return suite;
}
