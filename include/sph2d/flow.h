/* SPDX-License-Identifier: MIT */
/** @file flow.h
 *  Known flows: velocity and pressure of exact solutions at any point and time, as initial conditions and references.
 *
 *      sph2d_flow flow = sph2d_flow_default();
 *      flow.kind = SPH2D_FLOW_TAYLOR_GREEN;
 *      flow.speed = 1;
 *      flow.length = 1;
 *      sph2d_flow_context context = {.density = 1000, .dynamic_viscosity = 10};
 *      double x = 0.2, y = 0.3, vx, vy, p;
 *      sph2d_flow_values(&flow, &context, 0.5, 1, &x, &y, &vx, &vy, &p, NULL);
 *
 *  All are solutions for liquid of constant density. SI units throughout. */
#ifndef SPH2D_FLOW_H
#define SPH2D_FLOW_H

#include <stddef.h>

#include "sph2d/export.h"
#include "sph2d/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Which flow. The values are part of the ABI. */
typedef enum sph2d_flow_kind {
    /** No flow. */
    SPH2D_FLOW_NONE = 0,

    /** At rest under gravity, with a free surface across it. */
    SPH2D_FLOW_STILL = 1,

    /** Vortices that decay by viscosity, in a periodic square. */
    SPH2D_FLOW_TAYLOR_GREEN = 2,

    /** A steady vortex: rigid rotation inside, at rest outside; inviscid. */
    SPH2D_FLOW_GRESHO = 3,

    /** Channel flow from rest, driven by gravity along x. */
    SPH2D_FLOW_POISEUILLE = 4,

    /** Channel flow from rest, driven by the upper wall. */
    SPH2D_FLOW_COUETTE = 5,

    /** A small standing gravity wave that starts from a flat surface; inviscid. */
    SPH2D_FLOW_STANDING_WAVE = 6,

    /** A free disc that becomes an ellipse, and oscillates under a central force; inviscid. */
    SPH2D_FLOW_STRAIN = 7,

    /** A free disc in rigid rotation; any viscosity. */
    SPH2D_FLOW_ROTATION = 8,

    /** A free square, starting with the same velocity; inviscid, time 0 only. */
    SPH2D_FLOW_PATCH = 9,

    /** A disc under surface tension, at rest or in a small oscillation; inviscid. */
    SPH2D_FLOW_DROP = 10
} sph2d_flow_kind;

/** A flow. The meaning of its parameters, and the forces under which it is a solution; "-" is not read:
 *
 *      kind            speed U [m/s]               length L [m]         center [m]                      forces
 *      still           -                           -                    a point of the surface          any gravity
 *      taylor_green    largest velocity component  period               of a vortex, anticlockwise      none
 *                      at time 0
 *      gresho          largest, at 0.2 L           vortex ends at 0.4 L of the vortex                   none
 *      poiseuille      final one in the middle     between the walls    a point of the middle line      gravity (g, 0),
 *                                                                                                       g = 8 nu U/L^2
 *      couette         of the upper wall, along x  between the walls    a point of the middle line      none
 *      standing_wave   of the surface at `center`  wavelength           an antinode, at the mean        gravity (0, -g)
 *                      at time 0, upwards                               surface
 *      strain          U/L: rate dvx/dx at time 0  radius at time 0     of the disc                     central, rate B
 *      rotation        U/L: angular velocity       radius               of the disc                     none
 *      patch           U/L: angular velocity       side                 of the square                   none
 *      drop            U/L: rate dvx/dx at time 0  radius               of the disc                     tension
 *
 *  nu is the kinematic viscosity. A negative speed reverses a flow: positive ones rotate anticlockwise (gresho,
 *  rotation, patch), stretch along x (strain), flow to the right (poiseuille, couette). taylor_green is
 *  v = U (-cos kx sin ky, sin kx cos ky) at time 0, with k = 2 pi/L and (x, y) relative to `center`.
 *
 *  Pressure is 0 in air: in still liquid at the free surface, outside the disc, square or ellipse, above the wave. The
 *  pressure of taylor_green has mean 0, that of gresho is 0 outside the vortex, that of poiseuille and couette 0
 *  everywhere. In air the velocity is that of the liquid extrapolated; beyond a wall it is that of the wall.
 *
 *  The forces are not checked: a flow is evaluated whether or not they are those of this table. A central force must
 *  have the same centre as the flow. */
typedef struct sph2d_flow {
    /** Which flow; default none. */
    sph2d_flow_kind kind;

    /** Speed U [m/s], any sign; default 0. */
    double speed;

    /** Length L [m], > 0; default 0: must be given if it is read. */
    double length;

    /** standing_wave: depth of the liquid at rest [m], > 0, may be INFINITY; default 0: must be given. */
    double depth;

    /** Centre [m]; default (0, 0). */
    double center[2];
} sph2d_flow;

/** Parameters of the scene that a flow depends on. */
typedef struct sph2d_flow_context {
    /** Rest density rho0 [kg/m^3], > 0. */
    double density;

    /** Dynamic viscosity rho0 nu [Pa s], >= 0; poiseuille and couette: > 0. */
    double dynamic_viscosity;

    /** drop: surface tension [N/m], >= 0. */
    double surface_tension;

    /** still and standing_wave: gravity [m/s^2], for the latter (0, -g) with g > 0. */
    double gravity[2];

    /** strain: rate B of the central force [1/s], >= 0; its acceleration is -B^2 (x - center). */
    double central_rate;
} sph2d_flow_context;

/** The default flow. */
SPH2D_API sph2d_flow sph2d_flow_default(void);

/** The name of a kind, "taylor_green"; "unknown" for an invalid value. Static storage. */
SPH2D_API const char *sph2d_flow_name(sph2d_flow_kind kind);

/** Velocity [m/s] and pressure [Pa] at `count` points (x[i], y[i]) at a time [s], >= 0. Results that are not needed may
 *  be NULL, and so may `report`. Kind strain integrates its ellipse in each call. Errors: SPH2D_INVALID for kind none,
 *  for numbers out of range, and for the patch after time 0, for which no formula is known; the results are then not
 *  changed. */
SPH2D_API sph2d_status sph2d_flow_values(const sph2d_flow *flow, const sph2d_flow_context *context, double time,
                                         size_t count, const double *x, const double *y, double *vx, double *vy,
                                         double *pressure, sph2d_report *report);

/** The ellipse of kind strain at a time [s]: semi-axes along x and y [m] and the rate dvx/dx [1/s], to 1e-10 up to time
 *  1000 T with T = 1/sqrt((U/L)^2 + B^2), then to 1e-9. It is integrated from time 0 on, which takes milliseconds for
 *  100 T. Results that are not needed may be NULL. Errors: SPH2D_INVALID for other kinds, numbers out of range, and
 *  times above 10000 T. */
SPH2D_API sph2d_status sph2d_flow_axes(const sph2d_flow *flow, const sph2d_flow_context *context, double time,
                                       double *a, double *b, double *rate, sph2d_report *report);

#ifdef __cplusplus
}
#endif
#endif
