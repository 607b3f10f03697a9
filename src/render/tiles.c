/* SPDX-License-Identifier: MIT */
/** @file tiles.c
 *  Draws tiles as point sprites, which the card chooses by itself: which of them are drawn is known to a texture. */
#include "render/tiles.h"

#include "render/shader.h"

GLsizei sph2d__tiles_count(GLsizei pixels)
{
    return (pixels + SPH2D__TILE - 1) / SPH2D__TILE;
}

void sph2d__tiles_draw(const sph2d__gl *gl, GLuint program, const sph2d__target *target, int kinds, int kind)
{
    const GLsizei columns = sph2d__tiles_count(target->width), rows = sph2d__tiles_count(target->height);
    sph2d__target_bind(gl, target);
    gl->Viewport(0, 0, columns * SPH2D__TILE, rows * SPH2D__TILE);
    gl->BindVertexArray(gl->no_vertices);
    sph2d__program_set_int(gl, program, "kinds", kinds);
    sph2d__program_set_int(gl, program, "kind", kind);
    sph2d__program_set_float(gl, program, "tile", SPH2D__TILE);
    gl->DrawArrays(GL_POINTS, 0, columns * rows);
}
