/* SPDX-License-Identifier: MIT */
/** @file closed_flow.h
 *  What openings make of liquid that has no free surface: how fast it gets in the narrowest part of a channel, and how
 *  hard it is pulled. */
#ifndef SPH2D_SCENE_CLOSED_FLOW_H
#define SPH2D_SCENE_CLOSED_FLOW_H

#include "sph2d/scene.h"

/** The speed of the jet behind the narrowest cross-section of a channel from side to side, or in an outlet that is
 *  narrower, where openings prescribe a flow and liquid fills it; 0 for other scenes [m/s]. The jet is narrower than that
 *  section: where this has m times the width in which the liquid enters, the jet has 0.63 + 0.37 m^3 of it (Weisbach's
 *  coefficient of contraction, 1855); behind the inner corner of a bend less. Bodies do not count: they move out of the
 *  way. */
double sph2d__throat_speed(const sph2d_scene *scene);

/** The largest tension over density that comes from slowing what flows in, or from speeding up what is drawn out: the
 *  length of the domain times that deceleration; 0 where a surface is free [m^2/s^2]. Jumps do not count: they
 *  are a matter of sound. */
double sph2d__slowing_head(const sph2d_scene *scene);

#endif
