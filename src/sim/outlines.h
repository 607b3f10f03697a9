/* SPDX-License-Identifier: MIT */
/** @file outlines.h
 *  The outlines of walls and bodies as they are now, for pictures and for programs that read snapshots. */
#ifndef SPH2D_SIM_OUTLINES_H
#define SPH2D_SIM_OUTLINES_H

#include "base/memory.h"
#include "sph2d/field.h"

/** The corners of all outlines, one after the other: first the domain's sides, then obstacles, then bodies. */
typedef struct sph2d__outlines {
    size_t count;
    sph2d_vec2 *start; /**< where they are drawn in the scene [m] */
    double *x, *y;     /**< where they are now [m] */
    uint64_t *id;      /**< which outline a corner belongs to, from 0 */
    uint64_t *liquid;  /**< sph2d_outline_liquid of its outline */
    uint64_t *wall;    /**< its obstacle, or body behind all obstacles; UINT64_MAX: a side, or beside an opening */
} sph2d__outlines;

/** Lists the outlines, in the arena. False when memory is short. */
bool sph2d__outlines_create(sph2d_sim *sim);

/** Moves those of moving obstacles and bodies to where these are. */
void sph2d__outlines_move(sph2d_sim *sim);

#endif
