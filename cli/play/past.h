/* SPDX-License-Identifier: MIT */
/** @file past.h
 *  What a scene was before the last acts of the user, so that these can be undone. */
#ifndef SPH2D_CLI_PLAY_PAST_H
#define SPH2D_CLI_PLAY_PAST_H

#include <sph2d/scene.h>
#include <sph2d/state.h>

enum { PAST_MOST_ACTS = 10 };

/** What was before an act. */
typedef struct past_act {
    const char *name; /**< of the act: "pour" */
    sph2d_scene scene;
    void *lists;         /**< its obstacles and bodies, its own */
    sph2d_array *arrays; /**< of the state, in one block with their data */
    size_t array_count, bytes;
} past_act;

/** The last acts, the latest last: ten, and 128 MiB of them, at most. Starts with {0}. */
typedef struct past {
    past_act acts[PAST_MOST_ACTS];
    size_t count, bytes;
} past;

/** Keeps a copy of what is, before an act. Where there is no memory for it, nothing can be undone. */
void past_keep(past *p, const char *name, const sph2d_scene *scene, const sph2d_state *state);

/** Drops the latest act. */
void past_drop(past *p);

void past_free(past *p);

#endif
