/* SPDX-License-Identifier: MIT */
/** @file dots.h
 *  Particles in a buffer of the card: they are handed over once a picture, and drawn as often as needed, as the balls of
 *  metaballs.h or as round dots. */
#ifndef SPH2D_RENDER_DOTS_H
#define SPH2D_RENDER_DOTS_H

#include "render/gl_loader.h"
#include "render/target.h"
#include "render/view.h"

/** What a program reads for one particle: attribute 0 (vec2) and attribute 1 (vec4). */
typedef struct sph2d__dot {
    float pixel[2];         /**< centre [px] */
    unsigned char color[4]; /**< red, green, blue, opacity */
} sph2d__dot;

/** The buffer, and how it is read. */
typedef struct sph2d__dots {
    GLuint vertex_array, buffer;
    size_t count; /**< of dots in the buffer */
} sph2d__dots;

/** Which particles to draw. Positions that are not finite are skipped. */
typedef struct sph2d__dot_list {
    size_t count;
    const double *x, *y;    /**< [m] */
    double reach;           /**< radius of the figures [px]; those entirely outside the image are skipped */
    unsigned char color[4]; /**< of all particles, if there are neither */
    const uint64_t *colors; /**< one a particle, if there are no values; NULL for none */
    const double *values;   /**< one a particle, coloured from `value_min` to `value_max`; NULL for none */
    double value_min, value_max;
    bool diverging; /**< the colours of sph2d__colormap() */
} sph2d__dot_list;

/** The texels that dots are drawn on: the pixels of an image, or coarser ones. */
typedef struct sph2d__raster {
    GLsizei columns, rows;
    double texel; /**< side of one [px] */
    int margin;   /**< so many of them lie beside the image, on each side */
    int parts;    /**< a texel has the values at the middles of so many squares by so many */
} sph2d__raster;

/** Red, green and blue of 65536 red + 256 green + blue. */
static inline void sph2d__color_split(uint64_t color, unsigned char parts[3])
{
    for (int k = 0; k < 3; ++k)
        parts[k] = (unsigned char)(color >> (16 - 8 * k) & 255);
}

/** Errors: SPH2D_RENDER. */
sph2d_status sph2d__dots_create(const sph2d__gl *gl, sph2d__dots *dots, sph2d_report *report);

/** Makes room for so many dots, and takes away those that were there. */
void sph2d__dots_reserve(const sph2d__gl *gl, sph2d__dots *dots, size_t count);

/** Adds dots. */
void sph2d__dots_add(const sph2d__gl *gl, sph2d__dots *dots, const sph2d__dot *added, size_t count);

/** Hands a list over, in its order, in place of what was there. */
void sph2d__dots_fill(const sph2d__gl *gl, sph2d__dots *dots, const sph2d__view *view, const sph2d__dot_list *list);

/** Draws them in their order with figures of a radius [px], by a program with the vertices of gradientball.vert, which is
 *  in use, and with the target and blending in use. */
void sph2d__dots_draw(const sph2d__gl *gl, const sph2d__dots *dots, GLuint program, const sph2d__raster *on,
                      double reach);

/** Frees it; it may be zeroed. */
void sph2d__dots_destroy(const sph2d__gl *gl, sph2d__dots *dots);

/** Draws a list over the contents of `target` with the program "points". `radius` is a dot's [m]; the list's reach is
 *  set here. */
void sph2d__points_draw(const sph2d__gl *gl, GLuint program, sph2d__dots *dots, const sph2d__target *target,
                        const sph2d__view *view, sph2d__dot_list list, double radius);

#endif
