/* SPDX-License-Identifier: MIT */
/** @file png_file.c
 *  Writes PNG with libpng. Its errors are longjmps, which are confined to one small function. */
#include "render/png_file.h"

#include <errno.h>
#include <png.h>
#include <setjmp.h>
#include <stdbool.h>
#include <zlib.h>

#include "base/atomic_file.h"

/* The best of all filters with levels 1 to 6 on frames of 1280 x 720 of both styles: run-length encoding after the
 * Paeth filter takes 14 to 23 ms and 60 to 400 kB; libpng's defaults take three times as long for the same size; filter
 * Up with level 1 is a little faster on smooth water, but files are half as large again. */
enum { FILTER = PNG_FILTER_PAETH, STRATEGY = Z_RLE, COMPRESSION_LEVEL = 1, CHUNK_BYTES = 1 << 16 };

/* libpng's default prints to stderr. */
static void on_error(png_structp png, png_const_charp message)
{
    (void)message; /* out of disk space or memory: errno has the reason */
    png_longjmp(png, 1);
}

static void on_warning(png_structp png, png_const_charp message)
{
    (void)png;
    (void)message;
}

/* False when libpng failed. No variable is changed after setjmp and used after the jump. */
static bool encode(png_structp png, png_infop info, FILE *file, const unsigned char *pixels, unsigned width,
                   unsigned height, bool alpha)
{
    if (setjmp(png_jmpbuf(png)) != 0)
        return false;
    png_init_io(png, file);
    png_set_compression_buffer_size(png, CHUNK_BYTES);
    png_set_compression_level(png, COMPRESSION_LEVEL);
    png_set_compression_strategy(png, STRATEGY);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, FILTER);
    png_set_IHDR(png, info, width, height, 8, alpha ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    if (!alpha)
        png_set_filler(png, 0, PNG_FILLER_AFTER); /* drops the fourth byte of a pixel */
    for (unsigned row = 0; row < height; ++row)
        png_write_row(png, pixels + (size_t)row * width * 4);
    png_write_end(png, NULL);
    return true;
}

/* Writes an open file; on failure errno has the reason. */
static bool write_png(FILE *file, const unsigned char *pixels, unsigned width, unsigned height, bool alpha)
{
    errno = 0;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, on_error, on_warning);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    const bool written = info && encode(png, info, file, pixels, width, height, alpha);
    const int error = errno;
    png_destroy_write_struct(&png, &info);
    errno = error != 0 ? error : ENOMEM; /* the only other reason */
    return written;
}

sph2d_status sph2d__png_write(const char *path, const unsigned char *pixels, unsigned width, unsigned height,
                              bool alpha, sph2d_report *report)
{
    sph2d__atomic_file atomic = {0};
    const sph2d_status begun = sph2d__atomic_begin(&atomic, path, report);
    if (begun != SPH2D_OK)
        return begun;
    FILE *file = fopen(atomic.temp_path, "wb");
    if (!file) {
        sph2d__report_errno(report, SPH2D_CODE_FILE_WRITE, "create", path, errno);
        sph2d__atomic_abort(&atomic);
        return SPH2D_CANTCREAT;
    }
    bool written = write_png(file, pixels, width, height, alpha);
    int error = errno;
    if (fclose(file) != 0 && written) {
        error = errno;
        written = false;
    }
    if (!written) {
        sph2d__report_errno(report, SPH2D_CODE_FILE_WRITE, "write", path, error);
        sph2d__atomic_abort(&atomic);
        return SPH2D_IO;
    }
    return sph2d__atomic_commit(&atomic, report);
}
