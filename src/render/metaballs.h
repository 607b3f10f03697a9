/* SPDX-License-Identifier: MIT */
/** @file metaballs.h
 *  Metaballs: sums the fields of all particles, and shades the sum as water. */
#ifndef SPH2D_RENDER_METABALLS_H
#define SPH2D_RENDER_METABALLS_H

#include "render/lumps.h"
#include "render/target.h"
#include "render/walls.h"

/** The field, the depth, mean colours. */
enum { SPH2D__METABALL_TEXTURES = 3 };

typedef struct sph2d__metaballs {
    sph2d_look look;
    GLuint programs[2]; /**< for tiles that have a surface, and for those inside */
    GLuint textures[SPH2D__METABALL_TEXTURES];
    sph2d__field_grid field; /**< one number a pixel, or four with colours */
    sph2d__field_grid depth; /**< coarser: the field of wide balls, a measure of the depth below the surface */
    sph2d__lumps lumps;
    unsigned char (*tints)[4]; /**< mean colours of the particles, one a pixel; NULL without colours */
    float (*rises)[4];         /**< scratch, on the grid of the depth */
    sph2d__cover walls;        /**< on the grid of the depth */
    sph2d__tiles tiles;
} sph2d__metaballs;

/** Errors: SPH2D_RENDER, SPH2D_NOINPUT, SPH2D_NOMEM. */
sph2d_status sph2d__metaballs_create(const sph2d__gl *gl, sph2d__metaballs *balls, const char *shader_dir,
                                     sph2d_look look, GLsizei width, GLsizei height, sph2d_report *report);

/** Draws a list of particles over the contents of `target`; the list's reach is set here. The radius R and the walls are
 *  those of the picture, and `walls` the texture of their cover. Errors: SPH2D_NOMEM. */
sph2d_status sph2d__metaballs_draw(const sph2d__gl *gl, sph2d__metaballs *balls, sph2d__dots *dots,
                                   const sph2d__target *target, const sph2d__view *view, sph2d__dot_list list,
                                   const sph2d_picture *picture, GLuint walls, sph2d_report *report);

/** Frees it; it may be zeroed. */
void sph2d__metaballs_destroy(const sph2d__gl *gl, sph2d__metaballs *balls);

#endif
