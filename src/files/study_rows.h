/* SPDX-License-Identifier: MIT */
/** @file study_rows.h
 *  The rows of a study: its runs, each with every combination of the values that are varied. */
#ifndef SPH2D_FILES_STUDY_ROWS_H
#define SPH2D_FILES_STUDY_ROWS_H

#include "files/tree.h"
#include "sph2d/study.h"

/** How many rows a study that was read from `root` will have; more than SPH2D_STUDY_MOST_RUNS for all that is too many.
 */
size_t sph2d__study_rows_count(const sph2d_study *study, const sph2d__node *root);

/** Puts the rows, and the refinements with their names and places, in place of what was read. False when memory is
 *  short. */
bool sph2d__study_rows_make(sph2d_study *study, const sph2d__node *root, sph2d__pool *pool);

#endif
