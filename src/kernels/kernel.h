/* SPDX-License-Identifier: MIT */
/** @file kernel.h
 *  Smoothing kernels in two dimensions, by the SUPPORT radius H: zero from H on.
 *
 *      W(r) = C/H^2 f(q),   grad W = C/H^4 g(q) (x_i - x_j),   q = r/H,   g(q) = f'(q)/q <= 0
 *
 *  g is finite at q = 0 in all of them, so that no pair term divides by r. The smoothing length h of the literature is
 *  H/2 for the cubic spline and Wendland's kernels, H/3 for the quintic spline.
 *
 *  kernel        C             f(q)                                              source
 *  wendland_c2   7/pi          (1-q)^4 (4q+1)                                    Wendland 1995
 *  wendland_c4   9/pi          (1-q)^6 (35/3 q^2 + 6q + 1)                       Wendland 1995
 *  wendland_c6   78/(7 pi)     (1-q)^8 (32q^3 + 25q^2 + 8q + 1)                  Wendland 1995
 *  cubic         40/(7 pi)     2 [(1-q)^3 - 4 (1/2-q)^3]                         Monaghan & Lattanzio 1985
 *  quintic       63/(478 pi)   (3-3q)^5 - 6 (2-3q)^5 + 15 (1-3q)^5               Schoenberg 1946, Morris 1997
 *
 *  with each bracket cut off at zero. The kind is a compile-time constant wherever speed matters. */
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
    case SPH2D_KERNEL_WENDLAND_C6:
        return 78 / (7 * SPH2D__PI);
    case SPH2D_KERNEL_CUBIC:
        return 40 / (7 * SPH2D__PI);
    case SPH2D_KERNEL_QUINTIC:
        return 63 / (478 * SPH2D__PI);
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
    case SPH2D_KERNEL_WENDLAND_C6:
        return t4 * t4 * (((32 * q + 25) * q + 8) * q + 1);
    case SPH2D_KERNEL_CUBIC: {
        sph2d__lanes s = sph2d__above_zero(0.5 - q);
        return 2 * (t2 * t - 4 * s * s * s);
    }
    case SPH2D_KERNEL_QUINTIC: {
        sph2d__lanes a = 3 * t, b = sph2d__above_zero(2 - 3 * q), c = sph2d__above_zero(1 - 3 * q);
        sph2d__lanes a2 = a * a, b2 = b * b, c2 = c * c;
        return a2 * a2 * a - 6 * b2 * b2 * b + 15 * c2 * c2 * c;
    }
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
    case SPH2D_KERNEL_WENDLAND_C6:
        return -22 * t4 * t2 * t * ((16 * q + 7) * q + 1);
    case SPH2D_KERNEL_CUBIC: {
        /* Below q = 1/2 the two brackets are 6 (3q - 2) q: written so that nothing cancels and no division is left. */
        sph2d__lanes inner = 18 * q - 12, outer = -6 * t2 / sph2d__lanes_max(q, (sph2d__lanes){0} + 0.5);
        return sph2d__lanes_below(q, 0.5, inner, outer);
    }
    case SPH2D_KERNEL_QUINTIC: {
        /* f' = 3 [-5 (3-s)^4 + 30 (2-s)^4 - 75 (1-s)^4], s = 3q; for s < 1 it is 3 (-120 s + 120 s^3 - 50 s^4) exactly.
         */
        sph2d__lanes s = 3 * q, a = 3 - s, b = sph2d__above_zero(2 - s);
        a = sph2d__above_zero(a);
        sph2d__lanes a2 = a * a, b2 = b * b;
        sph2d__lanes inner = 9 * (-120 + s * s * (120 - 50 * s));
        sph2d__lanes outer = 9 * (30 * b2 * b2 - 5 * a2 * a2) / sph2d__lanes_max(s, (sph2d__lanes){0} + 1.0);
        return sph2d__lanes_below(s, 1.0, inner, outer);
    }
    case SPH2D_KERNEL_WENDLAND_C2:
        return -20 * t2 * t;
    }
    return sph2d__lanes_all(NAN);
}

/** f(q) of one distance. */
static inline double sph2d__kernel_value_at(sph2d_kernel kind, double q)
{
    sph2d__lanes value = sph2d__kernel_value(kind, sph2d__lanes_all(q));
    return value[0];
}

/** g(q) of one distance. */
static inline double sph2d__kernel_slope_at(sph2d_kernel kind, double q)
{
    sph2d__lanes slope = sph2d__kernel_slope(kind, sph2d__lanes_all(q));
    return slope[0];
}

#endif
