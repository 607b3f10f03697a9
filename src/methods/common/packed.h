/* SPDX-License-Identifier: MIT */
/** @file packed.h
 *  What the pair loops of method `wcsph` read of a neighbour: the store's own arrays or, with precision `mixed`, copies
 *  in floats. The state stays in doubles, as do the sums of a particle once they are complete.
 *
 *  Floats have seven digits. Positions are relative to the corner of a tile of cells (cells.h), densities to the rest
 *  density, so that no digits are lost to the origin of the scene or to a common offset. */
#ifndef SPH2D_METHODS_COMMON_PACKED_H
#define SPH2D_METHODS_COMMON_PACKED_H

#include "methods/common/system.h"
#include "simd/lanes.h"

/* The two halves of each float array:
 *   packed_place     x, y
 *   packed_velocity  velocity; of walls the image velocity
 *   packed_state     volume, pressure; for the rate of density instead of pressure the excess of liquid (Fourtakas'
 *                    diffusion) or the wall_rate of walls
 *   packed_density   density and min_eigenvalue of liquid; slide and mass of walls
 *   packed_gradient  gradient of density of liquid; slip direction of walls
 *   packed_strain    stretch, shear, or viscosity where it depends on them; for the rate of density H grad C (shift.h) */

/** Arrays with one value per particle. Density is relative to `from`. */
typedef struct sph2d__packed {
    const sph2d__real *x, *y, *vx, *vy, *density, *pressure, *volume, *mass, *density_grad_x, *density_grad_y,
        *min_eigenvalue, *excess, *stretch, *shear, *viscosity, *grad_c_x, *grad_c_y, *wall_rate, *slide, *along_x,
        *along_y;
    double from; /**< [kg/m^3] */
} sph2d__packed;

/** One of the two arrays of floats in the space of an array of doubles. */
static inline float *sph2d__floats(const sph2d__store *store, double *array, int which)
{
    void *floats = array; /* it never holds anything else */
    return floats ? (float *)floats + (size_t)which * store->capacity : NULL;
}

/** Arrays of the fluid that are set directly, without a copy in doubles; NULL in double precision. */
static inline float *sph2d__packed_volume(const sph2d__store *store)
{
    return sph2d__floats(store, store->packed_state, 0);
}
static inline float *sph2d__packed_pressure(const sph2d__store *store)
{
    return sph2d__floats(store, store->packed_state, 1);
}
static inline float *sph2d__packed_excess(const sph2d__store *store)
{
    return sph2d__floats(store, store->packed_state, 1);
}

#ifdef SPH2D__MIXED
SPH2D__INLINE sph2d__packed sph2d__packed_of(const sph2d__system *s, const sph2d__store *t, bool walls)
{
    (void)walls;
    return (sph2d__packed){.x = sph2d__floats(t, t->packed_place, 0),
                           .y = sph2d__floats(t, t->packed_place, 1),
                           .vx = sph2d__floats(t, t->packed_velocity, 0),
                           .vy = sph2d__floats(t, t->packed_velocity, 1),
                           .volume = sph2d__packed_volume(t),
                           .pressure = sph2d__packed_pressure(t),
                           .excess = sph2d__packed_excess(t),
                           .wall_rate = sph2d__packed_excess(t),
                           .density = sph2d__floats(t, t->packed_density, 0),
                           .stretch = sph2d__floats(t, t->packed_strain, 0),
                           .shear = sph2d__floats(t, t->packed_strain, 1),
                           .viscosity = sph2d__floats(t, t->packed_strain, 0),
                           .grad_c_x = sph2d__floats(t, t->packed_strain, 0),
                           .grad_c_y = sph2d__floats(t, t->packed_strain, 1),
                           .slide = sph2d__floats(t, t->packed_density, 0),
                           .along_x = sph2d__floats(t, t->packed_gradient, 0),
                           .along_y = sph2d__floats(t, t->packed_gradient, 1),
                           .min_eigenvalue = sph2d__floats(t, t->packed_density, 1),
                           .mass = sph2d__floats(t, t->packed_density, 1),
                           .density_grad_x = sph2d__floats(t, t->packed_gradient, 0),
                           .density_grad_y = sph2d__floats(t, t->packed_gradient, 1),
                           .from = s->rest_density};
}
#else
SPH2D__INLINE sph2d__packed sph2d__packed_of(const sph2d__system *s, const sph2d__store *t, bool walls)
{
    return (sph2d__packed){t->x,
                           t->y,
                           walls ? t->image_vx : t->vx,
                           walls ? t->image_vy : t->vy,
                           t->density,
                           t->pressure,
                           t->volume,
                           t->mass,
                           t->density_grad_x,
                           t->density_grad_y,
                           t->min_eigenvalue,
                           t->excess,
                           t->stretch,
                           t->shear,
                           s->viscosities,
                           t->grad_c_x,
                           t->grad_c_y,
                           t->wall_rate,
                           t->slide,
                           t->along_x,
                           t->along_y,
                           0};
}
#endif

/** Copy what the force loops read of the fluid and of the boundary particles; nothing without packed arrays. */
void sph2d__pack_fluid(sph2d__system *system);
void sph2d__pack_walls(sph2d__system *system);

/** The same for the rate of density: H grad C in place of strain, and wall_rate in place of pressure for boundary
 *  particles. */
void sph2d__pack_fluid_rates(sph2d__system *system);
void sph2d__pack_wall_rates(sph2d__system *system);

#endif
