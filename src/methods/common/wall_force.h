/* SPDX-License-Identifier: MIT */
/** @file wall_force.h
 *  The force of a boundary particle. */
#ifndef SPH2D_METHODS_COMMON_WALL_FORCE_H
#define SPH2D_METHODS_COMMON_WALL_FORCE_H

#include "sph2d/scene.h"

/** Force of a boundary particle on a fluid particle [N/m]. */
typedef struct sph2d__wall_force {
    sph2d_vec2 pressure, friction;
} sph2d__wall_force;

#endif
