/* SPDX-License-Identifier: MIT */
/** @file dots.c
 *  Particles as point sprites: one vertex and the fewest pixels each, which takes 0.6 of the time of triangles in a
 *  software renderer. Points have a largest size, though; larger ones are triangles around the same particles. */
#include "render/dots.h"

#include <math.h>
#include <string.h>

#include "render/gl_loader.h"
#include "render/legend.h"

sph2d_status sph2d__dots_create(const sph2d__gl *gl, sph2d__dots *dots, sph2d_report *report)
{
    *dots = (sph2d__dots){0};
    gl->GenVertexArrays(1, &dots->vertex_array);
    gl->BindVertexArray(dots->vertex_array);
    gl->GenBuffers(1, &dots->buffer);
    gl->BindBuffer(GL_ARRAY_BUFFER, dots->buffer);
    const GLsizei stride = sizeof(sph2d__dot);
    gl->EnableVertexAttribArray(0);
    gl->VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, stride, (const void *)offsetof(sph2d__dot, pixel));
    gl->EnableVertexAttribArray(1);
    gl->VertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride, (const void *)offsetof(sph2d__dot, color));
    return sph2d__gl_check(gl, "preparing to draw particles", report);
}

/* ---- the buffer -------------------------------------------------------------------------------------------------- */

void sph2d__dots_reserve(const sph2d__gl *gl, sph2d__dots *dots, size_t count)
{
    gl->BindBuffer(GL_ARRAY_BUFFER, dots->buffer);
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(count * sizeof(sph2d__dot)), NULL, GL_STREAM_DRAW);
    dots->count = 0;
}

void sph2d__dots_add(const sph2d__gl *gl, sph2d__dots *dots, const sph2d__dot *added, size_t count)
{
    if (count > 0)
        gl->BufferSubData(GL_ARRAY_BUFFER, (GLintptr)(dots->count * sizeof *added), (GLsizeiptr)(count * sizeof *added),
                          added);
    dots->count += count;
}

static void color_dot(const sph2d__dot_list *list, size_t i, unsigned char color[4])
{
    const double span = list->value_max - list->value_min;
    if (list->values)
        sph2d__colormap((list->values[i] - list->value_min) / span, list->diverging, color);
    else
        memcpy(color, list->color, sizeof list->color);
    if (list->colors && !list->values)
        sph2d__color_split(list->colors[i], color);
}

void sph2d__dots_fill(const sph2d__gl *gl, sph2d__dots *dots, const sph2d__view *view, const sph2d__dot_list *list)
{
    enum { BATCH = 1024 };
    sph2d__dot batch[BATCH];
    size_t filled = 0;
    sph2d__dots_reserve(gl, dots, list->count);
    for (size_t i = 0; i < list->count; ++i) {
        sph2d__dot *dot = &batch[filled];
        if (!sph2d__view_place(view, list->x[i], list->y[i], list->reach, dot->pixel))
            continue;
        color_dot(list, i, dot->color);
        if (++filled == BATCH) {
            sph2d__dots_add(gl, dots, batch, filled);
            filled = 0;
        }
    }
    sph2d__dots_add(gl, dots, batch, filled);
}

/* ---- drawing ----------------------------------------------------------------------------------------------------- */

/* A point whose centre is outside the viewport is not drawn at all, so the viewport becomes larger than the target. */
void sph2d__dots_draw(const sph2d__gl *gl, const sph2d__dots *dots, GLuint program, const sph2d__raster *on,
                      double reach)
{
    const double off = 0.5 - 0.5 / on->parts; /* a texel's squares are so far from its middle, to the side and down */
    double radius = reach / on->texel + off;
    const double wide = fmax(on->columns, on->rows) + 2.0 * ceil(radius);
    const bool points = 2.0 * radius <= gl->largest_point && wide <= gl->widest_viewport;
    radius += points ? 0.0 : (sqrt(2.0) - 1.0) * off;
    const GLsizei beyond = points ? (GLsizei)ceil(radius) : 0;
    gl->Viewport(-beyond, -beyond, on->columns + 2 * beyond, on->rows + 2 * beyond);
    sph2d__program_set_vec2(gl, program, "grid", on->columns, on->rows);
    sph2d__program_set_float(gl, program, "texel", on->texel);
    sph2d__program_set_float(gl, program, "margin", on->margin);
    sph2d__program_set_float(gl, program, "beyond", beyond);
    sph2d__program_set_float(gl, program, "reach", radius);
    sph2d__program_set_int(gl, program, "triangles", !points);
    gl->BindVertexArray(dots->vertex_array);
    for (GLuint attribute = 0; attribute < 2; ++attribute)
        gl->VertexAttribDivisor(attribute, points ? 0 : 1);
    if (points)
        gl->DrawArrays(GL_POINTS, 0, (GLsizei)dots->count);
    else
        gl->DrawArraysInstanced(GL_TRIANGLES, 0, 3, (GLsizei)dots->count);
}

void sph2d__dots_destroy(const sph2d__gl *gl, sph2d__dots *dots)
{
    gl->DeleteVertexArrays(1, &dots->vertex_array); /* 0 is ignored */
    gl->DeleteBuffers(1, &dots->buffer);
    *dots = (sph2d__dots){0};
}

/* ---- style points ------------------------------------------------------------------------------------------------ */

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
