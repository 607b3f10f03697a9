/* SPDX-License-Identifier: MIT */
/** @file constraint.h
 *  Method `constraint`: Constraint Fluids (Bodin, Lacoursiere & Servin 2011). Incompressibility is one constraint
 *  g_i = rho_i/rho0 - 1 a particle, and the pressure is the force that keeps it. The stepper is SPOOK (Lacoursiere
 *  2007): with J = dg/dx = D of projection.h, compliance e = 1/(m c0^2), damping of n steps and gamma = 1/(1 + 4 n)
 *
 *      (J M^-1 J' + 4 e gamma/dt^2) l = -(4/dt) gamma g + gamma J v - J (v + dt f/m)          v+ = v + dt f/m + J' l/m
 *
 *  With y = -l dt/m, which is dt^2 p/rho0, this is
 *
 *      (D D' + S) y = 4 gamma g + dt D (v* - gamma v)      S = 4 gamma/(c0 dt)^2,  v* = v + dt a
 *      v+ = v* - D' y/dt,  x+ = x + dt v+
 *
 *  At rest g = p/(rho0 c0^2), as in method wcsph, whatever the step. A compression fades within a few steps: n = 2 is
 *  the least without overshoot of a rigid constraint.
 *
 *  The constraints only push: y >= 0. Rows that would pull are left out, which are those of the free surface. The
 *  system is solved by conjugate gradients from the last step's pressure on; the residual is a compression, the part of
 *  it that the step leaves uncorrected. Where the density that follows is not what the linear system says, particles
 *  are corrected one by one (local_correction.h). */
#ifndef SPH2D_METHODS_PROJECTION_CONSTRAINT_H
#define SPH2D_METHODS_PROJECTION_CONSTRAINT_H

#include "methods/common/method.h"

extern const sph2d__method sph2d__constraint;

#endif
