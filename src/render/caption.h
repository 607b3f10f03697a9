/* SPDX-License-Identifier: MIT */
/** @file caption.h
 *  A strip below the picture with a line of text and a scale bar, and notes on the picture. */
#ifndef SPH2D_RENDER_CAPTION_H
#define SPH2D_RENDER_CAPTION_H

#include "render/canvas.h"
#include "render/lines.h"
#include "render/view.h"

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
