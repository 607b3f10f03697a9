/* SPDX-License-Identifier: MIT */
/** @file body_rows.h
 *  Bodies that the liquid moves, in D and D' of projection.h. With u_b = V + Omega x r_b on a body's boundary particles,
 *  masses m of a particle, M and I of the body, its row of D' and its motion by it are
 *
 *      (D' y)_body = -sum over i, b of (y_i + y_b) (G_ib, r_b x G_ib)            moved by (m/M, m/M, m/I) (D' y)_body
 *
 *  the transpose of what u_b adds to D u, so that the matrix D M^-1 D' is symmetric and has no negative eigenvalue with
 *  bodies of any mass, and their reaction is as implicit as the liquid's. Sums over pairs are in their order. */
#ifndef SPH2D_METHODS_PROJECTION_BODY_ROWS_H
#define SPH2D_METHODS_PROJECTION_BODY_ROWS_H

#include "methods/common/system.h"

/** Frees the pairs. */
void sph2d__body_pairs_free(sph2d__body_pairs *pairs, sph2d__memory *memory);

/** Lists the pairs of all bodies from the neighbours. False when memory is short. */
bool sph2d__body_rows_gather(sph2d__system *system);

/** Velocities of bodies' boundary particles at the end of the step, if the directions, or the multipliers, are right. */
void sph2d__body_rows_predict(sph2d__system *system);
void sph2d__body_rows_end(sph2d__system *system);

#endif
