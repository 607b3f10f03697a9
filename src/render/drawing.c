/* SPDX-License-Identifier: MIT */
/** @file drawing.c
 *  Draws a picture with the current context. Texts are written by the CPU: on the pixels that were read back, or on
 *  patches that are copied to the target. */
#include "render/drawing.h"

#include <string.h>

#include "base/random.h"
#include "render/dots.h"
#include "render/gl_loader.h"
#include "render/legend.h"

/* Colours of the background, inside the domain and outside; of paper for ink. */
static const unsigned char inside[3] = {246, 249, 251}, outside[3] = {231, 235, 239}, paper[3] = {255, 255, 255};

static bool on_paper(const sph2d__drawing *self)
{
    return self->style == SPH2D_STYLE_METABALLS && self->look == SPH2D_LOOK_INK;
}

sph2d_status sph2d__drawing_create(sph2d__drawing *self, const char *shader_dir, sph2d_report *report)
{
    const sph2d__gl *gl = &self->gl;
    sph2d_status status = sph2d__target_create_color(gl, &self->target, self->width, self->height, report);
    self->target.transparent = self->transparent;
    if (status == SPH2D_OK && self->shown)
        status = sph2d__target_create_color(gl, &self->patch, self->width, self->height, report);
    gl->GenVertexArrays(1, &self->gl.no_vertices);
    if (status == SPH2D_OK)
        status = sph2d__dots_create(gl, &self->dots, report);
    if (status == SPH2D_OK)
        status = sph2d__program_build(gl, shader_dir, (const char *[2]){"gradientball", "points"}, NULL,
                                      &self->points_program, report);
    if (status == SPH2D_OK && self->style == SPH2D_STYLE_METABALLS)
        status =
            sph2d__metaballs_create(gl, &self->metaballs, shader_dir, self->look, self->width, self->height, report);
    if (status == SPH2D_OK)
        status =
            sph2d__program_build(gl, shader_dir, (const char *[2]){"tiles", "mask"}, NULL, &self->mask_program, report);
    if (status == SPH2D_OK)
        status = sph2d__walls_create(gl, &self->walls, self->width, self->height, report);
    if (status == SPH2D_OK)
        status = sph2d__lines_create(gl, &self->lines, self->width, self->height, report);
    if (status == SPH2D_OK)
        status = sph2d__gl_check(gl, "preparing to draw", report);
    return status;
}

void sph2d__drawing_destroy(sph2d__drawing *self)
{
    const sph2d__gl *gl = &self->gl;
    sph2d__lines_destroy(gl, &self->lines);
    sph2d__walls_destroy(gl, &self->walls);
    sph2d__metaballs_destroy(gl, &self->metaballs);
    gl->DeleteProgram(self->points_program);
    gl->DeleteProgram(self->mask_program);
    sph2d__dots_destroy(gl, &self->dots);
    gl->DeleteVertexArrays(1, &gl->no_vertices);
    sph2d__target_destroy(gl, &self->patch);
    sph2d__target_destroy(gl, &self->target);
}

sph2d_status sph2d__drawing_arrange(const sph2d__drawing *self, const sph2d_picture *picture, sph2d__layout *out,
                                    sph2d_report *report)
{
    /* Before the first particle there may be no array of values, but the view must stay the same. */
    *out = (sph2d__layout){.legend = picture->values || (picture->count == 0 && picture->value_label),
                           .min = picture->value_min,
                           .max = picture->value_max};
    out->right = out->legend ? sph2d__colorbar_width(self->width, self->height, picture->value_label) : 0;
    out->below = picture->caption ? sph2d__caption_height(self->width, self->height) : 0;
    if (!sph2d__view_fit(&out->view, picture->view, (unsigned)self->width, (unsigned)self->height, (unsigned)out->right,
                         (unsigned)out->below)) {
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL,
                         "the view of the picture is empty or not finite");
        return SPH2D_INVALID;
    }
    if (out->legend && out->min == 0.0 && out->max == 0.0)
        sph2d__color_range(picture->values, picture->count, picture->diverging, &out->min, &out->max);
    return SPH2D_OK;
}

/* ---- picture ----------------------------------------------------------------------------------------------------- */

static void fill_box(const sph2d__drawing *self, sph2d__pixel_box box, const unsigned char color[3])
{
    const sph2d__gl *gl = &self->gl;
    if (box.width <= 0 || box.height <= 0)
        return;
    gl->Scissor(box.x, box.y, box.width, box.height);
    gl->ClearColor((float)color[0] / 255.0F, (float)color[1] / 255.0F, (float)color[2] / 255.0F, 1.0F);
    gl->Clear(GL_COLOR_BUFFER_BIT);
}

/* The part of the image with a lighter background: no number stands on it. */
static sph2d__pixel_box find_inside(const sph2d__drawing *self, const sph2d_picture *picture, const sph2d__layout *at)
{
    const sph2d_box *box = &picture->inside;
    const bool given = box->min.x < box->max.x && box->min.y < box->max.y;
    sph2d__pixel_box seen = sph2d__view_cover(&at->view, given ? *box : picture->view);
    const int columns = self->width - at->right - seen.x, rows = self->height - at->below - seen.y;
    seen.width = seen.width < columns ? seen.width : columns;
    seen.height = seen.height < rows ? seen.height : rows;
    return seen;
}

/* A light background, slightly darker outside the domain: the larger part is cleared with all of the image, which takes
 * little in a software renderer. */
static void draw_background(const sph2d__drawing *self, const sph2d_picture *picture, const sph2d__layout *at)
{
    const sph2d__gl *gl = &self->gl;
    sph2d__target_bind(gl, &self->target);
    if (self->transparent) {
        gl->ClearColor(0.0F, 0.0F, 0.0F, 0.0F);
        gl->Clear(GL_COLOR_BUFFER_BIT);
        return;
    }
    const sph2d__pixel_box seen = find_inside(self, picture, at);
    const int right = seen.x + seen.width, below = seen.y + seen.height;
    gl->Enable(GL_SCISSOR_TEST);
    fill_box(self, (sph2d__pixel_box){0, 0, self->width, self->height}, on_paper(self) ? paper : inside);
    if (!on_paper(self)) {
        fill_box(self, (sph2d__pixel_box){0, 0, self->width, seen.y}, outside);
        fill_box(self, (sph2d__pixel_box){0, below, self->width, self->height - below}, outside);
        fill_box(self, (sph2d__pixel_box){0, seen.y, seen.x, seen.height}, outside);
        fill_box(self, (sph2d__pixel_box){right, seen.y, self->width - right, seen.height}, outside);
    }
    gl->Disable(GL_SCISSOR_TEST);
}

static sph2d__dot_list fluid_of(const sph2d_picture *picture, const sph2d__layout *at)
{
    unsigned char color[3] = {26, 112, 176};
    if (picture->tinted)
        sph2d__color_split(picture->tint, color);
    return (sph2d__dot_list){.count = picture->count,
                             .x = picture->x,
                             .y = picture->y,
                             .color = {color[0], color[1], color[2], 255},
                             .colors = picture->colors,
                             .values = picture->values,
                             .value_min = at->min,
                             .value_max = at->max,
                             .diverging = picture->diverging};
}

sph2d_status sph2d__drawing_paint(sph2d__drawing *self, const sph2d_picture *picture, const sph2d__layout *at,
                                  sph2d_report *report)
{
    const sph2d__gl *gl = &self->gl;
    const bool balls = self->style == SPH2D_STYLE_METABALLS;
    if (!gl->es) /* where vertices always tell the size of points */
        gl->Enable(GL_PROGRAM_POINT_SIZE);
    gl->Disable(GL_SCISSOR_TEST);
    sph2d__walls_find(gl, &self->walls, &at->view, picture);
    if (balls) {
        const sph2d_status summed = sph2d__metaballs_sum(gl, &self->metaballs, &self->dots, &at->view,
                                                         fluid_of(picture, at), picture, self->walls.mark, report);
        if (summed != SPH2D_OK)
            return summed;
    }
    draw_background(self, picture, at);
    gl->Enable(GL_SCISSOR_TEST); /* no wall behind the numbers */
    gl->Scissor(0, 0, self->width - at->right, self->height - at->below);
    if (balls)
        sph2d__metaballs_shade(gl, &self->metaballs, &self->target, picture, self->walls.mask.texture);
    else
        sph2d__points_draw(gl, self->points_program, &self->dots, &self->target, &at->view, fluid_of(picture, at),
                           picture->radius);
    const sph2d_status status =
        sph2d__lines_find(&self->lines, &at->view, picture, &self->walls.mask.cover, &self->scales, report);
    sph2d__lines_draw(gl, &self->lines, self->mask_program, &self->target);
    sph2d__walls_draw(gl, &self->walls, self->mask_program, &self->target, picture);
    gl->Disable(GL_SCISSOR_TEST);
    return status;
}

/* ---- texts ------------------------------------------------------------------------------------------------------- */

/* The parts of an image that have text: where they are, and what they show. */
enum { LEGEND, STRIP, NOTES, PARTS };
_Static_assert((int)PARTS == SPH2D__TEXTS, "each part has a mark in sph2d__drawing");

static bool has_part(const sph2d_picture *picture, const sph2d__layout *at, int part)
{
    return part == LEGEND ? at->legend : (part == STRIP ? picture->caption : picture->notes) != NULL;
}

static sph2d__pixel_box box_of(const sph2d__drawing *self, const sph2d_picture *picture, const sph2d__layout *at,
                               int part)
{
    switch (part) {
    case LEGEND:
        return (sph2d__pixel_box){self->width - at->right, 0, at->right, self->height - at->below};
    case STRIP:
        return (sph2d__pixel_box){0, self->height - at->below, self->width, at->below};
    default:
        break;
    }
    sph2d__pixel_box notes = sph2d__notes_box(self->width, self->height, picture->notes);
    const int columns = self->width - at->right - notes.x, rows = self->height - at->below - notes.y;
    notes.width = notes.width < columns ? notes.width : columns; /* each part has a place of its own in the patch */
    notes.height = notes.height < rows ? notes.height : rows;
    return notes;
}

static void write_part(const sph2d__drawing *self, const sph2d__canvas *canvas, const sph2d_picture *picture,
                       const sph2d__layout *at, int part)
{
    if (part == LEGEND)
        sph2d__colorbar_draw(canvas, at->min, at->max, picture->diverging, picture->value_label);
    else if (part == STRIP)
        sph2d__caption_draw(canvas, &at->view, picture->caption, &self->scales, picture->level_label);
    else
        sph2d__notes_draw(canvas, picture->notes);
}

/* Part of a unit of text by which a halo is wider than the lines. */
static const double halo = 1.2;

/* The same on nothing: text is dark, and has a light halo, so that it can be read on any colour. */
static void write_on_nothing(const sph2d__drawing *self, const sph2d__canvas *canvas, const sph2d_picture *picture,
                             const sph2d__layout *at, int part)
{
    sph2d__canvas below = *canvas;
    below.halo = halo * sph2d__canvas_unit(self->width, self->height);
    if (part != NOTES) /* which have a box */
        write_part(self, &below, picture, at, part);
    write_part(self, canvas, picture, at, part);
}

void sph2d__drawing_write(const sph2d__drawing *self, const sph2d_picture *picture, const sph2d__layout *at,
                          unsigned char *pixels)
{
    const sph2d__canvas canvas = {.pixels = pixels, .width = self->width, .height = self->height};
    for (int part = 0; part < PARTS; ++part)
        if (has_part(picture, at, part))
            (self->transparent ? write_on_nothing : write_part)(self, &canvas, picture, at, part);
}

/* ---- texts on what is shown -------------------------------------------------------------------------------------- */

/* A mark of what a part shows: writing takes longer than drawing the liquid, so that it is done only for news. */
static uint64_t mark_of(const sph2d__drawing *self, const sph2d_picture *picture, const sph2d__layout *at, int part)
{
    const char *const texts[PARTS] = {
        [LEGEND] = picture->value_label, [STRIP] = picture->caption, [NOTES] = picture->notes};
    const char *text = texts[part] ? texts[part] : "", *label = picture->level_label ? picture->level_label : "";
    const double numbers[9] = {part,
                               picture->diverging,
                               at->min,
                               at->max,
                               at->view.scale,
                               at->right + 1e6 * at->below,
                               self->scales.arrow_pixels,
                               self->scales.arrow_speed,
                               self->scales.level_step};
    uint64_t mark = sph2d__hash(SPH2D__HASH_START, numbers, sizeof numbers);
    mark = sph2d__hash(mark, text, strlen(text));
    return part == STRIP ? sph2d__hash(mark, label, strlen(label)) : mark;
}

/* What text stands on: the colour outside the domain, or nothing. */
static void fill_ground(const sph2d__drawing *self, sph2d__pixel_box box, unsigned char *pixels)
{
    const unsigned char *color = on_paper(self) ? paper : outside;
    for (int row = box.y; row < box.y + box.height; ++row)
        for (int column = box.x; column < box.x + box.width; ++column) {
            unsigned char *pixel = pixels + 4 * ((size_t)row * (size_t)self->width + (size_t)column);
            memcpy(pixel, color, 3);
            pixel[3] = self->transparent ? 0 : 255;
        }
}

static void multiply_by_alpha(const sph2d__drawing *self, sph2d__pixel_box box, unsigned char *pixels)
{
    for (int row = box.y; row < box.y + box.height; ++row)
        for (int k = 4 * box.x; k < 4 * (box.x + box.width); ++k) {
            unsigned char *byte = pixels + (size_t)4 * (size_t)row * (size_t)self->width + (size_t)k;
            if (k % 4 != 3)
                *byte = (unsigned char)((*byte * byte[3 - k % 4] + 127) / 255);
        }
}

/* Writes a part on the scratch pad, and uploads it to its place in the patch. */
static void renew_part(sph2d__drawing *self, const sph2d_picture *picture, const sph2d__layout *at, int part,
                       sph2d__pixel_box box, unsigned char *pixels)
{
    const sph2d__gl *gl = &self->gl;
    const sph2d__canvas canvas = {.pixels = pixels, .width = self->width, .height = self->height};
    fill_ground(self, box, pixels);
    (self->transparent ? write_on_nothing : write_part)(self, &canvas, picture, at, part);
    if (self->transparent)
        multiply_by_alpha(self, box, pixels);
    gl->BindTexture(GL_TEXTURE_2D, self->patch.texture);
    gl->PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl->PixelStorei(GL_UNPACK_ROW_LENGTH, self->width);
    gl->TexSubImage2D(GL_TEXTURE_2D, 0, box.x, box.y, box.width, box.height, GL_RGBA, GL_UNSIGNED_BYTE,
                      pixels + 4 * ((size_t)box.y * (size_t)self->width + (size_t)box.x));
    gl->PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    gl->BindTexture(GL_TEXTURE_2D, 0);
}

void sph2d__drawing_write_to_target(sph2d__drawing *self, const sph2d_picture *picture, const sph2d__layout *at,
                                    unsigned char *pixels)
{
    for (int part = 0; part < PARTS; ++part) {
        if (!has_part(picture, at, part))
            continue;
        const sph2d__pixel_box box = box_of(self, picture, at, part);
        const uint64_t mark = mark_of(self, picture, at, part);
        if (box.width <= 0 || box.height <= 0)
            continue;
        if (self->marks[part] != mark)
            renew_part(self, picture, at, part, box, pixels);
        self->marks[part] = mark;
        sph2d__target_copy(&self->gl, &self->patch, box, self->target.framebuffer, box, false);
    }
}
