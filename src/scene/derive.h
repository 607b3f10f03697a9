/* SPDX-License-Identifier: MIT */
/** @file derive.h
 *  Numbers that follow from a scene alone. */
#ifndef SPH2D_SCENE_DERIVE_H
#define SPH2D_SCENE_DERIVE_H

#include "sph2d/scene.h"

/* Where the band of surface tension (methods/terms/tension.h) begins and ends, in spacings from the particles. Liquid
 * that flows has no holes of the inner radius; with an outer one of 1.5 a drop swings 1 % too slowly, with 2 by
 * 0.1 %. */
static const double SPH2D__INNER_RADIUS = 1, SPH2D__OUTER_RADIUS = 2;

/** What follows from a scene. */
typedef struct sph2d__derived {
    double support_radius; /**< H = support_ratio * spacing [m] */
    double reach;          /**< how far off particles must be found: H, under surface tension two outer radii of its
                                band at least [m] */
    double mass;           /**< of a particle, density * spacing^2 [kg/m] */
    double height;         /**< of liquid above the lowest place that it can get to, along gravity, at most [m] */
    double speed;          /**< fastest start or source [m/s] */
    double pull; /**< depth of the potentials that pull [m^2/s^2]: strongest interaction's acceleration * radius / 2,
                    and that of the central force at the farthest liquid */
    double head; /**< |g| height + speed^2 / 2 + pull: pressure over density that the liquid can build up [m^2/s^2] */
    double ripple_speed;     /**< least c0 for surface tension, sqrt(8 sigma/(rho0 dx)) [m/s] */
    double soft_compression; /**< what the sound speed is for: max_compression, of method pcisph a tenth */
    double stiffness_part;   /**< c0^2 over the stiffness k: 1, of method muller what its pair force makes of it */
    double sound_speed;      /**< c0 [m/s]; 0 when neither head nor stiffness gives one */
} sph2d__derived;

/** How far off particles must be found: H, under surface tension two outer radii of its band at least [m]. */
double sph2d__scene_reach(const sph2d_scene *scene);

/** Pressure under the head is rho0 * head (Bernoulli) and p = c0^2 (rho - rho0), so that the static compression is
 *  head / c0^2, and twice that in the swing that follows a release at rest density: c0^2 = 2 head / max_compression, of
 *  method pcisph a tenth of it, or the stiffness that the scene names.
 *  Under surface tension c0 is at least sqrt(8 sigma/(rho0 dx)), some four times the speed of the shortest ripples
 *  that particles can show: at that speed drops at rest keep their density within 1/8 dx/R. */
sph2d__derived sph2d__scene_derive(const sph2d_scene *scene);

#endif
