/* SPDX-License-Identifier: MIT */
/** @file test_render.c
 *  Pictures: what is drawn is measured in pixels, in every way to OpenGL that this build has and this machine offers.
 */
#include <dirent.h>
#include <float.h>
#include <math.h>
#include <png.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "common.h"
#include "sph2d/render.h"

static const double spacing = 0.01; /* [m] */

/* ---- renderers and pictures -------------------------------------------------------------------------------------- */

static const char *const ways[] = {"osmesa", "egl"};
enum { WAYS = sizeof ways / sizeof ways[0] };

/** A renderer that must work; NULL only where `gl` names a way that this build or machine lacks. */
static sph2d_renderer *make(const char *gl, unsigned width, unsigned height, sph2d_style style)
{
    sph2d_render_options options = sph2d_render_options_default();
    options.gl = gl;
    options.width = width;
    options.height = height;
    options.style = style;
    sph2d_report report = {0};
    sph2d_renderer *renderer = NULL;
    sph2d_status status = sph2d_renderer_create(&options, &renderer, &report);
    if (gl != NULL && status == SPH2D_RENDER && test_report_has(&report, SPH2D_CODE_GL_MISSING, NULL))
        return NULL;
    ck_assert_msg(status == SPH2D_OK, "%s", test_report_text(&report));
    ck_assert_ptr_nonnull(renderer);
    return renderer;
}

/** Draws and returns the pixels. */
static const unsigned char *draw(sph2d_renderer *renderer, const sph2d_picture *picture)
{
    sph2d_report report = {0};
    ck_assert_msg(sph2d_renderer_draw(renderer, picture, &report) == SPH2D_OK, "%s", test_report_text(&report));
    const unsigned char *pixels = sph2d_renderer_pixels(renderer);
    ck_assert_ptr_nonnull(pixels);
    return pixels;
}

/** A copy of the pixels of a picture, drawn by a renderer of its own. */
static unsigned char *draw_alone(const char *gl, unsigned width, unsigned height, sph2d_style style,
                                 const sph2d_picture *picture)
{
    sph2d_renderer *renderer = make(gl, width, height, style);
    if (renderer == NULL)
        return NULL;
    const size_t size = (size_t)width * height * 4;
    unsigned char *copy = malloc(size);
    ck_assert_ptr_nonnull(copy);
    memcpy(copy, draw(renderer, picture), size);
    sph2d_renderer_destroy(renderer);
    return copy;
}

/** Whether all tests share this process. */
static bool not_forked(void)
{
    const char *mode = getenv("CK_FORK");
    return mode != NULL && strcmp(mode, "no") == 0;
}

enum { SIDE = 40, FLUID = SIDE * SIDE + 1, WALLS = 30 };

/** Some water in a box of 1.28 m x 0.72 m: a disordered block, a drop, a line of boundary particles. */
typedef struct splash {
    double x[FLUID], y[FLUID], values[FLUID], wall_x[WALLS], wall_y[WALLS];
    sph2d_picture picture;
} splash;

static splash *make_splash(double offset)
{
    splash *s = calloc(1, sizeof *s);
    ck_assert_ptr_nonnull(s);
    uint64_t seed = 7;
    for (int i = 0; i < FLUID - 1; ++i) {
        const int row = i / SIDE;
        s->x[i] = offset + (i % SIDE + 0.5 + test_random(&seed, -0.3, 0.3)) * spacing;
        s->y[i] = offset + (row + 0.5 + test_random(&seed, -0.3, 0.3)) * spacing;
        s->values[i] = i;
    }
    s->x[FLUID - 1] = offset + 0.8;
    s->y[FLUID - 1] = offset + 0.5;
    s->values[FLUID - 1] = -3.0;
    for (int i = 0; i < WALLS; ++i) {
        s->wall_x[i] = offset + 0.7 + i * 0.5 * spacing;
        s->wall_y[i] = offset + 0.2;
    }
    s->picture = (sph2d_picture){.view = {{offset, offset}, {offset + 1.28, offset + 0.72}},
                                 .radius = 2.0 * spacing,
                                 .count = FLUID,
                                 .x = s->x,
                                 .y = s->y,
                                 .values = s->values,
                                 .value_label = "speed [m/s]",
                                 .wall_count = WALLS,
                                 .wall_x = s->wall_x,
                                 .wall_y = s->wall_y,
                                 .wall_radius = 0.5 * spacing};
    return s;
}

/** Water is dark in the red channel, the background and what lies beside the view are light. */
static bool is_water(const unsigned char *pixels, unsigned width, unsigned x, unsigned y)
{
    return pixels[4 * ((size_t)y * width + x)] < 160;
}

static size_t count_water(const unsigned char *pixels, unsigned width, unsigned height)
{
    size_t count = 0;
    for (unsigned y = 0; y < height; ++y)
        for (unsigned x = 0; x < width; ++x)
            count += is_water(pixels, width, x, y);
    return count;
}

/* ---- files ------------------------------------------------------------------------------------------------------- */

static char folder[64];

static void make_folder(void)
{
    snprintf(folder, sizeof folder, "/tmp/sph2d-render-XXXXXX");
    ck_assert_ptr_nonnull(mkdtemp(folder));
}

static const char *path_in_folder(const char *name)
{
    static char path[sizeof folder + 256 + 1]; /* as long as a name can be */
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return path;
}

/** Removes the folder's files and returns how many there were. */
static int empty_folder(void)
{
    int count = 0;
    DIR *dir = opendir(folder);
    ck_assert_ptr_nonnull(dir);
    for (struct dirent *entry; (entry = readdir(dir)) != NULL;)
        if (strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0) {
            unlink(path_in_folder(entry->d_name));
            ++count;
        }
    closedir(dir);
    return count;
}

static void remove_folder(void)
{
    empty_folder();
    rmdir(folder);
}

static void write_file(const char *name, const char *text)
{
    FILE *file = fopen(path_in_folder(name), "w");
    ck_assert_ptr_nonnull(file);
    fputs(text, file);
    ck_assert_int_eq(fclose(file), 0);
}

/** All bytes of a file. */
static unsigned char *read_file(const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    ck_assert_ptr_nonnull(file);
    unsigned char *bytes = malloc(1 << 22);
    ck_assert_ptr_nonnull(bytes);
    *size = fread(bytes, 1, 1 << 22, file);
    fclose(file);
    return bytes;
}

/* ---- creation ---------------------------------------------------------------------------------------------------- */

START_TEST(every_way_draws)
{
    int working = 0;
    for (int w = 0; w < WAYS; ++w)
        for (sph2d_style style = SPH2D_STYLE_METABALLS; style <= SPH2D_STYLE_POINTS; ++style) {
            sph2d_renderer *renderer = make(ways[w], 64, 48, style); /* compiles all shaders of the style */
            if (renderer == NULL)
                continue;
            ++working;
            ck_assert_str_eq(sph2d_renderer_gl(renderer), ways[w]);
            ck_assert_ptr_nonnull(strstr(sph2d_render_backends(), ways[w]));
            ck_assert_uint_gt(strlen(sph2d_renderer_gl_version(renderer)), 0);
            ck_assert_ptr_null(sph2d_renderer_pixels(renderer));
            sph2d_renderer_destroy(renderer);
        }
    ck_assert_int_gt(working, 0);
    sph2d_renderer_destroy(NULL);
}
END_TEST

START_TEST(options_are_checked)
{
    const sph2d_render_options fine = sph2d_render_options_default();
    sph2d_render_options bad[7];
    for (int i = 0; i < 7; ++i)
        bad[i] = fine;
    bad[0].struct_size = 0;
    bad[1].width = 15;
    bad[2].height = 16385;
    bad[3].gl = "vulkan";
    bad[4].style = (sph2d_style)7;
    bad[5].height = 0;
    bad[6].gl = "";
    for (int i = 0; i < 7; ++i) {
        sph2d_report report = {0};
        sph2d_renderer *renderer = (sph2d_renderer *)&report; /* must become NULL */
        ck_assert_int_eq(sph2d_renderer_create(&bad[i], &renderer, &report), SPH2D_INVALID);
        ck_assert_ptr_null(renderer);
        ck_assert_uint_eq(report.errors, 1);
    }
    sph2d_renderer *renderer = NULL;
    ck_assert_int_eq(sph2d_renderer_create(NULL, &renderer, NULL), SPH2D_INVALID);
    ck_assert_int_eq(sph2d_renderer_create(&fine, NULL, NULL), SPH2D_INVALID);
}
END_TEST

START_TEST(missing_gl_is_a_sentence)
{
    if (not_forked())
        return; /* what follows works before Mesa is used, and not afterwards */
    /* Mesa lowers its version on request. */
    setenv("MESA_GL_VERSION_OVERRIDE", "3.0", 1);
    sph2d_render_options options = sph2d_render_options_default();
    sph2d_report report = {0};
    sph2d_renderer *renderer = NULL;
    ck_assert_int_eq(sph2d_renderer_create(&options, &renderer, &report), SPH2D_RENDER);
    ck_assert_ptr_null(renderer);
    ck_assert_uint_eq(report.errors, 1);
    ck_assert_int_eq(report.items[0].code, SPH2D_CODE_GL_MISSING);
    ck_assert_ptr_nonnull(strstr(report.items[0].hint, "install"));
}
END_TEST

START_TEST(bad_shaders_are_located)
{
    sph2d_render_options options = sph2d_render_options_default();
    options.shader_dir = folder;
    sph2d_report report = {0};
    sph2d_renderer *renderer = NULL;
    ck_assert_int_eq(sph2d_renderer_create(&options, &renderer, &report), SPH2D_NOINPUT);
    ck_assert_ptr_null(renderer);
    ck_assert(test_report_has(&report, SPH2D_CODE_FILE_OPEN, NULL));
    ck_assert_ptr_nonnull(strstr(report.items[0].message, path_in_folder("points.vert")));

    write_file("points.vert", "#version 330 core\n\nvoid main() { gl_Position = nothing; }\n");
    sph2d_report_clear(&report);
    ck_assert_int_eq(sph2d_renderer_create(&options, &renderer, &report), SPH2D_RENDER);
    ck_assert_ptr_null(renderer);
    ck_assert_int_eq(report.items[0].code, SPH2D_CODE_GL_SHADER);
    ck_assert_str_eq(report.items[0].file, path_in_folder("points.vert"));
    ck_assert_int_eq(report.items[0].line, 3);
    ck_assert_ptr_nonnull(strstr(report.items[0].excerpt, "nothing"));

    options.shader_dir = "/dev/null";
    sph2d_report_clear(&report);
    ck_assert_int_eq(sph2d_renderer_create(&options, &renderer, &report), SPH2D_NOINPUT);
}
END_TEST

/* ---- what is drawn ----------------------------------------------------------------------------------------------- */

START_TEST(pictures_are_checked)
{
    splash *s = make_splash(0.0);
    sph2d_picture bad[10];
    for (int i = 0; i < 10; ++i)
        bad[i] = s->picture;
    bad[0].view.max.x = bad[0].view.min.x;
    bad[1].view.min.y = NAN;
    bad[2].view.max.y = INFINITY;
    bad[3].x = NULL;
    bad[4].radius = 0.0;
    bad[5].radius = NAN;
    bad[6].wall_y = NULL;
    bad[7].wall_radius = -1.0;
    bad[8].value_min = 2.0;
    bad[8].value_max = 1.0;
    bad[9].value_max = NAN;
    sph2d_renderer *renderer = make(NULL, 64, 48, SPH2D_STYLE_POINTS);
    for (int i = 0; i < 10; ++i)
        ck_assert_int_eq(sph2d_renderer_draw(renderer, &bad[i], NULL), SPH2D_INVALID);
    ck_assert_int_eq(sph2d_renderer_draw(renderer, NULL, NULL), SPH2D_INVALID);
    ck_assert_int_eq(sph2d_renderer_draw(NULL, &s->picture, NULL), SPH2D_INVALID);
    ck_assert_ptr_null(sph2d_renderer_pixels(renderer));
    ck_assert_int_eq(sph2d_renderer_write_png(renderer, path_in_folder("none.png"), NULL), SPH2D_INVALID);
    draw(renderer, &s->picture);
    ck_assert_int_eq(sph2d_renderer_write_png(renderer, NULL, NULL), SPH2D_INVALID);
    sph2d_renderer_destroy(renderer);
    free(s);
}
END_TEST

START_TEST(nothing_is_background)
{
    const sph2d_picture picture = {.view = {{0.0, 0.0}, {1.0, 1.0}}};
    for (sph2d_style style = SPH2D_STYLE_METABALLS; style <= SPH2D_STYLE_POINTS; ++style) {
        sph2d_renderer *renderer = make(NULL, 90, 40, style);
        const unsigned char *pixels = draw(renderer, &picture);
        int others = 0;
        for (unsigned y = 0; y < 40; ++y)
            for (unsigned x = 0; x < 90; ++x) {
                const unsigned char *like = pixels + 4 * (x >= 25 && x < 65 ? 45 : 0); /* the view is in the middle */
                others += memcmp(pixels + 4 * (y * 90 + x), like, 4) != 0;
            }
        ck_assert_int_eq(others, 0);
        for (int i = 0; i < 2; ++i) {
            const unsigned char *pixel = pixels + (i == 0 ? 0 : 4 * 45);
            ck_assert_uint_gt(pixel[0], 200);
            ck_assert_uint_eq(pixel[3], 255);
        }
        ck_assert_mem_ne(pixels, pixels + 4 * 45, 4);
        sph2d_renderer_destroy(renderer);
    }
}
END_TEST

/* A lone ball is seen where r^4 - r^2 + 1/4 > T in units of R, with sqrt T = 1/2 - 1/(4 pi): up to R/(2 sqrt pi). At R
 * of two spacings that circle is as large as the square of a particle. */
START_TEST(lone_ball_has_its_radius)
{
    const double radii[] = {8.0, 25.0, 60.0, 300.0}; /* R [px] */
    const double x = 0.5, y = 0.5;
    sph2d_renderer *renderer = make(NULL, 400, 400, SPH2D_STYLE_METABALLS);
    for (int i = 0; i < 4; ++i) {
        const sph2d_picture picture = {
            .view = {{0.0, 0.0}, {1.0, 1.0}}, .radius = radii[i] / 400.0, .count = 1, .x = &x, .y = &y};
        const unsigned char *pixels = draw(renderer, &picture);
        const double expected = radii[i] / (2.0 * sqrt(TEST_PI));
        unsigned across = 0;
        for (unsigned column = 0; column < 400; ++column)
            across += is_water(pixels, 400, column, 200);
        ck_assert_double_eq_tol(0.5 * across, expected, 1.0);
        ck_assert_double_eq_tol(sqrt((double)count_water(pixels, 400, 400) / TEST_PI), expected, 1.0);
    }
    sph2d_renderer_destroy(renderer);
}
END_TEST

START_TEST(water_covers_its_area)
{
    splash *s = make_splash(0.0);
    s->picture.wall_count = 0;
    sph2d_renderer *renderer = make(NULL, 1280, 720, SPH2D_STYLE_METABALLS);
    const unsigned char *pixels = draw(renderer, &s->picture);
    const double area = FLUID * spacing * spacing * 1.0e6; /* [px] at 1000 px/m */
    ck_assert_double_eq_tol((double)count_water(pixels, 1280, 720) / area, 1.0, 0.04);
    size_t inside = 0; /* no holes */
    for (unsigned y = 720 - 350; y < 720 - 50; ++y)
        for (unsigned x = 50; x < 350; ++x)
            inside += is_water(pixels, 1280, x, y);
    ck_assert_uint_eq(inside, 300 * 300);
    ck_assert(is_water(pixels, 1280, 800, 220)); /* the drop: y points upwards */
    sph2d_renderer_destroy(renderer);
    free(s);
}
END_TEST

START_TEST(points_show_values)
{
    static const unsigned char lowest[3] = {68, 1, 84}, highest[3] = {253, 231, 37}, grey[3] = {150, 150, 150};
    const double x[] = {0.25, 0.5, 0.75}, y[] = {0.5, 0.5, 0.5}, values[] = {1.0, NAN, 2.0};
    sph2d_picture picture = {
        .view = {{0.0, 0.0}, {1.0, 1.0}}, .radius = 0.05, .count = 3, .x = x, .y = y, .values = values};
    sph2d_renderer *renderer = make(NULL, 40, 40, SPH2D_STYLE_POINTS); /* too small for a colour bar */
    const unsigned char *row = draw(renderer, &picture) + 4 * 20 * 40;
    ck_assert_mem_eq(row + 4 * 10, lowest, 3);
    ck_assert_mem_eq(row + 4 * 20, grey, 3);
    ck_assert_mem_eq(row + 4 * 30, highest, 3);
    picture.value_min = 2.0;
    picture.value_max = 3.0;
    draw(renderer, &picture);
    ck_assert_mem_eq(row + 4 * 10, lowest, 3); /* clamped */
    ck_assert_mem_eq(row + 4 * 30, lowest, 3);
    sph2d_renderer_destroy(renderer);
}
END_TEST

START_TEST(color_bar_takes_any_numbers)
{
    const double x[] = {0.25, 0.75}, y[] = {0.5, 0.5};
    const double pairs[][2] = {{0.0, 0.0},       {3.0, 3.0},     {-1.0, 1.0},     {1.0e-9, 3.0e-9},
                               {1.0e20, 3.0e20}, {NAN, NAN},     {INFINITY, 1.0}, {1.0e6, 1.0e6 + 1.0e-6},
                               {-DBL_MAX, 1.0},  {0.0, DBL_MIN}, {99.7, 100.2},   {-DBL_MAX, DBL_MAX}};
    const char *const labels[] = {NULL, "", "Pressures [kg/(m s^2)]",
                                  "\xc3\xa9\x01 and a label that goes on and on and on"};
    sph2d_renderer *renderer = make(NULL, 640, 360, SPH2D_STYLE_POINTS);
    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; ++i) {
        const sph2d_picture picture = {.view = {{0.0, 0.0}, {1.6, 1.0}},
                                       .radius = 0.01,
                                       .count = 2,
                                       .x = x,
                                       .y = y,
                                       .values = pairs[i],
                                       .value_label = labels[i % 4]};
        const unsigned char *pixels = draw(renderer, &picture);
        size_t colors = 0; /* the bar: purple to yellow beside the view */
        for (unsigned row = 0; row < 360; ++row)
            for (unsigned column = 640 * 2 / 3 + 1; column < 640; ++column)
                colors += pixels[4 * (row * 640 + column)] > pixels[4 * (row * 640 + column) + 2] + 50;
        ck_assert_msg(colors > 100, "no colour bar for numbers %zu", i);
    }
    sph2d_renderer_destroy(renderer);
}
END_TEST

START_TEST(not_finite_is_left_out)
{
    for (sph2d_style style = SPH2D_STYLE_METABALLS; style <= SPH2D_STYLE_POINTS; ++style) {
        splash *s = make_splash(0.0);
        s->picture.value_max = 100.0;
        s->picture.count = FLUID - 1; /* without the drop */
        s->picture.wall_count = WALLS - 1;
        unsigned char *without = draw_alone(NULL, 320, 180, style, &s->picture);
        const double others[] = {NAN, INFINITY, -INFINITY, 1.0e300, -1.0e300};
        s->picture.count = FLUID;
        s->picture.wall_count = WALLS;
        sph2d_renderer *renderer = make(NULL, 320, 180, style);
        for (int i = 0; i < 5; ++i) {
            s->x[FLUID - 1] = others[i];
            s->wall_y[WALLS - 1] = others[i];
            ck_assert_mem_eq(draw(renderer, &s->picture), without, 320 * 180 * 4);
        }
        sph2d_renderer_destroy(renderer);
        free(without);
        free(s);
    }
}
END_TEST

START_TEST(far_from_the_origin_looks_the_same)
{
    splash *near = make_splash(0.0), *far = make_splash(1.0e6);
    for (sph2d_style style = SPH2D_STYLE_METABALLS; style <= SPH2D_STYLE_POINTS; ++style) {
        unsigned char *a = draw_alone(NULL, 640, 360, style, &near->picture);
        unsigned char *b = draw_alone(NULL, 640, 360, style, &far->picture);
        int largest = 0;
        for (size_t i = 0; i < 640 * 360 * 4; ++i)
            if (abs(a[i] - b[i]) > largest)
                largest = abs(a[i] - b[i]);
        ck_assert_int_le(largest, 2);
        free(a);
        free(b);
    }
    free(near);
    free(far);
}
END_TEST

START_TEST(any_size_works)
{
    static const unsigned sizes[][2] = {{16, 16}, {3000, 17}, {17, 3000}, {33, 31}};
    splash *s = make_splash(0.0);
    for (int i = 0; i < 4; ++i)
        for (sph2d_style style = SPH2D_STYLE_METABALLS; style <= SPH2D_STYLE_POINTS; ++style) {
            unsigned char *pixels = draw_alone(NULL, sizes[i][0], sizes[i][1], style, &s->picture);
            ck_assert_uint_gt(count_water(pixels, sizes[i][0], sizes[i][1]), 4);
            free(pixels);
        }
    free(s);
}
END_TEST

/* ---- determinism ------------------------------------------------------------------------------------------------- */

START_TEST(same_pixels_every_time)
{
    splash *s = make_splash(0.0), *other = make_splash(0.3);
    for (sph2d_style style = SPH2D_STYLE_METABALLS; style <= SPH2D_STYLE_POINTS; ++style) {
        unsigned char *first = NULL;
        for (int w = 0; w < WAYS; ++w) {
            sph2d_renderer *a = make(ways[w], 320, 180, style), *b = a != NULL ? make(ways[w], 64, 48, style) : NULL;
            if (a == NULL)
                continue;
            if (first == NULL)
                first = draw_alone(ways[w], 320, 180, style, &s->picture);
            draw(a, &other->picture); /* leaves nothing behind */
            ck_assert_mem_eq(draw(a, &s->picture), first, 320 * 180 * 4);
            draw(b, &other->picture);
            ck_assert_mem_eq(draw(a, &s->picture), first, 320 * 180 * 4);
            sph2d_renderer_destroy(b);
            ck_assert_mem_eq(draw(a, &s->picture), first, 320 * 180 * 4);
            sph2d_renderer_destroy(a);
        }
        free(first);
    }
    free(other);
    free(s);
}
END_TEST

/** Draws in a process of its own, since the driver counts its threads once. */
static void draw_with_threads(const char *threads, const sph2d_picture *picture, unsigned char *pixels, size_t size)
{
    int ends[2];
    ck_assert_int_eq(pipe(ends), 0);
    const pid_t child = fork();
    ck_assert_int_ge(child, 0);
    if (child == 0) {
        setenv("LP_NUM_THREADS", threads, 1);
        unsigned char *drawn = draw_alone(NULL, 320, 180, SPH2D_STYLE_METABALLS, picture);
        for (size_t done = 0; done < size;) {
            const ssize_t count = write(ends[1], drawn + done, size - done);
            if (count <= 0)
                _exit(1);
            done += (size_t)count;
        }
        _exit(0);
    }
    close(ends[1]);
    size_t done = 0;
    for (ssize_t count; done < size && (count = read(ends[0], pixels + done, size - done)) > 0;)
        done += (size_t)count;
    close(ends[0]);
    int status = 0;
    ck_assert_int_eq(waitpid(child, &status, 0), child);
    ck_assert_int_eq(status, 0);
    ck_assert_uint_eq(done, size);
}

START_TEST(any_number_of_threads_draws_the_same)
{
    if (not_forked())
        return; /* a forked child cannot draw once its parent has */
    static unsigned char one[320 * 180 * 4], other[320 * 180 * 4];
    splash *s = make_splash(0.0);
    draw_with_threads("0", &s->picture, one, sizeof one);
    draw_with_threads("1", &s->picture, other, sizeof other);
    ck_assert_mem_eq(one, other, sizeof one);
    draw_with_threads("3", &s->picture, other, sizeof other);
    ck_assert_mem_eq(one, other, sizeof one);
    free(s);
}
END_TEST

/* ---- PNG --------------------------------------------------------------------------------------------------------- */

START_TEST(png_holds_the_pixels)
{
    splash *s = make_splash(0.0);
    sph2d_renderer *renderer = make(NULL, 320, 180, SPH2D_STYLE_METABALLS);
    const unsigned char *pixels = draw(renderer, &s->picture);
    ck_assert_int_eq(sph2d_renderer_write_png(renderer, path_in_folder("a.png"), NULL), SPH2D_OK);
    png_image image = {.version = PNG_IMAGE_VERSION};
    ck_assert_int_ne(png_image_begin_read_from_file(&image, path_in_folder("a.png")), 0);
    ck_assert_uint_eq(image.width, 320);
    ck_assert_uint_eq(image.height, 180);
    ck_assert_uint_eq(image.format, PNG_FORMAT_RGB);
    image.format = PNG_FORMAT_RGBA;
    static unsigned char back[320 * 180 * 4];
    ck_assert_int_ne(png_image_finish_read(&image, NULL, back, 0, NULL), 0);
    ck_assert_mem_eq(back, pixels, sizeof back);

    /* the same bytes again, over a file that is there */
    size_t first_size = 0, second_size = 0;
    unsigned char *first = read_file(path_in_folder("a.png"), &first_size);
    ck_assert_int_eq(sph2d_renderer_write_png(renderer, path_in_folder("a.png"), NULL), SPH2D_OK);
    unsigned char *second = read_file(path_in_folder("a.png"), &second_size);
    ck_assert_uint_eq(first_size, second_size);
    ck_assert_mem_eq(first, second, first_size);
    ck_assert_int_eq(empty_folder(), 1);
    free(first);
    free(second);
    sph2d_renderer_destroy(renderer);
    free(s);
}
END_TEST

START_TEST(unwritable_png_leaves_nothing)
{
    splash *s = make_splash(0.0);
    sph2d_renderer *renderer = make(NULL, 320, 180, SPH2D_STYLE_METABALLS);
    draw(renderer, &s->picture);
    const char *const paths[] = {path_in_folder("none/a.png"), "/dev/full", folder, ""};
    for (int i = 0; i < 4; ++i) {
        sph2d_report report = {0};
        const sph2d_status status = sph2d_renderer_write_png(renderer, paths[i], &report);
        ck_assert_msg(status == SPH2D_CANTCREAT || status == SPH2D_IO, "'%s': %d", paths[i], (int)status);
        ck_assert_uint_eq(report.errors, 1);
        ck_assert_int_eq(report.items[0].code, SPH2D_CODE_FILE_WRITE);
        ck_assert_ptr_nonnull(strstr(report.items[0].message, paths[i]));
    }
    ck_assert_int_eq(empty_folder(), 0);

    /* a disk that fills up in the middle */
    struct rlimit limit, small;
    ck_assert_int_eq(getrlimit(RLIMIT_FSIZE, &limit), 0);
    small = limit;
    small.rlim_cur = 1000;
    void (*handler)(int) = signal(SIGXFSZ, SIG_IGN);
    ck_assert_int_eq(setrlimit(RLIMIT_FSIZE, &small), 0);
    sph2d_report report = {0};
    const sph2d_status status = sph2d_renderer_write_png(renderer, path_in_folder("a.png"), &report);
    ck_assert_int_eq(setrlimit(RLIMIT_FSIZE, &limit), 0);
    signal(SIGXFSZ, handler);
    ck_assert_int_eq(status, SPH2D_IO);
    ck_assert_ptr_nonnull(strstr(report.items[0].message, "File too large"));
    ck_assert_int_eq(empty_folder(), 0);
    sph2d_renderer_destroy(renderer);
    free(s);
}
END_TEST

Suite *suite_render(void)
{
    Suite *suite = suite_create("render");
    TCase *drawing = tcase_create("drawing");
    tcase_add_test(drawing, missing_gl_is_a_sentence);
    tcase_add_test(drawing, every_way_draws);
    tcase_add_test(drawing, options_are_checked);
    tcase_add_test(drawing, nothing_is_background);
    tcase_add_test(drawing, lone_ball_has_its_radius);
    tcase_add_test(drawing, water_covers_its_area);
    tcase_add_test(drawing, points_show_values);
    tcase_add_test(drawing, color_bar_takes_any_numbers);
    tcase_add_test(drawing, not_finite_is_left_out);
    tcase_add_test(drawing, far_from_the_origin_looks_the_same);
    tcase_add_test(drawing, any_size_works);
    tcase_add_test(drawing, same_pixels_every_time);
    tcase_add_test(drawing, any_number_of_threads_draws_the_same);
    suite_add_tcase(suite, drawing);

    TCase *files = tcase_create("files");
    tcase_add_checked_fixture(files, make_folder, remove_folder);
    tcase_add_test(files, bad_shaders_are_located);
    tcase_add_test(files, pictures_are_checked);
    tcase_add_test(files, png_holds_the_pixels);
    tcase_add_test(files, unwritable_png_leaves_nothing);
    suite_add_tcase(suite, files);
    return suite;
}
