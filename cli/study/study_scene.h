/* SPDX-License-Identifier: MIT */
/** @file study_scene.h
 *  The scene of a row, and whether the measures fit it. */
#ifndef SPH2D_CLI_STUDY_SCENE_H
#define SPH2D_CLI_STUDY_SCENE_H

#include "study.h"

/** Reads the scene with the overrides of a row and those of the command line on top. Tells what is wrong and returns an
 *  exit code. The caller owns *file. */
int study_scene_open(cli_study *s, const sph2d_study_run *run, sph2d_scene_file **file);

/** Tells what is wrong with a row before anything runs: its scene, and measures of what the scene does not have. With
 *  `place` the particles are placed too. Returns an exit code. */
int study_scene_check(cli_study *s, const sph2d_study_run *run, bool place);

/** Finds the column `name` in a probe's line of headings, which have units; false when it is not there. */
bool study_column_find(const char *headings, const char *name, size_t *column);

/** The number of columns in a line of headings. */
size_t study_column_count(const char *headings);

#endif
