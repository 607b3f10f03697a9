/* SPDX-License-Identifier: MIT */
/** @file test_drawing.c
 *  Pictures: what is drawn is measured in pixels, and the same every time, in every way to OpenGL that this build has
 *  and this machine offers. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "render/canvas.h"
#include "sph2d/render.h"
#include "splash.h"

/* ---- what is drawn ----------------------------------------------------------------------------------------------- */

START_TEST(nothing_is_background)
{
    const sph2d_picture picture = {.view = {{0.0, 0.0}, {1.0, 1.0}}};
    for (sph2d_style style = SPH2D_STYLE_METABALLS; style <= SPH2D_STYLE_POINTS; ++style) {
        sph2d_renderer *renderer = make_renderer(NULL, 90, 40, style);
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

/* What is lighter is the domain, whatever part of the plane is seen; the strip below never is. */
START_TEST(background_is_that_of_the_domain)
{
    static const struct {
        sph2d_box view, inside;
        int from, to; /* lighter columns */
    } cases[] = {
        {{{0.0, 0.0}, {1.0, 1.0}}, {{-9.0, -9.0}, {9.0, 9.0}}, 0, 90}, /* of another shape than the picture */
        {{{0.0, 0.0}, {2.25, 1.0}}, {{0.0, -9.0}, {0.75, 9.0}}, 0, 30},
        {{{0.0, 0.0}, {2.25, 1.0}}, {{3.0, -9.0}, {4.0, 9.0}}, 90, 90},
        {{{0.0, 0.0}, {2.25, 1.0}}, {{0.0, 0.0}, {0.0, 0.0}}, 0, 90}, /* none is told: the view */
    };
    sph2d_renderer *renderer = make_renderer(NULL, 90, 40, SPH2D_STYLE_POINTS);
    for (size_t k = 0; k < sizeof cases / sizeof *cases; ++k) {
        const sph2d_picture picture = {.view = cases[k].view, .inside = cases[k].inside};
        const unsigned char *pixels = draw(renderer, &picture);
        for (int i = 0; i < 90 * 40; ++i) {
            const bool lighter = i % 90 >= cases[k].from && i % 90 < cases[k].to;
            ck_assert_msg((pixels[4 * i] > 240) == lighter, "case %zu, column %d", k, i % 90);
        }
    }
    sph2d_renderer_destroy(renderer);
    renderer = make_renderer(NULL, 640, 360, SPH2D_STYLE_POINTS);
    const sph2d_picture picture = {
        .view = {{0.0, 0.0}, {1.0, 1.0}}, .inside = {{-9.0, -9.0}, {9.0, 9.0}}, .caption = "-"};
    const unsigned char *pixels = draw(renderer, &picture);
    ck_assert(pixels[0] > 240 && pixels[4 * (640 * 360 - 1)] < 240);
    sph2d_renderer_destroy(renderer);
}
END_TEST

/* What is written of a text: whether each of its characters has strokes of its own. */
START_TEST(letters_of_europe_are_no_boxes)
{
    const char *at = "\xE2\x98\x83"; /* a snowman */
    const char *box = sph2d__glyph_next(&at).strokes;
    static const char known[] = "ABCabc19~ÀéîÕüßæŒøÅçşğİıŁódźžščőűțąěř"
                                "АБВГДЕЁЖЗИЙКЛМНОПРСТУФХЦЧШЩЪЫЬЭЮЯабвгдеёжзийклмнопрстуфхцчшщъыьэюяїієґўљњђћџѓќ"
                                "ΑΒΓΔΕΖΗΘΙΚΛΜΝΞΟΠΡΣΤΥΦΧΨΩαβγδεζηθικλμνξοπρσςτυφχψωάΈήίόύώϊΐ°±²×–“”";
    for (at = known; *at != '\0';) {
        const char *before = at;
        const sph2d__glyph glyph = sph2d__glyph_next(&at);
        ck_assert_msg(glyph.strokes && glyph.strokes != box, "%s", before);
        ck_assert(glyph.width >= 0 && glyph.width < 7);
        for (const char *s = glyph.strokes; *s != '\0'; ++s) /* pairs of digits, and spaces */
            ck_assert((*s >= '0' && *s <= '9') || *s == ' ');
    }
    ck_assert_ptr_eq(at, known + sizeof known - 1);
    /* What is cut off is nothing, bytes of other encodings are boxes, and neither is read beyond its end. */
    static const char *const cut[] = {"\xC3", "\xE2\x98", "\xF0\x9F\x98"};
    for (int k = 0; k < 3; ++k) {
        at = cut[k];
        ck_assert_ptr_null(sph2d__glyph_next(&at).strokes);
        ck_assert_int_eq(*at, '\0');
    }
    static const char *const wrong[] = {"\x80", "\xFF", "\xC0"};
    for (int k = 0; k < 3; ++k) {
        at = wrong[k];
        ck_assert_str_eq(sph2d__glyph_next(&at).strokes, box);
        ck_assert_int_eq(*at, '\0');
    }
    at = "\xC3x"; /* what follows is seen */
    ck_assert_ptr_null(sph2d__glyph_next(&at).strokes);
    ck_assert_int_eq(*at, 'x');
    /* An accent stands over its letter, higher over a capital. */
    at = "\xC3\xA9\xC3\x89";
    const sph2d__glyph small = sph2d__glyph_next(&at), capital = sph2d__glyph_next(&at);
    ck_assert(small.mark && small.mark == capital.mark && capital.mark_y > small.mark_y);
}
END_TEST

/* A lone ball is seen where r^4 - r^2 + 1/4 > T in units of R, with sqrt T = 1/2 - 1/(4 pi): up to R/(2 sqrt pi). At R
 * of two spacings that circle is as large as the square of a particle. */
START_TEST(lone_ball_has_its_radius)
{
    const double radii[] = {8.0, 25.0, 60.0, 300.0}; /* R [px] */
    const double x = 0.5, y = 0.5;
    sph2d_renderer *renderer = make_renderer(NULL, 400, 400, SPH2D_STYLE_METABALLS);
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
    s->picture.outline_count = 0;
    s->picture.values = NULL;
    s->picture.value_label = NULL;
    sph2d_renderer *renderer = make_renderer(NULL, 1280, 720, SPH2D_STYLE_METABALLS);
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
    sph2d_renderer *renderer = make_renderer(NULL, 40, 40, SPH2D_STYLE_POINTS); /* too small for a colour bar */
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
    sph2d_renderer *renderer = make_renderer(NULL, 640, 360, SPH2D_STYLE_POINTS);
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

/* A wall that reaches under the colour bar is cut off there. */
START_TEST(nothing_is_behind_the_color_bar)
{
    enum { WIDTH = 640, HEIGHT = 360 };
    const double x[] = {0.25, 0.75}, y[] = {0.5, 0.5}, values[] = {1.0, 2.0};
    const double wall_x[] = {0.0, 4.0}, wall_y[] = {0.9, 0.9}; /* beyond the right edge of the image */
    const uint64_t outline[2] = {0}, liquid[2] = {SPH2D_OUTLINE_LIQUID_BOTH};
    sph2d_picture picture = {.view = {{0.0, 0.0}, {1.6, 1.0}},
                             .radius = 0.01,
                             .count = 2,
                             .x = x,
                             .y = y,
                             .values = values,
                             .value_label = "speed [m/s]",
                             .outline_x = wall_x,
                             .outline_y = wall_y,
                             .outline_id = outline,
                             .outline_liquid = liquid,
                             .wall_thickness = 0.04};
    sph2d_renderer *renderer = make_renderer(NULL, WIDTH, HEIGHT, SPH2D_STYLE_POINTS);
    static unsigned char without[4 * WIDTH * HEIGHT];
    memcpy(without, draw(renderer, &picture), sizeof without);
    picture.outline_count = 2;
    const unsigned char *pixels = draw(renderer, &picture);
    unsigned last = 0; /* column that the wall changes */
    for (unsigned k = 0; k < WIDTH * HEIGHT; ++k)
        if (memcmp(pixels + 4 * (size_t)k, without + 4 * (size_t)k, 4) != 0 && k % WIDTH > last)
            last = k % WIDTH;
    ck_assert_uint_gt(last, WIDTH / 2);
    ck_assert_uint_lt(last, WIDTH * 9 / 10);
    picture.values = NULL; /* no bar, and the wall goes on */
    picture.value_label = NULL;
    pixels = draw(renderer, &picture) + 4 * (WIDTH - 1);
    bool reaches = false;
    for (unsigned row = 0; row < HEIGHT; ++row)
        reaches |= pixels[(size_t)row * 4 * WIDTH] < 120;
    ck_assert(reaches);
    sph2d_renderer_destroy(renderer);
}
END_TEST

START_TEST(not_finite_is_left_out)
{
    for (sph2d_style style = SPH2D_STYLE_METABALLS; style <= SPH2D_STYLE_POINTS; ++style) {
        splash *s = make_splash(0.0);
        s->picture.value_max = 100.0;
        s->picture.count = FLUID - 1; /* without the drop */
        s->picture.outline_count = CORNERS - 2;
        unsigned char *without = draw_alone(NULL, 320, 180, style, &s->picture);
        const double others[] = {NAN, INFINITY, -INFINITY, 1.0e300, -1.0e300};
        s->picture.count = FLUID;
        s->picture.outline_count = CORNERS;
        sph2d_renderer *renderer = make_renderer(NULL, 320, 180, style);
        for (int i = 0; i < 5; ++i) {
            s->x[FLUID - 1] = others[i];
            s->wall_y[CORNERS - 1] = others[i];
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
            sph2d_renderer *a = make_renderer(ways[w], 320, 180, style),
                           *b = a != NULL ? make_renderer(ways[w], 64, 48, style) : NULL;
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

Suite *suite_drawing(void)
{
    Suite *suite = suite_create("drawing");
    TCase *drawing = tcase_create("drawing");
    tcase_add_test(drawing, nothing_is_background);
    tcase_add_test(drawing, background_is_that_of_the_domain);
    tcase_add_test(drawing, letters_of_europe_are_no_boxes);
    tcase_add_test(drawing, lone_ball_has_its_radius);
    tcase_add_test(drawing, water_covers_its_area);
    tcase_add_test(drawing, points_show_values);
    tcase_add_test(drawing, color_bar_takes_any_numbers);
    tcase_add_test(drawing, nothing_is_behind_the_color_bar);
    tcase_add_test(drawing, not_finite_is_left_out);
    tcase_add_test(drawing, far_from_the_origin_looks_the_same);
    tcase_add_test(drawing, any_size_works);
    tcase_add_test(drawing, same_pixels_every_time);
    tcase_add_test(drawing, any_number_of_threads_draws_the_same);
    suite_add_tcase(suite, drawing);
    return suite;
}
