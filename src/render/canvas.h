/* SPDX-License-Identifier: MIT */
/** @file canvas.h
 *  Text and boxes on rendered pixels, drawn by the CPU: a legend is small, and so it is identical on all drivers. The font
 *  is one of strokes: every glyph is a few polylines on a small grid, so that one table serves every size. It has Latin
 *  letters, those with the marks of European languages, Greek and Cyrillic ones, digits and the usual signs. */
#ifndef SPH2D_RENDER_CANVAS_H
#define SPH2D_RENDER_CANVAS_H

typedef struct sph2d__canvas {
    unsigned char *pixels; /**< 4 bytes a pixel, top row first; borrowed */
    int width, height;
    double halo; /**< above 0: all is drawn that much wider on each side [px], in light: below text on nothing */
} sph2d__canvas;

typedef struct sph2d__ink {
    unsigned char red, green, blue;
    double opacity; /**< 0 to 1 */
} sph2d__ink;

/** The usual unit of text in an image: a sixth of the height of a capital letter [px]. */
double sph2d__canvas_unit(int width, int height);

/** Fills a rectangle, clipped to the canvas. */
void sph2d__canvas_fill(const sph2d__canvas *canvas, int x, int y, int width, int height, sph2d__ink ink);

/** Draws a line with round ends between two points [px], `half` as wide on each side. */
void sph2d__canvas_line(const sph2d__canvas *canvas, const double from[2], const double to[2], double half,
                        sph2d__ink ink);

/** Writes UTF-8 text (characters that the font lacks become boxes) with its baseline's left end at (x, y) [px]; `unit` is a
 *  sixth of the height of a capital letter [px]. A character whose end is cut off is left out. */
void sph2d__canvas_text(const sph2d__canvas *canvas, double x, double y, double unit, const char *text, sph2d__ink ink);

/** Width of a text [px]. */
double sph2d__canvas_text_width(double unit, const char *text);

/* ---- the font (glyphs.c) ----------------------------------------------------------------------------------------- */

/** A character. Strokes are separated by spaces; a point is two digits, x from 0 to 5 and y from 0 to 9, with the baseline
 *  at 2, the x-height at 6 and the height of capitals at 8. Static storage. */
typedef struct sph2d__glyph {
    const char *strokes;   /**< NULL: nothing to draw */
    const char *mark;      /**< an accent, also strokes; NULL: none */
    double x;              /**< where the strokes' grid begins */
    double mark_x, mark_y; /**< where that of the mark does */
    double width;
} sph2d__glyph;

/** The glyph of the first character of a UTF-8 text that is not empty; *text moves to the next one. A box for what has
 *  none and for bytes that are no UTF-8, nothing for a character that is cut off. */
sph2d__glyph sph2d__glyph_next(const char **text);

#endif
