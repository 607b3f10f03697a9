/* SPDX-License-Identifier: MIT */
/** @file dots.c
 *  Instanced squares. Point sprites would be simpler, but software renderers cap their size and drop them when their
 *  centre leaves the picture. */
#include "render/dots.h"

#include <stdlib.h>
#include <string.h>

#include "render/colormap.h"

/* Particles per draw call: enough that calls cost nothing, little enough to stay in cache. */
enum { PART = 16384 };

sph2d_status sph2d__dots_create(const sph2d__gl *gl, sph2d__dots *dots, sph2d_report *report)
{
    *dots = (sph2d__dots){.part = malloc(PART * sizeof *dots->part)};
    if (dots->part == NULL) {
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
    gl->VertexAttribDivisor(0, 1);
    gl->EnableVertexAttribArray(1);
    gl->VertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride, (const void *)offsetof(sph2d__dot, color));
    gl->VertexAttribDivisor(1, 1);
    return sph2d__gl_check(gl, "preparing to draw particles", report);
}

void sph2d__dots_begin(const sph2d__gl *gl, sph2d__dots *dots)
{
    gl->BindVertexArray(dots->vertex_array);
    gl->BindBuffer(GL_ARRAY_BUFFER, dots->buffer);
    dots->filled = 0;
}

void sph2d__dots_end(const sph2d__gl *gl, sph2d__dots *dots)
{
    if (dots->filled == 0)
        return;
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(dots->filled * sizeof *dots->part), dots->part, GL_STREAM_DRAW);
    gl->DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, (GLsizei)dots->filled);
    dots->filled = 0;
}

void sph2d__dots_add(const sph2d__gl *gl, sph2d__dots *dots, const float pixel[2], const unsigned char color[4])
{
    if (dots->filled == PART)
        sph2d__dots_end(gl, dots);
    sph2d__dot *dot = &dots->part[dots->filled++];
    memcpy(dot->pixel, pixel, sizeof dot->pixel);
    memcpy(dot->color, color, sizeof dot->color);
}

void sph2d__dots_draw(const sph2d__gl *gl, sph2d__dots *dots, const sph2d__view *view, const sph2d__dot_list *list)
{
    const double span = list->value_max - list->value_min;
    sph2d__dots_begin(gl, dots);
    for (size_t i = 0; i < list->count; ++i) {
        float pixel[2];
        unsigned char color[4];
        if (!sph2d__view_place(view, list->x[i], list->y[i], list->half_side, pixel))
            continue;
        if (list->values != NULL)
            sph2d__colormap((list->values[i] - list->value_min) / span, color);
        sph2d__dots_add(gl, dots, pixel, list->values != NULL ? color : list->color);
    }
    sph2d__dots_end(gl, dots);
}

void sph2d__dots_destroy(const sph2d__gl *gl, sph2d__dots *dots)
{
    gl->DeleteVertexArrays(1, &dots->vertex_array); /* 0 is ignored */
    gl->DeleteBuffers(1, &dots->buffer);
    free(dots->part);
    *dots = (sph2d__dots){0};
}
