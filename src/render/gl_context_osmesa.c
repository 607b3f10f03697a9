/* SPDX-License-Identifier: MIT */
/** @file gl_context_osmesa.c
 *  A context from OSMesa, Mesa's off-screen software renderer. <GL/osmesa.h> includes <GL/gl.h>, which conflicts with
 *  <GL/glcorearb.h>, so it must only be included in this file. */
#include "render/gl_context.h"

#ifdef SPH2D_HAVE_OSMESA

#include <GL/osmesa.h>
#include <stdio.h>
#include <stdlib.h>

/* OSMesa requires a colour buffer, which is not used: frames are drawn into framebuffer objects. */
enum { UNUSED_SIDE = 4 };

typedef struct osmesa {
    OSMesaContext context;
    unsigned char unused[UNUSED_SIDE * UNUSED_SIDE * 4];
} osmesa;

static bool make_current(void *impl)
{
    osmesa *self = impl;
    return OSMesaMakeCurrent(self->context, self->unused, GL_UNSIGNED_BYTE, UNUSED_SIDE, UNUSED_SIDE) == GL_TRUE;
}

static void release(void *impl)
{
    (void)impl;
    OSMesaMakeCurrent(NULL, NULL, GL_UNSIGNED_BYTE, 0, 0);
}

static sph2d__gl_proc get_proc(const char *name)
{
    return OSMesaGetProcAddress(name);
}

static void destroy(void *impl)
{
    osmesa *self = impl;
    OSMesaDestroyContext(self->context);
    free(self);
}

bool sph2d__gl_open_osmesa(sph2d__gl_context *context, char *why, size_t size)
{
    static const int attributes[] = {OSMESA_FORMAT,
                                     OSMESA_RGBA,
                                     OSMESA_PROFILE,
                                     OSMESA_CORE_PROFILE,
                                     OSMESA_CONTEXT_MAJOR_VERSION,
                                     3,
                                     OSMESA_CONTEXT_MINOR_VERSION,
                                     3,
                                     0};
    osmesa *self = calloc(1, sizeof *self);
    if (!self) {
        snprintf(why, size, "out of memory for an OSMesa context");
        return false;
    }
    self->context = OSMesaCreateContextAttribs(attributes, NULL);
    if (!self->context) {
        snprintf(why, size, "OSMesa gives no OpenGL 3.3 core context");
        free(self);
        return false;
    }
    *context = (sph2d__gl_context){"osmesa", self, make_current, release, get_proc, destroy};
    return true;
}

#else
typedef int sph2d__no_osmesa; /* a translation unit must not be empty */
#endif
