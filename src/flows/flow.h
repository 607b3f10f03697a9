/* SPDX-License-Identifier: MIT */
/** @file flow.h
 *  Shared by the files of known flows: a flow at one time, and one function per kind for its values at a point. */
#ifndef SPH2D_FLOWS_FLOW_H
#define SPH2D_FLOWS_FLOW_H

#include "base/pi.h"
#include "sph2d/flow.h"

/** A flow at one time, with checked parameters. */
typedef struct sph2d__flow_moment {
    const sph2d_flow *flow;
    const sph2d_flow_context *context;
    double time;      /**< [s] */
    double viscosity; /**< kinematic, nu [m^2/s] */
    double a, b;      /**< strain: semi-axes along x and y [m] */
    double rate;      /**< strain: dvx/dx [1/s] */
} sph2d__flow_moment;

/** The values of a flow at a point. */
typedef struct sph2d__flow_value {
    double vx, vy;   /**< [m/s] */
    double pressure; /**< [Pa] */
} sph2d__flow_value;

/** The values at (x, y) relative to the flow's centre [m]. */
typedef sph2d__flow_value sph2d__flow_function(const sph2d__flow_moment *m, double x, double y);

sph2d__flow_function sph2d__flow_still, sph2d__flow_standing_wave; /* waves.c */
sph2d__flow_function sph2d__flow_taylor_green, sph2d__flow_gresho; /* vortices.c */
sph2d__flow_function sph2d__flow_poiseuille, sph2d__flow_couette;  /* channels.c */
sph2d__flow_function sph2d__flow_strain;                           /* strain.c */
sph2d__flow_function sph2d__flow_rotation, sph2d__flow_patch;      /* drops.c */
sph2d__flow_function sph2d__flow_drop;

/** Largest rate of a strain flow, sqrt((U/L)^2 + B^2) [1/s]. */
double sph2d__flow_strain_pace(const sph2d_flow *flow, const sph2d_flow_context *context);

/** Sets the semi-axes and rate of a strain at the moment's time. */
void sph2d__flow_strain_axes(sph2d__flow_moment *m);

#endif
