/* SPDX-License-Identifier: MIT */
/** @file particles_file.h
 *  Single particles of a scene from a CSV file. */
#ifndef SPH2D_FILES_PARTICLES_FILE_H
#define SPH2D_FILES_PARTICLES_FILE_H

#include "files/pool.h"
#include "sph2d/scene.h"

/** Reads the particle file that `scene` names, relative to the folder of the scene file `from`, into the pool. Missing
 *  columns are 0. Errors, each with file and line: SPH2D_NOINPUT, SPH2D_FORMAT, SPH2D_NOMEM. */
sph2d_status sph2d__particles_read(sph2d_scene *scene, const char *from, sph2d__pool *pool, sph2d_report *report);

#endif
