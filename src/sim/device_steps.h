/* SPDX-License-Identifier: MIT */
/** @file device_steps.h
 *  Parts of a step on a device that are the same for all methods; what they are on the processor, the functions that call them say. */
#ifndef SPH2D_SIM_DEVICE_STEPS_H
#define SPH2D_SIM_DEVICE_STEPS_H

#include "methods/common/on_device.h"
#include "methods/common/wall_force.h"
#include "sim/device_data.h"
#include "sim/extremes.h"
#include "sph2d/sim.h"

/** Opens a device for a simulation whose scene it takes. Errors: SPH2D_INVALID, SPH2D_DEVICE, SPH2D_NOMEM, with a report. */
sph2d_status sph2d__device_start(sph2d_sim *sim, int number, bool same_bits, sph2d_report *report);
void sph2d__device_end(sph2d_sim *sim);

/** Reports the failure of the device, if there was one: SPH2D_DEVICE; else SPH2D_OK. */
sph2d_status sph2d__device_check(const sph2d_sim *sim, sph2d_report *report);

/** Sorts the fluid into its cells. False when memory is short. */
bool sph2d__device_sort(sph2d__system *system);

/** Moves all particles by the method's kernel `advect`. Returns what happened to them; energies are counted in quanta [J/m]. If asked for by `noted`, what walls did to so many of them is in the
 *  simulation's list of contacts. */
sph2d__events sph2d__device_advect(sph2d_sim *sim, double dt, double quantum, bool noted);

/** The forces of all boundary particles, sph2d__sim_force_of_wall(), at the array `forces` of the simulation. */
void sph2d__device_wall_forces(const sph2d__system *system, sph2d__wall_force *forces);

sph2d__extremes sph2d__device_extremes(const sph2d__system *system, const sph2d__limits *within);

#endif
