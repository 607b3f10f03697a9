/* SPDX-License-Identifier: MIT */
/** @file gl_context.h
 *  An off-screen OpenGL context behind four functions, implemented by gl_context_osmesa.c and gl_context_egl.c. Frames
 *  are drawn into framebuffer objects, so a context has no size. */
#ifndef SPH2D_RENDER_GL_CONTEXT_H
#define SPH2D_RENDER_GL_CONTEXT_H

#include <stdbool.h>
#include <stddef.h>

/** Any OpenGL function; cast it to its own type before the call. */
typedef void (*sph2d__gl_proc)(void);

typedef struct sph2d__gl_context {
    const char *name; /**< "osmesa" or "egl" */
    void *impl;
    bool (*make_current)(void *impl);             /**< in this thread */
    void (*release)(void *impl);                  /**< leaves this thread without a context */
    sph2d__gl_proc (*get_proc)(const char *name); /**< may be non-NULL for names that no OpenGL has */
    void (*destroy)(void *impl);
} sph2d__gl_context;

/** Opens a context of OpenGL 3.3 core or newer. On failure `why` has a message. */
typedef bool sph2d__gl_opener(sph2d__gl_context *context, char *why, size_t size);

sph2d__gl_opener sph2d__gl_open_osmesa;
sph2d__gl_opener sph2d__gl_open_egl;

#endif
