/* SPDX-License-Identifier: MIT */
/** @file frame_writer.c
 *  Draws particles to PNG files. */
#include "frame_writer.h"

#include <stdio.h>
#include <stdlib.h>

#include "threads.h"

#ifdef SPH2D_NO_RENDER

sph2d_status frame_writer_create(const frame_style *style, const cli_options *options, frame_writer **out,
                                 sph2d_report *report)
{
    (void)style;
    (void)options;
    *out = NULL;
    sph2d_diagnostic *d = sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GL_MISSING, NULL,
                                           "this build of sph2d cannot draw: it has no render library");
    sph2d_diagnostic_hint(d, "build with RENDER=1 for frames; 'sph2d run --no-frames' simulates without them");
    return SPH2D_RENDER;
}

void frame_writer_destroy(frame_writer *w)
{
    (void)w;
}

bool frame_writer_accepts(const frame_writer *w, const frame_style *style)
{
    (void)w;
    (void)style;
    return false;
}

sph2d_status frame_writer_write(frame_writer *w, const particle_source *source, const frame_style *style,
                                const char *path, frame_times *times, sph2d_report *report)
{
    (void)w;
    (void)source;
    (void)style;
    (void)path;
    (void)times;
    (void)report;
    return SPH2D_RENDER;
}

sph2d_status frame_writer_draw(frame_writer *w, const particle_source *source, const frame_style *style,
                               frame_times *times, sph2d_report *report)
{
    return frame_writer_write(w, source, style, NULL, times, report);
}

const unsigned char *frame_writer_pixels(const frame_writer *w)
{
    (void)w;
    return NULL;
}

sph2d_status frame_writer_save(frame_writer *w, const sph2d_picture *picture, const char *path, frame_times *times,
                               sph2d_report *report)
{
    (void)picture;
    return frame_writer_write(w, NULL, NULL, path, times, report);
}

char *frame_writer_describe(const frame_writer *w, char *out, size_t size)
{
    (void)w;
    snprintf(out, size, "none");
    return out;
}

const char *frame_writer_backends(void)
{
    return "none";
}

#else

struct frame_writer {
    sph2d_renderer *renderer;
    sph2d_frames made_for; /* its size and style are those of the renderer */
    frame_buffers buffers;
};

sph2d_status frame_writer_create(const frame_style *style, const cli_options *options, frame_writer **out,
                                 sph2d_report *report)
{
    *out = NULL;
    frame_writer *w = calloc(1, sizeof *w);
    if (!w)
        return SPH2D_NOMEM;
    sph2d_render_options render = sph2d_render_options_default();
    render.width = (unsigned)style->frames.size[0];
    render.height = (unsigned)style->frames.size[1];
    render.style = style->frames.style;
    render.look = style->frames.look;
    render.background = style->frames.background;
    render.gl = options->gl;
    render.shader_dir = options->shader_dir;
    threads_draw_here();
    sph2d_status status = sph2d_renderer_create(&render, &w->renderer, report);
    if (status != SPH2D_OK) {
        free(w);
        return status;
    }
    w->made_for = style->frames;
    *out = w;
    return SPH2D_OK;
}

void frame_writer_destroy(frame_writer *w)
{
    if (!w)
        return;
    sph2d_renderer_destroy(w->renderer);
    frame_free(&w->buffers);
    free(w);
}

bool frame_writer_accepts(const frame_writer *w, const frame_style *style)
{
    return w->made_for.size[0] == style->frames.size[0] && w->made_for.size[1] == style->frames.size[1] &&
           w->made_for.style == style->frames.style && w->made_for.look == style->frames.look &&
           w->made_for.background == style->frames.background;
}

static sph2d_status draw(frame_writer *w, const sph2d_picture *picture, frame_times *times, sph2d_report *report)
{
    const sph2d_status status = sph2d_renderer_draw(w->renderer, picture, report);
    if (status == SPH2D_OK && times) {
        const frame_times one = {1, sph2d_renderer_times(w->renderer)};
        frame_times_add(times, &one);
    }
    return status;
}

sph2d_status frame_writer_draw(frame_writer *w, const particle_source *source, const frame_style *style,
                               frame_times *times, sph2d_report *report)
{
    sph2d_picture picture;
    const sph2d_status status = frame_make(source, style, &w->buffers, &picture, report);
    return status == SPH2D_OK ? draw(w, &picture, times, report) : status;
}

const unsigned char *frame_writer_pixels(const frame_writer *w)
{
    return sph2d_renderer_pixels(w->renderer);
}

sph2d_status frame_writer_save(frame_writer *w, const sph2d_picture *picture, const char *path, frame_times *times,
                               sph2d_report *report)
{
    sph2d_status status = draw(w, picture, times, report);
    if (status == SPH2D_OK)
        status = sph2d_renderer_write_png(w->renderer, path, report);
    if (status == SPH2D_OK && times)
        times->sum.encode += sph2d_renderer_times(w->renderer).encode;
    return status;
}

sph2d_status frame_writer_write(frame_writer *w, const particle_source *source, const frame_style *style,
                                const char *path, frame_times *times, sph2d_report *report)
{
    sph2d_picture picture;
    const sph2d_status status = frame_make(source, style, &w->buffers, &picture, report);
    return status == SPH2D_OK ? frame_writer_save(w, &picture, path, times, report) : status;
}

char *frame_writer_describe(const frame_writer *w, char *out, size_t size)
{
    snprintf(out, size, "%s: %s", sph2d_renderer_gl(w->renderer), sph2d_renderer_gl_version(w->renderer));
    return out;
}

const char *frame_writer_backends(void)
{
    return sph2d_render_backends();
}

#endif

void frame_times_add(frame_times *sum, const frame_times *more)
{
    sum->frames += more->frames;
    sum->sum.draw += more->sum.draw;
    sum->sum.read += more->sum.read;
    sum->sum.encode += more->sum.encode;
}

char *frame_times_describe(char out[TEXT_SIZE], const frame_times *times)
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
