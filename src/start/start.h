/* SPDX-License-Identifier: MIT */
/** @file start.h
 *  How a simulation gets its particles: walls first, then liquid. */
#ifndef SPH2D_START_START_H
#define SPH2D_START_START_H

#include "sim/simulation.h"

/** Whether so many particles are more than this machine's memory holds or a 32-bit index can name; then it is reported
 *  at `path`. */
bool sph2d__sim_too_many(const sph2d_sim *sim, double count, const char *path, sph2d_report *report);

/** Places the boundary particles of obstacles and sides. Errors: SPH2D_SCENE, SPH2D_NOMEM. */
sph2d_status sph2d__sim_place_walls(sph2d_sim *sim, sph2d_report *report);
/** Places the layers of a generalised wall: along an obstacle, whose back goes into its barrier, and around the sides
 *  of the domain that are walls. The same errors. */
sph2d_status sph2d__sim_place_layers(sph2d_sim *sim, const sph2d_obstacle *obstacle, sph2d__barrier *barrier,
                                     sph2d_report *report);
sph2d_status sph2d__sim_place_rings(sph2d_sim *sim, sph2d_report *report);
/** Places the particles of one block, and of all with the single ones. Errors: SPH2D_SCENE, SPH2D_NOMEM. */
sph2d_status sph2d__sim_place_block(sph2d_sim *sim, size_t index, sph2d_report *report);
sph2d_status sph2d__sim_place_fluid(sph2d_sim *sim, sph2d_report *report);

/** What an obstacle does to a place: leaves it free, encloses it, has it within the distance that it keeps free behind
 *  its own layers, or without layers. */
typedef enum sph2d__taken { SPH2D__FREE, SPH2D__ENCLOSED, SPH2D__BESIDE_LAYERS, SPH2D__BESIDE_LINE } sph2d__taken;

/** What the obstacles do to a place, or to one of its images beyond periodic sides: the last of the above that one of
 *  them does. They keep `part` of their distance free. */
sph2d__taken sph2d__sim_taken(const sph2d_sim *sim, sph2d_vec2 p, double part);

/** Faults of placed particles. Block `index`, whose particles start at `first`, against those before it; particles in
 *  one place, ids from `first` on being those of single ones; liquid in the layers of an obstacle, both once the cells
 *  are built; that single particle k cannot be where it is. Errors: SPH2D_SCENE. */
sph2d_status sph2d__sim_check_overlap(const sph2d_sim *sim, size_t index, size_t first, sph2d_report *report);
sph2d_status sph2d__sim_check_distances(const sph2d_sim *sim, uint64_t first, sph2d_report *report);
sph2d_status sph2d__sim_check_layers(const sph2d_sim *sim, sph2d_report *report);
sph2d_status sph2d__sim_refuse_particle(size_t k, const char *what, sph2d_vec2 p, sph2d_report *report);

/** Gives the particles of a block, from `first` on, the velocity and pressure of the flow that it starts with. Errors:
 *  SPH2D_SCENE. */
sph2d_status sph2d__sim_start_block(sph2d_sim *sim, size_t index, size_t first, sph2d_report *report);

#endif
