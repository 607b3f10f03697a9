/* SPDX-License-Identifier: MIT */
/** @file dots.h
 *  Draws many squares, one a particle, with the program in use: what fills a square is the program's affair. */
#ifndef SPH2D_RENDER_DOTS_H
#define SPH2D_RENDER_DOTS_H

#include "render/gl_loader.h"
#include "render/view.h"

/** What a program reads for one particle: attribute 0 (vec2) and attribute 1 (vec4). */
typedef struct sph2d__dot {
    float pixel[2];         /**< centre [px] */
    unsigned char color[4]; /**< red, green, blue, opacity */
} sph2d__dot;

/** The vertex array that feeds them to OpenGL, and room for a part of them: memory does not grow with the particles. */
typedef struct sph2d__dots {
    GLuint vertex_array, buffer;
    sph2d__dot *part;
    size_t filled;
} sph2d__dots;

/** Which particles to draw. Positions that are not finite are skipped. */
typedef struct sph2d__dot_list {
    size_t count;
    const double *x, *y;    /**< [m] */
    double half_side;       /**< of a square [px]: what lies farther outside the image is skipped */
    unsigned char color[4]; /**< for all of them, where there are no values */
    const double *values;   /**< one a particle, coloured from `value_min` to `value_max`; NULL for none */
    double value_min, value_max;
} sph2d__dot_list;

/** Errors: SPH2D_NOMEM, SPH2D_RENDER. */
sph2d_status sph2d__dots_create(const sph2d__gl *gl, sph2d__dots *dots, sph2d_report *report);

/** Draws a list in its order with the program, target and blending in use. */
void sph2d__dots_draw(const sph2d__gl *gl, sph2d__dots *dots, const sph2d__view *view, const sph2d__dot_list *list);

/** The same one by one: begin, add as often as you like, end. */
void sph2d__dots_begin(const sph2d__gl *gl, sph2d__dots *dots);
void sph2d__dots_add(const sph2d__gl *gl, sph2d__dots *dots, const float pixel[2], const unsigned char color[4]);
void sph2d__dots_end(const sph2d__gl *gl, sph2d__dots *dots);

/** Frees it; zeros are fine. */
void sph2d__dots_destroy(const sph2d__gl *gl, sph2d__dots *dots);

#endif
