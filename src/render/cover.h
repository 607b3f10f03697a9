/* SPDX-License-Identifier: MIT */
/** @file cover.h
 *  How much of each pixel polygons cover: exact areas, so that slanted edges are smooth. On the CPU, so that it is the
 *  same on all drivers. */
#ifndef SPH2D_RENDER_COVER_H
#define SPH2D_RENDER_COVER_H

#include <stdbool.h>
#include <stddef.h>

/** The cover of an image, and a polygon in the making. */
typedef struct sph2d__cover {
    int width, height;
    unsigned char *pixels; /**< 0 to 255 each, top row first */
    float *changes;        /**< of the polygon's cover from a pixel to the next; rows of width + 2 */
    int top, bottom;       /**< rows that it touches, bottom excluded */
} sph2d__cover;

/** Allocates it for an image; false when memory is short. */
bool sph2d__cover_create(sph2d__cover *cover, int width, int height);
void sph2d__cover_destroy(sph2d__cover *cover);

/** Clears the image, and makes it as large as this or smaller than it was made. */
void sph2d__cover_clear(sph2d__cover *cover, int width, int height);

/** Adds an edge of the polygon, in pixels from the top left corner, finite; it may lie outside the image. */
void sph2d__cover_edge(sph2d__cover *cover, const double from[2], const double to[2]);

/** Fills the polygon, whose edges close loops: what they go round once or more, in either direction. Covers add up to
 *  255 at most. */
void sph2d__cover_fill(sph2d__cover *cover);

#endif
