/* SPDX-License-Identifier: MIT */
/** @file state.h
 *  The state of a simulation, everything that is needed to continue it in a new one.
 *
 *      sph2d_state state = sph2d_sim_state(sim);
 *      sph2d_sim *other = NULL;
 *      sph2d_status status = sph2d_sim_restore(&scene, NULL, &state, &other, &report);
 *
 *  A simulation created by sph2d_sim_restore continues bit for bit like the one with that state, with the same binary
 *  and instruction set, for any number of threads. */
#ifndef SPH2D_STATE_H
#define SPH2D_STATE_H

#include "sph2d/array.h"
#include "sph2d/sim.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The version of the state's layout. A state of another version is rejected. */
#define SPH2D_STATE_VERSION 13u

/** A list of arrays: fields of fluid and walls in their order, and the scalars of the run. */
typedef struct sph2d_state {
    /** SPH2D_STATE_VERSION of the library that made it. */
    uint64_t version;

    /** The arrays, borrowed. */
    const sph2d_array *arrays;

    /** Number of arrays. */
    size_t array_count;
} sph2d_state;

/** The state of a simulation. Nothing is copied: arrays are valid until the next call that changes `sim`. No arrays when
 *  memory is short, nor after a step that returned SPH2D_NOMEM: it ended in the middle, from which nothing can go on; nor when
 *  the device has failed (sph2d_sim_device_status()). */
SPH2D_API sph2d_state sph2d_sim_state(sph2d_sim *sim);

/** Creates a simulation that continues from `state`, whose data is copied. Every array is validated: presence, shape,
 *  type, finite values, ranges. A state without any array of SPH2D_GROUP_WALL goes on among the walls of `scene`, where
 *  they are at its time: so walls can be added and taken away in a run, also where a body started. If it has no array
 *  "Bodies" either, bodies start as in `scene`, whatever those of the state were; their energy counts as fed. Liquid that is inside
 *  a new one stays there until sph2d_sim_remove_particles() takes it away. Errors: SPH2D_FORMAT for a state that is not
 *  one of this scene and version; otherwise as sph2d_sim_create. `options` may be NULL; its `isa` is overridden by the
 *  one stored in the state, and that by a device, which goes on as baseline. */
SPH2D_API sph2d_status sph2d_sim_restore(const sph2d_scene *scene, const sph2d_sim_options *options,
                                         const sph2d_state *state, sph2d_sim **sim, sph2d_report *report);

#ifdef __cplusplus
}
#endif
#endif
