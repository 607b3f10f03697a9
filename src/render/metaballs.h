/* SPDX-License-Identifier: MIT */
/** @file metaballs.h
 *  Metaballs: sums the fields of all particles, and shades the sum as water. */
#ifndef SPH2D_RENDER_METABALLS_H
#define SPH2D_RENDER_METABALLS_H

#include "render/dots.h"
#include "render/target.h"
#include "render/walls.h"

typedef struct sph2d__metaballs {
    sph2d_look look;
    GLuint balls[2]; /**< programs of the first pass, without and with colours */
    GLuint looks[2]; /**< those of the second, for tiles that have a surface, and for those inside */
    GLuint depth_program, limits_program, kinds_program;
    GLsizei width, height; /**< [px] */
    bool colored;          /**< the field has a second texture for colours */
    sph2d__target field;   /**< the balls' sum, a texel for two by two pixels */
    sph2d__target sums;    /**< coarser: that of wide balls ... */
    sph2d__target depth;   /**< ... from which follow its rise and its mean, a measure of the depth below the surface */
    sph2d__target limits;  /**< of the field in cells ... */
    sph2d__target kinds;   /**< ... from which follow those of tiles */
    sph2d__cover cover;    /**< of walls on the coarser grid ... */
    sph2d__dots walls;     /**< ... and the balls that stand for them */
    uint64_t walls_mark;   /**< of the walls in these */
    double radius;         /**< R of the last sum [px] ... */
    double texel;          /**< ... and the side of a square of its depth [px] ... */
    GLsizei columns, rows; /**< ... of which there are so many */
} sph2d__metaballs;

/** Errors: SPH2D_RENDER, SPH2D_NOINPUT, SPH2D_NOMEM. */
sph2d_status sph2d__metaballs_create(const sph2d__gl *gl, sph2d__metaballs *balls, const char *shader_dir,
                                     sph2d_look look, GLsizei width, GLsizei height, sph2d_report *report);

/** Sums the balls of a list of particles, which `dots` take to the card; the list's reach is set here. The radius R and
 *  the walls are those of the picture, and `walls_mark` tells when these changed. Errors: SPH2D_RENDER, SPH2D_NOMEM. */
sph2d_status sph2d__metaballs_sum(const sph2d__gl *gl, sph2d__metaballs *balls, sph2d__dots *dots,
                                  const sph2d__view *view, sph2d__dot_list list, const sph2d_picture *picture,
                                  uint64_t walls_mark, sph2d_report *report);

/** Draws the last sum as a liquid over the contents of `target`; `walls` is the texture of the walls' cover. */
void sph2d__metaballs_shade(const sph2d__gl *gl, const sph2d__metaballs *balls, const sph2d__target *target,
                            const sph2d_picture *picture, GLuint walls);

/** Frees it; it may be zeroed. */
void sph2d__metaballs_destroy(const sph2d__gl *gl, sph2d__metaballs *balls);

#endif
