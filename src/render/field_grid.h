/* SPDX-License-Identifier: MIT */
/** @file field_grid.h
 *  The sum of the fields of balls on a grid, such as the pixels of an image: each has r^4 - r^2 + 1/4, with r in units of
 *  its radius, as far as r^2 = 1/2.
 *
 *  On the CPU: a few vectors of four floats a row and ball take a fraction of what a triangle a ball takes in a software
 *  renderer, the sums are the same on all drivers, and they tell in which parts of the image nothing has to be shaded. */
#ifndef SPH2D_RENDER_FIELD_GRID_H
#define SPH2D_RENDER_FIELD_GRID_H

#include <stdbool.h>
#include <stddef.h>

/** A grid of squares of side 1, from the top left corner; the sums are those at their middles. */
typedef struct sph2d__field_grid {
    int columns, rows;
    int planes;      /**< 1: the field; 4: after a row of it one each of red, green and blue, times the field */
    size_t stride;   /**< floats from a row of a plane to that of the next plane, at least `columns` */
    float *sums;     /**< `planes` times `stride` floats a row */
    float *across;   /**< scratch, a row of a plane */
    size_t capacity; /**< [floats] of `sums` */
    int top, bottom; /**< rows that balls have touched, bottom excluded */
} sph2d__field_grid;

/** Makes a grid that may have so many columns and rows, of 0; false when memory is short. */
bool sph2d__field_grid_create(sph2d__field_grid *grid, int columns, int rows, int planes);

/** Sets all sums to 0, and the size, within that of creation. */
void sph2d__field_grid_reset(sph2d__field_grid *grid, int columns, int rows);

/** Adds a ball; only finite numbers and a radius above 0. `color` is read where there are planes for it. */
void sph2d__field_grid_add(sph2d__field_grid *grid, const float at[2], double radius, float weight,
                           const float color[3]);

/** The least and the greatest sum of the field. */
typedef struct sph2d__field_limits {
    float low, high;
} sph2d__field_limits;

/** Those in a box of squares, right column and lower row excluded, which is cut to the grid; something must be left. */
sph2d__field_limits sph2d__field_grid_limits(const sph2d__field_grid *grid, int left, int top, int right, int bottom);

/** The sums of the field in a row. */
static inline const float *sph2d__field_grid_row(const sph2d__field_grid *grid, int row)
{
    return grid->sums + (size_t)row * (size_t)grid->planes * grid->stride;
}

/** Frees it; it may be zeroed. */
void sph2d__field_grid_destroy(sph2d__field_grid *grid);

#endif
