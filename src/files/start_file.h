/* SPDX-License-Identifier: MIT */
/** @file start_file.h
 *  What liquid has at the start, from tables (CSV) and snapshots. */
#ifndef SPH2D_FILES_START_FILE_H
#define SPH2D_FILES_START_FILE_H

#include "files/motion_file.h"

/** Reads the tables and snapshots that the starts of blocks and of the scene name, relative to the scene file `from`, into
 *  the pool. They stay named. Largest speeds that the scene does not give are set, and the sound speed of a scene that has
 *  the liquid of a snapshot by the same method. Errors: those of sph2d_table_read() and sph2d_snapshot_read(),
 *  SPH2D_FORMAT for rows that make no grid and snapshots without liquid, SPH2D_NOMEM. */
sph2d_status sph2d__starts_read(sph2d_scene *scene, const char *from, sph2d__pool *pool, sph2d_report *report);

/** The same without the files, for a run that is resumed: sets the speeds from numbers that were kept. */
void sph2d__starts_keep(sph2d_scene *scene, const sph2d__kept_path *numbers, size_t count);

/** The keys of these numbers in snapshots: `blocks[0].start.top_speed`, for block SIZE_MAX `start.top_speed`; and
 *  `method.sound_speed`. */
void sph2d__start_key(char key[64], size_t block);
#define SPH2D__SOUND_SPEED_KEY "method.sound_speed"

#endif
