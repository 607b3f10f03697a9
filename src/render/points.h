/* SPDX-License-Identifier: MIT */
/** @file points.h
 *  Particles as round dots. */
#ifndef SPH2D_RENDER_POINTS_H
#define SPH2D_RENDER_POINTS_H

#include "render/dots.h"
#include "render/target.h"

/** Draws a list over the contents of `target` with the program "points". `radius` is a dot's [m]; the list's reach is
 *  set here. */
void sph2d__points_draw(const sph2d__gl *gl, GLuint program, sph2d__dots *dots, const sph2d__target *target,
                        const sph2d__view *view, sph2d__dot_list list, double radius);

#endif
