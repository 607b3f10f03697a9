/* SPDX-License-Identifier: MIT */
/** @file refine.h
 *  Rows that go on from the best rows so far: `refine` of a study. */
#ifndef SPH2D_STUDY_REFINE_H
#define SPH2D_STUDY_REFINE_H

#include "sph2d/study_results.h"

/** A row that goes on from `base` with the overrides of `step` on top, and room for the values of `measures`. The row
 *  owns its lists and its name, also when memory is short: then false. */
bool sph2d__refine_row(sph2d_study_row *row, const sph2d_study_run *base, const sph2d_study_run *step, size_t measures);

/** Frees what a row owns. */
void sph2d__row_free(sph2d_study_row *row);

#endif
