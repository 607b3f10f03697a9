/* SPDX-License-Identifier: MIT */
/** @file cells.h
 *  The cell grid: particles are sorted by cells, so that neighbours lie in contiguous ranges.
 *
 *  A grid of cells covers the particles. A cell is at least one support radius high, and `columns` cells together are
 *  at least one support radius wide. A counting sort puts the store in the order of the cells, row by row; linked lists
 *  would give the same order, but cannot be built by several threads. The particles of neighbouring cells of one row
 *  are then one contiguous range, and all neighbours of a particle lie in three ranges. Narrower cells have fewer
 *  candidates beyond the support, but need more lookups of ranges. A rim of empty cells around the grid makes sure that
 *  the cells around every particle exist.
 *
 *  In a periodic direction the cells divide the period. Cells around a particle that reach across its end are ranges of
 *  their own (six at most), each with the offset to the particle's image beside them. There are no ghost particles to
 *  store, update or keep out of files. */
#ifndef SPH2D_PARTICLES_CELLS_H
#define SPH2D_PARTICLES_CELLS_H

#include "particles/period.h"
#include "particles/store.h"

/** Support radii of empty cells around the grid. */
enum { SPH2D__RIM = 2 };

typedef struct sph2d__cells {
    sph2d__period period;          /**< set by the owner */
    uint32_t columns;              /**< cells in a row per support radius, at least 1; set by the owner */
    double origin_x, origin_y;     /**< lower left corner of the grid with its rim [m] */
    double width, height;          /**< of a cell [m] */
    double inverse_x, inverse_y;   /**< 1/width, 1/height [1/m] */
    uint32_t nx, ny;               /**< cells, rim included */
    SPH2D__ARRAY uint32_t *start;  /**< first particle of each cell, nx * ny + 1 values */
    SPH2D__ARRAY uint32_t *places; /**< of each sorter and cell: number of particles, then index of the next one */
    SPH2D__ARRAY uint32_t *cell;   /**< cell of each particle, in the order before the last sorting */
    SPH2D__ARRAY uint32_t *order;  /**< particle order[k] becomes particle k */
    size_t cell_capacity, place_capacity, particle_capacity;
} sph2d__cells;

/** Sorts the particles into cells of at least `support` and reorders the store. Positions must be finite. False when
 *  memory is short; there are no cells then, and sph2d__cells_find finds none. */
bool sph2d__cells_build(sph2d__cells *cells, sph2d__store *store, double support, sph2d__memory *memory);
/** Its first part alone, for a device that fills them: lays the grid around particles whose smallest and largest x and y are
 *  given, min_x, min_y, max_x, max_y, and reserves memory, for `more` places than cells. */
bool sph2d__cells_lay(sph2d__cells *cells, const sph2d__store *store, const double around[4], double support,
                      size_t more, sph2d__memory *memory);
void sph2d__cells_free(sph2d__cells *cells, sph2d__memory *memory);

/** Maximum number of ranges: four rows, each cut by the end of a period and again by the end of a tile. */
enum { SPH2D__RANGES = 16 };

/** Ranges of neighbour candidates around a position: particles begin[r] to end[r] - 1 for r < count. Add (x[r], y[r])
 *  to the position to get its image beside the particles of range r. */
typedef struct sph2d__ranges {
    int count;
    uint32_t begin[SPH2D__RANGES], end[SPH2D__RANGES];
    double x[SPH2D__RANGES], y[SPH2D__RANGES];
} sph2d__ranges;

/** Index of the cell that contains a position, if the cells around it lie in the grid; otherwise UINT32_MAX: no
 *  particle is within the support radius. Positions must be wrapped into the period. */
static inline uint32_t sph2d__cells_find(const sph2d__cells *cells, double x, double y)
{
    double fx = (x - cells->origin_x) * cells->inverse_x;
    double fy = (y - cells->origin_y) * cells->inverse_y;
    if (!(fx >= cells->columns && fy >= 1 && fx < (double)cells->nx - cells->columns && fy < cells->ny - 1.0))
        return UINT32_MAX;
    return (uint32_t)fy * cells->nx + (uint32_t)fx;
}

/** The cell of a particle of the grid, clamped against rounding. */
static inline uint32_t sph2d__cell_of(const sph2d__cells *cells, double x, double y)
{
    const double rim_x = (double)SPH2D__RIM * cells->columns, rim_y = SPH2D__RIM;
    const double last_x = cells->nx - 1.0 - rim_x, last_y = cells->ny - 1.0 - rim_y;
    double fx = (x - cells->origin_x) * cells->inverse_x, fy = (y - cells->origin_y) * cells->inverse_y;
    fx = fx > rim_x ? fx : rim_x;
    fy = fy > rim_y ? fy : rim_y;
    fx = fx < last_x ? fx : last_x;
    fy = fy < last_y ? fy : last_y;
    return (uint32_t)fy * cells->nx + (uint32_t)fx;
}

/** sph2d__cells_ranges where a direction is periodic. */
void sph2d__cells_periodic_ranges(const sph2d__cells *cells, uint32_t cell, sph2d__ranges *to);

/** The ranges of the cells around a cell from sph2d__cells_find; none is empty. */
static inline void sph2d__cells_ranges(const sph2d__cells *cells, uint32_t cell, sph2d__ranges *to)
{
    if (cells->period.length_x > 0 || cells->period.length_y > 0) {
        sph2d__cells_periodic_ranges(cells, cell, to);
        return;
    }
    SPH2D__ARRAY const uint32_t *row = cells->start + cell - cells->nx - cells->columns;
    to->count = 0;
    for (int k = 0; k < 3; ++k, row += cells->nx) {
        int r = to->count;
        to->begin[r] = row[0];
        to->end[r] = row[2 * cells->columns + 1];
        to->x[r] = to->y[r] = 0;
        to->count += to->begin[r] < to->end[r];
    }
}

/** Cells of a row in a tile. Floats relative to the lower left corner of a tile are as precise everywhere as near the
 *  origin. */
enum { SPH2D__TILE = 256 };

/** The lower left corner of a cell's tile [m]. */
static inline double sph2d__tile_x(const sph2d__cells *cells, uint32_t column)
{
    return cells->origin_x + (double)(column / SPH2D__TILE * SPH2D__TILE) * cells->width;
}
static inline double sph2d__tile_y(const sph2d__cells *cells, uint32_t row)
{
    return cells->origin_y + (double)row * cells->height;
}

/** A rectangle of cells: columns `left` to `right`, rows `bottom` to `top`, both included. */
typedef struct sph2d__patch {
    uint32_t left, right, bottom, top;
} sph2d__patch;

/** The cells that a box touches, clamped to those whose neighbours lie in the grid. False when no particle is within
 *  the support radius of the box. Positions must be wrapped into the period. */
static inline bool sph2d__cells_patch(const sph2d__cells *cells, double low_x, double low_y, double high_x,
                                      double high_y, sph2d__patch *to)
{
    double reach = cells->columns, last_x = cells->nx - reach - 1, last_y = cells->ny - 2.0;
    double left = (low_x - cells->origin_x) * cells->inverse_x, right = (high_x - cells->origin_x) * cells->inverse_x;
    double bottom = (low_y - cells->origin_y) * cells->inverse_y, top = (high_y - cells->origin_y) * cells->inverse_y;
    if (!(right >= reach && top >= 1 && left < last_x + 1 && bottom < last_y + 1))
        return false;
    to->left = (uint32_t)(left > reach ? left : reach);
    to->right = (uint32_t)(right < last_x ? right : last_x);
    to->bottom = (uint32_t)(bottom > 1 ? bottom : 1);
    to->top = (uint32_t)(top < last_y ? top : last_y);
    return true;
}

/** The ranges of the cells of a patch and around it; `cut`: each within one tile, with offsets from its corner. The
 *  patch with the cells around it must not be wider or higher than a period, nor higher than four rows. */
void sph2d__cells_around(const sph2d__cells *cells, const sph2d__patch *patch, bool cut, sph2d__ranges *to);

/** Loops over the particles `j` of all ranges `r`. */
#define SPH2D__FOR_NEIGHBOURS(ranges, r, j)                                                                            \
    for (int r = 0; r < (ranges)->count; ++r)                                                                          \
        for (size_t j = (ranges)->begin[r]; j < (ranges)->end[r]; ++j)

#endif
