/* SPDX-License-Identifier: MIT */
/** @file gl_context_egl.c
 *  A context from EGL on Mesa's surfaceless platform: no window system, no surface, no configuration. Without a
 *  graphics card Mesa draws in software, with the same code as OSMesa. */
#include "render/gl_context.h"

#ifdef SPH2D_HAVE_EGL

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct egl {
    EGLDisplay display;
    EGLContext context;
    bool counted; /* the display counts references: it may be terminated */
} egl;

/* Compares whole words: one extension's name may be the start of another's. */
static bool has_extension(EGLDisplay display, const char *name)
{
    const char *list = eglQueryString(display, EGL_EXTENSIONS);
    const size_t length = strlen(name);
    while (list && *list != '\0') {
        const size_t word = strcspn(list, " ");
        if (word == length && strncmp(list, name, length) == 0)
            return true;
        list += word;
        list += strspn(list, " ");
    }
    return false;
}

static bool make_current(void *impl)
{
    egl *self = impl;
    /* The API is bound per thread, and the calling program may have bound another. */
    return eglBindAPI(EGL_OPENGL_API) == EGL_TRUE &&
           eglMakeCurrent(self->display, EGL_NO_SURFACE, EGL_NO_SURFACE, self->context) == EGL_TRUE;
}

static void release(void *impl)
{
    egl *self = impl;
    eglMakeCurrent(self->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

static sph2d__gl_proc get_proc(const char *name)
{
    return eglGetProcAddress(name);
}

static void destroy(void *impl)
{
    egl *self = impl;
    if (self->context != EGL_NO_CONTEXT)
        eglDestroyContext(self->display, self->context);
    /* All renderers of a process share one display. If it does not count references, terminating it would destroy the
     * others' contexts, so it stays open until the process ends. */
    if (self->counted)
        eglTerminate(self->display);
    free(self);
}

/* Steps of opening; each returns NULL or an error message. */
static const char *open_display(egl *self)
{
    if (!has_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
        return "this EGL has no surfaceless platform (EGL_MESA_platform_surfaceless)";
    const bool can_count = has_extension(EGL_NO_DISPLAY, "EGL_KHR_display_reference");
    const EGLAttrib count[] = {EGL_TRACK_REFERENCES_KHR, EGL_TRUE, EGL_NONE};
    self->display =
        eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, (void *)EGL_DEFAULT_DISPLAY, can_count ? count : NULL);
    if (self->display == EGL_NO_DISPLAY)
        return "EGL gives no surfaceless display";
    if (eglInitialize(self->display, NULL, NULL) != EGL_TRUE)
        return "EGL finds no driver for its surfaceless display";
    self->counted = can_count;
    return NULL;
}

static const char *open_context(egl *self)
{
    static const EGLint attributes[] = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    if (!has_extension(self->display, "EGL_KHR_no_config_context") ||
        !has_extension(self->display, "EGL_KHR_surfaceless_context"))
        return "this EGL cannot make a context without a surface";
    if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE)
        return "this EGL has no desktop OpenGL";
    self->context = eglCreateContext(self->display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (self->context == EGL_NO_CONTEXT)
        return "EGL gives no OpenGL 3.3 core context";
    return NULL;
}

bool sph2d__gl_open_egl(sph2d__gl_context *context, char *why, size_t size)
{
    egl *self = calloc(1, sizeof *self);
    if (!self) {
        snprintf(why, size, "out of memory for an EGL context");
        return false;
    }
    const char *missing = open_display(self);
    if (!missing)
        missing = open_context(self);
    if (missing) {
        snprintf(why, size, "%s (EGL error 0x%04x)", missing, (unsigned)eglGetError());
        destroy(self);
        return false;
    }
    *context = (sph2d__gl_context){"egl", self, make_current, release, get_proc, destroy};
    return true;
}

#else
typedef int sph2d__no_egl; /* a translation unit must not be empty */
#endif
