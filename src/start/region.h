/* SPDX-License-Identifier: MIT */
/** @file region.h
 *  The area of a block's liquid: its shape without the solids in it, as the covered part of each cell of a grid; or that
 *  of a snapshot's. */
#ifndef SPH2D_START_REGION_H
#define SPH2D_START_REGION_H

#include "sim/simulation.h"

/** Sample points of a cell, and of a quarter of it. */
enum { SPH2D__REGION_POINTS = 256, SPH2D__QUARTER_POINTS = SPH2D__REGION_POINTS / 4 };

struct sph2d__cloud;

typedef struct sph2d__region {
    const sph2d_sim *sim;
    const sph2d_shape *shape;
    const struct sph2d__cloud *cloud; /**< if not NULL: only what this covers, in no block and behind no wall ... */
    double least_cover;               /**< ... by as much */
    sph2d_vec2 axis;                  /**< direction of the rows, of length 1 */
    sph2d_vec2 origin;                /**< corner of the first cell */
    double size;                      /**< of a cell [m] */
    size_t nx, ny;
    unsigned char
        *quarters; /**< covered points of each cell's lower left, lower right, upper left and upper right quarter */
} sph2d__region;

/** Samples the area on a grid with cells of a size and a corner at `corner`, over the shape and `margin` cells around
 *  it. For a polygon the grid is parallel to the longest side instead, and shifted so that most of the sides lie on
 *  grid lines. The caller frees it. False when memory is short. */
bool sph2d__region_make(sph2d__region *region, sph2d_sim *sim, const sph2d_shape *shape, sph2d_vec2 corner, double size,
                        int margin);

/** Samples the part of a shape, a box, that a snapshot covers; the area is that of `cells` cells, if it covers as much.
 *  Cells and the rest are as above. */
bool sph2d__region_make_covered(sph2d__region *region, sph2d_sim *sim, const sph2d_shape *shape,
                                const struct sph2d__cloud *cloud, sph2d_vec2 corner, double size, int margin,
                                double cells);

/** Conversion of a position to cells from the first cell's corner, and back. */
static inline sph2d_vec2 sph2d__region_in_cells(const sph2d__region *r, sph2d_vec2 p)
{
    double x = p.x - r->origin.x, y = p.y - r->origin.y;
    return (sph2d_vec2){(x * r->axis.x + y * r->axis.y) / r->size, (y * r->axis.x - x * r->axis.y) / r->size};
}
static inline sph2d_vec2 sph2d__region_position(const sph2d__region *r, double i, double j)
{
    return (sph2d_vec2){r->origin.x + (i * r->axis.x - j * r->axis.y) * r->size,
                        r->origin.y + (i * r->axis.y + j * r->axis.x) * r->size};
}
void sph2d__region_free(sph2d__region *region, sph2d__memory *memory);

/** Number of covered points of a cell. */
static inline int sph2d__region_covered(const sph2d__region *r, size_t cell)
{
    const unsigned char *q = r->quarters + 4 * cell;
    return q[0] + q[1] + q[2] + q[3];
}

/** Covered area [m^2]. */
double sph2d__region_area(const sph2d__region *region);

/** Whether a position is in the area: in the shape and in no solid. */
bool sph2d__region_contains(const sph2d__region *region, sph2d_vec2 p);

/** A place in the covered part of a cell: its centroid, or the point nearest to it where a thin solid or a corner takes
 *  that. */
sph2d_vec2 sph2d__region_place(const sph2d__region *region, size_t cell);

#endif
