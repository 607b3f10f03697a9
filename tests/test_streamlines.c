/* SPDX-License-Identifier: MIT */
/** @file test_streamlines.c
 *  Streamlines: circles in a rotation, straight lines in a stream, evenly spaced, all over the liquid, up to its surface and
 *  walls; heads along the velocity; the same lines every time; nonsense is refused or harmless. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "render/lines.h"
#include "render/walls.h"
#include "sph2d/field.h"
#include "sph2d/render.h"
#include "splash.h"

/* A tank of 1.28 m x 0.72 m, all of it liquid at 500 pixels a metre. */
enum { ACROSS = 128, UP = 72, COUNT = ACROSS * UP, WIDTH = 640, HEIGHT = 360 };
static const double dx = 0.01, distance = 0.03;
static double x[COUNT], y[COUNT], vx[COUNT], vy[COUNT];
static sph2d_picture picture;
static sph2d__lines lines;
static sph2d__cover walls;
static sph2d__view view;

static void fill(void)
{
    for (int i = 0; i < COUNT; ++i) {
        x[i] = (i % ACROSS + 0.5) * dx + 0.002 * sin(7.0 * i);
        y[i] = (i / ACROSS + 0.5) * dx + 0.002 * cos(11.0 * i); /* NOLINT: whole rows */
        vx[i] = 1.2;
        vy[i] = 0.5;
    }
    picture = (sph2d_picture){.view = {{0, 0}, {1.28, 0.72}},
                              .radius = 0.02,
                              .spacing = dx,
                              .count = COUNT,
                              .x = x,
                              .y = y,
                              .stream_vx = vx,
                              .stream_vy = vy,
                              .streamline_spacing = distance};
    ck_assert(sph2d__view_fit(&view, picture.view, WIDTH, HEIGHT, 0, 0));
    ck_assert(sph2d__cover_create(&walls, WIDTH, HEIGHT));
    sph2d__cover_clear(&walls, WIDTH, HEIGHT);
    lines = (sph2d__lines){0};
}

static void finish(void)
{
    free(lines.pieces);
    sph2d__sampled_free(&lines.sampled);
    sph2d__cover_destroy(&walls);
}

static void turn(double rate)
{
    for (int i = 0; i < COUNT; ++i) {
        vx[i] = -rate * (y[i] - 0.36);
        vy[i] = rate * (x[i] - 0.64);
    }
}

static void find(void)
{
    lines.count = 0;
    sph2d__streamlines_find(&lines, &view, &picture, &walls);
    ck_assert(!lines.failed);
}

static sph2d_vec2 place(sph2d_vec2 pixel)
{
    return sph2d__view_locate(&view, pixel.x, pixel.y);
}

static bool is_head(const sph2d__piece *p)
{
    return p->wider > 0.0;
}

/** Calls for every line with its pieces, which follow each other, at most in two parts from one beginning. */
static int each_line(void (*check)(const sph2d__piece *pieces, size_t count))
{
    int count = 0;
    for (size_t from = 0, to; from < lines.count; from = to) {
        for (to = from; to < lines.count && !is_head(&lines.pieces[to]); ++to)
            continue;
        check(lines.pieces + from, to - from);
        ++count;
        for (; to < lines.count && is_head(&lines.pieces[to]); ++to)
            continue;
    }
    return count;
}

static double radius_of(sph2d_vec2 pixel)
{
    const sph2d_vec2 at = place(pixel);
    return hypot(at.x - 0.64, at.y - 0.36);
}

static int closed;
static double radii[400];

/** All of a circle has one radius, within a twentieth of the spacing of particles; inside the tank it is closed. */
static void check_circle(const sph2d__piece *pieces, size_t count)
{
    const double radius = radius_of(pieces[0].from);
    for (size_t k = 0; k < count; ++k)
        ck_assert_double_eq_tol(radius_of(pieces[k].to), radius, 0.05 * dx);
    const sph2d_vec2 begin = pieces[0].from, end = pieces[count - 1].to;
    const bool is_closed = hypot(begin.x - end.x, begin.y - end.y) < 1e-9;
    ck_assert_msg(is_closed == (radius < 0.355) || (radius >= 0.34 && radius < 0.36), "radius %g", radius);
    if (is_closed)
        radii[closed++] = radius;
}

static int compare(const void *a, const void *b)
{
    const double p = *(const double *)a, q = *(const double *)b;
    return p < q ? -1 : p > q;
}

START_TEST(a_rotation_has_circles)
{
    turn(_i == 0 ? 2.0 : -0.1);
    find();
    closed = 0;
    ck_assert_int_gt(each_line(check_circle), 11);
    ck_assert_int_ge(closed, 10);
    ck_assert_int_le(closed, 12);
    qsort(radii, (size_t)closed, sizeof *radii, compare);
    for (int k = 1; k < closed; ++k) {
        ck_assert_double_gt(radii[k] - radii[k - 1], 0.98 * distance);
        ck_assert_double_lt(radii[k] - radii[k - 1], 1.5 * distance);
    }
    for (size_t k = 0; k < lines.count; ++k) { /* heads turn as the liquid does */
        const sph2d__piece *p = &lines.pieces[k];
        const sph2d_vec2 from = place(p->from), to = place(p->to);
        const double turns = (from.x - 0.64) * (to.y - 0.36) - (from.y - 0.36) * (to.x - 0.64);
        ck_assert(!is_head(p) || (turns > 0.0) == (_i == 0));
    }
}
END_TEST

static double offsets[400], lengths[400];
static int found;

/** Of a line along (12, 5)/13. */
static void check_straight(const sph2d__piece *pieces, size_t count)
{
    const sph2d_vec2 begin = place(pieces[0].from);
    offsets[found] = (12.0 * begin.y - 5.0 * begin.x) / 13.0;
    lengths[found] = 0.0;
    for (size_t k = 0; k < count; ++k) {
        const sph2d_vec2 from = place(pieces[k].from), to = place(pieces[k].to);
        ck_assert_double_eq_tol((12.0 * to.y - 5.0 * to.x) / 13.0, offsets[found], 1e-9);
        lengths[found] += hypot(to.x - from.x, to.y - from.y);
    }
    ++found;
}

START_TEST(a_stream_has_straight_lines_at_one_distance)
{
    find();
    found = 0;
    each_line(check_straight);
    ck_assert_int_gt(found, 30);
    double total = 0.0;
    for (int k = 0; k < found; ++k)
        total += lengths[k];
    ck_assert_double_eq_tol(total, 1.28 * 0.72 / distance, 0.06 * 1.28 * 0.72 / distance); /* all over the tank */
    qsort(offsets, (size_t)found, sizeof *offsets, compare);
    int even = 0;
    for (int k = 1; k < found; ++k)
        even += fabs(offsets[k] - offsets[k - 1] - distance) < 1e-6;
    ck_assert_int_ge(even, found - 4); /* others are in corners */
    int heads = 0;
    for (size_t k = 0; k < lines.count; ++k) {
        const sph2d__piece *p = &lines.pieces[k];
        heads += is_head(p);
        ck_assert(!is_head(p) || 12.0 * (p->to.x - p->from.x) - 5.0 * (p->to.y - p->from.y) > 0.0);
    }
    ck_assert_int_ge(heads, found);
}
END_TEST

/** Without a distance it is a 40th of the side of a square as large as the view; pixels set a limit to small ones. */
START_TEST(distances_have_defaults_and_limits)
{
    const double given[] = {0.0, 1e-9, DBL_MIN}, wanted[] = {0.024, 6.0 / 500.0, 6.0 / 500.0};
    for (int i = 0; i < 3; ++i) {
        picture.streamline_spacing = given[i];
        find();
        found = 0;
        each_line(check_straight);
        qsort(offsets, (size_t)found, sizeof *offsets, compare);
        ck_assert_double_eq_tol(offsets[found / 2] - offsets[found / 2 - 1], wanted[i], 1e-6);
    }
    picture.streamline_spacing = DBL_MAX;
    find();
    picture.streamline_spacing = 0.3;
    find();
    ck_assert_uint_gt(lines.count, 0);
}
END_TEST

/** Liquid in a box of the tank: lines end within two spacings of its surface, and none goes beyond. */
START_TEST(lines_end_at_the_surface)
{
    size_t kept = 0;
    for (int i = 0; i < COUNT; ++i)
        if (x[i] > 0.3 && x[i] < 0.9 && y[i] > 0.2 && y[i] < 0.5) {
            x[kept] = x[i];
            y[kept++] = y[i];
        }
    for (int i = 0; i < COUNT; ++i)
        vy[i] = 0.0;
    picture.count = kept;
    find();
    ck_assert_uint_gt(lines.count, 100);
    double left = HUGE_VAL, right = -HUGE_VAL, lower = HUGE_VAL, upper = -HUGE_VAL;
    for (size_t k = 0; k < lines.count; ++k) {
        const sph2d_vec2 at = place(lines.pieces[k].to);
        left = fmin(left, at.x);
        right = fmax(right, at.x);
        lower = fmin(lower, at.y);
        upper = fmax(upper, at.y);
    }
    ck_assert(left > 0.295 && left < 0.32 && right < 0.905 && right > 0.88);
    ck_assert(lower > 0.195 && lower < 0.2 + 1.3 * distance && upper < 0.505 && upper > 0.5 - 1.3 * distance);
}
END_TEST

/** A thin wall across a stream, which particles on both sides do not show: nothing crosses it. */
START_TEST(lines_end_at_walls)
{
    const double wall_x[] = {0.64, 0.64}, wall_y[] = {0.0, 0.72};
    const uint64_t id[2] = {0}, liquid[2] = {SPH2D_OUTLINE_LIQUID_BOTH, SPH2D_OUTLINE_LIQUID_BOTH};
    int crossing[2] = {0}, near = 0;
    for (int with = 0; with < 2; ++with) {
        if (with == 1) {
            picture.outline_count = 2;
            picture.outline_x = wall_x;
            picture.outline_y = wall_y;
            picture.outline_id = id;
            picture.outline_liquid = liquid;
            sph2d__walls_cover(&walls, &view, &picture, 0.0);
        }
        find();
        for (size_t k = 0; k < lines.count; ++k) {
            const sph2d__piece *p = &lines.pieces[k];
            crossing[with] += !is_head(p) && (place(p->from).x < 0.64) != (place(p->to).x < 0.64);
            near += with == 1 && place(p->to).x < 0.64 && place(p->to).x > 0.63;
        }
    }
    ck_assert_int_gt(crossing[0], 15);
    ck_assert_int_eq(crossing[1], 0);
    ck_assert_int_gt(near, 15);
}
END_TEST

START_TEST(liquid_at_rest_has_no_lines)
{
    memset(vx, 0, sizeof vx);
    memset(vy, 0, sizeof vy);
    find();
    ck_assert_uint_eq(lines.count, 0);
    for (int i = 0; i < COUNT; ++i)
        vx[i] = x[i] < 0.64 ? 1.0 : 0.001; /* creeping beside a stream */
    find();
    for (size_t k = 0; k < lines.count; ++k)
        ck_assert(place(lines.pieces[k].to).x < 0.68);
    ck_assert_uint_gt(lines.count, 100);
    picture.arrow_speed = 2000.0;
    find();
    ck_assert_uint_eq(lines.count, 0);
}
END_TEST

/** The lines of two vortices: none nearer to another one than half their distance, and no hole wider than three. */
START_TEST(lines_are_all_over_the_liquid)
{
    for (int i = 0; i < COUNT; ++i) {
        vx[i] = sin(9.82 * x[i]) * cos(8.73 * y[i]); /* 2 pi/1.28/2, pi/0.72 */
        vy[i] = -9.82 / 8.73 * cos(9.82 * x[i]) * sin(8.73 * y[i]);
    }
    find();
    const sph2d_vec2 last = lines.pieces[lines.count - 1].to;
    const size_t count = lines.count;
    int holes = 0;
    for (int row = 2; row < 34; ++row)
        for (int column = 2; column < 62; ++column) {
            double nearest = HUGE_VAL;
            for (size_t k = 0; k < count; ++k) {
                const sph2d_vec2 at = place(lines.pieces[k].to);
                nearest = fmin(nearest, hypot(at.x - 0.02 * column, at.y - 0.02 * row));
            }
            holes += nearest > 1.5 * distance;
        }
    ck_assert_int_eq(holes, 0);
    find(); /* the same again */
    ck_assert_uint_eq(lines.count, count);
    ck_assert(lines.pieces[count - 1].to.x == last.x && lines.pieces[count - 1].to.y == last.y);
}
END_TEST

static sph2d_renderer *make(sph2d_look look)
{
    sph2d_render_options options = sph2d_render_options_default();
    options.width = WIDTH;
    options.height = HEIGHT;
    options.look = look;
    sph2d_renderer *renderer = NULL;
    ck_assert_int_eq(sph2d_renderer_create(&options, &renderer, NULL), SPH2D_OK);
    return renderer;
}

static int count_dark(const unsigned char *pixels)
{
    int count = 0;
    for (int k = 0; k < WIDTH * HEIGHT; ++k)
        count += pixels[4 * k] < 70 && pixels[4 * k + 1] < 70 && pixels[4 * k + 2] < 70;
    return count;
}

/** Dark lines on every look, which arrows and isolines add to. */
START_TEST(lines_are_seen_on_every_look)
{
    sph2d_renderer *renderer = make((sph2d_look)_i);
    sph2d_picture plain = picture, more = picture;
    plain.stream_vx = plain.stream_vy = NULL;
    const int before = count_dark(draw(renderer, &plain)), with = count_dark(draw(renderer, &picture));
    ck_assert_int_gt(with - before, 8000); /* of 15,000 pixels of lines, the dark middle */
    more.vx = vx;
    more.vy = vy;
    const int arrows = count_dark(draw(renderer, &more));
    ck_assert_int_gt(arrows - with, 1000);
    more.level_values = x;
    ck_assert_int_gt(count_dark(draw(renderer, &more)) - arrows, 500);
    more.count = 0;
    draw(renderer, &more);
    sph2d_renderer_destroy(renderer);
}
END_TEST

START_TEST(nonsense_is_refused_or_left_out)
{
    sph2d_renderer *renderer = make(SPH2D_LOOK_FLAT);
    sph2d_picture bad[7];
    for (int k = 0; k < 7; ++k)
        bad[k] = picture;
    bad[0].stream_vy = NULL;
    bad[1].stream_vx = NULL;
    bad[2].spacing = 0.0;
    bad[3].spacing = NAN;
    bad[4].streamline_spacing = -1.0;
    bad[5].streamline_spacing = NAN;
    bad[6].streamline_spacing = INFINITY;
    static const char *const words[] = {"component",          "component",          "streamlines",       "streamlines",
                                        "streamline_spacing", "streamline_spacing", "streamline_spacing"};
    for (int k = 0; k < 7; ++k) {
        sph2d_report report = {0};
        ck_assert_int_eq(sph2d_renderer_draw(renderer, &bad[k], &report), SPH2D_INVALID);
        ck_assert_uint_eq(report.errors, 1);
        ck_assert_msg(strstr(report.items[0].message, words[k]), "%s", report.items[0].message);
        sph2d_report_clear(&report);
    }
    const double odd[] = {NAN, INFINITY, -INFINITY, DBL_MAX, -DBL_MAX, DBL_MIN};
    for (int k = 0; k < 6; ++k) {
        x[100] = vx[2000] = vy[3000] = odd[k];
        picture.arrow_speed = k == 2 ? DBL_MIN : k == 3 ? DBL_MAX : 0.0;
        picture.streamline_spacing = k == 1 ? 1e-300 : k == 4 ? 1e300 : 0.0;
        draw(renderer, &picture);
    }
    sph2d_renderer_destroy(renderer);
}
END_TEST

Suite *suite_streamlines(void)
{
    Suite *suite = suite_create("streamlines");
    TCase *cases = tcase_create("streamlines");
    tcase_add_checked_fixture(cases, fill, finish);
    tcase_add_loop_test(cases, a_rotation_has_circles, 0, 2);
    tcase_add_test(cases, a_stream_has_straight_lines_at_one_distance);
    tcase_add_test(cases, distances_have_defaults_and_limits);
    tcase_add_test(cases, lines_end_at_the_surface);
    tcase_add_test(cases, lines_end_at_walls);
    tcase_add_test(cases, liquid_at_rest_has_no_lines);
    tcase_add_test(cases, lines_are_all_over_the_liquid);
    tcase_add_loop_test(cases, lines_are_seen_on_every_look, 0, SPH2D_LOOK_INK + 1);
    tcase_add_test(cases, nonsense_is_refused_or_left_out);
    suite_add_tcase(suite, cases);
    return suite;
}
