/* SPDX-License-Identifier: MIT */
/** @file tiles.h
 *  The square tiles of the image that particles touch. The second pass of the metaballs is expensive for every pixel,
 *  water or not, in a software renderer, so it draws these tiles only. */
#ifndef SPH2D_RENDER_TILES_H
#define SPH2D_RENDER_TILES_H

#include "render/dots.h"

enum { SPH2D__TILE = 16 }; /**< side of a tile [px] */

typedef struct sph2d__tiles {
    int columns, rows;
    unsigned char *touched; /**< one a tile, row by row */
} sph2d__tiles;

/** Errors: SPH2D_NOMEM. */
sph2d_status sph2d__tiles_create(sph2d__tiles *tiles, int width, int height, sph2d_report *report);

/** Finds the tiles that touch a square of half side `reach` around any particle of a list. */
void sph2d__tiles_find(sph2d__tiles *tiles, const sph2d__view *view, const sph2d__dot_list *list);

/** Finds the tiles in which an image of bytes, as large as theirs, is not 0. */
void sph2d__tiles_find_bytes(sph2d__tiles *tiles, const unsigned char *bytes, int width, int height);

/** Draws the tiles found, as squares, with the program, target and blending in use. */
void sph2d__tiles_draw(const sph2d__gl *gl, const sph2d__tiles *tiles, sph2d__dots *dots);

/** Frees it; it may be zeroed. */
void sph2d__tiles_destroy(sph2d__tiles *tiles);

#endif
