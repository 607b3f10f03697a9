/* SPDX-License-Identifier: MIT */
/** @file svg_shape.c
 *  Attributes of elements: lengths, transforms, and the path that each basic shape is equivalent to
 *  (https://www.w3.org/TR/SVG2/shapes.html). */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/pi.h"
#include "files/svg.h"

const char *sph2d__svg_attribute(const char *const *attributes, const char *name)
{
    for (; *attributes; attributes += 2)
        if (strcmp(attributes[0], name) == 0)
            return attributes[1];
    return NULL;
}

bool sph2d__svg_length(const char *text, double *length)
{
    static const struct {
        const char *name;
        double size;
    } units[] = {{"", 1},           {"px", 1},         {"mm", 96 / 25.4}, {"cm", 96 / 2.54},
                 {"Q", 96 / 101.6}, {"pt", 96.0 / 72}, {"pc", 16},        {"in", 96}};
    text += strspn(text, " \t\n\r");
    if (!sph2d__svg_number(&text, length))
        return false;
    text += strspn(text, " \t\n\r");
    const size_t end = strcspn(text, " \t\n\r");
    for (size_t i = 0; i < sizeof units / sizeof units[0]; ++i)
        if (strlen(units[i].name) == end && memcmp(units[i].name, text, end) == 0) {
            *length *= units[i].size;
            return text[end + strspn(text + end, " \t\n\r")] == '\0';
        }
    return false;
}

/* ---- transforms -------------------------------------------------------------------------------------------------- */

static sph2d__affine turned(double degrees)
{
    const double c = cos(degrees * SPH2D__PI / 180), s = sin(degrees * SPH2D__PI / 180);
    return (sph2d__affine){c, s, -s, c, 0, 0};
}

static sph2d__affine moved(double x, double y)
{
    return (sph2d__affine){1, 0, 0, 1, x, y};
}

/** The map of one function with `count` arguments `v`. False if there is none. */
static bool function_of(const char *name, size_t length, const double v[6], size_t count, sph2d__affine *map)
{
    static const char *const names[] = {"matrix", "translate", "scale", "rotate", "skewX", "skewY"};
    size_t which = 0;
    while (which < 6 && (strlen(names[which]) != length || memcmp(names[which], name, length) != 0))
        ++which;
    *map = moved(0, 0);
    if (which == 0 && count == 6)
        *map = (sph2d__affine){v[0], v[1], v[2], v[3], v[4], v[5]};
    else if (which == 1 && (count == 1 || count == 2))
        *map = moved(v[0], v[1]);
    else if (which == 2 && (count == 1 || count == 2))
        *map = (sph2d__affine){v[0], 0, 0, count == 1 ? v[0] : v[1], 0, 0};
    else if (which == 3 && (count == 1 || count == 3))
        *map = sph2d__affine_of(sph2d__affine_of(moved(v[1], v[2]), turned(v[0])), moved(-v[1], -v[2]));
    else if (which == 4 && count == 1)
        map->c = tan(v[0] * SPH2D__PI / 180);
    else if (which == 5 && count == 1)
        map->b = tan(v[0] * SPH2D__PI / 180);
    else
        return false;
    return true;
}

bool sph2d__svg_transform(const char *text, sph2d__affine *map)
{
    *map = moved(0, 0);
    while (sph2d__svg_skip(&text), *text != '\0' && strcmp(text, "none") != 0) {
        const char *name = text;
        const size_t length = strspn(name, "abcdefghijklmnopqrstuvwxyzXY");
        double v[6] = {0};
        size_t count = 0;
        sph2d__affine one;
        text += length + strspn(text + length, " \t\n\r");
        if (*text++ != '(')
            return false;
        while (sph2d__svg_skip(&text), *text != ')')
            if (count == 6 || !sph2d__svg_number(&text, &v[count++]))
                return false;
        ++text;
        if (!function_of(name, length, v, count, &one))
            return false;
        *map = sph2d__affine_of(*map, one);
    }
    return true;
}

/* ---- basic shapes ------------------------------------------------------------------------------------------------ */

/** Reads lengths, which are 0 where they are not given. False if one is relative or none. */
static bool lengths(const char *const *attributes, const char *const names[], size_t count, double *out)
{
    for (size_t i = 0; i < count; ++i) {
        const char *text = sph2d__svg_attribute(attributes, names[i]);
        out[i] = 0;
        if (text && strcmp(text, "auto") != 0 && !sph2d__svg_length(text, &out[i]))
            return false;
    }
    return true;
}

/** An ellipse from its right end on, in two arcs. */
static void write_ellipse(char *out, size_t size, double cx, double cy, double rx, double ry)
{
    snprintf(out, size, "M%.17g %.17gA%.17g %.17g 0 0 1 %.17g %.17gA%.17g %.17g 0 0 1 %.17g %.17gZ", cx + rx, cy, rx,
             ry, cx - rx, cy, rx, ry, cx + rx, cy);
}

/** A rectangle, whose corners are rounded by rx, ry; one that is 0 is as the other. */
static void write_rect(char *out, size_t size, const double v[6])
{
    const double x = v[0], y = v[1], w = v[2], h = v[3];
    const double rx = fmin(v[4] > 0 ? v[4] : v[5], w / 2), ry = fmin(v[5] > 0 ? v[5] : v[4], h / 2);
    if (rx > 0 && ry > 0)
        snprintf(out, size,
                 "M%.17g %.17gH%.17gA%.17g %.17g 0 0 1 %.17g %.17gV%.17gA%.17g %.17g 0 0 1 %.17g %.17gH%.17g"
                 "A%.17g %.17g 0 0 1 %.17g %.17gV%.17gA%.17g %.17g 0 0 1 %.17g %.17gZ",
                 x + rx, y, x + w - rx, rx, ry, x + w, y + ry, y + h - ry, rx, ry, x + w - rx, y + h, x + rx, rx, ry, x,
                 y + h - ry, y + ry, rx, ry, x + rx, y);
    else
        snprintf(out, size, "M%.17g %.17gH%.17gV%.17gH%.17gZ", x, y, x + w, y + h, x);
}

/** The path of a circle, ellipse, rectangle or line, or "" with `*why`. */
static void write_basic(const char *name, const char *const *attributes, char *out, size_t size, const char **why)
{
    static const char *const circle[] = {"cx", "cy", "r"}, *const ellipse[] = {"cx", "cy", "rx", "ry"};
    static const char *const rect[] = {"x", "y", "width", "height", "rx", "ry"};
    static const char *const line[] = {"x1", "y1", "x2", "y2"};
    const bool is_circle = strcmp(name, "circle") == 0, is_ellipse = strcmp(name, "ellipse") == 0;
    const bool is_rect = strcmp(name, "rect") == 0;
    double v[6] = {0};
    out[0] = '\0';
    if (!lengths(attributes,
                 is_circle    ? circle
                 : is_ellipse ? ellipse
                 : is_rect    ? rect
                              : line,
                 is_circle ? 3
                 : is_rect ? 6
                           : 4,
                 v)) {
        *why = "has a length that is none, or a relative one such as 50%";
        return;
    }
    if (is_circle)
        v[3] = v[2];
    if ((is_circle || is_ellipse || is_rect) && !(v[2] > 0 && v[3] > 0))
        *why = "has no size";
    else if (is_circle || is_ellipse)
        write_ellipse(out, size, v[0], v[1], v[2], v[3]);
    else if (is_rect)
        write_rect(out, size, v);
    else
        snprintf(out, size, "M%.17g %.17gL%.17g %.17g", v[0], v[1], v[2], v[3]);
}

bool sph2d__svg_is_outline(const char *name)
{
    static const char *const names[] = {"path", "rect", "circle", "ellipse", "line", "polyline", "polygon"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; ++i)
        if (strcmp(name, names[i]) == 0)
            return true;
    return false;
}

const char *sph2d__svg_path_of(const char *name, const char *const *attributes, sph2d__pool *pool, const char **why)
{
    const bool is_path = strcmp(name, "path") == 0, is_polygon = strcmp(name, "polygon") == 0;
    *why = NULL;
    if (is_path || is_polygon || strcmp(name, "polyline") == 0) {
        const char *text = sph2d__svg_attribute(attributes, is_path ? "d" : "points");
        if (!text) {
            *why = is_path ? "has no path data (d)" : "has no points";
            return NULL;
        }
        if (is_path)
            return sph2d__pool_text(pool, text, strlen(text));
        const size_t size = strlen(text) + sizeof "MZ";
        char *path = sph2d__pool_alloc(pool, size, 1); /* more numbers after M are lines */
        if (path)
            snprintf(path, size, "M%s%s", text, is_polygon ? "Z" : "");
        return path;
    }
    char path[640];
    write_basic(name, attributes, path, sizeof path, why);
    return *why ? NULL : sph2d__pool_text(pool, path, strlen(path));
}
