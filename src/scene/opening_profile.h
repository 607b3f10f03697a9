/* SPDX-License-Identifier: MIT */
/** @file opening_profile.h
 *  The velocity of an opening over place and time, from points: cubics between places, straight lines between times. */
#ifndef SPH2D_SCENE_OPENING_PROFILE_H
#define SPH2D_SCENE_OPENING_PROFILE_H

#include "sph2d/scene.h"

/** Number of places at each time of valid points: those that have the time of the first. */
size_t sph2d__profile_places(const sph2d_path *profile);

/** Velocity into the domain at a place along the side [m] and a time, of points that are valid and not none [m/s]; beyond
 *  the places and times that of the nearest. */
double sph2d__profile_velocity(const sph2d_path *profile, double place, double time);

/** Its mean from one place to another. */
double sph2d__profile_mean(const sph2d_path *profile, double from, double to, double time);

/** The largest size of a point [m/s]. */
double sph2d__profile_largest(const sph2d_path *profile);

/** The named profiles: velocity over its mean; z from 0 to 1 across the opening. */
double sph2d__profile_shape(sph2d_opening_profile profile, double z);

/** The largest value of such a profile. */
double sph2d__profile_peak(sph2d_opening_profile profile);

#endif
