/* SPDX-License-Identifier: MIT */
/** @file frame_writer.h
 *  Draws particles to PNG files. In a build without the render library (SPH2D_NO_RENDER) the functions report that. */
#ifndef SPH2D_CLI_FRAME_WRITER_H
#define SPH2D_CLI_FRAME_WRITER_H

#include "frame.h"
#include "options.h"
#include "text.h"

typedef struct frame_writer frame_writer;

/** Creates a writer for frames of a size and style, with the context and shaders of the options. The caller owns *out
 *  (NULL after a failure). Errors: SPH2D_RENDER, SPH2D_NOMEM. */
sph2d_status frame_writer_create(const frame_style *style, const cli_options *options, frame_writer **out,
                                 sph2d_report *report);
void frame_writer_destroy(frame_writer *writer);

/** Whether it can draw frames of this size and style. */
bool frame_writer_accepts(const frame_writer *writer, const frame_style *style);

/** The total times of frames. */
typedef struct frame_times {
    size_t frames;
    sph2d_frame_times sum; /**< [s] */
} frame_times;

/** Draws the particles, and adds the times to `times`, which may be NULL. One thread at a time may draw. Errors:
 *  SPH2D_FORMAT, SPH2D_RENDER, SPH2D_NOMEM. */
sph2d_status frame_writer_draw(frame_writer *writer, const particle_source *source, const frame_style *style,
                               frame_times *times, sph2d_report *report);

/** What was drawn last: pixels of 4 bytes, top row first, valid until the next call. */
const unsigned char *frame_writer_pixels(const frame_writer *writer);

/** Draws a picture, writes the file atomically, and adds the times to `times`. Errors: SPH2D_RENDER, SPH2D_CANTCREAT,
 *  SPH2D_IO, SPH2D_NOMEM. */
sph2d_status frame_writer_save(frame_writer *writer, const sph2d_picture *picture, const char *path, frame_times *times,
                               sph2d_report *report);

/** The same of particles; `times` may be NULL. Errors: also SPH2D_FORMAT. */
sph2d_status frame_writer_write(frame_writer *writer, const particle_source *source, const frame_style *style,
                                const char *path, frame_times *times, sph2d_report *report);

void frame_times_add(frame_times *sum, const frame_times *more);

/** The mean times of a frame, "24 ms each to draw, 2 to read back, 9 to encode"; empty for none. Returns `out`. */
char *frame_times_describe(char out[TEXT_SIZE], const frame_times *times);

/** The OpenGL in use, "osmesa: 4.5 (Core Profile) Mesa ...". Returns `out`. */
char *frame_writer_describe(const frame_writer *writer, char *out, size_t size);

/** The OpenGL backends of this build, "osmesa egl"; "none" without the render library. */
const char *frame_writer_backends(void);

#endif
