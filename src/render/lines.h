/* SPDX-License-Identifier: MIT */
/** @file lines.h
 *  Lines over the liquid: arrows of its velocity, paths and isolines of a field (lines_find.c), evenly spaced streamlines of the
 *  velocity of the moment (streamlines.c). */
#ifndef SPH2D_RENDER_LINES_H
#define SPH2D_RENDER_LINES_H

#include "render/mask.h"
#include "render/sampled.h"
#include "render/view.h"

/** A straight piece of a line, in pixels. */
typedef struct sph2d__piece {
    sph2d_vec2 from, to;
    double wider;  /**< where it begins: the head of an arrow */
    bool has_next; /**< others go on from its ends, which are cut off; else they go on for half its width */
} sph2d__piece;

typedef struct sph2d__lines {
    sph2d__mask mask;
    sph2d__sampled sampled;
    sph2d__piece *pieces;
    size_t count, capacity;
    bool failed; /**< for want of memory */
} sph2d__lines;

/** What the numbers of a picture became. */
typedef struct sph2d__scales {
    double arrow_pixels, arrow_speed; /**< an arrow's length and its speed [m/s], a round number; 0: no arrows */
    double level_step;                /**< from isoline to isoline; 0: none */
} sph2d__scales;

/** Errors: SPH2D_NOMEM, SPH2D_RENDER. */
sph2d_status sph2d__lines_create(const sph2d__gl *gl, sph2d__lines *lines, GLsizei width, GLsizei height,
                                 sph2d_report *report);

/** Finds the isolines, streamlines, arrows and paths of a picture, whose walls cover the image. Errors: SPH2D_NOMEM. */
sph2d_status sph2d__lines_find(sph2d__lines *lines, const sph2d__view *view, const sph2d_picture *picture,
                               const sph2d__cover *walls, sph2d__scales *scales, sph2d_report *report);

/** Adds a piece. Sets `failed` when memory is short. */
void sph2d__lines_add(sph2d__lines *lines, const sph2d__piece *piece);

/** The part of the plane that an image shows. */
sph2d_box sph2d__lines_box(const sph2d__view *view);

/** Draws what was found, dark with a light edge, over the contents of `target` with the program "tiles", "mask". */
void sph2d__lines_draw(const sph2d__gl *gl, sph2d__lines *lines, GLuint program, const sph2d__target *target);

/** Frees it; it may be zeroed. */
void sph2d__lines_destroy(const sph2d__gl *gl, sph2d__lines *lines);

/** Adds the streamlines of a picture and their heads to `lines`, the same ones for the same picture; each line is followed
 *  by its heads. They end where `walls` covers half a pixel. Sets `failed` when memory is short. */
void sph2d__streamlines_find(sph2d__lines *lines, const sph2d__view *view, const sph2d_picture *picture,
                             const sph2d__cover *walls);

#endif
