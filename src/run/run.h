/* SPDX-License-Identifier: MIT */
/** @file run.h
 *  What a step does besides moving particles: sources and drains, guards, the length of the next step, the summary. */
#ifndef SPH2D_RUN_RUN_H
#define SPH2D_RUN_RUN_H

#include "sim/simulation.h"

/** Looks at every particle after its velocity and acceleration are new: finite values, largest speed, acceleration and
 *  compression; from them the length of the next step. False when a guard fires. */
bool sph2d__sim_measure(sph2d_sim *sim, sph2d_report *report);
/** Chooses the length of the next step from the largest speed [m/s] and acceleration [m/s^2] of a particle. */
void sph2d__sim_choose_step(sph2d_sim *sim, double fastest, double acceleration);
/** Fastest block at the start [m/s], without known flows, which start as they would go on. */
double sph2d__sim_start_speed(const sph2d_sim *sim);
/** The next step over the one that speed and sound allow: less than 1 for the first step of liquid whose density is
 *  integrated and that starts in motion against a wall or other liquid. */
double sph2d__sim_step_part(const sph2d_sim *sim);

/** Books work and dissipation from time to time, and how far energy rises above an earlier moment (energy.c). Errors:
 *  SPH2D_NOMEM. */
sph2d_status sph2d__sim_watch_energy(sph2d_sim *sim);
/** Densities that liquid may have by the method [kg/m^3], and the part of the scene's energy scale by which energy may
 *  rise. */
typedef struct sph2d__bounds {
    double min_density, max_density, rise;
} sph2d__bounds;
sph2d__bounds sph2d__sim_bounds(const sph2d_sim *sim);

/** False, reported, when energy came from nothing. */
bool sph2d__sim_guard_energy(const sph2d_sim *sim, sph2d_report *report);

/** Samples the compression when the step count says so. */
void sph2d__sim_sample(sph2d_sim *sim);

/** Fills the plan from a simulation that is ready to step. */
void sph2d__sim_make_plan(sph2d_sim *sim);

/** Feeds and drains at the present moment, before a step. Errors: SPH2D_NOMEM. */
sph2d_status sph2d__sim_emit(sph2d_sim *sim);
sph2d_status sph2d__sim_drain(sph2d_sim *sim);

/** Copies a state into a simulation whose walls are placed and whose fluid is empty. Errors: SPH2D_FORMAT, SPH2D_NOMEM.
 */
sph2d_status sph2d__sim_load(sph2d_sim *sim, const sph2d_state *state, sph2d_report *report);

#endif
