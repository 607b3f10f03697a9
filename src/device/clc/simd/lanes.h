/* SPDX-License-Identifier: MIT */
/** @file lanes.h
 *  Vectors of one lane: a thread is a particle. What it is in C: src/simd/lanes.h. */
#ifndef SPH2D_SIMD_LANES_H
#define SPH2D_SIMD_LANES_H

#include "base/address.h"

#define SPH2D__INLINE static inline __attribute__((always_inline))
#define SPH2D__LANES 1
typedef double sph2d__real;
typedef double sph2d__lanes;

#define SPH2D__LANE(a, l) (a)

SPH2D__INLINE sph2d__lanes sph2d__lanes_all(double a)
{
    return a;
}
SPH2D__INLINE sph2d__lanes sph2d__lanes_sqrt(sph2d__lanes a)
{
    return sqrt(a);
}
SPH2D__INLINE sph2d__lanes sph2d__lanes_max(sph2d__lanes a, sph2d__lanes b)
{
    return a > b ? a : b;
}
SPH2D__INLINE sph2d__lanes sph2d__lanes_min(sph2d__lanes a, sph2d__lanes b)
{
    return a < b ? a : b;
}
SPH2D__INLINE sph2d__lanes sph2d__lanes_where(sph2d__lanes left, sph2d__lanes right, sph2d__lanes a)
{
    return left > right ? a : 0;
}
SPH2D__INLINE sph2d__lanes sph2d__lanes_load(__global const double *from)
{
    return *from;
}
SPH2D__INLINE void sph2d__lanes_store(__global double *to, sph2d__lanes a)
{
    *to = a;
}

#endif
