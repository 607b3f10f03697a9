/* SPDX-License-Identifier: MIT */
/** @file mask.c
 *  Shapes of one colour, drawn by the tiles that they touch. */
#include "render/mask.h"

#include <stdlib.h>
#include <string.h>

#include "render/gl_loader.h"

/* Texture units of the program. */
enum { COVER, KINDS };

sph2d_status sph2d__mask_create(const sph2d__gl *gl, sph2d__mask *mask, GLsizei width, GLsizei height,
                                sph2d_report *report)
{
    *mask = (sph2d__mask){.tiles = malloc((size_t)sph2d__tiles_count(width) * (size_t)sph2d__tiles_count(height))};
    if (!mask->tiles || !sph2d__cover_create(&mask->cover, width, height)) {
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL, "out of memory for drawing walls and lines");
        return SPH2D_NOMEM;
    }
    gl->GenTextures(1, &mask->texture);
    sph2d__texture_prepare(gl, mask->texture, GL_NEAREST);
    gl->GenTextures(1, &mask->kinds);
    sph2d__texture_prepare(gl, mask->kinds, GL_NEAREST);
    gl->BindTexture(GL_TEXTURE_2D, 0);
    return sph2d__gl_check(gl, "preparing to draw walls and lines", report);
}

static void find_tiles(sph2d__mask *mask)
{
    const sph2d__cover *cover = &mask->cover;
    const size_t columns = (size_t)sph2d__tiles_count(cover->width), width = (size_t)cover->width;
    memset(mask->tiles, SPH2D__TILE_EMPTY, columns * (size_t)sph2d__tiles_count(cover->height));
    for (int y = 0; y < cover->height; ++y) {
        const unsigned char *pixels = cover->pixels + (size_t)y * width;
        unsigned char *row = mask->tiles + (size_t)(y / SPH2D__TILE) * columns;
        for (size_t x = 0; x < width; ++x)
            row[x / SPH2D__TILE] |= pixels[x] ? SPH2D__TILE_TOUCHED : 0;
    }
}

/* Fills a texture with bytes. */
static void upload(const sph2d__gl *gl, GLuint texture, GLsizei width, GLsizei height, const unsigned char *bytes)
{
    gl->BindTexture(GL_TEXTURE_2D, texture);
    gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_R8, width, height, 0, GL_RED, GL_UNSIGNED_BYTE, bytes);
    gl->BindTexture(GL_TEXTURE_2D, 0);
}

void sph2d__mask_upload(const sph2d__gl *gl, sph2d__mask *mask)
{
    const GLsizei width = mask->cover.width, height = mask->cover.height;
    upload(gl, mask->texture, width, height, mask->cover.pixels);
    find_tiles(mask);
    upload(gl, mask->kinds, sph2d__tiles_count(width), sph2d__tiles_count(height), mask->tiles);
}

void sph2d__mask_draw(const sph2d__gl *gl, const sph2d__mask *mask, GLuint program, const sph2d__target *target,
                      const float color[4])
{
    sph2d__target_blend(gl, target);
    sph2d__texture_bind(gl, KINDS, mask->kinds);
    sph2d__texture_bind(gl, COVER, mask->texture);
    gl->UseProgram(program);
    gl->Uniform4f(gl->GetUniformLocation(program, "ink"), color[0], color[1], color[2], color[3]);
    sph2d__program_set_int(gl, program, "cover", COVER);
    sph2d__tiles_draw(gl, program, target, KINDS, SPH2D__TILE_TOUCHED);
    sph2d__texture_bind(gl, KINDS, 0);
    sph2d__texture_bind(gl, COVER, 0);
}

void sph2d__mask_destroy(const sph2d__gl *gl, sph2d__mask *mask)
{
    gl->DeleteTextures(1, &mask->texture); /* 0 is ignored */
    gl->DeleteTextures(1, &mask->kinds);
    sph2d__cover_destroy(&mask->cover);
    free(mask->tiles);
    *mask = (sph2d__mask){0};
}
