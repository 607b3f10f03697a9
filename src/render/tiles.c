/* SPDX-License-Identifier: MIT */
/** @file tiles.c
 *  The tiles of the image that particles touch. */
#include "render/tiles.h"

#include <stdlib.h>
#include <string.h>

sph2d_status sph2d__tiles_create(sph2d__tiles *tiles, int width, int height, sph2d_report *report)
{
    *tiles = (sph2d__tiles){.columns = (width + SPH2D__TILE - 1) / SPH2D__TILE,
                            .rows = (height + SPH2D__TILE - 1) / SPH2D__TILE};
    tiles->touched = malloc((size_t)tiles->columns * (size_t)tiles->rows);
    if (tiles->touched)
        return SPH2D_OK;
    sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL, "out of memory for drawing metaballs");
    return SPH2D_NOMEM;
}

/* The tile of a pixel coordinate, within the image. */
static int tile_of(double pixel, int count)
{
    if (pixel <= 0.0)
        return 0;
    const int tile = (int)(pixel / SPH2D__TILE);
    return tile < count ? tile : count - 1;
}

void sph2d__tiles_find(sph2d__tiles *tiles, const sph2d__view *view, const sph2d__dot_list *list)
{
    memset(tiles->touched, 0, (size_t)tiles->columns * (size_t)tiles->rows);
    for (size_t i = 0; i < list->count; ++i) {
        float pixel[2];
        if (!sph2d__view_place(view, list->x[i], list->y[i], list->reach, pixel))
            continue;
        const int left = tile_of(pixel[0] - list->reach, tiles->columns);
        const int right = tile_of(pixel[0] + list->reach, tiles->columns);
        const int top = tile_of(pixel[1] - list->reach, tiles->rows);
        const int bottom = tile_of(pixel[1] + list->reach, tiles->rows);
        for (int row = top; row <= bottom; ++row)
            memset(tiles->touched + (size_t)row * (size_t)tiles->columns + left, 1, (size_t)right - (size_t)left + 1);
    }
}

void sph2d__tiles_find_bytes(sph2d__tiles *tiles, const unsigned char *bytes, int width, int height)
{
    memset(tiles->touched, 0, (size_t)tiles->columns * (size_t)tiles->rows);
    for (int y = 0; y < height; ++y) {
        unsigned char *row = tiles->touched + (size_t)(y / SPH2D__TILE) * (size_t)tiles->columns;
        for (int x = 0; x < width; ++x)
            row[x / SPH2D__TILE] |= bytes[(size_t)y * (size_t)width + (size_t)x];
    }
}

void sph2d__tiles_draw(const sph2d__gl *gl, const sph2d__tiles *tiles, sph2d__dots *dots)
{
    sph2d__dots_begin(gl, dots, SPH2D__SQUARE);
    for (int row = 0; row < tiles->rows; ++row)
        for (int column = 0; column < tiles->columns; ++column) {
            if (!tiles->touched[(size_t)row * (size_t)tiles->columns + (size_t)column])
                continue;
            const sph2d__dot tile = {
                .pixel = {((float)column + 0.5F) * SPH2D__TILE, ((float)row + 0.5F) * SPH2D__TILE}};
            sph2d__dots_add(gl, dots, &tile);
        }
    sph2d__dots_end(gl, dots);
}

void sph2d__tiles_destroy(sph2d__tiles *tiles)
{
    free(tiles->touched);
    *tiles = (sph2d__tiles){0};
}
