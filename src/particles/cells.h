/* SPDX-License-Identifier: MIT */
/** @file cells.h
 *  Linked-list cells that put particles in order, and the contiguous ranges of neighbours that follow from it.
 *
 *  A grid of square cells, at least one support radius wide, covers the particles. Each cell heads a linked list of its
 *  particles; walking the lists cell by cell, row by row, gives the order in which the store is then kept. In that
 * order the particles of three neighbouring cells of one row are one contiguous range, so that all neighbours of a
 * particle lie in three ranges. A rim of two empty cells around the grid makes every particle's 3 x 3 cells exist.
 *
 *  In a periodic direction the cells divide the period, and 3 x 3 cells that reach over its end go on at the other: as
 * ranges of their own (six at most), each with the way by which the asking particle must be moved to be beside them.
 * There are no ghost copies to store, refresh or keep out of files. */
#ifndef SPH2D_PARTICLES_CELLS_H
#define SPH2D_PARTICLES_CELLS_H

#include "particles/period.h"
#include "particles/store.h"

/** Empty cells around the grid. */
enum { SPH2D__RIM = 2 };

typedef struct sph2d__cells {
    sph2d__period period;        /**< set by the owner */
    double origin_x, origin_y;   /**< lower left corner of the grid with its rim [m] */
    double inverse_x, inverse_y; /**< one over the width and height of a cell [1/m] */
    uint32_t nx, ny;             /**< cells, rim included */
    uint32_t *start;             /**< first particle of each cell, nx * ny + 1 values */
    uint32_t *head;              /**< first particle of each cell's list */
    uint32_t *next;              /**< next particle in the list */
    uint32_t *cell;              /**< cell of each particle, then of each in the new order */
    uint32_t *order;             /**< particle order[k] becomes particle k */
    size_t cell_capacity, particle_capacity;
} sph2d__cells;

/** Sorts the particles into cells of at least `support` and reorders the store. Positions must be finite. False when
 *  memory is short. */
bool sph2d__cells_build(sph2d__cells *cells, sph2d__store *store, double support, sph2d__memory *memory, int threads);
void sph2d__cells_free(sph2d__cells *cells, sph2d__memory *memory);

/** The neighbours' ranges around a place: particles begin[r] to end[r] - 1 for r < count. A particle in range r is at a
 *  distance of (x[r], y[r]) more than the coordinates say: their images are the ones that are near. */
typedef struct sph2d__ranges {
    int count;
    uint32_t begin[6], end[6];
    double x[6], y[6];
} sph2d__ranges;

/** Index of the cell that holds a place, if its 3 x 3 cells lie in the grid; UINT32_MAX otherwise: no particle is
 * within one cell of it. A place beyond a period must be wrapped before. */
static inline uint32_t sph2d__cells_find(const sph2d__cells *cells, double x, double y)
{
    double fx = (x - cells->origin_x) * cells->inverse_x;
    double fy = (y - cells->origin_y) * cells->inverse_y;
    if (!(fx >= 1 && fy >= 1 && fx < cells->nx - 1.0 && fy < cells->ny - 1.0))
        return UINT32_MAX;
    return (uint32_t)fy * cells->nx + (uint32_t)fx;
}

/** The ranges of the 3 x 3 cells around a cell that sph2d__cells_find gave; none is empty. */
void sph2d__cells_ranges(const sph2d__cells *cells, uint32_t cell, sph2d__ranges *to);

/** Runs the statement behind it for each particle `j` in the ranges, `r` being the number of its range. */
#define SPH2D__FOR_NEIGHBOURS(ranges, r, j)                                                                            \
    for (int r = 0; r < (ranges)->count; ++r)                                                                          \
        for (size_t j = (ranges)->begin[r]; j < (ranges)->end[r]; ++j)

#endif
