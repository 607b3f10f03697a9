/* SPDX-License-Identifier: MIT */
/** @file derive.h
 *  Parameters derived from a scene. */
#ifndef SPH2D_SCENE_DERIVE_H
#define SPH2D_SCENE_DERIVE_H

#include "sph2d/scene.h"

/* Liquid released at rest density oscillates up to twice its static compression. */
static const double SPH2D__OVERSHOOT = 2;

/** The derived parameters. */
typedef struct sph2d__derived {
    double support_radius; /**< H = support_ratio * spacing [m] */
    double reach;          /**< search radius: H, with surface tension at least two outer radii of its band [m] */
    double mass;           /**< of a particle, density * spacing^2 [kg/m] */
    double gravity;        /**< largest gravity, with the acceleration of a tank that moves [m/s^2] */
    double height;         /**< largest height of liquid above the lowest point that it can reach, along gravity [m] */
    double speed;          /**< largest speed at the start, of a source, of a wall, or by springs of a body [m/s] */
    double pull; /**< depth of attractive potentials [m^2/s^2]: acceleration * radius / 2 of the strongest interaction,
                    and that of the central force at the farthest liquid */
    double head; /**< |g| height + speed^2 / 2 + pull: pressure over density that the liquid can build up [m^2/s^2] */
    double spring_head;      /**< the part of that by what only springs of bodies make fast [m^2/s^2] */
    double spring_energy;    /**< of springs of bodies at the start [J/m] */
    double capillary_head;   /**< pressure of surface tension in the thinnest block, over density [m^2/s^2] */
    double ripple_speed;     /**< minimum c0 for surface tension, sqrt(8 sigma/(rho0 dx)) [m/s] */
    double soft_compression; /**< compression for which c0 is chosen: max_compression, for pcisph a tenth of it */
    double stiffness_part;   /**< c0^2 over the stiffness k: 1, for muller the factor of its pair force */
    double sound_speed;      /**< c0 [m/s]; 0 when neither head nor stiffness gives one */
} sph2d__derived;

/** The pressure under the head is rho0 * head (Bernoulli) and p = c0^2 (rho - rho0), so that the static compression is
 *  head / c0^2, and twice that in the oscillation after a release at rest density: c0^2 = 2 head / max_compression, for
 *  method pcisph with a tenth of max_compression; or by the stiffness or sound speed of the scene.
 *  With surface tension c0 is at least sqrt(8 sigma/(rho0 dx)), about four times the speed of the shortest ripples that
 *  particles resolve: with it the density of drops at rest is within 1/8 dx/R. Where that is more than max_compression
 *  the check says so. */
sph2d__derived sph2d__scene_derive(const sph2d_scene *scene);

/** The scene's frames with the defaults that follow from its head: the ends of the colour bar 0 and sqrt(2 head) for
 *  speed, density * head for pressure, ten times that speed over the domain's smaller side, with either sign, for
 *  vorticity, (0, 0) for other fields; the speed of arrows, which streamlines know, too, sqrt(2 head); isolines a round number
 *  near a tenth of these. */
sph2d_frames sph2d__frames_resolve(const sph2d_scene *scene);

/** The rise time of gauges that have none of their own [s]. */
double sph2d__gauge_rise_time(const sph2d_scene *scene);

/** The regularisation of the liquid: the scene's, or by default 100 L/sqrt(2 E), L the smaller side of the domain and E
 *  the head, and 1 s where that is 0; 0 for liquids without one [s]. */
double sph2d__regularisation(const sph2d_scene *scene);

#endif
