/* SPDX-License-Identifier: MIT */
/** @file renderer.c
 *  The public interface: checks its arguments, opens a context, draws, reads the pixels back. */
#include "sph2d/render.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "render/drawing.h"
#include "render/png_file.h"

enum { SIDE_MIN = 16, SIDE_MAX = 16384 };

struct sph2d_renderer {
    sph2d__gl_context context;
    sph2d__drawing drawing;
    unsigned char *pixels;
    sph2d__view view; /* of the last picture; its scale is 0 before the first */
    bool drawn;       /* and read back */
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
    if (options->gl && options->get_proc_address)
        return invalid(report, "render options name a context and give one, by get_proc_address: give one of the two");
    if (options->style != SPH2D_STYLE_METABALLS && options->style != SPH2D_STYLE_POINTS)
        return invalid(report, "the style of the renderer is unknown");
    if (options->look < SPH2D_LOOK_WATER || options->look > SPH2D_LOOK_INK)
        return invalid(report, "the look of the renderer is unknown");
    if (options->background != SPH2D_BACKGROUND_OPAQUE && options->background != SPH2D_BACKGROUND_TRANSPARENT)
        return invalid(report, "the background of the renderer is unknown");
    if (options->width < SIDE_MIN || options->width > SIDE_MAX || options->height < SIDE_MIN ||
        options->height > SIDE_MAX) {
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_OUT_OF_RANGE, NULL,
                         "a picture of %u x %u pixels is not possible: each side has %d to %d", options->width,
                         options->height, SIDE_MIN, SIDE_MAX);
        return SPH2D_INVALID;
    }
    return SPH2D_OK;
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
    self->pixels = pixels;
    self->drawing.width = (int)options->width;
    self->drawing.height = (int)options->height;
    self->drawing.style = options->style;
    self->drawing.look = options->look;
    self->drawing.transparent = options->background == SPH2D_BACKGROUND_TRANSPARENT;
    self->drawing.shown = options->get_proc_address;
    status = options->get_proc_address
                 ? sph2d__gl_borrow(options->get_proc_address, &self->context, &self->drawing.gl, report)
                 : sph2d__gl_open(options->gl, &self->context, &self->drawing.gl, report);
    if (status == SPH2D_OK) {
        const sph2d__gl *gl = &self->drawing.gl;
        snprintf(self->gl_version, sizeof self->gl_version, "%s, %s", (const char *)gl->GetString(GL_VERSION),
                 (const char *)gl->GetString(GL_RENDERER));
        status = sph2d__drawing_create(&self->drawing, options->shader_dir, report);
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
            sph2d__drawing_destroy(&renderer->drawing);
            renderer->context.release(renderer->context.impl);
        }
        renderer->context.destroy(renderer->context.impl);
    }
    free(renderer->pixels);
    free(renderer);
}

static bool is_length(double number)
{
    return number >= 0.0 && isfinite(number);
}

static sph2d_status check_picture(const sph2d_picture *picture, sph2d_report *report)
{
    if (!picture)
        return invalid(report, "the picture is NULL");
    if (picture->count > 0 && (!picture->x || !picture->y))
        return invalid(report, "the picture has particles without positions");
    if (picture->count > 0 && !(picture->radius > 0.0 && isfinite(picture->radius)))
        return invalid(report, "the radius of the picture's particles is not a positive number");
    if (picture->outline_count > 0 &&
        (!picture->outline_x || !picture->outline_y || !picture->outline_id || !picture->outline_liquid))
        return invalid(report, "the picture has outlines without positions, numbers or sides of liquid");
    if (!(picture->wall_thickness >= 0.0 && isfinite(picture->wall_thickness)))
        return invalid(report, "the thickness of the picture's walls is not a finite number of at least 0");
    const bool lined = picture->count > 0 && (picture->vx || picture->stream_vx || picture->level_values);
    if (picture->count > 0 && (!picture->vx != !picture->vy || !picture->stream_vx != !picture->stream_vy))
        return invalid(report, "the picture has one component of velocities: give both, or none");
    if (lined && !(picture->spacing > 0.0 && isfinite(picture->spacing)))
        return invalid(
            report,
            "the picture has arrows, streamlines or isolines, and its particles' spacing is not a positive number");
    if (!is_length(picture->arrow_spacing) || !is_length(picture->arrow_speed) ||
        !is_length(picture->streamline_spacing) || !is_length(picture->level_step))
        return invalid(report, "the picture's arrow_spacing, arrow_speed, streamline_spacing or level_step is not a "
                               "finite number of at least 0");
    const bool automatic = picture->value_min == 0.0 && picture->value_max == 0.0;
    if (picture->values && !automatic &&
        !(picture->value_min < picture->value_max && isfinite(picture->value_max - picture->value_min)))
        return invalid(report, "the picture's colour range is not two finite numbers in increasing order");
    return SPH2D_OK;
}

/* Divides colours by their alpha, in which form files have them. */
static void divide_by_alpha(unsigned char *pixels, size_t count)
{
    for (unsigned char *p = pixels; p < pixels + 4 * count; p += 4)
        for (int c = 0; c < 3 && p[3] > 0 && p[3] < 255; ++c) {
            const int value = (p[c] * 255 + p[3] / 2) / p[3];
            p[c] = (unsigned char)(value < 255 ? value : 255);
        }
}

/* Reads the picture back, and writes the texts on it. */
static void read_back(sph2d_renderer *self, const sph2d_picture *picture, const sph2d__layout *at)
{
    sph2d__drawing *d = &self->drawing;
    sph2d__target_bind(&d->gl, &d->target);
    d->gl.Finish(); /* so that the time of reading does not include drawing */
    const double begun = seconds();
    d->gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
    d->gl.ReadPixels(0, 0, d->width, d->height, GL_RGBA, GL_UNSIGNED_BYTE, self->pixels);
    if (d->transparent)
        divide_by_alpha(self->pixels, (size_t)d->width * (size_t)d->height);
    self->times.read = seconds() - begun;
    sph2d__drawing_write(d, picture, at, self->pixels);
}

/* Where the caller wants the picture. */
typedef struct place {
    GLuint framebuffer;
    int x, y; /* of the lower left corner [px] */
} place;

/* Copies the picture with its texts to the caller's framebuffer, whose rows begin at the lower end. */
static void copy_to(sph2d_renderer *self, const sph2d_picture *picture, const sph2d__layout *at, const place *to)
{
    sph2d__drawing *d = &self->drawing;
    sph2d__drawing_write_to_target(d, picture, at, self->pixels);
    sph2d__target_copy(&d->gl, &d->target, (sph2d__pixel_box){0, 0, d->width, d->height}, to->framebuffer,
                       (sph2d__pixel_box){to->x, to->y, d->width, d->height}, true);
}

/* Draws into memory, or with `to` into the caller's framebuffer. */
static sph2d_status draw(sph2d_renderer *self, const sph2d_picture *picture, const place *to, sph2d_report *report)
{
    sph2d__layout at;
    sph2d_status status = check_picture(picture, report);
    if (status == SPH2D_OK)
        status = sph2d__drawing_arrange(&self->drawing, picture, &at, report);
    if (status != SPH2D_OK)
        return status;
    const double begun = seconds();
    self->view = at.view;
    self->drawn = false;
    self->times = (sph2d_frame_times){0};
    if (!self->context.make_current(self->context.impl)) {
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GL_FAILED, NULL,
                         "the OpenGL context from %s cannot be used in this thread", self->context.name);
        return SPH2D_RENDER;
    }
    sph2d__gl_clear_errors(&self->drawing.gl);
    status = sph2d__drawing_paint(&self->drawing, picture, &at, report);
    if (status == SPH2D_OK && to)
        copy_to(self, picture, &at, to);
    else if (status == SPH2D_OK)
        read_back(self, picture, &at);
    if (status == SPH2D_OK)
        status = sph2d__gl_check(&self->drawing.gl, "drawing a picture", report);
    self->context.release(self->context.impl);
    self->drawn = status == SPH2D_OK && !to;
    self->times.draw = seconds() - begun - self->times.read;
    return status;
}

sph2d_status sph2d_renderer_draw(sph2d_renderer *renderer, const sph2d_picture *picture, sph2d_report *report)
{
    return renderer ? draw(renderer, picture, NULL, report) : invalid(report, "the renderer is NULL");
}

sph2d_status sph2d_renderer_draw_to(sph2d_renderer *renderer, unsigned framebuffer, int x, int y,
                                    const sph2d_picture *picture, sph2d_report *report)
{
    if (!renderer)
        return invalid(report, "the renderer is NULL");
    if (strcmp(renderer->context.name, "current") != 0)
        return invalid(report, "the renderer has a context of its own, so it cannot draw into a framebuffer of the "
                               "caller: create it with get_proc_address");
    return draw(renderer, picture, &(place){framebuffer, x, y}, report);
}

bool sph2d_renderer_locate(const sph2d_renderer *renderer, double x, double y, sph2d_vec2 *at)
{
    if (!renderer || !at || !(renderer->view.scale > 0))
        return false;
    *at = sph2d__view_locate(&renderer->view, x, y);
    return true;
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
    const sph2d_status status =
        sph2d__png_write(path, renderer->pixels, (unsigned)renderer->drawing.width, (unsigned)renderer->drawing.height,
                         renderer->drawing.transparent, report);
    renderer->times.encode = seconds() - begun;
    return status;
}

sph2d_status sph2d_png_write(const char *path, const unsigned char *pixels, unsigned width, unsigned height,
                             sph2d_background background, sph2d_report *report)
{
    if (!path)
        return invalid(report, "the path of the picture is NULL");
    if (!pixels)
        return invalid(report, "the pixels of the picture are NULL");
    if (width < 1 || width > SIDE_MAX || height < 1 || height > SIDE_MAX) {
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_OUT_OF_RANGE, NULL,
                         "a picture of %u x %u pixels cannot be written: each side has 1 to %d", width, height,
                         SIDE_MAX);
        return SPH2D_INVALID;
    }
    return sph2d__png_write(path, pixels, width, height, background == SPH2D_BACKGROUND_TRANSPARENT, report);
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
