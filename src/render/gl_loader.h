/* SPDX-License-Identifier: MIT */
/** @file gl_loader.h
 *  The OpenGL functions in use, one line each, loaded from the current context; and programs of them from GLSL text, built in
 *  or in a folder (shader.c). */
#ifndef SPH2D_RENDER_GL_LOADER_H
#define SPH2D_RENDER_GL_LOADER_H

#include <GL/glcorearb.h>

#include "render/gl_context.h"
#include "sph2d/render.h"

/** Name without `gl`, type. */
#define SPH2D__GL_MAP(X)                                                                                               \
    X(ActiveTexture, PFNGLACTIVETEXTUREPROC)                                                                           \
    X(AttachShader, PFNGLATTACHSHADERPROC)                                                                             \
    X(BindBuffer, PFNGLBINDBUFFERPROC)                                                                                 \
    X(BindFramebuffer, PFNGLBINDFRAMEBUFFERPROC)                                                                       \
    X(BindTexture, PFNGLBINDTEXTUREPROC)                                                                               \
    X(BindVertexArray, PFNGLBINDVERTEXARRAYPROC)                                                                       \
    X(BlendEquation, PFNGLBLENDEQUATIONPROC)                                                                           \
    X(BlendFuncSeparate, PFNGLBLENDFUNCSEPARATEPROC)                                                                   \
    X(BlitFramebuffer, PFNGLBLITFRAMEBUFFERPROC)                                                                       \
    X(BufferData, PFNGLBUFFERDATAPROC)                                                                                 \
    X(BufferSubData, PFNGLBUFFERSUBDATAPROC)                                                                           \
    X(CheckFramebufferStatus, PFNGLCHECKFRAMEBUFFERSTATUSPROC)                                                         \
    X(Clear, PFNGLCLEARPROC)                                                                                           \
    X(ClearColor, PFNGLCLEARCOLORPROC)                                                                                 \
    X(CompileShader, PFNGLCOMPILESHADERPROC)                                                                           \
    X(CreateProgram, PFNGLCREATEPROGRAMPROC)                                                                           \
    X(CreateShader, PFNGLCREATESHADERPROC)                                                                             \
    X(DeleteBuffers, PFNGLDELETEBUFFERSPROC)                                                                           \
    X(DeleteFramebuffers, PFNGLDELETEFRAMEBUFFERSPROC)                                                                 \
    X(DeleteProgram, PFNGLDELETEPROGRAMPROC)                                                                           \
    X(DeleteShader, PFNGLDELETESHADERPROC)                                                                             \
    X(DeleteTextures, PFNGLDELETETEXTURESPROC)                                                                         \
    X(DeleteVertexArrays, PFNGLDELETEVERTEXARRAYSPROC)                                                                 \
    X(Disable, PFNGLDISABLEPROC)                                                                                       \
    X(DrawArrays, PFNGLDRAWARRAYSPROC)                                                                                 \
    X(DrawArraysInstanced, PFNGLDRAWARRAYSINSTANCEDPROC)                                                               \
    X(DrawBuffers, PFNGLDRAWBUFFERSPROC)                                                                               \
    X(Enable, PFNGLENABLEPROC)                                                                                         \
    X(EnableVertexAttribArray, PFNGLENABLEVERTEXATTRIBARRAYPROC)                                                       \
    X(Finish, PFNGLFINISHPROC)                                                                                         \
    X(FramebufferTexture2D, PFNGLFRAMEBUFFERTEXTURE2DPROC)                                                             \
    X(GenBuffers, PFNGLGENBUFFERSPROC)                                                                                 \
    X(GenFramebuffers, PFNGLGENFRAMEBUFFERSPROC)                                                                       \
    X(GenTextures, PFNGLGENTEXTURESPROC)                                                                               \
    X(GenVertexArrays, PFNGLGENVERTEXARRAYSPROC)                                                                       \
    X(GetError, PFNGLGETERRORPROC)                                                                                     \
    X(GetIntegerv, PFNGLGETINTEGERVPROC)                                                                               \
    X(GetProgramInfoLog, PFNGLGETPROGRAMINFOLOGPROC)                                                                   \
    X(GetProgramiv, PFNGLGETPROGRAMIVPROC)                                                                             \
    X(GetShaderInfoLog, PFNGLGETSHADERINFOLOGPROC)                                                                     \
    X(GetShaderiv, PFNGLGETSHADERIVPROC)                                                                               \
    X(GetString, PFNGLGETSTRINGPROC)                                                                                   \
    X(GetUniformLocation, PFNGLGETUNIFORMLOCATIONPROC)                                                                 \
    X(LinkProgram, PFNGLLINKPROGRAMPROC)                                                                               \
    X(PixelStorei, PFNGLPIXELSTOREIPROC)                                                                               \
    X(ReadPixels, PFNGLREADPIXELSPROC)                                                                                 \
    X(Scissor, PFNGLSCISSORPROC)                                                                                       \
    X(ShaderSource, PFNGLSHADERSOURCEPROC)                                                                             \
    X(TexImage2D, PFNGLTEXIMAGE2DPROC)                                                                                 \
    X(TexParameteri, PFNGLTEXPARAMETERIPROC)                                                                           \
    X(TexSubImage2D, PFNGLTEXSUBIMAGE2DPROC)                                                                           \
    X(Uniform1f, PFNGLUNIFORM1FPROC)                                                                                   \
    X(Uniform1i, PFNGLUNIFORM1IPROC)                                                                                   \
    X(Uniform2f, PFNGLUNIFORM2FPROC)                                                                                   \
    X(Uniform2i, PFNGLUNIFORM2IPROC)                                                                                   \
    X(Uniform4f, PFNGLUNIFORM4FPROC)                                                                                   \
    X(UseProgram, PFNGLUSEPROGRAMPROC)                                                                                 \
    X(VertexAttribDivisor, PFNGLVERTEXATTRIBDIVISORPROC)                                                               \
    X(VertexAttribPointer, PFNGLVERTEXATTRIBPOINTERPROC)                                                               \
    X(Viewport, PFNGLVIEWPORTPROC)

/** One context's functions: gl->Clear(...); and what it can do. */
typedef struct sph2d__gl {
#define SPH2D__GL_MEMBER(name, type) type name;
    SPH2D__GL_MAP(SPH2D__GL_MEMBER)
#undef SPH2D__GL_MEMBER
    bool es;               /**< OpenGL ES, as in browsers */
    int sum_bits;          /**< of the floats that draw calls can be added up in: 32, 16 or 0 for none */
    int smooth_bits;       /**< of the floats that textures can interpolate: 32 or 16 */
    GLint largest_point;   /**< side of a point [px] */
    GLint widest_viewport; /**< or highest [px] */
    GLuint
        no_vertices; /**< a vertex array without arrays, for shaders that need none; made by sph2d__drawing_create() */
} sph2d__gl;

/** Opens the context "osmesa" or "egl", or with NULL the first that works, makes it current and loads its functions.
 *  Errors: SPH2D_INVALID (another name), SPH2D_RENDER. */
sph2d_status sph2d__gl_open(const char *wanted, sph2d__gl_context *context, sph2d__gl *gl, sph2d_report *report);

/** Takes the caller's context, which is current and stays so. Errors: SPH2D_RENDER. */
sph2d_status sph2d__gl_borrow(sph2d_gl_loader get_proc_address, sph2d__gl_context *context, sph2d__gl *gl,
                              sph2d_report *report);

/** Fills `gl` from the current context and checks that it is OpenGL 3.3 or OpenGL ES 3.0, or newer. On failure `why` has a message. */
bool sph2d__gl_load(sph2d__gl *gl, const sph2d__gl_context *context, char *why, size_t size);

/** Clears OpenGL's pending errors, so that the next sph2d__gl_check reports only new ones. */
void sph2d__gl_clear_errors(const sph2d__gl *gl);

/** Reports the errors since the last call: "OpenGL failed while WHAT: ...". Errors: SPH2D_RENDER, SPH2D_NOMEM. */
sph2d_status sph2d__gl_check(const sph2d__gl *gl, const char *what, sph2d_report *report);

/* ---- programs ---------------------------------------------------------------------------------------------------- */

/** Builds names[0].vert and names[1].frag, the built-in text or, where `dir` is not NULL, the files in that folder.
 *  `defined` is a name that the preprocessor knows in both, NULL for none; it follows the first line, "#version", and may
 *  have more lines of the preprocessor, 80 characters in all. Each message of the compiler becomes a diagnostic with the
 *  line of the GLSL. The caller deletes *program; 0 after a failure. Errors: SPH2D_RENDER, SPH2D_NOINPUT, SPH2D_NOMEM. */
sph2d_status sph2d__program_build(const sph2d__gl *gl, const char *dir, const char *names[2], const char *defined,
                                  GLuint *program, sph2d_report *report);

/** Set a uniform of the program in use by name. A missing one is no error, for shaders under development. */
void sph2d__program_set_int(const sph2d__gl *gl, GLuint program, const char *name, int value);
void sph2d__program_set_float(const sph2d__gl *gl, GLuint program, const char *name, double value);
void sph2d__program_set_vec2(const sph2d__gl *gl, GLuint program, const char *name, double x, double y);

#endif
