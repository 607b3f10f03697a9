/* SPDX-License-Identifier: MIT */
/** @file checksum.h
 *  A checksum of a state, so that a bit that turned on the disk does not turn up in a resumed run. */
#ifndef SPH2D_FILES_CHECKSUM_H
#define SPH2D_FILES_CHECKSUM_H

#include <string.h>

#include "sph2d/array.h"

/** Start with 0 and take the arrays in their order. Every value counts with its place. */
static inline uint64_t sph2d__checksum(uint64_t sum, const sph2d_array *array)
{
    for (unsigned c = 0; c < array->components; ++c) {
        const char *data = array->data[c];
        sum += array->count + 1;
        for (size_t i = 0; i < array->count; ++i) {
            uint64_t word;
            memcpy(&word, data + i * array->stride * sizeof word, sizeof word);
            sum = (sum ^ word) * 0x9e3779b97f4a7c15u;
            sum ^= sum >> 32;
        }
    }
    return sum;
}

#endif
