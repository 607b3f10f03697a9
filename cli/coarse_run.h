/* SPDX-License-Identifier: MIT */
/** @file coarse_run.h
 *  Estimates the cost of a run by a short, coarse run, which shows how time steps and numbers of particles change. */
#ifndef SPH2D_CLI_COARSE_RUN_H
#define SPH2D_CLI_COARSE_RUN_H

#include "sph2d/sim.h"

/** Ratios of a whole run to its first steps, and costs. */
typedef struct coarse_run {
    double steps;           /**< steps over those with the first step's length; 1 if unknown */
    double particles;       /**< mean number of particles over that at the start; 1 if unknown */
    double cost;            /**< mean time of a particle and step over that of the first steps; 1 if unknown */
    double cpu_of_step;     /**< of a step, without its particles [s]; 0 if unknown */
    double cpu_of_particle; /**< of a particle and step [s]; 0 if unknown */
    double mean;            /**< mean number of particles of the scene; 0 if unknown */
} coarse_run;

/** Enlarges the spacings of a scene. Its blocks become copies, which the caller frees; NULL when memory is short, and
 *  then the scene is unchanged. */
sph2d_block *coarse_scene(sph2d_scene *scene, double k);

/** Runs a coarse copy of a scene, or a small scene itself, on one thread, for a second at most; `steps`, `seconds` and
 *  `particles` are expected from the scene's first steps. All is unknown for a scene that cannot be made coarser. */
coarse_run coarse_run_estimate(const sph2d_scene *scene, double steps, double seconds, double particles);

#endif
