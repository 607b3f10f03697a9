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
 *      a_i = 8/rho_i sum_j mu V_j w(r) (v_ij . r_ij) r_ij/r^2                    Monaghan & Gingold 1983; Monaghan 2005
 *
 *  conserves both, and damps compression three times as fast as shear. Both papers have w = W'/r, as the Laplacian form.
 *  Any w(r) with the integral over the plane of w r^2 = -2 gives the viscosity mu, since the mean of x^2 y^2/r^4 over
 *  directions is 1/8. Here it is
 *
 *      w(r) = W' r/(2 <r^2>),     <r^2> the integral of W r^2 over the plane, 5/36 H^2 for Wendland's C2
 *
 *  W'/r is largest between nearest neighbours, which move apart as little as a sheared lattice lets them, so that it
 *  transports too little momentum, by a part that does not shrink with the spacing: with a support of 3 spacings a film
 *  on a floor was 7 % too fast, the torque between two cylinders 8 % too low; with W' r they are 0.8 and 0.3 % off.
 *  Artificial viscosity, mu = alpha rho0 c0 H/16 (H/16 = h/8, h half the support radius H), and subgrid viscosity
 *  (wcsph.h) are there for differences between nearest neighbours and keep W'/r: with W' r water at rest moved twice
 *  as fast (tests/cases/hydrostatic.yaml). */
#ifndef SPH2D_METHODS_TERMS_VISCOSITY_H
#define SPH2D_METHODS_TERMS_VISCOSITY_H

#include "methods/common/system.h"

/** Viscosities. */
typedef struct sph2d__viscosity {
    double laplacian;  /**< the liquid's in Laplacian form [Pa s] */
    double central;    /**< the liquid's in central form, times its weight [Pa s/m^2] */
    double artificial; /**< artificial viscosity, times 8 [Pa s] */
} sph2d__viscosity;

/** The weight of the central form, 8/(2 <r^2>) [1/m^2]. */
double sph2d__central_weight(sph2d_kernel kernel, double support);

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
 *  0.073 over W(0) H^2 for all kernels; this is 0.067 over it, 0.03 for Wendland's C2. The central form's step is half of
 *  it: one over its largest eigenvalue is 0.0166 to 0.0218 there for Wendland's C2, 0.0099 to 0.0129 for C6 (H/dx 2.4 to
 *  4), where halves are 0.0150 and 0.0094. */
double sph2d__viscosity_step(sph2d_kernel kernel);

/** An upper bound of the rates at which the central form damps motions [1/s] is twice the largest eigenvalue `block` of
 *  sum V_j |W'/r| k_ij (r_ij r_ij)/rho_i of all particles, liquid and rough walls around them, k_ij the central viscosity
 *  plus the artificial one over r^2:
 *
 *      sum over pairs V_i V_j |W'/r| k_ij (v_ij . r_ij)^2 <= 2 sum_i m_i v_i . block_i v_i
 *
 *  A step is stable up to 1/rate: the forces of midpoint.c are those of velocities that were predicted by a whole step.
 *  In liquid that fills space the rate is 0.87 over the central form's step, 1.05 in disorder. But where threads and
 *  edges get thin, and along walls, density keeps the rest density by its rate of change while particles gather. What
 *  the rate is too large by, a quarter to a third, is left to the friction of smooth walls, which is not in it. */
static const double SPH2D__RATE_OF_BLOCK = 2;

/** Whether the rate above can limit the step: whether viscosity would if its step were half. */
bool sph2d__viscosity_limits(const sph2d__system *system);

/** Raises the system's viscous_rate to at least `rate`; threads may do so at once, the largest stays. */
void sph2d__viscous_rate_raise(sph2d__system *system, double rate);

/** The viscous force, of both forms, on particle i by boundary particle b [N/m]: (dx, dy) and (dvx, dvy) are the
 *  position and velocity of i relative to b, `share` is V_i V_b (W'/r) [1/m^4 m^4]. */
sph2d_vec2 sph2d__viscosity_force(sph2d__viscosity viscosity, double share, double dx, double dy, double dvx,
                                  double dvy);

#endif
