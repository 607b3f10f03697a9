/* SPDX-License-Identifier: MIT */
/** @file mask.h
 *  Shapes of one colour: how much of each pixel they cover, from the CPU to the target. */
#ifndef SPH2D_RENDER_MASK_H
#define SPH2D_RENDER_MASK_H

#include "render/cover.h"
#include "render/target.h"

typedef struct sph2d__mask {
    sph2d__cover cover;
    unsigned char *tiles; /**< their kinds, row by row: in those that are touched it is not 0 */
    GLuint texture;       /**< the cover, one byte a pixel, after sph2d__mask_upload() ... */
    GLuint kinds;         /**< ... and the kinds of tiles */
} sph2d__mask;

/** Errors: SPH2D_NOMEM, SPH2D_RENDER. */
sph2d_status sph2d__mask_create(const sph2d__gl *gl, sph2d__mask *mask, GLsizei width, GLsizei height,
                                sph2d_report *report);

/** Hands the cover over to the texture. */
void sph2d__mask_upload(const sph2d__gl *gl, sph2d__mask *mask);

/** Draws it over the contents of `target` with the program "tiles", "mask", in a colour (red, green, blue, opacity). */
void sph2d__mask_draw(const sph2d__gl *gl, const sph2d__mask *mask, GLuint program, const sph2d__target *target,
                      const float color[4]);

/** Frees it; it may be zeroed. */
void sph2d__mask_destroy(const sph2d__gl *gl, sph2d__mask *mask);

#endif
