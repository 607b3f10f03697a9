/* SPDX-License-Identifier: MIT */
/** @file gl_loader.c
 *  Loads OpenGL functions, and reports OpenGL errors. */
#include "render/gl_loader.h"

#include <stdio.h>
#include <string.h>

/* Not in the headers of OpenGL's core profile. */
#ifndef GL_ALIASED_POINT_SIZE_RANGE
#define GL_ALIASED_POINT_SIZE_RANGE 0x846D
#endif

/* OpenGL ES draws into floats, adds them up and interpolates them only by extensions. */
static void find_abilities(sph2d__gl *gl)
{
    const char *extensions = gl->es ? (const char *)gl->GetString(GL_EXTENSIONS) : NULL;
    const bool drawn = !gl->es || (extensions && strstr(extensions, "EXT_color_buffer_float"));
    const bool added = !gl->es || (extensions && strstr(extensions, "EXT_float_blend"));
    const bool half = drawn || (extensions && strstr(extensions, "EXT_color_buffer_half_float"));
    gl->sum_bits = drawn && added ? 32 : half ? 16 : 0;
    gl->smooth_bits = !gl->es || (extensions && strstr(extensions, "OES_texture_float_linear")) ? 32 : 16;
    GLint sides[2] = {0, 0};
    gl->GetIntegerv(gl->es ? GL_ALIASED_POINT_SIZE_RANGE : GL_POINT_SIZE_RANGE, sides);
    gl->largest_point = sides[1];
    gl->GetIntegerv(GL_MAX_VIEWPORT_DIMS, sides);
    gl->widest_viewport = sides[0] < sides[1] ? sides[0] : sides[1];
}

/* OSMesa returns a pointer for any name, so a pointer does not show that a function exists. The version is checked
 * first, by two functions that every OpenGL has. */
static bool check_version(sph2d__gl *gl, const sph2d__gl_context *context, char *why, size_t size)
{
    gl->GetIntegerv = (PFNGLGETINTEGERVPROC)context->get_proc("glGetIntegerv");
    gl->GetString = (PFNGLGETSTRINGPROC)context->get_proc("glGetString");
    if (!gl->GetIntegerv || !gl->GetString) {
        snprintf(why, size, "%s gives no OpenGL functions", context->name);
        return false;
    }
    const char *version = (const char *)gl->GetString(GL_VERSION);
    GLint major = 0, minor = 0;
    gl->GetIntegerv(GL_MAJOR_VERSION, &major);
    gl->GetIntegerv(GL_MINOR_VERSION, &minor);
    gl->es = version && strstr(version, "OpenGL ES");
    if (!version || major < 3 || (major == 3 && minor < 3 && !gl->es)) {
        snprintf(why, size, "OpenGL 3.3 or OpenGL ES 3.0 is needed, %s has %s", context->name,
                 version ? version : "none");
        return false;
    }
    find_abilities(gl);
    return true;
}

bool sph2d__gl_load(sph2d__gl *gl, const sph2d__gl_context *context, char *why, size_t size)
{
    if (!check_version(gl, context, why, size))
        return false;
#define SPH2D__GL_FETCH(function, type)                                                                                \
    gl->function = (type)context->get_proc("gl" #function);                                                            \
    if (!gl->function) {                                                                                               \
        snprintf(why, size, "OpenGL from %s lacks gl" #function, context->name);                                       \
        return false;                                                                                                  \
    }
    SPH2D__GL_MAP(SPH2D__GL_FETCH)
#undef SPH2D__GL_FETCH
    return true;
}

static const char *error_text(GLenum error)
{
    switch (error) {
    case GL_INVALID_ENUM:
        return "invalid enumerator";
    case GL_INVALID_VALUE:
        return "value out of range";
    case GL_INVALID_OPERATION:
        return "operation not allowed in this state";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
        return "incomplete framebuffer";
    case GL_OUT_OF_MEMORY:
        return "out of memory";
    default:
        return "unknown error";
    }
}

/* A lost context may report errors endlessly, so the loop is limited. */
enum { ERRORS_MAX = 32 };

void sph2d__gl_clear_errors(const sph2d__gl *gl)
{
    for (int i = 0; i < ERRORS_MAX && gl->GetError() != GL_NO_ERROR; ++i)
        continue;
}

sph2d_status sph2d__gl_check(const sph2d__gl *gl, const char *what, sph2d_report *report)
{
    const GLenum error = gl->GetError();
    if (error == GL_NO_ERROR)
        return SPH2D_OK;
    sph2d__gl_clear_errors(gl);
    sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GL_FAILED, NULL, "OpenGL failed while %s: %s (0x%04x)", what,
                     error_text(error), (unsigned)error);
    return error == GL_OUT_OF_MEMORY ? SPH2D_NOMEM : SPH2D_RENDER;
}
