/* SPDX-License-Identifier: MIT */
/** @file shared.h
 *  Memory of a simulation that others may hold: a block that is held lives until it is released, even if the simulation
 *  has long freed it. For languages whose views of arrays live as long as they are used.
 *
 *      sph2d_sim_options options = sph2d_sim_options_default();
 *      options.allocator = sph2d_shared_allocator();
 *      if (sph2d_sim_create(&scene, &options, &sim, &report) != SPH2D_OK) ...;
 *      const double *x = sph2d_sim_fluid(sim).x;
 *      sph2d_shared_hold(x);
 *      sph2d_sim_destroy(sim);
 *      ... x[0] ...;
 *      sph2d_shared_release(x);
 *
 *  Blocks are the arrays of an sph2d_view, and those of a field of the fluid or the walls whose stride is 1. Steps may put
 *  other values into a block that is held: it is the memory that lives on. Holding and releasing may be done by any
 *  thread, but a simulation that another thread steps may free a block before it is held. */
#ifndef SPH2D_SHARED_H
#define SPH2D_SHARED_H

#include "sph2d/sim.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The allocator of such memory, on top of the C library's. A block takes 64 bytes more; they are not counted by
 *  sph2d_sim_memory(). */
SPH2D_API sph2d_allocator sph2d_shared_allocator(void);

/** Holds a block of a simulation that has this allocator, once more. NULL is fine. */
SPH2D_API void sph2d_shared_hold(const void *block);

/** Releases it once; each hold needs one. NULL is fine. */
SPH2D_API void sph2d_shared_release(const void *block);

#ifdef __cplusplus
}
#endif
#endif
