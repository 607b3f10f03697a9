/* SPDX-License-Identifier: MIT */
/** @file muller.h
 *  Method `muller`: Mueller, Charypar & Gross 2003 in two dimensions, the report's method.
 *
 *  density       rho_i = c sum_j m W_poly6(r_ij), c gives a full lattice the rest density               (report eq. 3,
 *  4) pressure      p = k (rho - rho0), if positive                                                             (6)
 *  pressure      a_i = -(1/rho_i) sum_j m_j/rho_j (p_i + p_j)/2 grad W_spiky                                 (7, 8)
 *  viscosity     a_i = (mu/rho_i) sum_j m_j/rho_j (v_j - v_i) lap W_viscosity                                (9, 10)
 *
 *  Pair forces use G p for p. G (kernels/muller.h, 0.93 at 1.2 times rest density for H/dx = 2) makes the work of a
 *  uniformly compressed lattice that of the equation of state: with p itself a block 1.3 times too dense at the start
 *  released 7 % more energy than it was reported to have.
 *
 *  The stress of the pair forces is P p with P = 0.443 at H/dx = 2 (kernels/muller.h), about half: this is the reported
 *  pressure, c0^2 is dP p/drho, and k follows from c0. Negative pressure is cut off: at a free surface the density sum
 *  lacks neighbours, and the resulting tension would contract the surface into clumps.
 *
 *  Boundary particles b and sides (muller_side.h) contribute to density, sum_b m_b W_poly6(r_ib), and the corresponding
 *  force
 *
 *      a_i = -(p_i/rho_i^2) sum_b m_b grad W_poly6(r_ib)
 *
 *  alone has an energy, sum_i m e(rho_i), e the integral of p/rho^2. The force between fluid particles has none, since
 *  its kernel differs from that of density, so that viscosity has to dissipate what it produces: at least mu = alpha
 *  rho0 c0 H. With alpha = 0.02 the energy of a closed scene rose by up to 2 % of its scale, with 0.1 by less than
 *  0.1 % if the liquid starts uncompressed. Viscosity treats boundary particles as liquid. */
#ifndef SPH2D_METHODS_MULLER_MULLER_H
#define SPH2D_METHODS_MULLER_MULLER_H

#include "methods/common/method.h"
#include "methods/common/slabs.h"
#include "simd/isa.h"

/** The time scheme (leapfrog.c): method.h. */
sph2d_status sph2d__leapfrog(sph2d_sim *sim, double dt);

/** The pair loops, compiled once for each instruction set. */
typedef struct sph2d__muller_passes {
    /** Sets the density of the fluid, from fluid and walls. */
    sph2d__span_work *density;
    /** Sets pressures and volumes, from densities. */
    sph2d__span_work *pressures;
    /** Sets the density of boundary particles: rest density, by the boundary itself, plus that by the fluid. */
    sph2d__span_work *wall_density;
    /** Sets their pressures and volumes. */
    sph2d__span_work *wall_pressures;
    /** Sets the acceleration of the fluid, from densities, pressures and volumes. */
    sph2d__span_work *force;
} sph2d__muller_passes;

SPH2D__COPIES(sph2d__muller_passes, sph2d__muller_passes)

#endif
