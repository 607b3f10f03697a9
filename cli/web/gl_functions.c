/* SPDX-License-Identifier: MIT */
/** @file gl_functions.c
 *  The OpenGL functions of a page by their names. A list of the renderer's own, since Emscripten's holds all there are, 50
 *  kB of script. */
#define GL_GLEXT_PROTOTYPES
#include <string.h>

#include "gl_functions.h"
#include "render/gl_loader.h"

static bool asks = true;

void page_gl_ask(bool ask)
{
    asks = ask;
}

/* Asking for errors waits until the picture is drawn, in another process. */
static GLenum get_error(void)
{
    return asks ? glGetError() : GL_NO_ERROR;
}

sph2d_gl_function page_gl_function(const char *name)
{
    static const struct row {
        const char *name;
        sph2d_gl_function function;
    } rows[] = {
#define ROW(function, type) {"gl" #function, (sph2d_gl_function)gl##function},
        SPH2D__GL_MAP(ROW)
#undef ROW
    };
    if (strcmp(name, "glGetError") == 0)
        return (sph2d_gl_function)get_error;
    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; ++k)
        if (strcmp(rows[k].name, name) == 0)
            return rows[k].function;
    return NULL;
}
