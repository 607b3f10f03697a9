/* SPDX-License-Identifier: MIT */
/** @file colorbar.c
 *  A colour bar with ticks at round numbers. */
#include "render/colorbar.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "render/colormap.h"
#include "render/round_number.h"

enum { TICKS_TARGET = 5, TICKS_MAX = 16, NUMBER_SIZE = 40, LABEL_SIZE = 64 };

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

/* Sizes in units, a sixth of the height of a capital letter each. */
enum { PAD = 6, BAR = 9, TICK = 3, TITLE = 14, NUMBERS = 48 };

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
                 numbers = (BAR + TICK + 2 + NUMBERS) * at.unit;
    snprintf(at.title, sizeof at.title, "%s", label ? label : "");
    size_t length = strlen(at.title);
    while (length > 0 && sph2d__canvas_text_width(at.unit, at.title) > max_width)
        at.title[--length] = '\0';
    at.width = (int)ceil(fmax(numbers, sph2d__canvas_text_width(at.unit, at.title)) + pads);
    at.bar_width = (int)lrint(BAR * at.unit);
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

static void draw_bar(const sph2d__canvas *canvas, const layout *at, bool diverging)
{
    static const sph2d__ink frame = {70, 78, 88, 1.0};
    sph2d__canvas_fill(canvas, at->bar_x - 1, at->bar_y - 1, at->bar_width + 2, at->bar_height + 2, frame);
    for (int row = 0; row < at->bar_height; ++row) {
        unsigned char color[4];
        sph2d__colormap(1.0 - (row + 0.5) / at->bar_height, diverging, color);
        const sph2d__ink ink = {color[0], color[1], color[2], 1.0};
        sph2d__canvas_fill(canvas, at->bar_x, at->bar_y + row, at->bar_width, 1, ink);
    }
}

void sph2d__colorbar_draw(const sph2d__canvas *canvas, double min, double max, bool diverging, const char *label)
{
    static const sph2d__ink ink = {40, 46, 54, 1.0};
    const layout at = arrange(canvas->width, canvas->height, label);
    if (at.width == 0)
        return;
    sph2d__canvas_text(canvas, at.bar_x, at.bar_y - 7.0 * at.unit, at.unit, at.title, ink);
    draw_bar(canvas, &at, diverging);

    tick ticks[TICKS_MAX];
    const int count = place_ticks(min, max, ticks);
    const int thick = (int)fmax(1.0, 0.6 * at.unit);
    for (int i = 0; i < count; ++i) {
        const double x = at.bar_x + at.bar_width, y = at.bar_y + (1.0 - ticks[i].at) * at.bar_height;
        sph2d__canvas_fill(canvas, (int)x, (int)lrint(y - 0.5 * thick), (int)lrint(TICK * at.unit), thick, ink);
        sph2d__canvas_text(canvas, x + (TICK + 2) * at.unit, y + 3.0 * at.unit, at.unit, ticks[i].text, ink);
    }
}
