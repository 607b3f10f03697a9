/* SPDX-License-Identifier: MIT */
/** @file gaps.h
 *  Pressure in gaps between a body and another wall that are too thin for particles.
 *
 *  Without it a body that touches the floor feels the liquid above it and none below: it is pressed down by the whole
 *  depth, and a box of cork stays on the floor of a full tank. Water does enter such gaps, and then has the pressure of
 *  the liquid at their ends: p - rho g.x is constant in liquid at rest. So it is here along each part of an outline that
 *  has another wall right in front and liquid at both ends, with the mean of these. It takes the time in which liquid
 *  enters. A gap with a dry end has no pressure: water would run out of it.
 *
 *  The force acts on bodies alone, on both where two of them meet. Liquid has no part in it: its work is external. */
#ifndef SPH2D_SIM_GAPS_H
#define SPH2D_SIM_GAPS_H

#include "boundary/rigid.h"
#include "sph2d/sim.h"

/** A short piece of a body's outline, where the scene draws it. */
typedef struct sph2d__gap_piece {
    sph2d_vec2 at;     /**< its middle [m] */
    sph2d_vec2 normal; /**< outward normal times its length [m] */
} sph2d__gap_piece;

/** What is in front of a piece now. */
typedef struct sph2d__gap_front {
    sph2d_vec2 at;   /**< where it is [m] */
    double part;     /**< 1 where another wall is so near that the gap is thin, less as it widens */
    double liquid;   /**< 1 with liquid near, down to 0 without */
    double pressure; /**< of that liquid [Pa] */
    uint64_t beside; /**< id of the nearest boundary particle of the other wall; UINT64_MAX: a side without any */
} sph2d__gap_front;

typedef struct sph2d__gaps {
    sph2d__gap_piece *pieces; /**< of all bodies, one after another */
    sph2d__gap_front *fronts; /**< the same */
    size_t *first;            /**< of each body, and the end of the last */
} sph2d__gaps;

/** Makes the pieces of all bodies. Errors: SPH2D_NOMEM. */
sph2d_status sph2d__gaps_create(sph2d_sim *sim);

/** Sets the force of all gaps on each body (sph2d__rigid_state.gap), by the liquid as it is now. */
void sph2d__gaps_press(sph2d_sim *sim);

#endif
