/* SPDX-License-Identifier: MIT */
/** @file caption.c
 *  Text below the picture, a scale bar, and notes. */
#include "render/caption.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "render/round_number.h"

/* Sizes in units, a sixth of the height of a capital letter each. */
enum { PAD = 6, STRIP = 18, BASE = 12, BAR = 2, TICK = 5, LINE = 11 };
enum { TEXT_SIZE = 160, NUMBER_SIZE = 48 };

/* Part of the image's width that a scale bar has about. */
static const double bar_part = 0.16;

static const sph2d__ink ink = {40, 46, 54, 1.0};

int sph2d__caption_height(int width, int height)
{
    const int strip = (int)ceil(STRIP * sph2d__canvas_unit(width, height));
    return 6 * strip < height ? strip : 0;
}

/* ---- scale bar --------------------------------------------------------------------------------------------------- */

/* A length and its text, "20 mm". */
typedef struct scale_bar {
    double pixels;
    char text[NUMBER_SIZE];
} scale_bar;

static scale_bar make_bar(const sph2d__view *view)
{
    static const struct {
        int exponent;
        const char *name;
    } units[] = {{3, "km"}, {0, "m"}, {-2, "cm"}, {-3, "mm"}, {-6, "um"}};
    const sph2d__round_number length = sph2d__round_nearest(bar_part * view->width / view->scale);
    scale_bar bar = {.pixels = length.factor * pow(10.0, length.exponent) * view->scale};
    size_t k = 0;
    while (k + 1 < sizeof units / sizeof units[0] && length.exponent < units[k].exponent)
        ++k;
    char number[NUMBER_SIZE - 8];
    sph2d__write_number(number, sizeof number, length.factor, length.exponent - units[k].exponent);
    snprintf(bar.text, sizeof bar.text, "%s %s", number, units[k].name);
    return bar;
}

/* Draws the bar with its right end at `right` [px], the text on its left; returns where both begin. */
static double draw_bar(const sph2d__canvas *canvas, const sph2d__view *view, double right, double base, double unit)
{
    const scale_bar bar = make_bar(view);
    const double left = right - bar.pixels, text = left - 4 * unit - sph2d__canvas_text_width(unit, bar.text);
    const int thick = (int)fmax(1.0, round(BAR * unit / 2)), tall = (int)lrint(TICK * unit);
    const int x = (int)lrint(left), width = (int)lrint(bar.pixels), middle = (int)lrint(base - 3 * unit);
    sph2d__canvas_fill(canvas, x, middle - thick / 2, width, thick, ink);
    sph2d__canvas_fill(canvas, x, middle - tall / 2, thick, tall, ink);
    sph2d__canvas_fill(canvas, x + width - thick, middle - tall / 2, thick, tall, ink);
    sph2d__canvas_text(canvas, text, base, unit, bar.text, ink);
    return text;
}

/* ---- lines ------------------------------------------------------------------------------------------------------- */

/* Draws text with its right end at `right` [px]; returns where it begins. */
static double draw_before(const sph2d__canvas *canvas, double right, double base, double unit, const char *text)
{
    const double left = right - sph2d__canvas_text_width(unit, text);
    sph2d__canvas_text(canvas, left, base, unit, text, ink);
    return left;
}

/* Writes a number above 0 with four digits, without the zeros at its end, "0.25". */
static void write_digits(char *text, size_t size, double number)
{
    int exponent = (int)floor(log10(number)) - 3;
    long long digits = llround(number / pow(10.0, exponent));
    for (; digits % 10 == 0; digits /= 10)
        ++exponent;
    sph2d__write_number(text, size, digits, exponent);
}

/* Draws an arrow and its speed, the right end at `right` [px]; returns where both begin. */
static double draw_arrow(const sph2d__canvas *canvas, const sph2d__scales *scales, double right, double base,
                         double unit)
{
    char number[NUMBER_SIZE], text[NUMBER_SIZE + 8];
    write_digits(number, sizeof number, scales->arrow_speed);
    snprintf(text, sizeof text, "%s m/s", number);
    const double left = right - scales->arrow_pixels, y = base - 3 * unit, half = 0.35 * unit;
    const double back = right - 0.3 * scales->arrow_pixels, tall = fmin(0.15 * scales->arrow_pixels, TICK * unit);
    sph2d__canvas_line(canvas, (double[2]){left, y}, (double[2]){right, y}, half, ink);
    sph2d__canvas_line(canvas, (double[2]){right, y}, (double[2]){back, y - tall}, half, ink);
    sph2d__canvas_line(canvas, (double[2]){right, y}, (double[2]){back, y + tall}, half, ink);
    return draw_before(canvas, left - 4 * unit, base, unit, text);
}

/* Writes what isolines are, "Pressures [Pa] every 500". */
static double write_levels(const sph2d__canvas *canvas, const sph2d__scales *scales, double right, double base,
                           double unit, const char *levels)
{
    char number[NUMBER_SIZE], text[TEXT_SIZE];
    write_digits(number, sizeof number, scales->level_step);
    snprintf(text, sizeof text, "%.100s every %s", levels, number);
    return draw_before(canvas, right, base, unit, text);
}

/* ---- strip ------------------------------------------------------------------------------------------------------- */

void sph2d__caption_draw(const sph2d__canvas *canvas, const sph2d__view *view, const char *text,
                         const sph2d__scales *scales, const char *levels)
{
    const double unit = sph2d__canvas_unit(canvas->width, canvas->height);
    const int strip = sph2d__caption_height(canvas->width, canvas->height);
    if (strip == 0)
        return;
    const double base = canvas->height - strip + BASE * unit, left = PAD * unit;
    double right = draw_bar(canvas, view, canvas->width - PAD * unit, base, unit);
    if (scales->arrow_speed > 0.0)
        right = draw_arrow(canvas, scales, right - 2 * PAD * unit, base, unit);
    if (scales->level_step > 0.0 && levels)
        right = write_levels(canvas, scales, right - 2 * PAD * unit, base, unit, levels);
    const double room = right - left - PAD * unit;
    char line[TEXT_SIZE];
    snprintf(line, sizeof line, "%s", text);
    for (size_t length = strlen(line); length > 0 && sph2d__canvas_text_width(unit, line) > room; --length)
        line[length - 1] = '\0';
    sph2d__canvas_text(canvas, left, base, unit, line, ink);
}

/* ---- notes ------------------------------------------------------------------------------------------------------- */

/* Copies the first line of a text, and returns the rest; NULL after the last. */
static const char *next_line(const char *text, char line[TEXT_SIZE])
{
    const char *end = strchr(text, '\n');
    const size_t length = end ? (size_t)(end - text) : strlen(text);
    snprintf(line, TEXT_SIZE, "%.*s", (int)(length < TEXT_SIZE ? length : TEXT_SIZE - 1), text);
    return end ? end + 1 : NULL;
}

sph2d__pixel_box sph2d__notes_box(int width, int height, const char *notes)
{
    const double unit = sph2d__canvas_unit(width, height);
    double widest = 0.0;
    int lines = 0;
    char line[TEXT_SIZE];
    for (const char *rest = notes; rest; ++lines) {
        rest = next_line(rest, line);
        widest = fmax(widest, sph2d__canvas_text_width(unit, line));
    }
    const int margin = (int)lrint(PAD * unit);
    const int columns = (int)ceil(widest + 2 * PAD * unit), rows = (int)ceil((lines * LINE + PAD) * unit);
    return (sph2d__pixel_box){margin, margin, columns < width - margin ? columns : width - margin,
                              rows < height - margin ? rows : height - margin};
}

void sph2d__notes_draw(const sph2d__canvas *canvas, const char *notes)
{
    const double unit = sph2d__canvas_unit(canvas->width, canvas->height);
    const sph2d__pixel_box box = sph2d__notes_box(canvas->width, canvas->height, notes);
    sph2d__canvas_fill(canvas, box.x, box.y, box.width, box.height, (sph2d__ink){250, 251, 252, 1.0});
    double y = box.y + (LINE - 1) * unit;
    char line[TEXT_SIZE];
    for (const char *rest = notes; rest; y += LINE * unit) {
        rest = next_line(rest, line);
        sph2d__canvas_text(canvas, box.x + PAD * unit, y, unit, line, ink);
    }
}
