/* SPDX-License-Identifier: MIT */
/** @file viscosity.h
 *  Viscosity of the methods: its forms, their pair terms and step limits.
 *
 *  The Laplacian form, from velocity differences between neighbours,
 *
 *      a_i = mu/rho_i sum_j V_j (v_j - v_i) lap W  Mueller et al. 2003, eq. 14: muller, whose kernel's Laplacian is > 0
 *
 *  or by a fit (fitted.h), conserves momentum, but not angular momentum, and its stress at a free surface is wrong. The
 *  central form,
 *
 *      a_i = 8/rho_i sum_j mu V_j w(r) (v_ij . r_ij) r_ij/r^2                    Monaghan & Gingold 1983; Monaghan 2005
 *
 *  of all others conserves both, and damps compression three times as fast as shear. Both papers have w = W'/r. Any w(r)
 *  with the integral over the plane of w r^2 = -2 gives the viscosity mu, since the mean of x^2 y^2/r^4 over directions is
 *  1/8. Here it is
 *
 *      w(r) = W' r/(2 <r^2>),     <r^2> the integral of W r^2 over the plane, 5/36 H^2 for Wendland's C2
 *
 *  W'/r is largest between nearest neighbours, which move apart as little as a sheared lattice lets them, so that it
 *  transports too little momentum, by a part that does not shrink with the spacing: with a support of 3 spacings a film
 *  on a floor was 7 % too fast, the torque between two cylinders 8 % too low; with W' r they are 0.8 and 0.3 % off. */
#ifndef SPH2D_METHODS_TERMS_VISCOSITY_H
#define SPH2D_METHODS_TERMS_VISCOSITY_H

#include "methods/common/system.h"
#include "simd/lanes.h"

/** The weight of the central form, 8/(2 <r^2>) [1/m^2]. */
double sph2d__central_weight(sph2d_kernel kind, double support);

/** The viscosity of method `muller` [Pa s]: that of the liquid, at least alpha rho0 c0 H. */
double sph2d__viscosity_at_least(const sph2d__system *system);

/** Largest stable nu dt/H^2 of Morris' operator in an explicit step. Damping is fastest for neighbours with opposite
 *  velocities and proportional to sum V (r . grad W)/r^2, which is 2 pi W(0): kernels with a sharper peak need shorter
 *  steps. On lattices with a jitter of 0.25 dx, H/dx = 2 to 4, one over the operator's largest eigenvalue is 0.068 to
 *  0.073 over W(0) H^2 for all kernels; this is 0.067 over it, 0.03 for Wendland's C2. The central form's step is half of
 *  it: one over its largest eigenvalue is 0.0166 to 0.0218 there for Wendland's C2, 0.0099 to 0.0129 for C6 (H/dx 2.4 to
 *  4), where halves are 0.0150 and 0.0094. */
double sph2d__viscosity_step(sph2d_kernel kind);

/* ---- pair terms -------------------------------------------------------------------------------------------------- */

/** Sums of the Laplacian form, without the factors that are common to all neighbours. */
typedef struct sph2d__drag {
    sph2d__lanes x, y;
} sph2d__drag;

/** Adds a neighbour: `share` is V_j (W'/r) or V_j lap W, (dvx, dvy) the difference of the velocities. A viscosity that
 *  depends on the strain rate changes only the share. */
SPH2D__INLINE void sph2d__drag_add(sph2d__drag *sum, sph2d__lanes share, sph2d__lanes dvx, sph2d__lanes dvy)
{
    sum->x += share * dvx;
    sum->y += share * dvy;
}

#endif
