/* SPDX-License-Identifier: MIT */
/** @file stable_step.h
 *  What limits the length of a step, alike in all methods. */
#ifndef SPH2D_METHODS_TERMS_STABLE_STEP_H
#define SPH2D_METHODS_TERMS_STABLE_STEP_H

#include "methods/common/method.h"

/** nu dt/H^2 that Morris' operator stands in one explicit step. What it takes of a velocity in a step is largest
 *  between neighbours of opposite velocities and goes with sum V (r . grad W)/r^2, which is 2 pi W(0): kernels with a
 *  sharper peak stand less. On lattices with a jitter of 0.25 dx, H/dx = 2 to 4, one over the operator's largest
 *  eigenvalue is 0.068 to 0.073 over W(0) H^2 for all kernels; this is 0.067 over it, 0.03 for Wendland's C2. */
double sph2d__viscous_limit(sph2d_kernel kernel);

/** The shortest of the acoustic, viscous and force limits, and which it is:
 *      cfl H / (sound + speed),   viscous H^2 / nu,   force sqrt(H / acceleration), and that of surface tension
 *  with the largest speed of sound [m/s], the kinematic viscosity nu [m^2/s] that acts and two fractions that belong to
 *  the method. */
double sph2d__shortest_step(const sph2d__system *system, double sound, double speed, double acceleration, double nu,
                            double viscous, double force, sph2d__limit *limit);

#endif
