/* SPDX-License-Identifier: MIT */
/** @file lists.h
 *  The lists of a scene that play changes: obstacles and bodies. */
#ifndef SPH2D_CLI_PLAY_LISTS_H
#define SPH2D_CLI_PLAY_LISTS_H

#include <sph2d/scene.h>

/** Where a body is now: its centre of mass has gone `from` a place `to` another [m], and it has turned [rad]. */
typedef struct body_move {
    sph2d_vec2 from, to;
    double angle;
} body_move;

/** A place of a body's plane after the move, and the other way round. */
sph2d_vec2 body_moved(const body_move *move, sph2d_vec2 p);
sph2d_vec2 body_moved_back(const body_move *move, sph2d_vec2 p);

/** Gives a scene obstacles and bodies of its own, with their corners and springs, in one block that is returned; the rest
 *  is borrowed as before. `moves`, one for each body, which then starts where it is now; NULL: as they were. The caller
 *  frees the block. NULL when memory is short. */
void *lists_copy(sph2d_scene *scene, const body_move *moves);

#endif
