/* SPDX-License-Identifier: MIT */
/** @file canvas.c
 *  A stroke font: every glyph is a few polylines on a small grid, drawn as lines with round ends and smooth edges, so
 *  that one table serves every size. */
#include "render/canvas.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <string.h>

/* The strokes of each character from '!' to '~', separated by spaces; a point is two digits, x from 0 to 4 and y from
 * 0 to 9, with the baseline at 2, the x-height at 6 and the cap height at 8. */
static const char *const glyphs[] = {
    "0804 0202",                        /* ! */
    "0806 1816",                        /* " */
    "1218 3238 0444 0646",              /* # */
    "473818070615354443321203 2129",    /* $ */
    "0248 0808 4242",                   /* % */
    "4216172837360403122244",           /* & */
    "0806",                             /* ' */
    "18060412",                         /* ( */
    "08161402",                         /* ) */
    "2327 0446 0644",                   /* * */
    "0545 2327",                        /* + */
    "1201",                             /* , */
    "0535",                             /* - */
    "0202",                             /* . */
    "0149",                             /* / */
    "120307183847433212",               /* 0 */
    "062822 0242",                      /* 1 */
    "07183847460242",                   /* 2 */
    "0718384746354443321203 3515",      /* 3 */
    "32380444",                         /* 4 */
    "480805354443321203",               /* 5 */
    "4738180703123243443505",           /* 6 */
    "084812",                           /* 7 */
    "15354443321203041506071838474635", /* 8 */
    "0312324347381807061545",           /* 9 */
    "0202 0505",                        /* : */
    "1515 1201",                        /* ; */
    "380532",                           /* < */
    "0444 0646",                        /* = */
    "083502",                           /* > */
    "07183847462524 2222",              /* ? */
    "120307183847433212 2525",          /* @ */
    "022842 1434",                      /* A */
    "02083847463505 3544433202",        /* B */
    "4738180703123243",                 /* C */
    "02082846442202",                   /* D */
    "48080242 0535",                    /* E */
    "480802 0535",                      /* F */
    "47381807031232434525",             /* G */
    "0208 4248 0545",                   /* H */
    "0208",                             /* I */
    "4843321203",                       /* J */
    "0208 4804 1542",                   /* K */
    "080242",                           /* L */
    "0208254842",                       /* M */
    "02084248",                         /* N */
    "120307183847433212",               /* O */
    "02083847463505",                   /* P */
    "120307183847433212 2442",          /* Q */
    "02083847463505 2542",              /* R */
    "473818070615354443321203",         /* S */
    "0848 2228",                        /* T */
    "080312324348",                     /* U */
    "082248",                           /* V */
    "0812253248",                       /* W */
    "0248 0842",                        /* X */
    "082548 2522",                      /* Y */
    "08480242",                         /* Z */
    "18080212",                         /* [ */
    "0941",                             /* backslash */
    "08181202",                         /* ] */
    "062846",                           /* ^ */
    "0141",                             /* _ */
    "0817",                             /* ` */
    "3526160503122233 3632",            /* a */
    "0208 0516263533221203",            /* b */
    "3526160503122233",                 /* c */
    "3832 3526160503122233",            /* d */
    "04343526160503122233",             /* e */
    "281712 0626",                      /* f */
    "3526160503122233 3631201001",      /* g */
    "0208 0516263532",                  /* h */
    "0206 0808",                        /* i */
    "161100 1818",                      /* j */
    "0208 3603 1432",                   /* k */
    "080312",                           /* l */
    "0206 05162522 25364542",           /* m */
    "0206 0516263532",                  /* n */
    "120305162635332212",               /* o */
    "0006 0516263533221203",            /* p */
    "3630 3526160503122233",            /* q */
    "0206 051626",                      /* r */
    "3616051424332202",                 /* s */
    "181322 0626",                      /* t */
    "0603122233 3632",                  /* u */
    "062246",                           /* v */
    "0612253246",                       /* w */
    "0632 0236",                        /* x */
    "0622 4610",                        /* y */
    "06360232",                         /* z */
    "2817160514131222",                 /* { */
    "0109",                             /* | */
    "0817162514131202",                 /* } */
    "05163445",                         /* ~ */
};

static const char unknown_glyph[] = "0208484202";

enum { BASELINE = 2, GAP = 2, SPACE = 3 }; /* grid units */
static const double half_line = 0.42;      /* half the width of a line, grid units */

static const char *glyph_of(char character)
{
    const size_t index = (size_t)((unsigned char)character - '!');
    return index < sizeof glyphs / sizeof glyphs[0] ? glyphs[index] : unknown_glyph;
}

/* Width of a glyph, grid units. */
static int glyph_width(const char *glyph)
{
    int widest = 0;
    while (*glyph != '\0') {
        if (*glyph == ' ') {
            ++glyph;
            continue;
        }
        if (glyph[0] - '0' > widest)
            widest = glyph[0] - '0';
        glyph += 2;
    }
    return widest;
}

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
    bool pen_down = false;
    while (*glyph != '\0') {
        if (*glyph == ' ') {
            pen_down = false;
            ++glyph;
            continue;
        }
        const double point[2] = {glyph[0] - '0', glyph[1] - '0'};
        const double square = segment_square(x, y, pen_down ? last : point, point);
        nearest = square < nearest ? square : nearest;
        memcpy(last, point, sizeof last);
        pen_down = true;
        glyph += 2;
    }
    return sqrt(nearest);
}

/* Draws a glyph whose grid's origin is at (x, y) [px]. */
static void draw_glyph(const sph2d__canvas *canvas, double x, double y, double unit, const char *glyph, sph2d__ink ink)
{
    const int wider = 1 + (int)ceil(canvas->halo);
    const int left = (int)floor(x - unit) - wider, right = (int)ceil(x + 5.0 * unit) + wider;
    const int top = (int)floor(y - 10.0 * unit) - wider, bottom = (int)ceil(y + unit) + wider;
    for (int row = top > 0 ? top : 0; row < bottom && row < canvas->height; ++row)
        for (int column = left > 0 ? left : 0; column < right && column < canvas->width; ++column) {
            const double distance = glyph_distance(glyph, (column + 0.5 - x) / unit, (y - row - 0.5) / unit);
            const double cover = (half_line - distance) * unit + 0.5 + canvas->halo;
            if (cover > 0.0)
                blend(canvas, column, row, ink, fmin(cover, 1.0));
        }
}

static double advance(const char *glyph)
{
    return glyph_width(glyph) + GAP;
}

void sph2d__canvas_text(const sph2d__canvas *canvas, double x, double y, double unit, const char *text, sph2d__ink ink)
{
    for (; *text != '\0'; ++text) {
        if (*text == ' ') {
            x += SPACE * unit;
            continue;
        }
        const char *glyph = glyph_of(*text);
        draw_glyph(canvas, x, y + BASELINE * unit, unit, glyph, ink);
        x += advance(glyph) * unit;
    }
}

double sph2d__canvas_text_width(double unit, const char *text)
{
    double width = 0.0;
    for (; *text != '\0'; ++text)
        width += *text == ' ' ? SPACE : advance(glyph_of(*text));
    return width > GAP ? (width - GAP) * unit : 0.0;
}
