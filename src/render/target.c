/* SPDX-License-Identifier: MIT */
/** @file target.c
 *  Framebuffers: the image, and the float textures in which the metaballs' fields are summed. Tiles are point sprites,
 *  which the card chooses by itself: which of them are drawn is known to a texture. */
#include "render/target.h"

#include "render/gl_loader.h"

static const char *framebuffer_text(GLenum framebuffer_status)
{
    switch (framebuffer_status) {
    case GL_FRAMEBUFFER_UNDEFINED:
        return "there is no default framebuffer";
    case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT:
        return "an attachment is incomplete";
    case GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT:
        return "nothing is attached";
    case GL_FRAMEBUFFER_INCOMPLETE_DRAW_BUFFER:
        return "the draw buffer has no attachment";
    case GL_FRAMEBUFFER_INCOMPLETE_READ_BUFFER:
        return "the read buffer has no attachment";
    case GL_FRAMEBUFFER_UNSUPPORTED:
        return "the driver does not support this format";
    case GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE:
        return "the attachments differ in their samples";
    case GL_FRAMEBUFFER_INCOMPLETE_LAYER_TARGETS:
        return "the attachments differ in their layers";
    case 0:
        return "its status is not available";
    default:
        return "unknown reason";
    }
}

void sph2d__texture_prepare(const sph2d__gl *gl, GLuint texture, GLint filter)
{
    gl->BindTexture(GL_TEXTURE_2D, texture);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void sph2d__texture_bind(const sph2d__gl *gl, int unit, GLuint texture)
{
    gl->ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    gl->BindTexture(GL_TEXTURE_2D, texture);
}

/* Ends a creation: checks for errors and for completeness of the framebuffer. */
static sph2d_status finish(const sph2d__gl *gl, sph2d__target *target, const char *what, sph2d_report *report)
{
    sph2d_status status = sph2d__gl_check(gl, what, report);
    if (status == SPH2D_OK) {
        const GLenum complete = gl->CheckFramebufferStatus(GL_FRAMEBUFFER);
        if (complete != GL_FRAMEBUFFER_COMPLETE) {
            sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GL_FAILED, NULL,
                             "OpenGL failed while %s of %d x %d: %s (0x%04x)", what, (int)target->width,
                             (int)target->height, framebuffer_text(complete), (unsigned)complete);
            status = SPH2D_RENDER;
        }
    }
    if (status != SPH2D_OK)
        sph2d__target_destroy(gl, target);
    return status;
}

/* Drivers may have smaller limits than the renderer, and react differently to larger sizes, so the limit is checked. */
static sph2d_status check_limit(const sph2d__gl *gl, GLenum limit_name, GLsizei width, GLsizei height,
                                sph2d_report *report)
{
    GLint limit = 0;
    gl->GetIntegerv(limit_name, &limit);
    if (width <= limit && height <= limit)
        return SPH2D_OK;
    sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GL_FAILED, NULL,
                     "a picture of %d x %d is too large for this OpenGL, which draws up to %d x %d", (int)width,
                     (int)height, (int)limit, (int)limit);
    return SPH2D_RENDER;
}

/* Makes a texture of a format and attaches it to the framebuffer in use. */
static GLuint attach_texture(const sph2d__gl *gl, const sph2d__target *target, GLenum attachment, GLint format,
                             GLenum type, GLint filter)
{
    GLuint texture = 0;
    gl->GenTextures(1, &texture);
    sph2d__texture_prepare(gl, texture, filter);
    gl->TexImage2D(GL_TEXTURE_2D, 0, format, target->width, target->height, 0, GL_RGBA, type, NULL);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture, 0);
    gl->BindTexture(GL_TEXTURE_2D, 0);
    return texture;
}

static sph2d_status begin(const sph2d__gl *gl, sph2d__target *target, GLsizei width, GLsizei height,
                          sph2d_report *report)
{
    *target = (sph2d__target){.width = width, .height = height};
    const sph2d_status status = check_limit(gl, GL_MAX_TEXTURE_SIZE, width, height, report);
    if (status != SPH2D_OK)
        return status;
    gl->GenFramebuffers(1, &target->framebuffer);
    gl->BindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
    return SPH2D_OK;
}

sph2d_status sph2d__target_create_color(const sph2d__gl *gl, sph2d__target *target, GLsizei width, GLsizei height,
                                        sph2d_report *report)
{
    const sph2d_status status = begin(gl, target, width, height, report);
    if (status != SPH2D_OK)
        return status;
    target->texture = attach_texture(gl, target, GL_COLOR_ATTACHMENT0, GL_RGBA8, GL_UNSIGNED_BYTE, GL_NEAREST);
    return finish(gl, target, "making the picture", report);
}

static sph2d_status no_floats(sph2d_report *report)
{
    sph2d_report_add(
        report, SPH2D_ERROR, SPH2D_CODE_GL_FAILED, NULL,
        "metaballs are summed in textures of floats, into which this OpenGL ES cannot draw: it has neither "
        "GL_EXT_color_buffer_float nor GL_EXT_color_buffer_half_float");
    return SPH2D_RENDER;
}

sph2d_status sph2d__target_create_float(const sph2d__gl *gl, sph2d__target *target, int textures, GLint filter,
                                        GLsizei width, GLsizei height, sph2d_report *report)
{
    static const GLenum both[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    const GLint sum = gl->sum_bits == 32 ? GL_RGBA32F : GL_RGBA16F;
    const GLint smooth = gl->smooth_bits == 32 ? sum : GL_RGBA16F; /* that can be interpolated */
    const sph2d_status status = gl->sum_bits > 0 ? begin(gl, target, width, height, report) : no_floats(report);
    if (status != SPH2D_OK)
        return status;
    target->texture = attach_texture(gl, target, both[0], filter == GL_LINEAR ? smooth : sum, GL_FLOAT, filter);
    if (textures == 2)
        target->second = attach_texture(gl, target, both[1], smooth, GL_FLOAT, GL_LINEAR);
    gl->DrawBuffers(textures, both);
    return finish(gl, target, "making the field of the metaballs", report);
}

void sph2d__target_copy(const sph2d__gl *gl, const sph2d__target *from, sph2d__pixel_box source, GLuint framebuffer,
                        sph2d__pixel_box to, bool upside_down)
{
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, from->framebuffer);
    gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    const GLint top = to.y, bottom = to.y + to.height;
    gl->BlitFramebuffer(source.x, source.y, source.x + source.width, source.y + source.height, to.x,
                        upside_down ? bottom : top, to.x + to.width, upside_down ? top : bottom, GL_COLOR_BUFFER_BIT,
                        GL_NEAREST);
    gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

void sph2d__target_blend(const sph2d__gl *gl, const sph2d__target *target)
{
    gl->Enable(GL_BLEND);
    gl->BlendEquation(GL_FUNC_ADD);
    gl->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, target->transparent ? GL_ONE : GL_ZERO,
                          target->transparent ? GL_ONE_MINUS_SRC_ALPHA : GL_ONE);
}

void sph2d__target_begin_sum(const sph2d__gl *gl, const sph2d__target *target)
{
    sph2d__target_bind(gl, target);
    gl->ClearColor(0.0F, 0.0F, 0.0F, 0.0F);
    gl->Clear(GL_COLOR_BUFFER_BIT);
    gl->Enable(GL_BLEND);
    gl->BlendEquation(GL_FUNC_ADD);
    gl->BlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
}

void sph2d__target_bind(const sph2d__gl *gl, const sph2d__target *target)
{
    gl->BindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
    gl->Viewport(0, 0, target->width, target->height);
}

void sph2d__target_destroy(const sph2d__gl *gl, sph2d__target *target)
{
    gl->DeleteFramebuffers(1, &target->framebuffer); /* 0 is ignored */
    gl->DeleteTextures(1, &target->texture);
    gl->DeleteTextures(1, &target->second);
    *target = (sph2d__target){0};
}

/* ---- tiles ------------------------------------------------------------------------------------------------------- */

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
