/* SPDX-License-Identifier: MIT */
/** @file start.h
 *  Initial particles of a simulation: walls first, then liquid. */
#ifndef SPH2D_START_START_H
#define SPH2D_START_START_H

#include "sim/simulation.h"

/** Whether a number of particles exceeds this machine's memory or 32-bit indices; if so, it is reported at `path`. */
bool sph2d__sim_too_many(const sph2d_sim *sim, double count, const char *path, sph2d_report *report);

/** The same for all that the scene needs, before anything is placed. */
bool sph2d__sim_is_too_large(const sph2d_sim *sim, sph2d_report *report);

/** Places the boundary particles of obstacles and sides. Errors: SPH2D_SCENE, SPH2D_NOMEM. */
sph2d_status sph2d__sim_place_walls(sph2d_sim *sim, sph2d_report *report);
/** Place the layers of generalised walls: along an obstacle, adding the back of an open line to its barrier, and
 *  outside the sides of the domain that are walls. The same errors. */
sph2d_status sph2d__sim_place_layers(sph2d_sim *sim, const sph2d__wall *wall, sph2d__barrier *barrier,
                                     sph2d_report *report);
/** Whether the single row of an obstacle lies behind its surface: of solids that are heavy. */
bool sph2d__has_inset_row(const sph2d__wall *wall);
/** Piece `index` of a closed outline moved inwards by a distance [m], as a layer's. */
sph2d__segment sph2d__inset_piece(const sph2d_sim *sim, const sph2d__wall *wall, size_t index, double distance);
sph2d_status sph2d__sim_place_side_layers(sph2d_sim *sim, sph2d_report *report);
/** Place the particles of one block; all blocks and the single particles. Errors: SPH2D_SCENE, SPH2D_NOMEM. */
sph2d_status sph2d__sim_place_block(sph2d_sim *sim, size_t index, sph2d_report *report);
sph2d_status sph2d__sim_place_fluid(sph2d_sim *sim, sph2d_report *report);

/** A position relative to an obstacle: free, inside one with layers, within the clearance of one with layers, or inside
 *  or within the clearance of one without layers. */
typedef enum sph2d__occupancy { SPH2D__FREE, SPH2D__ENCLOSED, SPH2D__NEAR_LAYERS, SPH2D__NEAR_LINE } sph2d__occupancy;

/** The largest of these values over all obstacles and periodic images of a position; `factor` multiplies the
 *  clearance. */
sph2d__occupancy sph2d__sim_occupancy(const sph2d_sim *sim, sph2d_vec2 p, double factor);

/** Errors of placed particles: overlap of block `index`, whose particles start at `first`, with earlier blocks;
 *  coincident particles, where single particles have ids from `first` on; liquid in the layers of an obstacle (the last
 *  two need the cells). The last function reports a single particle k. Errors: SPH2D_SCENE. */
sph2d_status sph2d__sim_check_overlap(const sph2d_sim *sim, size_t index, size_t first, sph2d_report *report);
sph2d_status sph2d__sim_check_distances(const sph2d_sim *sim, uint64_t first, sph2d_report *report);
sph2d_status sph2d__sim_check_layers(const sph2d_sim *sim, sph2d_report *report);
sph2d_status sph2d__sim_refuse_particle(size_t k, const char *what, sph2d_vec2 p, sph2d_report *report);

/** The distance from a boundary particle in layers within which no liquid may start [m]. */
double sph2d__sim_clear_distance(const sph2d_sim *sim, size_t wall);
/** Whether a position is nearer to one of an obstacle. */
bool sph2d__sim_is_in_layers(const sph2d_sim *sim, sph2d_vec2 at);

/** Adds the velocity that liquid has at the start, and sets its pressure, to the particles from `first` on; `key` is that
 *  of `start` in the scene. Those of a lattice, whose spacing is that at rest density, are moved to where their density is
 *  that of still liquid. Errors: SPH2D_SCENE, SPH2D_NOMEM. */
sph2d_status sph2d__sim_start(sph2d_sim *sim, const sph2d_start *start, size_t first, const char *key, bool lattice,
                              sph2d_report *report);
/** The same by a known flow. */
sph2d_status sph2d__sim_start_flow(sph2d_sim *sim, const sph2d_flow *flow, size_t first, bool lattice,
                                   sph2d_report *report);

/** Places the liquid of the snapshot that the scene starts from. Errors: SPH2D_SCENE, SPH2D_NOMEM. */
sph2d_status sph2d__sim_place_snapshot(sph2d_sim *sim, sph2d_report *report);

#endif
