/* SPDX-License-Identifier: MIT */
/** @file store.h
 *  Particles as a struct of arrays. Fluid and boundary particles are two stores of this type. Each method declares the
 *  arrays that it needs; the others are never allocated. */
#ifndef SPH2D_PARTICLES_STORE_H
#define SPH2D_PARTICLES_STORE_H

#include <stdbool.h>
#include <stdint.h>

#include "base/address.h"
#include "base/memory.h"

/** Doubles after the last particle, which vector loads may read and vector stores may overwrite. */
enum { SPH2D__PADDING = 16 };

/** The arrays of doubles. */
#define SPH2D__STORE_REALS(X)                                                                                          \
    X(x) /* position [m] */                                                                                            \
    X(y)                                                                                                               \
    X(vx) /* velocity [m/s] */                                                                                         \
    X(vy)                                                                                                              \
    X(ax) /* acceleration [m/s^2] */                                                                                   \
    X(ay)                                                                                                              \
    X(old_ax) /* acceleration of the previous step, while a step needs both */                                         \
    X(old_ay)                                                                                                          \
    X(free_ax) /* acceleration without pressure, of a step with a pressure solver [m/s^2] */                           \
    X(free_ay)                                                                                                         \
    X(density)      /* [kg/m^3] */                                                                                     \
    X(pressure)     /* that is reported [Pa]; by which pairs act, too, where acting_pressure is missing */             \
    X(volume)       /* mass over density [m^2] */                                                                      \
    X(mass)         /* of a boundary particle [kg/m]; 0 if it only reflects. All fluid particles have one mass */      \
    X(bounce)       /* restitution of a boundary particle that reflects; negative: it exerts pressure */               \
    X(density_rate) /* material derivative of density [kg/(m^3 s)] */                                                  \
    X(shift_x)      /* shift velocity [m/s] */                                                                         \
    X(shift_y)                                                                                                         \
    X(shift_ax) /* added to the rates of velocity and density: advection with the shift velocity; in reservoirs less \
                 * these rates, so that what is prescribed holds */ \
    X(shift_ay)                                                                                                        \
    X(shift_density_rate)                                                                                              \
    X(normal_x) /* unit normal from a boundary particle to the wall's surface */                                       \
    X(normal_y)                                                                                                        \
    X(depth)    /* depth of a boundary particle below the surface [m] */                                               \
    X(filling)  /* part of the support outside walls that other liquid fills: 1 inside, half at a surface */           \
    X(filled)   /* of a boundary particle: density over rest density by liquid that fills its front: projection.h */   \
    X(stretch)  /* (dvx/dx - dvy/dy)/2 [1/s] */                                                                        \
    X(shear)    /* (dvx/dy + dvy/dx)/2 [1/s] */                                                                        \
    X(rotation) /* (dvy/dx - dvx/dy)/2 [1/s] */                                                                        \
    X(skin)     /* length of surface that a boundary particle of the first layer represents, 0 in others [m] */        \
    X(drag)     /* friction of a smooth wall over the sum of kernel weights: friction.h */                             \
    X(log_density)     /* logarithm of density over rest density */                                                    \
    X(stored)          /* a particle's energy of close pairs and beside sides [J/kg]: wcsph.h */                       \
    X(acting_pressure) /* by which pairs act where another is reported [Pa]: muller.h, projection.h */                 \
    X(next_x)          /* position predicted by a pressure solver */                                                   \
    X(next_y)                                                                                                          \
    X(diagonal)     /* of the matrix of a pressure solver */                                                           \
    X(multiplier)   /* dt^2 p/rho0 during the solution [m^2] */                                                        \
    X(residual)     /* compression error */                                                                            \
    X(direction)    /* trial multiplier: a float twice, lanes.h */                                                     \
    X(packed_place) /* two arrays of floats each, one after the other: hybrid.h */                                     \
    X(packed_state)                                                                                                    \
    X(start_x) /* position of a boundary particle at time 0 */                                                         \
    X(start_y)                                                                                                         \
    X(old_density_rate) /* of the previous step */                                                                     \
    X(older_ax)         /* of two steps before */                                                                      \
    X(older_ay)                                                                                                        \
    X(older_density_rate)

/** The index of each array. */
enum sph2d__store_real {
#define SPH2D__STORE_INDEX(name) SPH2D__STORE_##name,
    SPH2D__STORE_REALS(SPH2D__STORE_INDEX)
#undef SPH2D__STORE_INDEX
        SPH2D__STORE_COUNT
};

/** A set of arrays, a bit each. */
typedef uint64_t sph2d__set;
#define SPH2D__BIT(name) ((sph2d__set)1 << SPH2D__STORE_##name)
_Static_assert(SPH2D__STORE_COUNT <= 64, "a set of arrays has 64 bits");

/** What every store has. */
#define SPH2D__STORE_BASIC (SPH2D__BIT(x) | SPH2D__BIT(y) | SPH2D__BIT(vx) | SPH2D__BIT(vy))

/** A store; initialise it with its two sets of arrays and zeros. */
typedef struct sph2d__store {
    sph2d__set has;     /**< the arrays that it has; constant once memory is reserved */
    sph2d__set carried; /**< those whose values are reordered; the others are recomputed before they are read */
    size_t count, capacity;
#define SPH2D__STORE_MEMBER(name) SPH2D__ARRAY double *name;
    SPH2D__STORE_REALS(SPH2D__STORE_MEMBER)
#undef SPH2D__STORE_MEMBER
    SPH2D__ARRAY uint64_t *id;
    SPH2D__ARRAY uint64_t *color; /**< 0xRRGGBB; only where `colored`, which is constant, too */
    bool colored;
    SPH2D__ARRAY void *scratch; /**< target of a reordering, then swapped with its source */
} sph2d__store;

/** Bytes per particle in a store. */
size_t sph2d__store_bytes(const sph2d__store *store);

/** Reserves memory for at least `capacity` particles; the contents are kept. */
bool sph2d__store_reserve(sph2d__store *store, sph2d__memory *memory, size_t capacity);
void sph2d__store_free(sph2d__store *store, sph2d__memory *memory);

/** Adds a particle at a position, with all other values 0; the caller has reserved memory. Returns its index. */
size_t sph2d__store_add(sph2d__store *store, uint64_t id, double x, double y);

/** Puts the particles into a new order: particle order[k] becomes particle k. */
void sph2d__store_reorder(sph2d__store *store, const uint32_t *order);

/** Removes every particle whose flag is set, keeping the order of the rest. */
void sph2d__store_remove(sph2d__store *store, const unsigned char *flags);

#endif
