/* SPDX-License-Identifier: MIT */
/** @file run.h
 *  The parts of a step besides the time scheme: sources and drains, guards, length of the next step, summary. */
#ifndef SPH2D_RUN_RUN_H
#define SPH2D_RUN_RUN_H

#include "sim/simulation.h"

/** The number of threads of a step: as wanted, else those of OpenMP, or fewer where there are few particles. */
int sph2d__sim_threads(const sph2d_sim *sim);

/** Checks all particles after velocity and acceleration are updated: finite values, largest speed, acceleration and
 *  compression; sets the length of the next step. False when a guard fires. */
bool sph2d__sim_measure(sph2d_sim *sim, sph2d_report *report);

/** Hints at what to do about a particle at `place`, beyond a wall of the domain (escaped.c). */
void sph2d__sim_hint_escape(const sph2d_sim *sim, sph2d_vec2 place, sph2d_diagnostic *diagnostic);
/** Chooses the length of the next step from the largest speed [m/s] and acceleration [m/s^2] of a particle. */
void sph2d__sim_choose_step(sph2d_sim *sim, double fastest, double acceleration);
/** Samples work and dissipation every few steps and updates the error and the rise of energy (energy_guard.c). Errors:
 *  SPH2D_NOMEM. */
sph2d_status sph2d__sim_update_energy_balance(sph2d_sim *sim);
/** Bounds of the guards: density by method [kg/m^3], and the rise of energy over the scene's energy scale. */
typedef struct sph2d__bounds {
    double min_density, max_density, rise;
} sph2d__bounds;
sph2d__bounds sph2d__sim_bounds(const sph2d_sim *sim);

/** False, with a report, when the rise of energy is above its bound. */
bool sph2d__sim_guard_energy(const sph2d_sim *sim, sph2d_report *report);
/** The same for momentum that came from nothing. */
bool sph2d__sim_guard_momentum(const sph2d_sim *sim, sph2d_report *report);

/** Samples the compression every few steps. */
void sph2d__sim_sample(sph2d_sim *sim);

/** Bytes of a snapshot without compression, and of a particle of the liquid in it. */
double sph2d__snapshot_bytes(sph2d_sim *sim, double *of_particle);

/** Fills the plan of a simulation that is ready for its first step. */
void sph2d__sim_make_plan(sph2d_sim *sim);

/** Lets the velocities in absorbing ends decay for a step of `dt`, and books the energy. */
void sph2d__sim_absorb(sph2d_sim *sim, double dt);

/** Apply sources, and drains and open sides, before a step. Errors: SPH2D_NOMEM. */
sph2d_status sph2d__sim_emit(sph2d_sim *sim);
sph2d_status sph2d__sim_drain(sph2d_sim *sim);

/* Cells use 32-bit indices. */
static const size_t SPH2D__MAX_PARTICLES = 4000000000u;

/** Whether a new particle can be placed: on the same side of every wall at rest as `start`, 0.75 spacings from walls and
 *  other particles. The first `sorted` particles are in the cells, the others are new. */
bool sph2d__sim_has_room(const sph2d_sim *sim, size_t sorted, sph2d_vec2 start, double x, double y);
/** Adds the surface energy due to the new particles, from `sorted` on, which are not yet in the cells. Errors:
 *  SPH2D_NOMEM. */
sph2d_status sph2d__sim_book_new_surface(sph2d_sim *sim, size_t sorted);
/** Sorts the fluid between steps, carrying all arrays along. Errors: SPH2D_NOMEM. */
sph2d_status sph2d__sim_sort_all_arrays(sph2d_sim *sim);
/** Makes room for a flag of each particle in sim->to_remove. False when memory is short. */
bool sph2d__sim_reserve_flags(sph2d_sim *sim);
/** Removes the particles whose flag is set, and books their energy. Errors: SPH2D_NOMEM. */
sph2d_status sph2d__sim_remove_flagged(sph2d_sim *sim);

/** Copies a state into a simulation with walls but no fluid. Errors: SPH2D_FORMAT, SPH2D_NOMEM. */
sph2d_status sph2d__sim_load(sph2d_sim *sim, const sph2d_state *state, sph2d_report *report);
/** Whether the particles of a state have colours of their own. */
bool sph2d__state_has_colors(const sph2d_state *state);

/** Whether a state says nothing of bodies, which then start as the scene has them. */
bool sph2d__state_lacks_bodies(const sph2d_state *state);

/** Books the energy of bodies that start in the middle of a run as fed: all that there is now more than when it was summed
 *  last. */
void sph2d__sim_book_new_bodies(sph2d_sim *sim);

#endif
