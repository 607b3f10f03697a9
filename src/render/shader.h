/* SPDX-License-Identifier: MIT */
/** @file shader.h
 *  Shader programs from GLSL text, built in or in a folder. */
#ifndef SPH2D_RENDER_SHADER_H
#define SPH2D_RENDER_SHADER_H

#include "render/gl_loader.h"

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
