/* SPDX-License-Identifier: MIT */
/** @file tiles.h
 *  The square tiles of the image in which something is to be drawn. Shading is expensive for every pixel in a software
 *  renderer, and cheaper inside a liquid than at its surface. */
#ifndef SPH2D_RENDER_TILES_H
#define SPH2D_RENDER_TILES_H

#include "render/target.h"

enum { SPH2D__TILE = 16 }; /**< side of a tile [px] */

/** What is in a tile: nothing to draw, something, or a field that is full and even in it and around it; as kinds.frag
 *  finds them. */
enum { SPH2D__TILE_EMPTY, SPH2D__TILE_TOUCHED, SPH2D__TILE_INSIDE };

/** Number of tiles that cover so many pixels. */
GLsizei sph2d__tiles_count(GLsizei pixels);

/** Draws the tiles of a kind with a program whose vertices are those of tiles.vert and which is in use, with the blending
 *  in use. The texture unit `kinds` has a texel for each tile. */
void sph2d__tiles_draw(const sph2d__gl *gl, GLuint program, const sph2d__target *target, int kinds, int kind);

#endif
