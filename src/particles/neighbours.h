/* SPDX-License-Identifier: MIT */
/** @file neighbours.h
 *  The neighbours of every particle with the gradients of the kernel, found once and used many times: rows of a sparse
 *  matrix.
 *
 *  As many consecutive particles as the instruction set has lanes make a slice (SELL-C, Kreutzer et al. 2014). Its
 *  pairs are kept slot by slot: pair k of each of its particles, side by side. Sums over neighbours then run in lanes
 *  without a remainder, and add the same numbers in the same order at any width. A particle with fewer neighbours than
 *  the most of its slice has pairs with itself, or with boundary particle 0, and gradients of zero behind its own. In
 *  the order of cells the particles of a slice have about as many neighbours each, so that few pairs are such: 1 in 18
 *  on a disturbed lattice.
 *
 *  Gradients are floats: their seven digits are more than the positions' change over a step leaves right, and the sums
 *  wait for memory. The two gradients of a pair are opposite to the bit.
 *
 *  Pairs lie in slabs, one for each SPH2D__SLAB particles, so that threads fill them without waiting for each other. A
 *  slab has the same room for all; when one is full, all get more, and the filling starts again. */
#ifndef SPH2D_PARTICLES_NEIGHBOURS_H
#define SPH2D_PARTICLES_NEIGHBOURS_H

#include <stdint.h>

#include "base/memory.h"

/** Particles of one slab: few enough to share uneven work; a multiple of the lanes of every instruction set. */
enum { SPH2D__SLAB = 256 };
/** Lanes of the narrowest and the widest instruction set. */
enum { SPH2D__NARROWEST = 2, SPH2D__WIDEST = 8 };

/** What a loop over the particles of a slab sums up. */
typedef struct sph2d__slab_sum {
    double first, second, third; /**< sums */
    double most;                 /**< the largest of something, 0 at least */
} sph2d__slab_sum;

/** Where the pairs of some consecutive particles are, in slots of one pair each. */
typedef struct sph2d__slice {
    size_t begin;   /**< first pair of the first slot */
    uint32_t fluid; /**< slots with pairs with fluid particles: the first ones */
    uint32_t walls; /**< slots with pairs with boundary particles, behind them */
} sph2d__slice;

typedef struct sph2d__neighbours {
    sph2d__slice *slices;
    uint32_t *index;  /**< of each pair: the other particle */
    double *gradient; /**< of each pair: the gradient that the method keeps, two floats (lanes.h) */
    uint32_t *found;  /**< of each slab: room for the neighbours of a slice while they are searched, `longest` each */
    sph2d__slab_sum *sums; /**< of each slab: room for what a loop sums up, so that the order of sums is always one */
    size_t particles;      /**< room */
    size_t each;           /**< pairs of a particle that there is room for, on average in a slab */
    size_t lanes; /**< particles of a slice, and the way from slot to slot: those of the loops that filled it last. The
                     name of an instruction set does not tell them, as a compiler's flags may widen all of them */
} sph2d__neighbours;

/** Most neighbours that one particle can have. */
static inline size_t sph2d__neighbours_longest(const sph2d__neighbours *n)
{
    return 4 * n->each;
}

/** Room for `count` particles with `each` pairs on average in every slab. What was there is lost. False when memory is
 *  short. */
bool sph2d__neighbours_reserve(sph2d__neighbours *n, sph2d__memory *memory, size_t count, size_t each);
void sph2d__neighbours_free(sph2d__neighbours *n, sph2d__memory *memory);

/** The number of slabs of so many particles. */
static inline size_t sph2d__slabs(size_t particles)
{
    return (particles + SPH2D__SLAB - 1) / SPH2D__SLAB;
}

/** The sums of so many slabs, added from the first to the last. */
sph2d__slab_sum sph2d__neighbours_total(const sph2d__neighbours *n, size_t slabs);

#endif
