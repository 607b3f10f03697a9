/* SPDX-License-Identifier: MIT */
/** @file scene_file.h
 *  Scenes from files and from snapshots: their text, and the files that they name, which are tables (CSV), and snapshots
 *  for what liquid has at the start. */
#ifndef SPH2D_FILES_SCENE_FILE_H
#define SPH2D_FILES_SCENE_FILE_H

#include "files/pool.h"
#include "files/text.h"
#include "sph2d/io.h"
#include "sph2d/scene.h"
#include "sph2d/status.h"

/** The text of a scene, and where the files come from that it names. */
typedef struct sph2d__scene_source {
    const char *text;
    size_t length;
    const char *name;        /**< in messages */
    bool with_files;         /**< the files are read */
    const sph2d_scene *kept; /**< or else has what they gave, but for particles, which are not needed; NULL: none has */
} sph2d__scene_source;

/** As sph2d_scene_file_parse(), for the public function `function`. */
sph2d_status sph2d__scene_file_parse(const sph2d__scene_source *source, const sph2d_override *overrides,
                                     size_t override_count, const char *function, sph2d_scene_file **file,
                                     sph2d_report *report);

/* ---- tables that it names (scene_tables.c) ----------------------------------------------------------------------- */

/** Reads them, relative to the scene file `from`, into the pool. A list over time takes the place of its file, which is
 *  named no more; particles and grids stay named. Errors: those of sph2d_table_read(), SPH2D_FORMAT for rows that are not
 *  what the key is for, SPH2D_NOMEM. */
sph2d_status sph2d__tables_read(sph2d_scene *scene, const char *from, sph2d__pool *pool, sph2d_report *report);

/** Marks the keys that name them as invalid: what they would give is missing. */
void sph2d__tables_skip(const sph2d_scene *scene, sph2d__faults *faults);

/** The same without the files, for a run that is resumed: copies the lists over time of the scene `kept`. A file stays
 *  named if there is none. Errors: SPH2D_NOMEM. */
sph2d_status sph2d__tables_keep(sph2d_scene *scene, const sph2d_scene *kept, sph2d__pool *pool);

/** Calls `visit` for each list over time that a table may give, a sph2d__list, with its key, `obstacles[2].motion.path`,
 *  and the numbers of its items. */
void sph2d__tables_each_list(sph2d_scene *scene,
                             void (*visit)(void *context, const char *key, size_t width, void *list), void *context);

/* ---- snapshots that it names (start_file.c) ---------------------------------------------------------------------- */

/** Reads the snapshots that the starts of blocks and of the scene name, relative to the scene file `from`, into the
 *  pool; to be called after the tables are read. They stay named. Sets largest speeds that the scene does not give, and
 *  the sound speed of a scene that has the liquid of a snapshot by the same method. Errors: those of
 *  sph2d_snapshot_read(), SPH2D_FORMAT for snapshots without liquid, SPH2D_NOMEM. */
sph2d_status sph2d__starts_read(sph2d_scene *scene, const char *from, sph2d__pool *pool, sph2d_report *report);

/** The same without the files, for a run that is resumed: takes the speeds of the scene `kept`. */
void sph2d__starts_keep(sph2d_scene *scene, const sph2d_scene *kept);

#endif
