/* SPDX-License-Identifier: MIT */
/** @file pcisph.h
 *  Method `pcisph`: predictive-corrective incompressible SPH (Solenthaler & Pajarola 2009). With the notation of
 *  projection.h and y = dt^2 p/rho0, a step repeats
 *
 *      x+ = x + dt v + dt^2 a - D' z        rho+ at x+, with the neighbours of x
 *      r = rho+/rho0 - 1 - z/(c0 dt)^2
 *      y <- max(0, z + w r/(2 sum |G|^2)),  z = max(0, y + b (y - last y))
 *
 *  until the largest, or the mean, of |r| where z > 0 or r > 0 is at most max_compression, min_iterations times at
 *  least. The sum is that of a filled lattice, for all particles (their prototype): 1/(2 sum |G|^2) is delta of their
 *  eq. 8 in the units of y. Beyond the paper:
 *  - A relaxation w < 1, halved where r grows: unrelaxed the loop diverges for wide kernels and where particles are
 *    disordered.
 *  - Going ahead by b of the last way, starting anew where that goes too far (Nesterov 1983; O'Donoghue & Candes 2015,
 *    who restart by the sign of r . (y - last y)): a third of the iterations.
 *  - The compliance of a sound speed c0. Where there is more liquid than room, pressures then have an end.
 *  - A start from a part of the last step's pressure. */
#ifndef SPH2D_METHODS_PROJECTION_PCISPH_H
#define SPH2D_METHODS_PROJECTION_PCISPH_H

#include "methods/common/method.h"

extern const sph2d__method sph2d__pcisph;

/** sum |G|^2 of a particle in a filled square lattice [1/m^2]. */
double sph2d__pcisph_prototype(const sph2d__system *system);

#endif
