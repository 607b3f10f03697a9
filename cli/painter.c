/* SPDX-License-Identifier: MIT */
/** @file painter.c
 *  Draws particles into PNG files. */
#include "painter.h"

#include <stdio.h>
#include <stdlib.h>

#ifdef SPH2D_NO_RENDER

sph2d_status painter_create(const cli_look *look, const cli_options *options, cli_painter **out, sph2d_report *report)
{
    (void)look;
    (void)options;
    *out = NULL;
    sph2d_diagnostic *d = sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GL_MISSING, NULL,
                                           "this build of sph2d cannot draw: it was made without the render library");
    sph2d_diagnostic_hint(d, "build with RENDER=1 for pictures; 'sph2d run --no-frames' simulates without them");
    return SPH2D_RENDER;
}

void painter_destroy(cli_painter *p)
{
    (void)p;
}

bool painter_fits(const cli_painter *p, const cli_look *look)
{
    (void)p;
    (void)look;
    return false;
}

sph2d_status painter_paint(cli_painter *p, const particle_source *source, const cli_look *look, const char *path,
                           painter_times *spent, sph2d_report *report)
{
    (void)p;
    (void)source;
    (void)look;
    (void)path;
    (void)spent;
    (void)report;
    return SPH2D_RENDER;
}

char *painter_describe(const cli_painter *p, char *out, size_t size)
{
    (void)p;
    snprintf(out, size, "none");
    return out;
}

const char *painter_backends(void)
{
    return "none";
}

#else

struct cli_painter {
    sph2d_renderer *renderer;
    sph2d_frames made_for; /* size and style are the renderer's */
    picture_buffers buffers;
};

sph2d_status painter_create(const cli_look *look, const cli_options *options, cli_painter **out, sph2d_report *report)
{
    *out = NULL;
    cli_painter *p = calloc(1, sizeof *p);
    if (p == NULL)
        return SPH2D_NOMEM;
    sph2d_render_options render = sph2d_render_options_default();
    render.width = (unsigned)look->frames.size[0];
    render.height = (unsigned)look->frames.size[1];
    render.style = look->frames.style;
    render.gl = options->gl;
    render.shader_dir = options->shader_dir;
    sph2d_status status = sph2d_renderer_create(&render, &p->renderer, report);
    if (status != SPH2D_OK) {
        free(p);
        return status;
    }
    p->made_for = look->frames;
    *out = p;
    return SPH2D_OK;
}

void painter_destroy(cli_painter *p)
{
    if (p == NULL)
        return;
    sph2d_renderer_destroy(p->renderer);
    picture_free(&p->buffers);
    free(p);
}

bool painter_fits(const cli_painter *p, const cli_look *look)
{
    return p->made_for.size[0] == look->frames.size[0] && p->made_for.size[1] == look->frames.size[1] &&
           p->made_for.style == look->frames.style;
}

sph2d_status painter_paint(cli_painter *p, const particle_source *source, const cli_look *look, const char *path,
                           painter_times *spent, sph2d_report *report)
{
    sph2d_picture picture;
    sph2d_status status = picture_make(source, look, &p->buffers, &picture, report);
    if (status == SPH2D_OK)
        status = sph2d_renderer_draw(p->renderer, &picture, report);
    if (status == SPH2D_OK)
        status = sph2d_renderer_write_png(p->renderer, path, report);
    if (status == SPH2D_OK && spent != NULL) {
        const painter_times one = {1, sph2d_renderer_times(p->renderer)};
        painter_times_add(spent, &one);
    }
    return status;
}

char *painter_describe(const cli_painter *p, char *out, size_t size)
{
    snprintf(out, size, "%s: %s", sph2d_renderer_gl(p->renderer), sph2d_renderer_gl_version(p->renderer));
    return out;
}

const char *painter_backends(void)
{
    return sph2d_render_backends();
}

#endif

void painter_times_add(painter_times *sum, const painter_times *more)
{
    sum->frames += more->frames;
    sum->sum.draw += more->sum.draw;
    sum->sum.read += more->sum.read;
    sum->sum.encode += more->sum.encode;
}

char *painter_times_describe(char out[TEXT_SIZE], const painter_times *times)
{
    out[0] = '\0';
    if (times->frames == 0)
        return out;
    const double per_frame = 1e3 / (double)times->frames;
    char draw[TEXT_SIZE], read[TEXT_SIZE], encode[TEXT_SIZE];
    snprintf(out, TEXT_SIZE, "%s ms each to draw, %s to read back, %s to encode",
             text_short(draw, times->sum.draw * per_frame), text_short(read, times->sum.read * per_frame),
             text_short(encode, times->sum.encode * per_frame));
    return out;
}
