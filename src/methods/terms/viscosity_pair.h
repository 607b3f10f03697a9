/* SPDX-License-Identifier: MIT */
/** @file viscosity_pair.h
 *  What a pair of particles adds to viscosity, in the forms of viscosity.h. No loops. A law in which the viscosity
 *  depends on the rate of strain changes the shares that are given here, and nothing else. */
#ifndef SPH2D_METHODS_TERMS_VISCOSITY_PAIR_H
#define SPH2D_METHODS_TERMS_VISCOSITY_PAIR_H

#include "simd/lanes.h"

/** Sums of the Laplacian form, without the factors that a method multiplies by at the end. */
typedef struct sph2d__drag {
    sph2d__lanes x, y;
} sph2d__drag;

/** Adds a neighbour: `share` is V_j (W'/r) or V_j lap W, dv the difference of the velocities. */
SPH2D__INLINE void sph2d__drag_add(sph2d__drag *sum, sph2d__lanes share, sph2d__lanes dvx, sph2d__lanes dvy)
{
    sum->x += share * dvx;
    sum->y += share * dvy;
}

/** The stress along the line to a neighbour by the central form: `resisting` is -8 mu V_i V_j times v_ij . r_ij, and
 *  `tiny` what stands for r^2 between particles at one place. */
SPH2D__INLINE sph2d__lanes sph2d__central_stress(sph2d__lanes resisting, sph2d__lanes r2, sph2d__lanes tiny)
{
    return resisting / sph2d__lanes_max(r2, tiny);
}

#endif
