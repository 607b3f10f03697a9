/* SPDX-License-Identifier: MIT */
/** @file lanes.h
 *  Vectors of one lane: a thread is a particle. What it is in C: src/simd/lanes.h. */
#ifndef SPH2D_SIMD_LANES_H
#define SPH2D_SIMD_LANES_H

#include <stdint.h>

#include "base/address.h"

#define SPH2D__INLINE static inline __attribute__((always_inline))
#define SPH2D__LANES 1
#define SPH2D__LANE(a, l) (a)
#ifdef SPH2D__MIXED
typedef float sph2d__real;
#else
typedef double sph2d__real;
#endif
typedef sph2d__real sph2d__lanes;

SPH2D__INLINE sph2d__lanes sph2d__lanes_all(double a)
{
    return (sph2d__real)a;
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
/* Of any memory. */
#define sph2d__lanes_load(from) (*(from))
/* From a slot of a neighbour list to the next: threads that run together read side by side. */
#define SPH2D__STRIDE SPH2D__DEVICE_STRIDE

#ifndef SPH2D__MIXED
SPH2D__INLINE void sph2d__lanes_store(__global double *to, sph2d__lanes a)
{
    *to = a;
}

typedef struct sph2d__four {
    sph2d__lanes a, b, c, d;
} sph2d__four;

SPH2D__INLINE unsigned sph2d__lanes_which(sph2d__lanes a, double limit)
{
    return a < limit;
}
SPH2D__INLINE sph2d__lanes sph2d__lanes_gather(__global const double *from, __global const uint32_t *index)
{
    return from[*index];
}
SPH2D__INLINE sph2d__lanes sph2d__floats_load(__global const float *from)
{
    return (double)*from;
}
SPH2D__INLINE void sph2d__floats_store(__global float *to, sph2d__lanes a)
{
    *to = (float)a;
}
SPH2D__INLINE sph2d__four sph2d__four_load(__global const float *from)
{
    const float4 row = vload4(0, from);
    return (sph2d__four){(double)row.x, (double)row.y, (double)row.z, (double)row.w};
}
SPH2D__INLINE sph2d__four sph2d__four_gather(__global const float *from, __global const uint32_t *index)
{
    return sph2d__four_load(from + 4 * (size_t)*index);
}
SPH2D__INLINE void sph2d__four_store(__global float *to, sph2d__four v)
{
    vstore4((float4)((float)v.a, (float)v.b, (float)v.c, (float)v.d), 0, to);
}

#endif

#endif
