/* SPDX-License-Identifier: MIT */
/** @file hand_made.h
 *  Simulations whose particles a test places itself. */
#ifndef SPH2D_TESTS_HAND_MADE_H
#define SPH2D_TESTS_HAND_MADE_H

#include "common.h"
#include "sim/simulation.h"

/** A simulation of this scene without its blocks: no particles, and room for `room`. On one thread, or as many. */
sph2d_sim *hand_made(sph2d_scene scene, size_t room, int threads);

/** Adds a particle at rest with rest density. Returns its index until the next sorting. */
size_t add_particle(sph2d_sim *sim, double x, double y);

/** Adds a square lattice of the scene's spacing to a rectangle, half a spacing from its sides, each coordinate
 *  displaced by up to `jitter` spacings. */
void add_lattice(sph2d_sim *sim, sph2d_box box, double jitter, uint64_t seed);

/** Removes all particles. */
void remove_all(sph2d_sim *sim);

/** Sorts the particles into cells. */
void sort_particles(sph2d_sim *sim);

#endif
