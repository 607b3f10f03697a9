/* SPDX-License-Identifier: MIT */
/** @file test_balls.c
 *  The first pass of metaballs as the card draws it: its sums are read back and compared with sums over all particles; and
 *  what follows from them, the depth and the kinds of tiles. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "common.h"
#include "render/drawing.h"
#include "render/legend.h"
#include "render/target.h"
#include "shaders.h"
#include "sph2d/render.h"

/* ---- a drawing, and what is in its textures ---------------------------------------------------------------------- */

/** A drawing of metaballs with a context of its own, and a picture of which a metre is a pixel. */
typedef struct studio {
    sph2d__gl_context context;
    sph2d__drawing drawing;
    sph2d_picture picture;
} studio;

static void open_context(studio *s, int width, int height)
{
    sph2d_report report = {0};
    *s = (studio){.drawing = {.width = width, .height = height, .style = SPH2D_STYLE_METABALLS},
                  .picture = {.view = {{0.0, 0.0}, {width, height}}, .value_min = 0.0, .value_max = 1.0}};
    ck_assert_msg(sph2d__gl_open(NULL, &s->context, &s->drawing.gl, &report) == SPH2D_OK, "%s",
                  test_report_text(&report));
}

static void open_studio(studio *s, int width, int height)
{
    sph2d_report report = {0};
    open_context(s, width, height);
    ck_assert_msg(sph2d__drawing_create(&s->drawing, NULL, &report) == SPH2D_OK, "%s", test_report_text(&report));
}

static void paint(studio *s)
{
    sph2d__layout at;
    sph2d_report report = {0};
    ck_assert_int_eq(sph2d__drawing_arrange(&s->drawing, &s->picture, &at, &report), SPH2D_OK);
    ck_assert_msg(sph2d__drawing_paint(&s->drawing, &s->picture, &at, &report) == SPH2D_OK, "%s",
                  test_report_text(&report));
}

static void close_studio(studio *s)
{
    sph2d__drawing_destroy(&s->drawing);
    s->context.release(s->context.impl);
    s->context.destroy(s->context.impl);
}

/** The floats of a texture, four a texel, which the caller frees. */
static float *read_texture(const studio *s, const sph2d__target *from, GLuint texture)
{
    const sph2d__gl *gl = &s->drawing.gl;
    float *texels = malloc((size_t)from->width * (size_t)from->height * 4 * sizeof *texels);
    GLuint framebuffer = 0;
    ck_assert_ptr_nonnull(texels);
    gl->GenFramebuffers(1, &framebuffer);
    gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    gl->ReadPixels(0, 0, from->width, from->height, GL_RGBA, GL_FLOAT, texels);
    gl->DeleteFramebuffers(1, &framebuffer);
    ck_assert_int_eq(sph2d__gl_check(gl, "reading a texture", NULL), SPH2D_OK);
    return texels;
}

/** The value of a square in texels of two by two of them. */
static double square_of(const float *texels, const sph2d__target *from, int column, int row)
{
    const size_t texel = (size_t)(row / 2) * (size_t)from->width + (size_t)(column / 2);
    return texels[4 * texel + (size_t)(2 * (row % 2) + column % 2)];
}

/* ---- sums -------------------------------------------------------------------------------------------------------- */

enum { WIDTH = 101, HEIGHT = 75, BALLS = 90 };

/** Particles inside the image, at its edges and beside it. */
static void place_balls(double x[BALLS], double y[BALLS], double values[BALLS], double beside)
{
    uint64_t seed = 11;
    for (int i = 0; i < BALLS; ++i) {
        x[i] = test_random(&seed, -beside, WIDTH + beside);
        y[i] = test_random(&seed, -beside, HEIGHT + beside);
        values[i] = test_random(&seed, 0.0, 1.0);
    }
    static const double edges[][2] = {{0, 40}, {WIDTH, 30}, {50, 0}, {60, HEIGHT}, {-0.25, -0.25}, {WIDTH + 2.5, 20}};
    for (size_t k = 0; k < sizeof edges / sizeof *edges; ++k) {
        x[k] = edges[k][0];
        y[k] = edges[k][1];
    }
}

/** The field of a ball at so many pixels from its centre, by its formula. */
static double field_of(double across, double down, double radius)
{
    const double s = (across * across + down * down) / (radius * radius);
    return s < 0.5 ? s * s - s + 0.25 : 0.0;
}

/** The sum over all balls at a place of the image [px]. */
static double sum_at(const studio *s, double across, double down, double radius)
{
    double sum = 0.0;
    for (size_t i = 0; i < s->picture.count; ++i)
        sum += field_of(s->picture.x[i] - across, HEIGHT - s->picture.y[i] - down, radius);
    return sum;
}

/** How exact sums are: half precision rounds each of many balls to a thousandth of the sum. */
static double tolerance(const studio *s)
{
    return s->drawing.gl.sum_bits == 32 ? 2.0e-4 : 2.0e-2;
}

static void check_field(const studio *s, double radius)
{
    const sph2d__target *field = &s->drawing.metaballs.field;
    float *texels = read_texture(s, field, field->texture);
    double largest = 0.0;
    for (int row = 0; row < HEIGHT; ++row)
        for (int column = 0; column < WIDTH; ++column) {
            const double sum = sum_at(s, column + 0.5, row + 0.5, radius);
            largest = fmax(largest, sum);
            ck_assert_double_eq_tol(square_of(texels, field, column, row), sum, tolerance(s) * fmax(1.0, sum));
        }
    ck_assert_double_gt(largest, 0.2);
    free(texels);
}

static void check_colors(const studio *s, double radius)
{
    const sph2d__target *field = &s->drawing.metaballs.field;
    float *texels = read_texture(s, field, field->second);
    for (int k = 0; k < field->width * field->height; ++k) {
        const double across = 2 * (k % field->width) + 1, down = 2 * (k / field->width) + 1; /* NOLINT: whole rows */
        double sums[4] = {0.0};
        for (size_t i = 0; i < BALLS; ++i) {
            const double ball = field_of(s->picture.x[i] - across, HEIGHT - s->picture.y[i] - down, radius);
            unsigned char color[4];
            sph2d__colormap(s->picture.values[i], false, color);
            for (int c = 0; c < 4; ++c)
                sums[c] += ball * (c < 3 ? color[c] / 255.0 : 1.0);
        }
        for (int c = 0; c < 4; ++c)
            ck_assert_double_eq_tol(texels[4 * k + c], sums[c], tolerance(s) * fmax(1.0, sums[c]));
    }
    free(texels);
}

/** Points, and triangles where balls are larger than points can be; with colours and without. */
static void check_sums(studio *s)
{
    static const double radii[] = {4.0, 7.5, 30.0, 420.0};
    double x[BALLS], y[BALLS], values[BALLS];
    for (int k = 0; k < 8; ++k) {
        const double radius = radii[k / 2];
        place_balls(x, y, values, fmax(radius, 8.0));
        s->picture.radius = radius;
        s->picture.count = BALLS;
        s->picture.x = x;
        s->picture.y = y;
        s->picture.values = k % 2 ? values : NULL;
        paint(s);
        check_field(s, radius);
        if (k % 2)
            check_colors(s, radius);
    }
}

START_TEST(sums_are_those_of_the_formula)
{
    studio s;
    open_studio(&s, WIDTH, HEIGHT);
    ck_assert_int_lt(s.drawing.gl.largest_point, 400);
    check_sums(&s);
    s.drawing.gl.largest_point = 1; /* as if there were no larger ones */
    check_sums(&s);
    close_studio(&s);
}
END_TEST

/** As in an OpenGL ES that adds up 16 bits alone; and where it adds up none, a sentence. */
START_TEST(fewer_bits_are_less_exact)
{
    studio s;
    open_context(&s, WIDTH, HEIGHT);
    s.drawing.gl.sum_bits = s.drawing.gl.smooth_bits = 16;
    ck_assert_int_eq(sph2d__drawing_create(&s.drawing, NULL, NULL), SPH2D_OK);
    check_sums(&s);
    close_studio(&s);

    sph2d_report report = {0};
    open_context(&s, WIDTH, HEIGHT);
    s.drawing.gl.sum_bits = 0;
    ck_assert_int_eq(sph2d__drawing_create(&s.drawing, NULL, &report), SPH2D_RENDER);
    ck_assert_uint_eq(report.errors, 1);
    ck_assert_ptr_nonnull(strstr(test_report_text(&report), "GL_EXT_color_buffer_float"));
    close_studio(&s);
}
END_TEST

/** That of wide balls on a coarse grid, and what light follows. */
START_TEST(depth_is_that_of_wide_balls)
{
    double x[BALLS], y[BALLS], values[BALLS];
    studio s;
    open_studio(&s, WIDTH, HEIGHT);
    place_balls(x, y, values, 30.0);
    s.picture.radius = 6.0;
    s.picture.count = BALLS;
    s.picture.x = x;
    s.picture.y = y;
    paint(&s);
    const sph2d__metaballs *balls = &s.drawing.metaballs;
    float *sums = read_texture(&s, &balls->sums, balls->sums.texture);
    float *depth = read_texture(&s, &balls->depth, balls->depth.texture);
    const double wide = 9.33 * 6.0, side = 9.0, whole = TEST_PI / 6.0 * 9.33 * 9.33; /* whole: inside a large body */
    ck_assert_double_eq_tol(balls->texel, side, 1.0e-12);
    for (int row = 1; row < balls->rows - 1; ++row)
        for (int column = 1; column < balls->columns - 1; ++column) {
            double around[5]; /* here, left, right, above, below */
            for (int k = 0; k < 5; ++k) {
                const int to_right = (k == 2) - (k == 1), down = (k == 4) - (k == 3);
                around[k] = sum_at(&s, (column + to_right - 4 + 0.5) * side, (row + down - 4 + 0.5) * side, wide);
            }
            ck_assert_double_eq_tol(square_of(sums, &balls->sums, column, row), around[0], 2.0e-4);
            const float *found = depth + 4 * ((size_t)row * (size_t)balls->depth.width + (size_t)column);
            const double mean = 0.25 * (around[1] + around[2] + around[3] + around[4]);
            ck_assert_double_eq_tol(found[0] * whole, around[2] - around[1], 1.0e-3);
            ck_assert_double_eq_tol(found[1] * whole, around[4] - around[3], 1.0e-3);
            ck_assert_double_eq_tol(found[2] * whole, mean, 1.0e-3);
        }
    free(sums);
    free(depth);
    close_studio(&s);
}
END_TEST

/** A solid has the depth of a large body of water, half of it at its edge, and none far away; wherever it moves. */
START_TEST(walls_count_as_filled)
{
    static const uint64_t outline[4], liquid[4] = {SPH2D_OUTLINE_LIQUID_OUTSIDE, SPH2D_OUTLINE_LIQUID_OUTSIDE,
                                                   SPH2D_OUTLINE_LIQUID_OUTSIDE, SPH2D_OUTLINE_LIQUID_OUTSIDE};
    studio s;
    open_studio(&s, 400, 300);
    for (int moved = 0; moved < 60; moved += 20) {
        const double at = 200 + moved, x[] = {-100, at, at, -100}, y[] = {-100, -100, 400, 400};
        s.picture.radius = 4.0;
        s.picture.outline_count = 4;
        s.picture.outline_x = x;
        s.picture.outline_y = y;
        s.picture.outline_id = outline;
        s.picture.outline_liquid = liquid;
        paint(&s);
        const sph2d__metaballs *balls = &s.drawing.metaballs;
        float *depth = read_texture(&s, &balls->depth, balls->depth.texture);
        const float *row = depth + 4 * (size_t)(balls->rows / 2) * (size_t)balls->depth.width;
        const double column = at / balls->texel + 4 - 0.5;
        const int before = (int)column;
        const double part = column - before, one = row[4 * before + 2], next = row[4 * before + 6];
        ck_assert_double_eq_tol(row[4 * (before - 9) + 2], 1.0, 0.02);
        ck_assert_double_eq_tol((1.0 - part) * one + part * next, 0.5, 0.02);
        ck_assert_double_eq_tol(row[4 * (before + 9) + 2], 0.0, 1.0e-6);
        ck_assert_double_lt(row[4 * before], 0.0); /* it falls to the right */
        free(depth);
    }
    close_studio(&s);
}
END_TEST

/* ---- tiles ------------------------------------------------------------------------------------------------------- */

enum { WIDE = 203, HIGH = 157, SIDE = 40 };

/** A lattice of balls in an image, so many of their radii apart, with a hole, and here and there one missing. */
static size_t place_lattice(double x[SIDE * SIDE], double y[SIDE * SIDE], double radius, double apart, uint64_t *seed)
{
    size_t count = 0;
    for (int i = 0; i < SIDE * SIDE; ++i) {
        x[count] = 11.3 + i % SIDE * apart * radius;
        y[count] = HIGH - 9.1 - i / SIDE * apart * radius; /* NOLINT: whole rows */
        count += hypot(x[count] - 90.0, HIGH - y[count] - 60.0) > 3.0 * radius && test_random(seed, 0, 1) > 0.02;
    }
    return count;
}

/** The kind of a tile tells about each pixel in it what the second pass relies on: no water, or no surface around. */
static void check_kinds(const studio *s, int count[3])
{
    const sph2d__metaballs *balls = &s->drawing.metaballs;
    float *field = read_texture(s, &balls->field, balls->field.texture);
    float *kinds = read_texture(s, &balls->kinds, balls->kinds.texture);
    for (int k = 0; k < WIDE * HIGH; ++k) {
        const int column = k % WIDE, row = k / WIDE;
        const int tile = row / SPH2D__TILE * balls->kinds.width + column / SPH2D__TILE;
        const int kind = (int)lrintf(255 * kinds[4 * tile]);
        ck_assert(kind >= SPH2D__TILE_EMPTY && kind <= SPH2D__TILE_INSIDE);
        ++count[kind];
        if (kind == SPH2D__TILE_EMPTY)
            ck_assert_double_lt(square_of(field, &balls->field, column, row), 0.07071);
        for (int around = 0; around < 81 && kind == SPH2D__TILE_INSIDE; ++around) {
            const int at = column + around % 9 - 4, below = row + around / 9 - 4;
            if (at >= 0 && below >= 0 && at < WIDE && below < HIGH)
                ck_assert_double_ge(square_of(field, &balls->field, at, below), 0.36);
        }
    }
    free(field);
    free(kinds);
}

START_TEST(kinds_hold_for_every_pixel)
{
    static double x[SIDE * SIDE], y[SIDE * SIDE];
    int count[3] = {0};
    uint64_t seed = 4;
    studio s;
    open_studio(&s, WIDE, HIGH);
    for (int i = 0; i < 30; ++i) {
        s.picture.radius = 6.0;
        s.picture.count = place_lattice(x, y, 6.0, i % 3 ? 0.5 : 0.6, &seed); /* full, and not quite */
        s.picture.x = x;
        s.picture.y = y;
        paint(&s);
        check_kinds(&s, count);
    }
    ck_assert_int_gt(count[SPH2D__TILE_EMPTY], WIDE * HIGH);
    ck_assert_int_gt(count[SPH2D__TILE_TOUCHED], WIDE * HIGH);
    ck_assert_int_gt(count[SPH2D__TILE_INSIDE], 3000);
    close_studio(&s);
}
END_TEST

/* ---- pictures ---------------------------------------------------------------------------------------------------- */

enum { BLOCK_WIDTH = 256, BLOCK_HEIGHT = 192, BYTES = BLOCK_WIDTH * BLOCK_HEIGHT * 4 };

static sph2d_renderer *make_block_renderer(const char *shader_dir)
{
    sph2d_render_options options = sph2d_render_options_default();
    sph2d_renderer *renderer = NULL;
    sph2d_report report = {0};
    options.width = BLOCK_WIDTH;
    options.height = BLOCK_HEIGHT;
    options.shader_dir = shader_dir;
    ck_assert_msg(sph2d_renderer_create(&options, &renderer, &report) == SPH2D_OK, "%s", test_report_text(&report));
    return renderer;
}

/** A block of liquid whose first particle is at (x, y), and one drop elsewhere; coloured or not. As many pixels are a
 *  metre. */
static const unsigned char *draw_block(sph2d_renderer *renderer, double x, double y, double radius, bool colored)
{
    static double at[2][SIDE * SIDE], values[SIDE * SIDE];
    for (int i = 0; i < SIDE * SIDE; ++i) {
        at[0][i] = x + i % SIDE * 0.5 * radius;
        at[1][i] = y + i / SIDE * 0.5 * radius; /* NOLINT: whole rows */
        values[i] = i % SIDE;
    }
    at[0][7] = 250.0 - x;
    const sph2d_picture picture = {.view = {{0.0, 0.0}, {BLOCK_WIDTH, BLOCK_HEIGHT}},
                                   .radius = radius,
                                   .count = SIDE * SIDE,
                                   .x = at[0],
                                   .y = at[1],
                                   .values = colored ? values : NULL};
    sph2d_report report = {0};
    ck_assert_msg(sph2d_renderer_draw(renderer, &picture, &report) == SPH2D_OK, "%s", test_report_text(&report));
    return sph2d_renderer_pixels(renderer);
}

/** What earlier pictures left in textures and buffers is not seen. */
START_TEST(pictures_do_not_depend_on_those_before)
{
    sph2d_renderer *used = make_block_renderer(NULL);
    uint64_t seed = 8;
    for (int i = 0; i < 24; ++i) {
        const double x = test_random(&seed, -60, 200), y = test_random(&seed, -100, 170);
        const double radius = i % 7 == 3 ? 11.0 : 6.0;
        const bool colored = i % 5 == 2 || i % 5 == 3;
        sph2d_renderer *fresh = make_block_renderer(NULL);
        const unsigned char *pixels = draw_block(used, x, y, radius, colored);
        ck_assert_mem_eq(pixels, draw_block(fresh, x, y, radius, colored), BYTES);
        sph2d_renderer_destroy(fresh);
    }
    sph2d_renderer_destroy(used);
}
END_TEST

/** Light follows the depth, and must not jump where particles pass from texel to texel of its grid. */
START_TEST(moved_water_looks_the_same)
{
    sph2d_renderer *renderer = make_block_renderer(NULL);
    static unsigned char still[BYTES];
    memcpy(still, draw_block(renderer, 60, 60, 4.0, false), BYTES);
    for (int moved = 3; moved < 15; moved += 4) {
        const unsigned char *pixels = draw_block(renderer, 60 + moved, 60, 4.0, false);
        int largest = 0;
        for (int y = 0; y < BLOCK_HEIGHT; ++y)
            for (int k = 4 * 50; k < 4 * 150; ++k) { /* the drop moves the other way */
                const int row = y * BLOCK_WIDTH * 4;
                largest = (int)fmax(largest, abs(still[row + k] - pixels[row + 4 * moved + k]));
            }
        ck_assert_int_le(largest, 4);
    }
    sph2d_renderer_destroy(renderer);
}
END_TEST

/** Writes the shaders into a folder, where gradientball.frag has another number in place of one. */
static void write_shaders(const char *folder, const char *number, const char *other)
{
    for (size_t i = 0; i < sph2d__shader_source_count; ++i) {
        const char *text = sph2d__shader_sources[i].text;
        const bool changed = strcmp(sph2d__shader_sources[i].name, "gradientball.frag") == 0;
        const char *at = changed ? strstr(text, number) : text;
        ck_assert_ptr_nonnull(at);
        char path[160];
        snprintf(path, sizeof path, "%s/%s", folder, sph2d__shader_sources[i].name);
        FILE *file = fopen(path, "w");
        ck_assert_ptr_nonnull(file);
        fprintf(file, "%.*s%s%s", (int)(at - text), text, changed ? other : "", at + (changed ? strlen(number) : 0));
        ck_assert_int_eq(fclose(file), 0);
    }
}

/** Metaballs are what gradientball.frag makes them: another field is another picture, and with none there is no liquid. */
START_TEST(another_ball_is_another_picture)
{
    static const char *const others[] = {"0.5 - s", "0.4 - s", "0.0 - s"};
    char folder[] = "/tmp/sph2d-balls-XXXXXX", path[160];
    unsigned char *pictures[3];
    ck_assert_ptr_nonnull(mkdtemp(folder));
    for (int k = 0; k < 3; ++k) {
        write_shaders(folder, others[0], others[k]);
        sph2d_renderer *renderer = make_block_renderer(folder);
        pictures[k] = malloc(BYTES);
        ck_assert_ptr_nonnull(pictures[k]);
        memcpy(pictures[k], draw_block(renderer, 60, 60, 4.0, false), BYTES);
        sph2d_renderer_destroy(renderer);
    }
    ck_assert_mem_ne(pictures[0], pictures[1], BYTES);
    int water = 0;
    for (int i = 0; i < BYTES; i += 4)
        water += memcmp(pictures[2] + i, pictures[2], 4) != 0;
    ck_assert_int_eq(water, 0);
    for (int k = 0; k < 3; ++k)
        free(pictures[k]);
    for (size_t i = 0; i < sph2d__shader_source_count; ++i) {
        snprintf(path, sizeof path, "%s/%s", folder, sph2d__shader_sources[i].name);
        unlink(path);
    }
    rmdir(folder);
}
END_TEST

Suite *suite_balls(void)
{
    Suite *suite = suite_create("balls");
    TCase *sums = tcase_create("sums");
    tcase_add_test(sums, sums_are_those_of_the_formula);
    tcase_add_test(sums, fewer_bits_are_less_exact);
    tcase_add_test(sums, depth_is_that_of_wide_balls);
    tcase_add_test(sums, walls_count_as_filled);
    suite_add_tcase(suite, sums);
    TCase *slow = test_long(suite);
    tcase_add_test(slow, kinds_hold_for_every_pixel);
    TCase *pictures = tcase_create("pictures");
    tcase_add_test(pictures, pictures_do_not_depend_on_those_before);
    tcase_add_test(pictures, moved_water_looks_the_same);
    tcase_add_test(pictures, another_ball_is_another_picture);
    suite_add_tcase(suite, pictures);
    return suite;
}
