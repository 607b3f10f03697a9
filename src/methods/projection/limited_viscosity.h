/* SPDX-License-Identifier: MIT */
/** @file limited_viscosity.h
 *  Artificial viscosity of methods with a pressure that follows from density: on what of the velocities around a
 *  particle is not linear (Frontiere, Raskin & Owen 2017, with the limiter minmod).
 *
 *      a_i  = 8 nu sum_j w_ij/r_ij^2 G_ij                                     the form of Monaghan 2005 (viscosity.h)
 *      w_ij = minmod(v_ij . r_ij, v_ij . r_ij - r_ij . (L_i + L_j)/2 r_ij)
 *      L_i  = grad v, with v_i - v_j = L_i (x_i - x_j) by B_i = (-sum_j G_ij (x) r_ij)^-1, over the liquid
 *      nu   = alpha sqrt(g H_0) H/16                                          alpha of the scene, artificial_viscosity
 *
 *  sqrt(g H_0) is the root of the scene's head, g h + U^2/2. minmod is the smaller of two numbers of one sign, and 0 if
 *  they have two: every pair's part takes energy, and its forces are opposite and along the line between them, so that
 *  both momenta are kept. Rotation and strain that is the same everywhere are not damped at all, waves that many
 *  spacings resolve hardly.
 *
 *  What it is for: D D' hardly sees motions that change sign from neighbour to neighbour (projection.h), and density
 *  that is kept over disorder goes on exciting them. By density constraints (Bodin et al. 2011) a tank at rest, 40 particles deep, trembles
 *  by 0.0121 sqrt(gH) (rms) without, by 0.0022 to 0.0032 with alpha = 0.1; a drop under a central force keeps 0.76 and
 *  0.73 of its energy over ten periods. */
#ifndef SPH2D_METHODS_PROJECTION_LIMITED_VISCOSITY_H
#define SPH2D_METHODS_PROJECTION_LIMITED_VISCOSITY_H

#include "methods/common/system.h"
#include "simd/isa.h"

/** nu [m^2/s]; 0 without alpha or head. */
double sph2d__limited_viscosity_of(const sph2d__system *system);

/** Changes the velocities by what it does in dt [s], before all other forces, and returns the energy that it takes
 *  [J/m]. The lists of neighbours and the velocity gradients, in `stretch`, `shear` and `density_rate`, are new
 *  (sph2d__projection_gather). */
double sph2d__limited_viscosity_apply(sph2d__system *system, double dt);

/** The acceleration of the fluid particles `first`, which begins a slab, to `last` - 1, in the arrays of the solver's
 *  predicted positions, compiled once for each instruction set. */
typedef struct sph2d__limited_viscosity_pass {
    void (*accelerate)(sph2d__system *system, double nu, size_t first, size_t last);
} sph2d__limited_viscosity_pass;

SPH2D__COPIES(sph2d__limited_viscosity_pass, sph2d__limited_viscosity_pass)

#endif
