/* SPDX-License-Identifier: MIT */
/** @file points.c
 *  Draws round dots, the fluid particles in style points. */
#include "render/points.h"

#include <math.h>

#include "render/shader.h"

/* Smaller dots would be hard to see. */
static const double smallest_radius = 0.7; /* [px] */

void sph2d__points_draw(const sph2d__gl *gl, GLuint program, sph2d__dots *dots, const sph2d__target *target,
                        const sph2d__view *view, sph2d__dot_list list, double radius)
{
    const double pixels = fmax(radius * view->scale, smallest_radius);
    const sph2d__raster image = {target->width, target->height, 1.0, 0, 1};
    list.reach = pixels + 1.0; /* the soft edge */
    sph2d__dots_fill(gl, dots, view, &list);
    sph2d__target_bind(gl, target);
    sph2d__target_blend(gl, target);
    gl->UseProgram(program);
    sph2d__program_set_float(gl, program, "radius", pixels);
    sph2d__dots_draw(gl, dots, program, &image, list.reach);
}
