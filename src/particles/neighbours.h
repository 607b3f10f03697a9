/* SPDX-License-Identifier: MIT */
/** @file neighbours.h
 *  Neighbour lists with the kernel gradients of all pairs, built once and used many times: the rows of a sparse matrix.
 *
 *  As many consecutive particles as the instruction set has lanes form a slice (SELL-C, Kreutzer et al. 2014). Its
 *  pairs are stored slot by slot: pair k of each of its particles, side by side. Sums over neighbours then run in lanes
 *  without a remainder, and add the same numbers in the same order at any width. A particle with fewer neighbours than
 *  the maximum of its slice is padded by pairs with itself, or with boundary particle 0, with gradients of zero. In the
 *  order of cells the particles of a slice have about the same number of neighbours, so padding is rare: 1 pair in 18
 *  on a disturbed lattice.
 *
 *  Gradients are floats: positions change during a step by more than the seventh digit, and the sums are limited by
 *  memory bandwidth. The two gradients of a pair are exactly opposite.
 *
 *  Pairs are stored in slabs, one for each SPH2D__SLAB particles, so that threads fill them independently. All slabs
 *  have the same capacity; when one is full, all grow, and the lists are built again. */
#ifndef SPH2D_PARTICLES_NEIGHBOURS_H
#define SPH2D_PARTICLES_NEIGHBOURS_H

#include <stdint.h>

#include "base/address.h"
#include "base/memory.h"

/** Particles of a slab: few enough to balance uneven work; a multiple of the lanes of every instruction set. */
enum { SPH2D__SLAB = 256 };
/** Lanes of a device, the narrowest, and of the widest instruction set. */
enum { SPH2D__NARROWEST = 1, SPH2D__WIDEST = 8 };
/** From slot to slot on a device. */
enum { SPH2D__DEVICE_STRIDE = 32 };

/** The pairs of a slice. A slot has one pair of each of its particles. */
typedef struct sph2d__slice {
    size_t begin;   /**< first pair of the first slot */
    uint32_t fluid; /**< slots of pairs with fluid particles, which come first */
    uint32_t walls; /**< slots of pairs with boundary particles, after them */
} sph2d__slice;

typedef struct sph2d__neighbours {
    SPH2D__ARRAY sph2d__slice *slices;
    SPH2D__ARRAY uint32_t *index;  /**< of each pair: the other particle */
    SPH2D__ARRAY double *gradient; /**< of each pair: a kernel gradient, two floats (lanes.h); NULL if not asked for */
    SPH2D__ARRAY uint32_t
        *found;       /**< of each slab: buffer for the search of a slice's neighbours, `longest` for each particle */
    size_t particles; /**< capacity */
    size_t each;      /**< capacity in pairs per particle, on average over a slab */
    size_t stride;    /**< from a slot of a slice to the next: `lanes`, or more where the slots of slices take turns */
    size_t lanes; /**< particles of a slice, and the stride from slot to slot: as in the loops that filled it last. The
                     instruction set does not determine it, as compiler flags may widen all of them */
} sph2d__neighbours;

/** Maximum number of neighbours of one particle. */
static inline size_t sph2d__neighbours_longest(const sph2d__neighbours *n)
{
    return 4 * n->each;
}

/** Reserves memory for `count` particles with `each` pairs on average in every slab, and for their gradients. The contents
 *  are lost. False when
 *  memory is short. */
bool sph2d__neighbours_reserve(sph2d__neighbours *n, sph2d__memory *memory, size_t count, size_t each, bool gradients);
void sph2d__neighbours_free(sph2d__neighbours *n, sph2d__memory *memory);

/** Number of slabs for a number of particles. */
static inline size_t sph2d__slabs(size_t particles)
{
    return (particles + SPH2D__SLAB - 1) / SPH2D__SLAB;
}

#endif
