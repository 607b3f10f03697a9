/* SPDX-License-Identifier: MIT */
/** @file colorbar.h
 *  The legend of the colours: which numbers they stand for. */
#ifndef SPH2D_RENDER_COLORBAR_H
#define SPH2D_RENDER_COLORBAR_H

#include <stddef.h>

#include "render/canvas.h"

/** The smallest and largest finite value, widened where they are (nearly) equal, so that min < max. */
void sph2d__color_range(const double *values, size_t count, double *min, double *max);

/** How many columns at the right of an image the legend wants for itself [px]: the same for all numbers, so that a
 *  sequence of pictures stands still. 0 where an image has no room for one. */
int sph2d__colorbar_width(int width, int height, const char *label);

/** Draws a bar from `min` to `max` > `min` with round numbers beside it and a label (or NULL) above into those columns.
 */
void sph2d__colorbar_draw(const sph2d__canvas *canvas, double min, double max, const char *label);

#endif
