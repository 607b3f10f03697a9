/* SPDX-License-Identifier: MIT */
/** @file store.h
 *  Particles as a struct of arrays. Fluid and walls are two stores of this one type, and a method tells which arrays it
 *  needs: the others are never allocated. */
#ifndef SPH2D_PARTICLES_STORE_H
#define SPH2D_PARTICLES_STORE_H

#include <stdbool.h>
#include <stdint.h>

#include "base/team.h"

/** Doubles behind the last particle that a block of lanes may read, and write where nothing else is. */
enum { SPH2D__PADDING = 16 };

/** The arrays of doubles. */
#define SPH2D__STORE_REALS(X)                                                                                                   \
    X(x) /* position [m] */                                                                                                     \
    X(y)                                                                                                                        \
    X(vx) /* velocity [m/s] */                                                                                                  \
    X(vy)                                                                                                                       \
    X(ax) /* acceleration [m/s^2] */                                                                                            \
    X(ay)                                                                                                                       \
    X(old_ax) /* acceleration one step before, while a step needs both */                                                       \
    X(old_ay)                                                                                                                   \
    X(density)      /* [kg/m^3] */                                                                                              \
    X(pressure)     /* [Pa] */                                                                                                  \
    X(volume)       /* mass over density [m^2] */                                                                               \
    X(mass)         /* of a boundary particle [kg/m]; 0 for those that only reflect. All liquid has one mass */                 \
    X(bounce)       /* restitution of a boundary particle that reflects; negative: it acts by pressure */                       \
    X(density_rate) /* change of density of a particle on its way [kg/(m^3 s)] */                                               \
    X(shift_x)      /* shift velocity [m/s] */                                                                                  \
    X(shift_y)                                                                                                                  \
    X(shift_ax) /* rates of velocity and density by the shift along their slopes */                                             \
    X(shift_ay)                                                                                                                 \
    X(shift_density_rate)                                                                                                       \
    X(image_vx) /* velocity that liquid sees in a boundary particle, so that it sticks to the surface [m/s] */                  \
    X(image_vy)                                                                                                                 \
    X(normal_x) /* from a boundary particle straight to the wall's surface */                                                   \
    X(normal_y)                                                                                                                 \
    X(depth)    /* the distance to the surface [m] */                                                                           \
    X(grad_c_x) /* H grad C of symmetric operators, by which particles are shifted: shift.h */                                  \
    X(grad_c_y)                                                                                                                 \
    X(min_eigenvalue) /* how far the neighbourhood is filled: 1 in the bulk, near 0.5 at a flat surface, less in spray */       \
    X(filling) /* by other liquid, of the room that walls leave: 1 inside, half at a flat surface, 0 by itself */               \
    X(packing) /* density that the places of the particles around say [kg/m^3] */                                               \
    X(stretch) /* (dvx/dx - dvy/dy)/2 [1/s] */                                                                                  \
    X(shear)   /* (dvx/dy + dvy/dx)/2 [1/s] */                                                                                  \
    X(front)   /* 1 where no other wall is in front of a boundary particle's, 0 where one takes much of it: wcsph.h */          \
    X(along_x) /* the direction along a smooth wall where liquid slides, shorter where less of it does: wcsph.h */              \
    X(along_y)                                                                                                                  \
    X(slide)     /* what liquid in front pushes along it: wcsph.h */                                                            \
    X(skin)      /* length of the surface that a boundary particle next to it stands for, else 0 [m] */                         \
    X(drag)      /* friction of a smooth wall, over the kernel's weights: friction.h */                                         \
    X(wall_rate) /* the rate at which liquid fills what a boundary particle stands for: wcsph.h */                              \
    X(surface_distance) /* distance to the nearest particle of the free surface, the support radius where none is nearer [m] */ \
    X(density_grad_x) /* gradient of density [kg/m^4] */                                                                        \
    X(density_grad_y)                                                                                                           \
    X(excess)        /* density over that of a liquid at rest at the same place, and some constant [kg/m^3] */                  \
    X(push)          /* what pressures, or the direction of a search, push a particle: two floats, lanes.h */                   \
    X(pair_pressure) /* that pairs of particles carry [Pa] */                                                                   \
    X(next_x)        /* position that comes next, while a pressure solver predicts it */                                        \
    X(next_y)                                                                                                                   \
    X(filled) /* density over rest density that liquid adds at a boundary particle when it fills the room in front */           \
    X(diagonal)     /* of the matrix of a pressure solver, then its inverse */                                                  \
    X(multiplier)   /* dt^2 p/rho0 while it is solved for [m^2] */                                                              \
    X(residual)     /* compression that is left to correct */                                                                   \
    X(direction)    /* of the search, or what it tries: a float twice, lanes.h */                                               \
    X(product)      /* the matrix times the direction */                                                                        \
    X(packed_place) /* two arrays of floats each, one behind the other: packed.h */                                             \
    X(packed_velocity)                                                                                                          \
    X(packed_state)                                                                                                             \
    X(packed_gradient)                                                                                                          \
    X(packed_density)                                                                                                           \
    X(packed_strain)                                                                                                            \
    X(start_x) /* position of a boundary particle at time 0 */                                                                  \
    X(start_y)                                                                                                                  \
    X(old_density_rate) /* one step before */                                                                                   \
    X(older_ax)         /* two steps before */                                                                                  \
    X(older_ay)                                                                                                                 \
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

/** The arrays of floats but for slopes. */
#define SPH2D__PACKED                                                                                                  \
    (SPH2D__BIT(packed_place) | SPH2D__BIT(packed_velocity) | SPH2D__BIT(packed_state) | SPH2D__BIT(packed_density))

/** A store; start it with its two sets of arrays and zeros. */
typedef struct sph2d__store {
    sph2d__set has; /**< the arrays that it has; never changed once there is room */
    sph2d__set
        carried; /**< those whose values go along into a new order; the others are computed before they are read */
    size_t count, capacity;
#define SPH2D__STORE_MEMBER(name) double *name;
    SPH2D__STORE_REALS(SPH2D__STORE_MEMBER)
#undef SPH2D__STORE_MEMBER
    uint64_t *id;
    void *scratch; /**< where reordering writes, then swapped with the array it read */
} sph2d__store;

/** Bytes that a particle takes in a store of these arrays. */
size_t sph2d__store_bytes(sph2d__set has);

/** Room for `capacity` particles at least; counts and values stay. */
bool sph2d__store_reserve(sph2d__store *store, sph2d__memory *memory, size_t capacity);
void sph2d__store_free(sph2d__store *store, sph2d__memory *memory);

/** Adds a particle whose every value but its place is 0; the caller has reserved the room. Returns its index. */
size_t sph2d__store_add(sph2d__store *store, uint64_t id, double x, double y);

/** Puts the particles into a new order: particle order[k] becomes particle k. */
void sph2d__store_reorder(sph2d__store *store, const uint32_t *order, sph2d__team *team);

/** Removes every particle whose flag is set, keeping the order of the rest. */
void sph2d__store_remove(sph2d__store *store, const unsigned char *flags);

#endif
