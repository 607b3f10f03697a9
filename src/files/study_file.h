/* SPDX-License-Identifier: MIT */
/** @file study_file.h
 *  Parts of reading a study: what is wrong with it, and its rows, which are its runs, each with every combination of the
 *  values that are varied. */
#ifndef SPH2D_FILES_STUDY_FILE_H
#define SPH2D_FILES_STUDY_FILE_H

#include "files/document.h"
#include "files/tree.h"
#include "sph2d/study.h"

/* ---- what is wrong beyond keys and types (study_check.c) --------------------------------------------------------- */

/** Reports numbers out of range, keys without a meaning beside others and keys that are missed, each at its place in
 *  the document. What could not be read is left alone. */
void sph2d__study_check(const sph2d_study *study, const sph2d__document *document, sph2d__faults *faults);

/** Reads `target` and `percent` from the text that the file gives; what is no number above 0 becomes NaN. */
void sph2d__study_target(sph2d_study *study);

/* ---- rows (study_rows.c) ----------------------------------------------------------------------------------------- */

/** How many rows a study that was read from `root` will have; more than SPH2D_STUDY_MOST_RUNS for all that is too many.
 */
size_t sph2d__study_rows_count(const sph2d_study *study, const sph2d__node *root);

/** Puts the rows, and the refinements with their names and places, in place of what was read. False when memory is
 *  short. */
bool sph2d__study_rows_make(sph2d_study *study, const sph2d__node *root, sph2d__pool *pool);

#endif
