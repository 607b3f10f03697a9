/* SPDX-License-Identifier: MIT */
/** @file wcsph_pair.h
 *  The pair terms of wcsph.h. No loops; every lane is a particle with a neighbour of its own. */
#ifndef SPH2D_METHODS_WCSPH_WCSPH_PAIR_H
#define SPH2D_METHODS_WCSPH_WCSPH_PAIR_H

#include "methods/wcsph/wcsph_frozen.h"
#include "simd/lanes.h"

/* Factor of the limiter of dissipation (Zhang, Hu & Adams 2017). */
SPH2D__FIXED double SPH2D__LIMITER = 3;
/* C, the factor of the diffusion of density. */
SPH2D__FIXED double SPH2D__DIFFUSION = 0.03;

/** A symmetric matrix in each lane. */
typedef struct symmetric {
    sph2d__lanes xx, xy, yy;
} symmetric;

/** The smaller of both where they have one sign, else 0. */
SPH2D__INLINE sph2d__lanes sph2d__minmod(sph2d__lanes a, sph2d__lanes b)
{
    const sph2d__lanes none = {0};
    return sph2d__lanes_max(sph2d__lanes_min(a, b), none) + sph2d__lanes_min(sph2d__lanes_max(a, b), none);
}

#endif
