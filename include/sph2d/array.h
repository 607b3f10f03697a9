/* SPDX-License-Identifier: MIT */
/** @file array.h
 *  A borrowed, typed array: how fields and states leave the library and come back. */
#ifndef SPH2D_ARRAY_H
#define SPH2D_ARRAY_H

#include <stddef.h>
#include <stdint.h>

typedef enum sph2d_type { SPH2D_F64 = 0, SPH2D_U64 = 1 } sph2d_type;

/** What an array belongs to. */
typedef enum sph2d_group {
    SPH2D_GROUP_FLUID = 0, /**< one value a fluid particle */
    SPH2D_GROUP_WALL = 1,  /**< one value a boundary particle */
    SPH2D_GROUP_RUN = 2    /**< the run itself: clock, counters, sources */
} sph2d_group;

/** `count` values of `components` numbers each, one pointer a component (struct of arrays). The strings have static
 *  storage; the data is borrowed from whoever handed the array out. */
typedef struct sph2d_array {
    sph2d_group group;
    const char *name;        /**< "Coordinates"; unique inside its group */
    const char *description; /**< one sentence */
    signed char unit[3];     /**< exponents of metre, kilogram and second */
    sph2d_type type;
    unsigned components; /**< 1 or 2 */
    size_t count;        /**< values; 1 for a scalar of the run */
    size_t stride;       /**< 1, or 0 when all values are the one that data points at */
    const void *data[2]; /**< double or uint64_t by `type`; data[1] is NULL for one component */
} sph2d_array;

#endif
