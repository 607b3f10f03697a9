/* SPDX-License-Identifier: MIT */
/** @file history_file.h
 *  What openings prescribe over time, from CSV files. */
#ifndef SPH2D_FILES_HISTORY_FILE_H
#define SPH2D_FILES_HISTORY_FILE_H

#include "files/motion_file.h"

/** Reads the files that the histories of openings name, relative to the scene file `from`, into the pool: they become
 *  the lists, and the scene names them no more. Errors: those of sph2d_table_read(), SPH2D_FORMAT for rows that make no
 *  history, SPH2D_NOMEM. */
sph2d_status sph2d__histories_read(sph2d_scene *scene, const char *from, sph2d__pool *pool, sph2d_report *report);

/** The same without the files, from lists that were kept. A file that none was kept of stays named. Errors:
 *  SPH2D_NOMEM. */
sph2d_status sph2d__histories_keep(sph2d_scene *scene, const sph2d__kept_path *paths, size_t count, sph2d__pool *pool);

/** The key of a history in snapshots: `openings[0].history.level`, or of kind SPH2D__HISTORIES `...profile`. */
void sph2d__history_key(char key[64], size_t opening, size_t kind);

/** Kinds of histories over time alone. */
enum { SPH2D__HISTORIES = 4 };

#endif
