/* SPDX-License-Identifier: MIT */
/** @file legend.c
 *  The legend of a picture. Its colour map is viridis: perceptually uniform, also in grey and with most kinds of colour
 *  blindness; and for values of either sign one from blue to red, whose middle is a grey that lit surfaces do not hide. */
#include "render/legend.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The unit of sizes is a sixth of the height of a capital letter; here around what is written. */
enum { PAD = 6 };
enum { NUMBER_SIZE = 48 };

static const sph2d__ink ink = {40, 46, 54, 1.0};

/* ---- numbers ----------------------------------------------------------------------------------------------------- */

enum { DIGITS_SIZE = 24 };

sph2d__round_number sph2d__round_nearest(double number)
{
    sph2d__round_number round = {.exponent = (int)floor(log10(number))};
    const double lead = number / pow(10.0, round.exponent);
    round.factor = lead < 1.5 ? 1 : lead < 3.5 ? 2 : 5;
    if (lead >= 7.5) {
        round.factor = 1;
        ++round.exponent;
    }
    return round;
}

/* Not by printf, whose point depends on the locale. */
void sph2d__write_number(char *text, size_t size, long long digits, int exponent)
{
    char all[DIGITS_SIZE];
    const char *sign = digits < 0 ? "-" : "";
    if (digits == 0)
        exponent = 0;
    snprintf(all, sizeof all, "%lld", llabs(digits));
    const int length = (int)strlen(all);
    if (exponent >= 0 && length + exponent <= 6) {
        snprintf(text, size, "%s%s%.*s", sign, all, exponent, "000000");
    } else if (exponent < 0 && exponent >= -5) {
        const int whole = length + exponent; /* digits before the point */
        if (whole > 0)
            snprintf(text, size, "%s%.*s.%s", sign, whole, all, all + whole);
        else
            snprintf(text, size, "%s0.%.*s%s", sign, -whole, "00000", all);
    } else {
        int kept = length;
        while (kept > 1 && all[kept - 1] == '0')
            --kept;
        snprintf(text, size, "%s%c%s%.*se%d", sign, all[0], kept > 1 ? "." : "", kept - 1, all + 1,
                 exponent + length - 1);
    }
}

/* ---- colours ----------------------------------------------------------------------------------------------------- */

enum { ANCHORS = 9 };

/* Colours of viridis (by S. van der Walt and N. Smith, in the public domain under CC0), evenly spaced. */
static const unsigned char viridis[ANCHORS][3] = {{68, 1, 84},    {71, 44, 122},  {59, 81, 139},
                                                  {44, 113, 142}, {33, 144, 141}, {39, 173, 129},
                                                  {92, 200, 99},  {170, 220, 50}, {253, 231, 37}};

/* Colours of the cool to warm map of K. Moreland, Diverging color maps for scientific visualization, Advances in Visual
 * Computing, 2009. */
static const unsigned char cool_warm[ANCHORS][3] = {{59, 76, 192},   {98, 130, 234},  {141, 176, 254},
                                                    {184, 208, 249}, {221, 221, 221}, {245, 196, 173},
                                                    {244, 154, 123}, {222, 96, 77},   {180, 4, 38}};

void sph2d__colormap(double t, bool diverging, unsigned char color[4])
{
    static const unsigned char unknown[4] = {150, 150, 150, 255};
    if (isnan(t)) {
        memcpy(color, unknown, sizeof unknown);
        return;
    }
    const unsigned char(*anchors)[3] = diverging ? cool_warm : viridis;
    const int last = ANCHORS - 1;
    const double at = fmin(fmax(t, 0.0), 1.0) * last;
    const int low = at < last ? (int)at : last - 1;
    for (int c = 0; c < 3; ++c)
        color[c] = (unsigned char)lrint(anchors[low][c] + (at - low) * (anchors[low + 1][c] - anchors[low][c]));
    color[3] = 255;
}

/* ---- the colour bar ---------------------------------------------------------------------------------------------- */

enum { TICKS_TARGET = 5, TICKS_MAX = 16, LABEL_SIZE = 64 };

/* Relative difference below which two numbers count as equal in a legend. */
static const double resolution = 1.0e-9;

void sph2d__color_range(const double *values, size_t count, bool symmetric, double *min, double *max)
{
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (size_t i = 0; i < count; ++i) {
        if (!isfinite(values[i]))
            continue;
        low = fmin(low, values[i]);
        high = fmax(high, values[i]);
    }
    if (low > high)
        low = high = 0.0;
    const double size = fmax(fabs(low), fabs(high));
    if (symmetric) {
        high = size > 0.0 ? size : 1.0;
        low = -high;
    } else if (size == 0.0) {
        high = 1.0;
    } else if (high - low <= resolution * size) {
        low -= 0.1 * size;
        high += 0.1 * size;
    }
    *min = low;
    *max = high;
}

typedef struct tick {
    double at; /* 0 at the bar's lower end, 1 at its upper */
    char text[NUMBER_SIZE];
} tick;

/* Ticks at multiples of 1, 2 or 5 times a power of ten. */
static int place_ticks(double min, double max, tick ticks[TICKS_MAX])
{
    const sph2d__round_number by = sph2d__round_nearest((max - min) / TICKS_TARGET);
    const double step = by.factor * pow(10.0, by.exponent);
    const double first = ceil(min / step - 1.0e-6), last = floor(max / step + 1.0e-6);
    int count = 0;
    for (double k = first; k <= last && count < TICKS_MAX && fabs(k) < 1.0e15; k += 1.0) {
        tick *next = &ticks[count++];
        next->at = fmin(fmax((k * step - min) / (max - min), 0.0), 1.0);
        sph2d__write_number(next->text, sizeof next->text, (long long)k * by.factor, by.exponent);
    }
    return count;
}

/* Sizes in units. */
enum { BAR_WIDTH = 9, BAR_TICK = 3, TITLE = 14, NUMBER_COLUMN = 48 };

/* Layout of the legend [px]. */
typedef struct layout {
    double unit;
    char title[LABEL_SIZE]; /* the label, truncated to fit */
    int width;              /* of the columns reserved for it; 0: it does not fit */
    int bar_x, bar_y, bar_width, bar_height;
} layout;

static layout arrange(int width, int height, const char *label)
{
    layout at = {.unit = sph2d__canvas_unit(width, height)};
    const double pads = 2 * PAD * at.unit, max_width = width / 3.0 - pads,
                 numbers = (BAR_WIDTH + BAR_TICK + 2 + NUMBER_COLUMN) * at.unit;
    snprintf(at.title, sizeof at.title, "%s", label ? label : "");
    size_t length = strlen(at.title);
    while (length > 0 && sph2d__canvas_text_width(at.unit, at.title) > max_width)
        at.title[--length] = '\0';
    at.width = (int)ceil(fmax(numbers, sph2d__canvas_text_width(at.unit, at.title)) + pads);
    at.bar_width = (int)lrint(BAR_WIDTH * at.unit);
    at.bar_height = (int)lrint(0.4 * height);
    at.bar_x = width - at.width + (int)lrint(PAD * at.unit);
    at.bar_y = (int)lrint((PAD + TITLE) * at.unit);
    const bool fits = numbers <= max_width && at.bar_height >= 10 * TICKS_TARGET * at.unit &&
                      at.bar_y + at.bar_height + PAD * at.unit < height;
    if (!fits)
        at.width = 0;
    return at;
}

int sph2d__colorbar_width(int width, int height, const char *label)
{
    return arrange(width, height, label).width;
}

static void draw_colors(const sph2d__canvas *canvas, const layout *at, bool diverging)
{
    static const sph2d__ink frame = {70, 78, 88, 1.0};
    sph2d__canvas_fill(canvas, at->bar_x - 1, at->bar_y - 1, at->bar_width + 2, at->bar_height + 2, frame);
    for (int row = 0; row < at->bar_height; ++row) {
        unsigned char color[4];
        sph2d__colormap(1.0 - (row + 0.5) / at->bar_height, diverging, color);
        const sph2d__ink part = {color[0], color[1], color[2], 1.0};
        sph2d__canvas_fill(canvas, at->bar_x, at->bar_y + row, at->bar_width, 1, part);
    }
}

void sph2d__colorbar_draw(const sph2d__canvas *canvas, double min, double max, bool diverging, const char *label)
{
    const layout at = arrange(canvas->width, canvas->height, label);
    if (at.width == 0)
        return;
    sph2d__canvas_text(canvas, at.bar_x, at.bar_y - 7.0 * at.unit, at.unit, at.title, ink);
    draw_colors(canvas, &at, diverging);

    tick ticks[TICKS_MAX];
    const int count = place_ticks(min, max, ticks);
    const int thick = (int)fmax(1.0, 0.6 * at.unit);
    for (int i = 0; i < count; ++i) {
        const double x = at.bar_x + at.bar_width, y = at.bar_y + (1.0 - ticks[i].at) * at.bar_height;
        sph2d__canvas_fill(canvas, (int)x, (int)lrint(y - 0.5 * thick), (int)lrint(BAR_TICK * at.unit), thick, ink);
        sph2d__canvas_text(canvas, x + (BAR_TICK + 2) * at.unit, y + 3.0 * at.unit, at.unit, ticks[i].text, ink);
    }
}

/* ---- scale bar --------------------------------------------------------------------------------------------------- */

/* Sizes in units. */
enum { STRIP = 18, BASE = 12, BAR = 2, TICK = 5, LINE = 11 };
enum { TEXT_SIZE = 160 };

/* Part of the image's width that a scale bar has about. */
static const double bar_part = 0.16;

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

/* ---- the strip below --------------------------------------------------------------------------------------------- */

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
