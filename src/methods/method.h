/* SPDX-License-Identifier: MIT */
/** @file method.h
 *  A method is one entry in a table: how it gets ready, what accelerates its particles, how far it may step. */
#ifndef SPH2D_METHODS_METHOD_H
#define SPH2D_METHODS_METHOD_H

#include "methods/system.h"

/** What sets the length of a step; the order of sph2d_summary.limited_by. */
typedef enum sph2d__limit {
    SPH2D__LIMIT_ACOUSTIC,
    SPH2D__LIMIT_FORCE,
    SPH2D__LIMIT_VISCOUS,
    SPH2D__LIMIT_FIXED,
    SPH2D__LIMIT_COUNT
} sph2d__limit;

/** "acoustic", "force", "viscous", "fixed". */
const char *sph2d__limit_name(sph2d__limit limit);

typedef struct sph2d__method {
    const char *name;
    /** Sets what follows from the scene's numbers and the walls. */
    void (*prepare)(sph2d__system *system);
    /** Density, pressure and acceleration of every particle at its present position and (predicted) velocity. The
     *  cells are up to date. */
    void (*evaluate)(sph2d__system *system);
    /** Largest stable step [s] for a largest speed [m/s] and acceleration [m/s^2], and what limits it. */
    double (*stable_step)(const sph2d__system *system, double speed, double acceleration, sph2d__limit *limit);
} sph2d__method;

/** The entry of a method; never NULL for a checked scene. */
const sph2d__method *sph2d__method_find(sph2d_method name);

#endif
