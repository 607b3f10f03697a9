/* SPDX-License-Identifier: MIT */
/** @file method.h
 *  A method is one entry in a table: how it gets ready, what accelerates its particles, how far it may step. */
#ifndef SPH2D_METHODS_COMMON_METHOD_H
#define SPH2D_METHODS_COMMON_METHOD_H

#include "methods/common/system.h"

/** What sets the length of a step; the order of sph2d_summary.limited_by. */
typedef enum sph2d__limit {
    SPH2D__LIMIT_ACOUSTIC,
    SPH2D__LIMIT_FORCE,
    SPH2D__LIMIT_VISCOUS,
    SPH2D__LIMIT_FIXED,
    SPH2D__LIMIT_COUNT
} sph2d__limit;

/** What a boundary particle does to liquid [N/m]. */
typedef struct sph2d__wall_force {
    sph2d_vec2 pressure, friction;
} sph2d__wall_force;

typedef struct sph2d__method {
    const char *name;
    /** Moves all particles by one step of length dt, the method's time scheme (sim/stages.h). Errors: SPH2D_GUARD when a
     *  place is not finite, SPH2D_NOMEM. */
    sph2d_status (*step)(sph2d_sim *sim, double dt);
    sph2d__set fluid, carried; /**< the arrays of the fluid's store, and those that a new order carries along */
    sph2d__set walls;          /**< the arrays of the boundary particles' store */
    /** Those of the fluid's arrays that a scene's options do without; NULL: none. */
    sph2d__set (*unused)(const sph2d_method_options *options);
    /** Sets what follows from the scene's numbers and the walls. */
    void (*prepare)(sph2d__system *system);
    /** Sets what follows from the places of the boundary particles, whose cells are up to date: called when some have
     *  moved. NULL: nothing does. */
    void (*walls_placed)(sph2d__system *system);
    /** Density, pressure and acceleration of every particle at its present position and (predicted) velocity. The
     *  cells are up to date. With `project` acceleration without that of pressure. False when memory is short. */
    bool (*evaluate)(sph2d__system *system);
    /** Change of density of every particle at its present position and velocity, where the scheme moves density by
     *  its rate in the middle of a step; else NULL. */
    void (*density_rate)(sph2d__system *system);
    /** Adds the acceleration by the pressures that keep the density over the system's step, where they do; else
     *  NULL. */
    void (*project)(sph2d__system *system);
    /** Force of boundary particle b on particle i of the fluid at (dx, dy) from it, within the support radius, as the
     *  forces of the last evaluation, or projection, have it. NULL: not known. */
    sph2d__wall_force (*wall_force)(const sph2d__system *system, size_t i, size_t b, double dx, double dy);
    /** Elastic energy of particle i [J/kg], once it has a pressure (`stepped`) or before. NULL: by the equation of
     *  state (state_equation.h). */
    double (*elastic)(const sph2d__system *system, size_t i, bool stepped);
    /** Largest stable step [s] for a largest speed [m/s] and acceleration [m/s^2], and what limits it. */
    double (*stable_step)(const sph2d__system *system, double speed, double acceleration, sph2d__limit *limit);
} sph2d__method;

/** Each is defined in the folder of its method. */
#define SPH2D__METHOD_DECLARE(name, word) extern const sph2d__method sph2d__##word;
SPH2D_METHOD_MAP(SPH2D__METHOD_DECLARE)
#undef SPH2D__METHOD_DECLARE
/** Method `wcsph` with fitted operators. */
extern const sph2d__method sph2d__wcsph_fitted;

/** The entry for a scene's options; never NULL for a checked scene. */
const sph2d__method *sph2d__method_find(const sph2d_method_options *options);

#endif
