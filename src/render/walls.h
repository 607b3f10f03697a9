/* SPDX-License-Identifier: MIT */
/** @file walls.h
 *  Walls and bodies as filled shapes. */
#ifndef SPH2D_RENDER_WALLS_H
#define SPH2D_RENDER_WALLS_H

#include "render/mask.h"

typedef struct sph2d__walls {
    sph2d__mask mask;
    uint64_t mark; /**< of what is in it */
} sph2d__walls;

/** Errors: SPH2D_RENDER, SPH2D_NOMEM. */
sph2d_status sph2d__walls_create(const sph2d__gl *gl, sph2d__walls *walls, GLsizei width, GLsizei height,
                                 sph2d_report *report);

/** Adds the outlines of a picture to a cover of the view. Sides and walls with the liquid on one side are `thickness`
 *  [m] thick, lines without thickness as in the picture. */
void sph2d__walls_cover(sph2d__cover *cover, const sph2d__view *view, const sph2d_picture *picture, double thickness);

/** Covers the pixels of the mask by the outlines of a picture; again only if these have changed. */
void sph2d__walls_find(const sph2d__gl *gl, sph2d__walls *walls, const sph2d__view *view, const sph2d_picture *picture);

/** Draws the outlines that were found over the contents of `target` with the program "tiles", "mask". */
void sph2d__walls_draw(const sph2d__gl *gl, const sph2d__walls *walls, GLuint program, const sph2d__target *target,
                       const sph2d_picture *picture);

/** Frees it; it may be zeroed. */
void sph2d__walls_destroy(const sph2d__gl *gl, sph2d__walls *walls);

#endif
