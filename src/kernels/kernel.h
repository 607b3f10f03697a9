/* SPDX-License-Identifier: MIT */
/** @file kernel.h
 *  Smoothing kernels in two dimensions, by the SUPPORT radius H: zero from H on.
 *
 *      W(r) = C/H^2 f(q),   grad W = C/H^4 g(q) (x_i - x_j),   q = r/H,   g(q) = f'(q)/q <= 0
 *
 *  g is finite at q = 0 in all of them, so that no pair term divides by r. The smoothing length h of the literature is
 *  H/2.
 *
 *  kernel        C             f(q)                                              source
 *  wendland_c2   7/pi          (1-q)^4 (4q+1)                                    Wendland 1995
 *  wendland_c4   9/pi          (1-q)^6 (35/3 q^2 + 6q + 1)                       Wendland 1995
 *
 *  with 1-q cut off at zero. The kind is a compile-time constant wherever speed matters. */
#ifndef SPH2D_KERNELS_KERNEL_H
#define SPH2D_KERNELS_KERNEL_H

#include <math.h>

#include "base/pi.h"
#include "simd/lanes.h"
#include "sph2d/scene.h"

/** C in W = C/H^2 f(q). */
SPH2D__INLINE double sph2d__kernel_constant(sph2d_kernel kind)
{
    switch (kind) {
    case SPH2D_KERNEL_WENDLAND_C4:
        return 9 / SPH2D__PI;
    case SPH2D_KERNEL_WENDLAND_C2:
        return 7 / SPH2D__PI;
    }
    return NAN; /* no kernel: compilers warn of one that is missing above */
}

/** The positive part. */
SPH2D__INLINE sph2d__lanes sph2d__above_zero(sph2d__lanes a)
{
    return sph2d__lanes_max(a, (sph2d__lanes){0});
}

/** f(q) for q >= 0. */
SPH2D__INLINE sph2d__lanes sph2d__kernel_value(sph2d_kernel kind, sph2d__lanes q)
{
    sph2d__lanes t = sph2d__above_zero(1 - q), t2 = t * t, t4 = t2 * t2;
    switch (kind) {
    case SPH2D_KERNEL_WENDLAND_C4:
        return t4 * t2 * (((sph2d__real)(35.0 / 3) * q + 6) * q + 1);
    case SPH2D_KERNEL_WENDLAND_C2:
        return t4 * (4 * q + 1);
    }
    return sph2d__lanes_all(NAN);
}

/** g(q) = f'(q)/q for q >= 0. */
SPH2D__INLINE sph2d__lanes sph2d__kernel_slope(sph2d_kernel kind, sph2d__lanes q)
{
    sph2d__lanes t = sph2d__above_zero(1 - q), t2 = t * t, t4 = t2 * t2;
    switch (kind) {
    case SPH2D_KERNEL_WENDLAND_C4:
        return (sph2d__real)(-56.0 / 3) * t4 * t * (5 * q + 1);
    case SPH2D_KERNEL_WENDLAND_C2:
        return -20 * t2 * t;
    }
    return sph2d__lanes_all(NAN);
}

/** f(q) of one distance. */
static inline double sph2d__kernel_value_at(sph2d_kernel kind, double q)
{
    sph2d__lanes value = sph2d__kernel_value(kind, sph2d__lanes_all(q));
    return SPH2D__LANE(value, 0);
}

/** g(q) of one distance. */
static inline double sph2d__kernel_slope_at(sph2d_kernel kind, double q)
{
    sph2d__lanes slope = sph2d__kernel_slope(kind, sph2d__lanes_all(q));
    return SPH2D__LANE(slope, 0);
}

#endif
