/* SPDX-License-Identifier: MIT */
/** @file study_check.h
 *  What is wrong with a study beyond its keys and types. */
#ifndef SPH2D_FILES_STUDY_CHECK_H
#define SPH2D_FILES_STUDY_CHECK_H

#include "files/document.h"
#include "sph2d/study.h"

/** Reports numbers out of range, keys without a meaning beside others and keys that are missed, each at its place in
 *  the document. What could not be read is left alone. */
void sph2d__study_check(const sph2d_study *study, const sph2d__document *document, sph2d__faults *faults);

/** Reads `target` and `percent` from the text that the file gives; what is no number above 0 becomes NaN. */
void sph2d__study_target(sph2d_study *study);

#endif
