/* SPDX-License-Identifier: MIT */
/** @file copy.h
 *  A deep copy of a scene. */
#ifndef SPH2D_SCENE_COPY_H
#define SPH2D_SCENE_COPY_H

#include "base/memory.h"
#include "sph2d/scene.h"

/** Copies `from` with all its lists and strings into `arena`. Errors: SPH2D_NOMEM. */
sph2d_status sph2d__scene_copy(const sph2d_scene *from, sph2d__arena *arena, sph2d__memory *memory, sph2d_scene *to);

#endif
