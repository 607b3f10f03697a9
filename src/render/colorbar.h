/* SPDX-License-Identifier: MIT */
/** @file colorbar.h
 *  The legend: a colour bar. */
#ifndef SPH2D_RENDER_COLORBAR_H
#define SPH2D_RENDER_COLORBAR_H

#include <stdbool.h>
#include <stddef.h>

#include "render/canvas.h"

/** The smallest and largest finite value, widened where they are (nearly) equal, so that min < max; `symmetric`: the
 *  larger size of the two with either sign. */
void sph2d__color_range(const double *values, size_t count, bool symmetric, double *min, double *max);

/** Width of the legend at the right of an image [px]: independent of the numbers, so that the view is the same in all
 *  frames of a sequence. 0 where an image is too small for a legend. */
int sph2d__colorbar_width(int width, int height, const char *label);

/** Draws a bar from `min` to `max` > `min` with round numbers beside it and a label (or NULL) above into those columns,
 *  in the colours of sph2d__colormap(). */
void sph2d__colorbar_draw(const sph2d__canvas *canvas, double min, double max, bool diverging, const char *label);

#endif
