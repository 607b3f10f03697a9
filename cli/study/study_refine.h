/* SPDX-License-Identifier: MIT */
/** @file study_refine.h
 *  Rows that go on from the best rows so far: `refine` of a study. */
#ifndef SPH2D_CLI_STUDY_REFINE_H
#define SPH2D_CLI_STUDY_REFINE_H

#include "study.h"

/** Adds the rows of refinement `step`: the rows on the front of those with the smallest spacing so far, each with the
 *  step's overrides on top. Errors: SPH2D_NOMEM. */
sph2d_status study_refine(cli_study *s, size_t step);

#endif
