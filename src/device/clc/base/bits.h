/* SPDX-License-Identifier: MIT */
/** @file bits.h
 *  The bits of a number, in OpenCL C. */
#ifndef SPH2D_BASE_BITS_H
#define SPH2D_BASE_BITS_H

#include <stdint.h>

static inline uint64_t sph2d__bits_of(double a)
{
    return as_ulong(a);
}

static inline double sph2d__of_bits(uint64_t bits)
{
    return as_double(bits);
}

#endif
