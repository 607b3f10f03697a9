/* SPDX-License-Identifier: MIT */
/** @file dots.h
 *  Draws one figure per particle with the shader program in use, which determines its pixels. */
#ifndef SPH2D_RENDER_DOTS_H
#define SPH2D_RENDER_DOTS_H

#include "render/gl_loader.h"
#include "render/view.h"

/** What a program reads for one particle: attribute 0 (vec2), attribute 1 (vec4) and attribute 2 (float). */
typedef struct sph2d__dot {
    float pixel[2];         /**< centre [px] */
    unsigned char color[4]; /**< red, green, blue, opacity */
    float across;           /**< of a row of squares: their number */
} sph2d__dot;

/** The figure around a centre, by its number of vertices, which a program distinguishes by gl_VertexID. */
typedef enum sph2d__figure { SPH2D__TRIANGLE = 3, SPH2D__SQUARE = 6 } sph2d__figure;

/** The vertex array, and a buffer for one draw call: memory does not grow with the number of particles. */
typedef struct sph2d__dots {
    GLuint vertex_array, buffer;
    sph2d__dot *batch;
    size_t filled; /**< vertices */
    sph2d__figure figure;
} sph2d__dots;

/** Which particles to draw. Positions that are not finite are skipped. */
typedef struct sph2d__dot_list {
    size_t count;
    const double *x, *y;    /**< [m] */
    double reach;           /**< radius of the figures [px]; those entirely outside the image are skipped */
    unsigned char color[4]; /**< of all particles, if there are no values */
    const double *values;   /**< one a particle, coloured from `value_min` to `value_max`; NULL for none */
    double value_min, value_max;
    bool diverging; /**< the colours of sph2d__colormap() */
} sph2d__dot_list;

/** Errors: SPH2D_NOMEM, SPH2D_RENDER. */
sph2d_status sph2d__dots_create(const sph2d__gl *gl, sph2d__dots *dots, sph2d_report *report);

/** Draws a list in its order, a triangle each, with the program, target and blending in use. */
void sph2d__dots_draw(const sph2d__gl *gl, sph2d__dots *dots, const sph2d__view *view, const sph2d__dot_list *list);

/** The same one by one: begin, add any number, end. */
void sph2d__dots_begin(const sph2d__gl *gl, sph2d__dots *dots, sph2d__figure figure);
void sph2d__dots_add(const sph2d__gl *gl, sph2d__dots *dots, const sph2d__dot *dot);
void sph2d__dots_end(const sph2d__gl *gl, sph2d__dots *dots);

/** Frees it; it may be zeroed. */
void sph2d__dots_destroy(const sph2d__gl *gl, sph2d__dots *dots);

#endif
