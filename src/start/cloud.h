/* SPDX-License-Identifier: MIT */
/** @file cloud.h
 *  The liquid of a snapshot as a function of place: values between its particles, and where it is. */
#ifndef SPH2D_START_CLOUD_H
#define SPH2D_START_CLOUD_H

#include "sim/simulation.h"
#include "start/near.h"

/** The particles of a snapshot, and their images across periodic sides, in buckets. */
typedef struct sph2d__cloud {
    const sph2d_cloud *given;
    double spacing;   /**< its own or the scene's, whichever is larger [m] */
    size_t count;     /**< with images */
    size_t size;      /**< of the arrays */
    uint32_t *sample; /**< the particle that each is an image of, or is */
    double *x, *y;    /**< its place [m] */
    sph2d__near near;
} sph2d__cloud;

/** Values at a place: velocity along x and y [m/s], pressure [Pa]. */
enum { SPH2D__CLOUD_VX, SPH2D__CLOUD_VY, SPH2D__CLOUD_PRESSURE, SPH2D__CLOUD_VALUES };

/** Prepares a snapshot with particles for a simulation whose domain and system are set. False when memory is short, or
 *  there are more than 4e9 particles. */
bool sph2d__cloud_make(sph2d__cloud *cloud, const sph2d_cloud *given, sph2d_sim *sim);
void sph2d__cloud_free(sph2d__cloud *cloud, sph2d__memory *memory);

/** The values at a place, by moving least squares as of sph2d_cloud. False where no particle is within 2.5 spacings. */
bool sph2d__cloud_values(const sph2d__cloud *cloud, sph2d_vec2 place, double values[SPH2D__CLOUD_VALUES]);

/** How much of a place is covered: sum of dx^2 W over the particles within 1.6 spacings, 0.9 to 1.1 inside the liquid,
 *  0.47 on a flat surface half a spacing beyond the outermost particles, 0.87 where a particle is alone. */
double sph2d__cloud_cover(const sph2d__cloud *cloud, sph2d_vec2 place);

/** The same, 0 where a wall is between the place and the particle that is nearest to it. */
double sph2d__cloud_cover_of(const sph2d__cloud *cloud, const sph2d_sim *sim, sph2d_vec2 place);

/* The least cover of places that liquid takes where obstacles leave too few of those inside: half of that on a surface. */
static const double SPH2D__LEAST_COVER = 0.25;

#endif
