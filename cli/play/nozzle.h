/* SPDX-License-Identifier: MIT */
/** @file nozzle.h
 *  A jet that is poured by hand: like a source of the scene, but one that moves. */
#ifndef SPH2D_CLI_PLAY_NOZZLE_H
#define SPH2D_CLI_PLAY_NOZZLE_H

#include <stdbool.h>

#include <sph2d/sim.h>

/** Starts with {0}. */
typedef struct nozzle {
    bool open;     /**< for the next steps */
    sph2d_vec2 at; /**< its middle [m] */
    double width;  /**< across gravity [m] */
    double due;    /**< simulated time of the next row [s] */
    double color;  /**< of what is poured, as of sph2d_particle; 0: that of the scene */
} nozzle;

/** Opens it for the next steps, at a place, `width` wide [m]; a jet that was closed for more than a row begins anew. */
void nozzle_open(nozzle *n, const sph2d_scene *scene, const sph2d_sim *sim, sph2d_vec2 at, double width);

/** The acceleration by which the jet falls [m/s^2]: gravity; downwards and so large that it falls over the smaller side of
 *  the domain in about a second where there is none. */
sph2d_vec2 nozzle_gravity(const sph2d_scene *scene);

/** Adds the rows that are due, a spacing apart. They leave as fast as if they had fallen by half of the width. Between
 *  steps. Errors: as sph2d_sim_add_particles. */
sph2d_status nozzle_emit(nozzle *n, const sph2d_scene *scene, sph2d_sim *sim);

#endif
