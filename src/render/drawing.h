/* SPDX-License-Identifier: MIT */
/** @file drawing.h
 *  Draws a picture with the current context: background, liquid, walls, then what is written beside them. */
#ifndef SPH2D_RENDER_DRAWING_H
#define SPH2D_RENDER_DRAWING_H

#include "render/lines.h"
#include "render/metaballs.h"
#include "render/walls.h"

/** Colour bar, caption, notes. */
enum { SPH2D__TEXTS = 3 };

/** What drawing needs in OpenGL, for images of one size, style and look. */
typedef struct sph2d__drawing {
    int width, height; /**< [px] */
    sph2d_style style;
    sph2d_look look;
    bool transparent; /**< behind the liquid */
    bool shown;       /**< in the caller's framebuffer */
    sph2d__gl gl;
    sph2d__dots dots;
    GLuint points_program, mask_program;
    sph2d__metaballs metaballs;
    sph2d__walls walls;
    sph2d__lines lines;
    sph2d__scales scales; /**< of the lines of the last picture */
    sph2d__target target;
    sph2d__target patch;          /**< for text on what is shown, at its place */
    uint64_t marks[SPH2D__TEXTS]; /**< of what is in it */
} sph2d__drawing;

/** Where a picture is in the image, and what is beside it. */
typedef struct sph2d__layout {
    sph2d__view view;
    bool legend;      /**< a colour bar */
    int right, below; /**< columns and rows that are reserved [px] */
    double min, max;  /**< ends of the colour range */
} sph2d__layout;

/** Makes everything in the context that is current, whose functions are in `gl`. Errors: SPH2D_RENDER, SPH2D_NOINPUT,
 *  SPH2D_NOMEM. */
sph2d_status sph2d__drawing_create(sph2d__drawing *self, const char *shader_dir, sph2d_report *report);
void sph2d__drawing_destroy(sph2d__drawing *self);

/** Finds the layout of a picture that is valid. Errors: SPH2D_INVALID. */
sph2d_status sph2d__drawing_arrange(const sph2d__drawing *self, const sph2d_picture *picture, sph2d__layout *out,
                                    sph2d_report *report);

/** Draws background, liquid and walls into the target. Errors: SPH2D_RENDER, SPH2D_NOMEM. */
sph2d_status sph2d__drawing_paint(sph2d__drawing *self, const sph2d_picture *picture, const sph2d__layout *at,
                                  sph2d_report *report);

/** Writes the texts on pixels: 4 bytes each, the whole image. */
void sph2d__drawing_write(const sph2d__drawing *self, const sph2d_picture *picture, const sph2d__layout *at,
                          unsigned char *pixels);

/** The same in the target, with `pixels` as a scratch pad. */
void sph2d__drawing_write_to_target(sph2d__drawing *self, const sph2d_picture *picture, const sph2d__layout *at,
                                    unsigned char *pixels);

#endif
