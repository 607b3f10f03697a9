/* SPDX-License-Identifier: MIT */
/** @file region.h
 *  The area that a block's liquid fills: its shape without the solids in it, as a grid of squares that know how much of
 *  them is covered. */
#ifndef SPH2D_START_REGION_H
#define SPH2D_START_REGION_H

#include "base/memory.h"
#include "scene/shape.h"

/** Points in which a cell is looked at: the area of a cell counts so many. */
enum { SPH2D__REGION_WHOLE = 256, SPH2D__REGION_QUARTER = SPH2D__REGION_WHOLE / 4 };

typedef struct sph2d__region {
    const sph2d_scene *scene;
    const sph2d_shape *shape;
    sph2d_vec2 axis;   /**< direction of the rows, of length 1 */
    sph2d_vec2 origin; /**< where the first cell begins */
    double size;       /**< of a cell [m] */
    size_t nx, ny;
    unsigned char *quarters; /**< of each cell four, lower left, lower right, upper left, upper right: points covered */
} sph2d__region;

/** Looks at the grid of cells of a size that has a corner at `corner` and covers the shape, with `margin` cells around.
 *  Of a polygon the grid lies along its longest side, and its columns and rows begin where the most of the polygon's
 *  sides lie on them. The caller frees it. False when memory is short. */
bool sph2d__region_make(sph2d__region *region, const sph2d_scene *scene, const sph2d_shape *shape, sph2d_vec2 corner,
                        double size, int margin, sph2d__memory *memory);

/** A place in cells, from the first one's corner, and back. */
static inline sph2d_vec2 sph2d__region_in_cells(const sph2d__region *r, sph2d_vec2 p)
{
    double x = p.x - r->origin.x, y = p.y - r->origin.y;
    return (sph2d_vec2){(x * r->axis.x + y * r->axis.y) / r->size, (y * r->axis.x - x * r->axis.y) / r->size};
}
static inline sph2d_vec2 sph2d__region_place(const sph2d__region *r, double i, double j)
{
    return (sph2d_vec2){r->origin.x + (i * r->axis.x - j * r->axis.y) * r->size,
                        r->origin.y + (i * r->axis.y + j * r->axis.x) * r->size};
}
void sph2d__region_free(sph2d__region *region, sph2d__memory *memory);

/** Points of a cell that are covered. */
static inline int sph2d__region_cover(const sph2d__region *r, size_t cell)
{
    const unsigned char *q = r->quarters + 4 * cell;
    return q[0] + q[1] + q[2] + q[3];
}

/** Covered area [m^2]. */
double sph2d__region_area(const sph2d__region *region);

/** Whether a place is in the area: in the shape and in no solid. */
bool sph2d__region_contains(const sph2d__region *region, sph2d_vec2 p);

/** The middle of the covered part of a cell. */
sph2d_vec2 sph2d__region_middle(const sph2d__region *region, size_t cell);

#endif
