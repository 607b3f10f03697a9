/* SPDX-License-Identifier: MIT */
/** @file tiles.c
 *  The tiles of the image in which something is to be drawn. */
#include "render/tiles.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

sph2d_status sph2d__tiles_create(sph2d__tiles *tiles, int width, int height, sph2d_report *report)
{
    *tiles = (sph2d__tiles){.columns = (width + SPH2D__TILE - 1) / SPH2D__TILE,
                            .rows = (height + SPH2D__TILE - 1) / SPH2D__TILE};
    tiles->kinds = malloc((size_t)tiles->columns * (size_t)tiles->rows);
    if (tiles->kinds)
        return SPH2D_OK;
    sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL, "out of memory for drawing metaballs");
    return SPH2D_NOMEM;
}

/* Wider surroundings take more time than they save. */
static const double widest = 2.0 * SPH2D__TILE; /* [px] */

static unsigned char kind_of(const sph2d__field_grid *field, int left, int top, const sph2d__tile_rule *rule)
{
    const int right = left + SPH2D__TILE, bottom = top + SPH2D__TILE;
    const sph2d__field_limits own = sph2d__field_grid_limits(field, left, top, right, bottom);
    if (own.high < rule->lowest)
        return SPH2D__TILE_EMPTY;
    if (own.low < rule->full || own.high - own.low > rule->range || rule->around > widest)
        return SPH2D__TILE_TOUCHED;
    const int n = (int)ceil(rule->around);
    const sph2d__field_limits wide = sph2d__field_grid_limits(field, left - n, top - n, right + n, bottom + n);
    return wide.low < rule->full || wide.high - wide.low > rule->range ? SPH2D__TILE_TOUCHED : SPH2D__TILE_INSIDE;
}

void sph2d__tiles_find(sph2d__tiles *tiles, const sph2d__field_grid *field, const sph2d__tile_rule *rule)
{
    unsigned char *kind = tiles->kinds;
    memset(kind, SPH2D__TILE_EMPTY, (size_t)tiles->columns * (size_t)tiles->rows);
    for (int row = 0; row < tiles->rows; ++row)
        for (int column = 0; column < tiles->columns; ++column, ++kind)
            if ((row + 1) * SPH2D__TILE > field->top && row * SPH2D__TILE < field->bottom)
                *kind = kind_of(field, column * SPH2D__TILE, row * SPH2D__TILE, rule);
}

void sph2d__tiles_find_bytes(sph2d__tiles *tiles, const unsigned char *bytes, int width, int height)
{
    memset(tiles->kinds, 0, (size_t)tiles->columns * (size_t)tiles->rows);
    for (int y = 0; y < height; ++y) {
        unsigned char *row = tiles->kinds + (size_t)(y / SPH2D__TILE) * (size_t)tiles->columns;
        for (int x = 0; x < width; ++x)
            row[x / SPH2D__TILE] |= bytes[(size_t)y * (size_t)width + (size_t)x] ? SPH2D__TILE_TOUCHED : 0;
    }
}

void sph2d__tiles_draw(const sph2d__gl *gl, const sph2d__tiles *tiles, sph2d__dots *dots, unsigned char kind)
{
    sph2d__dots_begin(gl, dots, SPH2D__SQUARE);
    const unsigned char *kinds = tiles->kinds;
    for (int row = 0; row < tiles->rows; ++row, kinds += tiles->columns)
        for (int column = 0, end; column < tiles->columns; column = end) {
            for (end = column; end < tiles->columns && kinds[end] == kind; ++end)
                continue;
            const sph2d__dot run = {
                .pixel = {0.5F * (float)(column + end) * SPH2D__TILE, ((float)row + 0.5F) * SPH2D__TILE},
                .across = (float)(end - column)};
            if (end > column)
                sph2d__dots_add(gl, dots, &run);
            else
                ++end;
        }
    sph2d__dots_end(gl, dots);
}

void sph2d__tiles_destroy(sph2d__tiles *tiles)
{
    free(tiles->kinds);
    *tiles = (sph2d__tiles){0};
}
