/* SPDX-License-Identifier: MIT */
/** @file system.h
 *  What a method moves: the two stores with their cells, and the numbers of the liquid. */
#ifndef SPH2D_METHODS_SYSTEM_H
#define SPH2D_METHODS_SYSTEM_H

#include "particles/cells.h"
#include "physics/body.h"
#include "sph2d/sim.h"

typedef struct sph2d__system {
    sph2d__store fluid, walls;
    sph2d__cells fluid_cells, wall_cells;
    double *wall_mass;    /**< of each boundary particle [kg/m]; 0 for those that only reflect */
    double *wall_bounce;  /**< restitution of each that reflects; negative for those that act by pressure */
    size_t wall_capacity; /**< length of the two arrays above */
    bool walls_press;     /**< some boundary particle acts by pressure */
    bool walls_reflect;   /**< some boundary particle reflects */

    double spacing;        /**< dx [m] */
    double support;        /**< support radius H [m] */
    double mass;           /**< of a fluid particle [kg/m] */
    double rest_density;   /**< [kg/m^3] */
    double sound_speed;    /**< c0 [m/s] */
    double viscosity;      /**< dynamic [Pa s] */
    double wall_viscosity; /**< of fluid on boundary particles [Pa s] */
    double cfl;            /**< of the acoustic limit */
    double calibration;    /**< factor on summed density that makes a filled lattice have the rest density */
    sph2d__body body;

    sph2d__memory *memory;
    int threads;
    sph2d_isa isa;
} sph2d__system;

#endif
