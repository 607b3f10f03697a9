/* SPDX-License-Identifier: MIT */
/** @file start_file.h
 *  What liquid has at the start from files: snapshots, and the speeds that follow from these and from tables. */
#ifndef SPH2D_FILES_START_FILE_H
#define SPH2D_FILES_START_FILE_H

#include "files/pool.h"
#include "sph2d/scene.h"
#include "sph2d/status.h"

/** Reads the snapshots that the starts of blocks and of the scene name, relative to the scene file `from`, into the
 *  pool; to be called after the tables are read. They stay named. Sets largest speeds that the scene does not give, and
 *  the sound speed of a scene that has the liquid of a snapshot by the same method. Errors: those of
 *  sph2d_snapshot_read(), SPH2D_FORMAT for snapshots without liquid, SPH2D_NOMEM. */
sph2d_status sph2d__starts_read(sph2d_scene *scene, const char *from, sph2d__pool *pool, sph2d_report *report);

/** The same without the files, for a run that is resumed: takes the speeds of the scene `kept`. */
void sph2d__starts_keep(sph2d_scene *scene, const sph2d_scene *kept);

#endif
