/* SPDX-License-Identifier: MIT */
/** @file target.h
 *  Render targets: framebuffer objects, row 0 of which is the top of the image; and the square tiles of one in which
 *  something is to be drawn. Shading is expensive for every pixel in a software renderer, and cheaper inside a liquid than
 *  at its surface. */
#ifndef SPH2D_RENDER_TARGET_H
#define SPH2D_RENDER_TARGET_H

#include "render/gl_loader.h"
#include "render/view.h"

/** Binds a texture and sets its filter, GL_NEAREST or GL_LINEAR; beyond its edges are their values. */
void sph2d__texture_prepare(const sph2d__gl *gl, GLuint texture, GLint filter);

/** Binds a texture to a unit of the programs; unit 0 should come last: it is the one that others work with. */
void sph2d__texture_bind(const sph2d__gl *gl, int unit, GLuint texture);

typedef struct sph2d__target {
    GLsizei width, height;
    GLuint framebuffer, texture;
    GLuint second;    /**< texture, of float targets that have two */
    bool transparent; /**< cleared to nothing: colours are multiplied by their alpha */
} sph2d__target;

/** An 8-bit RGBA target. Errors: SPH2D_RENDER, SPH2D_NOMEM. */
sph2d_status sph2d__target_create_color(const sph2d__gl *gl, sph2d__target *target, GLsizei width, GLsizei height,
                                        sph2d_report *report);

/** A target of floats, four a pixel, or of two textures of them, in which draw calls can be added up. The next pass reads
 *  the first with `filter`, GL_NEAREST or GL_LINEAR, the second with GL_LINEAR. Errors: SPH2D_RENDER, SPH2D_NOMEM. */
sph2d_status sph2d__target_create_float(const sph2d__gl *gl, sph2d__target *target, int textures, GLint filter,
                                        GLsizei width, GLsizei height, sph2d_report *report);

/** Copies a box of pixels to a framebuffer, which is bound then. */
void sph2d__target_copy(const sph2d__gl *gl, const sph2d__target *from, sph2d__pixel_box source, GLuint framebuffer,
                        sph2d__pixel_box to, bool upside_down);

/** Blends the following draw calls over its contents, by their alpha; an opaque image stays so. */
void sph2d__target_blend(const sph2d__gl *gl, const sph2d__target *target);

/** Adds the following draw calls up, from nothing. */
void sph2d__target_begin_sum(const sph2d__gl *gl, const sph2d__target *target);

/** Makes it the target of the following draw calls. */
void sph2d__target_bind(const sph2d__gl *gl, const sph2d__target *target);

/** Frees it; it may be zeroed. */
void sph2d__target_destroy(const sph2d__gl *gl, sph2d__target *target);

/* ---- tiles ------------------------------------------------------------------------------------------------------- */

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
