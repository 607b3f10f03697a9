/* SPDX-License-Identifier: MIT */
/** @file number.h
 *  Numbers in scene files: decimal, with a point, without a unit. */
#ifndef SPH2D_BASE_NUMBER_H
#define SPH2D_BASE_NUMBER_H

#include <stdint.h>

typedef enum sph2d__number {
    SPH2D__NUMBER_OK,
    SPH2D__NUMBER_NONE,       /**< no number, or followed by other text */
    SPH2D__NUMBER_NOT_FINITE, /**< NaN or infinity, in any of its spellings */
    SPH2D__NUMBER_RANGE       /**< a number that the type cannot hold */
} sph2d__number;

/** Reads all of `text` as a double. The thread must be in the C locale (c_locale.h). */
sph2d__number sph2d__number_real(const char *text, double *value);

/** Reads all of `text` as a non-negative integer. */
sph2d__number sph2d__number_count(const char *text, uint64_t *value);

#endif
