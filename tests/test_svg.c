/* SPDX-License-Identifier: MIT */
/** @file test_svg.c
 *  Outlines from drawings: path data against points and areas that are known, transforms, basic shapes, the page, and what
 *  is refused. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "common.h"
#include "sph2d/io.h"

/* Scenes are 4 m x 2 m, pages 400 x 200: a unit is 1 cm, and its y is 2 m - y/100. */
static const double SPACING = 0.02;
enum { MOST = 1 << 16 };

static sph2d_report report;
static sph2d_scene_file *file;
static char folder[32];

static void set_up(void)
{
    sph2d_report_clear(&report);
    file = NULL;
    strcpy(folder, "/tmp/sph2d-svg-XXXXXX");
    ck_assert_ptr_nonnull(mkdtemp(folder));
    ck_assert_int_eq(chdir(folder), 0);
}

static void tear_down(void)
{
    sph2d_scene_file_destroy(file);
    remove("d.svg");
    remove("s.yaml");
    ck_assert_int_eq(chdir("/"), 0);
    rmdir(folder);
}

static void write_text(const char *path, const char *text)
{
    ck_assert_int_eq(sph2d_text_write(path, text, strlen(text), NULL), SPH2D_OK);
}

/** Reads an obstacle of that shape in the drawing d.svg. */
static sph2d_status read_scene(const char *shape)
{
    char text[400];
    snprintf(text, sizeof text,
             "domain: {min: [0, 0], max: [4, 2]}\nspacing: %g\nblocks: [{box: {min: [0, 0], max: [0.1, 0.1]}}]\n"
             "obstacles:\n  - svg: %s\n",
             SPACING, shape);
    write_text("s.yaml", text);
    sph2d_report_clear(&report);
    sph2d_scene_file_destroy(file);
    return sph2d_scene_file_read("s.yaml", NULL, 0, &file, &report);
}

/** The obstacle `a` of a page with these elements. */
static const sph2d_shape *shape_of(const char *elements)
{
    static char text[MOST];
    snprintf(text, sizeof text, "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 400 200'>%s</svg>", elements);
    write_text("d.svg", text);
    ck_assert_msg(read_scene("d.svg#a") == SPH2D_OK, "%s\n%s", elements, test_report_text(&report));
    const sph2d_shape *shape = &sph2d_scene_file_scene(file)->obstacles[0].shape;
    ck_assert_ptr_null(shape->svg);
    return shape;
}

/** The same of a path. */
static const sph2d_shape *path_of(const char *data)
{
    static char text[MOST];
    snprintf(text, sizeof text, "<path id='a' d='%s'/>", data);
    return shape_of(text);
}

/** The area to the left of a polygon [m^2]. */
static double area_of(const sph2d_shape *shape)
{
    double twice = 0;
    for (size_t i = 0; i < shape->points.count; ++i) {
        const sph2d_vec2 a = shape->points.items[i], b = shape->points.items[(i + 1) % shape->points.count];
        twice += a.x * b.y - b.x * a.y;
    }
    return twice / 2;
}

/** Compares with corners on the page. */
static void expect_points(const sph2d_shape *shape, sph2d_shape_kind kind, const double (*corners)[2], size_t count,
                          const char *what)
{
    ck_assert_msg(shape->kind == kind, "%s: kind %d", what, (int)shape->kind);
    ck_assert_msg(shape->points.count == count, "%s: %zu points", what, shape->points.count);
    for (size_t i = 0; i < count; ++i) {
        const sph2d_vec2 p = shape->points.items[i];
        const double x = corners[i][0] / 100, y = 2 - corners[i][1] / 100;
        ck_assert_msg(fabs(p.x - x) < 1e-12 && fabs(p.y - y) < 1e-12, "%s: point %zu is (%.15g, %.15g)", what, i, p.x,
                      p.y);
    }
}

/* ---- straight pieces --------------------------------------------------------------------------------------------- */

static const struct {
    const char *data;
    sph2d_shape_kind kind;
    double corners[5][2];
    size_t count;
} straight[] = {
    {"M 100 50 L 200 50 L 200 150 Z", SPH2D_SHAPE_POLYGON, {{100, 50}, {200, 50}, {200, 150}}, 3},
    {"m100,50l100,0l0 100z", SPH2D_SHAPE_POLYGON, {{100, 50}, {200, 50}, {200, 150}}, 3},
    {"M100 50 200 50 200 150Z", SPH2D_SHAPE_POLYGON, {{100, 50}, {200, 50}, {200, 150}}, 3},
    {"m100 50 100 0 0 100 z", SPH2D_SHAPE_POLYGON, {{100, 50}, {200, 50}, {200, 150}}, 3},
    {"M100 50H200V150Z", SPH2D_SHAPE_POLYGON, {{100, 50}, {200, 50}, {200, 150}}, 3},
    {"M100 50h50 50v100z", SPH2D_SHAPE_POLYGON, {{100, 50}, {150, 50}, {200, 50}, {200, 150}}, 4},
    {"M1e2.5l+100-.5e0-1.5+9.5E+0-1.0.5", SPH2D_SHAPE_POLYLINE, {{100, 0.5}, {200, 0}, {198.5, 9.5}, {197.5, 10}}, 4},
    {"M100 50L200 50 200 150 100 50", SPH2D_SHAPE_POLYGON, {{100, 50}, {200, 50}, {200, 150}}, 3}, /* ends meet */
    {"M100 50L200 50 200 50 200 150", SPH2D_SHAPE_POLYLINE, {{100, 50}, {200, 50}, {200, 150}}, 3},
    {"M100 50M10 10 L 20 20 M 30 30", SPH2D_SHAPE_POLYLINE, {{10, 10}, {20, 20}}, 2}, /* a move draws nothing */
    {" M\t100\n50\rL 200 , 50,200,150z ", SPH2D_SHAPE_POLYGON, {{100, 50}, {200, 50}, {200, 150}}, 3},
};

START_TEST(straight_pieces_are_exact)
{
    expect_points(path_of(straight[_i].data), straight[_i].kind, straight[_i].corners, straight[_i].count,
                  straight[_i].data);
}
END_TEST

/* ---- curves ------------------------------------------------------------------------------------------------------ */

/** The largest distance of chords and points from a circle [cm]. */
static double off_circle(const sph2d_shape *shape, double x, double y, double radius)
{
    double off = 0;
    for (size_t i = 0; i + 1 < shape->points.count; ++i) {
        const sph2d_vec2 a = shape->points.items[i], b = shape->points.items[i + 1];
        const double to[2][2] = {{100 * a.x - x, 200 - 100 * a.y - y},
                                 {50 * (a.x + b.x) - x, 200 - 50 * (a.y + b.y) - y}};
        for (int k = 0; k < 2; ++k)
            off = fmax(off, fabs(hypot(to[k][0], to[k][1]) - radius));
    }
    return off;
}

/* A disc of 50 cm in many ways: of arcs, of cubics (2.7e-4 from a circle), of smooth ones. */
static const char *const discs[] = {
    "<path id='a' d='M150 100A50 50 0 0 1 100 150A50 50 0 0 1 50 100A50 50 0 0 1 100 50A50 50 0 0 1 150 100Z'/>",
    "<path id='a' d='M150 100a50 50 0 00-100 0 50 50 0 10100 0z'/>",
    "<path id='a' transform='matrix(50 0 0 50 100 100)' d='M1 0C1 .552.552 1 0 1S-1 .552-1 0-.552-1 0-1 1-.552 1 0'/>",
    "<path id='a' d='M150 100c0 27.614-22.386 50-50 50s-50-22.386-50-50S72.386 50 100 50s50 22.386 50 50z'/>",
    "<circle id='a' cx='100' cy='100' r='50'/>",
    "<circle id='a' cx='1e2px' cy=' 100 ' r='13.229166666666666mm'/>",
    "<ellipse id='a' cx='100' cy='100' rx='50' ry='50'/>",
    "<rect id='a' x='50' y='50' width='100' height='100' rx='50'/>",
    "<rect id='a' x='50' y='50' width='100' height='100' ry='80' rx='90'/>",
    "<ellipse id='a' transform='translate(100 100) rotate(30) scale(5 1)' rx='10' ry='50'/>",
    "<g transform='translate(100,100)'><g transform='scale(-2)'><circle id='a' r='25'/></g></g>",
    "<g transform='matrix(2 0 0 2 0 0)'><circle id='a' cx='50' cy='50' r='25'/></g>",
    "<circle id='a' transform='rotate(90 100 100)' cx='100' cy='100' r='50'/>",
    "<circle id='a' transform='skewX(45)skewX(-45),skewY(20) skewY(-20)' cx='100' cy='100' r='50'/>",
};

START_TEST(discs_are_round)
{
    const sph2d_shape *shape = shape_of(discs[_i]);
    const double off = off_circle(shape, 100, 100, 50);
    const double area = fabs(area_of(shape)) * 1e4, exact = TEST_PI * 50 * 50;
    ck_assert_int_eq((int)shape->kind, SPH2D_SHAPE_POLYGON);
    ck_assert_msg(off < 0.01 * 100 * SPACING + 0.0137, "%s: %g cm off the circle", discs[_i], off);
    ck_assert_msg(fabs(area - exact) < 1e-3 * exact, "%s: %g cm^2, a disc has %g", discs[_i], area, exact);
    ck_assert_uint_lt(shape->points.count, 200);
}
END_TEST

/* By the sweep flag an arc is on either side of its chord, by the other it is the short or the long way. */
START_TEST(arcs_follow_their_flags)
{
    const struct {
        const char *data;
        double x, y, radius;
        double area; /**< between it and its chord, over that of the disc */
    } arcs[] = {
        {"M100 50A50 50 0 0 1 150 100Z", 100, 100, 50, 0.25 - 0.5 / TEST_PI},
        {"M100 50A50 50 0 0 0 150 100Z", 150, 50, 50, 0.25 - 0.5 / TEST_PI},
        {"M100 50A50 50 0 1 1 150 100Z", 150, 50, 50, 0.75 + 0.5 / TEST_PI},
        {"M100 50A50 50 0 1 0 150 100Z", 100, 100, 50, 0.75 + 0.5 / TEST_PI},
        {"M100 50a-50 50 0 0150 50Z", 100, 100, 50, 0.25 - 0.5 / TEST_PI}, /* the sign of a radius does not count */
        {"M100 50A5 5 77 0 1 150 100Z", 125, 75, 25 * sqrt(2), 0.25},      /* one that is too small grows */
    };
    for (size_t i = 0; i < sizeof arcs / sizeof arcs[0]; ++i) {
        const sph2d_shape *shape = path_of(arcs[i].data);
        const double disc = TEST_PI * 50 * 50;
        ck_assert_msg(off_circle(shape, arcs[i].x, arcs[i].y, arcs[i].radius) < 0.0201, "%s", arcs[i].data);
        ck_assert_double_eq_tol(fabs(area_of(shape)) * 1e4, arcs[i].area * disc, 1e-3 * disc);
    }
    /* a radius of 0 is a line */
    static const double line[][2] = {{100, 50}, {150, 100}};
    expect_points(path_of("M100 50A0 50 0 0 1 150 100"), SPH2D_SHAPE_POLYLINE, line, 2, "no radius");
}
END_TEST

/* Areas between curves and their chords: of a parabola 2/3 of the triangle's; of a cubic with control points a, b, c from its
 * first point on, by Green's theorem, |3 a x b + 3 a x c + 6 b x c| / 20. */
START_TEST(curves_have_their_areas)
{
    static const struct {
        const char *data;
        double area; /**< [cm^2] */
    } curves[] = {
        {"M100 100Q150 0 200 100Z", 2.0 / 3 * 5000},
        {"m100 100q50-100 100 0z", 2.0 / 3 * 5000},
        {"M100 100Q150 0 200 100V150H100Z", 2.0 / 3 * 5000 + 5000},
        {"M50 100Q100 50 150 100T250 100V150H50Z", 10000}, /* a hump, and the same one below */
        {"m50 100q50-50 100 0t100 0v50h-200z", 10000},
        {"M50 100T250 100V150H50Z", 10000}, /* with nothing before it: a line */
        {"M100 100C100 0 200 0 200 100Z", (3 + 3 + 6) / 20.0 * 10000},
        {"M50 100C50 50 150 50 150 100S250 150 250 100V180H50Z", 16000},
        {"M50 100c0-50 100-50 100 0s100 50 100 0v80h-200z", 16000},
        {"M100 100S200 0 200 100Z", 6 / 20.0 * 10000},
    };
    for (size_t i = 0; i < sizeof curves / sizeof curves[0]; ++i) {
        const double area = fabs(area_of(path_of(curves[i].data))) * 1e4;
        ck_assert_msg(fabs(area - curves[i].area) < 5, "%s: %.6g cm^2, not %.6g", curves[i].data, area, curves[i].area);
    }
}
END_TEST

/* ---- basic shapes, labels, the page ------------------------------------------------------------------------------ */

static const struct {
    const char *elements;
    sph2d_shape_kind kind;
    double corners[4][2];
    size_t count;
} basic[] = {
    {"<rect id='a' x='50' y='60' width='100' height='20'/>",
     SPH2D_SHAPE_POLYGON,
     {{50, 60}, {150, 60}, {150, 80}, {50, 80}},
     4},
    {"<polygon id='a' points='50,60 150,60 150,80'/>", SPH2D_SHAPE_POLYGON, {{50, 60}, {150, 60}, {150, 80}}, 3},
    {"<polyline id='a' points=' 50 60,150 60 150 80'/>", SPH2D_SHAPE_POLYLINE, {{50, 60}, {150, 60}, {150, 80}}, 3},
    {"<line id='a' x1='50' y1='60' x2='150' y2='0.5in'/>", SPH2D_SHAPE_POLYLINE, {{50, 60}, {150, 48}}, 2},
    {"<g transform='translate(10)'><line id='a' x1='40' y1='60' x2='140' y2='60' transform='scale(1 .5)'/></g>",
     SPH2D_SHAPE_POLYLINE,
     {{50, 30}, {150, 30}},
     2},
    {"<line id='a' x2='10' y2='0' transform='translate(100 100) rotate(90)'/>",
     SPH2D_SHAPE_POLYLINE,
     {{100, 100}, {100, 110}},
     2},
    {"<line id='a' x1='0' y1='10' x2='20' y2='10' transform='translate(100,100)skewX(45)'/>",
     SPH2D_SHAPE_POLYLINE,
     {{110, 110}, {130, 110}},
     2},
    {"<line id='a' x1='10' y1='0' x2='10' y2='20' transform='skewY(-45) translate(100 200)'/>",
     SPH2D_SHAPE_POLYLINE,
     {{110, 90}, {110, 110}},
     2},
    {"<line id='a' x1='1' y1='2' x2='3' y2='4' transform='matrix(1e1,0,1,10,5,6)'/>",
     SPH2D_SHAPE_POLYLINE,
     {{17, 26}, {39, 46}},
     2},
    {"<g xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape'><line x2='9' inkscape:label='a'/></g>",
     SPH2D_SHAPE_POLYLINE,
     {{0, 0}, {9, 0}},
     2},
    {"<g xmlns:i='http://www.inkscape.org/namespaces/inkscape'><line x2='9' i:label='a'/><line id='a' x2='8'/></g>",
     SPH2D_SHAPE_POLYLINE,
     {{0, 0}, {8, 0}},
     2},
    {"<!-- <line id='a'/> --><style><![CDATA[ <line id='a'/> ]]></style><line id=\"&#97;\" x2='9'/>",
     SPH2D_SHAPE_POLYLINE,
     {{0, 0}, {9, 0}},
     2},
    {"<text>a</text><g id='b'><path d='nonsense' transform='none'/></g>"
     "<line id='a' x2='9' style='text-transform:none;transform-origin:5px 5px;fill: none'/>",
     SPH2D_SHAPE_POLYLINE,
     {{0, 0}, {9, 0}},
     2},
};

START_TEST(elements_are_where_they_are_drawn)
{
    expect_points(shape_of(basic[_i].elements), basic[_i].kind, basic[_i].corners, basic[_i].count, basic[_i].elements);
}
END_TEST

/* The lower left corner of the page is that of the domain, and its width the domain's. */
START_TEST(pages_are_as_wide_as_the_domain)
{
    static const struct {
        const char *page;
        double x, y; /**< where (20, 10) is [m] */
    } pages[] = {
        {"viewBox='0 0 400 200'", 0.2, 1.9},
        {"viewBox='0,0,40,20' width='400mm' height='200mm'", 2, 1},
        {"viewBox='10 5 40 20' width='100%'", 1, 1.5},
        {"viewBox='0 0 40 10'", 2, 0},
        {"width='400' height='200px'", 0.2, 1.9},
        {"width='1in' height='36pt'", 80.0 / 96, (48 - 10) * 4 / 96.0},
        {"width='2.54cm' height='3pc' transform='translate(0 0)'", 80.0 / 96, (48 - 10) * 4 / 96.0},
    };
    for (size_t i = 0; i < sizeof pages / sizeof pages[0]; ++i) {
        char text[400];
        snprintf(text, sizeof text,
                 "<?xml version='1.0'?>\n<svg %s>\n<line id='a' x1='20' y1='10' x2='21' y2='10'/></svg>",
                 pages[i].page);
        write_text("d.svg", text);
        ck_assert_msg(read_scene("d.svg#a") == SPH2D_OK, "%s: %s", pages[i].page, test_report_text(&report));
        const sph2d_vec2 p = sph2d_scene_file_scene(file)->obstacles[0].shape.points.items[0];
        ck_assert_msg(fabs(p.x - pages[i].x) < 1e-12 && fabs(p.y - pages[i].y) < 1e-12, "%s: (%g, %g)", pages[i].page,
                      p.x, p.y);
    }
}
END_TEST

/* A block, drain or body is a polygon, also where its path is open. */
START_TEST(every_shape_may_be_drawn)
{
    write_text("d.svg", "<svg viewBox='0 0 400 200'><path id='a' d='M100 100H200V50'/><path id='b' d='M300 50h40v40'/>"
                        "<rect id='c' y='150' width='400' height='50'/></svg>");
    write_text("s.yaml", "domain: {min: [0, 0], max: [4, 2]}\nspacing: 0.02\nblocks: [{svg: d.svg#c}]\n"
                         "drains: [{svg: d.svg#a}]\nbodies: [{svg: d.svg#b, density: 500}]\n");
    ck_assert_msg(sph2d_scene_file_read("s.yaml", NULL, 0, &file, &report) == SPH2D_OK, "%s",
                  test_report_text(&report));
    const sph2d_scene *scene = sph2d_scene_file_scene(file);
    ck_assert_int_eq((int)scene->blocks[0].shape.kind, SPH2D_SHAPE_POLYGON);
    ck_assert_int_eq((int)scene->drains[0].shape.kind, SPH2D_SHAPE_POLYGON);
    ck_assert_int_eq((int)scene->bodies[0].shape.kind, SPH2D_SHAPE_POLYGON);
    ck_assert_double_eq_tol(fabs(area_of(&scene->drains[0].shape)), 0.25, 1e-12);
    /* as text it needs the drawing no more */
    char text[2000];
    ck_assert_uint_lt(sph2d_scene_text(scene, text, sizeof text), sizeof text);
    ck_assert_ptr_null(strstr(text, "svg"));
    ck_assert_ptr_nonnull(strstr(text, "bodies:\n  - polygon: [[3, 1.5], [3.4"));
}
END_TEST

/* ---- what is refused --------------------------------------------------------------------------------------------- */

static const struct {
    const char *elements;
    int line; /**< 0: of the drawing as a whole */
    const char *message;
} refused[] = {
    {"<path id='b' d='M0 0'/><g id='c'/>", 0, "there is no 'a'; there are b"},
    {"<g id='c'/>", 0, "there is no 'a', nor another outline with an id"},
    {"\n<g id='a'><path id='b'/></g>", 2,
     "'a' is no outline, but <g>: name a path, rect, circle, ellipse, line, polyline"},
    {"\n<line id='a'/>\n<line id='a'/>", 2, "'a' is there 2 times"},
    {"\n<path id='a'/>", 2, "'a' has no path data"},
    {"<path id='a' d=''/>", 1, "there is nothing to draw"},
    {"<path id='a' d='M1 1'/>", 1, "there is nothing to draw"},
    {"<path id='a' d='L1 1'/>", 1, "a path must begin with M"},
    {"<path id='a' d='1 1'/>", 1, "a command is missing"},
    {"<path id='a' d='M1 1L9 9Z 5 5'/>", 1, "a command is missing after 'M1 1L9 9Z '"},
    {"\n\n<path id='a' d='M1 1B2'/>", 3, "the path of 'a': 'B' is no command after 'M1 1B'"},
    {"<path id='a' d='M1 1L9'/>", 1, "a number is missing or too large after 'M1 1L9'"},
    {"<path id='a' d='M1 1L9 inf'/>", 1, "a number is missing or too large after 'M1 1L9 '"},
    {"<path id='a' d='M1 1L9 1e999'/>", 1, "a number is missing or too large"},
    {"<path id='a' d='M1 1L0x10 1'/>", 1, "a number is missing"},
    {"<path id='a' d='M1 1L1e300 1e300' transform='scale(1e300)'/>", 1, "a point is too far away"},
    {"<path id='a' d='M1 1A5 5 0 2 0 9 9'/>", 1, "a flag of an arc must be 0 or 1"},
    {"<path id='a' d='M1 1H9V9ZM2 2H5V5Z'/>", 1, "a second part begins"},
    {"<path id='a' d='M1 1H9V9ZL20 20'/>", 1, "a second part begins"},
    {"<path id='a' d='M0 0C1e9 1e9 0 1e9 10 0'/>", 1, "more than 10000 points at this spacing"},
    {"<circle id='a' r='0'/>", 1, "'a' has no size"},
    {"<rect id='a' width='10' height='-1'/>", 1, "'a' has no size"},
    {"<circle id='a' r='10%'/>", 1, "'a' has a length that is none, or a relative one"},
    {"<circle id='a' r='10em'/>", 1, "'a' has a length that is none, or a relative one"},
    {"<polygon id='a'/>", 1, "'a' has no points"},
    {"<g transform='rotate(1 2)'><circle id='a' r='5'/></g>", 1, "has a transform, or is in an element with one"},
    {"<g transform='scale(2'><circle id='a' r='5'/></g>", 1, "has a transform, or is in an element with one"},
    {"<g transform='scale(2)' style='fill:red;transform-origin:5px 5px'><circle id='a' r='5'/></g>", 1,
     "an origin of it"},
    {"<g style='fill:red;; transform : scale(2)'><circle id='a' r='5'/></g>", 1, "give a plain `transform`"},
    {"<symbol><circle id='a' r='5'/></symbol>", 1, "'a' is in an inner svg, symbol, marker or pattern"},
    {"<svg><circle id='a' r='5'/></svg>", 1, "'a' is in an inner svg, symbol, marker or pattern"},
    {"\n<circle id='a' r='5'>", 2, "this is no XML, as a drawing is: mismatched tag"},
    {"<a:b/>", 1, "this is no XML, as a drawing is: unbound prefix"},
};

START_TEST(drawings_are_refused_with_a_place)
{
    char text[1000];
    snprintf(text, sizeof text, "<svg viewBox='0 0 400 200'>%s</svg>", refused[_i].elements);
    write_text("d.svg", text);
    ck_assert_int_eq(read_scene("d.svg#a"), SPH2D_FORMAT);
    ck_assert_ptr_null(file);
    ck_assert_uint_eq(report.errors, 1);
    const sph2d_diagnostic *d = &report.items[0];
    ck_assert_msg(strstr(d->message, refused[_i].message) != NULL, "%s\n%s", text, test_report_text(&report));
    ck_assert_msg(d->line == refused[_i].line && strcmp(d->file, "d.svg") == 0, "%s:%d\n%s", d->file, d->line,
                  test_report_text(&report));
}
END_TEST

START_TEST(files_are_refused_that_are_no_drawings)
{
    static char bomb[MOST];
    char *end = bomb + sprintf(bomb, "<!DOCTYPE svg [<!ENTITY a0 'lol'>");
    for (int i = 1; i < 30; ++i)
        end += sprintf(end, "<!ENTITY a%d '&a%d;&a%d;&a%d;&a%d;'>", i, i - 1, i - 1, i - 1, i - 1);
    sprintf(end, "]><svg viewBox='0 0 4 2'><path id='a' d='&a29;'/></svg>");
    static char deep[MOST];
    end = deep + sprintf(deep, "<svg viewBox='0 0 4 2'>");
    for (int i = 0; i < 5000; ++i)
        end += sprintf(end, "<g>");
    const struct {
        const char *text, *message;
    } files[] = {
        {"", "this is no XML, as a drawing is: no element found"},
        {"\x1f\x8b\x08", "this is no XML, as a drawing is: not well-formed"},
        {"<html/>", "this is XML, but no drawing: its first element is not svg"},
        {"<svg/>", "the page has no size"},
        {"<svg width='100%' height='100%'/>", "the page has no size"},
        {"<svg viewBox='0 0 4'/>", "the viewBox needs four numbers"},
        {"<svg viewBox='0 0 4 0'/>", "the viewBox needs four numbers"},
        {"<svg viewBox='0 0 4 2' width='4mm' height='3mm'/>", "width and height are of another shape than the viewBox"},
        {bomb, "an entity is long or made of others"},
        {deep, "elements are nested too deeply"},
    };
    for (size_t i = 0; i < sizeof files / sizeof files[0]; ++i) {
        write_text("d.svg", files[i].text);
        ck_assert_int_eq(read_scene("d.svg#a"), SPH2D_FORMAT);
        ck_assert_uint_eq(report.errors, 1);
        ck_assert_msg(strstr(report.items[0].message, files[i].message) != NULL, "%s", test_report_text(&report));
    }
    /* short entities are what some editors write */
    write_text("d.svg",
               "<!DOCTYPE svg PUBLIC '-//W3C//DTD SVG 1.1//EN' 'http://www.w3.org/svg11.dtd' [<!ENTITY ns "
               "'http://www.w3.org/2000/svg'>]><svg xmlns='&ns;' viewBox='0 0 4 2'><line id='a' x2='1'/></svg>");
    ck_assert_int_eq(read_scene("d.svg#a"), SPH2D_OK);
    ck_assert_int_eq(read_scene("d.svg"), SPH2D_FORMAT);
    ck_assert_ptr_nonnull(strstr(report.items[0].message, "name an outline in it, FILE.svg#ID; there are a"));
    ck_assert_int_eq(truncate("d.svg", 20 << 20), 0);
    ck_assert_int_eq(read_scene("d.svg#a"), SPH2D_SCENE);
    ck_assert_ptr_nonnull(strstr(report.items[0].message, "too long"));
    remove("d.svg");
    ck_assert_int_eq(read_scene("d.svg#a"), SPH2D_NOINPUT);
    ck_assert_str_eq(report.items[0].path, "obstacles[0].svg");
    ck_assert_int_eq(report.items[0].line, 5);
}
END_TEST

/* What the checks say of a polygon is said of the drawing. */
START_TEST(checks_name_the_drawing)
{
    write_text("d.svg", "<svg viewBox='0 0 400 200'><path id='a' d='M100 100H200L100 150 200 150Z'/>"
                        "<path id='b' d='M100 100H900'/></svg>");
    ck_assert_int_eq(read_scene("d.svg#a"), SPH2D_SCENE);
    ck_assert_str_eq(report.items[0].path, "obstacles[0].svg");
    ck_assert_str_eq(report.items[0].message, "a polygon must not cross or touch itself");
    ck_assert_int_eq(report.items[0].line, 5);
    ck_assert_int_eq(read_scene("d.svg#b"), SPH2D_SCENE);
    ck_assert_uint_eq(report.errors, 1);
    ck_assert_ptr_nonnull(strstr(report.items[0].message, "(9, 1) lies outside the domain"));
    ck_assert_str_eq(report.items[0].path, "obstacles[0].svg");
}
END_TEST

START_TEST(a_scene_without_a_file_has_no_drawing)
{
    static const char text[] = "domain: {min: [0, 0], max: [4, 2]}\nspacing: 0.1\nblocks: [{svg: d.svg#a}]\n"
                               "obstacles: [{svg: d.svg#b}]\n";
    ck_assert_int_eq(sph2d_scene_file_parse(text, strlen(text), "s.yaml", NULL, 0, &file, &report), SPH2D_SCENE);
    ck_assert(test_report_has(&report, SPH2D_CODE_MISSING_KEY, "blocks[0].svg"));
    ck_assert(test_report_has(&report, SPH2D_CODE_MISSING_KEY, "obstacles[0].svg"));
    /* with a fault that keeps it from being read, the fault is said alone */
    write_text("s.yaml", "domain: {min: [0, 0], max: [4, 2]}\nspacing: 0.1\nblocks: [{svg: d.svg#a}]\nnonsense: 1\n");
    sph2d_report_clear(&report);
    ck_assert_int_eq(sph2d_scene_file_read("s.yaml", NULL, 0, &file, &report), SPH2D_SCENE);
    ck_assert_uint_eq(report.errors, 1);
    /* a program's own */
    sph2d_obstacle obstacle = sph2d_obstacle_default();
    sph2d_scene scene = test_scene(0.1, 0, 0, 1, 1);
    sph2d_block block = test_block(0, 0, 0.5, 0.5);
    obstacle.shape.kind = SPH2D_SHAPE_SVG;
    scene.blocks = &block;
    scene.obstacles = &obstacle;
    scene.block_count = scene.obstacle_count = 1;
    char out[1000];
    ck_assert_uint_gt(sph2d_scene_text(&scene, out, sizeof out), 0);
    sph2d_report_clear(&report);
    ck_assert_int_eq(sph2d_scene_check(&scene, &report), SPH2D_SCENE);
    ck_assert(test_report_has(&report, SPH2D_CODE_MISSING_KEY, "obstacles[0].svg"));
}
END_TEST

Suite *suite_svg(void)
{
    Suite *suite = suite_create("svg");
    TCase *tests = tcase_create("svg");
    tcase_add_checked_fixture(tests, set_up, tear_down);
    tcase_add_loop_test(tests, straight_pieces_are_exact, 0, sizeof straight / sizeof straight[0]);
    tcase_add_loop_test(tests, discs_are_round, 0, sizeof discs / sizeof discs[0]);
    tcase_add_test(tests, arcs_follow_their_flags);
    tcase_add_test(tests, curves_have_their_areas);
    tcase_add_loop_test(tests, elements_are_where_they_are_drawn, 0, sizeof basic / sizeof basic[0]);
    tcase_add_test(tests, pages_are_as_wide_as_the_domain);
    tcase_add_test(tests, every_shape_may_be_drawn);
    tcase_add_loop_test(tests, drawings_are_refused_with_a_place, 0, sizeof refused / sizeof refused[0]);
    tcase_add_test(tests, files_are_refused_that_are_no_drawings);
    tcase_add_test(tests, checks_name_the_drawing);
    tcase_add_test(tests, a_scene_without_a_file_has_no_drawing);
    suite_add_tcase(suite, tests);
    return suite;
}
