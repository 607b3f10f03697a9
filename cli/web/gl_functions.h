/* SPDX-License-Identifier: MIT */
/** @file gl_functions.h
 *  The OpenGL functions of a page by their names. */
#ifndef SPH2D_CLI_WEB_GL_FUNCTIONS_H
#define SPH2D_CLI_WEB_GL_FUNCTIONS_H

#include <sph2d/render.h>

/** An sph2d_gl_loader. */
sph2d_gl_function page_gl_function(const char *name);

/** Whether glGetError asks the browser, or says that there is no error; true at first. */
void page_gl_ask(bool ask);

#endif
