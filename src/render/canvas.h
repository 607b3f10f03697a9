/* SPDX-License-Identifier: MIT */
/** @file canvas.h
 *  Text and boxes on rendered pixels, drawn by the CPU: a legend is small, and so it is identical on all drivers. */
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

/** Writes UTF-8 text (characters that glyphs.h lacks become boxes) with its baseline's left end at (x, y) [px]; `unit` is a
 *  sixth of the height of a capital letter [px]. A character whose end is cut off is left out. */
void sph2d__canvas_text(const sph2d__canvas *canvas, double x, double y, double unit, const char *text, sph2d__ink ink);

/** Width of a text [px]. */
double sph2d__canvas_text_width(double unit, const char *text);

#endif
