/* SPDX-License-Identifier: MIT */
/** @file motion_file.h
 *  Motions of obstacles and of the tank, and gravity in time, from CSV files. */
#ifndef SPH2D_FILES_MOTION_FILE_H
#define SPH2D_FILES_MOTION_FILE_H

#include "files/pool.h"
#include "sph2d/scene.h"
#include "sph2d/status.h"

/** Reads the files that the motions and the gravity of a scene name, relative to the scene file `from`, into the pool:
 *  they become the paths, those of motions by cubics unless the scene says otherwise, and the scene names them no more.
 *  Errors: those of sph2d_table_read(), SPH2D_FORMAT for rows that make no path, SPH2D_NOMEM. */
sph2d_status sph2d__motions_read(sph2d_scene *scene, const char *from, sph2d__pool *pool, sph2d_report *report);

/** A path of a scene as a snapshot has it: its key, `obstacles[2].motion.path`, and its rows of numbers. */
typedef struct sph2d__kept_path {
    const char *key;
    const void *rows;
    size_t count, width; /**< of rows, and of numbers in each */
} sph2d__kept_path;

/** The same without the files: copies their rows from paths that were kept. A file that none was kept of stays named.
 *  Errors: SPH2D_NOMEM. */
sph2d_status sph2d__motions_keep(sph2d_scene *scene, const sph2d__kept_path *paths, size_t count, sph2d__pool *pool);

#endif
