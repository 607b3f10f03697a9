/* SPDX-License-Identifier: MIT */
/** @file renderer.c
 *  The public interface: checks its arguments, opens a context, draws, reads the pixels back. */
#include "sph2d/render.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "render/colorbar.h"
#include "render/metaballs.h"
#include "render/png_file.h"
#include "render/points.h"
#include "render/shader.h"

enum { SIDE_MIN = 16, SIDE_MAX = 16384 };

struct sph2d_renderer {
    unsigned width, height;
    sph2d_style style;
    sph2d__gl_context context;
    sph2d__gl gl;
    sph2d__dots dots;
    GLuint points_program;
    sph2d__metaballs metaballs;
    sph2d__target target;
    unsigned char *pixels;
    bool drawn;
    sph2d_frame_times times;
    char gl_version[192];
};

sph2d_render_options sph2d_render_options_default(void)
{
    return (sph2d_render_options){
        .struct_size = sizeof(sph2d_render_options), .width = 1280, .height = 720, .style = SPH2D_STYLE_METABALLS};
}

static double seconds(void)
{
    struct timespec now;
    return clock_gettime(CLOCK_MONOTONIC, &now) == 0 ? (double)now.tv_sec + 1e-9 * (double)now.tv_nsec : 0.0;
}

static sph2d_status invalid(sph2d_report *report, const char *what)
{
    sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL, "%s", what);
    return SPH2D_INVALID;
}

static sph2d_status check_options(const sph2d_render_options *options, sph2d_report *report)
{
    if (!options || options->struct_size != sizeof *options)
        return invalid(report, "render options do not come from sph2d_render_options_default()");
    if (options->style != SPH2D_STYLE_METABALLS && options->style != SPH2D_STYLE_POINTS)
        return invalid(report, "the style of the renderer is unknown");
    if (options->width < SIDE_MIN || options->width > SIDE_MAX || options->height < SIDE_MIN ||
        options->height > SIDE_MAX) {
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_OUT_OF_RANGE, NULL,
                         "a picture of %u x %u pixels is not possible: each side has %d to %d", options->width,
                         options->height, SIDE_MIN, SIDE_MAX);
        return SPH2D_INVALID;
    }
    return SPH2D_OK;
}

static sph2d_status create_passes(sph2d_renderer *self, const char *shader_dir, sph2d_report *report)
{
    const GLsizei width = (GLsizei)self->width, height = (GLsizei)self->height;
    snprintf(self->gl_version, sizeof self->gl_version, "%s, %s", (const char *)self->gl.GetString(GL_VERSION),
             (const char *)self->gl.GetString(GL_RENDERER));
    sph2d_status status = sph2d__target_create_color(&self->gl, &self->target, width, height, report);
    if (status == SPH2D_OK)
        status = sph2d__dots_create(&self->gl, &self->dots, report);
    if (status == SPH2D_OK)
        status = sph2d__program_build(&self->gl, shader_dir, "points", &self->points_program, report);
    if (status == SPH2D_OK && self->style == SPH2D_STYLE_METABALLS)
        status = sph2d__metaballs_create(&self->gl, &self->metaballs, shader_dir, width, height, report);
    if (status == SPH2D_OK)
        status = sph2d__gl_check(&self->gl, "preparing to draw", report);
    return status;
}

sph2d_status sph2d_renderer_create(const sph2d_render_options *options, sph2d_renderer **renderer, sph2d_report *report)
{
    if (!renderer)
        return invalid(report, "the pointer for the renderer is NULL");
    *renderer = NULL;
    sph2d_status status = check_options(options, report);
    if (status != SPH2D_OK)
        return status;
    sph2d_renderer *self = calloc(1, sizeof *self);
    unsigned char *pixels = malloc((size_t)options->width * options->height * 4);
    if (!self || !pixels) {
        free(self);
        free(pixels);
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL, "out of memory for a picture of %u x %u pixels",
                         options->width, options->height);
        return SPH2D_NOMEM;
    }
    self->width = options->width;
    self->height = options->height;
    self->style = options->style;
    self->pixels = pixels;
    status = sph2d__gl_open(options->gl, &self->context, &self->gl, report);
    if (status == SPH2D_OK) {
        status = create_passes(self, options->shader_dir, report);
        self->context.release(self->context.impl);
    }
    if (status != SPH2D_OK) {
        sph2d_renderer_destroy(self);
        return status;
    }
    *renderer = self;
    return SPH2D_OK;
}

void sph2d_renderer_destroy(sph2d_renderer *renderer)
{
    if (!renderer)
        return;
    if (renderer->context.impl) {
        if (renderer->context.make_current(renderer->context.impl)) {
            sph2d__metaballs_destroy(&renderer->gl, &renderer->metaballs);
            renderer->gl.DeleteProgram(renderer->points_program);
            sph2d__dots_destroy(&renderer->gl, &renderer->dots);
            sph2d__target_destroy(&renderer->gl, &renderer->target);
            renderer->context.release(renderer->context.impl);
        }
        renderer->context.destroy(renderer->context.impl);
    }
    free(renderer->pixels);
    free(renderer);
}

static sph2d_status check_picture(const sph2d_picture *picture, sph2d_report *report)
{
    if (!picture)
        return invalid(report, "the picture is NULL");
    if (picture->count > 0 && (!picture->x || !picture->y))
        return invalid(report, "the picture has particles without positions");
    if (picture->count > 0 && !(picture->radius > 0.0 && isfinite(picture->radius)))
        return invalid(report, "the radius of the picture's particles is not a positive number");
    if (picture->wall_count > 0 && (!picture->wall_x || !picture->wall_y))
        return invalid(report, "the picture has boundary particles without positions");
    if (picture->wall_count > 0 && !(picture->wall_radius > 0.0 && isfinite(picture->wall_radius)))
        return invalid(report, "the radius of the picture's boundary particles is not a positive number");
    const bool automatic = picture->value_min == 0.0 && picture->value_max == 0.0;
    if (picture->values && !automatic &&
        !(picture->value_min < picture->value_max && isfinite(picture->value_max - picture->value_min)))
        return invalid(report, "the picture's colour range is not two finite numbers in increasing order");
    return SPH2D_OK;
}

/* Position of a picture in the image, and its legend. */
typedef struct layout {
    sph2d__view view;
    bool legend;
    int reserved;    /* columns for the legend, on the right [px] */
    double min, max; /* ends of the colour range */
} layout;

static sph2d_status arrange(const sph2d_renderer *self, const sph2d_picture *picture, layout *out, sph2d_report *report)
{
    /* Before the first particle there may be no array of values, but the view must stay the same. */
    const bool colored = picture->values || (picture->count == 0 && picture->value_label);
    *out = (layout){
        .legend = self->style == SPH2D_STYLE_POINTS && colored, .min = picture->value_min, .max = picture->value_max};
    const int width = (int)self->width, height = (int)self->height;
    out->reserved = out->legend ? sph2d__colorbar_width(width, height, picture->value_label) : 0;
    if (!sph2d__view_fit(&out->view, picture->view, self->width, self->height, (unsigned)out->reserved))
        return invalid(report, "the view of the picture is empty or not finite");
    if (out->legend && out->min == 0.0 && out->max == 0.0)
        sph2d__color_range(picture->values, picture->count, &out->min, &out->max);
    return SPH2D_OK;
}

static void fill_box(const sph2d__gl *gl, sph2d__pixel_box box, const float color[3])
{
    gl->Scissor(box.x, box.y, box.width, box.height);
    gl->ClearColor(color[0], color[1], color[2], 1.0F);
    gl->Clear(GL_COLOR_BUFFER_BIT);
}

/* A light background, slightly darker outside the view. */
static void draw_background(const sph2d__gl *gl, const sph2d__target *target, const sph2d__view *view, sph2d_box box)
{
    static const float inside[3] = {0.965F, 0.976F, 0.984F}, outside[3] = {0.906F, 0.922F, 0.937F};
    sph2d__target_bind(gl, target);
    gl->Enable(GL_SCISSOR_TEST);
    fill_box(gl, (sph2d__pixel_box){0, 0, target->width, target->height}, outside);
    fill_box(gl, sph2d__view_cover(view, box), inside);
    gl->Disable(GL_SCISSOR_TEST);
}

static void draw_particles(sph2d_renderer *self, const sph2d_picture *picture, const layout *at)
{
    const sph2d__dot_list fluid = {.count = picture->count,
                                   .x = picture->x,
                                   .y = picture->y,
                                   .color = {26, 112, 176, 255},
                                   .values = picture->values,
                                   .value_min = at->min,
                                   .value_max = at->max};
    const sph2d__dot_list walls = {
        .count = picture->wall_count, .x = picture->wall_x, .y = picture->wall_y, .color = {84, 78, 76, 255}};
    if (self->style == SPH2D_STYLE_METABALLS)
        sph2d__metaballs_draw(&self->gl, &self->metaballs, &self->dots, &self->target, &at->view, fluid,
                              picture->radius);
    else
        sph2d__points_draw(&self->gl, self->points_program, &self->dots, &self->target, &at->view, fluid,
                           picture->radius);
    sph2d__points_draw(&self->gl, self->points_program, &self->dots, &self->target, &at->view, walls,
                       picture->wall_radius);
}

/* Draws with the context current, and reads the picture back. */
static sph2d_status draw_current(sph2d_renderer *self, const sph2d_picture *picture, const layout *at,
                                 sph2d_report *report)
{
    const sph2d__gl *gl = &self->gl;
    sph2d__gl_clear_errors(gl);
    draw_background(gl, &self->target, &at->view, picture->view);
    if (at->reserved > 0) { /* no wall behind the numbers */
        gl->Enable(GL_SCISSOR_TEST);
        gl->Scissor(0, 0, self->target.width - at->reserved, self->target.height);
    }
    draw_particles(self, picture, at);
    gl->Disable(GL_SCISSOR_TEST);
    sph2d__target_bind(gl, &self->target);
    gl->Finish(); /* so that the time of reading does not include drawing */
    const double begun = seconds();
    gl->PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl->ReadPixels(0, 0, self->target.width, self->target.height, GL_RGBA, GL_UNSIGNED_BYTE, self->pixels);
    self->times.read = seconds() - begun;
    return sph2d__gl_check(gl, "drawing a picture", report);
}

sph2d_status sph2d_renderer_draw(sph2d_renderer *renderer, const sph2d_picture *picture, sph2d_report *report)
{
    if (!renderer)
        return invalid(report, "the renderer is NULL");
    layout at;
    sph2d_status status = check_picture(picture, report);
    if (status == SPH2D_OK)
        status = arrange(renderer, picture, &at, report);
    if (status != SPH2D_OK)
        return status;
    const double begun = seconds();
    renderer->drawn = false;
    renderer->times = (sph2d_frame_times){0};
    if (!renderer->context.make_current(renderer->context.impl)) {
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GL_FAILED, NULL,
                         "the OpenGL context from %s cannot be used in this thread", renderer->context.name);
        return SPH2D_RENDER;
    }
    status = draw_current(renderer, picture, &at, report);
    renderer->context.release(renderer->context.impl);
    if (status != SPH2D_OK)
        return status;
    renderer->drawn = true;
    if (at.legend) {
        const sph2d__canvas canvas = {renderer->pixels, (int)renderer->width, (int)renderer->height};
        sph2d__colorbar_draw(&canvas, at.min, at.max, picture->value_label);
    }
    renderer->times.draw = seconds() - begun - renderer->times.read;
    return SPH2D_OK;
}

const unsigned char *sph2d_renderer_pixels(const sph2d_renderer *renderer)
{
    return renderer && renderer->drawn ? renderer->pixels : NULL;
}

sph2d_status sph2d_renderer_write_png(sph2d_renderer *renderer, const char *path, sph2d_report *report)
{
    if (!path)
        return invalid(report, "the path of the picture is NULL");
    if (!sph2d_renderer_pixels(renderer))
        return invalid(report, "there is no picture to write: draw one first");
    const double begun = seconds();
    const sph2d_status status = sph2d__png_write(path, renderer->pixels, renderer->width, renderer->height, report);
    renderer->times.encode = seconds() - begun;
    return status;
}

sph2d_frame_times sph2d_renderer_times(const sph2d_renderer *renderer)
{
    return renderer ? renderer->times : (sph2d_frame_times){0};
}

const char *sph2d_renderer_gl(const sph2d_renderer *renderer)
{
    if (!renderer)
        return NULL;
    return renderer->context.name;
}

const char *sph2d_renderer_gl_version(const sph2d_renderer *renderer)
{
    if (!renderer)
        return NULL;
    return renderer->gl_version;
}
