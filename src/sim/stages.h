/* SPDX-License-Identifier: MIT */
/** @file stages.h
 *  What the methods' time schemes share. */
#ifndef SPH2D_SIM_STAGES_H
#define SPH2D_SIM_STAGES_H

#include "sim/simulation.h"

/** Particles that are moved together: so many that the look for walls around all of them costs little. */
enum { SPH2D__BATCH = 32 };

/** Some particles on their way. */
typedef struct sph2d__batch {
    size_t first, count;
    double dx[SPH2D__BATCH], dy[SPH2D__BATCH]; /**< their ways [m] */
    double vx[SPH2D__BATCH], vy[SPH2D__BATCH]; /**< velocities on them, which walls may turn [m/s] */
} sph2d__batch;

/** Sets ways and velocities of a batch for a step of `dt`; or what comes after its way. */
typedef void sph2d__batch_work(sph2d_sim *sim, double dt, sph2d__batch *batch);

/** Moves all particles by their ways, held by walls and brought round periodic sides, and sets their velocities
 *  (advect.c). `after` may be NULL. SPH2D_GUARD when a place is not finite. */
sph2d_status sph2d__advect(sph2d_sim *sim, double dt, sph2d__batch_work *set, sph2d__batch_work *after);

/** Sorts the fluid into its cells. SPH2D_OK or SPH2D_NOMEM. */
sph2d_status sph2d__sort_fluid(sph2d_sim *sim);

/** Sets the shift velocity's gain for a step: `gain` times the scene's, but no more than moves particles stably.
 *  Shifting is a diffusion of particles with D = gain U H, and `limit` the largest D dt / H^2 that the scheme stands.
 *  */
void sph2d__limit_shift(sph2d__system *s, double gain, double limit, double dt);

/** Keeps a(n) beside in old_ax and old_ay, so that the second kick can take the prediction back. */
void sph2d__keep_accelerations(sph2d__store *fluid);

/** Kicks a batch by dt/2 a, what a(n+1) is found with: v(n+1/2) + dt/2 a(n). */
sph2d__batch_work sph2d__predict;

/** From the predicted v(n+1/2) + dt/2 a(n) to v(n+1/2) + dt/2 a(n+1). */
void sph2d__second_kick(sph2d__system *s, double dt);

#endif
