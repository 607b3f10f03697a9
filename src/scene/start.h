/* SPDX-License-Identifier: MIT */
/** @file start.h
 *  What liquid has at the start, as far as a scene tells. */
#ifndef SPH2D_SCENE_START_H
#define SPH2D_SCENE_START_H

#include "sph2d/scene.h"

/** Whether a scene has the liquid of a snapshot: it names one, and no particles that take their values from it. */
bool sph2d__starts_from_snapshot(const sph2d_scene *scene);

/** Whether it has liquid of a file: single particles, or those of a snapshot. */
bool sph2d__liquid_is_from_file(const sph2d_scene *scene);

/** The largest speed of a start, without the velocity that it is added to [m/s]: as given, or of its values. */
double sph2d__start_speed(const sph2d_start *start);

#endif
