/* SPDX-License-Identifier: MIT */
/** @file points.c
 *  Draws round dots: fluid particles in style points, boundary particles in all styles. */
#include "render/points.h"

#include <math.h>

#include "render/shader.h"

/* Smaller dots would be hard to see. */
static const double smallest_radius = 0.7; /* [px] */

void sph2d__points_draw(const sph2d__gl *gl, GLuint program, sph2d__dots *dots, const sph2d__target *target,
                        const sph2d__view *view, sph2d__dot_list list, double radius)
{
    const double pixels = fmax(radius * view->scale, smallest_radius);
    list.reach = pixels + 1.0; /* the soft edge */
    sph2d__target_bind(gl, target);
    sph2d__target_blend(gl, target);
    gl->UseProgram(program);
    sph2d__program_set_vec2(gl, program, "image_size", view->width, view->height);
    sph2d__program_set_float(gl, program, "radius", pixels);
    sph2d__dots_draw(gl, dots, view, &list);
}
