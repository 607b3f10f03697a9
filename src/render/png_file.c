/* SPDX-License-Identifier: MIT */
/** @file png_file.c
 *  Writes PNG: its chunks by libpng, the data in them by zlib. libpng's errors are longjmps, which are confined to one
 *  small function. Its own filter takes bytes one by one, ten times as long as the one below, which compilers turn into
 *  vectors. */
#include "render/png_file.h"

#include <errno.h>
#include <png.h>
#include <setjmp.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#include "base/atomic_file.h"

/* The best of all filters with levels 1 to 6 on frames of 1280 x 720 of both styles: run-length encoding after the
 * Paeth filter; filter Up and Sub with level 1 are as fast on smooth water, and files larger by a quarter. */
enum { PAETH = 4, STRATEGY = Z_RLE, LEVEL = 1, WINDOW_BITS = 15, MEMORY = 8, CHUNK_BYTES = 1 << 16, PIXEL_MOST = 4 };

/* What takes rows of pixels: bytes a pixel and row, this row and the one above with a pixel of 0 before each, the row
 * filtered with its filter's number before it, and a chunk in the making. */
typedef struct encoder {
    size_t pixel, row;
    unsigned char *here, *above, *filtered, *memory, chunk[CHUNK_BYTES];
    z_stream stream;
} encoder;

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

/* ---- rows -------------------------------------------------------------------------------------------------------- */

/* Drops the fourth byte of a pixel where it is not wanted: the next pixel, or the room behind the row, is put over it. */
static void pack(unsigned char *restrict to, const unsigned char *restrict pixels, size_t count, size_t pixel)
{
    if (pixel == 4) {
        memcpy(to, pixels, 4 * count);
        return;
    }
    for (size_t k = 0; k < count; ++k)
        memcpy(to + 3 * k, pixels + 4 * k, 4);
}

/* Each byte less the one of left, above and upper left that is nearest to left + above - upper left: A. W. Paeth, Image
 * file compression made easy, Graphics Gems II, 1991. In 16 bits, of which vectors have most. */
static void filter(unsigned char *restrict to, const unsigned char *restrict here, const unsigned char *restrict above,
                   size_t count, size_t pixel)
{
    const unsigned char *before = here - pixel, *corner = above - pixel;
    for (size_t k = 0; k < count; ++k) {
        const short left = before[k], up = above[k], upper_left = corner[k];
        const short by_left = (short)(up - upper_left), by_up = (short)(left - upper_left),
                    by_both = (short)(by_left + by_up);
        const short p = by_left < 0 ? (short)-by_left : by_left, q = by_up < 0 ? (short)-by_up : by_up,
                    r = by_both < 0 ? (short)-by_both : by_both;
        const short other = q <= r ? up : upper_left, nearest = q <= r ? q : r;
        to[k] = (unsigned char)(here[k] - (p <= nearest ? left : other));
    }
}

/* ---- file -------------------------------------------------------------------------------------------------------- */

static const png_byte data_name[5] = "IDAT", end_name[5] = "IEND";

static bool create_encoder(encoder *e, unsigned width, bool alpha)
{
    e->pixel = alpha ? 4 : 3;
    e->row = e->pixel * width;
    e->memory = calloc(3, e->row + PIXEL_MOST);
    if (!e->memory)
        return false;
    e->here = e->memory + PIXEL_MOST;
    e->above = e->here + e->row + PIXEL_MOST;
    e->filtered = e->above + e->row + PIXEL_MOST - 1;
    e->filtered[0] = PAETH;
    return deflateInit2(&e->stream, LEVEL, Z_DEFLATED, WINDOW_BITS, MEMORY, STRATEGY) == Z_OK;
}

static void destroy_encoder(encoder *e)
{
    deflateEnd(&e->stream); /* zeroed is an error without effect */
    free(e->memory);
}

/* Compresses what the stream has been given, and writes each chunk that is full; at the end the last one, too. */
static void write_data(png_structp png, encoder *e, int flush)
{
    int state;
    do {
        if (e->stream.avail_out == 0 || !e->stream.next_out) {
            if (e->stream.next_out)
                png_write_chunk(png, data_name, e->chunk, sizeof e->chunk);
            e->stream.next_out = e->chunk;
            e->stream.avail_out = sizeof e->chunk;
        }
        state = deflate(&e->stream, flush);
    } while (e->stream.avail_out == 0 || (flush == Z_FINISH && state == Z_OK));
    if (flush == Z_FINISH)
        png_write_chunk(png, data_name, e->chunk, sizeof e->chunk - e->stream.avail_out);
}

/* False when libpng failed. No variable is changed after setjmp and used after the jump. */
static bool encode(png_structp png, png_infop info, FILE *file, encoder *e, const unsigned char *pixels, unsigned width,
                   unsigned height)
{
    if (setjmp(png_jmpbuf(png)) != 0)
        return false;
    png_init_io(png, file);
    png_set_IHDR(png, info, width, height, 8, e->pixel == 4 ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    for (unsigned row = 0; row < height; ++row) {
        pack(e->here, pixels + (size_t)row * width * 4, width, e->pixel);
        filter(e->filtered + 1, e->here, e->above, e->row, e->pixel);
        e->stream.next_in = e->filtered;
        e->stream.avail_in = (uInt)(e->row + 1);
        write_data(png, e, row + 1 < height ? Z_NO_FLUSH : Z_FINISH);
        unsigned char *above = e->above;
        e->above = e->here;
        e->here = above;
    }
    png_write_chunk(png, end_name, NULL, 0);
    return true;
}

/* Writes an open file; on failure errno has the reason. */
static bool write_png(FILE *file, const unsigned char *pixels, unsigned width, unsigned height, bool alpha)
{
    errno = 0;
    encoder *e = calloc(1, sizeof *e);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, on_error, on_warning);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    const bool written =
        e && info && create_encoder(e, width, alpha) && encode(png, info, file, e, pixels, width, height);
    const int error = errno;
    png_destroy_write_struct(&png, &info);
    if (e)
        destroy_encoder(e);
    free(e);
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
