/* SPDX-License-Identifier: MIT */
/** @file pilot.h
 *  A short run with fewer, larger particles, to see how steps shorten and particles come and go in a scene. */
#ifndef SPH2D_CLI_PILOT_H
#define SPH2D_CLI_PILOT_H

#include "sph2d/sim.h"

/** What a run will take beyond what its first steps tell. */
typedef struct cli_pilot {
    double steps;           /**< steps over those that the first step's length makes; 1 when nothing is known */
    double particles;       /**< mean number of particles in a step over that at the start; 1 likewise */
    double cost;            /**< mean time of a particle in a step over that of the first steps; 1 likewise */
    double cpu_of_step;     /**< of a step, beside its particles [s]; 0 likewise */
    double cpu_of_particle; /**< of a particle in a step [s]; 0 when nothing is known */
    double mean;            /**< particles of the scene in a step, by those of the pilot; 0 likewise */
} cli_pilot;

/** Makes the pilot run of a scene on one thread, for a second or two, with sources four at most; `steps`, `seconds` and
 *  `particles` are what the scene's first steps let expect. A scene that cannot be made coarser gives one that knows
 *  nothing. */
cli_pilot pilot_run(const sph2d_scene *scene, double steps, double seconds, double particles);

#endif
