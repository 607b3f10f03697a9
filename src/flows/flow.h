/* SPDX-License-Identifier: MIT */
/** @file flow.h
 *  What the files of known flows share: a moment of a flow, and one function a kind that gives its values at a point.
 */
#ifndef SPH2D_FLOWS_FLOW_H
#define SPH2D_FLOWS_FLOW_H

#include "base/pi.h"
#include "sph2d/flow.h"

/** A flow at one time, its numbers checked. */
typedef struct sph2d__flow_moment {
    const sph2d_flow *flow;
    const sph2d_flow_context *context;
    double time;      /**< [s] */
    double viscosity; /**< kinematic, nu [m^2/s] */
    double a, b;      /**< strain: half axes along x and y [m] */
    double rate;      /**< strain: dvx/dx [1/s] */
} sph2d__flow_moment;

/** What a flow has at a point. */
typedef struct sph2d__flow_value {
    double vx, vy;   /**< [m/s] */
    double pressure; /**< [Pa] */
} sph2d__flow_value;

/** The values at (x, y), counted from the flow's centre [m]. */
typedef sph2d__flow_value sph2d__flow_function(const sph2d__flow_moment *m, double x, double y);

sph2d__flow_function sph2d__flow_still, sph2d__flow_standing_wave; /* waves.c */
sph2d__flow_function sph2d__flow_taylor_green, sph2d__flow_gresho; /* vortices.c */
sph2d__flow_function sph2d__flow_poiseuille, sph2d__flow_couette;  /* channels.c */
sph2d__flow_function sph2d__flow_strain;                           /* strain.c */
sph2d__flow_function sph2d__flow_rotation, sph2d__flow_patch;      /* drops.c */
sph2d__flow_function sph2d__flow_drop;

/** How fast a strain runs: sqrt((U/L)^2 + B^2) [1/s]. No rate of it is ever larger. */
double sph2d__flow_strain_pace(const sph2d_flow *flow, const sph2d_flow_context *context);

/** Fills in the half axes and rate of a strain at the moment's time. */
void sph2d__flow_strain_axes(sph2d__flow_moment *m);

#endif
