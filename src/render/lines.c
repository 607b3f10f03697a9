/* SPDX-License-Identifier: MIT */
/** @file lines.c
 *  Straight pieces of lines become thin rectangles. */
#include "render/lines.h"

#include <math.h>
#include <stdlib.h>

#include "render/canvas.h"

sph2d_status sph2d__lines_create(const sph2d__gl *gl, sph2d__lines *lines, GLsizei width, GLsizei height,
                                 sph2d_report *report)
{
    *lines = (sph2d__lines){0};
    return sph2d__mask_create(gl, &lines->mask, width, height, report);
}

void sph2d__lines_add(sph2d__lines *lines, const sph2d__piece *piece)
{
    if (lines->count == lines->capacity) {
        const size_t capacity = lines->capacity ? 2 * lines->capacity : 1024;
        sph2d__piece *grown = realloc(lines->pieces, capacity * sizeof *grown);
        lines->failed |= !grown;
        if (!grown)
            return;
        lines->pieces = grown;
        lines->capacity = capacity;
    }
    lines->pieces[lines->count++] = *piece;
}

sph2d_box sph2d__lines_box(const sph2d__view *view)
{
    const sph2d_vec2 upper = sph2d__view_locate(view, 0, 0),
                     lower = sph2d__view_locate(view, view->width, view->height);
    return (sph2d_box){{upper.x, lower.y}, {lower.x, upper.y}};
}

/* ---- drawing ----------------------------------------------------------------------------------------------------- */

/* Adds a piece as a rectangle, or trapezium. */
static void add_rectangle(sph2d__cover *cover, const sph2d__piece *p, double wide)
{
    const double x = p->to.x - p->from.x, y = p->to.y - p->from.y, length = hypot(x, y);
    const double along = length > 0.0 ? 0.5 * wide / length : 0.0, ax = along * x, ay = along * y;
    const double wider = 1.0 + p->wider / wide, bx = wider * ax, by = wider * ay; /* where it begins */
    const double on = p->has_next ? 0.0 : 1.0, ex = on * ax, ey = on * ay;        /* beyond its ends */
    const double corners[4][2] = {{p->from.x - ex - by, p->from.y - ey + bx},
                                  {p->from.x - ex + by, p->from.y - ey - bx},
                                  {p->to.x + ex + ay, p->to.y + ey - ax},
                                  {p->to.x + ex - ay, p->to.y + ey + ax}};
    for (int k = 0; k < 4; ++k)
        sph2d__cover_edge(cover, corners[k], corners[(k + 1) % 4]);
}

static void draw_wide(const sph2d__gl *gl, sph2d__lines *lines, GLuint program, const sph2d__target *target,
                      double wide, const float color[4])
{
    sph2d__cover *cover = &lines->mask.cover;
    sph2d__cover_clear(cover, target->width, target->height);
    for (size_t k = 0; k < lines->count; ++k)
        add_rectangle(cover, &lines->pieces[k], wide);
    sph2d__cover_fill(cover); /* all turn the same way: where some overlap is no hole */
    sph2d__mask_upload(gl, &lines->mask);
    sph2d__mask_draw(gl, &lines->mask, program, target, color);
}

void sph2d__lines_draw(const sph2d__gl *gl, sph2d__lines *lines, GLuint program, const sph2d__target *target)
{
    static const float light[4] = {1.0F, 1.0F, 1.0F, 0.55F}, dark[4] = {0.06F, 0.08F, 0.11F, 1.0F};
    const double wide = fmax(1.1, 0.65 * sph2d__canvas_unit(target->width, target->height));
    if (lines->count == 0)
        return;
    draw_wide(gl, lines, program, target, wide + 2.0, light);
    draw_wide(gl, lines, program, target, wide, dark);
}

void sph2d__lines_destroy(const sph2d__gl *gl, sph2d__lines *lines)
{
    sph2d__mask_destroy(gl, &lines->mask);
    sph2d__sampled_free(&lines->sampled);
    free(lines->pieces);
    *lines = (sph2d__lines){0};
}
