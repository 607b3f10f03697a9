/* SPDX-License-Identifier: MIT */
/** @file viscosity_pair.h
 *  Pair terms of viscosity, in the forms of viscosity.h. No loops. A viscosity that depends on the strain rate changes
 *  only the `share` passed in. */
#ifndef SPH2D_METHODS_TERMS_VISCOSITY_PAIR_H
#define SPH2D_METHODS_TERMS_VISCOSITY_PAIR_H

#include <math.h>

#include "simd/lanes.h"

/** Sums of the Laplacian form, without the factors that are common to all neighbours. */
typedef struct sph2d__drag {
    sph2d__lanes x, y;
} sph2d__drag;

/** Adds a neighbour: `share` is V_j (W'/r) or V_j lap W, (dvx, dvy) the difference of the velocities. */
SPH2D__INLINE void sph2d__drag_add(sph2d__drag *sum, sph2d__lanes share, sph2d__lanes dvx, sph2d__lanes dvy)
{
    sum->x += share * dvx;
    sum->y += share * dvy;
}

/** Sums for the largest eigenvalue of a particle's block (viscosity.h), without the common factors; negative. */
typedef struct sph2d__block {
    sph2d__lanes xx, xy, yy;
} sph2d__block;

/** Adds a neighbour: `share` is V_j (W'/r) k_ij. */
SPH2D__INLINE void sph2d__block_add(sph2d__block *sum, sph2d__lanes share, sph2d__lanes dx, sph2d__lanes dy)
{
    sum->xx += share * dx * dx;
    sum->xy += share * dx * dy;
    sum->yy += share * dy * dy;
}

/** The larger eigenvalue of minus a sum. */
static inline double sph2d__block_most(double xx, double xy, double yy)
{
    double half = (xx - yy) / 2;
    return sqrt(half * half + xy * xy) - (xx + yy) / 2;
}

#endif
