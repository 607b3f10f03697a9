/* SPDX-License-Identifier: MIT */
/** @file test_render.c
 *  Renderers: in which ways to OpenGL they can be had, what they refuse, and the PNG files that they write. */
#include <dirent.h>
#include <math.h>
#include <png.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

#include "sph2d/render.h"
#include "splash.h"

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
            sph2d_renderer *renderer = make_renderer(ways[w], 64, 48, style); /* compiles all shaders of the style */
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
    sph2d_render_options bad[9];
    for (int i = 0; i < 9; ++i)
        bad[i] = fine;
    bad[0].struct_size = 0;
    bad[1].width = 15;
    bad[2].height = 16385;
    bad[3].gl = "vulkan";
    bad[4].style = (sph2d_style)7;
    bad[5].height = 0;
    bad[6].gl = "";
    bad[7].look = (sph2d_look)(SPH2D_LOOK_INK + 1);
    bad[8].background = (sph2d_background)-1;
    for (int i = 0; i < 9; ++i) {
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
    ck_assert_ptr_nonnull(strstr(report.items[0].message, path_in_folder("gradientball.vert")));

    write_file("gradientball.vert", "#version 330 core\n\nvoid main() { gl_Position = nothing; }\n");
    sph2d_report_clear(&report);
    ck_assert_int_eq(sph2d_renderer_create(&options, &renderer, &report), SPH2D_RENDER);
    ck_assert_ptr_null(renderer);
    ck_assert_int_eq(report.items[0].code, SPH2D_CODE_GL_SHADER);
    ck_assert_str_eq(report.items[0].file, path_in_folder("gradientball.vert"));
    ck_assert_int_eq(report.items[0].line, 3);
    ck_assert_ptr_nonnull(strstr(report.items[0].excerpt, "nothing"));

    options.shader_dir = "/dev/null";
    sph2d_report_clear(&report);
    ck_assert_int_eq(sph2d_renderer_create(&options, &renderer, &report), SPH2D_NOINPUT);
}
END_TEST

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
    bad[6].outline_y = NULL;
    bad[7].wall_thickness = -1.0;
    bad[8].value_min = 2.0;
    bad[8].value_max = 1.0;
    bad[9].value_max = NAN;
    sph2d_renderer *renderer = make_renderer(NULL, 64, 48, SPH2D_STYLE_POINTS);
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

/* ---- PNG --------------------------------------------------------------------------------------------------------- */

static void check_file(const unsigned char *pixels, unsigned width, unsigned height, sph2d_background background)
{
    const bool alpha = background == SPH2D_BACKGROUND_TRANSPARENT;
    const size_t size = (size_t)4 * width * height;
    ck_assert_int_eq(sph2d_png_write(path_in_folder("c.png"), pixels, width, height, background, NULL), SPH2D_OK);
    png_image image = {.version = PNG_IMAGE_VERSION};
    ck_assert_int_ne(png_image_begin_read_from_file(&image, path_in_folder("c.png")), 0);
    ck_assert(image.width == width && image.height == height);
    ck_assert_uint_eq(image.format, alpha ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB);
    image.format = PNG_FORMAT_RGBA;
    unsigned char *back = malloc(size);
    ck_assert_ptr_nonnull(back);
    ck_assert_int_ne(png_image_finish_read(&image, NULL, back, 0, NULL), 0);
    ck_assert_uint_eq(image.warning_or_error, 0);
    for (size_t k = 0; k < size; ++k)
        ck_assert_uint_eq(back[k], k % 4 == 3 && !alpha ? 255 : pixels[k]);
    free(back);
}

/** Noise, which does not compress, and even colours, of sizes from one pixel to several chunks of data. */
START_TEST(png_holds_any_pixels)
{
    static const unsigned sizes[][2] = {{1, 1}, {1, 40}, {40, 1}, {7, 5}, {171, 128}, {333, 211}, {2048, 3}, {3, 9000}};
    static unsigned char pixels[4 * 333 * 211];
    uint64_t seed = 21;
    for (int even = 0; even < 2; ++even) {
        for (size_t k = 0; k < sizeof pixels; ++k)
            pixels[k] = even ? 77 : (unsigned char)test_random(&seed, 0, 255.99);
        for (size_t i = 0; i < sizeof sizes / sizeof *sizes; ++i) {
            check_file(pixels, sizes[i][0], sizes[i][1], SPH2D_BACKGROUND_OPAQUE);
            check_file(pixels, sizes[i][0], sizes[i][1], SPH2D_BACKGROUND_TRANSPARENT);
        }
    }
    ck_assert_int_eq(empty_folder(), 1);
}
END_TEST

START_TEST(png_holds_the_pixels)
{
    splash *s = make_splash(0.0);
    sph2d_renderer *renderer = make_renderer(NULL, 320, 180, SPH2D_STYLE_METABALLS);
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
    ck_assert_int_eq(sph2d_png_write(path_in_folder("b.png"), pixels, 320, 180, SPH2D_BACKGROUND_OPAQUE, NULL),
                     SPH2D_OK);
    free(second);
    second = read_file(path_in_folder("b.png"), &second_size);
    ck_assert_uint_eq(first_size, second_size);
    ck_assert_mem_eq(first, second, first_size);
    ck_assert_int_eq(empty_folder(), 2);
    free(first);
    free(second);
    sph2d_renderer_destroy(renderer);
    free(s);
}
END_TEST

START_TEST(unwritable_png_leaves_nothing)
{
    splash *s = make_splash(0.0);
    sph2d_renderer *renderer = make_renderer(NULL, 320, 180, SPH2D_STYLE_METABALLS);
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
    TCase *creation = tcase_create("creation");
    tcase_add_test(creation, missing_gl_is_a_sentence);
    tcase_add_test(creation, every_way_draws);
    tcase_add_test(creation, options_are_checked);
    suite_add_tcase(suite, creation);

    TCase *files = tcase_create("files");
    tcase_add_checked_fixture(files, make_folder, remove_folder);
    tcase_add_test(files, bad_shaders_are_located);
    tcase_add_test(files, pictures_are_checked);
    tcase_add_test(files, png_holds_the_pixels);
    tcase_add_test(files, unwritable_png_leaves_nothing);
    suite_add_tcase(suite, files);
    TCase *slow = test_long(suite);
    tcase_add_checked_fixture(slow, make_folder, remove_folder);
    tcase_add_test(slow, png_holds_any_pixels);
    return suite;
}
