/* SPDX-License-Identifier: MIT */
/** @file packer.h
 *  What the parts of packing.c share: a packing under way, what is missing around its places, and their descent. */
#ifndef SPH2D_START_PACKER_H
#define SPH2D_START_PACKER_H

#include <math.h>

#include "start/packing.h"

/* Values of the kernel's slope that are kept, by q^2: between them straight lines are right to 1e-6. */
enum { SPH2D__PACKER_SLOPES = 2048 };
/* Neighbours are looked for this much farther than they act, in spacings, and again when one may have come so far. */
static const double SPH2D__PACKER_SKIN = 0.5;

/** One packing under way. */
typedef struct sph2d__packer {
    sph2d_sim *sim;
    sph2d__region *region;
    sph2d_kernel kernel;
    double size, support; /**< spacing; H */
    /** of W over the distance, times the area of a particle, by q^2 times the number of them */
    double slope[SPH2D__PACKER_SLOPES + 2];
    size_t count, movers;
    sph2d_vec2 *at, *velocity, *gradient, *old; /**< of every place; velocity: the last step */
    uint32_t *mover;                            /**< those that move */
    unsigned char *near_edge;                   /**< cells near which something is missing */
    unsigned char *chosen;                      /**< cells that have a place */
    uint32_t *start, *order;                    /**< buckets of the places: by rows, H + skin wide */
    uint32_t *first, *partner;                  /**< neighbours of each mover */
    size_t partner_capacity;
    size_t bx, by;
    double bucket;
} sph2d__packer;

/** The number of cells of the region, and the cell of a place. */
static inline size_t sph2d__packer_cells(const sph2d__packer *p)
{
    return p->region->nx * p->region->ny;
}

static inline size_t sph2d__packer_cell(const sph2d__packer *p, sph2d_vec2 at)
{
    sph2d_vec2 cell = sph2d__region_in_cells(p->region, at);
    double i = fmin(fmax(floor(cell.x), 0), (double)p->region->nx - 1);
    double j = fmin(fmax(floor(cell.y), 0), (double)p->region->ny - 1);
    return (size_t)j * p->region->nx + (size_t)i;
}

/** Adds a part of a particle's area at (x, y) from a place. */
static inline void sph2d__packer_add_area(const sph2d__packer *p, double x, double y, double part, sph2d_vec2 *sum)
{
    double s = (x * x + y * y) * (SPH2D__PACKER_SLOPES / (p->support * p->support));
    if (!(s < SPH2D__PACKER_SLOPES))
        return;
    size_t k = (size_t)s;
    double g = part * (p->slope[k] + (s - (double)k) * (p->slope[k + 1] - p->slope[k]));
    sum->x += g * x;
    sum->y += g * y;
}

/** Spreads marks of cells, 1, over a number of cells around them. */
void sph2d__packer_spread(const sph2d__packer *packer, unsigned char *marks, size_t reach);

/** Turns the cover of each quarter of a cell into what is missing, where no boundary particle stands for it, and marks
 *  the cells near which something is. */
void sph2d__packer_find_missing(sph2d__packer *packer);

/** Adds what is missing around a place, and the boundary particles there, to its gradient of concentration. */
void sph2d__packer_add_missing(const sph2d__packer *packer, sph2d_vec2 at, sph2d_vec2 *sum);
void sph2d__packer_add_walls(const sph2d__packer *packer, sph2d_vec2 at, sph2d_vec2 *sum);

/** Moves the places until the gradient is gone; `residual` is the largest that is left, times the spacing. False when
 *  memory is short. */
bool sph2d__packer_relax(sph2d__packer *packer, double *residual);

#endif
