/* SPDX-License-Identifier: MIT */
/** @file wcsph_pair.h
 *  The pair terms of wcsph.h. No loops; every lane is a particle with a neighbour of its own. */
#ifndef SPH2D_METHODS_WCSPH_WCSPH_PAIR_H
#define SPH2D_METHODS_WCSPH_WCSPH_PAIR_H

#include "methods/wcsph/wcsph.h"
#include "simd/lanes.h"

/* Factor of the limiter of dissipation (Zhang, Hu & Adams 2017). */
static const double SPH2D__LIMITER = 3;
/* C, the factor of the diffusion of density. */
static const double SPH2D__DIFFUSION = 0.03;

/** Two floats in the space of a double, as sph2d__float2 has them. */
static inline double sph2d__pair_of_floats(double a, double b)
{
    const float both[2] = {(float)a, (float)b};
    double kept;
    memcpy(&kept, both, sizeof kept);
    return kept;
}

SPH2D__INLINE sph2d__lanes sph2d__lanes_of_floats(const float *from)
{
    sph2d__lanes a;
    for (int l = 0; l < SPH2D__LANES; ++l)
        a[l] = (double)from[l];
    return a;
}

/** The smaller of both where they have one sign, else 0. */
SPH2D__INLINE sph2d__lanes sph2d__minmod(sph2d__lanes a, sph2d__lanes b)
{
    const sph2d__lanes none = {0};
    return sph2d__lanes_max(sph2d__lanes_min(a, b), none) + sph2d__lanes_min(sph2d__lanes_max(a, b), none);
}

#endif
