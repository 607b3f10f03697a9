/* SPDX-License-Identifier: MIT */
/** @file scene_tables.h
 *  The tables (CSV) that a scene names. */
#ifndef SPH2D_FILES_SCENE_TABLES_H
#define SPH2D_FILES_SCENE_TABLES_H

#include "files/pool.h"
#include "sph2d/scene.h"
#include "sph2d/status.h"

/** Reads them, relative to the scene file `from`, into the pool. A list over time takes the place of its file, which is
 *  named no more; particles and grids stay named. Errors: those of sph2d_table_read(), SPH2D_FORMAT for rows that are not
 *  what the key is for, SPH2D_NOMEM. */
sph2d_status sph2d__tables_read(sph2d_scene *scene, const char *from, sph2d__pool *pool, sph2d_report *report);

/** The same without the files, for a run that is resumed: copies the lists over time of the scene `kept`. A file stays
 *  named if there is none. Errors: SPH2D_NOMEM. */
sph2d_status sph2d__tables_keep(sph2d_scene *scene, const sph2d_scene *kept, sph2d__pool *pool);

/** Calls `visit` for each list over time that a table may give, a sph2d__list, with its key, `obstacles[2].motion.path`,
 *  and the numbers of its items. */
void sph2d__tables_each_list(sph2d_scene *scene,
                             void (*visit)(void *context, const char *key, size_t width, void *list), void *context);

#endif
