/* SPDX-License-Identifier: MIT */
/** @file muller.h
 *  Method `muller`: Mueller, Charypar & Gross 2003 in two dimensions, the report's method.
 *
 *  density       rho_i = sum_j m_j W_poly6(r_ij)                                                     (report eq. 3, 4)
 *  pressure      p = k (rho - rho0), k = c0^2, where positive                                        (6)
 *  pressure      a_i = -(1/rho_i) sum_j m_j/rho_j (p_i + p_j)/2 grad W_spiky                         (7, 8)
 *  viscosity     a_i = (mu/rho_i) sum_j m_j/rho_j (v_j - v_i) lap W_viscosity                        (9, 10)
 *
 *  The sums run over fluid and boundary particles alike, but boundary particles drag with mu = 0.005 rho0 c0 H at
 * least: their push has no potential, and without drag a bounce could gain energy. Negative pressure is cut off: at a
 * free surface the density sum lacks neighbours, and the tension that follows would draw the surface together into
 * clumps. */
#ifndef SPH2D_METHODS_MULLER_H
#define SPH2D_METHODS_MULLER_H

#include "methods/method.h"
#include "methods/slabs.h"

extern const sph2d__method sph2d__muller;

/** The pair loops, compiled once for each instruction set. */
typedef struct sph2d__muller_passes {
    /** Density of the fluid, from fluid and walls. */
    sph2d__span_work *density;
    /** Density of the boundary particles that press: the rest density they give themselves and what the fluid adds. */
    sph2d__span_work *wall_density;
    /** Acceleration of the fluid, from densities, pressures and volumes. */
    sph2d__span_work *force;
} sph2d__muller_passes;

extern const sph2d__muller_passes sph2d__muller_passes_baseline;
#ifdef SPH2D__ISA_X86
extern const sph2d__muller_passes sph2d__muller_passes_avx2;
extern const sph2d__muller_passes sph2d__muller_passes_avx512;
#endif

#endif
