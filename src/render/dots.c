/* SPDX-License-Identifier: MIT */
/** @file dots.c
 *  Draws a triangle around each particle. Point sprites would be simpler, but software renderers limit their size and
 *  drop them when their centre leaves the image. Instancing is slow in software renderers, so each vertex repeats its
 *  particle's attributes; and the cost is that of the pixels, so one triangle around a disc is better than a square of
 *  two. */
#include "render/dots.h"

#include <stdlib.h>
#include <string.h>

#include "render/colormap.h"

/* Vertices per draw call: enough to make calls cheap. Mesa's software drivers visit all vertices of a call several
 * times; with sixteen times as many a frame of 16,000 particles takes 4 ms longer. */
enum { BATCH = 768 };
_Static_assert(BATCH % SPH2D__TRIANGLE == 0 && BATCH % SPH2D__SQUARE == 0, "a batch has whole figures");

sph2d_status sph2d__dots_create(const sph2d__gl *gl, sph2d__dots *dots, sph2d_report *report)
{
    *dots = (sph2d__dots){.batch = malloc(BATCH * sizeof *dots->batch)};
    if (!dots->batch) {
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL, "out of memory for drawing particles");
        return SPH2D_NOMEM;
    }
    gl->GenVertexArrays(1, &dots->vertex_array);
    gl->BindVertexArray(dots->vertex_array);
    gl->GenBuffers(1, &dots->buffer);
    gl->BindBuffer(GL_ARRAY_BUFFER, dots->buffer);
    const GLsizei stride = sizeof(sph2d__dot);
    gl->EnableVertexAttribArray(0);
    gl->VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, stride, (const void *)offsetof(sph2d__dot, pixel));
    gl->EnableVertexAttribArray(1);
    gl->VertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride, (const void *)offsetof(sph2d__dot, color));
    gl->EnableVertexAttribArray(2);
    gl->VertexAttribPointer(2, 1, GL_FLOAT, GL_FALSE, stride, (const void *)offsetof(sph2d__dot, across));
    return sph2d__gl_check(gl, "preparing to draw particles", report);
}

void sph2d__dots_begin(const sph2d__gl *gl, sph2d__dots *dots, sph2d__figure figure)
{
    gl->BindVertexArray(dots->vertex_array);
    gl->BindBuffer(GL_ARRAY_BUFFER, dots->buffer);
    dots->filled = 0;
    dots->figure = figure;
}

void sph2d__dots_end(const sph2d__gl *gl, sph2d__dots *dots)
{
    if (dots->filled == 0)
        return;
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(dots->filled * sizeof *dots->batch), dots->batch, GL_STREAM_DRAW);
    gl->DrawArrays(GL_TRIANGLES, 0, (GLsizei)dots->filled);
    dots->filled = 0;
}

void sph2d__dots_add(const sph2d__gl *gl, sph2d__dots *dots, const sph2d__dot *dot)
{
    if (dots->filled == BATCH)
        sph2d__dots_end(gl, dots);
    for (int i = 0; i < (int)dots->figure; ++i)
        dots->batch[dots->filled++] = *dot;
}

void sph2d__dots_draw(const sph2d__gl *gl, sph2d__dots *dots, const sph2d__view *view, const sph2d__dot_list *list)
{
    const double span = list->value_max - list->value_min;
    sph2d__dots_begin(gl, dots, SPH2D__TRIANGLE);
    for (size_t i = 0; i < list->count; ++i) {
        sph2d__dot dot = {.across = 1.0F};
        if (!sph2d__view_place(view, list->x[i], list->y[i], list->reach, dot.pixel))
            continue;
        if (list->values)
            sph2d__colormap((list->values[i] - list->value_min) / span, list->diverging, dot.color);
        else
            memcpy(dot.color, list->color, sizeof dot.color);
        sph2d__dots_add(gl, dots, &dot);
    }
    sph2d__dots_end(gl, dots);
}

void sph2d__dots_destroy(const sph2d__gl *gl, sph2d__dots *dots)
{
    gl->DeleteVertexArrays(1, &dots->vertex_array); /* 0 is ignored */
    gl->DeleteBuffers(1, &dots->buffer);
    free(dots->batch);
    *dots = (sph2d__dots){0};
}
