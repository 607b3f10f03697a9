/* SPDX-License-Identifier: MIT */
/** @file viscosity_pair.h
 *  Pair terms of viscosity, in the forms of viscosity.h. No loops. A viscosity that depends on the strain rate changes
 *  only the `share` passed in. */
#ifndef SPH2D_METHODS_TERMS_VISCOSITY_PAIR_H
#define SPH2D_METHODS_TERMS_VISCOSITY_PAIR_H

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

#endif
