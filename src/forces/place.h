/* SPDX-License-Identifier: MIT */
/** @file place.h
 *  Where a force is asked for. */
#ifndef SPH2D_FORCES_PLACE_H
#define SPH2D_FORCES_PLACE_H

/** Place [m] and velocity [m/s] of a particle, relative to the tank. */
typedef struct sph2d__place {
    double x, y, vx, vy;
} sph2d__place;

#endif
