/* SPDX-License-Identifier: MIT */
/** @file store.h
 *  Particles as a struct of arrays. Fluid and walls are two stores of this one type. */
#ifndef SPH2D_PARTICLES_STORE_H
#define SPH2D_PARTICLES_STORE_H

#include <stdbool.h>
#include <stdint.h>

#include "base/memory.h"

/** Doubles behind the last particle that a block of lanes may read. */
enum { SPH2D__PADDING = 16 };

/** The arrays of doubles: name, and whether a new order of the particles must carry its values along (the others are
 *  computed anew before they are read). */
#define SPH2D__STORE_REALS(X)                                                                                          \
    X(x, true) /* position [m] */                                                                                      \
    X(y, true)                                                                                                         \
    X(vx, true) /* velocity [m/s] */                                                                                   \
    X(vy, true)                                                                                                        \
    X(ax, true) /* acceleration [m/s^2] */                                                                             \
    X(ay, true)                                                                                                        \
    X(old_ax, false) /* acceleration one step before, while a step needs both */                                       \
    X(old_ay, false)                                                                                                   \
    X(density, false)  /* [kg/m^3] */                                                                                  \
    X(pressure, false) /* [Pa] */                                                                                      \
    X(volume, false)   /* mass over density [m^2] */

typedef struct sph2d__store {
    size_t count, capacity;
#define SPH2D__STORE_MEMBER(name, carried) double *name;
    SPH2D__STORE_REALS(SPH2D__STORE_MEMBER)
#undef SPH2D__STORE_MEMBER
    uint64_t *id;
    double *scratch; /**< where reordering writes, then swapped with the array it read */
    uint64_t *scratch_id;
} sph2d__store;

/** Room for `capacity` particles at least; counts and values stay. */
bool sph2d__store_reserve(sph2d__store *store, sph2d__memory *memory, size_t capacity);
void sph2d__store_free(sph2d__store *store, sph2d__memory *memory);

/** Adds a particle at rest of density 0; the caller has reserved the room. Returns its index. */
size_t sph2d__store_add(sph2d__store *store, uint64_t id, double x, double y);

/** Puts the particles into a new order: particle order[k] becomes particle k. */
void sph2d__store_reorder(sph2d__store *store, const uint32_t *order, int threads);

/** Removes every particle whose flag is set, keeping the order of the rest. */
void sph2d__store_remove(sph2d__store *store, const unsigned char *flags);

#endif
