/* SPDX-License-Identifier: MIT */
/** @file viscosity.h
 *  Viscosity of all methods: the forms that it has, which of them acts, and how strongly. What a pair adds is in
 *  viscosity_pair.h.
 *
 *  Laplacian of the velocity, from differences between neighbours,
 *
 *      a_i = 2/rho_i sum_j mu V_j (W'/r) v_ij      Morris, Fox & Zhu 1997, eq. 22: wcsph, pcisph, constraint
 *      a_i = mu/rho_i sum_j V_j (v_j - v_i) lap W  Mueller et al. 2003, eq. 14: muller, whose kernel's Laplacian is > 0
 *
 *  and by a fit (fitted.h). Momentum is kept; angular momentum and the stress at a free surface are not right. The
 *  central form,
 *
 *      a_i = 8/rho_i sum_j mu V_j (W'/r) (v_ij . r_ij) r_ij/r^2                    Monaghan & Gingold 1983; Monaghan 2005
 *
 *  keeps both, and damps compression three times as fast as shear. Artificial viscosity has this form with
 *  mu = alpha rho0 c0 H/16 (H/16 = h/8, h half the support radius H), and so do eddies (wcsph.h). */
#ifndef SPH2D_METHODS_TERMS_VISCOSITY_H
#define SPH2D_METHODS_TERMS_VISCOSITY_H

#include "methods/common/system.h"

/** Dynamic viscosities of the two forms [Pa s]. */
typedef struct sph2d__viscosity {
    double laplacian;
    double central; /**< that of the liquid where it has this form, and the artificial one */
} sph2d__viscosity;

/** What acts in the symmetric operators of `wcsph`. */
sph2d__viscosity sph2d__viscosity_of(const sph2d__system *system);

/** The kinematic viscosity in Laplacian form that limits the step as much as what acts [m^2/s]. */
double sph2d__viscosity_limiting(const sph2d__system *system);

/** What resists shear in method `muller` [Pa s]: that of the liquid, alpha rho0 c0 H at least. */
double sph2d__viscosity_at_least(const sph2d__system *system);

/** nu dt/H^2 that Morris' operator stands in one explicit step. What it takes of a velocity in a step is largest
 *  between neighbours of opposite velocities and goes with sum V (r . grad W)/r^2, which is 2 pi W(0): kernels with a
 *  sharper peak stand less. On lattices with a jitter of 0.25 dx, H/dx = 2 to 4, one over the operator's largest
 *  eigenvalue is 0.068 to 0.073 over W(0) H^2 for all kernels; this is 0.067 over it, 0.03 for Wendland's C2. */
double sph2d__viscosity_step(sph2d_kernel kernel);

/** The force on particle i by a wall particle at (dx, dy) from it that it passes at (dvx, dvy), given V_i V_b (W'/r)
 *  [1/m^4 m^4]: both forms [N/m]. */
sph2d_vec2 sph2d__viscosity_force(sph2d__viscosity viscosity, double share, double dx, double dy, double dvx,
                                  double dvy);

#endif
