/* SPDX-License-Identifier: MIT */
/** @file wcsph.h
 *  Method `wcsph` with symmetric operators: delta-SPH, for free surfaces and impacts.
 *
 *  With V = m/rho, r_ij = x_i - x_j, v_ij = v_i - v_j, the smoothing length h = H/2 and grad W the gradient at i:
 *
 *      drho_i/dt = sum m_j v_ij . grad W + delta h c0 sum V_j psi_ij . grad W                  (Monaghan 1994, eq. 2.3)
 *      psi_ij    = 2 [(rho_i - rho_j) - (grad rho_i + grad rho_j) . r_ij / 2] r_ij/r^2         (Antuono et al. 2010)
 *      dv_i/dt   = -sum m_j (p_i/rho_i^2 + p_j/rho_j^2) grad W + viscosity + body force        (Monaghan 1994, eq. 2.2)
 *      morris    = 2 mu/rho_i sum V_j (r_ij . grad W)/r^2 v_ij                                 (Morris et al. 1997, eq.
 * 22) monaghan  = 8 mu/rho_i sum V_j (v_ij . r_ij)/r^2 grad W,  8 = 2 (d + 2) in d = 2        (Monaghan & Gingold 1983)
 *
 *  Boundary particles b of generalised walls take part in all sums but the diffusion's, with (Adami, Hu & Adams 2012,
 * eq. 27; a_b the wall's acceleration, g the body force, j over the liquid around b)
 *
 *      p_b   = [sum p_j W + (g - a_b) . sum rho_j r_bj W] / sum W,   rho_b from the equation of state
 *      v_b   = the wall's velocity in the rate of density, 2 v_wall - sum v_j W / sum W in the viscosity of a no-slip
 * wall
 *
 *  which holds a resting liquid exactly. A free-slip wall has no viscosity.
 *
 *  grad rho_i is corrected: exact for linear density, so that psi vanishes there pair by pair and a resting liquid
 * keeps its surface. Artificial viscosity alpha is the monaghan form with mu = rho0 alpha h c0/8 in approach and
 * recession alike. The pair (rate, pressure) conserves energy when nothing dissipates. */
#ifndef SPH2D_METHODS_WCSPH_H
#define SPH2D_METHODS_WCSPH_H

#include "methods/method.h"

extern const sph2d__method sph2d__wcsph;

/** The pair loops, compiled once for each instruction set; one of each for every kernel. */
typedef struct sph2d__wcsph_passes {
    /** density_rate of the fluid, from places, velocities, densities, volumes and slopes. */
    void (*density_rate[5])(sph2d__system *system);
    /** Pressure, density, volume and image velocity of the boundary particles, from the fluid. */
    void (*walls[5])(sph2d__system *system);
    /** Acceleration and slope of density of the fluid, from densities, pressures and volumes. */
    void (*force[5])(sph2d__system *system);
} sph2d__wcsph_passes;

extern const sph2d__wcsph_passes sph2d__wcsph_passes_baseline;
#ifdef SPH2D__ISA_X86
extern const sph2d__wcsph_passes sph2d__wcsph_passes_avx2;
extern const sph2d__wcsph_passes sph2d__wcsph_passes_avx512;
#endif

#endif
