/* SPDX-License-Identifier: MIT */
/** @file png_file.h
 *  Writes pixels to a PNG file. */
#ifndef SPH2D_RENDER_PNG_FILE_H
#define SPH2D_RENDER_PNG_FILE_H

#include <stdbool.h>

#include "sph2d/status.h"

/** Writes width * height pixels of 4 bytes, top row first, atomically as an 8-bit PNG file: RGBA, or RGB without the
 *  fourth. The same pixels give the same bytes. Errors: SPH2D_CANTCREAT, SPH2D_IO, SPH2D_NOMEM. */
sph2d_status sph2d__png_write(const char *path, const unsigned char *pixels, unsigned width, unsigned height,
                              bool alpha, sph2d_report *report);

#endif
