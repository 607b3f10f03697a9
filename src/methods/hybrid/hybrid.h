/* SPDX-License-Identifier: MIT */
/** @file hybrid.h
 *  Method `hybrid`: particles that carry the liquid, with neighbours, densities and walls of SPH, and a staggered grid
 *  whose pressure keeps their velocities free of divergence. For looking and playing: one solution a step of some
 *  hundredth of a second, whatever the sound speed, and no pressures finer than the grid.
 *
 *  The shape is that of Raveendran, Wojtan & Turk (Hybrid smoothed particle hydrodynamics, SCA 2011): a coarse Poisson
 *  equation, and densities put right on the particles. A second Poisson equation for the density is that of Kugelstadt,
 *  Longva, Thuerey & Bender (Implicit density projection for volume conserving liquids, IEEE TVCG 27 (2021) 2385-2395).
 *  Velocities go to the grid and back with their slopes, as in APIC (Jiang, Schroeder, Selle, Teran & Stomakhin, The
 *  affine particle-in-cell method, ACM TOG 34 (2015) 51). Surfaces of liquid and walls cut the squares of the grid (Enright
 *  et al. 2003; Batty, Bertails & Bridson 2007).
 *
 *  A step of length dt:
 *
 *      density     rho_i/rho0 = sum_j W(r_ij) + sum_b (m_b/m) W(r_ib), 1 on a full lattice
 *      order       e_i = -sum_j (l_i + l_j + B b_i b_j) grad W_ij - sum_b (m_b/m) (2 l_i + B b_i) grad W_ib,
 *                  l = max(0, rho/rho0 - 1) K/2, b = 15 (rho/rho0 - 0.9) from 0 to 1, B = K/10, 1/K = sum |grad W|^2 on a
 *                  lattice: half a step of Jacobi for the density, and an even pressure inside, which puts particles in
 *                  order
 *      forces      v_i <- v_i + dt a_i
 *      to the grid u = sum w (v_i + (x - x_i) . grad v_i) / sum w on faces; on squares the mass, sum w over that of a
 *                  full one, and the mean of rho/rho0 - 1; w bilinear. Squares with a mass above 1/2 are liquid.
 *      viscosity   w = u - grad q of the step before, w <- (1 - nu dt lap)^-1 w, u = w + grad q
 *      pressure    div(u - grad q) = 0, q = p dt/rho0, with q = 0 on the surface, below which weights have the masses of
 *                  the two squares beside it, and walls' own velocity on the closed part of faces, and what sources emit
 *      volume      lap s = -(rho/rho0 - 1): displacements -grad s
 *      back        v_i and its slopes are those of u
 *      move        by dt (u + dt/2 (u . grad) u) + e_i - grad s; spray by itself
 *
 *  Changes of place never enter velocities. */
#ifndef SPH2D_METHODS_HYBRID_HYBRID_H
#define SPH2D_METHODS_HYBRID_HYBRID_H

#include "methods/common/method.h"
#include "methods/common/slabs.h"
#include "particles/store.h"
#include "simd/isa.h"

/** The pair loops, in floats, compiled once for each instruction set. */
typedef struct sph2d__hybrid_passes {
    /** Sets the density of the fluid, and l and b in floats; these of densities that were read. */
    sph2d__span_work *density, *pack;
    /** Sets the displacements of the fluid. */
    sph2d__span_work *order;
} sph2d__hybrid_passes;

SPH2D__COPIES(sph2d__hybrid_passes, sph2d__hybrid_passes)

/** Eight floats side by side are best: with sixteen more are too far from a candidate, and roots take as long for each. */
static inline const sph2d__hybrid_passes *sph2d__hybrid_passes_best(sph2d_isa isa)
{
    return sph2d__hybrid_passes_find(isa == SPH2D_ISA_AVX512 ? SPH2D_ISA_AVX2 : isa);
}

#endif
