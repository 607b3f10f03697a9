/* SPDX-License-Identifier: MIT */
/** @file muller.h
 *  Method `muller`: Mueller, Charypar & Gross 2003 in two dimensions, the report's method.
 *
 *  density       rho_i = c sum_j m W_poly6(r_ij), c making a filled lattice have the rest density      (report eq. 3,
 *  4) pressure      p = k (rho - rho0), where positive                                                          (6)
 *  pressure      a_i = -(1/rho_i) sum_j m_j/rho_j (p_i + p_j)/2 grad W_spiky                                 (7, 8)
 *  viscosity     a_i = (mu/rho_i) sum_j m_j/rho_j (v_j - v_i) lap W_viscosity                                (9, 10)
 *
 *  Pairs take G p for p. G (kernels/muller.h, 0.93 where density is 1.2 of rest density at H/dx = 2) makes the work of
 *  a lattice that is compressed evenly that of the state equation: by p itself, of a block that is 1.3 times too dense
 *  at the start, pairs gave back 7 % more than it was reported to hold.
 *
 *  What pairs carry is P p with P = 0.443 at H/dx = 2 (kernels/muller.h), about half: the pressure that particles tell
 *  is this one, c0^2 is dP p/drho, and k follows from c0. Negative pressure is cut off: at a free surface the density
 *  sum lacks neighbours, and the tension that follows would draw the surface together into clumps.
 *
 *  Boundary particles b and sides (muller_side.h) add to density, sum_b m_b W_poly6(r_ib), and what that takes comes
 *  back:
 *
 *      a_i = -(p_i/rho_i^2) sum_b m_b grad W_poly6(r_ib)
 *
 *  has the energy sum_i m e(rho_i), e the integral of p/rho^2, as the only one that there is. The force between
 *  particles has none, its kernel being another than that of density, so that viscosity has to take what it makes: at
 *  least mu = alpha rho0 c0 H. At alpha = 0.02 energy of a closed scene rose by up to 2 % of its scale, at 0.1 by less
 *  than 0.1 % wherever liquid starts uncompressed. Boundary particles drag like liquid. */
#ifndef SPH2D_METHODS_MULLER_MULLER_H
#define SPH2D_METHODS_MULLER_MULLER_H

#include "methods/common/method.h"
#include "methods/common/slabs.h"
#include "simd/isa.h"

/** Its time scheme (leapfrog.c): method.h. */
sph2d_status sph2d__leapfrog(sph2d_sim *sim, double dt);

/** The pair loops, compiled once for each instruction set. */
typedef struct sph2d__muller_passes {
    /** Density of the fluid, from fluid and walls. */
    sph2d__span_work *density;
    /** Density of the boundary particles that press: the rest density they give themselves and what the fluid adds. */
    sph2d__span_work *wall_density;
    /** Acceleration of the fluid, from densities, pressures and volumes. */
    sph2d__span_work *force;
} sph2d__muller_passes;

SPH2D__COPIES(sph2d__muller_passes, sph2d__muller_passes, )

#endif
