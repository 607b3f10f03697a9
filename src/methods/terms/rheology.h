/* SPDX-License-Identifier: MIT */
/** @file rheology.h
 *  Viscosity that depends on the shear rate g = sqrt(2 D:D), D the symmetric part of the velocity gradient without its
 *  trace:
 *
 *      power_law          mu = K g^(n-1)                                  Ostwald & de Waele; Bird, Armstrong & Hassager
 *      carreau            mu = mui + (mu0 - mui) (1 + (l g)^2)^((n-1)/2)  1987, Dynamics of Polymeric Liquids, 4.1-9, -7
 *      herschel_bulkley   mu = K g^(n-1) + (1 - exp(-m g)) t/g            Herschel & Bulkley 1926; Papanastasiou 1987,
 *                                                                         eq. 16: Bingham's liquid for n = 1
 *
 *  Of a pair's two viscosities the harmonic mean counts, 2 mu_i mu_j/(mu_i + mu_j), by which the stress between layers of
 *  different viscosity is the same on both sides (Cleary 1998, Appl. Math. Modelling 22, 981). With the arithmetic mean
 *  what does not flow held back what does next to it: mud on a slope whose sheared layer is 5 spacings thick was 23 %
 *  too slow, with the harmonic one 2 % (examples/slope/study.yaml).
 *
 *  Liquid below the yield stress t creeps with the viscosity m t. For n < 1, g^(n-1) is that of g = 1/m for all slower
 *  liquid, so that the largest viscosity is K m^(1-n) + m t. */
#ifndef SPH2D_METHODS_TERMS_RHEOLOGY_H
#define SPH2D_METHODS_TERMS_RHEOLOGY_H

#include "methods/common/system.h"

/** The viscosity at a shear rate g [1/s], >= 0, in [Pa s]; the regularisation of the liquid is known. */
double sph2d__rheology_viscosity(const sph2d_fluid *fluid, double g);

/** Sets the viscosities of particles by their shear rates, and the largest of them as the system's. Nothing for liquids
 *  with one viscosity. False when memory is short. */
bool sph2d__rheology_set(sph2d__system *system);

#endif
