/* SPDX-License-Identifier: MIT */
/** @file method.h
 *  A method is one entry in a table: its time scheme, arrays, setup, forces and stable step. */
#ifndef SPH2D_METHODS_COMMON_METHOD_H
#define SPH2D_METHODS_COMMON_METHOD_H

#include "methods/common/system.h"
#include "methods/common/wall_force.h"
#include "sph2d/sim.h"

/** What limits a step; in the order of sph2d_summary.limited_by. */
typedef enum sph2d__limit {
    SPH2D__LIMIT_ACOUSTIC,
    SPH2D__LIMIT_FORCE,
    SPH2D__LIMIT_VISCOUS,
    SPH2D__LIMIT_FIXED,
    SPH2D__LIMIT_COUNT
} sph2d__limit;

typedef struct sph2d__method {
    const char *name;
    /** The method's time scheme: advances all particles by one step of length dt (sim/stages.h). Errors: SPH2D_GUARD
     *  when a position is not finite, SPH2D_NOMEM. */
    sph2d_status (*step)(sph2d_sim *sim, double dt);
    sph2d__set fluid, carried; /**< the arrays of the fluid's store, and those of them that are reordered */
    sph2d__set walls;          /**< the arrays of the boundary particles' store */
    /** The arrays of the fluid that a scene's options do not need; NULL: none. */
    sph2d__set (*unused)(const sph2d_method_options *options);
    /** Sets what depends on the scene's parameters and the walls alone. */
    void (*prepare)(sph2d__system *system);
    /** After it, sets what depends on the scene's sides. False when memory is short. NULL: nothing does. */
    bool (*set_sides)(sph2d_sim *sim);
    /** Sets what depends on the positions of the boundary particles, whose cells are up to date; called when some have
     *  moved. NULL: nothing does. */
    void (*walls_placed)(sph2d__system *system);
    /** Sets density, pressure and acceleration of every particle at its present position and (predicted) velocity. The
     *  cells are up to date. In methods with `project` without the acceleration by pressure. False when memory is
     *  short. */
    bool (*evaluate)(sph2d__system *system);
    /** Adds the acceleration by the pressures that keep the density over the system's step, in methods that solve for
     *  them; else NULL. */
    void (*project)(sph2d__system *system);
    /** Force of boundary particle b on fluid particle i at (dx, dy) from it, within the support radius, as in the last
     *  evaluation or projection. NULL: not available. */
    sph2d__wall_force (*wall_force)(const sph2d__system *system, size_t i, size_t b, double dx, double dy);
    /** Force of the surface before boundary particle b, in its first layer, on the liquid [N/m], in a method without
     *  forces between particles and walls; else NULL. */
    sph2d__wall_force (*surface_force)(const sph2d__system *system, size_t b);
    /** Sets the acceleration of particle i away from each side of the domain by liquid that the method imagines behind
     *  it: left, right, bottom, top [m/s^2]. NULL: none. */
    void (*side_push)(const sph2d__system *system, size_t i, double push[4]);
    /** Elastic energy of particle i [J/kg]; `stepped`: it has a pressure of the last step. NULL: by the equation of
     *  state (state_equation.h). */
    double (*elastic)(const sph2d__system *system, size_t i, bool stepped);
    /** Takes over the density of particle i, which has been set from outside. NULL: density itself is what counts. */
    void (*take_density)(sph2d__system *system, size_t i);
    /** Whether its steps book the work of pressure, which is dissipation where it is negative, and friction, too. */
    bool books_pressure;
    /** Whether its steps book all dissipation themselves, and the work of external forces on the liquid, and set their mean
     *  (system.h). */
    bool books_all;
    /** Whether the forces of walls are their means over a step, and known until its end. */
    bool mean_forces;
    /** Whether its steps book the work of moving obstacles by pressure. */
    bool books_walls;
    /** Whether its steps are so long that a particle may cross several spacings, and one that a moving wall
     *  presses against one at rest stays before that, in the moving one, until it is put in order. Else it may get behind,
     *  for a guard. */
    bool walls_hold;
    /** Whether bodies take part in the solution for the pressure of their boundary particles, so that light ones are as
     *  stable as heavy ones. */
    bool couples_bodies;
    /** Largest stable step [s] for the largest speed [m/s] and acceleration [m/s^2], and what limits it. */
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
