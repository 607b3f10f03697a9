/* SPDX-License-Identifier: MIT */
/** @file lumps.c
 *  Cloud-in-cell assignment of particles to the nodes of a grid. */
#include "render/lumps.h"

#include <stdlib.h>
#include <string.h>

sph2d_status sph2d__lumps_create(sph2d__lumps *lumps, int columns, int rows, sph2d_report *report)
{
    *lumps = (sph2d__lumps){.capacity = (size_t)columns * (size_t)rows};
    lumps->weights = malloc(lumps->capacity * sizeof *lumps->weights);
    if (lumps->weights)
        return SPH2D_OK;
    sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL, "out of memory for drawing metaballs");
    return SPH2D_NOMEM;
}

void sph2d__lumps_reset(sph2d__lumps *lumps, int columns, int rows, double texel)
{
    lumps->columns = columns;
    lumps->rows = rows;
    lumps->texel = texel;
    memset(lumps->weights, 0, (size_t)columns * (size_t)rows * sizeof *lumps->weights);
}

bool sph2d__lumps_add(sph2d__lumps *lumps, const float pixel[2])
{
    const double x = pixel[0] / lumps->texel - 0.5, y = pixel[1] / lumps->texel - 0.5;
    if (!(x >= 0.0 && y >= 0.0 && x < lumps->columns - 1 && y < lumps->rows - 1))
        return false;
    const int column = (int)x, row = (int)y;
    const float right = (float)(x - column), below = (float)(y - row);
    float *upper = lumps->weights + (size_t)row * (size_t)lumps->columns + column, *lower = upper + lumps->columns;
    upper[0] += (1.0F - right) * (1.0F - below);
    upper[1] += right * (1.0F - below);
    lower[0] += (1.0F - right) * below;
    lower[1] += right * below;
    return true;
}

void sph2d__lumps_sum(sph2d__lumps *lumps, sph2d__field_grid *grid, const sph2d__view *view,
                      const sph2d__dot_list *list, double radius)
{
    const double texel = lumps->texel, reach = radius / texel;
    for (size_t i = 0; i < list->count; ++i) {
        float pixel[2];
        if (sph2d__view_place(view, list->x[i], list->y[i], list->reach, pixel) && !sph2d__lumps_add(lumps, pixel))
            sph2d__field_grid_add(grid, (float[2]){(float)(pixel[0] / texel), (float)(pixel[1] / texel)}, reach, 1.0F,
                                  NULL);
    }
    const float *weight = lumps->weights;
    for (int row = 0; row < lumps->rows; ++row)
        for (int column = 0; column < lumps->columns; ++column, ++weight)
            if (*weight > 0.0F)
                sph2d__field_grid_add(grid, (float[2]){(float)column + 0.5F, (float)row + 0.5F}, reach, *weight, NULL);
}

void sph2d__lumps_destroy(sph2d__lumps *lumps)
{
    free(lumps->weights);
    *lumps = (sph2d__lumps){0};
}
