/* SPDX-License-Identifier: MIT */
/** @file stable_step.h
 *  Limits of the step that all methods have. */
#ifndef SPH2D_METHODS_TERMS_STABLE_STEP_H
#define SPH2D_METHODS_TERMS_STABLE_STEP_H

#include "methods/common/method.h"

/** The shortest of the acoustic, viscous and force limits, and which it is:
 *      cfl H / (sound_speed + speed),   viscous H^2 / nu,   force sqrt(H / acceleration), and that of surface tension
 *  with the largest speed of sound [m/s], the effective kinematic viscosity nu [m^2/s] and the method's factors
 *  `viscous` and `force`. */
double sph2d__shortest_step(const sph2d__system *system, double sound_speed, double speed, double acceleration,
                            double nu, double viscous, double force, sph2d__limit *limit);

#endif
