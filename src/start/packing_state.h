/* SPDX-License-Identifier: MIT */
/** @file packing_state.h
 *  The internal state of a packing, and the functions that packing*.c share. */
#ifndef SPH2D_START_PACKING_STATE_H
#define SPH2D_START_PACKING_STATE_H

#include <math.h>

#include "start/packing.h"

/* Entries in the table of kernel gradients, by q^2: linear interpolation is accurate to 1e-6. */
enum { SPH2D__PACKING_SLOPES = 2048 };
/* The skin of the neighbour lists [spacings]: they are rebuilt when two particles may have approached by as much. */
static const double SPH2D__PACKING_SKIN = 0.5;

/** The missing area of a cell, and its centroid. */
typedef struct sph2d__missing {
    sph2d_vec2 at;
    double part; /**< of a particle's area */
} sph2d__missing;

/** The state of a packing. */
typedef struct sph2d__packing_state {
    sph2d_sim *sim;
    sph2d__region *region;
    sph2d_kernel kernel;
    double size, support; /**< spacing; H */
    /** kernel gradient over the distance, times the area of a particle; by q^2 times SPH2D__PACKING_SLOPES */
    double slope[SPH2D__PACKING_SLOPES + 2];
    size_t count, movers; /**< positions, and those that move */
    sph2d_vec2 *at, *velocity, *gradient,
        *old;                 /**< of every particle: position, last step, gradient, position in the neighbour lists */
    uint32_t *mover;          /**< indices of particles that move */
    unsigned char *near_edge; /**< cells near ones that are not full */
    sph2d__missing *missing;  /**< of each cell */
    unsigned char *chosen;    /**< cells that get a particle */
    uint32_t *start, *order;  /**< buckets of the particles: by rows, H + skin wide */
    uint32_t *first, *neighbour; /**< neighbours of each mover */
    size_t neighbour_capacity;
    size_t bx, by;
    double bucket;
} sph2d__packing_state;

/** The number of cells of the region, and the cell of a position. */
static inline size_t sph2d__packing_cell_count(const sph2d__packing_state *p)
{
    return p->region->nx * p->region->ny;
}

static inline size_t sph2d__packing_cell(const sph2d__packing_state *p, sph2d_vec2 at)
{
    sph2d_vec2 cell = sph2d__region_in_cells(p->region, at);
    double i = fmin(fmax(floor(cell.x), 0), (double)p->region->nx - 1);
    double j = fmin(fmax(floor(cell.y), 0), (double)p->region->ny - 1);
    return (size_t)j * p->region->nx + (size_t)i;
}

/** Adds the gradient due to a part of a particle's area; the particle is at -(x, y) from the position. */
static inline void sph2d__packing_add_area(const sph2d__packing_state *p, double x, double y, double part,
                                           sph2d_vec2 *sum)
{
    double s = (x * x + y * y) * (SPH2D__PACKING_SLOPES / (p->support * p->support));
    if (!(s < SPH2D__PACKING_SLOPES))
        return;
    size_t k = (size_t)s;
    double g = part * (p->slope[k] + (s - (double)k) * (p->slope[k + 1] - p->slope[k]));
    sum->x += g * x;
    sum->y += g * y;
}

/** Dilates marks of cells, 1, by a number of cells. */
void sph2d__packing_dilate(const sph2d__packing_state *p, unsigned char *marks, size_t reach);

/** Replaces the covered points of each quarter cell by the missing ones that no boundary particle represents, sums these
 *  in `missing`, and marks the cells near them. */
void sph2d__packing_find_missing(sph2d__packing_state *p);

/** Adds the missing areas around a position, and its boundary particles, to its concentration gradient. */
void sph2d__packing_add_missing(const sph2d__packing_state *p, sph2d_vec2 at, sph2d_vec2 *sum);
void sph2d__packing_add_walls(const sph2d__packing_state *p, sph2d_vec2 at, sph2d_vec2 *sum);

/** Where the boundary particle that is too near to a position by the largest distance leaves it; the position itself if
 *  none is. */
sph2d_vec2 sph2d__packing_clear_of_walls(const sph2d__packing_state *p, sph2d_vec2 at);

/** Moves the particles until the gradients vanish; `residual` is the largest remaining gradient times the spacing.
 *  False when memory is short. */
bool sph2d__packing_relax(sph2d__packing_state *state, double *residual);

#endif
