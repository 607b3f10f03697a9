/* SPDX-License-Identifier: MIT */
/** @file local_correction.h
 *  Particles that the linear system of a step leaves compressed. Its matrix is that of the positions that the step
 *  begins with; where particles pass close by each other within the step the density that follows is another one, for a
 *  few particles of a thousand by some percent. No number of iterations would change that, and shorter steps little.
 *
 *  They are corrected one after another, with the density that is predicted where the corrections before have moved
 *  their neighbours (position based fluids, Macklin & Mueller 2013, eq. 11, in the order of rows and with the gradients
 *  of the matrix):
 *
 *      y_i += (rho+_i/rho0 - 1 - aim) / (D D' + S)_ii      where rho+_i/rho0 - 1 > limit
 *
 *  What that pushes is D' of what is added, as for the multipliers of the solution, so that momentum is kept.
 *
 *  Rows of boundary particles are left as they are: correcting them, too, changed nothing that was measured. */
#ifndef SPH2D_METHODS_PROJECTION_LOCAL_CORRECTION_H
#define SPH2D_METHODS_PROJECTION_LOCAL_CORRECTION_H

#include "methods/projection/projection.h"

/** Corrects fluid particles that would be compressed by more than `limit`, and by more than their pressure explains:
 *  `share` of their multiplier, 1/(c dt)^2 for a liquid of sound speed c. They are brought to half the limit, or to
 *  what is explained. Changes multipliers, accelerations, and pressures, none of which is raised above the largest;
 *  leaves something in `residual`, `next_x` and `next_y`. `diagonal` is the inverse of the matrix's, of either sign.
 *  The same bits for any number of threads. */
void sph2d__stragglers_correct(sph2d__system *system, double limit, double share);

#endif
