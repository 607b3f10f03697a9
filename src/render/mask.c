/* SPDX-License-Identifier: MIT */
/** @file mask.c
 *  Shapes of one colour, drawn by the tiles that they touch. */
#include "render/mask.h"

#include "render/shader.h"

sph2d_status sph2d__mask_create(const sph2d__gl *gl, sph2d__mask *mask, GLsizei width, GLsizei height,
                                sph2d_report *report)
{
    *mask = (sph2d__mask){0};
    const sph2d_status status = sph2d__tiles_create(&mask->tiles, width, height, report);
    if (status != SPH2D_OK)
        return status;
    if (!sph2d__cover_create(&mask->cover, width, height)) {
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL, "out of memory for drawing walls and lines");
        return SPH2D_NOMEM;
    }
    gl->GenTextures(1, &mask->texture);
    gl->BindTexture(GL_TEXTURE_2D, mask->texture);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl->BindTexture(GL_TEXTURE_2D, 0);
    return sph2d__gl_check(gl, "preparing to draw walls and lines", report);
}

void sph2d__mask_upload(const sph2d__gl *gl, sph2d__mask *mask)
{
    const sph2d__cover *cover = &mask->cover;
    gl->BindTexture(GL_TEXTURE_2D, mask->texture);
    gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_R8, cover->width, cover->height, 0, GL_RED, GL_UNSIGNED_BYTE, cover->pixels);
    gl->BindTexture(GL_TEXTURE_2D, 0);
    sph2d__tiles_find_bytes(&mask->tiles, cover->pixels, cover->width, cover->height);
}

void sph2d__mask_draw(const sph2d__gl *gl, const sph2d__mask *mask, GLuint program, sph2d__dots *dots,
                      const sph2d__target *target, const float color[4])
{
    sph2d__target_bind(gl, target);
    sph2d__target_blend(gl, target);
    gl->BindTexture(GL_TEXTURE_2D, mask->texture);
    gl->UseProgram(program);
    gl->Uniform4f(gl->GetUniformLocation(program, "ink"), color[0], color[1], color[2], color[3]);
    sph2d__program_set_int(gl, program, "cover", 0);
    sph2d__program_set_vec2(gl, program, "image_size", target->width, target->height);
    sph2d__program_set_float(gl, program, "tile", SPH2D__TILE);
    sph2d__tiles_draw(gl, &mask->tiles, dots, SPH2D__TILE_TOUCHED);
    gl->BindTexture(GL_TEXTURE_2D, 0);
}

void sph2d__mask_destroy(const sph2d__gl *gl, sph2d__mask *mask)
{
    gl->DeleteTextures(1, &mask->texture); /* 0 is ignored */
    sph2d__cover_destroy(&mask->cover);
    sph2d__tiles_destroy(&mask->tiles);
    *mask = (sph2d__mask){0};
}
