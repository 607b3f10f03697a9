/* SPDX-License-Identifier: MIT */
/** @file derive.h
 *  Parameters derived from a scene. */
#ifndef SPH2D_SCENE_DERIVE_H
#define SPH2D_SCENE_DERIVE_H

#include "scene/world.h"

/* Liquid released at rest density oscillates up to twice its static compression. */
static const double SPH2D__OVERSHOOT = 2;

/** Sets `derived` of a world whose sides are resolved, and the defaults that follow from it: the regularisation of the
 *  liquid, the frames', and the rise time of gauges. Errors: SPH2D_NOMEM.
 *
 *  The pressure under the head is rho0 * head (Bernoulli) and p = c0^2 (rho - rho0), so that the static compression is
 *  head / c0^2, and twice that in the oscillation after a release at rest density: c0^2 = 2 head / max_compression, for
 *  method pcisph with a tenth of max_compression; or by the stiffness or sound speed of the scene.
 *  With surface tension c0 is at least sqrt(8 sigma/(rho0 dx)), about four times the speed of the shortest ripples that
 *  particles resolve: with it the density of drops at rest is within 1/8 dx/R. Where that is more than max_compression
 *  the check says so. */
sph2d_status sph2d__derive(sph2d__world *world, sph2d__arena *arena, sph2d__memory *memory);

/** Largest height of a block, source or single particle above the lowest point that its liquid can reach [m], against
 *  gravity, which must not be 0. Liquid with a head of `extra_head` [m] in addition to its height can rise by that
 *  much; sides of the domain and walls at rest confine it. Without such walls, or with more than four million
 *  cells of the size of the spacing, the lowest point is the domain's lowest corner. basin.c */
double sph2d__basin_height(const sph2d__world *world, double extra_head);

/** The speed of the jet behind the narrowest cross-section of a channel from side to side, or in an outlet that is
 *  narrower, where openings prescribe a flow and liquid fills it; 0 for other scenes [m/s]. The jet is narrower than that
 *  section: where this has m times the width in which the liquid enters, the jet has 0.63 + 0.37 m^3 of it (Weisbach's
 *  coefficient of contraction, 1855); behind the inner corner of a bend less. Bodies do not count: they move out of the
 *  way. closed_flow.c */
double sph2d__throat_speed(const sph2d__world *world);

/** The largest tension over density that comes from slowing what flows in, or from speeding up what is drawn out: the
 *  length of the domain times that deceleration; 0 where a surface is free [m^2/s^2]. Jumps do not count: they
 *  are a matter of sound. */
double sph2d__slowing_head(const sph2d_scene *scene);

#endif
