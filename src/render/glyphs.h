/* SPDX-License-Identifier: MIT */
/** @file glyphs.h
 *  A stroke font: every glyph is a few polylines on a small grid, so that one table serves every size. Latin letters, those
 *  with the marks of European languages, Greek and Cyrillic ones, digits and the usual signs. */
#ifndef SPH2D_RENDER_GLYPHS_H
#define SPH2D_RENDER_GLYPHS_H

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
