/* SPDX-License-Identifier: MIT */
/** @file packed.h
 *  Arrays of floats in a store. */
#ifndef SPH2D_METHODS_COMMON_PACKED_H
#define SPH2D_METHODS_COMMON_PACKED_H

#include "particles/store.h"

/** One of the two arrays of floats in the space of an array of doubles. */
static inline float *sph2d__floats(const sph2d__store *store, double *array, int which)
{
    void *floats = array; /* it never holds anything else */
    return floats ? (float *)floats + (size_t)which * store->capacity : NULL;
}

#endif
