/* SPDX-License-Identifier: MIT */
/** @file view.h
 *  Conversion from metres to pixels, in double precision, so that scenes far from the origin are drawn as precisely. */
#ifndef SPH2D_RENDER_VIEW_H
#define SPH2D_RENDER_VIEW_H

#include <stdbool.h>

#include "sph2d/scene.h"

/** Pixels are counted from the top left corner, y downwards. */
typedef struct sph2d__view {
    unsigned width, height; /**< of the image [px] */
    sph2d_vec2 middle;      /**< a point of the image [px] ... */
    sph2d_vec2 center;      /**< ... and its position [m] */
    double scale;           /**< [px/m] */
} sph2d__view;

/** A rectangle of whole pixels. */
typedef struct sph2d__pixel_box {
    int x, y, width, height;
} sph2d__pixel_box;

/** Fits a box into an image, of which `right` columns and `below` rows at its ends are left free, centred, with its
 *  aspect kept. False where the box is empty, not finite or so small or large that nothing can be drawn. */
bool sph2d__view_fit(sph2d__view *view, sph2d_box box, unsigned width, unsigned height, unsigned right, unsigned below);

/** Converts a position, which may lie outside the image. */
sph2d_vec2 sph2d__view_at(const sph2d__view *view, double x, double y);

/** The position at a pixel. */
sph2d_vec2 sph2d__view_locate(const sph2d__view *view, double right, double down);

/** Converts a position. False if it is not finite or more than `margin` pixels outside the image. */
bool sph2d__view_place(const sph2d__view *view, double x, double y, double margin, float pixel[2]);

/** The part of the image that a box covers, rounded to pixels. */
sph2d__pixel_box sph2d__view_cover(const sph2d__view *view, sph2d_box box);

#endif
