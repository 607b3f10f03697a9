/* SPDX-License-Identifier: MIT */
/** @file painter.h
 *  Draws particles into PNG files. A build without the render library (SPH2D_NO_RENDER) has a painter that only says
 *  so. */
#ifndef SPH2D_CLI_PAINTER_H
#define SPH2D_CLI_PAINTER_H

#include "options.h"
#include "picture.h"
#include "text.h"

typedef struct cli_painter cli_painter;

/** Makes a painter for pictures of a look's size and style, with the context and shaders that the options name. The
 *  caller owns *out (NULL after a failure). Errors: SPH2D_RENDER, SPH2D_NOMEM. */
sph2d_status painter_create(const cli_look *look, const cli_options *options, cli_painter **out, sph2d_report *report);
void painter_destroy(cli_painter *p);

/** Whether it can draw with this look too. */
bool painter_fits(const cli_painter *p, const cli_look *look);

/** What frames took, all together. */
typedef struct painter_times {
    size_t frames;
    sph2d_frame_times sum; /**< [s] */
} painter_times;

/** Draws the particles and writes the file, whole or not at all, and adds what it took to `spent`
 *  (NULL: nowhere). Errors: SPH2D_FORMAT, SPH2D_RENDER, SPH2D_CANTCREAT,
 *  SPH2D_IO, SPH2D_NOMEM. */
sph2d_status painter_paint(cli_painter *p, const particle_source *source, const cli_look *look, const char *path,
                           painter_times *spent, sph2d_report *report);

void painter_times_add(painter_times *sum, const painter_times *more);

/** The mean of a frame, "24 ms each to draw, 2 to read back, 9 to encode"; empty for none. Returns `out`. */
char *painter_times_describe(char out[TEXT_SIZE], const painter_times *times);

/** What it draws with, "osmesa: 4.5 (Core Profile) Mesa ...". Returns `out`. */
char *painter_describe(const cli_painter *p, char *out, size_t size);

/** The contexts that this build has, "osmesa egl"; "none" without the render library. */
const char *painter_backends(void);

#endif
