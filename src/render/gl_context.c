/* SPDX-License-Identifier: MIT */
/** @file gl_context.c
 *  Choice of the backend that provides an OpenGL context. */
#include "render/gl_context.h"

#include <stdio.h>
#include <string.h>

#include "render/gl_loader.h"
#include "sph2d/render.h"

/* A backend. `open` is NULL for one that is not in this build. */
typedef struct backend {
    const char *name;
    sph2d__gl_opener *open;
    const char *missing; /* hint if it is not in this build ... */
    const char *broken;  /* ... or if it does not work */
} backend;

#ifdef SPH2D_HAVE_OSMESA
#define OPEN_OSMESA sph2d__gl_open_osmesa
#define NAME_OSMESA "osmesa"
#else
#define OPEN_OSMESA NULL
#define NAME_OSMESA ""
#endif
#ifdef SPH2D_HAVE_EGL
#define OPEN_EGL sph2d__gl_open_egl
#define NAME_EGL "egl"
#else
#define OPEN_EGL NULL
#define NAME_EGL ""
#endif
#if defined(SPH2D_HAVE_OSMESA) && defined(SPH2D_HAVE_EGL)
#define BETWEEN " "
#else
#define BETWEEN ""
#endif

/* In order of preference. */
static const backend backends[] = {
    {"osmesa", OPEN_OSMESA, "install OSMesa (Debian: apt install libosmesa6-dev) and build sph2d again, or use egl",
     "install a Mesa whose OSMesa has OpenGL 3.3 (Debian: apt install libosmesa6), or use egl"},
    {"egl", OPEN_EGL,
     "install EGL (Debian: apt install libegl-dev libgl1-mesa-dri) and build sph2d again, or use osmesa",
     "install EGL with Mesa's drivers (Debian: apt install libegl1 libgl1-mesa-dri), or use osmesa"}};
enum { BACKENDS = sizeof backends / sizeof backends[0], WHY_SIZE = 140 };

const char *sph2d_render_backends(void)
{
    return NAME_OSMESA BETWEEN NAME_EGL;
}

/* Opens one context and loads its functions; the context is current afterwards. */
static bool open_one(const backend *from, sph2d__gl_context *context, sph2d__gl *gl, char *why, size_t size)
{
    if (!from->open) {
        snprintf(why, size, "this build of sph2d has no OpenGL from %s", from->name);
        return false;
    }
    if (!from->open(context, why, size))
        return false;
    bool opened = context->make_current(context->impl);
    if (!opened)
        snprintf(why, size, "the OpenGL context from %s cannot be used in this thread", from->name);
    else
        opened = sph2d__gl_load(gl, context, why, size);
    if (opened)
        return true;
    context->release(context->impl);
    context->destroy(context->impl);
    *context = (sph2d__gl_context){0};
    return false;
}

/* ---- the caller's context ---------------------------------------------------------------------------------------- */

static bool stay_current(void *impl)
{
    (void)impl;
    return true;
}

static void leave(void *impl)
{
    (void)impl;
}

sph2d_status sph2d__gl_borrow(sph2d_gl_loader get_proc_address, sph2d__gl_context *context, sph2d__gl *gl,
                              sph2d_report *report)
{
    static char impl; /* none, but not NULL */
    char why[WHY_SIZE];
    *context = (sph2d__gl_context){"current", &impl, stay_current, leave, get_proc_address, leave};
    if (sph2d__gl_load(gl, context, why, sizeof why))
        return SPH2D_OK;
    *context = (sph2d__gl_context){0};
    sph2d_diagnostic_hint(sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GL_FAILED, NULL, "%s", why),
                          "make a context of OpenGL 3.3, OpenGL ES 3.0 or newer current before the call");
    return SPH2D_RENDER;
}

sph2d_status sph2d__gl_open(const char *wanted, sph2d__gl_context *context, sph2d__gl *gl, sph2d_report *report)
{
    char why[BACKENDS][WHY_SIZE] = {""};
    const char *hint = NULL;
    for (size_t i = 0; i < BACKENDS; ++i) {
        const backend *from = &backends[i];
        if (wanted && strcmp(wanted, from->name) != 0)
            continue;
        if (open_one(from, context, gl, why[i], sizeof why[i]))
            return SPH2D_OK;
        hint = from->open ? from->broken : from->missing;
    }
    if (!hint) {
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL,
                         "unknown OpenGL backend '%s'; expected 'osmesa' or 'egl'", wanted);
        return SPH2D_INVALID;
    }
    if (!wanted)
        hint = "install a software OpenGL (Debian: apt install libosmesa6-dev, or libegl-dev and libgl1-mesa-dri) and "
               "build sph2d again";
    const char *between = why[0][0] != '\0' && why[1][0] != '\0' ? "; " : "";
    sph2d_diagnostic_hint(
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GL_MISSING, NULL, "%s%s%s", why[0], between, why[1]), "%s",
        hint);
    return SPH2D_RENDER;
}
