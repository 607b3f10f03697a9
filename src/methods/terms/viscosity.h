/* SPDX-License-Identifier: MIT */
/** @file viscosity.h
 *  Viscosity of all methods: its forms, coefficients and step limits. The pair terms are in viscosity_pair.h.
 *
 *  The Laplacian form, from velocity differences between neighbours,
 *
 *      a_i = 2/rho_i sum_j mu V_j (W'/r) v_ij      Morris, Fox & Zhu 1997, eq. 22: wcsph, pcisph, constraint
 *      a_i = mu/rho_i sum_j V_j (v_j - v_i) lap W  Mueller et al. 2003, eq. 14: muller, whose kernel's Laplacian is > 0
 *
 *  or by a fit (fitted.h). The sums conserve momentum, but not angular momentum, and the stress at a free surface is
 *  wrong. The central form,
 *
 *      a_i = 8/rho_i sum_j mu V_j (W'/r) (v_ij . r_ij) r_ij/r^2                  Monaghan & Gingold 1983; Monaghan 2005
 *
 *  conserves both, and damps compression three times as fast as shear. Artificial viscosity has this form with
 *  mu = alpha rho0 c0 H/16 (H/16 = h/8, h half the support radius H), and so has subgrid viscosity (wcsph.h). */
#ifndef SPH2D_METHODS_TERMS_VISCOSITY_H
#define SPH2D_METHODS_TERMS_VISCOSITY_H

#include "methods/common/system.h"

/** Dynamic viscosities of the two forms [Pa s]. */
typedef struct sph2d__viscosity {
    double laplacian;
    double central; /**< artificial viscosity, and the liquid's own if it has this form */
} sph2d__viscosity;

/** Those of the symmetric operators of `wcsph`. */
sph2d__viscosity sph2d__viscosity_of(const sph2d__system *system);

/** The same with another viscosity of the liquid in either form. */
sph2d__viscosity sph2d__viscosity_apart(const sph2d__system *system, double laplacian, double central);

/** Those of particle i, whose viscosity may be its own. */
sph2d__viscosity sph2d__viscosity_at(const sph2d__system *system, size_t i);

/** The kinematic viscosity in Laplacian form with the same step limit [m^2/s]. */
double sph2d__viscosity_limiting(const sph2d__system *system);

/** The viscosity of method `muller` [Pa s]: that of the liquid, at least alpha rho0 c0 H. */
double sph2d__viscosity_at_least(const sph2d__system *system);

/** Largest stable nu dt/H^2 of Morris' operator in an explicit step. Damping is fastest for neighbours with opposite
 *  velocities and proportional to sum V (r . grad W)/r^2, which is 2 pi W(0): kernels with a sharper peak need shorter
 *  steps. On lattices with a jitter of 0.25 dx, H/dx = 2 to 4, one over the operator's largest eigenvalue is 0.068 to
 *  0.073 over W(0) H^2 for all kernels; this is 0.067 over it, 0.03 for Wendland's C2. */
double sph2d__viscosity_step(sph2d_kernel kernel);

/** An upper bound of the rates at which the central form damps motions [1/s], from the largest eigenvalue `block` of
 *  sum V_j |W'/r| (r_ij r_ij)/r_ij^2/rho_i of all particles, liquid and rough walls around them:
 *
 *      sum over pairs k_ij (v_ij . n_ij)^2 <= 2 sum_i v_i . D_i v_i,     D_i = 8 mu block,     rate = 2 max D_i
 *
 *  A step is stable up to 1/rate: the forces of midpoint.c are those of velocities that were predicted by a whole step.
 *  In liquid that fills space the rate is 0.83 over the step above, 1.1 in disorder. But where threads and edges get
 *  thin, and along walls, density keeps the rest density by its rate of change while particles gather. Honey poured
 *  from a jar then had sums of V W of 1.3 to 1.6, largest eigenvalues of 1.0 to 1.1 over the step above, and gained
 *  three times the scene's energy; by this rate at most 0.03 % come from nothing. What the rate is too
 *  large by, a quarter to a third, is left to the friction of smooth walls, which is not in it. */
double sph2d__viscous_rate(sph2d__viscosity viscosity, double block);

/** Whether the rate above can limit the step: whether viscosity would if its step were a third. */
bool sph2d__viscosity_limits(const sph2d__system *system);

/** Raises the system's viscous_rate to at least `rate`; threads may do so at once, the largest stays. */
void sph2d__viscous_rate_raise(sph2d__system *system, double rate);

/** The viscous force, of both forms, on particle i by boundary particle b [N/m]: (dx, dy) and (dvx, dvy) are the
 *  position and velocity of i relative to b, `share` is V_i V_b (W'/r) [1/m^4 m^4]. */
sph2d_vec2 sph2d__viscosity_force(sph2d__viscosity viscosity, double share, double dx, double dy, double dvx,
                                  double dvy);

#endif
