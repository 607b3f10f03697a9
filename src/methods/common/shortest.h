/* SPDX-License-Identifier: MIT */
/** @file shortest.h
 *  Minimum image convention: the distance between two particles in a periodic direction. */
#ifndef SPH2D_METHODS_COMMON_SHORTEST_H
#define SPH2D_METHODS_COMMON_SHORTEST_H

#include "simd/lanes.h"

/** The difference of coordinates between nearest images, given that between any two images less than a period apart;
 *  `length` 0: not periodic. Opposite arguments give opposite results to the bit. */
SPH2D__INLINE sph2d__lanes sph2d__shortest(sph2d__lanes d, double length)
{
    const sph2d__lanes period = (sph2d__lanes){0} + length;
    if (length > 0)
        d += sph2d__lanes_where(-period / 2, d, period) - sph2d__lanes_where(d, period / 2, period);
    return d;
}

#endif
