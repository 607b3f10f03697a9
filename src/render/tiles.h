/* SPDX-License-Identifier: MIT */
/** @file tiles.h
 *  The square tiles of the image in which something is to be drawn. Shading is expensive for every pixel in a software
 *  renderer, and cheaper inside a liquid than at its surface. */
#ifndef SPH2D_RENDER_TILES_H
#define SPH2D_RENDER_TILES_H

#include "render/dots.h"
#include "render/field_grid.h"

enum { SPH2D__TILE = 16 }; /**< side of a tile [px] */

/** What is in a tile: nothing to draw, something, or a field that is full and even in it and around it. */
enum { SPH2D__TILE_EMPTY, SPH2D__TILE_TOUCHED, SPH2D__TILE_INSIDE };

typedef struct sph2d__tiles {
    int columns, rows;
    unsigned char *kinds; /**< one a tile, row by row */
} sph2d__tiles;

/** What makes the kind of a tile. */
typedef struct sph2d__tile_rule {
    float lowest;  /**< a tile is not empty if the field is as large somewhere */
    float full;    /**< it is inside if the field is as large everywhere ... */
    float range;   /**< ... and between its limits so far ... */
    double around; /**< ... in the tile and so many pixels around it */
} sph2d__tile_rule;

/** Errors: SPH2D_NOMEM. */
sph2d_status sph2d__tiles_create(sph2d__tiles *tiles, int width, int height, sph2d_report *report);

/** Finds the kinds of tiles from a field on the pixels of an image as large as theirs. */
void sph2d__tiles_find(sph2d__tiles *tiles, const sph2d__field_grid *field, const sph2d__tile_rule *rule);

/** Finds the tiles in which an image of bytes, as large as theirs, is not 0. */
void sph2d__tiles_find_bytes(sph2d__tiles *tiles, const unsigned char *bytes, int width, int height);

/** Draws the tiles of a kind, those side by side as one rectangle, with the program, target and blending in use. */
void sph2d__tiles_draw(const sph2d__gl *gl, const sph2d__tiles *tiles, sph2d__dots *dots, unsigned char kind);

/** Frees it; it may be zeroed. */
void sph2d__tiles_destroy(sph2d__tiles *tiles);

#endif
