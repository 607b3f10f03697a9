/* SPDX-License-Identifier: MIT */
/** @file shortest.h
 *  The way between two particles, of which each has images in periodic directions. */
#ifndef SPH2D_METHODS_COMMON_SHORTEST_H
#define SPH2D_METHODS_COMMON_SHORTEST_H

#include "simd/lanes.h"

/** The way between the nearest images, given one between any two that are less than a period apart; `length` 0: there
 *  is but one. Opposite ways stay opposite to the bit. */
SPH2D__INLINE sph2d__lanes sph2d__shortest(sph2d__lanes way, double length)
{
    const sph2d__lanes period = (sph2d__lanes){0} + length;
    if (length > 0)
        way += sph2d__lanes_where(-period / 2, way, period) - sph2d__lanes_where(way, period / 2, period);
    return way;
}

#endif
