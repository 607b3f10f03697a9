/* SPDX-License-Identifier: MIT */
/** @file legend.h
 *  What is written beside a picture, on its pixels: a colour bar at the right, a strip below it with a line of text and a
 *  scale bar, notes in its corner; and the numbers and colours that these have. */
#ifndef SPH2D_RENDER_LEGEND_H
#define SPH2D_RENDER_LEGEND_H

#include <stdbool.h>
#include <stddef.h>

#include "render/canvas.h"
#include "render/lines.h"
#include "render/view.h"

/* ---- numbers ----------------------------------------------------------------------------------------------------- */

/** factor * 10^exponent. */
typedef struct sph2d__round_number {
    int factor, exponent;
} sph2d__round_number;

/** The one nearest to a positive number. */
sph2d__round_number sph2d__round_nearest(double number);

/** Writes digits and a power of ten as "-0.25", "1500" or "1.5e7". */
void sph2d__write_number(char *text, size_t size, long long digits, int exponent);

/* ---- colours ----------------------------------------------------------------------------------------------------- */

/** The opaque colour of `t` from 0 to 1, clamped; grey where it is NaN. `diverging`: of two hues that meet in a light grey
 *  at 1/2, for values of either sign. */
void sph2d__colormap(double t, bool diverging, unsigned char color[4]);

/** The smallest and largest finite value, widened where they are (nearly) equal, so that min < max; `symmetric`: the
 *  larger size of the two with either sign. */
void sph2d__color_range(const double *values, size_t count, bool symmetric, double *min, double *max);

/** Width of the legend at the right of an image [px]: independent of the numbers, so that the view is the same in all
 *  frames of a sequence. 0 where an image is too small for a legend. */
int sph2d__colorbar_width(int width, int height, const char *label);

/** Draws a bar from `min` to `max` > `min` with round numbers beside it and a label (or NULL) above into those columns,
 *  in the colours of sph2d__colormap(). */
void sph2d__colorbar_draw(const sph2d__canvas *canvas, double min, double max, bool diverging, const char *label);

/* ---- caption and notes ------------------------------------------------------------------------------------------- */

/** The rows that a strip takes from the lower end of an image [px]; 0 where the image is too low for it. */
int sph2d__caption_height(int width, int height);

/** Draws the strip: the text, cut where it does not fit, what lines are, and a bar as long as its number of metres.
 *  `levels` is what isolines show; NULL: nothing. */
void sph2d__caption_draw(const sph2d__canvas *canvas, const sph2d__view *view, const char *text,
                         const sph2d__scales *scales, const char *levels);

/** The box of notes: lines of text, in the upper left corner. */
sph2d__pixel_box sph2d__notes_box(int width, int height, const char *notes);
void sph2d__notes_draw(const sph2d__canvas *canvas, const char *notes);

#endif
