/* SPDX-License-Identifier: MIT */
/** @file row_scene.h
 *  The scene of a row, and where its faults are. */
#ifndef SPH2D_STUDY_ROW_SCENE_H
#define SPH2D_STUDY_ROW_SCENE_H

#include "sph2d/study_results.h"

/** Gives the diagnostics from number `first` on their places: those of key paths in the scene's file (NULL: none), those
 *  of overrides that the study makes in the study's. */
void sph2d__row_locate(const sph2d_study_results *results, const sph2d_study_run *run, const sph2d_scene_file *scene,
                       sph2d_report *report, size_t first);

/** A scene as text; NULL when memory is short. The caller frees it. */
char *sph2d__scene_text(const sph2d_scene *scene);

/** Reports what does not fit in the scene of a run: the scene itself, and measures of what it does not have. With
 *  `place` the particles are placed too. Errors: as sph2d_study_run_scene() and sph2d_sim_create(). */
sph2d_status sph2d__row_check(const sph2d_study_results *results, const sph2d_study_run *run, bool place,
                              sph2d_report *report);

/** Finds the column `name` in a probe's line of headings, which have units; false when it is not there. */
bool sph2d__column_find(const char *headings, const char *name, size_t *column);

#endif
