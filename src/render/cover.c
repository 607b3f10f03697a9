/* SPDX-License-Identifier: MIT */
/** @file cover.c
 *  Area coverage by accumulation: an edge adds to each pixel that it crosses the area on its right, as the change from
 *  the pixel before; the sum along a row is the cover. */
#include "render/cover.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

bool sph2d__cover_create(sph2d__cover *cover, int width, int height)
{
    const size_t columns = (size_t)width, rows = (size_t)height;
    *cover = (sph2d__cover){.width = width, .height = height, .top = height, .bottom = 0};
    cover->pixels = calloc(columns * rows, 1);
    cover->changes = calloc((columns + 2) * rows, sizeof *cover->changes);
    if (cover->pixels && cover->changes)
        return true;
    sph2d__cover_destroy(cover);
    return false;
}

void sph2d__cover_destroy(sph2d__cover *cover)
{
    free(cover->pixels);
    free(cover->changes);
    *cover = (sph2d__cover){0};
}

void sph2d__cover_clear(sph2d__cover *cover, int width, int height)
{
    cover->width = width;
    cover->height = cover->top = height;
    cover->bottom = 0;
    memset(cover->pixels, 0, (size_t)cover->width * (size_t)cover->height);
}

/* Adds the part of an edge within a row, from x to `next` (both within the image), `rise` rows high. */
static void add_to_row(float *row, double x, double next, double rise)
{
    const double low = fmin(x, next), high = fmax(x, next);
    const int first = (int)low, last = (int)high;
    if (first == last) {
        const double right = 1.0 - (0.5 * (low + high) - first); /* of this pixel */
        row[first] += (float)(rise * right);
        row[first + 1] += (float)(rise * (1.0 - right));
        return;
    }
    const double slope = rise / (high - low); /* rows per column */
    double before = 0.0;                      /* what the pixels so far have of `rise` */
    for (int k = first; k <= last; ++k) {
        const double from = fmax(low, k), to = fmin(high, k + 1);
        const double right = slope * ((k + 1) - 0.5 * (from + to)) * (to - from) + slope * (from - low);
        row[k] += (float)(right - before);
        before = right;
    }
    row[last + 1] += (float)(rise - before);
}

void sph2d__cover_edge(sph2d__cover *cover, const double from[2], const double to[2])
{
    if (from[1] == to[1])
        return;
    const bool down = from[1] < to[1];
    const double *upper = down ? from : to, *lower = down ? to : from, sign = down ? 1.0 : -1.0;
    const double top = fmax(upper[1], 0.0), bottom = fmin(lower[1], cover->height);
    if (!(top < bottom))
        return;
    const double slope = (lower[0] - upper[0]) / (lower[1] - upper[1]);
    const int first = (int)top, end = (int)ceil(bottom);
    cover->top = first < cover->top ? first : cover->top;
    cover->bottom = end > cover->bottom ? end : cover->bottom;
    for (int k = first; k < end; ++k) {
        const double y = fmax(top, k), below = fmin(bottom, k + 1);
        const double x = upper[0] + slope * (y - upper[1]), next = upper[0] + slope * (below - upper[1]);
        float *row = cover->changes + (size_t)k * ((size_t)cover->width + 2);
        add_to_row(row, fmin(fmax(x, 0.0), cover->width), fmin(fmax(next, 0.0), cover->width), sign * (below - y));
    }
}

void sph2d__cover_fill(sph2d__cover *cover)
{
    const size_t columns = (size_t)cover->width;
    for (int k = cover->top; k < cover->bottom; ++k) {
        float *change = cover->changes + (size_t)k * (columns + 2), sum = 0.0F;
        unsigned char *pixel = cover->pixels + (size_t)k * columns;
        for (size_t i = 0; i < columns; ++i) {
            sum += change[i];
            const float part = fabsf(sum), all = (float)pixel[i] + 255.0F * (part < 1.0F ? part : 1.0F) + 0.5F;
            pixel[i] = (unsigned char)(all < 255.0F ? all : 255.0F);
        }
        memset(change, 0, (columns + 2) * sizeof *change);
    }
    cover->top = cover->height;
    cover->bottom = 0;
}
