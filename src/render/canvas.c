/* SPDX-License-Identifier: MIT */
/** @file canvas.c
 *  Draws the strokes of glyphs as lines with round ends and smooth edges. */
#include "render/canvas.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

enum { BASELINE = 2, GAP = 2, SPACE = 3 }; /* grid units */
static const double half_line = 0.42;      /* half the width of a line, grid units */

/* Lays a color over a pixel, whose colours are not multiplied by its alpha. */
static void blend(const sph2d__canvas *canvas, int x, int y, sph2d__ink ink, double cover)
{
    static const sph2d__ink light = {250, 251, 252, 1.0};
    unsigned char *pixel = canvas->pixels + 4 * ((size_t)y * (size_t)canvas->width + (size_t)x);
    if (canvas->halo > 0.0)
        ink = light;
    const unsigned char color[3] = {ink.red, ink.green, ink.blue};
    const double over = ink.opacity * cover, alpha = pixel[3] + (255 - pixel[3]) * over;
    const double part = pixel[3] == 255 ? over : alpha > 0.0 ? 255.0 * over / alpha : 0.0;
    for (int c = 0; c < 3; ++c)
        pixel[c] = (unsigned char)lrint(pixel[c] + (color[c] - pixel[c]) * part);
    pixel[3] = (unsigned char)lrint(alpha);
}

double sph2d__canvas_unit(int width, int height)
{
    return fmax(1.1, (width < height ? width : height) / 400.0);
}

void sph2d__canvas_fill(const sph2d__canvas *canvas, int x, int y, int width, int height, sph2d__ink ink)
{
    const int wider = (int)lrint(canvas->halo);
    x -= wider;
    y -= wider;
    width += 2 * wider;
    height += 2 * wider;
    for (int row = y > 0 ? y : 0; row < y + height && row < canvas->height; ++row)
        for (int column = x > 0 ? x : 0; column < x + width && column < canvas->width; ++column)
            blend(canvas, column, row, ink, 1.0);
}

/* Square of the distance of a point from the line between two points. */
static double segment_square(double x, double y, const double from[2], const double to[2])
{
    const double dx = to[0] - from[0], dy = to[1] - from[1], square = dx * dx + dy * dy;
    const double along = square > 0.0 ? ((x - from[0]) * dx + (y - from[1]) * dy) / square : 0.0;
    const double t = along < 0.0 ? 0.0 : (along < 1.0 ? along : 1.0);
    const double right = x - from[0] - t * dx, up = y - from[1] - t * dy;
    return right * right + up * up;
}

void sph2d__canvas_line(const sph2d__canvas *canvas, const double from[2], const double to[2], double half,
                        sph2d__ink ink)
{
    half += canvas->halo;
    const double reach = half + 1.0;
    const int left = (int)fmax(floor(fmin(from[0], to[0]) - reach), 0.0);
    const int right = (int)fmin(ceil(fmax(from[0], to[0]) + reach), canvas->width);
    const int top = (int)fmax(floor(fmin(from[1], to[1]) - reach), 0.0);
    const int bottom = (int)fmin(ceil(fmax(from[1], to[1]) + reach), canvas->height);
    for (int row = top; row < bottom; ++row)
        for (int column = left; column < right; ++column) {
            const double cover = half + 0.5 - sqrt(segment_square(column + 0.5, row + 0.5, from, to));
            if (cover > 0.0)
                blend(canvas, column, row, ink, fmin(cover, 1.0));
        }
}

/* Distance of a point from the strokes of a glyph, grid units. */
static double glyph_distance(const char *glyph, double x, double y)
{
    double nearest = HUGE_VAL, last[2] = {0};
    int pen_down = 0;
    while (*glyph != '\0') {
        if (*glyph == ' ') {
            pen_down = 0;
            ++glyph;
            continue;
        }
        const double point[2] = {glyph[0] - '0', glyph[1] - '0'};
        const double square = segment_square(x, y, pen_down ? last : point, point);
        nearest = square < nearest ? square : nearest;
        memcpy(last, point, sizeof last);
        pen_down = 1;
        glyph += 2;
    }
    return sqrt(nearest);
}

/* Draws strokes whose grid's origin is at (x, y) [px]. */
static void draw_strokes(const sph2d__canvas *canvas, double x, double y, double unit, const char *strokes,
                         sph2d__ink ink)
{
    const int wider = 1 + (int)ceil(canvas->halo);
    const int left = (int)floor(x - unit) - wider, right = (int)ceil(x + 6.0 * unit) + wider;
    const int top = (int)floor(y - 10.0 * unit) - wider, bottom = (int)ceil(y + unit) + wider;
    for (int row = top > 0 ? top : 0; row < bottom && row < canvas->height; ++row)
        for (int column = left > 0 ? left : 0; column < right && column < canvas->width; ++column) {
            const double distance = glyph_distance(strokes, (column + 0.5 - x) / unit, (y - row - 0.5) / unit);
            const double cover = (half_line - distance) * unit + 0.5 + canvas->halo;
            if (cover > 0.0)
                blend(canvas, column, row, ink, fmin(cover, 1.0));
        }
}

static double advance(const sph2d__glyph *glyph)
{
    return glyph->strokes ? glyph->width + GAP : 0.0;
}

void sph2d__canvas_text(const sph2d__canvas *canvas, double x, double y, double unit, const char *text, sph2d__ink ink)
{
    y += BASELINE * unit;
    while (*text != '\0') {
        if (*text == ' ') {
            x += SPACE * unit;
            ++text;
            continue;
        }
        const sph2d__glyph glyph = sph2d__glyph_next(&text);
        if (glyph.strokes)
            draw_strokes(canvas, x + glyph.x * unit, y, unit, glyph.strokes, ink);
        if (glyph.mark)
            draw_strokes(canvas, x + glyph.mark_x * unit, y - glyph.mark_y * unit, unit, glyph.mark, ink);
        x += advance(&glyph) * unit;
    }
}

double sph2d__canvas_text_width(double unit, const char *text)
{
    double width = 0.0;
    while (*text != '\0') {
        if (*text == ' ') {
            width += SPACE;
            ++text;
            continue;
        }
        const sph2d__glyph glyph = sph2d__glyph_next(&text);
        width += advance(&glyph);
    }
    return width > GAP ? (width - GAP) * unit : 0.0;
}
