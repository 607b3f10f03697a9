/* SPDX-License-Identifier: MIT */
/** @file stages.h
 *  Stages that the methods' time schemes share. */
#ifndef SPH2D_SIM_STAGES_H
#define SPH2D_SIM_STAGES_H

#include "sim/simulation.h"

/** Particles that are moved together: enough to make the search for walls around all of them cheap. */
enum { SPH2D__BATCH = 32 };

/** Consecutive particles and their displacements. */
typedef struct sph2d__batch {
    size_t first, count;
    double dx[SPH2D__BATCH], dy[SPH2D__BATCH]; /**< displacements [m] */
    double vx[SPH2D__BATCH], vy[SPH2D__BATCH]; /**< velocities, which walls may change [m/s] */
    int64_t diffused; /**< elastic energy that they lost otherwise than by their velocities, in quanta; 0 unless set */
    double kick; /**< for how long the accelerations have just acted, and elastic energy not yet; 0 unless set [s] */
} sph2d__batch;

/** Sets displacements and velocities of a batch for a step of `dt`; or finishes the batch after its displacement. */
typedef void sph2d__batch_work(sph2d_sim *sim, double dt, sph2d__batch *batch);

/** Moves all particles by their displacements, stopped by walls and wrapped at periodic sides, and sets their
 *  velocities (advect.c). `after` may be NULL. SPH2D_GUARD when a position is not finite. */
sph2d_status sph2d__advect(sph2d_sim *sim, double dt, sph2d__batch_work *set, sph2d__batch_work *after);

/** Sorts the fluid into its cells. SPH2D_OK or SPH2D_NOMEM. */
sph2d_status sph2d__sort_fluid(sph2d_sim *sim);

/** Sets the shift velocity's gain for a step: `gain` times the scene's, limited by stability. Shifting is a diffusion
 *  of particles with D = gain U H; `limit` is the largest D dt / H^2 for which the scheme is stable. */
void sph2d__limit_shift(sph2d__system *s, double gain, double limit, double dt);

/** Moves a(n) to old_ax and old_ay, so that the second kick can undo the prediction. */
void sph2d__keep_accelerations(sph2d__store *fluid);

#endif
