/* SPDX-License-Identifier: MIT */
/** @file bits.h
 *  The bits of a number, and the number of bits. */
#ifndef SPH2D_BASE_BITS_H
#define SPH2D_BASE_BITS_H

#include <stdint.h>
#include <string.h>

static inline uint64_t sph2d__bits_of(double a)
{
    uint64_t bits;
    memcpy(&bits, &a, sizeof bits);
    return bits;
}

static inline double sph2d__of_bits(uint64_t bits)
{
    double a;
    memcpy(&a, &bits, sizeof a);
    return a;
}

#endif
