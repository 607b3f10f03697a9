/* SPDX-License-Identifier: MIT */
/** @file study_refine.h
 *  Rows that go on from the best rows so far: `refine` of a study. */
#ifndef SPH2D_CLI_STUDY_REFINE_H
#define SPH2D_CLI_STUDY_REFINE_H

#include "study.h"

/** A row that goes on from `base` with the overrides of `step` on top, and room for the values of `measures`. The row
 *  owns its lists and its name, also when memory is short: then false. */
bool study_refine_row(study_row *row, const sph2d_study_run *base, const sph2d_study_run *step, size_t measures);

/** Adds the rows of refinement `step`: the rows on the front of those with the smallest spacing so far, each with the
 *  step's overrides on top. Errors: SPH2D_NOMEM. */
sph2d_status study_refine(cli_study *s, size_t step);

#endif
