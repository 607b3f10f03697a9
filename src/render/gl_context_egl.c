/* SPDX-License-Identifier: MIT */
/** @file gl_context_egl.c
 *  A context from EGL: no window system, no surface, no configuration. It is that of the first graphics card that works
 *  without a display, of any maker; else that of Mesa's surfaceless platform, which without a card draws in software, with
 *  the same code as OSMesa; else that of a device that draws in software. */
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

/* Whether a list of extensions, which may be NULL, has one: whole words, as one's name may be the start of another's. */
static bool has_word(const char *list, const char *name)
{
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

static bool has_extension(EGLDisplay display, const char *name)
{
    return has_word(eglQueryString(display, EGL_EXTENSIONS), name);
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

/* ---- displays ---------------------------------------------------------------------------------------------------- */

/* Steps of opening; each returns NULL or an error message. */
static const char *open_display(egl *self, EGLenum platform, void *native)
{
    const bool can_count = has_extension(EGL_NO_DISPLAY, "EGL_KHR_display_reference");
    const EGLAttrib count[] = {EGL_TRACK_REFERENCES_KHR, EGL_TRUE, EGL_NONE};
    self->display = eglGetPlatformDisplay(platform, native, can_count ? count : NULL);
    if (self->display == EGL_NO_DISPLAY)
        return "EGL gives no display";
    if (eglInitialize(self->display, NULL, NULL) != EGL_TRUE)
        return "EGL finds no driver for its display";
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

static void close_all(egl *self)
{
    if (self->context != EGL_NO_CONTEXT)
        eglDestroyContext(self->display, self->context);
    /* All renderers of a process share one display. If it does not count references, terminating it would destroy the
     * others' contexts, so it stays open until the process ends. */
    if (self->counted)
        eglTerminate(self->display);
    *self = (egl){0};
}

static void destroy(void *impl)
{
    close_all(impl);
    free(impl);
}

/* Tries a display. On failure `why` has the reason, unless an earlier failure has told one. */
static bool open_one(egl *self, EGLenum platform, void *native, char *why, size_t size)
{
    const char *missing = open_display(self, platform, native);
    if (!missing)
        missing = open_context(self);
    if (!missing)
        return true;
    if (why[0] == '\0')
        snprintf(why, size, "%s (EGL error 0x%04x)", missing, (unsigned)eglGetError());
    close_all(self);
    return false;
}

/* Tries the graphics devices that draw in software, or those that do not. */
static bool open_device(egl *self, bool software, char *why, size_t size)
{
    enum { DEVICES = 32 };
    EGLDeviceEXT devices[DEVICES];
    EGLint count = 0;
    if (!has_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device") ||
        !(has_extension(EGL_NO_DISPLAY, "EGL_EXT_device_base") ||
          (has_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration") &&
           has_extension(EGL_NO_DISPLAY, "EGL_EXT_device_query"))))
        return false;
    const PFNEGLQUERYDEVICESEXTPROC query = (PFNEGLQUERYDEVICESEXTPROC)eglGetProcAddress("eglQueryDevicesEXT");
    const PFNEGLQUERYDEVICESTRINGEXTPROC describe =
        (PFNEGLQUERYDEVICESTRINGEXTPROC)eglGetProcAddress("eglQueryDeviceStringEXT");
    if (!query || !describe || query(DEVICES, devices, &count) != EGL_TRUE)
        return false;
    for (EGLint k = 0; k < count; ++k)
        if (has_word(describe(devices[k], EGL_EXTENSIONS), "EGL_MESA_device_software") == software &&
            open_one(self, EGL_PLATFORM_DEVICE_EXT, devices[k], why, size))
            return true;
    return false;
}

bool sph2d__gl_open_egl(sph2d__gl_context *context, char *why, size_t size)
{
    egl *self = calloc(1, sizeof *self);
    if (!self) {
        snprintf(why, size, "out of memory for an EGL context");
        return false;
    }
    char of_cards[2] = ""; /* why no card can be used does not matter where something else can */
    why[0] = '\0';
    const bool opened = open_device(self, false, of_cards, sizeof of_cards) ||
                        (has_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless") &&
                         open_one(self, EGL_PLATFORM_SURFACELESS_MESA, (void *)EGL_DEFAULT_DISPLAY, why, size)) ||
                        open_device(self, true, why, size);
    if (opened) {
        *context = (sph2d__gl_context){"egl", self, make_current, release, get_proc, destroy};
        return true;
    }
    if (why[0] == '\0')
        snprintf(why, size, "this EGL %s",
                 of_cards[0] ? "cannot use the graphics cards, and has no other display"
                             : "finds neither a graphics card nor Mesa's surfaceless platform");
    free(self);
    return false;
}

#else
typedef int sph2d__no_egl; /* a translation unit must not be empty */
#endif
