/* SPDX-License-Identifier: MIT */
/** @file motion_file.h
 *  Motions of obstacles and of the tank from CSV files. */
#ifndef SPH2D_FILES_MOTION_FILE_H
#define SPH2D_FILES_MOTION_FILE_H

#include "files/pool.h"
#include "sph2d/scene.h"
#include "sph2d/status.h"

/** Reads the files that the motions of a scene name, relative to the scene file `from`, into the pool: they become the
 *  paths, by cubics unless the scene says otherwise, and the scene names them no more. Errors: those of
 *  sph2d_table_read(), SPH2D_FORMAT for rows that make no path, SPH2D_NOMEM. */
sph2d_status sph2d__motions_read(sph2d_scene *scene, const char *from, sph2d__pool *pool, sph2d_report *report);

#endif
