/* SPDX-License-Identifier: MIT */
/** @file system.h
 *  What a method moves: the two stores with their cells, and the numbers of the liquid. */
#ifndef SPH2D_METHODS_COMMON_SYSTEM_H
#define SPH2D_METHODS_COMMON_SYSTEM_H

#include "base/team.h"
#include "methods/common/body.h"
#include "methods/common/profile.h"
#include "particles/cells.h"
#include "particles/neighbours.h"
#include "sph2d/sim.h"

/** Size and upper end of sph2d__system's pair_gain. */
enum { SPH2D__PAIR_GAINS = 96, SPH2D__PAIR_GAIN_TOP = 4 };

typedef struct sph2d__system {
    sph2d__store fluid, walls;
    sph2d__cells fluid_cells, wall_cells;
    sph2d__neighbours neighbours, wall_neighbours; /**< of fluid and boundary particles, in methods that keep them */
    bool walls_press;                              /**< some boundary particle acts by pressure */
    bool walls_move;                               /**< some boundary particle changes its place */
    bool walls_reflect;                            /**< some boundary particle reflects */

    double spacing;         /**< dx [m] */
    double support;         /**< support radius H [m] */
    double reach;           /**< how far off fluid particles must be found [m] */
    double wall_reach;      /**< how far off boundary particles must be found [m] */
    double mass;            /**< of a fluid particle [kg/m] */
    double rest_density;    /**< [kg/m^3] */
    double sound_speed;     /**< c0 [m/s] */
    double viscosity;       /**< dynamic [Pa s] */
    double surface_tension; /**< [N/m] */
    double calibration;     /**< muller: factor on summed density that makes a filled lattice have the rest density */
    double side_fill;       /**< muller: F of muller_side.h, times rest density [kg/m^3] */
    double corner_fill;     /**< muller: Q, times rest density [kg/m^3] */
    double side_power;      /**< muller: m */
    double modulus;         /**< muller: pressure over summed density beyond rest density [m^2/s^2] */
    double pair_gain[SPH2D__PAIR_GAINS +
                     1];   /**< muller: pressure that pairs take over that which is reported, at densities
                                                  from 1 to SPH2D__PAIR_GAIN_TOP times rest density */
    double moment;         /**< of a projection's gradients on a filled lattice, where 1 would be exact */
    double residual_gain;  /**< wcsph, fitted: gamma, the part of the fit's residual that belongs to the Laplacian */
    double shift_gain;     /**< wcsph, fitted: shift velocity over U and the crowding; set for each step */
    double lattice_values; /**< wcsph: sum of f(r/H)/f(dx/H) over a filled lattice, the particle itself with them */
    double lattice_slopes; /**< wcsph: sum of g(r/H) over the others of a filled lattice */
    sph2d_method_options method; /**< the scene's, every default filled in */
    sph2d_slip wall_slip;
    double slip_length; /**< of smooth walls [m] */
    sph2d__body body;

    double step;         /**< length of the step that is being taken [s] */
    double speed;        /**< largest speed of a particle when the step began [m/s] */
    double max_pressure; /**< largest pressure then, that of the scene's head at least [Pa] */
    double head;    /**< g h + U^2/2 + pull of the scene as it starts, or what its sound speed is meant for [m^2/s^2] */
    double tension; /**< wcsph: by how much pressure may be negative; infinite without tensile control [Pa] */
    double max_density; /**< largest density of a particle then, the rest density at least [kg/m^3] */

    uint64_t iterations;    /**< of the pressure solver in the step that was taken */
    bool unconverged;       /**< it was not done then */
    double residual;        /**< compression that it left */
    double wanted_residual; /**< and what it should have left at most */

    sph2d__profile profile;
    sph2d__memory *memory;
    sph2d__team *team; /**< that shares the loops; NULL: one thread */
    sph2d_isa isa;
} sph2d__system;

#endif
