/* SPDX-License-Identifier: MIT */
/** @file measure.h
 *  What records must hold, so that everything can be measured. */
#ifndef SPH2D_STUDY_MEASURE_H
#define SPH2D_STUDY_MEASURE_H

#include "sph2d/study_results.h"

/** How many places along its line a profile is taken at, and where: 0 to 1 from end to end. */
size_t sph2d__profile_places(const sph2d_study_results *results, size_t measure);
double sph2d__profile_place(const sph2d_study_results *results, size_t measure, size_t place);

/** Whether a record holds all that the study measures. */
bool sph2d__record_serves(const sph2d_study_results *results, const sph2d_study_record *record);

#endif
